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



    /// The deepest place of @p surface. Each process looks at its share of the
    /// facets. A place further behind the other surface than its facet is long,
    /// or than the surfaces have moved, has come there around it.
    template<int dim>
    void look(const DeformedSurface<dim> &own,
              const DeformedSurface<dim> &facing,
              const bool                  is_master,
              const MPI_Comm              communicator,
              const BodyOverlap<dim>     &bodies,
              const double                way,
              const bool                  as_drawn,
              ContactDepth<dim>          &deepest)
    {
      const Surface<dim>        &surface = own.surface, &other = facing.surface;
      const DeformedSurface<dim> drawn(surface, {}), other_drawn(other, {});
      const auto of_own = sagittas(drawn), of_other = sagittas(other_drawn);
      double     longest = 0;
      for (unsigned int f = 0; f < other.facets.size(); ++f)
        longest = std::max(longest, other.reference_length(f));
      const auto is_close = facing.may_be_close(own, longest);
      const auto places   = places_of_facet<dim>(/*with_nodes=*/true);
      for (const unsigned int e :
           Utilities::MPI::create_evenly_distributed_partitioning(
             communicator,
             surface.facets.size()))
        for (const FacetPoint<dim> &xi : places)
          {
            if (!is_close[e])
              break;
            const Point<dim> x = own.position(e, xi);
            NormalCone<dim>  directions{{own.normal(e, xi)}};
            directions.reach   = 0;
            directions.overlap = [&](const auto &a, const auto &b) {
              return bodies.is_between(a, is_master, b);
            };
            const auto projection = facing.closest_facing(x, directions);
            const unsigned int f  = projection.facet;
            if (projection.beyond_end || projection.clipped ||
                largest_coordinate(projection.xi) > 1)
              continue;
            const double behind = -((x - facing.position(f, projection.xi)) *
                                    facing.normal(f, projection.xi));
            if (behind <= 0 ||
                behind >= std::min(way, other.reference_length(f)))
              continue;
            const double depth =
              as_drawn ? behind : behind - of_own[e] - of_other[f];
            if (depth > deepest.depth)
              deepest = {depth,
                         is_master,
                         drawn.position(e, xi),
                         is_master ? f : e};
          }
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
              deepest = {depth, false, drawn.position(e, xi), e};
          }
    }



    /// Of those of all processes the deepest one.
    template<int dim>
    void compare(const MPI_Comm communicator, ContactDepth<dim> &deepest)
    {
      std::array<double, 3 + dim> own{
        {deepest.depth,
         static_cast<double>(deepest.of_master),
         static_cast<double>(deepest.slave_facet)}};
      for (unsigned int i = 0; i < dim; ++i)
        own[3 + i] = deepest.X[i];
      for (const auto &of : Utilities::MPI::all_gather(communicator, own))
        if (of[0] > deepest.depth)
          {
            deepest = {of[0],
                       of[1] > 0,
                       Point<dim>(),
                       static_cast<unsigned int>(of[2])};
            for (unsigned int i = 0; i < dim; ++i)
              deepest.X[i] = of[3 + i];
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
        const BodyOverlap<dim> bodies(contact_pair.surfaces_of_bodies, u);
        const double way = as_drawn ? std::numeric_limits<double>::max()
                                    : largest_way(slave) + largest_way(master) +
                                        contact_pair.interference->at_start;
        look(slave,
             master,
             false,
             communicator,
             bodies,
             way,
             as_drawn,
             deepest);
        look(master, slave, true, communicator, bodies, way, as_drawn, deepest);
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
