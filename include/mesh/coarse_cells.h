/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_coarse_cells_h
#define contact_coarse_cells_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <string>
#include <vector>

#include "mesh/msh_file.h"

namespace Contact
{
  using namespace dealii;

  /// Number of a node in the file -> our number of the vertex.
  using VertexNumbers = std::map<long, unsigned int>;

  /// The cells of a gmsh file, with corners in gmsh's order, right-handed:
  /// those of the other orientation are turned round. Throws InputError where a
  /// cell is tangled or has not one body.
  template<int dim>
  std::vector<CellData<dim>>
  make_cells(const MshFile                                   &msh,
             const VertexNumbers                             &vertices,
             const std::vector<Point<dim>>                   &points,
             const std::map<std::string, types::material_id> &bodies);

  /// A place in a message.
  template<int dim>
  std::string to_string(const Point<dim> &p);
} // namespace Contact

#endif
