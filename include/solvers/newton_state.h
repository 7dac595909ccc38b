/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_newton_state_h
#define contact_newton_state_h

#include "solvers/convergence_test.h"
#include "solvers/linear_system.h"
#include "solvers/newton_guard.h"
#include "solvers/pairing.h"

namespace Contact
{
  using namespace dealii;

  /**
   * What Newton's method knows of the present state: the residual, and how many
   * points change their status in it.
   */
  class NewtonState
  {
  public:
    NewtonState(const ContactModel                  &model,
                const std::unique_ptr<LinearSystem> &system,
                IncrementState                      &state,
                Pairing                             &pairing,
                TimerOutput                         &timer);

    /// On a new mesh, with points that are paired in the undeformed state.
    void begin_level(const double tolerance);

    /// Pair the points and evaluate the residual and the status of the points.
    /// With @p one_at_a_time only one of them may change it. Collective.
    void evaluate(const bool after_a_step, const bool one_at_a_time);

    /**
     * A step that turns a cell inside out, or leads to a residual that @p guard
     * does not accept though no point has changed its status, was too long:
     * half of it from @p last, and half of that, under the status of
     * @p decisions. Returns the residuals of these attempts. Collective.
     */
    std::vector<double>
    search_along_line(const NewtonGuard           &guard,
                      const Vector<double>        &last,
                      const std::vector<Decision> &decisions);

    /// Throws NotConverged if this is no state of the bodies.
    void check() const;

    /// Whether no point changes its status, or would if it had none before:
    /// after a step a point may change it for ever where pressure and gap both
    /// vanish.
    bool is_decided(const bool after_a_step, const bool one_at_a_time) const;

    unsigned int n_changes() const
    {
      return n_status_changes;
    }

    /// Minus the residual.
    Vector<double> rhs;

    ConvergenceTest convergence;

  private:
    unsigned int                         update_status(const bool after_a_step,
                                                       const bool one_at_a_time);
    bool                                 points_follow_the_law() const;
    const ContactModel                  &model;
    const std::unique_ptr<LinearSystem> &system;
    IncrementState                      &state;
    Pairing                             &pairing;
    TimerOutput                         &timer;

    VolumeRatio  smallest_volume;
    unsigned int n_status_changes = 0;
  };
} // namespace Contact

#endif
