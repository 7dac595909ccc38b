/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact_interface.h"

#include <deal.II/lac/full_matrix.h>

#include "errors.h"

namespace Contact
{
  namespace
  {
    /**
     * The complementarity parameter of a point, relative to the stiffness E/h
     * of its slave edge. The active set of the nodal rule does not depend on
     * it; with a status per Gauss point it enters the discrete problem, whose
     * results do not change any more from about this value down.
     */
    const double complementarity_per_stiffness = 1e-3;
  } // namespace



  ContactInterface::ContactInterface(const Discretization      &discretization,
                                     const Elasticity          &elasticity,
                                     const Parameters::Contact &parameters)
    : law{parameters.tresca_limit, parameters.friction_coefficient}
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

    points =
      parameters.rule == "nodal"
        ? make_nodal_points(slave, excluded, multipliers)
        : make_gauss_points(slave, parameters.n_gauss_points, multipliers);

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
          r[i] += point.C[a] * (point.X[a][i] + u);
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
    if (!point.facing || p_trial <= 0)
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



  /// How foot point and edge of a contact point move with the bodies.
  struct ContactInterface::Motion
  {
    using Row = std::array<double, 2 * ContactPoint::max_nodes>;

    Row    d_xi{};       // of the foot's coordinate
    Row    omega{};      // rotation: d_n = -omega t, d_t = omega n
    double slip_normal;  // n . sum C_a (u_a - start)
    double slip_stretch; // t . sum C1_a (u_a - start)
  };



  // With tau = d x_m/d xi, kappa = d^2 x_m/d xi^2, m = |tau| and the gap g, the
  // foot of the normal moves as
  //   (m^2 - g n.kappa) d_xi = tau . sum C_a du_a - g n . sum C1_a du_a
  // (C1 carries the minus of the master side), and the edge turns by
  //   omega = n . d_tau / m.
  ContactInterface::Motion
  ContactInterface::motion(const ContactPoint   &point,
                           const Vector<double> &solution,
                           const Vector<double> &u_start) const
  {
    Tensor<1, 2> kappa, r, d_r, d_r1;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double u = solution[point.dofs[a][i]];
          const double x = point.X[a][i] + u;
          const double d = u - u_start[point.dofs[a][i]];
          kappa[i] -= point.C2[a] * x;
          r[i] += point.C[a] * x;
          d_r[i] += point.C[a] * d;
          d_r1[i] += point.C1[a] * d;
        }
    const double gap   = point.normal * r;
    const double curve = point.normal * kappa;
    const double slope = point.metric * point.metric - gap * curve;

    Motion motion;
    motion.slip_normal  = point.normal * d_r;
    motion.slip_stretch = point.tangent * d_r1;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int j = 2 * a + i;
          if (!point.foot_is_clipped)
            motion.d_xi[j] = (point.metric * point.tangent[i] * point.C[a] -
                              gap * point.normal[i] * point.C1[a]) /
                             slope;
          motion.omega[j] =
            (curve * motion.d_xi[j] - point.C1[a] * point.normal[i]) /
            point.metric;
        }
    return motion;
  }



  void ContactInterface::rows(const ContactPoint   &point,
                              const Vector<double> &solution,
                              const Vector<double> &u_start,
                              const Linearization  &linearization,
                              Rows                 &rows) const
  {
    collect_unknowns(point, rows.unknowns);
    const unsigned int n_u = 2 * point.n_nodes;
    const unsigned int n_m = point.n_multipliers;
    for (auto *row : {&rows.p_trial, &rows.q_trial, &rows.load_p, &rows.load_q})
      row->reinit(rows.unknowns.size());

    const double c = point.complementarity;
    const double w = point.weight;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int j = 2 * a + i;
          rows.p_trial[j]      = -c * point.C[a] * point.normal[i];
          rows.q_trial[j]      = -c * point.C[a] * point.tangent[i];
          rows.load_p[j]       = -w * point.C[a] * point.normal[i];
          rows.load_q[j]       = -w * point.C[a] * point.tangent[i];
        }
    for (unsigned int k = 0; k < n_m; ++k)
      {
        rows.p_trial[n_u + k] = point.psi[k];
        rows.load_p[n_u + k]  = w * point.psi[k] / c;
        if (!law.is_frictionless())
          {
            rows.q_trial[n_u + n_m + k] = point.psi[k];
            rows.load_q[n_u + n_m + k]  = w * point.psi[k] / c;
          }
      }

    if (linearization.moving_geometry && !law.is_frictionless())
      {
        const Motion moves = motion(point, solution, u_start);
        for (unsigned int j = 0; j < n_u; ++j)
          rows.q_trial[j] -= c * (moves.slip_normal * moves.omega[j] +
                                  moves.slip_stretch * moves.d_xi[j]);
      }
  }



  void ContactInterface::assemble_point(const ContactPoint   &point,
                                        const Vector<double> &solution,
                                        const Vector<double> &u_start,
                                        const Linearization  &linearization,
                                        Rows                 &rows,
                                        FullMatrix<double>   &matrix,
                                        Vector<double>       &residual) const
  {
    this->rows(point, solution, u_start, linearization, rows);
    const unsigned int n   = rows.unknowns.size();
    const unsigned int n_u = 2 * point.n_nodes;
    const unsigned int n_m = point.n_multipliers;

    const ContactState now = state(point, solution, u_start);
    const Traction     t   = traction(point,
                                point.decision,
                                now.p_trial,
                                now.q_trial,
                                linearization.moving_bound);

    matrix.reinit(n, n);
    residual.reinit(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        residual[i]       = t.p * rows.load_p[i] + t.q * rows.load_q[i];
        const double by_p = t.dp_dp * rows.load_p[i] + t.dq_dp * rows.load_q[i];
        const double by_q = t.dq_dq * rows.load_q[i];
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = by_p * rows.p_trial[j] + by_q * rows.q_trial[j];
      }

    // The constraints w psi_k (p - lambda)/c = 0 take the multipliers off.
    const double scale = point.weight / point.complementarity;
    for (unsigned int k = 0; k < n_m; ++k)
      for (unsigned int b = 0; b < (law.is_frictionless() ? 1 : 2); ++b)
        {
          const unsigned int row    = n_u + b * n_m + k;
          const double       lambda = b == 0 ? now.lambda_n : now.lambda_t;
          residual[row] -= scale * point.psi[k] * lambda;
          for (unsigned int l = 0; l < n_m; ++l)
            matrix(row, n_u + b * n_m + l) -=
              scale * point.psi[k] * point.psi[l];
        }

    // The loads turn and travel with the master edge.
    if (linearization.moving_geometry && point.decision.status != Status::open)
      {
        const Motion       moves  = motion(point, solution, u_start);
        const Tensor<1, 2> along  = t.p * point.normal + t.q * point.tangent;
        const Tensor<1, 2> turned = t.q * point.normal - t.p * point.tangent;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < n_u; ++j)
              matrix(2 * a + i, j) -=
                point.weight * (turned[i] * point.C[a] * moves.omega[j] +
                                along[i] * point.C1[a] * moves.d_xi[j]);
      }
  }



  void ContactInterface::assemble(const Vector<double> &solution,
                                  const Vector<double> &u_start,
                                  const Linearization  &linearization,
                                  Vector<double>       &rhs,
                                  SparseMatrix<double> *matrix) const
  {
    const auto        &constraints = discretization.constraints;
    Rows               rows;
    FullMatrix<double> local_matrix;
    Vector<double>     local_rhs;
    for (const ContactPoint &point : points)
      {
        assemble_point(point,
                       solution,
                       u_start,
                       linearization,
                       rows,
                       local_matrix,
                       local_rhs);
        local_rhs *= -1;
        if (matrix == nullptr)
          constraints.distribute_local_to_global(local_rhs, rows.unknowns, rhs);
        else
          constraints.distribute_local_to_global(local_matrix,
                                                 local_rhs,
                                                 rows.unknowns,
                                                 *matrix,
                                                 rhs);
      }
  }
} // namespace Contact
