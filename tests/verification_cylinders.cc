/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the closed form of concentric cylinders obeys the equations that
// define it, with derivatives by differences: Hooke's law, equilibrium, the
// load and the conditions of contact; and that cylinders of one material are
// Lame's.

#include "closed_forms/concentric_cylinders.h"
#include "plane_strain.h"

using namespace Tests;

namespace
{
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
  check_cylinders("disk in a ring", 0, {70000, 0.33}, {210000, 0.25});
  check_cylinders("ring in a ring", 10, {210000, 0.25}, {3000, 0.4});
  check_lame();
  return 0;
}
