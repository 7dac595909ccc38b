/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the closed forms of line contact obey the equations that define
// them, which are integrated here by other means than the formulas: the
// approach of a disk, Dundurs' constant, and the shear of Cattaneo and Mindlin.
// The concentric cylinders: verification_cylinders.cc.

#include <deal.II/base/quadrature_lib.h>

#include "closed_forms/line_contact.h"
#include "plane_strain.h"

using namespace Tests;

namespace
{
  /// The integral of @p f. With x = m + h sin(phi) a root at either end is
  /// smooth.
  template<typename Function>
  auto integral(const Function &f, const double begin, const double end)
  {
    static const QGauss<1> quadrature(100);
    const double           m = (begin + end) / 2, h = (end - begin) / 2;

    decltype(f(m)) sum{};
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double phi = pi * (quadrature.point(q)[0] - 0.5);
        sum += pi * quadrature.weight(q) * h * std::cos(phi) *
               f(m + h * std::sin(phi));
      }
    return sum;
  }



  /**
   * The stress of a disk at the distance X[0] from the axis and the depth X[1]
   * below the contact: of lines of force, -2 F cos(phi)/(pi r) e_r e_r, under
   * the pressure of Hertz and opposite to it, and of a uniform tension.
   */
  SymmetricTensor<2, 2> disk_stress(const HertzLineContact &hertz,
                                    const double            disk_radius,
                                    const Point<2>         &X)
  {
    const Tensor<1, 2> far = Point<2>(0, 2 * disk_radius) - X;

    const double P = hertz.force, a = hertz.half_width();
    Tensor<2, 2> stress;
    stress[0][0] = stress[1][1] = P / (pi * disk_radius);
    stress -= 2 * P / pi * far[1] / Utilities::fixed_power<4>(far.norm()) *
              outer_product(far, far);

    // By the angle under which the contact is seen it is smooth near to it.
    stress -= 2 / pi *
              integral(
                [&](const double angle) {
                  const Tensor<1, 2> e =
                    Point<2>(-std::sin(angle), std::cos(angle));
                  return hertz.pressure(X[0] + X[1] * std::tan(angle)) *
                         outer_product(e, e);
                },
                std::atan((-a - X[0]) / X[1]),
                std::atan((a - X[0]) / X[1]));
    return symmetrize(stress);
  }



  /// The approach of the center by the strain on the axis of the disk.
  double integrated_approach(const HertzLineContact &hertz,
                             const double            disk_radius)
  {
    // With z = a sinh(t) the points gather where the strain changes.
    const double a = hertz.half_width();
    return -integral(
      [&](const double t) {
        const auto stress =
          disk_stress(hertz, disk_radius, Point<2>(0, a * std::sinh(t)));
        return a * std::cosh(t) *
               strain(stress, hertz.young_1, hertz.poisson_1)[1][1];
      },
      0,
      std::asinh(disk_radius / a));
  }



  /// The largest traction on the circle of the disk away from the contact and
  /// from its opposite, by the uniform tension.
  double traction_on_circle(const HertzLineContact &hertz,
                            const double            disk_radius)
  {
    double largest = 0;
    for (const double theta : {-0.9, -0.3, 0., 0.6})
      {
        const Tensor<1, 2> n = on_circle(1, theta);
        const Point<2>     X = Point<2>(0, disk_radius) + disk_radius * n;
        largest =
          std::max(largest, (disk_stress(hertz, disk_radius, X) * n).norm());
      }
    return largest / (hertz.force / (pi * disk_radius));
  }



  // The way [mm] of the center of body 1, a full cylinder of the radius R1
  // [mm], approaches the center of the contact,
  //   delta = P (1 - nu1^2)/(pi E1) (2 ln(4 R1/a) - 1),
  // Johnson, equation (5.56). It is the strain on the axis between the two
  // under the Hertz pressure, the opposite force -P on a line at the far end of
  // the diameter, and the tension P/(pi R1) in all directions that frees the
  // rest of the circle, up to terms of the order (a/R1)^2. A force that acts
  // elsewhere gives another approach. A half plane has none: there the
  // displacement grows with the logarithm of the distance.
  double approach_of_centre(const HertzLineContact &hertz, const double R1)
  {
    return hertz.force * (1 - hertz.poisson_1 * hertz.poisson_1) /
           (pi * hertz.young_1) *
           (2 * std::log(4 * R1 / hertz.half_width()) - 1);
  }



  // Proves that the approach is the integral of the strain in a disk, and the
  // stress one that leaves the circle free, both up to terms of the order
  // (a/R1)^2: with a force four times smaller they are, by the force, four
  // times smaller.
  void check_approach()
  {
    headline("approach of the center");
    const double R1 = 50, R2 = 200;

    HertzLineContact hertz{1 / (1 / R1 + 1 / R2),
                           2000,
                           70000,
                           0.3,
                           210000,
                           0.2};
    std::cout << std::fixed << std::setprecision(6) << "  a "
              << hertz.half_width() << " mm" << std::endl
              << "  approach " << approach_of_centre(hertz, R1) << " mm"
              << std::defaultfloat << std::endl;

    double                difference = 0;
    std::array<double, 3> error, traction; // by the force
    for (unsigned int k = 0; k < 3; ++k)
      {
        const double approach = approach_of_centre(hertz, R1);
        difference            = integrated_approach(hertz, R1) - approach;
        error[k]              = difference / hertz.force;
        traction[k]           = traction_on_circle(hertz, R1);
        difference /= approach;
        hertz.force /= 4;
      }
    check_small("differs from the integral", std::abs(difference), 1e-5);
    for (unsigned int k = 0; k < 2; ++k)
      std::cout << "  the error falls by "
                << two_digits(error[k] / error[k + 1])
                << ", the traction on the circle by "
                << two_digits(traction[k] / traction[k + 1]) << std::endl;
  }



  // Proves that Dundurs' constant compares the strains under a pressure, and
  // its value and sign by the equal formula with shear moduli, by known limits
  // and by what is known about the exchange of the bodies.
  void check_dundurs()
  {
    headline("Dundurs' constant");
    const auto beta = [](const double young_1,
                         const double poisson_1,
                         const double young_2,
                         const double poisson_2) {
      return HertzLineContact{1, 1, young_1, poisson_1, young_2, poisson_2}
        .dundurs();
    };
    std::cout << "  aluminium on steel " << beta(70000, 0.3, 210000, 0.3)
              << std::endl;

    const double G1 = 70000 / 2.66, G2 = 210000 / 2.5;
    const double value = beta(70000, 0.33, 210000, 0.25);
    check_small("differs from the formula with shear moduli",
                std::abs(value - 0.5 * (0.34 / G1 - 0.5 / G2) /
                                   (0.67 / G1 + 0.75 / G2)),
                1e-15);

    const auto             hydrostatic = -unit_symmetric_tensor<2>();
    const HertzLineContact contact{1, 1, 70000, 0.33, 210000, 0.25};
    check_small("differs from the strains under a pressure",
                std::abs(value + contact.contact_modulus() / 2 *
                                   (strain(hydrostatic, 70000, 0.33)[0][0] -
                                    strain(hydrostatic, 210000, 0.25)[0][0])),
                1e-15);

    check("zero for equal bodies", beta(1000, 0.2, 1000, 0.2) == 0);
    check("zero for incompressible ones", beta(1000, 0.5, 2000, 0.5) == 0);
    check("1/2 for a body without lateral strain on a rigid one",
          std::abs(beta(1, 0, 1e20, 0) - 0.5) < 1e-15);
    check("changes its sign with the exchange",
          std::abs(value + beta(210000, 0.25, 70000, 0.33)) < 1e-15);
  }



  // Proves that the shear carries the force, stays below friction and reaches
  // it in the zone of slip alone, and that the bodies do not move against each
  // other where they stick: the strain of a half plane is proportional to the
  // principal value of the integral of q(s)/(x - s).
  void check_friction(const double tangential_force)
  {
    const HertzLineContact hertz{50, 2000, 70000, 0.3, 70000, 0.3};
    const CattaneoMindlin  contact{hertz, 0.2, tangential_force};
    const double           a = hertz.half_width();
    const double           c = contact.stick_half_width();

    std::ostringstream text;
    text << std::fixed << std::setprecision(6) << "tangential force "
         << tangential_force << "\n  c " << c << " mm, max q "
         << contact.max_shear() << " MPa\n  q at 0, 0.6 a, 0.9 a:";
    for (const double x : {0., 0.6 * a, 0.9 * a})
      text << ' ' << contact.shear(x);
    headline(text.str() + " MPa");

    // Piece by piece: q has corners at c.
    const auto over_contact = [&](const std::function<double(double)> &f) {
      return integral(f, -a, -c) + integral(f, -c, c) + integral(f, c, a);
    };
    const double force =
      over_contact([&](const double x) { return contact.shear(x); });
    check_small("integral differs from the force",
                std::abs(force - tangential_force) / (0.2 * hertz.force),
                1e-12);

    const unsigned int n      = 1000;
    double             excess = 0, slip = 0, largest = 0;
    bool               sticks = true;
    for (unsigned int k = 0; k <= n; ++k)
      {
        const double x = a * (-1.1 + 2.2 * k / n), q = contact.shear(x);
        const double bound = 0.2 * hertz.pressure(x);
        excess             = std::max(excess, std::abs(q) - bound);
        largest            = std::max(largest, std::abs(q));
        if (std::abs(x) >= c)
          slip = std::max(slip, std::abs(std::abs(q) - bound));
        else
          sticks = sticks && std::abs(q) < bound;
      }
    check_small("excess of friction", excess, 1e-12);
    check_small("differs from friction in the zone of slip", slip, 1e-12);
    check("less than friction where it sticks", sticks);
    check("max q is the largest of a thousand",
          largest <= contact.max_shear() &&
            largest > 0.98 * contact.max_shear());

    const auto strain = [&](const double x) {
      const double q = contact.shear(x);
      return over_contact([&](const double s) {
               return (contact.shear(s) - q) / (x - s);
             }) +
             q * std::log((a + x) / (a - x));
    };
    double relative_strain = 0;
    for (const double x : {-0.71, -0.3, 0.11, 0.5})
      relative_strain =
        std::max(relative_strain, std::abs(strain(x * c)) / largest);
    check_small("relative strain where it sticks", relative_strain, 1e-9);
    check("relative strain beyond",
          std::abs(strain(c + 0.4 * (a - c))) > 0.1 * largest);
  }
} // namespace



int main()
{
  check_approach();
  check_dundurs();
  for (const double force : {100., -360.})
    check_friction(force);
  return 0;
}
