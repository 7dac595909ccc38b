/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The kernel of ContactInterface: what a point adds to the linear system.

#include "contact_interface.h"
#include "counters.h"

namespace Contact
{
  /// How foot point and edge of a contact point move with the bodies.
  struct ContactInterface::Motion
  {
    // By unknown of the nodes: the foot's coordinate, and the rotation,
    // d_n = -omega t, d_t = omega n.
    std::vector<double> d_xi, omega;

    double offset;       // t . (x_slave - x_master): zero but over a corner
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
    Tensor<1, 2> kappa = point.foot_curvature, r = -point.foot, d_r, d_r1;
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
    motion.d_xi.resize(2 * point.n_nodes);
    motion.omega.resize(2 * point.n_nodes);
    motion.offset       = point.tangent * r;
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
          rows.load_p[j]       = -w * point.C[a] * point.normal[i];
          if (has_friction(point))
            {
              rows.q_trial[j] = -c * point.C[a] * point.tangent[i];
              rows.load_q[j]  = -w * point.C[a] * point.tangent[i];
            }
        }
    counters().tangential_rows += has_friction(point);
    for (unsigned int k = 0; k < n_m; ++k)
      {
        rows.p_trial[n_u + k] = point.psi[k];
        rows.load_p[n_u + k]  = w * point.psi[k] / c;
        if (has_friction(point))
          {
            rows.q_trial[n_u + n_m + k] = point.psi[k];
            rows.load_q[n_u + n_m + k]  = w * point.psi[k] / c;
          }
      }

    if (linearization.moving_geometry && !zone(point).tied)
      {
        const Motion moves = motion(point, solution, u_start);
        for (unsigned int j = 0; j < n_u; ++j)
          {
            rows.p_trial[j] += c * moves.offset * moves.omega[j];
            if (has_friction(point))
              rows.q_trial[j] -= c * (moves.slip_normal * moves.omega[j] +
                                      moves.slip_stretch * moves.d_xi[j]);
          }
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
      for (unsigned int b = 0; b < (has_friction(point) ? 2 : 1); ++b)
        {
          const unsigned int row    = n_u + b * n_m + k;
          const double       lambda = b == 0 ? now.lambda_n : now.lambda_t;
          residual[row] -= scale * point.psi[k] * lambda;
          for (unsigned int l = 0; l < n_m; ++l)
            matrix(row, n_u + b * n_m + l) -=
              scale * point.psi[k] * point.psi[l];
        }

    // The loads turn and travel with the master edge.
    if (linearization.moving_geometry && !zone(point).tied &&
        point.decision.status != Status::open)
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
