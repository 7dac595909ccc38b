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
    steps.push_back({residual, n_changes});
    const bool is_smallest = residual < best;
    best                   = std::min(best, residual);
    return is_smallest;
  }



  unsigned int NewtonGlobalization::circle() const
  {
    const unsigned int longest = 20;
    const double       same    = 0.02;
    for (unsigned int k = 1; k <= longest && k < steps.size(); ++k)
      {
        const unsigned int n_repeated =
          steps.back().n_changes == 0 && k == 1 ? 5 : std::max(patience, 2 * k);
        if (n_repeated + k <= steps.size() &&
            std::equal(steps.end() - n_repeated,
                       steps.end(),
                       steps.end() - n_repeated - k,
                       [&](const Step &now, const Step &before) {
                         return now.n_changes == before.n_changes &&
                                std::abs(now.residual - before.residual) <=
                                  same * now.residual;
                       }))
          return k;
      }
    return 0;
  }



  void NewtonGlobalization::forget()
  {
    steps.clear();
    best = std::numeric_limits<double>::max();
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
