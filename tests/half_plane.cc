/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The frictional contact of half planes against Hertz, the force balance,
// friction's law, closed forms of the stick contact pair and known stick
// contact pairs.

#include "closed_forms/half_plane.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <utility>
#include <vector>

using namespace Contact;

namespace
{
  const HertzLineContact benchmark{50, 100, 70000, 0.3, 210000, 0.3};
  const unsigned int     n_elements = 100;



  void check(const std::string &what, const double value, const double bound)
  {
    std::cout << "  " << what << " < " << bound << ": ";
    if (value < bound)
      std::cout << "ok" << std::endl;
    else
      std::cout << "FAILED, it is " << value << std::endl;
  }



  // Between the axis and 0.99 a: what is beyond is the last element's.
  template<typename Function>
  double largest(const HertzLineContact &hertz, const Function &function)
  {
    double result = 0;
    for (unsigned int k = 0; k < 990; ++k)
      result =
        std::max(result, std::abs(function(k * hertz.half_width() / 1000)));
    return result / hertz.max_pressure();
  }



  double force(const HalfPlaneContact &contact, const HertzLineContact &hertz)
  {
    // The trapezoidal rule in between and at all midpoints is exact for what is
    // linear between them.
    const double h      = hertz.half_width() / (2 * n_elements);
    double       result = contact.pressure(0) * h;
    for (unsigned int k = 1; k < 3 * n_elements; ++k)
      result += 2 * h * contact.pressure(k * h);
    return result;
  }



  void check_frictionless(const HertzLineContact &hertz, const double friction)
  {
    const HalfPlaneContact contact(hertz, friction, 2, n_elements);
    const double           a = hertz.half_width(), p0 = hertz.max_pressure();
    check("half width off Hertz", std::abs(contact.half_width() / a - 1), 5e-4);
    check("largest pressure off Hertz",
          std::abs(contact.max_pressure() / p0 - 1),
          1e-4);
    check("pressure off Hertz within 0.99 a",
          largest(hertz,
                  [&](const double x) {
                    return contact.pressure(x) - hertz.pressure(x);
                  }),
          0.02);
    check("shear", contact.max_shear() / p0, 1e-10);
    check("force off",
          std::abs(force(contact, hertz) / hertz.force - 1),
          1e-10);
    std::cout << "  stick: " << contact.stick_half_width() / a << " a"
              << std::endl;
  }



  // For small beta and friction p is that of Hertz whatever q is. The change
  // of q in the last increment is friction * dp beyond c; that it has no
  // singularity at c determines c, with elliptic integrals by
  //   beta [a E(c/a) - b E(c/b)] = friction [a F(c/a) - b F(c/b)],
  //   F(k) = K(k') - E(k'), k' = sqrt(1 - k^2),
  // b the half width at the start of the increment; and with many increments
  // by beta K(c/a) = friction K'(c/a) (Spence, J. Elasticity 5, 1975).
  double closed_form(const double ratio, const unsigned int n_increments)
  {
    const auto residual = [&](const double k) {
      const double complement = std::sqrt(1 - k * k);
      return ratio * std::comp_ellint_2(k) -
             (std::comp_ellint_1(complement) - std::comp_ellint_2(complement));
    };
    const double b   = std::sqrt(1 - 1. / n_increments);
    double       low = 1e-6, high = b > 0 ? b - 1e-6 : 1 - 1e-6;
    for (unsigned int k = 0; k < 50; ++k)
      {
        const double c       = (low + high) / 2;
        const double r       = residual(c) - (b > 0 ? b * residual(c / b) : 0);
        (r < 0 ? low : high) = c;
      }
    return low;
  }
} // namespace



int main()
{
  std::cout << std::setprecision(3);

  std::cout << "no friction" << std::endl;
  check_frictionless(benchmark, 0);
  std::cout << "equal bodies, friction" << std::endl;
  check_frictionless({50, 100, 70000, 0.3, 70000, 0.3}, 0.1);

  {
    std::cout << "friction 0.1 in 10 increments" << std::endl;
    const HalfPlaneContact contact(benchmark, 0.1, 10, n_elements);
    const double           c = contact.stick_half_width();
    const double           h = benchmark.half_width() / n_elements;
    check("force off",
          std::abs(force(contact, benchmark) / benchmark.force - 1),
          1e-10);
    check("excess of the shear over its bound",
          largest(benchmark,
                  [&](const double x) {
                    return std::max(0.,
                                    std::abs(contact.shear(x)) -
                                      0.1 * contact.pressure(x));
                  }),
          1e-10);
    check("shear off its bound beyond c",
          largest(benchmark,
                  [&](const double x) {
                    return x < c + h
                             ? 0.
                             : contact.shear(x) - 0.1 * contact.pressure(x);
                  }),
          1e-10);
    check("shear not odd",
          largest(benchmark,
                  [&](const double x) {
                    return contact.shear(x) + contact.shear(-x);
                  }),
          1e-10);

    // The cylinder as the stiffer body: x changes its sign.
    const HalfPlaneContact swapped({50, 100, 210000, 0.3, 70000, 0.3},
                                   0.1,
                                   10,
                                   n_elements);
    check("pressure off that of the swapped bodies",
          largest(benchmark,
                  [&](const double x) {
                    return contact.pressure(x) - swapped.pressure(x);
                  }),
          1e-10);
    check("shear off minus that of the swapped bodies",
          largest(benchmark,
                  [&](const double x) {
                    return contact.shear(x) + swapped.shear(x);
                  }),
          1e-10);
    std::cout << "  shear on the cylinder "
              << (contact.shear(c) > 0 ? "outwards" : "inwards") << std::endl;
  }

  // beta is 2/7 (E2 - E1)/(E2 + E1): 1/7 for the benchmark, 1/70 here.
  const HertzLineContact similar{50, 100, 95000, 0.3, 105000, 0.3};
  const double           ratio = 1 / 0.7;

  // From another half-plane solver, with a the half width of the contact.
  const std::vector<std::pair<unsigned int, double>> known{{1, 0.153},
                                                           {2, 0.333},
                                                           {4, 0.367},
                                                           {10, 0.387},
                                                           {50, 0.393}};
  for (const auto &[n_increments, stick] : known)
    {
      std::cout << n_increments << " increments" << std::endl;
      const HalfPlaneContact contact(benchmark, 0.1, n_increments, n_elements);
      check("c/a off " + std::to_string(stick).substr(0, 5),
            std::abs(contact.stick_half_width() / contact.half_width() - stick),
            0.005);

      const HalfPlaneContact weak(similar, 0.01, n_increments, n_elements);
      const double           closed = closed_form(ratio, n_increments);
      std::cout << "  weak coupling: c/a " << closed << " in closed form"
                << std::endl;
      check("c/a off that",
            std::abs(weak.stick_half_width() / weak.half_width() - closed),
            0.0005);
    }
  return 0;
}
