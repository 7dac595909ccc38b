/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_obstacle_h
#define contact_obstacle_h

#include <deal.II/base/point.h>

#include <memory>
#include <vector>

#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A rigid master without a mesh, which stands still (in the manner of
   * step-42): it answers what a point of the slave faces.
   */
  template<int dim>
  class Obstacle
  {
  public:
    virtual ~Obstacle() = default;

    /// A half plane by the numbers x, y, n_x, n_y, a point of it and its
    /// outward normal, or a circle by x, y and its radius, solid, with a
    /// negative radius the inside of a hole [mm]; in space a half space and a
    /// sphere alike, and a cylinder by a point of its axis, the direction of
    /// the axis and its radius. Throws InputError if a shape is one of the
    /// other dimension.
    static std::unique_ptr<const Obstacle<dim>>
    create(const Parameters::ObstacleShape shape,
           const std::vector<double>      &numbers);

    /// The closest point and what is known of the obstacle there.
    struct ClosestPoint
    {
      Point<dim>     x;      // [mm]
      Tensor<1, dim> normal; // outward
      double         radius; // [mm], negative in a hole; 0: flat
    };

    virtual ClosestPoint closest_point(const Point<dim> &x) const = 0;
  };
} // namespace Contact

#endif
