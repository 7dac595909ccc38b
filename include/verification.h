/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_verification_h
#define contact_verification_h

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Contact
{
  using namespace dealii;

  /**
   * The analytic solution of Hertz for a cylinder that is pressed on a half
   * plane without friction, in plane strain and small strain:
   *   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2,
   *   a    = sqrt(4 P R / (pi E*)),   p0 = 2 P/(pi a),
   *   p(x) = p0 sqrt(1 - (x/a)^2)   within the distance a of the axis.
   */
  struct HertzLineContact
  {
    double radius; // R of the cylinder [mm]
    double force;  // P of the full cylinder [N per mm of thickness]

    // Young's moduli [MPa] and Poisson's ratios of both bodies.
    double young_1, poisson_1;
    double young_2, poisson_2;

    /// E* [MPa].
    double contact_modulus() const
    {
      return 1. / ((1 - poisson_1 * poisson_1) / young_1 +
                   (1 - poisson_2 * poisson_2) / young_2);
    }

    /// a [mm].
    double half_width() const
    {
      return std::sqrt(4 * force * radius / (numbers::PI * contact_modulus()));
    }

    /// p0 [MPa].
    double max_pressure() const
    {
      return std::sqrt(force * contact_modulus() / (numbers::PI * radius));
    }

    /// p [MPa] at the distance @p x [mm] from the axis, to either side.
    double pressure(const double x) const
    {
      const double ratio = x / half_width();
      return std::abs(ratio) < 1 ? max_pressure() * std::sqrt(1 - ratio * ratio)
                                 : 0.;
    }
  };
} // namespace Contact

#endif
