/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_joined_cells_h
#define contact_joined_cells_h

#include <deal.II/grid/tria.h>

#include <map>
#include <set>
#include <string>

namespace Contact
{
  using namespace dealii;

  /**
   * Check that triangles and tetrahedra of a body that are side by side are
   * joined by a face, which each of them is on its own side of. Else the body
   * is cut open, or folded, and too soft: a node that is there twice, one that
   * hangs on the edge of another cell, two pairs of triangles that meet with
   * either diagonal of a quadrangle, as of transfinite volumes side by side, a
   * node beyond the other side of a cell.
   *
   * Beyond a face at the boundary there is no cell of the same body: asked for
   * a place in front of its middle, of faces in none of the @p groups; the
   * others may be the sides of a crack. Sides are taken as straight. Throws
   * InputError with the @p file.
   */
  template<int dim>
  void check_joined_cells(
    const Triangulation<dim>                                  &mesh,
    const std::map<std::string, std::set<types::boundary_id>> &groups,
    const std::string                                         &file);
} // namespace Contact

#endif
