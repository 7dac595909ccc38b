/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A row of springs from a wall, pushed at its end by a negative stiffness, is
// stable as long as that is smaller than the stiffness of the row; if a
// constraint keeps the last two nodes together, than that of the row without
// its last spring (closed forms). Of an unsymmetric matrix the symmetric part
// decides.

#include "solvers/direct/definiteness.h"

#include <iostream>

using namespace Contact;

namespace
{
  /// The matrix of n springs in a row from a wall, the last one with @p push at
  /// its end; with a row behind it that keeps the last two together, or none.
  SparseRows chain(const unsigned int n,
                   const double       stiffness,
                   const double       push,
                   const bool         is_held)
  {
    SparseRows rows(n + 1);
    for (unsigned int i = 0; i < n; ++i)
      {
        rows[i].emplace_back(i, stiffness);
        if (i > 0)
          {
            rows[i - 1].emplace_back(i - 1, stiffness);
            rows[i - 1].emplace_back(i, -stiffness);
            rows[i].emplace_back(i - 1, -stiffness);
          }
      }
    rows[n - 1].emplace_back(n - 1, -push);
    if (is_held)
      {
        rows[n].emplace_back(n - 2, -1e-3);
        rows[n].emplace_back(n - 1, 1e-3);
      }
    return rows;
  }



  void push_chain(const unsigned int n, const double stiffness, const bool held)
  {
    const double      critical = stiffness / (held ? n - 1 : n);
    std::vector<bool> is_constraint(n + 1);
    is_constraint[n] = true;
    std::cout << n << " springs of " << stiffness
              << (held ? ", the last one held:" : ":");
    for (const double part : {0., 0.99, 1.01, 10.})
      std::cout << ' '
                << (is_definite_under_constraints(
                      chain(n, stiffness, part * critical, held),
                      is_constraint)
                      ? "stable"
                      : "unstable");
    std::cout << std::endl;
  }



  void turn_and_shear()
  {
    const int    starts[]   = {0, 2, 4};
    const int    columns[]  = {0, 1, 0, 1};
    const double turning[]  = {1, 5, -5, 1};
    const double shearing[] = {1, 5, 0, 1};
    std::cout << "a turning: "
              << has_definite_symmetric_part(2, starts, columns, turning)
              << ", a shear: "
              << has_definite_symmetric_part(2, starts, columns, shearing)
              << std::endl;
  }
} // namespace



int main()
{
  for (const double stiffness : {1., 1e-6})
    for (const bool held : {false, true})
      for (const unsigned int n : {2u, 20u, 200u})
        push_chain(n, stiffness, held);
  turn_and_shear();
  return 0;
}
