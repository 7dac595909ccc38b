/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_verification_h
#define contact_verification_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <cmath>
#include <vector>

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



  /**
   * Two concentric bodies about the origin in plane strain and small strain:
   * the inner one in a <= r <= b, a disk if a = 0, the outer one in b <= r <=
   * c. They touch without friction and without a gap at r = b; r = a is free,
   * and on r = c acts the normal pressure p + alpha cos(2 theta).
   *
   * For either body Airy's function is
   *   A0 r^2 + B0 ln r + (A r^2 + B r^4 + C r^-2 + D) cos(2 theta);
   * stresses and displacements of the six terms are those of Michell's
   * solution, J. R. Barber, Elasticity (2010), tables 8.1 and 9.1, with
   * kappa = 3 - 4 nu, and without rigid motion. A disk has no terms that are
   * singular in the origin. The amplitudes follow from the normal and shear
   * tractions on the circles of the body, the contact pressure
   *   P(theta) = P0 + P2 cos(2 theta)
   * from the radial displacements, which agree at r = b.
   *
   * Displacement and stress can be asked for a little outside of the body,
   * too, as on the edges of a mesh, where they continue analytically.
   */
  class ConcentricCylinders
  {
  public:
    struct Material
    {
      double youngs_modulus; // E [MPa]
      double poisson;        // nu [-]
    };

    /**
     * The radii a, b and c [mm], the load @p p and @p alpha [MPa]. Throws if P
     * would be negative somewhere: the bodies would part.
     */
    ConcentricCylinders(const double    a,
                        const double    b,
                        const double    c,
                        const Material &inner_material,
                        const Material &outer_material,
                        const double    p,
                        const double    alpha);

    /// P [MPa] in the direction of @p X, positive in compression.
    double pressure(const Point<2> &X) const;

    /// u [mm] at @p X [mm], of the outer or of the inner body.
    Tensor<1, 2> displacement(const Point<2> &X, const bool outer) const;

    /// The stress [MPa] in 2-D at @p X [mm], tension positive.
    SymmetricTensor<2, 2> stress(const Point<2> &X, const bool outer) const;

  private:
    /// The amplitudes of 1 and of cos(2 theta).
    using Harmonics = std::array<double, 2>;

    /// One body under pressures on its circles.
    class Ring
    {
    public:
      Ring(const double    inner_radius,
           const double    outer_radius,
           const Material &material);

      /// Pressures [MPa]; the inner one is nothing to a disk.
      void load(const Harmonics &inner_pressure,
                const Harmonics &outer_pressure);

      /// u_r [mm].
      Harmonics radial_displacement(const double r) const;

      Tensor<1, 2>          displacement(const Point<2> &X) const;
      SymmetricTensor<2, 2> stress(const Point<2> &X) const;

    private:
      /**
       * One term of Airy's function. With s = r / radius the stress is
       * amplitude s^power times the factors given here, the displacement
       * amplitude radius s^(power+1) / (2 G) times those; times cos(2 theta),
       * or sin(2 theta) for the components rt and t, if the harmonic is 1.
       */
      struct Term
      {
        unsigned int harmonic;
        int          power;
        double       stress_rr, stress_rt, stress_tt;
        double       u_r, u_t;
        double       radius    = 0;
        double       amplitude = 0;

        double stress_scale(const double r) const;
        double displacement_scale(const double r) const; // without 1/(2 G)
      };

      double            inner_radius, outer_radius;
      double            shear_modulus; // G [MPa]
      std::vector<Term> terms;
    };

    Ring      inner, outer;
    Harmonics contact_pressure; // P0, P2
  };
} // namespace Contact

#endif
