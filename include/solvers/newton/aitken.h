/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_aitken_h
#define contact_aitken_h

#include <cmath>

#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Aitken's extrapolation of a fixed-point iteration x <- G(x) of vectors. If
   * one mode is left, the steps r = G(x) - x are parallel, and each is a factor
   * s times the one before it: the limit is x + r / (1 - s). It serves where s
   * is between about 0.3 and 1, which takes many steps, and where it is
   * negative, which is an iteration that jumps to and fro.
   */
  class AitkenExtrapolation
  {
  public:
    /// The part of the @p step to take: 1 is to its end.
    double length(const GhostedVector &step)
    {
      if (last.size() == step.size() && last.l2_norm() > 0)
        {
          const double product = step * last;
          const double factor  = product / (last * last);
          const bool   is_parallel =
            std::abs(product) > 0.95 * step.l2_norm() * last.l2_norm();
          if (is_parallel && std::abs(factor) > 0.3 && factor < 0.98)
            {
              forget();
              return 1 / (1 - factor);
            }
        }
      last = step;
      return 1;
    }

    /// The iteration starts anew.
    void forget()
    {
      last = GhostedVector();
    }

  private:
    GhostedVector last;
  };
} // namespace Contact

#endif
