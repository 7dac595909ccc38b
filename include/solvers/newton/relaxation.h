/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_relaxation_h
#define contact_relaxation_h

#include <limits>

#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The part of the steps of a fixed-point iteration to take: all of it, as
   * long as they get smaller. If an iterate is less than half as far from the
   * one before the last as from the last, the iteration jumps to and fro, and
   * if four steps in a row are no smaller than one before, it goes round in
   * circles: then half as far, but not less than a sixteenth. A map of slope s
   * becomes one of slope 1 + l (s - 1), which converges for 1 - 2/l < s < 1.
   */
  class Relaxation
  {
  public:
    /// The part l to take of the step to @p iterate, the image of where the
    /// iteration is.
    double length(const GhostedVector &iterate)
    {
      if (last.size() > 0)
        {
          GhostedVector step(iterate);
          step -= last;
          const double size = step.linfty_norm() / part;
          n_wasted          = size < smallest ? 0 : n_wasted + 1;
          smallest          = std::min(size, smallest);

          bool to_and_fro = false;
          if (before.size() > 0)
            {
              GhostedVector back(iterate);
              back -= before;
              to_and_fro = back.linfty_norm() < 0.5 * step.linfty_norm();
            }
          if ((to_and_fro || n_wasted == 4) && part > 1. / 16)
            {
              part /= 2;
              n_wasted = 0;
              before   = GhostedVector();
              last     = iterate;
              return part;
            }
        }
      before = last;
      last   = iterate;
      return part;
    }

  private:
    GhostedVector last, before;
    double        smallest = std::numeric_limits<double>::max();
    double        part     = 1;
    unsigned int  n_wasted = 0;
  };
} // namespace Contact

#endif
