/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact_interface.h"

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <limits>

#include "errors.h"

namespace Contact
{
  ContactInterface::ContactInterface(const Discretization      &discretization,
                                     const Elasticity          &elasticity,
                                     const Parameters::Contact &parameters)
    : tied(parameters.tied)
    , law{tied ? std::numeric_limits<double>::max() : parameters.tresca_limit,
          parameters.friction_coefficient}
    , slave(discretization,
            discretization.mesh.boundary(parameters.slave, "Contact/Slave"),
            parameters.slave)
    , master(discretization,
             discretization.mesh.boundary(parameters.master, "Contact/Master"),
             parameters.master)
    , complementarity_per_stiffness(parameters.complementarity)
    , discretization(discretization)
  {
    for (const Surface::Node &a : slave.nodes)
      for (const Surface::Node &b : master.nodes)
        if (a.dofs == b.dofs)
          throw InputError("slave '" + parameters.slave + "' and master '" +
                             parameters.master +
                             "' overlap: both have the "
                             "node at (" +
                             std::to_string(a.X[0]) + ", " +
                             std::to_string(a.X[1]) + ")",
                           "Contact/Slave, Contact/Master",
                           "name two surfaces without a common node");

    std::set<unsigned int> excluded;
    for (const std::string &name : parameters.excluded_points)
      {
        const auto &dofs =
          discretization.vertex_dofs[discretization.mesh
                                       .point(name, "Contact/Excluded points")];
        for (unsigned int i = 0; i < slave.nodes.size(); ++i)
          if (slave.nodes[i].dofs == dofs)
            excluded.insert(i);
      }
    // Over a ring, the shape function of degree 2 of a node on the axis has the
    // integral zero: no pressure there has a weight.
    if (slave.degree == 2)
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (discretization.is_on_axis(slave.nodes[i].X))
          excluded.insert(i);

    if (parameters.rule == "mortar")
      {
        mortar =
          std::make_unique<MortarRule>(slave, master, discretization, excluded);
        points = mortar->make_points(multipliers);
      }
    else if (parameters.rule == "nodal")
      points = make_nodal_points(slave, excluded, multipliers);
    else
      points = make_gauss_points(slave, parameters.n_gauss_points, multipliers);

    for (ContactPoint &point : points)
      {
        const auto  &edge     = slave.edges[point.slave_edge];
        const double young    = std::min(elasticity.young(edge.body),
                                      elasticity.young(master.edges[0].body));
        point.complementarity = complementarity_per_stiffness * young /
                                slave.reference_length(point.slave_edge);
      }
  }



  unsigned int ContactInterface::n_multipliers() const
  {
    return (law.is_frictionless() ? 1 : 2) * multipliers.n_multipliers;
  }



  types::global_dof_index
  ContactInterface::normal_index(const unsigned int k) const
  {
    return discretization.dof_handler.n_dofs() + k;
  }



  types::global_dof_index
  ContactInterface::tangential_index(const unsigned int k) const
  {
    return normal_index(k) + multipliers.n_multipliers;
  }



  bool ContactInterface::pair(const Vector<double> &u)
  {
    if (mortar)
      return mortar->pair(points, u);

    const SurfaceSearch search(master, u);
    bool                changed = false;
    for (ContactPoint &point : points)
      {
        const bool         was_paired = point.n_nodes > point.n_slave_nodes;
        const unsigned int last_edge  = point.master_edge;
        pair_with_master(point, master, search, discretization, u);
        changed = changed || !was_paired || point.master_edge != last_edge;
      }
    return changed;
  }



  double ContactInterface::largest_change(const Vector<double> &u,
                                          const Vector<double> &from) const
  {
    double change = 0;
    for (const Surface *surface : {&slave, &master})
      for (const Surface::Node &node : surface->nodes)
        for (const auto dof : node.dofs)
          change = std::max(change, std::abs(u[dof] - from[dof]));
    return change;
  }



  void ContactInterface::initialize_status(const Vector<double> &u)
  {
    for (ContactPoint &point : points)
      {
        const double length = slave.reference_length(point.slave_edge);
        if (point.facing && state(point, u, u).gap <= 0.01 * length)
          point.decision.status =
            can_stick(point) ? Status::stick : Status::slip;
      }
  }



  void ContactInterface::close_nearest(const Vector<double> &u)
  {
    if (count().active > 0)
      return;
    double smallest = std::numeric_limits<double>::max();
    for (const ContactPoint &point : points)
      if (point.facing)
        smallest = std::min(smallest, state(point, u, u).gap);
    for (ContactPoint &point : points)
      if (point.facing && state(point, u, u).gap - smallest <=
                            0.01 * slave.reference_length(point.slave_edge))
        point.decision.status = can_stick(point) ? Status::stick : Status::slip;
  }



  bool ContactInterface::can_stick(const ContactPoint &point) const
  {
    return !law.is_frictionless() && !point.tangential_row_is_void;
  }



  ContactState ContactInterface::state(const ContactPoint   &point,
                                       const Vector<double> &solution,
                                       const Vector<double> &u_start) const
  {
    Tensor<1, 2> r, dr;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double u = solution[point.dofs[a][i]];
          r[i] += point.C[a] * (tied ? u : point.X[a][i] + u);
          dr[i] += point.C[a] * (u - u_start[point.dofs[a][i]]);
        }

    ContactState state{};
    state.gap  = point.normal * r;
    state.slip = point.tangent * dr;
    // Without multipliers in the vector the question is for the gap alone.
    if (solution.size() > discretization.dof_handler.n_dofs())
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        {
          state.lambda_n +=
            point.psi[k] * solution[normal_index(point.multipliers[k])];
          if (!law.is_frictionless())
            state.lambda_t +=
              point.psi[k] * solution[tangential_index(point.multipliers[k])];
        }
    state.p_trial = state.lambda_n - point.complementarity * state.gap;
    state.q_trial = state.lambda_t - point.complementarity * state.slip;
    return state;
  }



  double ContactInterface::update_bounds(const Vector<double> &solution,
                                         const Vector<double> &u_start)
  {
    double change = 0, largest = 0;
    for (ContactPoint &point : points)
      {
        const double bound =
          point.decision.status == Status::open
            ? law.bound(0)
            : law.bound(state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.tresca_bound));
        largest = std::max(largest, bound);
        point.tresca_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  Vector<double> ContactInterface::bounds() const
  {
    Vector<double> bounds(points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      bounds[q] = points[q].tresca_bound;
    return bounds;
  }



  void ContactInterface::set_bounds(const Vector<double> &bounds)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].tresca_bound = bounds[q];
  }



  Decision ContactInterface::decide(const ContactPoint &point,
                                    const double        p_trial,
                                    const double        q_trial,
                                    const bool          moving_bound) const
  {
    if (!point.facing || (!tied && p_trial <= 0))
      return {Status::open, 0};
    if (!can_stick(point))
      return {Status::slip, 0};

    const double bound = moving_bound ? law.bound(p_trial) : point.tresca_bound;
    if (std::abs(q_trial) <= bound)
      return {Status::stick, 0};
    return {Status::slip, q_trial > 0 ? 1 : -1};
  }



  Traction ContactInterface::traction(const ContactPoint &point,
                                      const Decision     &decision,
                                      const double        p_trial,
                                      const double        q_trial,
                                      const bool          moving_bound) const
  {
    Traction traction;
    if (decision.status == Status::open)
      return traction;

    traction.p     = p_trial;
    traction.dp_dp = 1;
    if (decision.status == Status::stick)
      {
        traction.q     = q_trial;
        traction.dq_dq = 1;
      }
    else if (moving_bound)
      {
        traction.q = decision.slip_direction * law.bound(p_trial);
        traction.dq_dp =
          decision.slip_direction * law.bound_derivative(p_trial);
      }
    else
      traction.q = decision.slip_direction * point.tresca_bound;
    return traction;
  }



  unsigned int ContactInterface::decide_all(const Vector<double> &solution,
                                            const Vector<double> &u_start,
                                            const bool            moving_bound,
                                            const bool            keep)
  {
    unsigned int n_changes = 0;
    for (ContactPoint &point : points)
      {
        const ContactState now = state(point, solution, u_start);
        const Decision     decision =
          decide(point, now.p_trial, now.q_trial, moving_bound);
        n_changes += !(decision == point.decision);
        if (keep)
          point.decision = decision;
      }
    return n_changes;
  }



  const ContactPoint *
  ContactInterface::decide_one(const Vector<double> &solution,
                               const Vector<double> &u_start,
                               const bool            moving_bound)
  {
    for (ContactPoint &point : points)
      {
        const ContactState now = state(point, solution, u_start);
        const Decision     decision =
          decide(point, now.p_trial, now.q_trial, moving_bound);
        if (decision == point.decision)
          continue;
        point.decision = decision;
        // A bound that was frozen while the point was under pressure may leave
        // it no solution: open it penetrates, closed and held it is pulled.
        if (decision.status == Status::open)
          point.tresca_bound = law.bound(0);
        return &point;
      }
    return nullptr;
  }



  void ContactInterface::open_parted(const Vector<double> &solution)
  {
    for (ContactPoint &point : points)
      if (!tied && state(point, solution, solution).p_trial <= 0)
        point.decision = Decision();
  }



  std::vector<Decision> ContactInterface::decisions() const
  {
    std::vector<Decision> all;
    for (const ContactPoint &point : points)
      all.push_back(point.decision);
    return all;
  }



  void ContactInterface::set_decisions(const std::vector<Decision> &all)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].decision = all[q];
  }



  std::vector<signed char> ContactInterface::signature() const
  {
    std::vector<signed char> signature;
    for (const ContactPoint &point : points)
      signature.push_back(point.decision.code());
    return signature;
  }



  StatusCount ContactInterface::count() const
  {
    StatusCount count;
    for (const ContactPoint &point : points)
      {
        count.active += point.decision.status != Status::open;
        count.stick += point.decision.status == Status::stick;
      }
    return count;
  }



  double ContactInterface::constraint_norm(const Vector<double> &rhs) const
  {
    // Every multiplier has a point of its own surroundings: the last one wins.
    std::vector<double> stiffness(multipliers.n_multipliers, 0.);
    for (const ContactPoint &point : points)
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        stiffness[point.multipliers[k]] =
          point.complementarity / complementarity_per_stiffness;

    double square = 0;
    for (unsigned int k = 0; k < multipliers.n_multipliers; ++k)
      {
        square += std::pow(stiffness[k] * rhs[normal_index(k)], 2);
        if (!law.is_frictionless())
          square += std::pow(stiffness[k] * rhs[tangential_index(k)], 2);
      }
    return std::sqrt(square);
  }



  void ContactInterface::collect_unknowns(
    const ContactPoint                   &point,
    std::vector<types::global_dof_index> &unknowns) const
  {
    unknowns.clear();
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (const auto dof : point.dofs[a])
        unknowns.push_back(dof);
    for (unsigned int k = 0; k < point.n_multipliers; ++k)
      unknowns.push_back(normal_index(point.multipliers[k]));
    if (!law.is_frictionless())
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        unknowns.push_back(tangential_index(point.multipliers[k]));
  }



  void ContactInterface::add_couplings(DynamicSparsityPattern &pattern) const
  {
    std::vector<types::global_dof_index> unknowns;
    for (const ContactPoint &point : points)
      {
        collect_unknowns(point, unknowns);
        discretization.constraints.add_entries_local_to_global(
          unknowns,
          pattern,
          /*keep_constrained_entries=*/false);
      }
  }
} // namespace Contact
