/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/mesh_pieces.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace Contact
{
  template<int dim>
  void MeshPieces<dim>::find(const Triangulation<dim> &triangulation)
  {
    pieces.clear();
    by_coarse_cell.assign(triangulation.n_cells(0),
                          numbers::invalid_unsigned_int);
    for (const auto &seed : triangulation.cell_iterators_on_level(0))
      {
        if (by_coarse_cell[seed->index()] != numbers::invalid_unsigned_int)
          continue;

        // From neighbor to neighbor through all cells of the piece.
        const unsigned int number = pieces.size();
        pieces.push_back(
          {seed->material_id(),
           BoundingBox<dim>({seed->vertex(0), seed->vertex(0)})});
        std::vector<typename Triangulation<dim>::cell_iterator> to_visit{seed};
        by_coarse_cell[seed->index()] = number;
        while (!to_visit.empty())
          {
            const auto cell = to_visit.back();
            to_visit.pop_back();
            for (const unsigned int v : cell->vertex_indices())
              pieces[number].box.merge_with(
                BoundingBox<dim>({cell->vertex(v), cell->vertex(v)}));
            for (const unsigned int f : cell->face_indices())
              if (!cell->at_boundary(f))
                if (const auto neighbor = cell->neighbor(f);
                    neighbor->material_id() == seed->material_id() &&
                    by_coarse_cell[neighbor->index()] ==
                      numbers::invalid_unsigned_int)
                  {
                    by_coarse_cell[neighbor->index()] = number;
                    to_visit.push_back(neighbor);
                  }
          }
      }
    find_joints(triangulation);
  }



  template<int dim>
  void MeshPieces<dim>::find_joints(const Triangulation<dim> &triangulation)
  {
    by_vertex.clear();
    all_joints.clear();
    std::set<std::pair<unsigned int, unsigned int>> seen; // vertex, piece
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        {
          const unsigned int vertex = cell->vertex_index(v);
          const unsigned int piece  = by_coarse_cell[cell->index()];
          if (!seen.emplace(vertex, piece).second)
            continue;
          const auto first = by_vertex.emplace(vertex, piece);
          if (!first.second)
            all_joints.push_back({first.first->second, piece, cell->vertex(v)});
        }
  }



  template<int dim>
  unsigned int MeshPieces<dim>::of_cell(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    auto ancestor = cell;
    while (ancestor->level() > 0)
      ancestor = ancestor->parent();
    return by_coarse_cell[ancestor->index()];
  }



  template<int dim>
  bool MeshPieces<dim>::is_whole_body(const unsigned int piece) const
  {
    return std::count_if(pieces.begin(), pieces.end(), [&](const auto &other) {
             return other.body == pieces[piece].body;
           }) == 1;
  }



  template<int dim>
  std::string MeshPieces<dim>::describe(const unsigned int piece,
                                        const std::string &body) const
  {
    if (is_whole_body(piece))
      return "the body '" + body + "'";
    const auto &[low, high] = pieces[piece].box.get_boundary_points();
    const auto place        = [](const Point<dim> &p) {
      std::ostringstream text;
      for (unsigned int d = 0; d < dim; ++d)
        text << (d == 0 ? "(" : ", ") << p[d];
      return text.str() + ")";
    };
    return "the piece of the body '" + body + "' from " + place(low) + " to " +
           place(high) + " mm";
  }



  template class MeshPieces<2>;
  template class MeshPieces<3>;
} // namespace Contact
