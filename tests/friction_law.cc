/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the bound of the shear traction is the one of Tresca, of Coulomb,
// or zero, and that its derivative is that of the bound.

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

} // namespace



int main()
{
  print_law("frictionless", FrictionLaw{});
  print_law("Tresca", FrictionLaw{4., 0.});
  print_law("Coulomb", FrictionLaw{0., 0.25});
  return 0;
}
