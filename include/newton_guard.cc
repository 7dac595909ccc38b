/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "newton_guard.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  bool NewtonGuard::accepts(const double residual) const
  {
    return std::isfinite(residual) &&
           (residuals.empty() ||
            residual <= *std::max_element(residuals.begin(), residuals.end()));
  }



  void NewtonGuard::advance(const double residual)
  {
    residuals.push_back(residual);
    if (residuals.size() > memory)
      residuals.pop_front();
  }



  void NewtonGuard::forget()
  {
    residuals.clear();
  }



  bool NewtonGuard::one_at_a_time(const unsigned int n_changes)
  {
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
