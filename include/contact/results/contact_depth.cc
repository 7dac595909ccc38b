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



    /// The directions that a place of a facet looks in, and nothing beside it.
    NormalCone<2> straight_ahead(const Tensor<1, 2> &normal)
    {
      return {normal, normal};
    }

    NormalCone<3> straight_ahead(const Tensor<1, 3> &normal)
    {
      NormalCone<3> directions;
      directions.normals = {normal};
      return directions;
    }



    /// Whether a place is on the overhang of a facet beyond its end.
    bool is_beyond(const double xi)
    {
      return std::abs(xi) > 1;
    }

    bool is_beyond(const Point<2> &xi)
    {
      return is_beyond(xi[0]) || is_beyond(xi[1]);
    }



    /// By how much each facet may be beside the surface that it stands for, by
    /// the angles between the facets that meet smoothly at its nodes, as drawn:
    /// the sagitta. Corners and ends stand for themselves.
    template<int dim>
    std::vector<double> sagittas(const Surface<dim>  &surface,
                                 const GhostedVector &undeformed)
    {
      const SurfaceSearch<dim> own(surface, undeformed);
      const auto               means = surface.facet_normals(undeformed);
      std::vector<double>      sagittas(surface.facets.size(), 0.);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          {
            const double cosine =
              std::clamp(own.normal(e, node_place<dim>(a)) * means[e][a],
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
    double largest_way(const Surface<dim> &surface, const GhostedVector &u)
    {
      double largest = 0;
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        largest = std::max(largest,
                           surface.position(i, u).distance(surface.nodes[i].X));
      return largest;
    }



    /// The deepest place of @p surface. Each process looks at its share of the
    /// facets. A place further behind the other surface than its facet is long,
    /// or than the surfaces have moved, has come there around it.
    template<int dim>
    void look(const Surface<dim>  &surface,
              const Surface<dim>  &other,
              const bool           is_master,
              const MPI_Comm       communicator,
              const double         reach,
              const GhostedVector &u,
              const bool           as_drawn,
              ContactDepth<dim>   &deepest)
    {
      const SurfaceSearch<dim> own(surface, u), search(other, u);
      const auto               of_own = sagittas(surface, u.zero()),
                 of_other             = sagittas(other, u.zero());
      double longest                  = 0;
      for (unsigned int f = 0; f < other.facets.size(); ++f)
        longest = std::max(longest, other.reference_length(f));
      const auto is_close = search.may_be_close(own, longest);
      const auto places   = places_of_facet<dim>(/*with_nodes=*/true);
      for (const unsigned int e :
           Utilities::MPI::create_evenly_distributed_partitioning(
             communicator,
             surface.facets.size()))
        for (const FacetPoint<dim> &xi : places)
          {
            if (!is_close[e])
              break;
            const FacetShape<dim> shape(surface.degree, xi);
            Point<dim>            x, X;
            for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
              {
                const unsigned int i = surface.facets[e].nodes[a];
                x += shape.value[a] * surface.position(i, u);
                X += shape.value[a] * surface.nodes[i].X;
              }
            const auto projection =
              search.closest_facing(x, straight_ahead(own.normal(e, xi)));
            const unsigned int f = projection.facet;
            if (projection.off_the_end || projection.clipped ||
                is_beyond(projection.xi))
              continue;
            const double behind = -((x - search.position(projection)) *
                                    search.normal(f, projection.xi));
            if (behind <= 0 ||
                behind >= std::min(reach, other.reference_length(f)))
              continue;
            const double depth =
              as_drawn ? behind : behind - of_own[e] - of_other[f];
            if (depth > deepest.depth)
              deepest = {depth, is_master, X, is_master ? f : e};
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
      const Surface<dim>        &slave          = contact_pair.slave;
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
            const FacetShape<dim> shape(slave.degree, xi);
            Point<dim>            x, X;
            for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
              {
                const unsigned int i = slave.facets[e].nodes[a];
                x += shape.value[a] * slave.position(i, u);
                X += shape.value[a] * slave.nodes[i].X;
              }
            const auto closest = obstacle.closest_point(x);
            if (!as_drawn && is_held(slave.facets[e], closest.normal))
              continue;
            const double h = // from corner to opposite corner
              std::sqrt(dim - 1.) * slave.reference_length(e);
            const double chord =
              h <= closest.radius ? h * h / (8 * closest.radius) : 0.;
            const double behind = (closest.x - x) * closest.normal;
            const double depth  = as_drawn ? behind : behind - chord;
            if (depth > deepest.depth)
              deepest = {depth, false, X, e};
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
        const Surface<dim> &slave  = contact_pair.slave,
                           &master = *contact_pair.master;
        const double reach = largest_way(slave, u) + largest_way(master, u) +
                             contact_pair.interference->at_start;
        look(slave, master, false, communicator, reach, u, as_drawn, deepest);
        look(master, slave, true, communicator, reach, u, as_drawn, deepest);
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
