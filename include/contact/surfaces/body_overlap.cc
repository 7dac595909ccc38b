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
  BodyOverlap<dim>::BodyOverlap(const Surfaces         &surfaces,
                                const GhostedVector    &u,
                                const SelfContact<dim> *itself)
    : surfaces(surfaces)
    , u(u)
    , itself(itself)
  {
  }



  template<int dim>
  bool BodyOverlap<dim>::is_between(const SurfacePlace<dim> &place,
                                    const unsigned int       of_place,
                                    const SurfacePlace<dim> &other) const
  {
    if (is_with_itself())
      return !SelfContact<dim>::are_back_to_back(place, other);
    const Tensor<1, dim> way    = other.x - place.x;
    const Point<dim>     middle = place.x + 0.5 * way;
    const double depth = NormalCone<dim>::smallest_cosine() * way.norm();
    return is_inside(place.x, 1 - of_place, depth) &&
           is_inside(other.x, of_place, depth) && is_inside(middle, 0, 0) &&
           is_inside(middle, 1, 0);
  }



  namespace
  {
    /// Whether a place is beyond an end of a surface, by more than @p slack,
    /// where the body has a side that is not known.
    template<int dim>
    bool is_beyond_end(const DeformedSurface<dim> &surface,
                       const Projection<dim>      &projection,
                       const Point<dim>           &x,
                       const double                slack)
    {
      if (!surface.is_at_end(projection))
        return false;
      const Tensor<1, dim> n = surface.normal(projection.facet, projection.xi);
      const Tensor<1, dim> r =
        x - surface.position(projection.facet, projection.xi);
      return (r - (r * n) * n).norm() > slack;
    }
  } // namespace



  // Facets that meet at an edge of a body have their closest place in common.
  // Outside of a convex edge is what is in front of one of them; outside of a
  // hollow one no place has the edge as its closest.
  template<int dim>
  bool BodyOverlap<dim>::is_inside(const Point<dim>  &x,
                                   const unsigned int body,
                                   const double       depth) const
  {
    if (deformed[body].empty())
      for (const Surface<dim> *surface : surfaces[body])
        deformed[body].emplace_back(*surface, u, /*overhang=*/0.);

    const double round_off = 1e-8;
    double       nearest = std::numeric_limits<double>::max(), beyond = 0;
    bool         is_behind = false, is_beyond = false;
    for (const DeformedSurface<dim> &surface : deformed[body])
      {
        const Projection<dim> projection = surface.closest_point(x);
        const double          distance =
          std::sqrt(surface.distance_square(x, projection));
        const double length =
          surface.surface.reference_length(projection.facet);
        const double same = round_off * length;
        if (distance > nearest + same)
          continue;
        const bool is_here   = surface.is_behind(x, projection, same);
        const bool is_nearer = distance < nearest - same;
        beyond               = DeformedSurface<dim>::overhang * length;
        is_behind            = is_here && (is_behind || is_nearer);
        is_beyond = is_nearer && is_beyond_end(surface, projection, x, beyond);
        nearest   = std::min(nearest, distance);
      }
    return nearest <= beyond ? depth <= beyond
                             : is_behind && !is_beyond && nearest >= depth;
  }

  template class BodyOverlap<2>;
  template class BodyOverlap<3>;
} // namespace Contact
