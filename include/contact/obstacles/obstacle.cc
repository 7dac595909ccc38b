/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/obstacles/obstacle.h"

#include <cmath>

#include "base/errors.h"
#include "contact/obstacles/profile_obstacle.h"


namespace Contact
{
  namespace
  {
    template<int dim>
    class HalfSpace : public Obstacle<dim>
    {
    public:
      HalfSpace(const Point<dim> &point, const Tensor<1, dim> &normal)
        : point(point)
        , normal(normal / normal.norm())
      {
      }

      typename Obstacle<dim>::ClosestPoint
      closest_point(const Point<dim> &x) const override
      {
        return {x - ((x - point) * normal) * normal, normal, 0};
      }

      Point<dim> centre() const override
      {
        return point;
      }

    private:
      const Point<dim>     point;
      const Tensor<1, dim> normal;
    };



    template<int dim>
    class Ball : public Obstacle<dim>
    {
    public:
      Ball(const Point<dim> &middle, const double radius)
        : middle(middle)
        , radius(radius)
      {
      }

      // In its centre any direction is as good as another.
      typename Obstacle<dim>::ClosestPoint
      closest_point(const Point<dim> &x) const override
      {
        Tensor<1, dim> normal = x - middle;
        if (normal.norm() == 0)
          normal[1] = 1;
        normal *= std::copysign(1 / normal.norm(), radius);
        return {middle + radius * normal, normal, radius};
      }

      Point<dim> centre() const override
      {
        return middle;
      }

    private:
      const Point<dim> middle;
      const double     radius;
    };



    // A ball in the planes across the axis.
    class Cylinder : public Obstacle<3>
    {
    public:
      Cylinder(const Point<3>     &point,
               const Tensor<1, 3> &axis,
               const double        radius)
        : point(point)
        , axis(axis / axis.norm())
        , section(Point<3>(), radius)
      {
      }

      ClosestPoint closest_point(const Point<3> &x) const override
      {
        const Tensor<1, 3> along = ((x - point) * axis) * axis;
        auto closest = section.closest_point(Point<3>(x - point - along));
        closest.x += point + along;
        return closest;
      }

      Point<3> centre() const override
      {
        return point;
      }

    private:
      const Point<3>     point;
      const Tensor<1, 3> axis;
      const Ball<3>      section;
    };



    [[noreturn]] void refuse(const Parameters::ObstacleShape shape,
                             const std::string              &meshes,
                             const std::string              &remedy)
    {
      throw InputError(
        "the obstacle '" +
          Parameters::Choice<Parameters::ObstacleShape>(shape).name() +
          "' is none for a mesh of " + meshes,
        "Contact/Obstacle",
        remedy);
    }
  } // namespace



  template<>
  std::unique_ptr<Obstacle<2>>
  Obstacle<2>::create(const Parameters::ObstacleShape shape,
                      const std::vector<double>      &numbers)
  {
    using Parameters::ObstacleShape;
    const Point<2> x(numbers[0], numbers[1]);
    switch (shape)
      {
        case ObstacleShape::half_plane:
          return std::make_unique<HalfSpace<2>>(x,
                                                Tensor<1, 2>(
                                                  {numbers[2], numbers[3]}));
        case ObstacleShape::circle:
          return std::make_unique<Ball<2>>(x, numbers[2]);
        case ObstacleShape::profile:
          return std::make_unique<ProfileObstacle<2>>(numbers);
        default:
          refuse(shape, "surfaces", "take a half plane, a circle or a profile");
      }
  }



  template<>
  std::unique_ptr<Obstacle<3>>
  Obstacle<3>::create(const Parameters::ObstacleShape shape,
                      const std::vector<double>      &numbers)
  {
    using Parameters::ObstacleShape;
    if (shape == ObstacleShape::profile)
      return std::make_unique<ProfileObstacle<3>>(numbers);
    const Point<3> x(numbers[0], numbers[1], numbers[2]);
    const auto     direction = [&]() {
      return Tensor<1, 3>({numbers[3], numbers[4], numbers[5]});
    };
    switch (shape)
      {
        case ObstacleShape::half_space:
          return std::make_unique<HalfSpace<3>>(x, direction());
        case ObstacleShape::sphere:
          return std::make_unique<Ball<3>>(x, numbers[3]);
        case ObstacleShape::cylinder:
          return std::make_unique<Cylinder>(x, direction(), numbers[6]);
        default:
          refuse(shape,
                 "volumes",
                 "take a half space, a sphere, a cylinder or a profile");
      }
  }
} // namespace Contact
