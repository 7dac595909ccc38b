/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The closed-form solutions against the equations that define them, which are
// integrated or differentiated here by other means than the formulas.

#include "verification/verification.h"

#include <deal.II/base/quadrature_lib.h>

#include "tests.h"

using namespace Tests;

namespace
{
  constexpr double pi = numbers::PI;

  /// Hooke's law in plane strain, solved for the strain.
  SymmetricTensor<2, 2> strain(const SymmetricTensor<2, 2> &stress,
                               const double                 youngs_modulus,
                               const double                 poisson)
  {
    return (1 + poisson) / youngs_modulus *
           (stress - poisson * trace(stress) * unit_symmetric_tensor<2>());
  }



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



  /// The derivative of a field in direction @p d, to the fourth order of h.
  template<typename Field>
  auto derivative(const Field       &field,
                  const Point<2>    &X,
                  const unsigned int d,
                  const double       h)
  {
    const Tensor<1, 2> step = h * Point<2>::unit_vector(d);
    return (8. * (field(X + step) - field(X - step)) -
            (field(X + 2. * step) - field(X - 2. * step))) /
           (12 * h);
  }



  Point<2> on_circle(const double r, const double theta)
  {
    return Point<2>(r * std::cos(theta), r * std::sin(theta));
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



  /// Whether the constructor refuses this.
  template<typename Make>
  bool throws(const Make &make)
  {
    try
      {
        make();
      }
    catch (const ExceptionBase &)
      {
        return true;
      }
    return false;
  }



  // Proves that both bodies obey Hooke's law and equilibrium, that the load and
  // the contact are as stated: then the solution is the only one.
  void check_cylinders(const std::string                   &name,
                       const double                         a,
                       const ConcentricCylinders::Material &inner,
                       const ConcentricCylinders::Material &outer)
  {
    headline(name);
    const double              b = 30, c = 50, p = 100, alpha = 20;
    const ConcentricCylinders solution(a, b, c, inner, outer, p, alpha);

    const std::array<double, 5> angles{{0.1, 0.9, 2.3, 4, 5.5}};
    const std::array<double, 3> radii{{a, b, c}};

    std::cout << std::fixed << std::setprecision(6)
              << "  pressure at 0, 45, 90 degrees:";
    for (const double theta : {0., pi / 4, pi / 2})
      std::cout << ' ' << solution.pressure(on_circle(b, theta));
    std::cout << " MPa\n  radial displacement at b and c, 0 and 90 degrees:";
    for (const double r : {b, c})
      for (const unsigned int d : {0, 1})
        std::cout << ' '
                  << solution.displacement(r * Point<2>::unit_vector(d),
                                           true)[d];
    std::cout << " mm" << std::defaultfloat << std::endl;

    // A little beyond the radii, too, where the solution continues.
    double hooke = 0, balance = 0, symmetry = 0;
    for (const bool is_outer : {false, true})
      {
        const auto &material = is_outer ? outer : inner;
        const auto  u        = [&](const Point<2> &X) {
          return solution.displacement(X, is_outer);
        };
        const auto stress = [&](const Point<2> &X) {
          return solution.stress(X, is_outer);
        };
        const double begin = radii[is_outer],
                     width = radii[is_outer + 1] - begin;
        const double h     = 2e-4 * b;
        for (const double part : {-0.05, 0., 0.4, 1., 1.05})
          {
            const double r = begin + part * width;
            for (const double theta : angles)
              {
                const Point<2> X = on_circle(r, theta);
                Tensor<2, 2>   gradient; // transposed
                Tensor<1, 2>   divergence;
                for (unsigned int d = 0; d < 2; ++d)
                  {
                    gradient[d] = derivative(u, X, d, h);
                    divergence +=
                      derivative(stress, X, d, h) * Point<2>::unit_vector(d);
                  }
                hooke   = std::max(hooke,
                                 material.youngs_modulus / p *
                                   (symmetrize(gradient) -
                                    strain(stress(X),
                                           material.youngs_modulus,
                                           material.poisson))
                                     .norm());
                balance = std::max(balance, b / p * divergence.norm());
              }
            // On the x axis the other component is 1, on the y axis it is 0.
            for (const unsigned int d : {0, 1})
              {
                const Point<2> X(r * Point<2>::unit_vector(d));
                symmetry = std::max({symmetry,
                                     std::abs(u(X)[1 - d]) / u(X).norm(),
                                     std::abs(stress(X)[0][1]) / p});
              }
          }
      }
    check_small("strain of u less that of the stress", hooke, 1e-9);
    check_small("divergence of the stress", balance, 1e-9);
    check_small("u_theta and shear on the axes", symmetry, 1e-13);

    double load = 0, hole = 0, traction = 0, gap = 0;
    for (const double theta : angles)
      {
        const Tensor<1, 2> n = on_circle(1, theta);
        const Point<2>     A(a * n), B(b * n), C(c * n);
        load = std::max(load,
                        (solution.stress(C, true) * n +
                         (p + alpha * std::cos(2 * theta)) * n)
                            .norm() /
                          p);
        hole = std::max(hole, (solution.stress(A, false) * n).norm() / p);
        gap  = std::max(gap,
                       std::abs((solution.displacement(B, true) -
                                 solution.displacement(B, false)) *
                                n) /
                         solution.displacement(B, true).norm());
        for (const bool is_outer : {false, true})
          traction = std::max(traction,
                              (solution.stress(B, is_outer) * n +
                               solution.pressure(B) * n)
                                  .norm() /
                                p);
      }
    check_small("traction on r = c less the load", load, 1e-12);
    if (a > 0)
      check_small("traction on r = a", hole, 1e-12);
    else
      check_small("displacement of the origin",
                  solution.displacement(Point<2>(), false).norm(),
                  1e-300);
    check_small("traction on r = b less the pressure, both sides",
                traction,
                1e-12);
    check_small("jump of the radial displacement at r = b", gap, 1e-12);

    // The bodies part first where the pressure is lowest.
    const double P0     = solution.pressure(on_circle(b, pi / 4));
    const double P2     = solution.pressure(on_circle(b, 0)) - P0;
    const auto   loaded = [&](const double times) {
      return [=]() {
        ConcentricCylinders(a, b, c, inner, outer, p, times * alpha * P0 / P2);
      };
    };
    check("a pressure above zero is accepted",
          !throws(loaded(0.999)) && !throws(loaded(-0.999)));
    check("parting bodies are refused",
          throws(loaded(1.001)) && throws(loaded(-1.001)));
  }



  // Proves the uniform part by what is known without a contact: bodies of the
  // same material under a uniform load are one.
  void check_lame()
  {
    headline("one material under uniform pressure");
    const ConcentricCylinders::Material steel{210000, 0.3};
    const Point<2>                      X(0.6 * 30, 0.8 * 30);
    std::cout
      << "  disk "
      << ConcentricCylinders(0, 30, 50, steel, steel, 100, 0).pressure(X)
      << " MPa\n  ring, by the formula of Lame "
      << ConcentricCylinders(10, 30, 50, steel, steel, 100, 0).pressure(X)
      << " = " << 100 * (1 - 1. / 9) / (1 - 1. / 25) << " MPa" << std::endl;

    // A hole so small that only its own neighborhood knows of it.
    const ConcentricCylinders pierced(1e-9, 30, 50, steel, steel, 100, 20);
    const ConcentricCylinders whole(0, 30, 50, steel, steel, 100, 20);
    check_small("a tiny hole changes the pressure",
                std::abs(pierced.pressure(X) / whole.pressure(X) - 1),
                1e-12);
    check("radii out of order are refused", throws([&]() {
            ConcentricCylinders(10, 50, 30, steel, steel, 100, 0);
          }));
  }
} // namespace



int main()
{
  check_approach();
  check_dundurs();
  for (const double force : {100., -360.})
    check_friction(force);
  check_cylinders("disk in a ring", 0, {70000, 0.33}, {210000, 0.25});
  check_cylinders("ring in a ring", 10, {210000, 0.25}, {3000, 0.4});
  check_lame();
}
