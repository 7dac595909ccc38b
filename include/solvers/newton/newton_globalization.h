/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_newton_globalization_h
#define contact_newton_globalization_h

#include <limits>
#include <vector>

namespace Contact
{
  /**
   * The globalization of a semismooth Newton method: it keeps the residual from
   * running away and the active set from cycling, without being in the way
   * where the method converges.
   *
   * Runaway: the residual need not fall where an active set is looked for, nor
   * where a slender body turns, which the first step stretches. But the next
   * step cancels it to its round-off only: where that is above the tolerance,
   * the method is lost.
   *
   * Circles: steps that repeat those of one to twenty steps before, in residual
   * within a fiftieth and in the number of points that want to change, go on
   * like that, but where the pairing has been frozen meanwhile. Where no point
   * changes five of them tell, otherwise ten, or twice the circle.
   *
   * Cycles: all points change their status at once. If their number has not
   * come below its minimum for ten steps in which points change at all, one
   * does, until it has: the safeguarded block pivoting of Portugal, Judice and
   * Vicente (Math. Comp. 63, 1994), finite for uniquely solvable problems.
   */
  class NewtonGlobalization
  {
  public:
    /// Whether a step that ended with this residual has lost the way to one as
    /// small as @p tolerance.
    bool is_lost(const double residual, const double tolerance) const;

    /// A step has ended with this residual, and @p n_changes points want to
    /// change their statuses: returns whether the residual is the smallest.
    bool advance(const double residual, const unsigned int n_changes);

    /// The steps of a circle that the last ones go in, one where they stand
    /// still; zero if they do not.
    unsigned int circle() const;

    /// The problem that the steps did not solve has become a simpler one.
    void move_on()
    {
      steps.clear();
    }

    /// Forget the residuals: the next step starts a new problem, as one that
    /// moves supports does.
    void forget();

    /// Whether, as @p n_changes points want to change their statuses, only
    /// one may.
    bool one_at_a_time(const unsigned int n_changes);

  private:
    static constexpr unsigned int patience = 10; // steps without progress

    struct Step
    {
      double       residual;
      unsigned int n_changes;
    };

    std::vector<Step> steps;
    double            best     = std::numeric_limits<double>::max();
    unsigned int      fewest   = std::numeric_limits<unsigned int>::max();
    unsigned int      n_wasted = 0;
  };
} // namespace Contact

#endif
