/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_depth.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <boost/serialization/array.hpp>
#include <cmath>
#include <limits>

namespace Contact
{
  namespace
  {
    /// Places of a facet, with its nodes or between them only.
    template<int dim>
    std::vector<FacetPoint<dim>> places_of_facet(const bool with_nodes);

    template<>
    std::vector<FacetPoint<2>> places_of_facet<2>(const bool with_nodes)
    {
      if (with_nodes)
        return {-1., -0.5, 0., 0.5, 1.};
      return {-0.5, 0., 0.5};
    }

    template<>
    std::vector<FacetPoint<3>> places_of_facet<3>(const bool with_nodes)
    {
      std::vector<FacetPoint<3>> places;
      for (const double xi : places_of_facet<2>(with_nodes))
        for (const double eta : places_of_facet<2>(with_nodes))
          places.emplace_back(xi, eta);
      return places;
    }



    /// By how much each facet may be beside the surface that it stands for, by
    /// the angles between the facets that meet smoothly at its nodes, as drawn:
    /// the sagitta. Corners and ends stand for themselves.
    template<int dim>
    std::vector<double> sagittas(const DeformedSurface<dim> &drawn)
    {
      const Surface<dim> &surface = drawn.surface;
      const auto         &means   = drawn.facet_normals();
      std::vector<double> sagittas(surface.facets.size(), 0.);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          {
            const double cosine =
              std::clamp(drawn.normal(e, node_place<dim>(a)) * means[e][a],
                         -1.,
                         1.);
            sagittas[e] =
              std::max(sagittas[e],
                       2 * std::acos(cosine) * surface.reference_length(e) / 4);
          }
      return sagittas;
    }



    /// The largest displacement of a node [mm].
    template<int dim>
    double largest_way(const DeformedSurface<dim> &now)
    {
      double largest = 0;
      for (unsigned int i = 0; i < now.positions.size(); ++i)
        largest =
          std::max(largest, now.positions[i].distance(now.surface.nodes[i].X));
      return largest;
    }



    /// Whether the closest place of a surface is on a side where it ends.
    template<int dim>
    bool is_at_end(const Surface<dim> &surface, const Projection<dim> &closest)
    {
      const SurfaceFacet<dim> &facet = surface.facets[closest.facet];
      for (unsigned int s = 0; s < facet.n_sides; ++s)
        if (facet.ends_surface(s) &&
            (s % 2 == 0 ? -1 : 1) * coordinate(closest.xi, s / 2) >= 1)
          return true;
      return false;
    }



    /// The depth of a place behind the closest place of the boundary of a body:
    /// at a convex edge it is behind all facets that meet there. Zero outside.
    template<int dim>
    double depth_behind(const DeformedSurface<dim> &boundary,
                        const Projection<dim>      &closest,
                        const Point<dim>           &x)
    {
      const auto is_behind = [&](const auto facet, const auto &xi) {
        return (x - boundary.position(facet, xi)) * boundary.normal(facet, xi) <
               0;
      };
      const bool is_inside =
        !is_at_end(boundary.surface, closest) &&
        is_behind(closest.facet, closest.xi) &&
        std::all_of(closest.twins.begin(),
                    closest.twins.end(),
                    [&](const auto &twin) {
                      return is_behind(twin.first, twin.second);
                    });
      return is_inside
               ? x.distance(boundary.position(closest.facet, closest.xi))
               : 0;
    }



    /// The deepest place of a surface inside of the other body. Each process
    /// looks at its share of the facets. A place deeper than @p way has not
    /// come there from outside: it is of the same body.
    template<int dim>
    void look(const DeformedSurface<dim> &own,
              const DeformedSurface<dim> &boundary,
              const DeformedSurface<dim> &slave,
              const MPI_Comm              communicator,
              const double                way,
              const bool                  as_drawn,
              ContactDepth<dim>          &deepest)
    {
      const bool                 is_master = &own != &slave;
      const DeformedSurface<dim> drawn(own.surface, {}),
        boundary_drawn(boundary.surface, {});
      const auto of_own = sagittas(drawn), of_other = sagittas(boundary_drawn);
      const BoundingBox<dim> box(boundary.positions);
      const auto             places = places_of_facet<dim>(/*with_nodes=*/true);
      for (const unsigned int e :
           Utilities::MPI::create_evenly_distributed_partitioning(
             communicator,
             own.surface.facets.size()))
        for (const FacetPoint<dim> &xi : places)
          {
            const Point<dim> x = own.position(e, xi);
            if (!box.point_inside(x))
              continue;
            const auto         closest = boundary.closest_point(x);
            const unsigned int f       = closest.facet;
            const double       behind  = depth_behind(boundary, closest, x);
            const double       depth =
              as_drawn ? behind : behind - of_own[e] - of_other[f];
            if (depth > deepest.depth && behind < way)
              deepest = {depth,
                         is_master,
                         drawn.position(e, xi),
                         is_master ? slave.closest_alone(x).facet : e,
                         (boundary.position(f, closest.xi) - x) / behind};
          }
    }



    /// The positions of the nodes of the boundary of a body under the
    /// displacement @p u, put together from what each process owns. Collective.
    template<int dim>
    std::vector<Point<dim>> gather_positions(const Surface<dim>  &boundary,
                                             const GhostedVector &u,
                                             const Discretization<dim> &of)
    {
      std::vector<double> ways;
      for (const SurfaceNode<dim> &node : boundary.nodes)
        for (const auto dof : node.dofs)
          ways.push_back(of.distribution->in_local_range(dof) ? u[dof] : 0.);
      Utilities::MPI::sum(ways, of.communicator, ways);
      std::vector<Point<dim>> positions;
      for (unsigned int i = 0; i < boundary.nodes.size(); ++i)
        {
          positions.push_back(boundary.nodes[i].X);
          for (unsigned int c = 0; c < dim; ++c)
            positions.back()[c] += ways[i * dim + c];
        }
      return positions;
    }



    /// The deepest place of the slave inside of an obstacle: between the nodes,
    /// where each node has a point that looks there, else at nodes as well. Not
    /// beside nodes that supports hold along the normal, which a note tells.
    template<int dim>
    void look_at_obstacle(const ContactPair<dim> &contact_pair,
                          const GhostedVector    &u,
                          const bool              as_drawn,
                          ContactDepth<dim>      &deepest)
    {
      const Surface<dim>        &slave = contact_pair.slave;
      const DeformedSurface<dim> now(slave, u), drawn(slave, {});
      const Obstacle<dim>       &obstacle       = *contact_pair.obstacle;
      const Discretization<dim> &discretization = contact_pair.discretization;
      const bool at_nodes = !contact_pair.has_point_per_multiplier();
      const auto is_held  = [&](const SurfaceFacet<dim> &facet,
                               const Tensor<1, dim>    &normal) {
        const double round_off = 1e-8;
        for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
          if (discretization.free_part(slave.nodes[facet.nodes[a]].dofs, normal)
                .norm() < round_off)
            return true;
        return false;
      };
      const auto places = places_of_facet<dim>(at_nodes);
      for (unsigned int e = 0; e < slave.facets.size(); ++e)
        for (const FacetPoint<dim> &xi : places)
          {
            const Point<dim> x       = now.position(e, xi);
            const auto       closest = obstacle.closest_point(x);
            if (!as_drawn && is_held(slave.facets[e], closest.normal))
              continue;
            const double h = // from corner to opposite corner
              std::sqrt(dim - 1.) * slave.reference_length(e);
            const double chord =
              h <= closest.radius ? h * h / (8 * closest.radius) : 0.;
            const double behind = (closest.x - x) * closest.normal;
            const double depth  = as_drawn ? behind : behind - chord;
            if (depth > deepest.depth)
              deepest = {depth,
                         false,
                         drawn.position(e, xi),
                         e,
                         closest.normal};
          }
    }



    /// Of those of all processes the deepest one.
    template<int dim>
    void compare(const MPI_Comm communicator, ContactDepth<dim> &deepest)
    {
      std::array<double, 3 + 2 * dim> own{
        {deepest.depth,
         static_cast<double>(deepest.of_master),
         static_cast<double>(deepest.slave_facet)}};
      for (unsigned int i = 0; i < dim; ++i)
        {
          own[3 + i]       = deepest.X[i];
          own[3 + dim + i] = deepest.normal[i];
        }
      for (const auto &of : Utilities::MPI::all_gather(communicator, own))
        if (of[0] > deepest.depth)
          {
            deepest.depth       = of[0];
            deepest.of_master   = of[1] > 0;
            deepest.slave_facet = static_cast<unsigned int>(of[2]);
            for (unsigned int i = 0; i < dim; ++i)
              {
                deepest.X[i]      = of[3 + i];
                deepest.normal[i] = of[3 + dim + i];
              }
          }
    }
  } // namespace



  template<int dim>
  ContactDepth<dim> largest_depth(const ContactPair<dim> &contact_pair,
                                  const GhostedVector    &u,
                                  const bool              as_drawn)
  {
    const MPI_Comm    communicator = contact_pair.discretization.communicator;
    ContactDepth<dim> deepest;
    if (contact_pair.master)
      {
        const DeformedSurface<dim> slave(contact_pair.slave, u),
          master(*contact_pair.master, u);
        const double way = as_drawn ? std::numeric_limits<double>::max()
                                    : largest_way(slave) + largest_way(master) +
                                        contact_pair.interference->at_start;
        const auto   look_from =
          [&](const auto &own, const auto &other, const auto &whole) {
            const auto look_at = [&](const DeformedSurface<dim> &boundary) {
              look(own, boundary, slave, communicator, way, as_drawn, deepest);
            };
            if (whole)
              look_at({*whole,
                       gather_positions(*whole, u, contact_pair.discretization),
                       /*overhang=*/0.});
            else
              look_at(other);
          };
        look_from(slave, master, contact_pair.boundaries[1]);
        look_from(master, slave, contact_pair.boundaries[0]);
        compare(communicator, deepest);
      }
    else
      look_at_obstacle(contact_pair, u, as_drawn, deepest);
    return deepest;
  }

  template ContactDepth<2>
  largest_depth(const ContactPair<2> &, const GhostedVector &, const bool);
  template ContactDepth<3>
  largest_depth(const ContactPair<3> &, const GhostedVector &, const bool);
} // namespace Contact
