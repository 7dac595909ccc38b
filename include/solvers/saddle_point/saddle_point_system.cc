/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/saddle_point_system.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

#include "solvers/newton/nearby_state.h"
#include "solvers/saddle_point/active_set_search.h"

namespace Contact
{
  SaddlePointSystem::SaddlePointSystem(
    const ContactModel<2>      &model,
    const ContactLinearization &linearization,
    const bool                  geometry_follows,
    const bool                  keeps_factorization,
    TimerOutput                &timer,
    const bool                  by_umfpack,
    ConditionalOStream         *screen)
    : model(model)
    , discretization(*model.discretization)
    , elasticity(*model.elasticity)
    , interface(model.interface.get())
    , linearization(linearization)
    , geometry_follows(geometry_follows)
    , keeps_factorization(keeps_factorization)
    , by_umfpack(by_umfpack)
    , timer(timer)
    , screen(screen)
    , solver(discretization.counters)
  {
  }



  // The step under the present status, then the search for the status that
  // the linearised problem has.
  unsigned int SaddlePointSystem::make_step(const Step        &step,
                                            GhostedVector     &rhs,
                                            IncrementState<2> &state)
  {
    const unsigned int n_motions =
      interface ? interface->motions.free.size() : 0;
    double missing = 0;
    for (unsigned int k = 0; k < n_motions; ++k)
      missing += std::abs(rhs[interface->motions.index(k)]) /
                 interface->motions.free[k]->lever;
    const bool settled = solve(state.solution,
                               state.start,
                               state.load_factor,
                               step.residual,
                               step.last_residual,
                               searches,
                               rhs);
    if (screen && solver.is_indefinite_inside())
      *screen << "      the stiffness of the bodies is not positive definite: "
                 "factorized by UMFPACK"
              << std::endl;
    if (missing > step.tolerance * step.force)
      for (unsigned int k = 0; k < n_motions; ++k)
        if (!interface->motions.free[k]->stays)
          interface->motions.check(*interface->motions.free[k],
                                   rhs[interface->motions.index(k)],
                                   missing);
    state.solution += rhs;
    model.discretization->project_on_rigid_motions(state.solution,
                                                   state.load_factor);
    model.discretization->constrain_update(state.solution, state.load_factor);
    if (screen && !settled)
      *screen << "      the search of the active set does not settle: the "
                 "statuses change from step to step"
              << std::endl;
    searches = searches && settled;
    return 0;
  }



  bool SaddlePointSystem::tangent_is_indefinite(const IncrementState<2> &state,
                                                const bool may_cost)
  {
    was_indefinite =
      may_cost && model.may_be_unstable() &&
      is_indefinite(state.solution, state.start, state.load_factor);
    return was_indefinite && !model.has_friction();
  }



  void SaddlePointSystem::update_pattern(const bool pairing_has_changed)
  {
    if (!pattern.empty() && !pairing_has_changed &&
        pattern_version == discretization.pattern_version())
      return;
    pattern_version = discretization.pattern_version();
    TimerOutput::Scope scope(timer, "setup");

    const auto n_unknowns = discretization.dof_handler.n_dofs() +
                            (interface ? interface->n_multipliers() : 0);
    DynamicSparsityPattern couplings(n_unknowns, n_unknowns);
    elasticity.add_couplings(couplings);
    if (interface)
      interface->add_couplings(couplings);
    for (unsigned int i = 0; i < couplings.n_rows(); ++i)
      couplings.add(i, i);

    pattern.copy_from(couplings);
    matrix.reinit(pattern);
    if (!interface || by_umfpack)
      {
        solver.initialize(pattern);
        return;
      }
    note_unknowns_of_contact();
    solver.initialize(pattern, of_contact);
  }



  // Displacements that points acted on before stay: an analysis is kept until
  // there are others.
  void SaddlePointSystem::note_unknowns_of_contact()
  {
    of_contact.resize(discretization.dof_handler.n_dofs());
    of_contact.resize(pattern.n_rows(), true);
    DynamicSparsityPattern couplings(pattern.n_rows(), pattern.n_rows());
    interface->add_couplings(couplings);
    for (unsigned int i = 0; i < of_contact.size(); ++i)
      if (couplings.row_length(i) > 0)
        of_contact[i] = true;
  }



  void SaddlePointSystem::clear_pattern()
  {
    matrix.clear();
    pattern.reinit(0, 0, 0);
  }



  bool SaddlePointSystem::solve(const GhostedVector &solution,
                                const GhostedVector &u_start,
                                const double         load_factor,
                                const double         residual,
                                const double         last_residual,
                                const bool           searches,
                                GhostedVector       &rhs_and_update)
  {
    if (!factorization_serves(residual, last_residual))
      assemble_and_factorize(solution,
                             u_start,
                             load_factor,
                             linearization,
                             StressStiffness::with,
                             rhs_and_update);
    solve_factorized(rhs_and_update);
    if (!interface || !searches)
      return true;

    // A body that springs hold is far from where contact will hold it.
    if (has_frozen_geometry() || elasticity.springs.held().empty())
      {
        TimerOutput::Scope scope(timer, "active set");
        if (ActiveSetSearch(discretization, *interface, solver, linearization)
              .correct(solution, u_start, rhs_and_update))
          return true;
      }
    return !has_frozen_geometry() &&
           search_with_frozen_geometry(solution,
                                       u_start,
                                       load_factor,
                                       rhs_and_update);
  }



  bool SaddlePointSystem::has_frozen_geometry() const
  {
    return elasticity.is_linear() && !linearization.moving_geometry &&
           !(interface && interface->has_elastic_slip());
  }



  // If the search ends at the present statuses, take the Newton step with the
  // linearised geometry under these statuses.
  bool
  SaddlePointSystem::search_with_frozen_geometry(const GhostedVector &solution,
                                                 const GhostedVector &u_start,
                                                 const double   load_factor,
                                                 GhostedVector &rhs_and_update)
  {
    const ContactLinearization frozen{/*moving_geometry=*/false};
    const GhostedVector        newton_step = rhs_and_update;
    assemble_and_factorize(solution,
                           u_start,
                           load_factor,
                           frozen,
                           StressStiffness::without,
                           rhs_and_update);
    solve_factorized(rhs_and_update);

    TimerOutput::Scope scope(timer, "active set");
    ActiveSetSearch    search(discretization, *interface, solver, frozen);
    const bool settled = search.correct(solution, u_start, rhs_and_update);
    if (!settled || search.keeps_statuses())
      rhs_and_update = newton_step;
    return settled;
  }



  void SaddlePointSystem::solve_factorized(GhostedVector &rhs_and_update)
  {
    TimerOutput::Scope scope(timer, "solution");
    solver.solve(rhs_and_update);
    discretization.distribute(discretization.constraints, rhs_and_update);
  }



  void SaddlePointSystem::factorize(const GhostedVector &solution,
                                    const GhostedVector &u_start,
                                    const double         load_factor)
  {
    GhostedVector rhs(matrix.m());
    assemble_and_factorize(solution,
                           u_start,
                           load_factor,
                           linearization,
                           StressStiffness::with,
                           rhs);
  }



  // The matrix at hand serves if it is of that state: it costs little to ask.
  bool SaddlePointSystem::is_indefinite(const GhostedVector &solution,
                                        const GhostedVector &u_start,
                                        const double         load_factor)
  {
    std::vector<bool> is_multiplier(matrix.m());
    if (interface)
      for (auto i = discretization.dof_handler.n_dofs();
           i < interface->motions.index(0);
           ++i)
        is_multiplier[i] = true;
    const auto is_definite = [&] {
      TimerOutput::Scope scope(timer, "stability");
      return solver.is_definite_under_constraints(is_multiplier);
    };
    if (solver.is_factorized() && stresses_turn &&
        is_nearby(discretization, solution, factorized_at, u_start) &&
        is_definite())
      return false;

    GhostedVector rhs(matrix.m());
    assemble_and_factorize(solution,
                           u_start,
                           load_factor,
                           {geometry_follows},
                           StressStiffness::with,
                           rhs);
    return !is_definite();
  }



  bool SaddlePointSystem::has_tangent_of(const IncrementState<2> &state) const
  {
    if (!solver.is_factorized() || !stresses_turn || pattern.empty() ||
        pattern_version != discretization.pattern_version() ||
        factorized_version != elasticity.tangent_version())
      return false;
    if (interface &&
        (factorized_contact != interface->signature() ||
         (interface->has_coulomb_friction() && !interface->bounds.follow)))
      return false;
    return has_frozen_geometry() || is_nearby(discretization,
                                              state.solution,
                                              factorized_at,
                                              state.start);
  }



  void SaddlePointSystem::solve_transposed(GhostedVector &b) const
  {
    TimerOutput::Scope scope(timer, "solution");
    discretization.constraints.condense(static_cast<Vector<double> &>(b));
    solver.solve_transposed(b);
    discretization.constrain_homogeneously(b);
  }



  // Under statuses that stay linear bodies keep their matrix, if the points do
  // not follow them.
  bool SaddlePointSystem::factorization_serves(const double residual,
                                               const double last_residual) const
  {
    if (!solver.is_factorized() || discretization.update_is_prescribed() ||
        pattern_version != discretization.pattern_version() ||
        factorized_version != elasticity.tangent_version() ||
        (interface && factorized_contact != interface->signature()))
      return false;
    if (elasticity.is_linear() && !geometry_follows &&
        !(interface && interface->has_elastic_slip()))
      return true;
    return interface && keeps_factorization && residual < 0.1 * last_residual;
  }



  // The right-hand side is assembled anew with the matrix, because prescribed
  // displacements enter it through the matrix.
  void SaddlePointSystem::assemble_and_factorize(
    const GhostedVector        &solution,
    const GhostedVector        &u_start,
    const double                load_factor,
    const ContactLinearization &linearization,
    const StressStiffness       stress_stiffness,
    GhostedVector              &rhs)
  {
    update_pattern(/*pairing_has_changed=*/false);
    {
      TimerOutput::Scope scope(timer, "assembly");
      matrix = 0;
      rhs    = 0;
      if (interface && elasticity.is_linear())
        {
          add_tangent_of_linear_bodies(solution);
          elasticity.assemble(solution, load_factor, rhs, nullptr);
        }
      else
        {
          ++discretization.counters.tangents;
          elasticity.assemble(solution,
                              load_factor,
                              rhs,
                              &matrix,
                              stress_stiffness);
          elasticity.add_rigid_stiffness(solution, matrix);
        }
      if (interface)
        ContactKernel<2>(*interface)
          .assemble(solution, u_start, linearization, rhs, &matrix);

      // Unknowns that are not free keep a row of their own, and get their
      // update from the constraints afterwards.
      for (unsigned int i = 0; i < discretization.dof_handler.n_dofs(); ++i)
        if (discretization.constraints.is_constrained(i))
          {
            matrix.diag_element(i) = 1;
            rhs[i]                 = 0;
          }
    }

    TimerOutput::Scope scope(timer, "factorization");
    solver.factorize(matrix);
    factorized_at      = solution;
    stresses_turn      = stress_stiffness == StressStiffness::with;
    factorized_version = elasticity.tangent_version();
    if (interface)
      factorized_contact = interface->signature();
  }



  // Contact changes, linear bodies do not: their tangent is assembled once on
  // a mesh and added to what the points make of the matrix.
  void
  SaddlePointSystem::add_tangent_of_linear_bodies(const GhostedVector &solution)
  {
    if (bodies_tangent.empty() ||
        bodies_version != elasticity.tangent_version())
      {
        ++discretization.counters.tangents;
        const auto             n = discretization.dof_handler.n_dofs();
        DynamicSparsityPattern couplings(n, n);
        elasticity.add_couplings(couplings);
        bodies_tangent.clear();
        bodies_pattern.copy_from(couplings);
        bodies_tangent.reinit(bodies_pattern);
        elasticity.visit_cells(
          solution,
          /*with_tangent=*/true,
          [this](const std::vector<types::global_dof_index> &dofs,
                 const FullMatrix<double>                   &tangent,
                 const Vector<double> &) {
            discretization.constraints
              .distribute_local_to_global(tangent, dofs, bodies_tangent);
          });
        bodies_version = elasticity.tangent_version();
      }
    for (const auto &entry : bodies_tangent)
      matrix.add(entry.row(), entry.column(), entry.value());
  }
} // namespace Contact
