/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_concentric_cylinders_h
#define contact_tests_concentric_cylinders_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

namespace Contact
{
  using namespace dealii;

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
