/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed_form.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

#include "solvers/direct/definite_solver.h"
#include "solvers/multigrid/matrix_free_system.h"

namespace Contact
{
  template<int dim>
  CondensedForm<dim>::CondensedForm(const ContactModel<dim> &model,
                                    const Parameters::All   &parameters,
                                    ConditionalOStream      &screen,
                                    TimerOutput             &timer)
    : model(model)
    , parameters(parameters.solution)
    , screen(screen)
    , timer(timer)
    , solver(choose_solver(model, parameters.solution))
    , elimination(*model.discretization, model.interface.get())
    , system(create(solver))
    , last(system.get())
    , update(model.discretization->distribution)
  {
  }



  template<int dim>
  void CondensedForm<dim>::update_pattern(const bool)
  {
    system->update_pattern();
    if (stabilized_system)
      stabilized_system->update_pattern();
  }



  // A bound that follows the pressure does so in between. In 3-D nearly
  // incompressible bodies have forces at the new place that are of second
  // order, and the wrong points would open.
  template<int dim>
  void CondensedForm<dim>::recover_multipliers(const GhostedVector &rhs,
                                               const double         part,
                                               IncrementState<dim> &state)
  {
    if (dim == 3 && part > 0)
      elimination.recover_multipliers(last->linear_forces(state.solution,
                                                          state.load_factor),
                                      state.start,
                                      state.solution);
    else
      elimination.recover_multipliers(rhs, state.start, state.solution);
  }



  // Inexact Newton: a step that others follow is solved to a thousandth of
  // the residual, linear bodies under statuses that stay in one, and where
  // bodies yield as far as it serves. Supports that the step moves are not
  // in the residual: bodies that are not linear do not balance behind it,
  // however exact it is.
  template<int dim>
  unsigned int CondensedForm<dim>::make_step(const Step          &step,
                                             GhostedVector       &rhs,
                                             IncrementState<dim> &state)
  {
    const bool statuses_stay =
      step.number > 0 || !model.interface || model.interface->is_tied();
    const bool one_solve_is_all =
      model.elasticity->is_linear() && statuses_stay &&
      !parameters.pairs_each_step() &&
      parameters.friction == Parameters::FrictionLoop::fixed_point;
    const bool moves_nonlinear_bodies =
      !model.elasticity->is_linear() &&
      model.discretization->update_is_prescribed();
    const double forcing =
      moves_nonlinear_bodies ? 1e-5
      : model.elasticity->changes_by_yielding()
        ? forcing_term(step) * step.residual
      : leaves_pairing()
        ? std::max(parameters.linear_tolerance, 0.01) * step.residual
        : std::min(1e-5, parameters.linear_tolerance * step.residual);
    const double relative =
      std::max(0.1 * step.tolerance, one_solve_is_all ? 0. : forcing);
    unsigned int n = solve_for_update(rhs, relative * step.force, step, state);
    if (model.interface && !model.interface->motions.free.empty())
      n += add_motions(rhs, relative * step.force, step, state);
    screen << "      solved to " << std::scientific << std::setprecision(1)
           << relative << std::defaultfloat << std::setprecision(6) << " in "
           << n << " iterations" << std::endl;
    std::transform(update.begin(),
                   update.end(),
                   state.solution.begin(),
                   state.solution.begin(),
                   std::plus<>());
    model.discretization->project_on_rigid_motions(state.solution,
                                                   state.load_factor);
    model.discretization->constrain_update(state.solution, state.load_factor);
    return n;
  }



  // Whatever its right-hand side is, it is solved well enough.
  template<int dim>
  void CondensedForm<dim>::renew_tangent(const IncrementState<dim> &state)
  {
    present_system().solve(state.solution,
                           state.start,
                           model.zero(),
                           std::numeric_limits<double>::max(),
                           update);
  }



  template<int dim>
  std::string CondensedForm<dim>::open_stability() const
  {
    if (!model.may_be_unstable() || last->knows_definiteness())
      return "";
    if (solver == Parameters::SolverKind::cholmod)
      return friction_leaves_stability_open;
    return "the stability of the solution is not checked: " +
           std::string(solver == Parameters::SolverKind::mumps
                         ? "MUMPS does"
                         : "the solver of unsymmetric matrices does") +
           " not tell of a tangent that is not positive definite";
  }



  // In 3-D the tangent does not know how the coefficients of a point
  // change with the way of the nodes around, and the residual falls by the
  // gradients of the displacements at best. Where bodies are linear, and
  // steps cost little else than their solution, two digits serve.
  template<int dim>
  bool CondensedForm<dim>::leaves_pairing() const
  {
    return dim == 3 && model.elasticity->is_linear() &&
           parameters.pairs_each_step() && model.geometry_follows(parameters);
  }



  // In bodies that yield a step is solved to a tenth of what it
  // would leave of the residual if Newton's method converged quadratically
  // from the last step on, but to two digits (the second choice of S. C.
  // Eisenstat and H. F. Walker, SIAM J. Sci. Comput. 17, 1996).
  template<int dim>
  double CondensedForm<dim>::forcing_term(const Step &step) const
  {
    const double largest = 0.01, part = 0.1;
    const double expected =
      step.number == 0 ? 1. : std::pow(step.residual / step.last_residual, 2);
    return std::max(parameters.linear_tolerance,
                    std::min(largest, part * expected));
  }



  // The forces along free motions after the update.
  template<int dim>
  std::vector<double>
  CondensedForm<dim>::motion_forces(GhostedVector        trial,
                                    const GhostedVector &u_start,
                                    const double         load_factor)
  {
    std::transform(update.begin(),
                   update.end(),
                   trial.begin(),
                   trial.begin(),
                   std::plus<>());
    const auto of_bodies = last->linear_forces(trial, load_factor);
    elimination.recover_multipliers(of_bodies, u_start, trial);
    return model.interface->motions.forces(trial,
                                           u_start,
                                           /*of_multipliers=*/true);
  }



  // The bordered system. The response to each free motion takes a solution
  // with the same matrix, and is linear: a hundredth of an edge serves. The
  // update is then that under which the forces are those given.
  template<int dim>
  unsigned int CondensedForm<dim>::add_motions(const GhostedVector &rhs,
                                               const double         tolerance,
                                               const Step          &step,
                                               IncrementState<dim> &state)
  {
    const ContactInterface<dim> &interface = *model.interface;
    double                       part      = std::numeric_limits<double>::max();
    for (const ContactPoint<dim> &point : interface.points())
      part =
        std::min(part, 0.01 * interface.contact_pair(point).edge_length(point));
    std::vector<unsigned int> motions;
    for (unsigned int k = 0; k < interface.motions.free.size(); ++k)
      if (!interface.motions.free[k]->stays)
        motions.push_back(k);

    const unsigned int m = motions.size();
    if (m == 0)
      return 0;
    model.discretization->counters.free_motions += m;
    const auto motion = [&](const unsigned int i) -> const FreeMotion & {
      return *interface.motions.free[motions[i]];
    };
    const GhostedVector first = update;
    const auto          before =
      motion_forces(state.solution, state.start, state.load_factor);
    std::vector<GhostedVector> responses;
    LAPACKFullMatrix<double>   resistance(m, m);
    Vector<double>             way(m); // of turns times the lever
    unsigned int               n = 0;
    for (unsigned int j = 0; j < m; ++j)
      {
        GhostedVector moved = state.solution;
        moved[interface.motions.index(motions[j])] += part / motion(j).lever;
        n += last->solve(state.solution,
                         state.start,
                         rhs,
                         tolerance,
                         update,
                         /*keep_tangents=*/true,
                         &moved);
        responses.push_back(update);
        responses.back() -= first;
        const auto after = motion_forces(moved, state.start, state.load_factor);
        for (unsigned int i = 0; i < m; ++i)
          resistance(i, j) =
            (after[motions[i]] - before[motions[i]]) / (motion(i).lever * part);
        resistance(j, j) +=
          interface.motions.spring(motion(j)) / std::pow(motion(j).lever, 2);
        way[j] = (motion(j).force - before[motions[j]]) / motion(j).lever;
      }

    const double missing = way.l1_norm();
    resistance.compute_lu_factorization();
    resistance.solve(way);
    update = first;
    for (unsigned int j = 0; j < m; ++j)
      {
        const double of_motion = way[j] / motion(j).lever;
        if (missing > step.tolerance * step.force)
          interface.motions.check(motion(j), of_motion, missing);
        state.solution[interface.motions.index(motions[j])] += of_motion;
        update.add(way[j] / part, responses[j]);
      }
    return n;
  }



  template<int dim>
  typename CondensedForm<dim>::SolverChoice
  CondensedForm<dim>::choose_solver(const ContactModel<dim>    &model,
                                    const Parameters::Solution &parameters)
  {
    const auto &discretization = *model.discretization;
    const auto &elasticity     = *model.elasticity;
    if (parameters.linear_solver == Parameters::SolverKind::gmg)
      {
        const std::string of =
          MatrixFreeSystem<dim>::refusal(discretization, elasticity);
        if (!of.empty())
          throw InputError("the matrix-free multigrid does not know "
                           "of " +
                             of,
                           "entry Solution/Linear solver = GMG",
                           "set 'Linear solver = AMG', or 'automatic'");
        if (MatrixFreeSystem<dim>::is_too_deep(discretization.mesh))
          return Parameters::SolverKind::amg;
      }
    if (parameters.linear_solver != Parameters::SolverKind::automatic)
      return parameters.linear_solver;
    if (MatrixFreeSystem<dim>::is_preferred(discretization, elasticity))
      return Parameters::SolverKind::gmg;
    return choose_with_matrix(model);
  }



  template<int dim>
  typename CondensedForm<dim>::SolverChoice
  CondensedForm<dim>::choose_with_matrix(const ContactModel<dim> &model)
  {
    return DefiniteSolver::choose(dim,
                                  model.n_displacements(),
                                  Utilities::MPI::n_mpi_processes(
                                    model.discretization->communicator),
                                  model.has_friction());
  }



  // A solver with a matrix goes on where the multigrid without one stalls, and
  // a factorization where AMG does.
  template<int dim>
  unsigned int
  CondensedForm<dim>::solve_for_update(const GhostedVector       &rhs,
                                       const double               tolerance,
                                       const Step                &step,
                                       const IncrementState<dim> &state)
  {
    try
      {
        return present_system().solve(state.solution,
                                      state.start,
                                      rhs,
                                      tolerance,
                                      update,
                                      step.continues);
      }
    catch (const SolverStalls &stall)
      {
        if (solver == Parameters::SolverKind::gmg)
          solver = choose_with_matrix(model);
        else
          solver = DefiniteSolver::direct(Utilities::MPI::n_mpi_processes(
            model.discretization->communicator));
        screen << "      " << stall.what() << "; " << solver.name()
               << " goes on from here" << std::endl;
        system = create(solver);
        system->update_pattern();
        return solve_for_update(rhs, tolerance, step, state);
      }
  }



  // Springs hold bodies for a while: these are in no multigrid without a
  // matrix.
  template<int dim>
  CondensedSystem<dim> &CondensedForm<dim>::present_system()
  {
    if (solver != Parameters::SolverKind::gmg ||
        model.elasticity->springs.held().empty())
      {
        stabilized_system.reset();
        last = system.get();
      }
    else
      {
        if (!stabilized_system)
          {
            stabilized_system = create(choose_with_matrix(model));
            stabilized_system->update_pattern();
          }
        last = stabilized_system.get();
      }
    return *last;
  }



  template<int dim>
  std::unique_ptr<CondensedSystem<dim>>
  CondensedForm<dim>::create(const Parameters::SolverKind kind)
  {
    return CondensedSystem<dim>::create(*model.discretization,
                                        *model.elasticity,
                                        model.interface.get(),
                                        elimination,
                                        kind,
                                        timer);
  }

  template class CondensedForm<2>;
  template class CondensedForm<3>;
} // namespace Contact
