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
  namespace
  {
    /**
     * The complementarity parameter of a point, relative to the stiffness E/h
     * of its slave edge. The active set of the nodal rule does not depend on
     * it; with a status per Gauss point it enters the discrete problem, whose
     * results move by 1e-4 over the two decades to either side.
     */
    const double complementarity_per_stiffness = 1e-3;
  } // namespace



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
        const auto  &edge  = slave.edges[point.slave_edge];
        const double young = std::min(elasticity.young(edge.body),
                                      elasticity.young(master.edges[0].body));
        const double length =
          slave.nodes[edge.nodes[0]].X.distance(slave.nodes[edge.nodes[1]].X);
        point.complementarity = complementarity_per_stiffness * young / length;
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



  std::vector<double> ContactInterface::places() const
  {
    std::vector<Point<2>> X;
    for (const Surface::Node &node : slave.nodes)
      X.push_back(node.X);
    auto         places = slave.arc_length(X);
    const double length = places.back();
    for (double &place : places)
      place /= length;
    return places;
  }



  ContactInterface::SurfaceState
  ContactInterface::save(const Vector<double> &solution) const
  {
    const auto   all_places = places();
    SurfaceState state;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      {
        const unsigned int k = multipliers.of_node[i];
        if (k == numbers::invalid_unsigned_int)
          continue;
        state.place.push_back(all_places[i]);
        state.pressure.push_back(solution[normal_index(k)]);
        state.shear.push_back(
          law.is_frictionless() ? 0. : solution[tangential_index(k)]);
        state.bound.push_back(points[k].tresca_bound);
        state.decisions.push_back(points[k].decision);
      }
    return state;
  }



  namespace
  {
    /**
     * Where between a point @p last in contact and an open one beside it,
     * @p open, the contact ends. Between smooth bodies p^2 falls to zero there
     * with a finite slope, as in Hertz' solution: the parabola of p^2 through
     * three points is extrapolated. They are two apart, so that with elements
     * of degree 2 they are of one kind, and not the very last ones, which the
     * end within their support disturbs. Without as many points: the middle.
     */
    double end_of_contact(const ContactInterface::SurfaceState &state,
                          const unsigned int                    last,
                          const unsigned int                    open)
    {
      const int             inward = last < open ? -2 : 2;
      const int             n      = state.place.size();
      std::array<double, 3> s{}, f{};
      double                end = 0.5 * (state.place[last] + state.place[open]);
      for (int k = 0; k < 3; ++k)
        {
          const int i = static_cast<int>(last) + (k + 1) * inward;
          if (i < 0 || i >= n || !(state.pressure[i] > 0))
            return end;
          s[k] = state.place[i];
          f[k] = std::pow(state.pressure[i], 2);
        }

      // Newton's form of the parabola, and Newton's method for its root.
      const double d01  = (f[1] - f[0]) / (s[1] - s[0]);
      const double d12  = (f[2] - f[1]) / (s[2] - s[1]);
      const double d012 = (d12 - d01) / (s[2] - s[0]);
      for (unsigned int iteration = 0; iteration < 10; ++iteration)
        end -= (f[0] + (end - s[0]) * (d01 + d012 * (end - s[1]))) /
               (d01 + d012 * (2 * end - s[0] - s[1]));

      const auto [low, high] =
        std::minmax({state.place[last], state.place[open]});
      return end >= low && end <= high ? end : (end < low ? low : high);
    }
  } // namespace



  // Values are interpolated; a decision is that of the nearer point, but that
  // the end of the contact is looked for between the points.
  void ContactInterface::restore(const SurfaceState &state,
                                 Vector<double>     &solution)
  {
    const auto all_places = places();
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      {
        const unsigned int k = multipliers.of_node[i];
        if (k == numbers::invalid_unsigned_int)
          continue;
        const auto above = std::lower_bound(state.place.begin(),
                                            state.place.end(),
                                            all_places[i]);
        const auto n     = state.place.size();
        const auto b =
          std::min<std::size_t>(above - state.place.begin(), n - 1);
        const auto   a = b == 0 ? b : b - 1;
        const double x =
          a == b ? 0.
                 : std::min(1.,
                            std::max(0.,
                                     (all_places[i] - state.place[a]) /
                                       (state.place[b] - state.place[a])));
        const auto between = [&](const std::vector<double> &values) {
          return (1 - x) * values[a] + x * values[b];
        };

        solution[normal_index(k)] = between(state.pressure);
        if (!law.is_frictionless())
          solution[tangential_index(k)] = between(state.shear);
        points[k].tresca_bound = between(state.bound);
        points[k].decision     = state.decisions[x < 0.5 ? a : b];
        const bool a_is_open   = state.decisions[a].status == Status::open;
        const bool b_is_open   = state.decisions[b].status == Status::open;
        if (a_is_open != b_is_open)
          {
            const double end   = b_is_open ? end_of_contact(state, a, b)
                                           : end_of_contact(state, b, a);
            points[k].decision = state.decisions[all_places[i] < end ? a : b];
          }
        if (!points[k].facing)
          points[k].decision = Decision();
        else if (points[k].decision.status == Status::stick &&
                 !can_stick(points[k]))
          points[k].decision = {Status::slip, 0};
      }
  }



  void ContactInterface::initialize_status(const Vector<double> &u)
  {
    for (ContactPoint &point : points)
      {
        const auto  &edge = slave.edges[point.slave_edge].nodes;
        const double length =
          slave.nodes[edge[0]].X.distance(slave.nodes[edge[1]].X);
        const double gap = state(point, u, u).gap;
        if (point.facing && gap <= 0.01 * length)
          point.decision.status =
            can_stick(point) ? Status::stick : Status::slip;
      }
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
