/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/goal_errors.h"

#include <algorithm>
#include <cmath>

#include "adaptivity/patch_recovery.h"
#include "adaptivity/refined_system.h"
#include "contact/results/contact_results.h"
#include "probes/probes.h"
#include "solvers/saddle_point/saddle_point_system.h"

namespace Contact
{
  GoalErrors::GoalErrors(const Parameters::All   &parameters,
                         ContactModel<2>         &model,
                         const IncrementState<2> &state,
                         const LinearSystem<2>   &system,
                         TimerOutput             &timer)
    : parameters(parameters)
    , model(model)
    , state(state)
    , system(system)
    , timer(timer)
    , probes(parameters.probes.definitions())
    , linearization(
        {/*moving_geometry=*/model.geometry_follows(parameters.solution)})
  {
  }



  namespace
  {
    /// Whether a probe is no value at a point.
    bool is_integral(const Parameters::Quantity quantity)
    {
      return is_force(quantity) || is_energy(quantity);
    }



    /// Add what the test function of a resultant is at the boundary, times
    /// @p factor: its dual solution z has the derivative K^T v on the right, so
    /// z - v is as smooth as that of a displaced boundary, and z is not.
    void add_lift(const Parameters::Probes::Definition &probe,
                  const double                          factor,
                  const ContactModel<2>                &model,
                  GhostedVector                        &dual)
    {
      if (!is_force(probe.quantity))
        return;
      double sign = factor;
      for (const std::string &place : probe.places)
        {
          const GhostedVector v =
            resultant(probe.quantity, place, model).test_function();
          for (unsigned int i = 0; i < v.size(); ++i)
            dual[i] += sign * v[i];
          sign = -sign;
        }
    }
  } // namespace



  ProbeErrors GoalErrors::estimate()
  {
    TimerOutput::Scope         scope(timer, "estimate");
    ProbeErrors                errors;
    std::vector<GhostedVector> duals = solve_dual_problems(errors);
    const PatchRecovery        recovery(*model.discretization, duals);
    refined                     = std::make_unique<RefinedState>(parameters,
                                             model,
                                             state,
                                             linearization,
                                             duals);
    const ContactModel<2> &fine = refined->model;
    const auto             recovered = recovery.values(*fine.discretization);
    RefinedSystem          system(fine, refined->state, linearization);
    GhostedVector          residual = system.negative_residual();
    const auto             requests = parameters.probes.requests();
    Vector<float>          missed(model.mesh->triangulation.n_active_cells());
    Vector<float>          met(missed.size());
    // By trial: without sweeps estimates of smooth scenes are off by a factor
    // of up to six, after one by half, after three by a tenth, after five by
    // less.
    const GhostedVector relaxed = system.relax(residual, /*n_sweeps=*/5);

    find_doubts(errors);
    unsigned int k = 0;
    for (const auto &[name, probe] : probes)
      {
        GhostedVector &dual        = duals[k];
        GhostedVector  transferred = dual;
        GhostedVector  functional =
          probe_derivative(probe, fine, refined->state.solution);
        fine.discretization->constraints.condense(
          static_cast<Vector<double> &>(functional));
        std::copy(recovered[k].begin(), recovered[k].end(), dual.begin());
        add_lift(probe, 1, fine, dual);
        add_lift(probe, 1, fine, transferred);
        impose_contact(functional, dual);
        std::vector<unsigned int> vertices;
        if (!is_integral(probe.quantity))
          for (const std::string &point : probe.places)
            for (const auto &[vertex, weight] :
                 fine.discretization->place(point, "Probes/Probes").vertices)
              vertices.push_back(vertex);
        system.solve_dual_around(vertices, functional, dual);
        fine.discretization->constrain_homogeneously(dual);
        errors.mesh[name] =
          (change_of_probe(probe, functional, relaxed) + residual * dual) /
          (1 - std::pow(2., -order(probe)));
        if (const auto request = requests.find(name); request != requests.end())
          {
            const double accepted =
              request->second.error_of(probe_value(probe, model, state));
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



  void GoalErrors::find_doubts(ProbeErrors &errors) const
  {
    if (!model.interface)
      return;
    for (const auto &[name, probe] : probes)
      if (!is_integral(probe.quantity))
        for (const std::string &point : probe.places)
          for (const auto &[vertex, weight] :
               model.discretization->place(point, "Probes/Probes").vertices)
            {
              const NodeDoFs<2> &node =
                model.discretization->vertex_dofs[vertex];
              if (weight == 1 && is_at_corner(*model.interface, node))
                errors.at_corners.insert(name);
              if (is_contact_traction(probe.quantity) && is_unresolved(node))
                errors.unresolved.insert(name);
            }
  }



  // At a line of symmetry it is half of the zone, elsewhere at least that.
  bool GoalErrors::is_unresolved(const NodeDoFs<2> &node) const
  {
    const ContactInterface<2> &interface = *model.interface;
    const unsigned int         n_facets  = 4;
    const unsigned int n_nodes = n_facets * parameters.element.degree + 1;
    for (const ContactPoint<2> &at : interface.points())
      if (at.n_nodes > 0 && at.status.kind != Status::open &&
          !interface.contact_pair(at).tied && at.dofs(at.own_node()) == node)
        {
          unsigned int n_active = 0;
          for (const ContactPoint<2> &point :
               interface.contact_pair(at).points_among(interface.points()))
            if (point.status.kind != Status::open)
              ++n_active;
          return n_active < n_nodes;
        }
    return false;
  }



  // A node's share belongs to all cells at it alike; the multipliers of a point
  // to those at its own node.
  void GoalErrors::add_indicators(const GhostedVector &residual,
                                  const GhostedVector &weight,
                                  const double         scale,
                                  Vector<float>       &indicators) const
  {
    const ContactModel<2> &fine        = refined->model;
    const auto            &dof_handler = fine.discretization->dof_handler;
    GhostedVector          shares(fine.n_displacements());
    for (unsigned int i = 0; i < shares.size(); ++i)
      shares[i] = residual[i] * weight[i];
    if (fine.interface)
      for (const ContactPoint<2> &point : fine.interface->points())
        for (unsigned int k = 0; k < point.n_multipliers && point.n_nodes > 0;
             ++k)
          {
            const auto n = fine.interface->normal_index(point.multipliers[k]);
            shares[point.dofs(point.own_node())[0]] += residual[n] * weight[n];
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
  GhostedVector GoalErrors::negative_residual() const
  {
    GhostedVector residual = model.zero();
    model.elasticity->assemble(state.solution,
                               state.load_factor,
                               residual,
                               nullptr);
    if (model.interface)
      ContactKernel<2>(*model.interface)
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
      model.interface && model.interface->has_coulomb_friction() &&
      parameters.solution.friction == Parameters::FrictionLoop::fixed_point;
    Residuals residuals = {
      {has_friction_loop ? "friction loop" : "Newton's method",
       negative_residual()}};
    if (!model.interface)
      return residuals;
    PairingMode mode;
    mode.with_derivatives = linearization.moving_geometry;
    model.interface->pair(linearization.moving_geometry
                            ? state.solution
                            : GhostedVector(state.solution.size()),
                          mode);
    if (linearization.moving_geometry)
      {
        model.interface->active_set.update(state.solution,
                                           state.start,
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
    std::vector<ContactPoint<2>> points = model.interface->points();
    for (ContactPoint<2> &point : points)
      if (point.status.kind != Status::open && !point.change.dofs.empty())
        {
          point.projection = Point<2>();
          std::fill(point.change.projection.begin(),
                    point.change.projection.end(),
                    0.);
        }
    model.interface->set_points(points);
  }



  // The tangent knows how pairing and bounds move, unless the run ends with a
  // factorization that serves: as weights of residuals dual solutions need not
  // be exact.
  std::vector<GhostedVector>
  GoalErrors::solve_dual_problems(ProbeErrors &errors) const
  {
    // Asked before bounds follow: in what the run factorized they need not.
    const auto *at_hand = dynamic_cast<const SaddlePointSystem *>(&system);
    if (at_hand && !at_hand->has_tangent_of(state))
      at_hand = nullptr;
    std::vector<ContactPoint<2>>  points;
    std::optional<BoundsWhile<2>> bounds;
    if (model.interface)
      {
        points = model.interface->points();
        bounds.emplace(model.interface->bounds, /*follow=*/true);
      }
    const Residuals   residuals = pair_anew();
    SaddlePointSystem anew(model,
                           linearization,
                           linearization.moving_geometry,
                           /*keeps_factorization=*/false,
                           timer);
    if (!at_hand)
      {
        anew.update_pattern(true);
        anew.factorize(state.solution, state.start, state.load_factor);
      }

    std::vector<GhostedVector> duals;
    for (const auto &[name, probe] : probes)
      {
        duals.push_back(probe_derivative(probe, model, state.solution));
        (at_hand ? *at_hand : anew).solve_transposed(duals.back());
        double before = 0;
        for (const auto &[loop, residual] : residuals)
          {
            const double so_far      = residual * duals.back();
            errors.loops[name][loop] = so_far - before;
            before                   = so_far;
          }
        add_lift(probe, -1, model, duals.back());
      }
    if (model.interface)
      model.interface->set_points(points);
    return duals;
  }



  // Of the transposed equations those of the multipliers of a point k in
  // contact: with the jump [z] = sum_a C_a z_a and J' = (J_n, J_t),
  //   w n.[z] = -J_n,  w t.[z] = -J_t                        where it sticks,
  //   w (n + q' t).[z] = -(J_n + q' J_t)                     where it slips,
  // q' the derivative of the shear with respect to the pressure. The node of
  // the slave takes what is missing.
  void GoalErrors::impose_contact(const GhostedVector &functional,
                                  GhostedVector       &dual) const
  {
    const ContactModel<2> &fine        = refined->model;
    const auto            &constraints = fine.discretization->constraints;
    fine.discretization->constrain_homogeneously(dual);
    if (!fine.interface)
      return;

    const ContactInterface<2> &interface = *fine.interface;
    for (const ContactPoint<2> &point : interface.points())
      {
        if (point.status.kind == Status::open || !point.facing)
          continue;
        const unsigned int own = point.own_node();
        Tensor<1, 2>       missing;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            missing[i] -= point.C[a] * dual[point.dofs(a)[i]];

        const unsigned int    k   = point.multipliers[0];
        const double          J_n = functional[interface.normal_index(k)];
        const double          J_t = interface.has_friction(point)
                                      ? functional[interface.tangential_index(k)]
                                      : 0.;
        const ContactState<2> now =
          interface.state(point, refined->state.solution, refined->state.start);
        const Traction<2> traction = interface.active_set.traction(point, now);
        std::vector<std::pair<Tensor<1, 2>, double>> conditions;
        if (traction.dq_dq[0][0] > 0)
          conditions = {{point.normal, -J_n}, {point.tangents[0], -J_t}};
        else
          conditions = {{point.normal + traction.dq_dp[0] * point.tangents[0],
                         -(J_n + traction.dq_dp[0] * J_t)}};
        Tensor<1, 2> correction;
        for (auto &[direction, target] : conditions)
          {
            const double distance = target / point.weight + direction * missing;
            for (unsigned int i = 0; i < 2; ++i)
              if (constraints.is_constrained(point.dofs(own)[i]))
                direction[i] = 0;
            if (direction.norm() > 0)
              correction += distance / direction.norm_square() * direction;
          }
        for (unsigned int i = 0; i < 2; ++i)
          dual[point.dofs(own)[i]] += correction[i] / point.C[own];
      }
    fine.discretization->constrain_homogeneously(dual);
  }



  // Functionals converge twice as fast as the energy norm. Not so the pressure
  // of contact, which is as accurate as its space, a stress on a boundary,
  // which is recovered from one side, and a stress between nodes, which is
  // interpolated linearly. The error of a displacement between nodes is h^3 at
  // degree 2, but its sign depends on the place in the cell: on the average of
  // all places 1/64 of it is left on the next mesh.
  double GoalErrors::order(const Definition &probe) const
  {
    const double p = parameters.element.degree;
    if (is_contact_traction(probe.quantity))
      return p;
    if (is_integral(probe.quantity))
      return 2 * p;
    if (!is_stress(probe.quantity))
      return 2 * p;
    const StressRecovery<2> recovery(*model.discretization);
    for (const std::string &point : probe.places)
      for (const auto &[vertex, cells] : recovery.cells_at(
             model.discretization->place(point, "Probes/Probes")))
        for (const auto &cell : cells)
          if (cell->at_boundary())
            return p;
    return is_between_nodes(probe) ? 2 : 2 * p;
  }



  bool GoalErrors::is_between_nodes(const Definition &probe) const
  {
    return !is_integral(probe.quantity) &&
           std::any_of(probe.places.begin(),
                       probe.places.end(),
                       [&](const std::string &point) {
                         return model.discretization
                           ->place(point, "Probes/Probes")
                           .is_between_nodes();
                       });
  }



  // J(x_h + e) - J_h(x_h). An energy is quadratic, and where the supports are
  // at rest its error is that of second order. In a curved cell the place
  // between the nodes of the mesh refined once is not quite that of this one.
  double GoalErrors::change_of_probe(const Definition    &probe,
                                     const GhostedVector &functional,
                                     const GhostedVector &relaxed) const
  {
    if (is_energy(probe.quantity))
      {
        IncrementState<2> better = refined->state;
        better.solution += relaxed;
        return probe_value(probe, refined->model, better) -
               probe_value(probe, model, state);
      }
    const bool is_recovered = is_stress(probe.quantity) ||
                              is_force(probe.quantity) ||
                              is_between_nodes(probe);
    return functional * relaxed +
           (is_recovered ? probe_value(probe, refined->model, refined->state) -
                             probe_value(probe, model, state)
                         : 0.);
  }
} // namespace Contact
