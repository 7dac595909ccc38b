/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A chain of equations, each with the unknowns of its neighbors and one that is
// free: the lines of the eliminated unknowns fulfil all equations to round-off,
// and are as long as their coefficients are above it, however long the chain.

#include "solvers/condensed/row_elimination.h"

#include <cmath>
#include <iostream>

using namespace Contact;

namespace
{
  const double coupling = 0.2;

  RowElimination::Row equation(const unsigned int i, const unsigned int n)
  {
    RowElimination::Row row;
    row.entries[i] = 1;
    if (i > 0)
      row.entries[i - 1] = -coupling;
    if (i + 1 < n)
      row.entries[i + 1] = -coupling;
    row.entries[n + i] = 0.5;
    row.constant       = 1. + i;
    return row;
  }



  void eliminate_chain(const unsigned int n)
  {
    std::set<RowElimination::Dof> usual;
    for (unsigned int i = 0; i < n; ++i)
      usual.insert(i);
    RowElimination rows(usual);
    for (unsigned int i = 0; i < n; ++i)
      {
        auto row = equation(i, n);
        rows.reduce(row);
        rows.eliminate(i, row);
      }

    double      error   = 0;
    std::size_t longest = 0;
    for (const auto &line : rows.lines())
      longest = std::max(longest, line.second.entries.size());
    for (unsigned int i = 0; i < n; ++i)
      {
        auto left = equation(i, n);
        rows.reduce(left);
        error =
          std::max({error, left.largest(), std::abs(left.constant) / (1. + i)});
      }

    // Coefficients decay by the root of c x^2 - x + c = 0 from one to the next.
    const double decay =
      (1 - std::sqrt(1 - 4 * coupling * coupling)) / (2 * coupling);
    const auto reach = std::log(1e-16) / std::log(decay);
    std::cout << n << " equations: error "
              << (error < 1e-14 ? "ok" : "too large") << ", longest line "
              << (longest < 2 * reach + 2 ? "ok" : "too long") << std::endl;
  }
} // namespace



int main()
{
  eliminate_chain(10);
  eliminate_chain(1000);
  return 0;
}
