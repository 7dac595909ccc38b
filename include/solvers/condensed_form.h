/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_form_h
#define contact_condensed_form_h

#include <memory>

#include "solvers/condensed/condensed_system.h"
#include "solvers/newton/linear_system.h"

namespace Contact
{
  using namespace dealii;

  /// The form of LinearSystem whose unknowns are displacements that fulfil the
  /// conditions of contact; multipliers follow from the forces of the bodies.
  template<int dim>
  class CondensedForm : public LinearSystem<dim>
  {
  public:
    using Step = typename LinearSystem<dim>::Step;

    CondensedForm(const ContactModel<dim> &model,
                  const Parameters::All   &parameters,
                  ConditionalOStream      &screen,
                  TimerOutput             &timer);

    std::string name() const override
    {
      return "condensed, " + solver.name();
    }

    bool has_multipliers() const override
    {
      return false;
    }

    void update_pattern(const bool edges_have_changed) override;

    /// That of the next pairing is compared with this one.
    void clear_pattern() override
    {
    }

    bool subtract_forces(const GhostedVector &u,
                         GhostedVector       &rhs) const override
    {
      return system->subtract_forces(u, rhs);
    }

    void recover_multipliers(const GhostedVector &rhs,
                             const double         part,
                             IncrementState<dim> &state) override;

    void begin_newton() override
    {
    }

    unsigned int make_step(const Step          &step,
                           GhostedVector       &rhs,
                           IncrementState<dim> &state) override;

    void renew_tangent(const IncrementState<dim> &state) override;

    bool tangent_is_indefinite(const IncrementState<dim> &,
                               const bool may_cost) override
    {
      return model.may_be_unstable() && last->is_indefinite(may_cost) &&
             (!model.has_friction() || last->knows_definiteness());
    }

    std::string open_stability() const override;

    std::string contradiction() const override
    {
      return elimination.contradiction();
    }

  private:
    using SolverChoice = Parameters::Choice<Parameters::SolverKind>;

    static SolverChoice choose_solver(const ContactModel<dim>    &model,
                                      const Parameters::Solution &parameters);
    static SolverChoice choose_with_matrix(const ContactModel<dim> &model);

    std::unique_ptr<CondensedSystem<dim>>
    create(const Parameters::SolverKind kind);

    /// The system that is solved at present.
    CondensedSystem<dim> &present_system();

    bool leaves_pairing() const;

    /// To which part of a step's residual its solution is left, where bodies
    /// yield.
    double forcing_term(const Step &step) const;

    unsigned int solve_for_update(const GhostedVector       &rhs,
                                  const double               tolerance,
                                  const Step                &step,
                                  const IncrementState<dim> &state);

    std::vector<double> motion_forces(GhostedVector        trial,
                                      const GhostedVector &u_start,
                                      const double         load_factor);

    unsigned int add_motions(const GhostedVector &rhs,
                             const double         tolerance,
                             const Step          &step,
                             IncrementState<dim> &state);

    const ContactModel<dim>   &model;
    const Parameters::Solution parameters;
    ConditionalOStream        &screen;
    TimerOutput               &timer;
    SolverChoice               solver;
    ContactElimination<dim>    elimination;

    std::unique_ptr<CondensedSystem<dim>> system, stabilized_system;
    CondensedSystem<dim>                 *last; // that of the last solve

    GhostedVector update; // of the displacements
  };
} // namespace Contact

#endif
