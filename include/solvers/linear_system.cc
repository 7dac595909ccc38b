/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/linear_system.h"

#include <iomanip>

#include "solvers/condensed_system.h"
#include "solvers/saddle_point_system.h"

namespace Contact
{
  namespace
  {
    class SaddlePointForm : public LinearSystem<2>
    {
    public:
      SaddlePointForm(const ContactModel<2>      &model,
                      const Parameters::All      &parameters,
                      const ContactLinearization &linearization,
                      ConditionalOStream         &screen,
                      TimerOutput                &timer)
        : model(model)
        , screen(screen)
        , system(*model.discretization,
                 *model.elasticity,
                 model.interface.get(),
                 linearization,
                 model.geometry_follows(parameters.solution),
                 keeps_factorization(model, parameters),
                 timer)
      {
      }

      std::string name() const override
      {
        return "saddle point, UMFPACK";
      }

      bool has_multipliers() const override
      {
        return true;
      }

      void update_pattern(const bool edges_have_changed) override
      {
        system.update_pattern(edges_have_changed);
      }

      void forget_pattern() override
      {
        system.forget_pattern();
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

      // The step under the present status, then the search for the status that
      // the linearised problem has.
      unsigned int make_step(const Step        &step,
                             GhostedVector     &rhs,
                             IncrementState<2> &state) override
      {
        const bool settled =
          system.solve(state.solution,
                       state.start,
                       state.load_factor,
                       step.residual,
                       step.last_residual,
                       !searches          ? StatusSearch::none
                       : step.number == 0 ? StatusSearch::first
                                          : StatusSearch::later,
                       rhs);
        state.solution += rhs;
        model.discretization->settle(state.solution, state.load_factor);
        model.discretization->constrain_update(state.solution,
                                               state.load_factor);
        if (!settled)
          screen << "      the search of the active set does not settle: the "
                    "statuses change from step to step"
                 << std::endl;
        searches = searches && settled;
        return 0;
      }

      std::string contradiction() const override
      {
        return "";
      }

    private:
      // In loops around Newton's method little changes from turn to turn. With
      // the pairing in the tangent there are none: it is there for its
      // quadratic convergence.
      static bool keeps_factorization(const ContactModel<2> &model,
                                      const Parameters::All &parameters)
      {
        return parameters.geometry(model.n_displacements()) !=
               Parameters::GeometryLoop::newton;
      }

      const ContactModel<2> &model;
      ConditionalOStream    &screen;
      SaddlePointSystem      system;
      bool                   searches = true;
    };



    template<int dim>
    class CondensedForm : public LinearSystem<dim>
    {
    public:
      using Step = typename LinearSystem<dim>::Step;

      CondensedForm(const ContactModel<dim> &model,
                    const Parameters::All   &parameters,
                    const bool               moving_bound,
                    ConditionalOStream      &screen,
                    TimerOutput             &timer)
        : model(model)
        , parameters(parameters.solution)
        , screen(screen)
        , solver(choose_solver(model, parameters.solution))
        , elimination(*model.discretization,
                      model.interface.get(),
                      moving_bound)
        , system(*model.discretization,
                 *model.elasticity,
                 model.interface.get(),
                 elimination,
                 solver,
                 timer)
        , update(model.discretization->distribution)
      {
      }

      std::string name() const override
      {
        return "condensed, " + solver.name();
      }

      bool has_multipliers() const override
      {
        return false;
      }

      void update_pattern(const bool) override
      {
        system.update_pattern();
      }

      // That of the next pairing is compared with this one.
      void forget_pattern() override
      {
      }

      // A bound that follows the pressure does so in between. In space nearly
      // incompressible bodies have forces at the new place that are of second
      // order, and the wrong points would open.
      void recover_multipliers(const GhostedVector &rhs,
                               const double         part,
                               IncrementState<dim> &state) override
      {
        if (dim == 3 && part > 0)
          recover_from(system.linear_forces(state.solution, state.load_factor),
                       state);
        else
          recover_from(rhs, state);
      }

      void recover_from(const GhostedVector &rhs, IncrementState<dim> &state)
      {
        elimination.recover_pressures(rhs, state.start, state.solution);
        if (model.has_friction() &&
            parameters.friction == Parameters::FrictionLoop::lagged_bound)
          model.interface->update_bounds(state.solution, state.start);
        elimination.recover_shears(rhs, state.start, state.solution);
      }

      void begin_newton() override
      {
      }

      // Inexact Newton: a step that others follow is solved to a thousandth of
      // the residual, linear bodies under statuses that stay in one.
      unsigned int make_step(const Step          &step,
                             GhostedVector       &rhs,
                             IncrementState<dim> &state) override
      {
        const bool statuses_stay =
          step.number > 0 || !model.interface || model.interface->is_tied();
        const bool one_solve_is_all =
          model.elasticity->is_linear() && statuses_stay &&
          !parameters.pairs_each_step() &&
          parameters.friction == Parameters::FrictionLoop::fixed_point;
        const double forcing =
          std::min(1e-5, parameters.linear_tolerance * step.residual);
        const double relative =
          std::max(0.1 * step.tolerance, one_solve_is_all ? 0. : forcing);
        const unsigned int n = system.solve(state.solution,
                                            state.start,
                                            rhs,
                                            relative * step.force,
                                            update,
                                            step.continues);
        screen << "      solved to " << std::scientific << std::setprecision(1)
               << relative << std::defaultfloat << std::setprecision(6)
               << " in " << n << " iterations" << std::endl;
        std::transform(update.begin(),
                       update.end(),
                       state.solution.begin(),
                       state.solution.begin(),
                       std::plus<>());
        model.discretization->settle(state.solution, state.load_factor);
        model.discretization->constrain_update(state.solution,
                                               state.load_factor);
        return n;
      }

      std::string contradiction() const override
      {
        return elimination.contradiction();
      }

    private:
      using SolverChoice = Parameters::Choice<Parameters::SolverKind>;

      static SolverChoice choose_solver(const ContactModel<dim>    &model,
                                        const Parameters::Solution &parameters)
      {
        if (parameters.linear_solver != Parameters::SolverKind::automatic)
          return parameters.linear_solver;
        return DefiniteSolver::choose(dim,
                                      model.n_displacements(),
                                      Utilities::MPI::n_mpi_processes(
                                        model.discretization->communicator));
      }

      const ContactModel<dim>   &model;
      const Parameters::Solution parameters;
      ConditionalOStream        &screen;
      const SolverChoice         solver;
      ContactElimination<dim>    elimination;
      CondensedSystem<dim>       system;
      GhostedVector              update; // of the displacements
    };
  } // namespace



  template<>
  std::unique_ptr<LinearSystem<2>>
  LinearSystem<2>::create(const ContactModel<2>      &model,
                          const Parameters::All      &parameters,
                          const ContactLinearization &linearization,
                          ConditionalOStream         &screen,
                          TimerOutput                &timer)
  {
    if (parameters.is_condensed(model.n_displacements()))
      return std::make_unique<CondensedForm<2>>(model,
                                                parameters,
                                                linearization.moving_bound,
                                                screen,
                                                timer);
    return std::make_unique<SaddlePointForm>(model,
                                             parameters,
                                             linearization,
                                             screen,
                                             timer);
  }



  template<>
  std::unique_ptr<LinearSystem<3>>
  LinearSystem<3>::create(const ContactModel<3>      &model,
                          const Parameters::All      &parameters,
                          const ContactLinearization &linearization,
                          ConditionalOStream         &screen,
                          TimerOutput                &timer)
  {
    return std::make_unique<CondensedForm<3>>(model,
                                              parameters,
                                              linearization.moving_bound,
                                              screen,
                                              timer);
  }
} // namespace Contact
