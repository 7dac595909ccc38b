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

#include "mesh/coarse_cells.h"
#include "mesh/mid_sides.h"
#include "mesh/msh_file.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The elements of a gmsh file as cells, faces and points, still where the
   * file has them. The names are those of class Mesh.
   */
  template<int dim>
  struct CoarseMesh
  {
    std::vector<Point<dim>>    vertices;
    std::vector<CellData<dim>> cells; // corners in gmsh's order, right-handed
    SubCellData                faces; // and curves in 3-D, with ids
    MidSides<dim>              mid_sides; // of elements of second order

    std::map<std::string, std::set<types::boundary_id>> boundaries;
    std::map<std::string, std::set<types::boundary_id>> curves; // in 3-D
    std::map<std::string, std::vector<unsigned int>>    points;

    /// The groups that have faces inside of bodies, and in 3-D those of lines
    /// that are not all on the boundary: they are no curves.
    std::set<std::string> with_inner_faces, inner_curves;
  };

  /// Throws InputError, where cells are tangled, overlap or have no body, or
  /// where faces with a name are no faces of cells.
  template<int dim>
  CoarseMesh<dim>
  make_coarse_mesh(const MshFile                                   &msh,
                   const std::map<std::string, types::material_id> &bodies);
} // namespace Contact

#endif
