/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/place_search.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <array>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "base/constraint_entries.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/coarse_mesh.h"

namespace Contact
{
  template<int dim>
  PlaceSearch<dim>::PlaceSearch(const Mesh<dim>                  &mesh,
                                const hp::MappingCollection<dim> &mapping,
                                const DoFHandler<dim>            &dof_handler,
                                const MPI_Comm                    communicator)
    : mesh(mesh)
    , mapping(mapping)
    , dof_handler(dof_handler)
    , communicator(communicator)
  {
    if (!mesh.places.empty() && mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    hanging.close();
  }



  namespace
  {
    const std::string place_entry = "entry 'Mesh/Points'";

    /// Round-off of shape functions and coordinates in the reference cell.
    const double negligible = 1e-12;

    /// The point of the reference cell that is closest to @p xi.
    template<int dim>
    Point<dim> closest_in_unit_cell(const ReferenceCell &cell,
                                    const Point<dim>    &xi)
    {
      Point<dim> closest = GeometryInfo<dim>::project_to_unit_cell(xi);
      if (cell.is_hyper_cube() ||
          std::accumulate(&closest[0], &closest[0] + dim, 0.) <= 1)
        return closest;
      // On the face where they add up to one, less the same of each.
      std::array<double, dim> sorted;
      for (unsigned int d = 0; d < dim; ++d)
        sorted[d] = xi[d];
      std::sort(sorted.rbegin(), sorted.rend());
      double less = 0, sum = 0;
      for (unsigned int n = 0; n < dim; ++n)
        {
          sum += sorted[n];
          if (const double mean = (sum - 1) / (n + 1); mean < sorted[n])
            less = mean;
        }
      for (unsigned int d = 0; d < dim; ++d)
        closest[d] = std::max(xi[d] - less, 0.);
      return closest;
    }



    /// The point of the face @p f of the reference cell across from @p xi.
    template<int dim>
    Point<dim> across_face(const ReferenceCell &cell,
                           const unsigned int   f,
                           const Point<dim>    &xi)
    {
      Point<dim> across = xi;
      if (cell.is_hyper_cube())
        {
          across[f / 2] = f % 2;
          return across;
        }
      // Vertex d + 1 is where coordinate d is one.
      std::set<unsigned int> vertices;
      for (unsigned int v = 0; v < dim; ++v)
        vertices.insert(cell.face_to_cell_vertices(f, v, /*orientation=*/1));
      if (vertices.count(0) == 0)
        across *= 1 / std::accumulate(&xi[0], &xi[0] + dim, 0.);
      for (unsigned int d = 0; d < dim; ++d)
        if (vertices.count(0) > 0 && vertices.count(d + 1) == 0)
          across[d] = 0;
      return across;
    }



    /// Whether two places are the same point of a body: the weights of the
    /// same unknowns. Points of two bodies have none in common, and differ by
    /// two; points close to each other by next to nothing.
    template<int dim>
    bool are_the_same(const Place<dim> &a, const Place<dim> &b)
    {
      typename Place<dim>::Weights difference = a.unknowns[0];
      for (const auto &[dof, weight] : b.unknowns[0])
        difference[dof] -= weight;
      double sum = 0;
      for (const auto &[dof, weight] : difference)
        sum += std::abs(weight);
      return sum < 1;
    }
  } // namespace



  // The smallest distance wins; where cells have the place in common, the first
  // of them on any number of ranks.
  template<int dim>
  Place<dim> PlaceSearch<dim>::find(const std::string &name) const
  {
    const NamedPlace<dim> &named = mesh.places.at(name);
    const auto             all =
      Utilities::MPI::all_gather(communicator, candidates(named));
    const Candidate *best  = nullptr;
    unsigned int     owner = 0;
    for (unsigned int rank = 0; rank < all.size(); ++rank)
      for (const Candidate &candidate : all[rank])
        if (const double ahead = best ? best->distance - candidate.distance
                                      : std::numeric_limits<double>::max();
            ahead > candidate.round_off ||
            (ahead >= -candidate.round_off && candidate.cell < best->cell))
          {
            best  = &candidate;
            owner = rank;
          }
    if (best == nullptr || best->distance > best->allowed)
      throw InputError("no body is at the point '" + name + "'",
                       place_entry,
                       "the closest corner of a cell is at " +
                         to_string(named.closest_node) + " mm, " +
                         brief(named.distance) +
                         " mm away, in the coordinates of the file");

    Place<dim> place = best->place;
    if (owner != Utilities::MPI::this_mpi_process(communicator))
      place.vertices.clear();
    for (const auto &of_rank : all)
      for (const Candidate &candidate : of_rank)
        {
          if (candidate.distance > best->distance + candidate.close)
            continue;
          if (!are_the_same(candidate.place, best->place))
            throw InputError("two bodies, or two sides of one, are at the "
                             "point '" +
                               name + "', which could be either's",
                             place_entry,
                             "name the body, '" + name +
                               " in BODY: x, y', or "
                               "move the point into one, by more than " +
                               brief(mesh.typed_digits) + " mm");
          place.coarse_cells.insert(candidate.place.coarse_cells.begin(),
                                    candidate.place.coarse_cells.end());
        }
    return place;
  }



  // Cells farther away than a diameter from their centre are not looked at.
  template<int dim>
  std::vector<typename PlaceSearch<dim>::Candidate>
  PlaceSearch<dim>::candidates(const NamedPlace<dim> &named) const
  {
    std::vector<Candidate> found;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned() ||
            named.in_body.count(cell->material_id()) == 0)
          continue;
        const Point<dim> &X        = named.in_body.at(cell->material_id());
        const double      diameter = cell->diameter();
        Candidate         candidate;
        Point<dim>        xi;
        if (X.distance(cell->center()) > diameter ||
            !closest_point(cell, X, xi, candidate.distance))
          continue;
        candidate.allowed   = mesh.typed_digits + distance_from_curve(cell, xi);
        candidate.round_off = 1e-10 * diameter;
        candidate.close     = std::min(mesh.typed_digits, 1e-2 * diameter);
        candidate.cell      = cell->id();
        if (candidate.distance > candidate.allowed)
          continue;
        move_to_boundary(cell, X, candidate.close, xi);
        candidate.place = place_in(cell, xi);
        found.push_back(candidate);
      }
    return found;
  }



  // False where the mapping has no inverse, far outside a curved cell.
  template<int dim>
  bool PlaceSearch<dim>::closest_point(const Cell       &cell,
                                       const Point<dim> &X,
                                       Point<dim>       &xi,
                                       double           &distance) const
  {
    const auto &of_cell = mapping[cell->active_fe_index()];
    try
      {
        xi = closest_in_unit_cell<dim>(cell->reference_cell(),
                                       of_cell.transform_real_to_unit_cell(cell,
                                                                           X));
      }
    catch (const typename Mapping<dim>::ExcTransformationFailed &)
      {
        return false;
      }
    distance = X.distance(of_cell.transform_unit_to_real_cell(cell, xi));
    return true;
  }



  // The side of a cell stands for its curve: the polygon inside a circle for
  // the circle.
  template<int dim>
  void PlaceSearch<dim>::move_to_boundary(const Cell       &cell,
                                          const Point<dim> &X,
                                          const double      close,
                                          Point<dim>       &xi) const
  {
    const auto &of_cell = mapping[cell->active_fe_index()];
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
        {
          const auto across = across_face<dim>(cell->reference_cell(), f, xi);
          const Tensor<1, dim> way =
            X - of_cell.transform_unit_to_real_cell(cell, across);
          const Tensor<1, dim> to_curve = way_to_curve(cell, f, across);
          const double         bulge    = to_curve.norm();
          const bool           is_on_curve =
            way.norm() <= bulge + close &&
            std::abs((way - to_curve) * to_curve) <= close * bulge;
          if (way.norm() <= close || (bulge > close && is_on_curve))
            xi = across;
        }
  }



  // From the point xi of a face to the curve that the face stands for.
  template<int dim>
  Tensor<1, dim> PlaceSearch<dim>::way_to_curve(const Cell        &cell,
                                                const unsigned int f,
                                                const Point<dim>  &xi) const
  {
    std::vector<Point<dim>> corners;
    std::vector<double>     weights;
    for (const unsigned int v : cell->vertex_indices())
      if (const double weight =
            cell->reference_cell().d_linear_shape_function(xi, v);
          std::abs(weight) > negligible)
        {
          corners.push_back(cell->vertex(v));
          weights.push_back(weight);
        }
    return cell->face(f)->get_manifold().get_new_point(make_array_view(corners),
                                                       make_array_view(
                                                         weights)) -
           mapping[cell->active_fe_index()].transform_unit_to_real_cell(cell,
                                                                        xi);
  }



  template<int dim>
  double PlaceSearch<dim>::distance_from_curve(const Cell       &cell,
                                               const Point<dim> &xi) const
  {
    double largest = 0;
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) &&
          xi.distance(across_face<dim>(cell->reference_cell(), f, xi)) <
            negligible)
        largest = std::max(largest, way_to_curve(cell, f, xi).norm());
    return largest;
  }



  template<int dim>
  Place<dim> PlaceSearch<dim>::place_in(const Cell       &cell,
                                        const Point<dim> &xi) const
  {
    Place<dim> place;
    place.coarse_cells = {cell->id().get_coarse_cell_id()};
    for (const unsigned int v : cell->vertex_indices())
      if (const double weight =
            cell->reference_cell().d_linear_shape_function(xi, v);
          std::abs(weight) > negligible)
        place.vertices[cell->vertex_index(v)] = weight;

    const auto                          &fe = cell->get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (const double weight = fe.shape_value(i, xi);
          std::abs(weight) > negligible)
        {
          auto &of_component =
            place.unknowns[fe.system_to_component_index(i).first];
          visit_leaders(hanging,
                        dofs[i],
                        [&](const auto dof, const double factor) {
                          of_component[dof] += weight * factor;
                        });
        }
    return place;
  }



  template class PlaceSearch<2>;
  template class PlaceSearch<3>;
} // namespace Contact
