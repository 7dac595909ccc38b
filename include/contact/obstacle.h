/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_obstacle_h
#define contact_obstacle_h

#include <deal.II/base/point.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * A rigid master without a mesh, which stands still (in the manner of
   * step-42): it answers what a point of the slave faces.
   */
  class Obstacle
  {
  public:
    virtual ~Obstacle() = default;

    /// The obstacle of an entry {"half plane": {x, y, n_x, n_y}}, a point of
    /// it and its outward normal, or {"circle": {x, y, radius}}, solid, with a
    /// negative radius the inside of a hole [mm].
    static std::unique_ptr<const Obstacle>
    create(const std::map<std::string, std::vector<double>> &description);

    /// The closest point and what is known of the obstacle there.
    struct Foot
    {
      Point<2>     x;      // [mm]
      Tensor<1, 2> normal; // outward
      double       radius; // [mm], negative in a hole; 0: flat
    };

    virtual Foot closest_point(const Point<2> &x) const = 0;
  };
} // namespace Contact

#endif
