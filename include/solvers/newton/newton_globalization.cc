/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/newton_globalization.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  bool NewtonGlobalization::accepts(const double residual) const
  {
    return std::isfinite(residual) &&
           (residuals.empty() || n_uphill < patience ||
            residual <= *std::max_element(residuals.begin(), residuals.end()));
  }



  bool NewtonGlobalization::is_lost(const double residual,
                                    const double tolerance) const
  {
    return residual > best &&
           std::numeric_limits<double>::epsilon() * residual > tolerance;
  }



  bool NewtonGlobalization::advance(const double       residual,
                                    const unsigned int n_changes)
  {
    const bool is_same = n_changes == 0 && !residuals.empty() &&
                         std::abs(residual - residuals.back()) < residual / 50;
    n_still = is_same ? n_still + 1 : 0;
    residuals.push_back(residual);
    if (residuals.size() > memory)
      residuals.pop_front();
    n_uphill = residual < best ? 0 : n_uphill + 1;
    best     = std::min(best, residual);
    return n_uphill == 0;
  }



  bool NewtonGlobalization::stands_still() const
  {
    return n_still >= memory;
  }



  void NewtonGlobalization::forget()
  {
    n_still = 0;
    residuals.clear();
    best     = std::numeric_limits<double>::max();
    n_uphill = 0;
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
