/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_crossed_diagonals_h
#define contact_crossed_diagonals_h

#include <deal.II/grid/tria.h>

namespace Contact
{
  using namespace dealii;

  /**
   * Check that a mesh of tetrahedra is not cut open inside, where two triangles
   * of a surface within meet two others that cross them: those of a
   * quadrangle with either diagonal. The four have common nodes and are no
   * faces of both sides; they bound a hole of no thickness, across which the
   * displacements differ, and the body is too soft. gmsh makes such meshes of
   * transfinite volumes side by side. A hole is found by its faces: those of
   * a tetrahedron that is not there. Throws InputError with the @p file.
   */
  template<int dim>
  void check_diagonals(const Triangulation<dim> &mesh, const std::string &file);
} // namespace Contact

#endif
