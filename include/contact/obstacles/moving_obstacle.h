/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_moving_obstacle_h
#define contact_moving_obstacle_h

#include <array>
#include <functional>

#include "contact/obstacles/obstacle.h"
#include "parameters/parameters_scene.h"

namespace Contact
{
  using namespace dealii;

  /**
   * An obstacle that moves as a rigid body: with the centre c, histories d(t)
   * and alpha(t), and R the rotation by alpha about the axis, its material
   * point X is at
   *   x(X, t) = c + d + R (X - c).
   * The point of the material that is at x at the end of an increment has moved
   * by x - x_start there, a chord, so that what sticks to it has no slip
   * however far it turns, and along the surface of a plane, where the obstacle
   * turns by the angle beta in the increment, that changes with the slope 1 -
   * cos beta. Components of d and alpha that are free are unknowns.
   */
  template<int dim>
  class MovingObstacle : public Obstacle<dim>
  {
  public:
    MovingObstacle(std::unique_ptr<const Obstacle<dim>> shape,
                   const Parameters::Contact           &parameters);

    typename Obstacle<dim>::ClosestPoint
               closest_point(const Point<dim> &x) const override;
    Point<dim> carried(const Point<dim> &x) const override;

    Point<dim> centre() const override
    {
      return end.at(pivot);
    }

    bool move(const double               from,
              const double               to,
              const std::vector<double> &free) override;

    void place(const std::vector<double> &free,
               const bool                 keeps_place) override;

    typename Obstacle<dim>::Motion motion() const override;

    std::optional<typename Obstacle<dim>::Travel> travel() const override;

    double given_way(const double reach) const override;

    Tensor<1, dim> way(const Point<dim> &x) const override
    {
      return x - first.at(end.back(x));
    }

  private:
    struct Placement
    {
      Point<dim>     centre;
      Tensor<1, dim> shift;
      double         angle = 0; // [rad]
      Tensor<2, dim> rotation;

      Point<dim> at(const Point<dim> &X) const
      {
        return centre + shift + rotation * (X - centre);
      }

      Point<dim> back(const Point<dim> &x) const
      {
        return centre + transpose(rotation) * (x - centre - shift);
      }
    };

    Placement placement(const double               load_factor,
                        const std::vector<double> &free) const;

    using History = std::function<double(const Point<1> &)>;

    const std::unique_ptr<const Obstacle<dim>> shape;
    const bool                                 moves;
    Point<dim>                                 pivot;
    Tensor<1, 3>                               axis;
    std::array<History, dim>                   shifts; // empty: none
    History                                    angle;
    std::vector<unsigned int>                  components; // free; dim: angle
    double                                     load_factor = 0;
    std::vector<double>                        placed; // free motions of end
    Placement                                  first, start, end, reached;
  };
} // namespace Contact

#endif
