/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/goal_errors.h"

#include <algorithm>
#include <cmath>

#include "adaptivity/patch_recovery.h"
#include "adaptivity/refined_system.h"
#include "adaptivity/refinement.h"
#include "contact/probes.h"
#include "solvers/saddle_point_system.h"

namespace Contact
{
  GoalErrors::GoalErrors(const Parameters::All &parameters,
                         ContactModel          &model,
                         const IncrementState  &state,
                         TimerOutput           &timer)
    : parameters(parameters)
    , model(model)
    , state(state)
    , timer(timer)
    , probes(parameters.probes.definitions())
    , linearization(
        {/*moving_geometry=*/model.geometry_follows(parameters.solution),
         /*moving_bound=*/model.interface &&
           model.interface->has_coulomb_friction()})
  {
  }



  ProbeErrors GoalErrors::estimate()
  {
    TimerOutput::Scope          scope(timer, "estimate");
    ProbeErrors                 errors;
    std::vector<Vector<double>> duals = solve_dual_problems(errors);
    const PatchRecovery         recovery(*model.discretization, duals);
    refine(duals);
    const auto          recovered = recovery.values(*fine.discretization);
    const RefinedSystem system(fine, fine_state, linearization);
    Vector<double>      residual = system.negative_residual();
    const auto          requests = parameters.probes.requests();
    Vector<float>       missed(model.mesh->triangulation.n_active_cells());
    Vector<float>       met(missed.size());
    // By trial: without sweeps estimates of smooth scenes are off by a factor
    // of up to six, after one by half, after three by a tenth, after five by
    // less.
    const Vector<double> relaxed = system.relax(residual, /*n_sweeps=*/5);

    unsigned int k = 0;
    for (const auto &[name, probe] : probes)
      {
        Vector<double>      &dual        = duals[k];
        Vector<double>       transferred = dual;
        const Vector<double> functional =
          probe_derivative(probe, fine, fine_state.solution);
        std::copy(recovered[k].begin(), recovered[k].end(), dual.begin());
        impose_contact(functional, dual);
        std::vector<unsigned int> vertices;
        for (const std::string &point : probe.points)
          vertices.push_back(model.mesh->point(point, "Probes/Probes"));
        system.solve_dual_around(vertices, functional, dual);
        fine.discretization->constrain_homogeneously(dual);
        errors.mesh[name] =
          (functional * relaxed + residual * dual + change_of_recovery(probe)) /
          (1 - std::pow(2., -order(probe)));
        if (const auto request = requests.find(name); request != requests.end())
          {
            const double accepted = request->second.error_of(
              probe_value(probe, model, state.solution));
            transferred -= dual;
            add_indicators(system.negative_residual(),
                           transferred,
                           1 / accepted,
                           std::abs(errors.mesh[name]) > accepted ? missed
                                                                  : met);
          }
        ++k;
      }
    cell_indicators = missed.linfty_norm() > 0 ? missed : met;
    return errors;
  }



  // A node's share belongs to all cells at it alike; the multipliers of a point
  // to those at its own node.
  void GoalErrors::add_indicators(const Vector<double> &residual,
                                  const Vector<double> &weight,
                                  const double          scale,
                                  Vector<float>        &indicators) const
  {
    const auto    &dof_handler = fine.discretization->dof_handler;
    Vector<double> shares(fine.n_displacements());
    for (unsigned int i = 0; i < shares.size(); ++i)
      shares[i] = residual[i] * weight[i];
    if (fine.interface)
      for (const ContactPoint &point : fine.interface->points())
        for (unsigned int k = 0; k < point.n_multipliers && point.n_nodes > 0;
             ++k)
          {
            const auto n = fine.interface->normal_index(point.multipliers[k]);
            shares[point.dofs[point.own_node()][0]] += residual[n] * weight[n];
          }

    std::vector<unsigned int>            n_cells(shares.size());
    std::vector<types::global_dof_index> dofs;
    const auto                           for_cells = [&](const auto &visit) {
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          dofs.resize(cell->get_fe().dofs_per_cell);
          cell->get_dof_indices(dofs);
          visit(cell);
        }
    };
    for_cells([&](const auto &) {
      for (const auto dof : dofs)
        ++n_cells[dof];
    });
    Vector<double> of_cells(indicators.size());
    for_cells([&](const auto &cell) {
      const Triangulation<2>::active_cell_iterator parent(
        &model.mesh->triangulation,
        cell->level() - 1,
        cell->parent_index());
      for (const auto dof : dofs)
        of_cells[parent->active_cell_index()] += shares[dof] / n_cells[dof];
    });
    for (unsigned int c = 0; c < of_cells.size(); ++c)
      indicators[c] += scale * std::abs(of_cells[c]);
  }



  Vector<float> GoalErrors::indicators() const
  {
    return cell_indicators;
  }



  // Minus the residual of the state under the present pairing.
  Vector<double> GoalErrors::negative_residual() const
  {
    Vector<double> residual(model.n_unknowns());
    model.elasticity->assemble(state.solution,
                               state.load_factor,
                               residual,
                               nullptr);
    if (model.interface)
      ContactKernel(*model.interface)
        .assemble(state.solution,
                  state.start,
                  linearization,
                  residual,
                  nullptr);
    return residual;
  }



  // First under the pairing of the run, which ends with bounds of friction from
  // the pressures; then under that of the state. There points may face the
  // master that did not, or the other way round.
  GoalErrors::Residuals GoalErrors::pair_anew() const
  {
    const bool has_friction_loop =
      linearization.moving_bound && !parameters.solution.has_moving_bound();
    Residuals residuals = {
      {has_friction_loop ? "friction loop" : "Newton's method",
       negative_residual()}};
    if (!model.interface)
      return residuals;
    PairingMode mode;
    mode.with_derivatives = linearization.moving_geometry;
    model.interface->pair(linearization.moving_geometry
                            ? state.solution
                            : Vector<double>(state.solution.size()),
                          mode);
    if (linearization.moving_geometry)
      {
        model.interface->update_statuses(state.solution,
                                         state.start,
                                         linearization.moving_bound,
                                         /*keep=*/true);
        forget_excess();
        residuals.emplace_back("pairing", negative_residual());
      }
    return residuals;
  }



  // In contact the weighted gap of a mortar point vanishes, and no distance is
  // above it. Under a pairing that is not yet that of the state one may be, and
  // two points would have the gap of the one place where the bodies are
  // closest.
  void GoalErrors::forget_excess() const
  {
    std::vector<ContactPoint> points = model.interface->points();
    for (ContactPoint &point : points)
      if (point.status.kind != Status::open && !point.change.dofs.empty())
        {
          point.projection = Point<2>();
          std::fill(point.change.projection.begin(),
                    point.change.projection.end(),
                    0.);
        }
    model.interface->set_points(points);
  }



  // The tangent knows how the pairing moves, whatever the run did.
  std::vector<Vector<double>>
  GoalErrors::solve_dual_problems(ProbeErrors &errors) const
  {
    std::vector<ContactPoint> points;
    if (model.interface)
      points = model.interface->points();
    const Residuals   residuals = pair_anew();
    SaddlePointSystem system(*model.discretization,
                             *model.elasticity,
                             model.interface.get(),
                             linearization,
                             linearization.moving_geometry,
                             /*keeps_factorization=*/false,
                             timer);
    system.update_pattern(true);
    system.factorize(state.solution, state.start, state.load_factor);

    std::vector<Vector<double>> duals;
    for (const auto &[name, probe] : probes)
      {
        duals.push_back(probe_derivative(probe, model, state.solution));
        system.solve_transposed(duals.back());
        double before = 0;
        for (const auto &[loop, residual] : residuals)
          {
            const double so_far      = residual * duals.back();
            errors.loops[name][loop] = so_far - before;
            before                   = so_far;
          }
      }
    if (model.interface)
      model.interface->set_points(points);
    return duals;
  }



  void GoalErrors::refine(std::vector<Vector<double>> &duals)
  {
    fine.mesh = std::make_unique<Mesh>(*model.mesh);
    fine.discretization =
      std::make_unique<Discretization>(*fine.mesh, parameters);

    std::vector<std::vector<SurfaceState>> surfaces;
    if (model.interface)
      for (const Vector<double> &dual : duals)
        surfaces.push_back(save_surfaces(*model.interface, dual));

    std::vector<Vector<double>> transferred = duals;
    transferred.push_back(state.solution);
    transferred.push_back(state.start);
    flag_all_cells(*fine.mesh);
    refine_and_transfer(*fine.mesh, *fine.discretization, transferred);

    fine.elasticity =
      Elasticity::create(*fine.discretization, parameters.solids);
    if (model.interface)
      {
        auto pairs = parameters.pairs();
        for (unsigned int z = 0; z < pairs.size(); ++z)
          pairs[z].ends_are_corners = model.interface->pairs[z]->sees_ends();
        fine.interface =
          std::make_unique<ContactInterface>(*fine.discretization,
                                             *fine.elasticity,
                                             pairs);
      }
    for (Vector<double> &vector : transferred)
      vector.grow_or_shrink(fine.n_unknowns());

    fine_state.load_factor = state.load_factor;
    fine_state.start       = transferred.back();
    transferred.pop_back();
    fine_state.solution = transferred.back();
    transferred.pop_back();
    duals.swap(transferred);
    fine.discretization->prescribe(fine_state.solution, state.load_factor);
    if (fine.interface)
      transfer_contact(surfaces, duals);
  }



  // Statuses follow the pressures of the state: it comes last.
  void GoalErrors::transfer_contact(
    const std::vector<std::vector<SurfaceState>> &duals_on_surfaces,
    std::vector<Vector<double>>                  &duals)
  {
    PairingMode mode;
    mode.with_derivatives = linearization.moving_geometry;
    fine.interface->pair(linearization.moving_geometry
                           ? fine_state.solution
                           : Vector<double>(fine_state.solution.size()),
                         mode);
    fine.interface->set_support_motion(
      fine.discretization->support_motion(fine_state.start, state.load_factor));
    for (unsigned int k = 0; k < duals.size(); ++k)
      restore_surfaces(duals_on_surfaces[k], *fine.interface, duals[k]);
    restore_surfaces(save_surfaces(*model.interface, state.solution),
                     *fine.interface,
                     fine_state.solution);
    update_statuses();
    for (const ContactPoint &point : fine.interface->points())
      if (point.status.kind == Status::open)
        for (Vector<double> &dual : duals)
          set_multipliers(point, 0., dual);
  }



  // At the end of the contact a point is part of it if what presses it is more
  // than what its gap takes to close: the pressure against the stiffness E/h.
  void GoalErrors::update_statuses()
  {
    std::vector<ContactPoint> points = fine.interface->points();
    for (ContactPoint &point : points)
      {
        if (!point.facing || fine.interface->contact_pair(point).tied)
          continue;
        const ContactState now =
          fine.interface->state(point, fine_state.solution, fine_state.start);
        const double p_trial =
          now.lambda_n -
          fine.interface->contact_pair(point).stiffness(point) * now.gap;
        const bool is_open = point.status.kind == Status::open;
        if (is_open != (p_trial <= 0))
          point.status =
            fine.interface->updated_status(point,
                                           PointStatus(),
                                           p_trial,
                                           now.lambda_t,
                                           linearization.moving_bound);
        if (point.status.kind == Status::open)
          set_multipliers(point, 0., fine_state.solution);
      }
    fine.interface->set_points(points);
  }



  void GoalErrors::set_multipliers(const ContactPoint &point,
                                   const double        value,
                                   Vector<double>     &vector) const
  {
    for (unsigned int k = 0; k < point.n_multipliers; ++k)
      {
        vector[fine.interface->normal_index(point.multipliers[k])] = value;
        if (fine.interface->has_friction(point))
          vector[fine.interface->tangential_index(point.multipliers[k])] =
            value;
      }
  }



  // Of the transposed equations those of the multipliers of a point k in
  // contact: with the jump [z] = sum_a C_a z_a and J' = (J_n, J_t),
  //   w n.[z] = -J_n,  w t.[z] = -J_t                        where it sticks,
  //   w (n + q' t).[z] = -(J_n + q' J_t)                     where it slips,
  // q' the derivative of the shear with respect to the pressure. The node of
  // the slave takes what is missing.
  void GoalErrors::impose_contact(const Vector<double> &functional,
                                  Vector<double>       &dual) const
  {
    const auto &constraints = fine.discretization->constraints;
    fine.discretization->constrain_homogeneously(dual);
    if (!fine.interface)
      return;

    const ContactInterface &interface = *fine.interface;
    for (const ContactPoint &point : interface.points())
      {
        if (point.status.kind == Status::open || !point.facing)
          continue;
        const unsigned int own = point.own_node();
        Tensor<1, 2>       missing;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            missing[i] -= point.C[a] * dual[point.dofs[a][i]];

        const unsigned int k   = point.multipliers[0];
        const double       J_n = functional[interface.normal_index(k)];
        const double       J_t = interface.has_friction(point)
                                   ? functional[interface.tangential_index(k)]
                                   : 0.;
        const ContactState now =
          interface.state(point, fine_state.solution, fine_state.start);
        const Traction traction =
          interface.traction(point,
                             point.status,
                             now.p_trial,
                             now.q_trial,
                             linearization.moving_bound);
        std::vector<std::pair<Tensor<1, 2>, double>> conditions;
        if (traction.dq_dq > 0)
          conditions = {{point.normal, -J_n}, {point.tangent, -J_t}};
        else
          conditions = {{point.normal + traction.dq_dp * point.tangent,
                         -(J_n + traction.dq_dp * J_t)}};
        Tensor<1, 2> correction;
        for (auto &[direction, target] : conditions)
          {
            const double distance = target / point.weight + direction * missing;
            for (unsigned int i = 0; i < 2; ++i)
              if (constraints.is_constrained(point.dofs[own][i]))
                direction[i] = 0;
            if (direction.norm() > 0)
              correction += distance / direction.norm_square() * direction;
          }
        for (unsigned int i = 0; i < 2; ++i)
          dual[point.dofs[own][i]] += correction[i] / point.C[own];
      }
    fine.discretization->constrain_homogeneously(dual);
  }



  // Functionals converge twice as fast as the energy norm. Not so the pressure
  // of contact, which is as accurate as its space, and a stress on a boundary,
  // which is recovered from one side.
  double GoalErrors::order(const Definition &probe) const
  {
    const double p = parameters.element.degree;
    if (is_contact_traction(probe.quantity))
      return p;
    if (!is_stress(probe.quantity))
      return 2 * p;
    const StressRecovery recovery(*model.discretization);
    for (const std::string &point : probe.points)
      for (const auto &cell :
           recovery.cells_at(model.mesh->point(point, "Probes/Probes")))
        if (cell->at_boundary())
          return p;
    return 2 * p;
  }



  double GoalErrors::change_of_recovery(const Definition &probe) const
  {
    return is_stress(probe.quantity)
             ? probe_value(probe, fine, fine_state.solution) -
                 probe_value(probe, model, state.solution)
             : 0.;
  }
} // namespace Contact
