/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/lemke.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/interruption.h"

namespace Contact
{
  namespace
  {
    // Below this share of the largest entry, an entry is what round-off left of
    // a zero: half of all digits, for the steps are many and a body on soft
    // springs costs digits. Too small a share is the danger: what should be
    // zero decides which way the path goes.
    const double relative_round_off = 1e-8;
  } // namespace



  // The covering vector d is one everywhere: any positive one will do, as long
  // as all rows have the same unit.
  Lemke::Lemke(const FullMatrix<double> &M, const Vector<double> &r)
    : n(r.size())
    , table(n, n + 1)
    , constant(r)
    , zero(relative_round_off * r.linfty_norm())
    , basic(n)
    , others(n + 1)
  {
    std::iota(basic.begin(), basic.end(), 0);
    std::iota(others.begin(), others.end(), n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          table(i, j) = M(i, j);
        table(i, n) = 1;
      }
  }



  unsigned int Lemke::complement(const unsigned int variable) const
  {
    return variable < n ? variable + n : variable - n;
  }



  bool Lemke::solve()
  {
    // Of equal ones the last: the first in the lexicographic order.
    unsigned int row = 0;
    for (unsigned int i = 1; i < n; ++i)
      if (constant[i] <= constant[row])
        row = i;
    if (n > 0 && constant[row] < 0)
      {
        const unsigned int artificial = 2 * n;
        unsigned int       column     = n;
        // The number of steps has no bound that is of use; in practice it is a
        // small multiple of the size.
        for (unsigned int step = 0; step < 50 * n; ++step)
          {
            stop_if_interrupted(MPI_COMM_SELF);
            const unsigned int left = basic[row];
            exchange(row, column);
            if (left == artificial)
              break;
            column = std::find(others.begin(), others.end(), complement(left)) -
                     others.begin();
            row = leaving_row(column);
            if (row == n)
              return false;
          }
        if (std::find(basic.begin(), basic.end(), artificial) != basic.end())
          return false;
      }
    collect();
    return true;
  }



  // Ratios that differ by round-off are equal; z_0 leaves as soon as it can.
  unsigned int Lemke::leaving_row(const unsigned int column) const
  {
    double largest = 0;
    for (unsigned int i = 0; i < n; ++i)
      largest = std::max(largest, std::abs(table(i, column)));

    unsigned int row = n;
    for (unsigned int i = 0; i < n; ++i)
      {
        if (table(i, column) >= -relative_round_off * largest)
          continue;
        if (row == n)
          {
            row = i;
            continue;
          }
        const double here  = -positive_part(i) / table(i, column);
        const double there = -positive_part(row) / table(row, column);
        const double equal = relative_round_off * std::max(here, there);
        if (here < there - equal ||
            (here <= there + equal &&
             (basic[i] == 2 * n ||
              (basic[row] != 2 * n && is_first(i, row, column)))))
          row = i;
      }
    return row;
  }



  // By the rows of the inverse of the basis: the columns of the w that are not
  // basic, with the opposite sign, and of those that are, unit vectors.
  bool Lemke::is_first(const unsigned int i,
                       const unsigned int j,
                       const unsigned int c) const
  {
    const auto entry = [&](const unsigned int row, const unsigned int k) {
      const auto   place = std::find(others.begin(), others.end(), k);
      const double value = place == others.end()
                             ? (basic[row] == k ? 1. : 0.)
                             : -table(row, place - others.begin());
      return -value / table(row, c);
    };
    for (unsigned int k = 0; k < n; ++k)
      {
        const double a = entry(i, k), b = entry(j, k);
        if (std::abs(a - b) >
            relative_round_off * std::max(std::abs(a), std::abs(b)))
          return a < b;
      }
    return false;
  }



  void Lemke::exchange(const unsigned int row, const unsigned int column)
  {
    const double pivot = table(row, column);
    for (unsigned int j = 0; j <= n; ++j)
      table(row, j) = j == column ? 1 / pivot : -table(row, j) / pivot;
    constant[row] /= -pivot;
    for (unsigned int i = 0; i < n; ++i)
      if (const double factor = table(i, column); i != row && factor != 0)
        {
          for (unsigned int j = 0; j <= n; ++j)
            table(i, j) =
              (j == column ? 0 : table(i, j)) + factor * table(row, j);
          constant[i] += factor * constant[row];
        }
    std::swap(basic[row], others[column]);
  }



  void Lemke::collect()
  {
    values_of_z.reinit(n);
    values_of_w.reinit(n);
    for (unsigned int i = 0; i < n; ++i)
      if (basic[i] < n)
        values_of_w[basic[i]] = std::max(0., constant[i]);
      else
        values_of_z[basic[i] - n] = std::max(0., constant[i]);
  }
} // namespace Contact
