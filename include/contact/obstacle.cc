/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/obstacle.h"

#include <cmath>


namespace Contact
{
  namespace
  {
    class HalfPlane : public Obstacle
    {
    public:
      HalfPlane(const Point<2> &point, const Tensor<1, 2> &normal)
        : point(point)
        , normal(normal / normal.norm())
      {
      }

      ClosestPoint closest_point(const Point<2> &x) const override
      {
        return {x - ((x - point) * normal) * normal, normal, 0};
      }

    private:
      const Point<2>     point;
      const Tensor<1, 2> normal;
    };



    class Circle : public Obstacle
    {
    public:
      Circle(const Point<2> &centre, const double radius)
        : centre(centre)
        , radius(radius)
      {
      }

      // In its centre any direction is as good as another.
      ClosestPoint closest_point(const Point<2> &x) const override
      {
        Tensor<1, 2> normal = x - centre;
        if (normal.norm() == 0)
          normal[1] = 1;
        normal *= std::copysign(1 / normal.norm(), radius);
        return {centre + radius * normal, normal, radius};
      }

    private:
      const Point<2> centre;
      const double   radius;
    };
  } // namespace



  std::unique_ptr<const Obstacle>
  Obstacle::create(const Parameters::ObstacleShape shape,
                   const std::vector<double>      &numbers)
  {
    using Parameters::ObstacleShape;
    const Point<2> x(numbers[0], numbers[1]);
    switch (shape)
      {
        case ObstacleShape::half_plane:
          return std::make_unique<HalfPlane>(x,
                                             Tensor<1, 2>(
                                               {numbers[2], numbers[3]}));
        case ObstacleShape::circle:
          return std::make_unique<Circle>(x, numbers[2]);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }
} // namespace Contact
