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
     * The complementarity parameter of a point. The active set of the nodal
     * rule does not depend on it; with a status per Gauss point it enters the
     * discrete problem, and its scale is a thousandth of the stiffness of the
     * slave edge.
     */
    double complementarity(const double young, const double edge_length)
    {
      return 1e-3 * young / edge_length;
    }
  } // namespace



  ContactInterface::ContactInterface(const Discretization      &discretization,
                                     const Elasticity          &elasticity,
                                     const Parameters::Contact &parameters)
    : law{ parameters.tresca_limit, parameters.friction_coefficient }
    , slave(discretization,
            discretization.mesh.boundary(parameters.slave, "Contact/Slave"),
            parameters.slave)
    , master(discretization,
             discretization.mesh.boundary(parameters.master, "Contact/Master"),
             parameters.master)
    , discretization(discretization)
  {
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
        const auto &edge = slave.edges[point.slave_edge];
        point.complementarity =
          complementarity(std::min(elasticity.young(edge.body),
                                   elasticity.young(master.edges[0].body)),
                          slave.nodes[edge.nodes[0]].X.distance(
                            slave.nodes[edge.nodes[1]].X));
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



  void ContactInterface::initialize_status(const Vector<double> &u,
                                           const double          tolerance)
  {
    for (ContactPoint &point : points)
      {
        const auto  &edge = slave.edges[point.slave_edge].nodes;
        const double length =
          slave.nodes[edge[0]].X.distance(slave.nodes[edge[1]].X);
        const double gap = state(point, u, u).gap;
        if (point.facing && gap <= tolerance * length)
          point.status =
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
          point.status == Status::open
            ? law.bound(0)
            : law.bound(state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.tresca_bound));
        largest = std::max(largest, bound);
        point.tresca_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  unsigned int ContactInterface::update_status(const Vector<double> &solution,
                                               const Vector<double> &u_start,
                                               const bool newton_friction)
  {
    unsigned int n_changes = 0;
    for (ContactPoint &point : points)
      {
        const ContactState now       = state(point, solution, u_start);
        Status             status    = Status::open;
        int                direction = 0;
        if (point.facing && now.p_trial > 0)
          {
            const double bound =
              newton_friction ? law.bound(now.p_trial) : point.tresca_bound;
            const bool sticks =
              can_stick(point) && std::abs(now.q_trial) <= bound;
            status = sticks ? Status::stick : Status::slip;
            if (can_stick(point) && !sticks)
              direction = now.q_trial > 0 ? 1 : -1;
          }
        if (status != point.status || direction != point.slip_direction)
          ++n_changes;
        point.status         = status;
        point.slip_direction = direction;
      }
    return n_changes;
  }



  StatusCount ContactInterface::count() const
  {
    StatusCount count;
    for (const ContactPoint &point : points)
      {
        count.active += point.status != Status::open;
        count.stick += point.status == Status::stick;
      }
    return count;
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



  /// A point's unknowns, its residual, and the rows of derivatives of which
  /// the tangent is made.
  struct ContactInterface::LocalSystem
  {
    using Row = std::array<double,
                           2 * ContactPoint::max_nodes +
                             2 * ContactPoint::max_multipliers>;

    std::vector<types::global_dof_index> unknowns;
    FullMatrix<double>                   matrix;
    Vector<double>                       residual;
  };



  // With tau = d x_m/d xi, kappa = d^2 x_m/d xi^2, m = |tau| and the gap g, the
  // foot of the normal moves as
  //   (m^2 - g n.kappa) d_xi = tau . sum C_a du_a - g n . sum C1_a du_a
  // (C1 carries the minus of the master side), the edge turns by
  //   omega = n . d_tau / m,  d_n = -omega t,  d_t = omega n.
  void ContactInterface::assemble_point(const ContactPoint   &point,
                                        const Vector<double> &solution,
                                        const Vector<double> &u_start,
                                        const Linearization  &linearization,
                                        LocalSystem          &local) const
  {
    using Row = LocalSystem::Row;

    collect_unknowns(point, local.unknowns);
    const unsigned int n_u = 2 * point.n_nodes;
    const unsigned int n_m = point.n_multipliers;
    const unsigned int n   = local.unknowns.size();
    local.matrix.reinit(n, n);
    local.residual.reinit(n);

    const ContactState  now      = state(point, solution, u_start);
    const bool          contact  = point.status != Status::open;
    const bool          friction = !law.is_frictionless();
    const double        c        = point.complementarity;
    const Tensor<1, 2> &normal   = point.normal;
    const Tensor<1, 2> &tangent  = point.tangent;

    // The derivatives of gap and slip, and of the moving geometry.
    Row d_gap{}, d_slip{}, d_xi{}, omega{};
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          d_gap[2 * a + i]  = point.C[a] * normal[i];
          d_slip[2 * a + i] = point.C[a] * tangent[i];
        }

    const bool moving = linearization.moving_geometry && contact;
    if (moving)
      {
        Tensor<1, 2> kappa, d_r, d_r1;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double u  = solution[point.dofs[a][i]];
              const double du = u - u_start[point.dofs[a][i]];
              kappa[i] -= point.C2[a] * (point.X[a][i] + u);
              d_r[i] += point.C[a] * du;
              d_r1[i] += point.C1[a] * du;
            }
        const double slope =
          point.metric * point.metric - now.gap * (normal * kappa);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            {
              const unsigned int j = 2 * a + i;
              d_xi[j]              = (point.metric * tangent[i] * point.C[a] -
                         now.gap * normal[i] * point.C1[a]) /
                        slope;
              omega[j] =
                (-point.C1[a] * normal[i] + (normal * kappa) * d_xi[j]) /
                point.metric;
            }
        for (unsigned int j = 0; j < n_u; ++j)
          d_slip[j] += (normal * d_r) * omega[j] + (tangent * d_r1) * d_xi[j];
      }

    // The tractions and their derivatives.
    double p = 0, q = 0;
    Row    d_p{}, d_q{};
    if (contact)
      {
        p = now.p_trial;
        for (unsigned int j = 0; j < n_u; ++j)
          d_p[j] = -c * d_gap[j];
        for (unsigned int k = 0; k < n_m; ++k)
          d_p[n_u + k] = point.psi[k];
      }
    if (point.status == Status::stick)
      {
        q = now.q_trial;
        for (unsigned int j = 0; j < n_u; ++j)
          d_q[j] = -c * d_slip[j];
        for (unsigned int k = 0; k < n_m; ++k)
          d_q[n_u + n_m + k] = point.psi[k];
      }
    else if (point.slip_direction != 0)
      {
        if (linearization.moving_bound)
          {
            q = point.slip_direction * law.bound(p);
            for (unsigned int j = 0; j < n_u + n_m; ++j)
              d_q[j] = point.slip_direction * law.bound_derivative(p) * d_p[j];
          }
        else
          q = point.slip_direction * point.tresca_bound;
      }

    // The forces on the nodes.
    const double w = point.weight;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double       traction = p * normal[i] + q * tangent[i];
          const double       turned   = q * normal[i] - p * tangent[i];
          const unsigned int row      = 2 * a + i;
          local.residual[row]         = -w * traction * point.C[a];
          for (unsigned int j = 0; j < n; ++j)
            local.matrix(row, j) =
              -w * (d_p[j] * normal[i] + d_q[j] * tangent[i]) * point.C[a];
          if (moving)
            for (unsigned int j = 0; j < n_u; ++j)
              local.matrix(row, j) -= w * (turned * point.C[a] * omega[j] +
                                           traction * point.C1[a] * d_xi[j]);
        }

    // The constraints.
    for (unsigned int k = 0; k < n_m; ++k)
      {
        const double w_k        = w * point.psi[k] / c;
        local.residual[n_u + k] = w_k * (p - now.lambda_n);
        for (unsigned int j = 0; j < n; ++j)
          local.matrix(n_u + k, j) = w_k * d_p[j];
        for (unsigned int l = 0; l < n_m; ++l)
          local.matrix(n_u + k, n_u + l) -= w_k * point.psi[l];

        if (friction)
          {
            const unsigned int row = n_u + n_m + k;
            local.residual[row]    = w_k * (q - now.lambda_t);
            for (unsigned int j = 0; j < n; ++j)
              local.matrix(row, j) = w_k * d_q[j];
            for (unsigned int l = 0; l < n_m; ++l)
              local.matrix(row, n_u + n_m + l) -= w_k * point.psi[l];
          }
      }
  }



  void ContactInterface::assemble(const Vector<double> &solution,
                                  const Vector<double> &u_start,
                                  const Linearization  &linearization,
                                  SparseMatrix<double> &matrix,
                                  Vector<double>       &residual) const
  {
    LocalSystem local;
    for (const ContactPoint &point : points)
      {
        assemble_point(point, solution, u_start, linearization, local);
        discretization.constraints.distribute_local_to_global(local.matrix,
                                                              local.residual,
                                                              local.unknowns,
                                                              matrix,
                                                              residual);
      }
  }
} // namespace Contact
