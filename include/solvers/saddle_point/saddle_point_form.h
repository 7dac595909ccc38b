/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_saddle_point_form_h
#define contact_saddle_point_form_h

#include "solvers/newton/linear_system.h"
#include "solvers/saddle_point/saddle_point_system.h"

namespace Contact
{
  using namespace dealii;

  /// The form of LinearSystem whose unknowns are displacements and multipliers.
  class SaddlePointForm : public LinearSystem<2>
  {
  public:
    SaddlePointForm(const ContactModel<2>      &model,
                    const Parameters::All      &parameters,
                    const ContactLinearization &linearization,
                    ConditionalOStream         &screen,
                    TimerOutput                &timer);

    std::string name() const override
    {
      return "saddle point, " + system.solver_name();
    }

    bool has_multipliers() const override
    {
      return true;
    }

    void update_pattern(const bool edges_have_changed) override
    {
      system.update_pattern(edges_have_changed);
    }

    void clear_pattern() override
    {
      system.clear_pattern();
    }

    void recover_multipliers(const GhostedVector &,
                             const double,
                             IncrementState<2> &) override
    {
    }

    void begin_newton() override
    {
      searches = true;
    }

    unsigned int make_step(const Step        &step,
                           GhostedVector     &rhs,
                           IncrementState<2> &state) override;

    void renew_tangent(const IncrementState<2> &) override
    {
    }

    /// The tangent of the state itself is looked at, and made if need be.
    bool tangent_is_indefinite(const IncrementState<2> &state,
                               const bool               may_cost) override;

    std::string open_stability() const override;

    std::string contradiction() const override
    {
      return "";
    }

  private:
    static bool keeps_factorization(const ContactModel<2> &model,
                                    const Parameters::All &parameters);

    const ContactModel<2> &model;
    ConditionalOStream    &screen;
    SaddlePointSystem      system;
    bool                   searches = true;

    // Of the state that was looked at last.
    bool is_indefinite = false;
  };
} // namespace Contact

#endif
