/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of the mortar points of a slave that faces the master in part, or that
// has a node without multiplier: all weights are positive, however little of an
// edge faces the master, and sum up to the length that both surfaces share; a
// rigid shift is no gap; the tangential offset is zero also across a gap; and
// without the multiplier of a node, too, a uniform pressure gives every node of
// the master its integral.

#include "mortar_pairing.h"

using namespace Tests;

namespace
{
  // The worst of many pairings on one line. A point whose weight were negative
  // would count as not facing, and be missed in the length.
  struct Extremes
  {
    double length = 0, coefficients = 0, offset = 0;
    double smallest_weight = 1e9, largest_coefficient = 0;

    void add(const Pairing &pairing, const double shared)
    {
      length = std::max(length, std::abs(pairing.shared_length() - shared));
      coefficients =
        std::max(coefficients, pairing.largest(sum_of_coefficients));
      offset =
        std::max(offset, pairing.largest([&](const ContactPoint<2> &point) {
          return pairing.offset(point).norm();
        }));
      for (const ContactPoint<2> &point : pairing.points)
        if (point.facing)
          {
            // Relative to the shared length, of one edge at most.
            smallest_weight =
              std::min(smallest_weight, point.weight / std::min(shared, 1.));
            for (const double c : point.C)
              largest_coefficient = std::max(largest_coefficient, std::abs(c));
          }
    }

    void print() const
    {
      std::cout << "  weights down to " << two_digits(smallest_weight)
                << " of the shared length, coefficients up to "
                << two_digits(largest_coefficient) << std::endl;
      check("all weights are positive", smallest_weight > 0);
      check_small("sum of the coefficients", coefficients, 1e-11);
      check_small("gap", offset, 1e-11);
      check_small("weights and length", length, 1e-12);
    }
  };



  const Line places{0.001,
                    0.01,
                    0.1,
                    0.2,
                    0.3,
                    0.4,
                    0.499,
                    0.5,
                    0.501,
                    0.6,
                    0.7,
                    0.8,
                    0.9,
                    0.99,
                    0.999};



  void partial(const unsigned int degree)
  {
    const std::string name = ", degree " + std::to_string(degree);
    const Line        slave{0, 1, 2, 3};
    headline("the master ends within an edge" + name);
    Extremes ends;
    for (const double s : places)
      {
        ends.add(Pairing(make_strips(degree, slave, {-1, 0.8, 1 + s}), stay),
                 1 + s);
        ends.add(Pairing(make_strips(degree, slave, {1 + s, 2.1, 4}), stay),
                 2 - s);
      }
    ends.print();

    headline("the master begins with the slave and ends within its first edge" +
             name);
    Extremes first;
    for (const double s : places)
      {
        first.add(Pairing(make_strips(degree, slave, {-1, s}), stay), s);
        first.add(Pairing(make_strips(degree, {0, 1}, {-1, s}), stay), s);
        first.add(Pairing(make_strips(degree, {0, 1}, {s, 2}), stay), 1 - s);
      }
    first.print();

    headline("the master lies within one edge" + name);
    Extremes within;
    for (const double s : places)
      within.add(
        Pairing(make_strips(degree, slave, {1 + 0.9 * s, 1.09 + 0.9 * s}),
                stay),
        0.09);
    within.print();
  }


  // Bodies apart, where the overlap is seen along curving normals.
  void partial_bent(const unsigned int degree)
  {
    headline("bent, one faces a part of the other, degree " +
             std::to_string(degree));
    bool   beyond = true, in_part = true;
    double coefficients = 0, offset = 0;
    for (const double s : places)
      for (const Line &master : {Line{-1, 0.8, 1 + s}, Line{1 + s, 2.1, 4}})
        {
          const Pairing pairing(make_strips(degree, {0, 1, 2, 3}, master, 0.1),
                                bend);
          const double  shared = pairing.shared_length();
          in_part              = in_part && shared > 0.5 && shared < 2.5;
          for (const ContactPoint<2> &point : pairing.points)
            if (!point.facing)
              beyond = beyond && (master[0] < 0 ? point.X(0)[0] > 1 + s - 0.1
                                                : point.X(0)[0] < 1 + s + 0.1);
          coefficients =
            std::max(coefficients, pairing.largest(sum_of_coefficients));
          offset =
            std::max(offset, pairing.largest([&](const ContactPoint<2> &point) {
              return std::abs(point.tangents[0] * pairing.offset(point));
            }));
        }
    check("the surfaces overlap in part", in_part);
    check("nodes without weight are beyond the end", beyond);
    check_small("sum of the coefficients", coefficients, 1e-11);
    check_small("tangential offset", offset, 1e-11);
  }



  // One node after the other carries no multiplier.
  void without_a_node(const unsigned int degree)
  {
    headline("a slave node without multiplier, degree " +
             std::to_string(degree));
    Extremes extremes;
    double   error = 0;
    for (const Line &slave : {Line{0, 3}, Line{0, 1, 1.7, 3}})
      {
        const auto strips = make_strips(degree, slave, {0, 0.5, 1.4, 2, 3});
        for (unsigned int i = 0; i < degree * (slave.size() - 1) + 1; ++i)
          {
            const Pairing pairing(strips, stay, {i});
            extremes.add(pairing, 3);
            error = std::max(error, error_of_loads(pairing));
          }
      }
    extremes.print();
    check_small("loads on the master under uniform pressure", error, 1e-10);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      partial(degree);
      partial_bent(degree);
      without_a_node(degree);
    }
  return 0;
}
