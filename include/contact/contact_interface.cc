/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/contact_interface.h"

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <limits>


namespace Contact
{
  ContactInterface::ContactInterface(
    const Discretization                   &discretization,
    const Elasticity                       &elasticity,
    const std::vector<Parameters::Contact> &parameters)
    : discretization(discretization)
  {
    for (const Parameters::Contact &of_zone : parameters)
      {
        auto zone =
          std::make_unique<ContactZone>(discretization, elasticity, of_zone);
        const unsigned int first = tangential_number.size();
        for (ContactPoint &point : zone->make_points(first, points.size()))
          {
            point.zone = zones.size();
            points.push_back(std::move(point));
          }
        for (unsigned int k = 0; k < zone->multipliers.n_multipliers; ++k)
          tangential_number.push_back(zone->law.is_frictionless()
                                        ? numbers::invalid_unsigned_int
                                        : n_tangential++);
        zones.push_back(std::move(zone));
      }
  }



  ArrayView<const ContactPoint>
  ContactInterface::points_of(const ContactZone &zone) const
  {
    return {points.data() + zone.first_point, zone.n_points};
  }



  bool ContactInterface::is_tied() const
  {
    return std::all_of(zones.begin(), zones.end(), [](const auto &zone) {
      return zone->tied;
    });
  }



  bool ContactInterface::has_friction() const
  {
    return std::any_of(zones.begin(), zones.end(), [](const auto &zone) {
      return !zone->tied && !zone->law.is_frictionless();
    });
  }



  bool ContactInterface::has_coulomb_friction() const
  {
    return std::any_of(zones.begin(), zones.end(), [](const auto &zone) {
      return !zone->tied && zone->law.coulomb_coefficient > 0;
    });
  }



  unsigned int ContactInterface::n_multipliers() const
  {
    return n_normal_multipliers() + n_tangential;
  }



  unsigned int ContactInterface::n_normal_multipliers() const
  {
    return tangential_number.size();
  }



  types::global_dof_index
  ContactInterface::normal_index(const unsigned int k) const
  {
    return discretization.dof_handler.n_dofs() + k;
  }



  types::global_dof_index
  ContactInterface::tangential_index(const unsigned int k) const
  {
    return normal_index(n_normal_multipliers() + tangential_number[k]);
  }



  double ContactInterface::pressure(
    const std::vector<std::pair<unsigned int, double>> &multipliers,
    const Vector<double>                               &solution) const
  {
    double sum = 0;
    for (const auto &[k, factor] : multipliers)
      sum += factor * solution[normal_index(k)];
    // What is continued may not pull.
    return multipliers.size() > 1 ? std::max(0., sum) : sum;
  }



  bool ContactInterface::pair(const Vector<double> &u,
                              const bool            with_derivatives)
  {
    bool changed = false;
    for (const auto &zone : zones)
      changed = zone->pair({points.data() + zone->first_point, zone->n_points},
                           u,
                           with_derivatives) ||
                changed;
    return changed;
  }



  double ContactInterface::largest_misfit(const Vector<double> &u) const
  {
    double largest = 0;
    for (const ContactPoint &point : points)
      if (point.facing && !zone(point).tied)
        {
          const double gap = state(point, u, u).gap;
          largest =
            std::max(largest,
                     point.decision.status == Status::open ? -gap
                                                           : std::abs(gap));
        }
    return largest;
  }



  double ContactInterface::largest_change(const Vector<double> &u,
                                          const Vector<double> &from) const
  {
    double     change = 0;
    const auto look   = [&](const Surface &surface) {
      for (const Surface::Node &node : surface.nodes)
        for (const auto dof : node.dofs)
          change = std::max(change, std::abs(u[dof] - from[dof]));
    };
    for (const auto &zone : zones)
      {
        look(zone->slave);
        if (zone->master)
          look(*zone->master);
      }
    return change;
  }



  void ContactInterface::initialize_status(const Vector<double> &u)
  {
    for (ContactPoint &point : points)
      if (point.facing && !point.is_master_corner &&
          state(point, u, u).gap <= 0.01 * zone(point).edge_length(point))
        point.decision.status = can_stick(point) ? Status::stick : Status::slip;
  }



  void ContactInterface::close_nearest(const Vector<double> &u)
  {
    if (count().active > 0)
      return;
    double smallest = std::numeric_limits<double>::max();
    for (const ContactPoint &point : points)
      if (point.facing)
        smallest = std::min(smallest, state(point, u, u).gap);
    const auto close = [&](const bool corners) {
      for (ContactPoint &point : points)
        if (point.facing && point.is_master_corner == corners &&
            state(point, u, u).gap - smallest <=
              0.01 * zone(point).edge_length(point))
          point.decision.status =
            can_stick(point) ? Status::stick : Status::slip;
    };
    close(false);
    if (count().active == 0)
      close(true);
  }



  bool ContactInterface::can_stick(const ContactPoint &point) const
  {
    return has_friction(point) && !point.tangential_row_is_void;
  }



  ContactState ContactInterface::state(const ContactPoint   &point,
                                       const Vector<double> &solution,
                                       const Vector<double> &u_start) const
  {
    const bool   tied = zone(point).tied;
    Tensor<1, 2> r, dr;
    if (!tied)
      r -= point.foot;
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
          if (has_friction(point))
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
        if (zone(point).tied)
          continue;
        const FrictionLaw &law = zone(point).law;
        const double       bound =
          point.decision.status == Status::open
                  ? law.bound(0)
                  : law.bound(state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.tresca_bound));
        largest = std::max(largest, bound);
        point.tresca_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  void ContactInterface::raise_unknown_bounds()
  {
    for (ContactPoint &point : points)
      if (zone(point).law.coulomb_coefficient > 0 && point.tresca_bound == 0)
        point.tresca_bound = std::numeric_limits<double>::max();
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



  // Slip turns round by way of sticking: where all points of a body slip, none
  // would hold it, whichever way they do.
  Decision ContactInterface::decide(const ContactPoint &point,
                                    const Decision     &before,
                                    const double        p_trial,
                                    const double        q_trial,
                                    const bool          moving_bound) const
  {
    if (!point.facing || (!zone(point).tied && p_trial <= 0))
      return {Status::open, 0};
    if (!can_stick(point))
      return {Status::slip, 0};

    const double bound =
      moving_bound ? zone(point).law.bound(p_trial) : point.tresca_bound;
    const int direction = q_trial > 0 ? 1 : -1;
    if (std::abs(q_trial) <= bound || direction * before.slip_direction < 0)
      return {Status::stick, 0};
    return {Status::slip, direction};
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
        traction.q = decision.slip_direction * zone(point).law.bound(p_trial);
        traction.dq_dp =
          decision.slip_direction * zone(point).law.bound_derivative(p_trial);
      }
    else
      traction.q = decision.slip_direction * point.tresca_bound;
    return traction;
  }



  // From step to step a point knows its last decision: slip turns round by way
  // of sticking. Under bounds that are frozen the problem is convex, and slip
  // turns round at once.
  Decision ContactInterface::decision_in(const ContactPoint   &point,
                                         const Vector<double> &solution,
                                         const Vector<double> &u_start,
                                         const bool moving_bound) const
  {
    const ContactState now = state(point, solution, u_start);
    return decide(point,
                  moving_bound ? point.decision : Decision(),
                  now.p_trial,
                  now.q_trial,
                  moving_bound);
  }



  unsigned int ContactInterface::decide_all(const Vector<double> &solution,
                                            const Vector<double> &u_start,
                                            const bool            moving_bound,
                                            const bool            keep)
  {
    unsigned int n_changes = 0;
    for (ContactPoint &point : points)
      {
        const Decision decision =
          decision_in(point, solution, u_start, moving_bound);
        if (decision == point.decision)
          continue;
        ++n_changes;
        if (keep)
          point.decision = decision;
      }
    return n_changes;
  }



  void ContactInterface::decide_one(const Vector<double> &solution,
                                    const Vector<double> &u_start,
                                    const bool            moving_bound)
  {
    for (ContactPoint &point : points)
      {
        const Decision decision =
          decision_in(point, solution, u_start, moving_bound);
        if (decision == point.decision)
          continue;
        point.decision = decision;
        if (!moving_bound && decision.status == Status::open)
          drop_bound(&point - points.data());
        return;
      }
  }



  void ContactInterface::drop_bound(const unsigned int point)
  {
    points[point].tresca_bound = zone(points[point]).law.bound(0);
  }



  void ContactInterface::drop_bounds_of_open_points()
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].decision.status == Status::open)
        drop_bound(q);
  }



  void ContactInterface::open_parted(const Vector<double> &solution)
  {
    for (ContactPoint &point : points)
      if (!zone(point).tied && state(point, solution, solution).p_trial <= 0)
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
    std::vector<double> stiffness(n_normal_multipliers(), 0.);
    for (const ContactPoint &point : points)
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        stiffness[point.multipliers[k]] = zone(point).stiffness(point);

    double square = 0;
    for (unsigned int k = 0; k < stiffness.size(); ++k)
      {
        square += std::pow(stiffness[k] * rhs[normal_index(k)], 2);
        if (tangential_number[k] != numbers::invalid_unsigned_int)
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
    if (has_friction(point))
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        unknowns.push_back(tangential_index(point.multipliers[k]));
    const unsigned int n_own = 2 * point.n_nodes;
    for (const auto dof : point.change.dofs)
      if (std::find(unknowns.begin(), unknowns.begin() + n_own, dof) ==
          unknowns.begin() + n_own)
        unknowns.push_back(dof);
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
