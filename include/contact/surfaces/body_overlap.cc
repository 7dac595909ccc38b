/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/body_overlap.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  template<int dim>
  BodyOverlap<dim>::BodyOverlap(const Surfaces      &surfaces,
                                const GhostedVector &u)
    : surfaces(surfaces)
    , u(u)
  {
  }



  template<int dim>
  bool BodyOverlap<dim>::is_between(const Point<dim>  &x,
                                    const unsigned int of_x,
                                    const Point<dim>  &y) const
  {
    const Point<dim> middle = x + 0.5 * (y - x);
    return is_inside(x, 1 - of_x) && is_inside(y, of_x) &&
           is_inside(middle, 0) && is_inside(middle, 1);
  }



  namespace
  {
    /// Whether a place is beyond an end of a surface, by more than @p slack,
    /// where the body has a side that is not known.
    template<int dim>
    bool is_beyond_end(const DeformedSurface<dim> &surface,
                       const Projection<dim>      &projection_point,
                       const Point<dim>           &x,
                       const double                slack)
    {
      const auto &facet = surface.surface.facets[projection_point.facet];
      for (unsigned int s = 0; s < facet.n_sides; ++s)
        if (facet.ends_surface(s) &&
            (s % 2 == 0 ? -1 : 1) * coordinate(projection_point.xi, s / 2) >= 1)
          {
            const Tensor<1, dim> n =
              surface.normal(projection_point.facet, projection_point.xi);
            const Tensor<1, dim> r =
              x - surface.position(projection_point.facet, projection_point.xi);
            return (r - (r * n) * n).norm() > slack;
          }
      return false;
    }
  } // namespace



  // Facets that meet at an edge of a body have their closest place in common.
  // Outside of a convex edge is what is in front of one of them; outside of a
  // hollow one no place has the edge as its closest.
  template<int dim>
  bool BodyOverlap<dim>::is_inside(const Point<dim>  &x,
                                   const unsigned int body) const
  {
    if (deformed[body].empty())
      for (const Surface<dim> *surface : surfaces[body])
        deformed[body].emplace_back(*surface, u, /*overhang=*/0.);

    const double round_off = 1e-8;
    double       nearest = std::numeric_limits<double>::max(), beyond = 0;
    bool         is_behind = false, is_beyond = false;
    for (const DeformedSurface<dim> &surface : deformed[body])
      {
        const Projection<dim> projection_point = surface.closest_point(x);
        const double          distance =
          std::sqrt(surface.distance_square(x, projection_point));
        const double length =
          surface.surface.reference_length(projection_point.facet);
        const double same = round_off * length;
        if (distance > nearest + same)
          continue;
        const auto behind = [&](const unsigned int     facet,
                                const FacetPoint<dim> &xi) {
          return (x - surface.position(facet, xi)) *
                   surface.normal(facet, xi) <=
                 same;
        };
        const bool is_here =
          behind(projection_point.facet, projection_point.xi) &&
          std::all_of(projection_point.twins.begin(),
                      projection_point.twins.end(),
                      [&](const auto &twin) {
                        return behind(twin.first, twin.second);
                      });
        const bool is_nearer = distance < nearest - same;
        beyond               = DeformedSurface<dim>::overhang * length;
        is_behind            = is_here && (is_behind || is_nearer);
        is_beyond =
          is_nearer && is_beyond_end(surface, projection_point, x, beyond);
        nearest = std::min(nearest, distance);
        beyond  = DeformedSurface<dim>::overhang * length;
      }
    return nearest <= beyond || (is_behind && !is_beyond);
  }

  template class BodyOverlap<2>;
  template class BodyOverlap<3>;
} // namespace Contact
