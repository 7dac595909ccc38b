/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/obstacles/moving_obstacle.h"

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <cmath>

#include "base/dimension.h"
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

    /// The way of a point per angle.
    Tensor<1, 2> turned(const Tensor<1, 3> &, const Tensor<1, 2> &arm)
    {
      return Tensor<1, 2>({-arm[1], arm[0]});
    }

    Tensor<1, 3> turned(const Tensor<1, 3> &axis, const Tensor<1, 3> &arm)
    {
      return cross_product_3d(axis, arm);
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
      for (const auto &[entry, of_entry] :
           {std::make_pair("Obstacle motion", motion),
            std::make_pair("Obstacle force", parameters.obstacle_force)})
        if (dim == 2 && of_entry.count("z") > 0)
          refuse("the mesh is plane and has no direction z",
                 entry,
                 "remove it, or take a mesh of volumes");
      if (!centre.empty() && centre.size() != dim)
        refuse("this is no point",
               "Obstacle centre",
               std::string("write ") + Dimension<dim>::coordinates);
      if (!axis.empty() && (dim == 2 || axis.size() != 3 ||
                            std::count(axis.begin(), axis.end(), 0.) == 3))
        refuse("this is no direction in 3-D",
               "Obstacle axis",
               "write x, y, z; in 2-D there is none");
      if (dim == 3 &&
          (motion.count("angle") > 0 || !parameters.obstacle_moment.empty()) &&
          axis.empty() && shape != ObstacleShape::cylinder &&
          shape != ObstacleShape::profile)
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
    , moves(!parameters.obstacle_motion.empty() || parameters.has_free_motion())
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
        if (parameters.obstacle_force.count(std::string(1, "xyz"[i])) > 0)
          components.push_back(i);
      }
    angle = history("angle");
    if (!parameters.obstacle_moment.empty())
      components.push_back(dim);
    placed.resize(components.size());

    const auto &[name, numbers] = *parameters.obstacle.begin();
    if (name == Parameters::ObstacleShape::cylinder)
      axis = Tensor<1, 3>({numbers[3], numbers[4], numbers[5]});
    if (!parameters.obstacle_axis.empty())
      for (unsigned int i = 0; i < 3; ++i)
        axis[i] = parameters.obstacle_axis[i];
    axis /= axis.norm();
    first = start = end = reached = placement(0, placed);
  }



  template<int dim>
  typename MovingObstacle<dim>::Placement
  MovingObstacle<dim>::placement(const double               load_factor,
                                 const std::vector<double> &free) const
  {
    const auto value = [&](const History &history) {
      return history ? history(Point<1>(load_factor)) : 0.;
    };
    Placement placed;
    placed.centre = pivot;
    for (unsigned int i = 0; i < dim; ++i)
      placed.shift[i] = value(shifts[i]);
    placed.angle = value(angle) * numbers::PI / 180;
    for (unsigned int k = 0; k < components.size(); ++k)
      if (components[k] < dim)
        placed.shift[components[k]] += free[k];
      else
        placed.angle += free[k];
    placed.rotation = rotation(axis, placed.angle, pivot);
    return placed;
  }



  template<int dim>
  bool MovingObstacle<dim>::move(const double               from,
                                 const double               to,
                                 const std::vector<double> &free)
  {
    load_factor = to;
    start       = placement(from, free);
    place(free, /*keeps_place=*/false);
    return moves;
  }



  template<int dim>
  void MovingObstacle<dim>::place(const std::vector<double> &free,
                                  const bool                 keeps_place)
  {
    reached = placement(load_factor, free);
    if (keeps_place)
      return;
    end    = reached;
    placed = free;
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
    for (unsigned int k = 0; k < components.size(); ++k)
      {
        Tensor<1, dim> way;
        if (components[k] < dim)
          way[components[k]] = 1;
        else
          way = turned(axis, closest.x - centre());
        closest.motions.push_back({way, placed[k]});
      }
    return closest;
  }



  template<int dim>
  Point<dim> MovingObstacle<dim>::carried(const Point<dim> &x) const
  {
    return end.at(start.back(x));
  }



  template<int dim>
  typename Obstacle<dim>::Motion MovingObstacle<dim>::motion() const
  {
    return {reached.shift - start.shift,
            turn_about(axis, reached.angle - start.angle, pivot)};
  }

  template<int dim>
  std::optional<typename Obstacle<dim>::Travel>
  MovingObstacle<dim>::travel() const
  {
    if (!moves)
      return {};
    return typename Obstacle<dim>::Travel{reached.shift - first.shift,
                                          (reached.angle - first.angle) * 180 /
                                            numbers::PI};
  }

  template<int dim>
  double MovingObstacle<dim>::given_way(const double reach) const
  {
    const std::vector<double> none(components.size());
    const Placement           at_first = placement(0, none);
    const Placement           now      = placement(load_factor, none);
    return (now.shift - at_first.shift).norm() +
           std::abs(now.angle - at_first.angle) * reach;
  }

  template class MovingObstacle<2>;
  template class MovingObstacle<3>;
} // namespace Contact
