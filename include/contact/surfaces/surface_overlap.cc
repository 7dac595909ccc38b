/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/surface_overlap.h"

#include <algorithm>
#include <map>

namespace Contact
{
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



  namespace
  {
    /// Undeformed surfaces by the connected part of the mesh that they are on.
    template<int dim>
    class DrawnBodies
    {
    public:
      const DeformedSurface<dim> &add(const Surface<dim> &surface)
      {
        const auto [entry, is_new] =
          drawn.try_emplace(&surface, surface, GhostedVector());
        if (is_new)
          of_part[surface.facets[0].part].push_back(&entry->second);
        return entry->second;
      }

      /// Whether a place is inside of the body that a surface is on: behind
      /// all facets that have the closest place.
      bool is_inside(const Point<dim> &x, const Surface<dim> &surface) const
      {
        const double round_off = 1e-8 * surface.reference_length(0);
        double       nearest   = std::numeric_limits<double>::max();
        bool         inside    = false;
        for (const DeformedSurface<dim> *side :
             of_part.at(surface.facets[0].part))
          {
            const Projection<dim> foot = side->closest_point(x);
            const double distance = std::sqrt(side->distance_square(x, foot));
            if (distance > nearest + round_off)
              continue;
            bool       is_behind = true;
            const auto look      = [&](const unsigned int     facet,
                                  const FacetPoint<dim> &xi) {
              is_behind = is_behind && (x - side->position(facet, xi)) *
                                           side->normal(facet, xi) <
                                         -round_off;
            };
            look(foot.facet, foot.xi);
            for (const auto &[facet, xi] : foot.twins)
              look(facet, xi);
            inside  = is_behind && (inside || distance < nearest - round_off);
            nearest = std::min(nearest, distance);
          }
        return inside;
      }

    private:
      std::map<const Surface<dim> *, const DeformedSurface<dim>>        drawn;
      std::map<unsigned int, std::vector<const DeformedSurface<dim> *>> of_part;
    };
  } // namespace



  template<int dim>
  void visit_overlaps(
    const DeformedSurface<dim>                               &own,
    const DeformedSurface<dim>                               &facing,
    const double                                              reach,
    const MPI_Comm                                            communicator,
    const std::function<void(const OverlappingPlace<dim> &)> &visit)
  {
    const auto is_close = facing.may_be_close(own, reach);
    for (const unsigned int e :
         Utilities::MPI::create_evenly_distributed_partitioning(
           communicator,
           own.surface.facets.size()))
      if (is_close[e])
        for (const FacetPoint<dim> &xi :
             places_of_facet<dim>(/*with_nodes=*/true))
          {
            const Point<dim> x = own.position(e, xi);
            NormalCone<dim>  directions{{own.normal(e, xi)}};
            directions.depth    = reach;
            const auto opposite = facing.closest_facing(x, directions);
            if (opposite.off_the_end || opposite.clipped ||
                largest_coordinate(opposite.xi) > 1)
              continue;
            const double depth =
              (facing.position(opposite.facet, opposite.xi) - x) *
              facing.normal(opposite.facet, opposite.xi);
            if (depth > 0)
              visit({e, xi, opposite, depth});
          }
  }



  // An overlap of two bodies is in the boxes around both.
  template<int dim>
  std::vector<double> overlaps_as_drawn(
    const std::vector<std::pair<const Surface<dim> *, const Surface<dim> *>>
                  &pairs,
    const MPI_Comm communicator)
  {
    DrawnBodies<dim> bodies;
    for (const auto &[slave, master] : pairs)
      {
        bodies.add(*slave);
        bodies.add(*master);
      }

    std::vector<double> overlaps;
    for (const auto &[slave, master] : pairs)
      {
        const DeformedSurface<dim> &a = bodies.add(*slave),
                                   &b = bodies.add(*master);
        const BoundingBox<dim> box_a(a.positions), box_b(b.positions);
        double                 reach = 0;
        for (unsigned int i = 0; i < dim; ++i)
          reach = std::max({reach, box_a.side_length(i), box_b.side_length(i)});
        double     overlap = 0;
        const auto look    = [&](const DeformedSurface<dim> &own,
                              const DeformedSurface<dim> &facing) {
          visit_overlaps<dim>(
            own,
            facing,
            reach,
            communicator,
            [&](const OverlappingPlace<dim> &place) {
              if (place.depth > overlap &&
                  bodies.is_inside(own.position(place.facet, place.xi),
                                   facing.surface) &&
                  bodies.is_inside(facing.position(place.opposite.facet,
                                                   place.opposite.xi),
                                   own.surface))
                overlap = place.depth;
            });
        };
        look(a, b);
        look(b, a);
        overlaps.push_back(Utilities::MPI::max(overlap, communicator));
      }
    return overlaps;
  }

#define INSTANTIATE(dim)                                                     \
  template void visit_overlaps(                                              \
    const DeformedSurface<dim> &,                                            \
    const DeformedSurface<dim> &,                                            \
    const double,                                                            \
    const MPI_Comm,                                                          \
    const std::function<void(const OverlappingPlace<dim> &)> &);             \
  template std::vector<double> overlaps_as_drawn(                            \
    const std::vector<std::pair<const Surface<dim> *, const Surface<dim> *>> \
      &pairs,                                                                \
    const MPI_Comm);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
