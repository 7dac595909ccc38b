/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/round_surface.h"

#include <cmath>

namespace Contact
{
  namespace
  {
    /// A point by its position along an axis and the vector from the axis.
    struct FromAxis
    {
      FromAxis(const Tensor<1, 3> &from_origin, const Tensor<1, 3> &axis)
        : height(from_origin * axis)
        , ray(from_origin - height * axis)
      {
      }

      double       height;
      Tensor<1, 3> ray;
    };



    Tensor<1, 3> normalized(const Tensor<1, 3> &vector)
    {
      return vector / vector.norm();
    }
  } // namespace



  RoundSurface sphere(const Point<3> &center, const double radius)
  {
    return {[=](const Point<3> &p) -> Point<3> {
              return center + radius * normalized(p - center);
            },
            [=](const Point<3> &) { return radius; }};
  }



  RoundSurface
  cylinder(const Point<3> &point, const Tensor<1, 3> &axis, const double radius)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis q(p - point, along);
              return point + q.height * along + radius * normalized(q.ray);
            },
            [=](const Point<3> &) { return radius; }};
  }



  // The projection onto the straight line of the cone in the half plane of p.
  RoundSurface
  cone(const Point<3> &apex, const Tensor<1, 3> &axis, const double angle)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis     q(p - apex, along);
              const Tensor<1, 3> line =
                std::cos(angle) * along + std::sin(angle) * normalized(q.ray);
              return apex + ((p - apex) * line) * line;
            },
            [=](const Point<3> &p) { return p.distance(apex); }};
  }



  RoundSurface torus(const Point<3>     &center,
                     const Tensor<1, 3> &axis,
                     const double        ring,
                     const double        tube)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis q(p - center, along);
              const Point<3> middle = center + ring * normalized(q.ray);
              return middle + tube * normalized(p - middle);
            },
            [=](const Point<3> &) { return tube; }};
  }



  RoundManifold::RoundManifold(const RoundSurface &surface)
    : surface(surface)
  {
  }



  std::unique_ptr<Manifold<3>> RoundManifold::clone() const
  {
    return std::make_unique<RoundManifold>(surface);
  }



  Point<3> RoundManifold::get_new_point(
    const ArrayView<const Point<3>> &surrounding_points,
    const ArrayView<const double>   &weights) const
  {
    Point<3> mean;
    for (unsigned int i = 0; i < weights.size(); ++i)
      mean += weights[i] * surrounding_points[i];
    return surface.closest(mean);
  }
} // namespace Contact
