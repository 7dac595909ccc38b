/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_line_contact_h
#define contact_tests_line_contact_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <cmath>

namespace Contact
{
  using namespace dealii;

  /**
   * The analytic solution of Hertz for a cylinder that is pressed on a half
   * plane or on another cylinder without friction, in plane strain and small
   * strain:
   *   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2,
   *   a    = sqrt(4 P R / (pi E*)),   p0 = 2 P/(pi a),
   *   p(x) = p0 sqrt(1 - (x/a)^2)   within the distance a of the axis,
   * K. L. Johnson, Contact Mechanics (1985), section 4.2 (c).
   */
  struct HertzLineContact
  {
    // R of the cylinder [mm]; of two cylinders 1/R = 1/R1 + 1/R2, the radius
    // of a hollow one negative.
    double radius;
    double force; // P of the full cylinder [N per mm of thickness]

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

    /**
     * Dundurs' constant [-]. A pressure p strains the surface below it by
     * -(1 + nu)(1 - 2 nu)/E p, and by reciprocity a shear traction bends the
     * surface in the same ratio. What counts is the difference of the bodies,
     *   beta = 1/2 E* ((1 + nu1)(1 - 2 nu1)/E1 - (1 + nu2)(1 - 2 nu2)/E2)
     *        = 1/2 ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)
     *              / ((1 - nu1)/G1 + (1 - nu2)/G2),
     * Johnson, equation (5.3): positive if body 1 is the softer one at equal
     * Poisson's ratios, opposite to the sign in J. Dundurs, J. Appl. Mech. 36
     * (1969). Where it is zero, as for equal bodies, shear tractions do not
     * change the pressure.
     */
    double dundurs() const
    {
      return contact_modulus() / 2 *
             ((1 + poisson_1) * (1 - 2 * poisson_1) / young_1 -
              (1 + poisson_2) * (1 - 2 * poisson_2) / young_2);
    }
  };



  /**
   * The analytic solution of Cattaneo (1938) and Mindlin (1949) for a Hertz
   * contact with Coulomb's friction mu: first the normal force P, then at
   * constant P a tangential force |Q| <= mu P. The middle of the contact
   * sticks, its borders slip:
   *   c    = a sqrt(1 - |Q|/(mu P)),
   *   q(x) = sign(Q) mu p0 (sqrt(1 - (x/a)^2) - c/a sqrt(1 - (x/c)^2)),
   * the second term within the distance c of the axis only. Johnson, section
   * 7.2 (a). It takes both bodies for half planes, and the pressure of Hertz
   * for unchanged by q: exact if HertzLineContact::dundurs() is zero.
   */
  struct CattaneoMindlin
  {
    HertzLineContact hertz;
    double           friction;         // mu [-]
    double           tangential_force; // Q [N per mm of thickness]

    /// c [mm].
    double stick_half_width() const
    {
      const double used = std::abs(tangential_force) / (friction * hertz.force);
      Assert(used <= 1, ExcMessage("The tangential force exceeds friction."));
      return hertz.half_width() * std::sqrt(1 - used);
    }

    /// The largest |q| [MPa], where sticking ends: mu p(c).
    double max_shear() const
    {
      return friction * hertz.pressure(stick_half_width());
    }

    /// q [MPa] at @p x [mm], positive in the direction of a positive Q.
    double shear(const double x) const
    {
      const double c     = stick_half_width();
      double       shear = friction * hertz.pressure(x);
      if (std::abs(x) < c)
        shear -= friction * hertz.max_pressure() / hertz.half_width() *
                 std::sqrt(c * c - x * x);
      return std::copysign(shear, tangential_force);
    }
  };
} // namespace Contact

#endif
