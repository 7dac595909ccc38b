/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_obstacle_h
#define contact_obstacle_h

#include <deal.II/base/point.h>

#include <memory>
#include <optional>
#include <vector>

#include "base/dimension.h"
#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  /// A moment [N mm per mm of thickness], or a turn [rad]: in 2-D about
  /// z.
  template<int dim>
  using Moment = Tensor<1, Dimension<dim>::n_rotations>;

  inline Moment<2> moment_of(const Tensor<1, 2> &arm, const Tensor<1, 2> &force)
  {
    return Moment<2>({arm[0] * force[1] - arm[1] * force[0]});
  }

  inline Moment<3> moment_of(const Tensor<1, 3> &arm, const Tensor<1, 3> &force)
  {
    return cross_product_3d(arm, force);
  }



  /// A motion that follows from a force, at a point of the master: the way per
  /// unit of it, and how far it was when this was found [mm, rad].
  template<int dim>
  struct MotionAt
  {
    Tensor<1, dim> way;
    double         paired = 0;
  };



  /**
   * A rigid master without a mesh (in the manner of step-42): it answers what a
   * point of the slave faces. It stands still, but for a MovingObstacle.
   */
  template<int dim>
  class Obstacle
  {
  public:
    virtual ~Obstacle() = default;

    /// A half plane by the numbers x, y, n_x, n_y, a point of it and its
    /// outward normal, or a circle by x, y and its radius, solid, with a
    /// negative radius the inside of a hole [mm]; in 3-D a half space and a
    /// sphere alike, and a cylinder by a point of its axis, the direction of
    /// the axis and its radius; in both a ProfileObstacle. Throws InputError if
    /// a shape is one of the other dimension.
    static std::unique_ptr<Obstacle<dim>>
    create(const Parameters::ObstacleShape shape,
           const std::vector<double>      &numbers);

    /// The closest point and what is known of the obstacle there.
    struct ClosestPoint
    {
      Point<dim>     x;      // [mm]
      Tensor<1, dim> normal; // outward
      double         radius; // [mm], negative in a hole; 0: flat

      // The way of the material there in this increment [mm], and in
      // 2-D the derivative of its tangential part along the surface [-].
      Tensor<1, dim> motion  = {};
      double         stretch = 0;

      std::vector<MotionAt<dim>> motions = {};
    };

    virtual ClosestPoint closest_point(const Point<dim> &x) const = 0;

    /// The point that it turns about, and its moments are about [mm].
    virtual Point<dim> centre() const = 0;

    /// An increment from a load factor to another moves it, and begins with
    /// these motions that follow from forces [mm, rad]. Returns whether it
    /// moves.
    virtual bool move(const double /*from*/,
                      const double /*to*/,
                      const std::vector<double> & /*free*/)
    {
      return false;
    }

    /// The increment has come to these motions. With @p keeps_place closest
    /// points and centre stay those of before.
    virtual void place(const std::vector<double> & /*free*/,
                       const bool /*keeps_place*/)
    {
    }

    /// The motion of this increment: of the centre [mm], and the rotation.
    struct Motion
    {
      Tensor<1, dim> shift;
      Moment<dim>    rotation;
    };

    virtual Motion motion() const
    {
      return {};
    }

    /// The way of the centre [mm] and the angle [degrees] since the beginning,
    /// of one that can move.
    struct Travel
    {
      Tensor<1, dim> shift;
      double         angle;
    };

    virtual std::optional<Travel> travel() const
    {
      return {};
    }

    /// The way by which its given motions have moved it since the beginning
    /// [mm], turns at the distance @p reach [mm].
    virtual double given_way(const double /*reach*/) const
    {
      return 0;
    }

    /// The place to which this increment carries a point that is at @p x at its
    /// start and does not move against the material.
    virtual Point<dim> carried(const Point<dim> &x) const
    {
      return x;
    }

    /// The way of the material at @p x since the beginning [mm].
    virtual Tensor<1, dim> way(const Point<dim> & /*x*/) const
    {
      return {};
    }
  };
} // namespace Contact

#endif
