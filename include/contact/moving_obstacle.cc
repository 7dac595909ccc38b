/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/moving_obstacle.h"

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    namespace Rotations = Physics::Transformations::Rotations;

    Tensor<2, 2>
    rotation(const Tensor<1, 3> &, const double angle, const Point<2> &)
    {
      return Rotations::rotation_matrix_2d(angle);
    }

    Tensor<2, 3>
    rotation(const Tensor<1, 3> &axis, const double angle, const Point<3> &)
    {
      return Rotations::rotation_matrix_3d(Point<3>(axis), angle);
    }

    Moment<2>
    turn_about(const Tensor<1, 3> &, const double angle, const Point<2> &)
    {
      return Moment<2>({angle});
    }

    Moment<3>
    turn_about(const Tensor<1, 3> &axis, const double angle, const Point<3> &)
    {
      return angle * axis;
    }
    /// Throws InputError where a motion is none of this dimension.
    template<int dim>
    void check(const Parameters::Contact &parameters)
    {
      using Parameters::ObstacleShape;
      const auto refuse = [&](const std::string &problem,
                              const std::string &entry,
                              const std::string &remedy) {
        throw InputError(problem, parameters.section() + "/" + entry, remedy);
      };
      const auto &motion = parameters.obstacle_motion;
      const auto &axis   = parameters.obstacle_axis;
      const auto &centre = parameters.obstacle_centre;
      const auto  shape  = parameters.obstacle.begin()->first;
      if (dim == 2 && motion.count("z") > 0)
        refuse("the mesh is plane and has no direction z",
               "Obstacle motion",
               "remove it, or take a mesh of volumes");
      if (!centre.empty() && centre.size() != dim)
        refuse("this is no point",
               "Obstacle centre",
               dim == 2 ? "write x, y" : "write x, y, z");
      if (!axis.empty() && (dim == 2 || axis.size() != 3 ||
                            std::count(axis.begin(), axis.end(), 0.) == 3))
        refuse("this is no direction in space",
               "Obstacle axis",
               "write x, y, z; in the plane there is none");
      if (dim == 3 && motion.count("angle") > 0 && axis.empty() &&
          shape != ObstacleShape::cylinder && shape != ObstacleShape::profile)
        refuse("the obstacle turns about no axis",
               "Obstacle axis",
               "set the direction of the axis");
    }
  } // namespace



  // A cylinder turns about its own axis if nothing else is said.
  template<int dim>
  MovingObstacle<dim>::MovingObstacle(
    std::unique_ptr<const Obstacle<dim>> shape_,
    const Parameters::Contact           &parameters)
    : shape(std::move(shape_))
    , moves(!parameters.obstacle_motion.empty())
    , pivot(shape->centre())
    , axis({0, 0, 1})
  {
    check<dim>(parameters);
    const std::string entry   = parameters.section() + "/Obstacle motion";
    const auto        history = [&](const std::string &name) -> History {
      const auto found = parameters.obstacle_motion.find(name);
      return found == parameters.obstacle_motion.end()
                      ? History()
                      : parse_history(found->second, entry);
    };
    for (unsigned int i = 0; i < dim; ++i)
      {
        shifts[i] = history(std::string(1, "xyz"[i]));
        if (!parameters.obstacle_centre.empty())
          pivot[i] = parameters.obstacle_centre[i];
      }
    angle = history("angle");

    const auto &[name, numbers] = *parameters.obstacle.begin();
    if (name == Parameters::ObstacleShape::cylinder)
      axis = Tensor<1, 3>({numbers[3], numbers[4], numbers[5]});
    if (!parameters.obstacle_axis.empty())
      for (unsigned int i = 0; i < 3; ++i)
        axis[i] = parameters.obstacle_axis[i];
    axis /= axis.norm();
    first = start = end = placement(0);
  }



  template<int dim>
  typename MovingObstacle<dim>::Placement
  MovingObstacle<dim>::placement(const double load_factor) const
  {
    const auto value = [&](const History &history) {
      return history ? history(Point<1>(load_factor)) : 0.;
    };
    Placement placed;
    placed.centre = pivot;
    for (unsigned int i = 0; i < dim; ++i)
      placed.shift[i] = value(shifts[i]);
    placed.angle    = value(angle) * numbers::PI / 180;
    placed.rotation = rotation(axis, placed.angle, pivot);
    return placed;
  }



  template<int dim>
  bool MovingObstacle<dim>::move(const double from, const double to)
  {
    start = placement(from);
    end   = placement(to);
    return moves;
  }



  template<int dim>
  typename Obstacle<dim>::ClosestPoint
  MovingObstacle<dim>::closest_point(const Point<dim> &x) const
  {
    auto             closest = shape->closest_point(end.back(x));
    const Point<dim> X       = closest.x;
    closest.x                = end.at(X);
    closest.normal           = end.rotation * closest.normal;
    closest.motion           = closest.x - start.at(X);
    closest.stretch          = 1 - std::cos(end.angle - start.angle);
    return closest;
  }



  template<int dim>
  typename Obstacle<dim>::Motion MovingObstacle<dim>::motion() const
  {
    return {end.shift - start.shift,
            turn_about(axis, end.angle - start.angle, pivot)};
  }

  template class MovingObstacle<2>;
  template class MovingObstacle<3>;
} // namespace Contact
