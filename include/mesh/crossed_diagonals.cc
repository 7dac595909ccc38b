/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/crossed_diagonals.h"

#include <map>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  template<int dim>
  void check_diagonals(const Triangulation<dim> &mesh, const std::string &file)
  {
    using Vertices = std::set<unsigned int>;
    std::map<Vertices, Vertices> cell_of; // the triangles at the boundary
    std::map<Vertices, Vertices> beside;  // their edges: the third vertices
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (const auto face = cell->face(f);
            face->at_boundary() && face->n_vertices() == 3)
          {
            Vertices triangle, of_cell;
            for (const unsigned int v : face->vertex_indices())
              triangle.insert(face->vertex_index(v));
            for (const unsigned int v : cell->vertex_indices())
              of_cell.insert(cell->vertex_index(v));
            cell_of.emplace(triangle, of_cell);
            for (const unsigned int v : triangle)
              {
                Vertices edge = triangle;
                edge.erase(v);
                beside[edge].insert(v);
              }
          }
    for (const auto &[edge, thirds] : beside)
      for (const unsigned int c : thirds)
        for (const unsigned int d : thirds)
          {
            Vertices near = edge;
            near.insert(c);
            bool is_hole = c < d && cell_of.at(near).count(d) == 0;
            for (const unsigned int v : edge)
              is_hole = is_hole && cell_of.count({v, c, d}) > 0;
            if (is_hole)
              throw InputError(
                "the mesh is cut open at " +
                  to_string(mesh.get_vertices()[*edge.begin()]) + " and " +
                  to_string(mesh.get_vertices()[c]) +
                  ": two triangles meet two others that have the other "
                  "diagonal of a quadrangle",
                file,
                "have volumes that share a face meshed without 'Transfinite "
                "Volume', or as hexahedra");
          }
  }

  template void check_diagonals(const Triangulation<2> &, const std::string &);
  template void check_diagonals(const Triangulation<3> &, const std::string &);
} // namespace Contact
