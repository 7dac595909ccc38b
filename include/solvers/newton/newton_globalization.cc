/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/newton_globalization.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  bool NewtonGlobalization::is_lost(const double residual,
                                    const double tolerance) const
  {
    return residual > best &&
           std::numeric_limits<double>::epsilon() * residual > tolerance;
  }



  bool NewtonGlobalization::advance(const double       residual,
                                    const unsigned int n_changes)
  {
    const bool is_same =
      n_changes == 0 && std::abs(residual - last) < residual / 50;
    n_still = is_same ? n_still + 1 : 0;
    all.push_back(residual);
    const bool is_smallest = residual < best;
    last                   = residual;
    best                   = std::min(best, residual);
    return is_smallest;
  }



  bool NewtonGlobalization::stands_still() const
  {
    return n_still >= max_still;
  }



  unsigned int NewtonGlobalization::circle() const
  {
    const unsigned int n_repeated = 20, longest = 20;
    const double       same = 1e-3;
    for (unsigned int k = 1; k <= longest && n_repeated + k <= all.size(); ++k)
      if (std::equal(all.end() - n_repeated,
                     all.end(),
                     all.end() - n_repeated - k,
                     [&](const double now, const double before) {
                       return std::abs(now - before) <= same * now;
                     }))
        return k;
    return 0;
  }



  void NewtonGlobalization::forget()
  {
    n_still = 0;
    all.clear();
    last = best = std::numeric_limits<double>::max();
  }



  bool NewtonGlobalization::one_at_a_time(const unsigned int n_changes)
  {
    if (n_changes == 0)
      return false;
    if (n_changes < fewest)
      {
        fewest   = n_changes;
        n_wasted = 0;
      }
    else
      ++n_wasted;
    return n_wasted > patience;
  }
} // namespace Contact
