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



  Sphere::Sphere(const Point<3> &center, const double radius)
    : center(center)
    , radius(radius)
  {
  }



  Point<3> Sphere::closest(const Point<3> &p) const
  {
    return center + radius * normalized(p - center);
  }



  double Sphere::size(const Point<3> &) const
  {
    return radius;
  }



  Cylinder::Cylinder(const Point<3>     &point,
                     const Tensor<1, 3> &axis,
                     const double        radius)
    : point(point)
    , axis(normalized(axis))
    , radius(radius)
  {
  }



  Point<3> Cylinder::closest(const Point<3> &p) const
  {
    const FromAxis q(p - point, axis);
    return point + q.height * axis + radius * normalized(q.ray);
  }



  double Cylinder::size(const Point<3> &) const
  {
    return radius;
  }



  Cone::Cone(const Point<3> &apex, const Tensor<1, 3> &axis, const double angle)
    : apex(apex)
    , axis(normalized(axis))
    , angle(angle)
  {
  }



  // The projection onto the straight line of the cone in the half plane of p.
  Point<3> Cone::closest(const Point<3> &p) const
  {
    const FromAxis     q(p - apex, axis);
    const Tensor<1, 3> line =
      std::cos(angle) * axis + std::sin(angle) * normalized(q.ray);
    return apex + ((p - apex) * line) * line;
  }



  double Cone::size(const Point<3> &p) const
  {
    return p.distance(apex);
  }



  Torus::Torus(const Point<3>     &center,
               const Tensor<1, 3> &axis,
               const double        ring,
               const double        tube)
    : center(center)
    , axis(normalized(axis))
    , ring(ring)
    , tube(tube)
  {
  }



  Point<3> Torus::closest(const Point<3> &p) const
  {
    const FromAxis q(p - center, axis);
    const Point<3> middle = center + ring * normalized(q.ray);
    return middle + tube * normalized(p - middle);
  }



  double Torus::size(const Point<3> &) const
  {
    return tube;
  }



  RoundManifold::RoundManifold(
    const std::shared_ptr<const RoundSurface> &surface)
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
    return surface->closest(mean);
  }
} // namespace Contact
