/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_coarse_mesh_h
#define contact_coarse_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/msh_file.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The elements of a gmsh file as cells, lines and points, still where the
   * file has them. The names are those of class Mesh.
   */
  struct CoarseMesh
  {
    std::vector<Point<2>>    vertices;
    std::vector<CellData<2>> cells; // corners in cyclic order, anticlockwise
    SubCellData              lines; // with boundary ids

    std::map<std::string, std::set<types::boundary_id>> boundaries;
    std::map<std::string, unsigned int>                 points;

    /// The groups that have lines inside of bodies.
    std::set<std::string> with_inner_lines;
  };

  /// Throws InputError, where cells are tangled, overlap or have no body, or
  /// where lines with a name are no edges of cells.
  CoarseMesh
  make_coarse_mesh(const MshFile                                   &msh,
                   const std::map<std::string, types::material_id> &bodies);

  /// A place in a message.
  std::string to_string(const Point<2> &p);
} // namespace Contact

#endif
