/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_alternation_h
#define contact_alternation_h

#include <deal.II/lac/vector.h>

namespace Contact
{
  using namespace dealii;

  /**
   * Watches the iterates of a fixed-point iteration. If one is less than half
   * as far from the one before the last as from the last, the iteration jumps
   * to and fro. From then on it takes half steps: a map of slope s becomes one
   * of slope (1 + s)/2, which converges for -3 < s < 1, and an iteration that
   * approaches from one side is never slowed down.
   */
  class Alternation
  {
  public:
    /// The length of the step to take from here, 1 or 1/2.
    double step_length(const Vector<double> &iterate)
    {
      if (before.size() > 0)
        {
          Vector<double> back(iterate), step(iterate);
          back -= before;
          step -= last;
          if (back.linfty_norm() < 0.5 * step.linfty_norm())
            length = 0.5;
        }
      before = last;
      last   = iterate;
      return length;
    }

  private:
    Vector<double> last, before;
    double         length = 1;
  };
} // namespace Contact

#endif
