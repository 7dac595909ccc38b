/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/joined_cells.h"

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <iterator>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/coarse_cells.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    using Cell = typename Triangulation<dim>::active_cell_iterator;

    /// The corner of a cell that is not on one of its faces.
    template<int dim>
    unsigned int corner_across(const Cell<dim> &cell, const unsigned int f)
    {
      const auto face = cell->face(f);
      for (const unsigned int v : cell->vertex_indices())
        {
          bool is_on_it = false;
          for (const unsigned int w : face->vertex_indices())
            is_on_it =
              is_on_it || face->vertex_index(w) == cell->vertex_index(v);
          if (!is_on_it)
            return v;
        }
      throw ExcInternalError();
    }



    /// The shape functions of the corners at a place.
    template<int dim>
    std::array<double, dim + 1> weights(const Cell<dim>  &cell,
                                        const Point<dim> &X)
    {
      Tensor<2, dim> edges;
      for (unsigned int v = 0; v < dim; ++v)
        for (unsigned int d = 0; d < dim; ++d)
          edges[d][v] = cell->vertex(v + 1)[d] - cell->vertex(0)[d];
      const Tensor<1, dim>        xi = invert(edges) * (X - cell->vertex(0));
      std::array<double, dim + 1> result;
      result[0] = 1;
      for (unsigned int v = 0; v < dim; ++v)
        result[0] -= result[v + 1] = xi[v];
      return result;
    }
  } // namespace



  template<int dim>
  void check_joined_cells(
    const Triangulation<dim>                                  &mesh,
    const std::map<std::string, std::set<types::boundary_id>> &groups,
    const std::string                                         &file)
  {
    std::set<types::boundary_id> with_group;
    for (const auto &[name, ids] : groups)
      with_group.insert(ids.begin(), ids.end());
    std::vector<std::pair<BoundingBox<dim>, Cell<dim>>> boxes;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->reference_cell().is_simplex())
        boxes.emplace_back(cell->bounding_box(), cell);
    const auto   tree     = pack_rtree(boxes);
    const double in_front = 1e-3; // of the way from the face to the corner

    for (const auto &[box, cell] : boxes)
      for (const unsigned int f : cell->face_indices())
        {
          const unsigned int v      = corner_across<dim>(cell, f);
          const auto         middle = cell->face(f)->center();
          if (!cell->at_boundary(f))
            {
              const auto        &next = cell->neighbor(f);
              const unsigned int across =
                corner_across<dim>(next, cell->neighbor_of_neighbor(f));
              if (weights<dim>(cell, next->vertex(across))[v] >= 0)
                throw InputError("the mesh is folded: two cells are on the "
                                 "same side of the face at " +
                                   to_string(middle),
                                 file,
                                 "mend the nodes there, or mesh anew");
            }
          else if (with_group.count(cell->face(f)->boundary_id()) == 0)
            {
              const Point<dim> X =
                middle + in_front * (middle - cell->vertex(v));
              std::vector<std::pair<BoundingBox<dim>, Cell<dim>>> around;
              tree.query(boost::geometry::index::intersects(X),
                         std::back_inserter(around));
              for (const auto &candidate : around)
                {
                  const auto inside = weights<dim>(candidate.second, X);
                  if (candidate.second != cell &&
                      candidate.second->material_id() == cell->material_id() &&
                      *std::min_element(inside.begin(), inside.end()) > 0)
                    throw InputError(
                      "the mesh is cut open inside of a body: cells meet at " +
                        to_string(middle) + " that have no common face there",
                      file,
                      "join their nodes (gmsh: Coherence, Coherence Mesh), have "
                      "no nodes on edges of others, and volumes with a common "
                      "face not as 'Transfinite Volume' without 'Recombine'");
                }
            }
        }
  }

#define INSTANTIATE(dim)                                         \
  template void check_joined_cells(                              \
    const Triangulation<dim> &,                                  \
    const std::map<std::string, std::set<types::boundary_id>> &, \
    const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
