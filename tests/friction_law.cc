/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the bound of the shear traction is the one of Tresca, of Coulomb,
// or zero, that its derivative is that of the bound, and that the projection
// gives the nearest admissible traction.

#include "tests.h"

using namespace Tests;

namespace
{
  void print_law(const std::string &name, const FrictionLaw &law)
  {
    headline(name);
    std::cout << "  " << (law.is_frictionless() ? "without" : "with")
              << " friction" << std::endl;
    for (const double p : {-5., 0., 2., 100.})
      std::cout << "  p = " << p << ": bound " << law.bound(p)
                << ", derivative " << law.bound_derivative(p) << std::endl;

    // At p = 0 the derivative is the one from the side of contact.
    const double h     = 1e-3;
    double       error = 0;
    for (const double p : {-5., -0.1, 0., 0.1, 2., 100.})
      error = std::max(error,
                       std::abs((law.bound(p + h) - law.bound(p)) / h -
                                law.bound_derivative(p)));
    check_small("derivative against difference quotient", error, 1e-10);
  }



  void check_projection()
  {
    headline("projection");
    for (const double q : {-7., -3., -1., 0., 2., 3., 8.})
      std::cout << "  " << q << " -> " << friction_projection(q, 3)
                << std::endl;

    double again = 0, outside = 0, further = 0, odd = 0;
    Random random;
    for (unsigned int k = 0; k < 1000; ++k)
      {
        const double bound = random(0, 2), q = random(-5, 5);
        const double inside = friction_projection(q, bound);
        again               = std::max(again,
                         std::abs(friction_projection(inside, bound) - inside));
        outside             = std::max(outside, std::abs(inside) - bound);
        odd = std::max(odd, std::abs(friction_projection(-q, bound) + inside));

        const double other = random(-bound, bound);
        further = std::max(further, std::abs(q - inside) - std::abs(q - other));
      }
    check("applied twice changes nothing", again == 0);
    check("the result is admissible", outside <= 0);
    check("no admissible traction is nearer", further <= 0);
    check("both directions alike", odd == 0);
    check("without a bound nothing is left", friction_projection(4, 0) == 0);
  }
} // namespace



int main()
{
  print_law("frictionless", FrictionLaw{});
  print_law("Tresca", FrictionLaw{4., 0.});
  print_law("Coulomb", FrictionLaw{0., 0.25});
  check_projection();
}
