/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A uniform pressure through the interface of two blocks. Proves that the nodal
// and the Gauss-point discretization transmit it exactly where the nodes of the
// surfaces match, and states what is known to happen where they do not: the
// nodal discretization puts the force of a slave node on the master nodes
// beside it, which is not how a uniform pressure is distributed, and fails; the
// Gauss-point discretization misses the uniform pressure by the error of its
// quadrature over the kinks of the master's shape functions, which only many
// points make small.

#include "patch_test.h"

using namespace Tests;

namespace
{
  std::string named(const unsigned int degree, const double poisson)
  {
    return "degree " + std::to_string(degree) +
           (poisson == 0 ? ", no lateral strain" : "");
  }



  void matching(const std::string &rule, const unsigned int n_points)
  {
    for (const unsigned int degree : {1, 2})
      for (const double poisson : {0., 0.3})
        {
          const Result result =
            press(make_case({degree, poisson, rule, n_points}), poisson);
          const std::string name = named(degree, poisson);
          check(name + ", converged, all in contact",
                result.converged && result.all_in_contact);
          check_small(name + ", stress", result.deviation, 1e-9);
          check_small(name + ", pressure", result.deviation_of_pressure, 1e-9);
        }
  }



  // Known failures are printed with two digits, as parts of the pressure.
  void not_matching(const std::string &rule, const unsigned int n_points)
  {
    for (const unsigned int degree : {1, 2})
      {
        const Result result =
          press(make_case({degree, 0.3, rule, n_points, 4}), 0.3);
        if (rule == "nodal")
          check(named(degree, 0.3) + ", deviation of the stress > 1e-3",
                result.deviation > 1e-3);
        std::cout << "  " << named(degree, 0.3) << ", "
                  << (result.converged ? "converged" : "not converged") << ", "
                  << (result.all_in_contact ? "all" : "not all")
                  << " in contact, deviation of the stress "
                  << two_digits(result.deviation) << ", of the pressure "
                  << two_digits(result.deviation_of_pressure) << std::endl;
      }
  }
} // namespace



int main()
{
  headline("matching nodes, nodal rule: passed");
  matching("nodal", 0);
  headline("matching nodes, Gauss rule of 3 points: passed");
  matching("Gauss", 3);
  headline("other nodes, nodal rule: failed");
  not_matching("nodal", 0);
  for (const unsigned int n_points : {2, 3, 6, 10})
    {
      headline("other nodes, Gauss rule of " + std::to_string(n_points) +
               " points: inexact");
      not_matching("Gauss", n_points);
    }
  return 0;
}
