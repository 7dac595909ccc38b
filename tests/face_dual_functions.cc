/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The dual functions of a facet that faces the master in the quarter around one
// of its nodes: their sum is one, their integrals are those of the test
// functions and positive, none is larger than the facet allows; where the node
// has a multiplier of its own, where it hangs between two nodes of which one is
// beyond the facet, and where both are: then both test functions are the same.
// The same over a small part in the middle of the facet, which leaves one
// function, and over a strip across its middle, which leaves one at either end.

#include "contact/mortar/face_dual_functions.h"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <iostream>

using namespace Contact;

namespace
{
  /// The part that faces the master, in the coordinates of the facet.
  struct Part
  {
    Point<2> from, to;
  };

  std::vector<FacetSample> samples_of(const Part &part)
  {
    std::vector<FacetSample> samples;
    const QGauss<2>          rule(3);
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        FacetSample sample;
        for (unsigned int i = 0; i < 2; ++i)
          sample.slave_xi[i] =
            part.from[i] + (part.to[i] - part.from[i]) * rule.point(q)[i];

        sample.slave_values = facet_kind<3>(4, 1).values(sample.slave_xi);
        sample.weight       = rule.weight(q);
        for (unsigned int i = 0; i < 2; ++i)
          sample.weight *= (part.to[i] - part.from[i]) / 2;
        samples.push_back(sample);
      }
    return samples;
  }



  void check(const std::string                   &name,
             const Part                          &part,
             const std::vector<Surface<3>::Part> &last)
  {
    FacetDualFunctions::Carriers carries;
    for (unsigned int a = 0; a < 3; ++a)
      carries[a] = {{a, 1.}};
    carries[3]                       = last;
    const auto               samples = samples_of(part);
    const FacetDualFunctions dual(facet_kind<3>(4, 1),
                                  samples,
                                  {.25, .25, .25, .25},
                                  carries);

    const unsigned int n = dual.nodes().size();
    Vector<double>     integrals(n), of_tests(n);
    double             sum_error = 0, largest = 0;
    for (const FacetSample &sample : samples)
      {
        const auto phi = dual.values(sample), M = dual.test_functions(sample);
        double     sum = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            sum += phi[k];
            largest = std::max(largest, std::abs(phi[k]));
            integrals[k] += sample.weight * phi[k];
            of_tests[k] += sample.weight * M[k];
          }
        sum_error = std::max(sum_error, std::abs(sum - 1));
      }
    double error = 0, area = 0, smallest = 1, whole = 0;
    for (const FacetSample &sample : samples)
      whole += sample.weight;
    for (unsigned int k = 0; k < n; ++k)
      {
        error    = std::max({error,
                             std::abs(integrals[k] - dual.integrals()[k]),
                             std::abs(of_tests[k] - dual.integrals()[k])});
        smallest = std::min(smallest, dual.integrals()[k]);
        area += integrals[k];
      }
    const bool ok = sum_error < 1e-13 && error < 1e-14 && smallest > 0 &&
                    std::abs(area - whole) < 1e-14 && largest < 10;
    std::cout << name << ": " << n << " functions, " << (ok ? "ok" : "FAILED")
              << std::endl;
  }
} // namespace



int main()
{
  const Part corner{{0.2, 0.2}, {1, 1}};
  check("a multiplier of its own", corner, {{3, 1.}});
  check("hanging, one receiver is on the facet", corner, {{1, .5}, {7, .5}});
  check("hanging, both receivers are beyond the facet",
        corner,
        {{7, .5}, {9, .5}});
  check("hanging, unequal parts", corner, {{7, .75}, {9, .25}});
  check("a part in the middle", {{-0.1, -0.1}, {0.2, 0.1}}, {{3, 1.}});
  check("a strip across the middle", {{-1, -0.1}, {1, 0.2}}, {{3, 1.}});
  return 0;
}
