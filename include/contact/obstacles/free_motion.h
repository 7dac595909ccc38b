/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_free_motion_h
#define contact_free_motion_h

#include <deal.II/base/point.h>

#include <functional>
#include <string>

namespace Contact
{
  using namespace dealii;

  /**
   * A motion of the master of a contact pair that follows from the force that
   * it takes: of an obstacle along an axis [mm] or about one [rad], or by how
   * much a bolt is shortened in a cut [mm]. It is an unknown a behind the
   * multipliers, which moves the master by v_a a at a point and so changes its
   * gap and its slip by
   *   -n . v_a a,   -t . v_a a.
   * Its equation is the principle of virtual work: with the force F_a that is
   * given and pressure and shear of the points,
   *   sum w v_a . (p n + q t) = F_a.
   * In a cut v is -n, and F the tension. While it stays the motion is known,
   * and there is no equation.
   */
  struct FreeMotion
  {
    std::string                             name;
    unsigned int                            contact_pair; // the number
    std::function<double(const Point<1> &)> force_at;     // by the load factor

    /// A motion about an axis, not along one.
    bool rotates = false;

    /// Increments that begin there or behind it do not move it.
    double end = 1;

    /// The largest way of the master per unit: 1, or of turns a length [mm].
    double lever = 1;

    // In this increment.
    double force = 0; // [N, of turns N mm; in 2-D per mm of thickness]
    bool   stays = false;
  };
} // namespace Contact

#endif
