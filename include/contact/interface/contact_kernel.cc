/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The kernel of ContactInterface: what a point adds to the linear system.

#include "contact/interface/contact_kernel.h"

#include "contact/interface/pairing_motion.h"

namespace Contact
{
  namespace
  {
    /// Call @p visit with the place of each free motion among the unknowns of a
    /// point, with what makes of a row over these its entry there, and with the
    /// number of the motion: that the master moves is that the nodes of the
    /// slave move the other way.
    template<int dim, typename Visit>
    void for_free_motions(const ContactInterface<dim> &interface,
                          const ContactPoint<dim>     &point,
                          const Visit                 &visit)
    {
      const unsigned int first = interface.contact_pair(point).first_motion;
      unsigned int       place =
        dim * point.n_nodes +
        (interface.has_friction(point) ? dim : 1) * point.n_multipliers;
      for (unsigned int k = 0; k < point.motions.size(); ++k)
        if (!interface.motions.free[first + k]->stays)
          visit(
            place++,
            [&](const auto &row) {
              double sum = 0;
              for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
                for (unsigned int i = 0; i < dim; ++i)
                  sum -= point.motions[k].way[i] * row(dim * a + i);
              return sum;
            },
            first + k);
    }



    /// In 2-D an obstacle under a moment takes the loads with it as it
    /// turns, and its moment changes with their arms.
    void add_turning_loads(const ContactInterface<2> &interface,
                           const ContactPoint<2>     &point,
                           const Vector<double>      &residual,
                           FullMatrix<double>        &matrix)
    {
      const auto turned = [&](const unsigned int k) {
        return k % 2 == 0 ? -residual[k + 1] : residual[k - 1];
      };
      for_free_motions(
        interface,
        point,
        [&](const unsigned int j, const auto &, const unsigned int motion) {
          if (!interface.motions.free[motion]->rotates)
            return;
          for (unsigned int k = 0; k < 2 * point.n_slave_nodes; ++k)
            {
              matrix(k, j) += turned(k);
              matrix(j, k) += turned(k);
            }
          for_free_motions(interface,
                           point,
                           [&](const unsigned int i,
                               const auto        &node_by_way,
                               const unsigned int) {
                             matrix(i, j) += node_by_way(turned);
                             if (i != j)
                               matrix(j, i) += node_by_way(turned);
                           });
        });
    }

    void add_turning_loads(const ContactInterface<3> &,
                           const ContactPoint<3> &,
                           const Vector<double> &,
                           FullMatrix<double> &)
    {
    }
  } // namespace



  template<int dim>
  void ContactKernel<dim>::rows(const ContactPoint<dim>    &point,
                                const GhostedVector        &solution,
                                const GhostedVector        &u_start,
                                const ContactLinearization &linearization,
                                Rows                       &rows) const
  {
    rows.unknowns          = interface.unknowns_of(point);
    const unsigned int n_u = dim * point.n_nodes;
    const unsigned int n_m = point.n_multipliers;
    rows.p_trial.reinit(rows.unknowns.size());
    rows.load_p.reinit(rows.unknowns.size());
    for (unsigned int t = 0; t < dim - 1; ++t)
      {
        rows.q_trial[t].reinit(rows.unknowns.size());
        rows.load_q[t].reinit(rows.unknowns.size());
      }

    const double c = point.augmentation_parameter;
    const double w = point.weight;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const unsigned int j = dim * a + i;
          rows.p_trial[j]      = -c * point.C[a] * point.normal[i];
          rows.load_p[j]       = -w * point.C[a] * point.normal[i];
          if (interface.has_friction(point))
            for (unsigned int t = 0; t < dim - 1; ++t)
              {
                rows.q_trial[t][j] = -c * point.C[a] * point.tangents[t][i];
                rows.load_q[t][j]  = -w * point.C[a] * point.tangents[t][i];
              }
        }
    interface.discretization.counters.tangential_rows +=
      interface.has_friction(point);
    for (unsigned int k = 0; k < n_m; ++k)
      {
        rows.p_trial[n_u + k] = point.psi[k];
        rows.load_p[n_u + k]  = w * point.psi[k] / c;
        if (interface.has_friction(point))
          for (unsigned int t = 0; t < dim - 1; ++t)
            {
              const unsigned int j = n_u + (1 + t) * n_m + k;
              rows.q_trial[t][j]   = point.psi[k];
              rows.load_q[t][j]    = w * point.psi[k] / c;
            }
      }

    if (linearization.moving_geometry && !interface.contact_pair(point).tied)
      {
        // Systems in 3-D pair the points before each step.
        AssertThrow(dim == 2, ExcNotImplemented());
        if constexpr (dim == 2)
          PairingMotion(interface, point, solution, u_start)
            .add_to_trial_values(rows.p_trial, rows.q_trial[0]);
      }
    for_free_motions(interface,
                     point,
                     [&](const unsigned int j,
                         const auto        &node_by_way,
                         const unsigned int) {
                       rows.p_trial[j] = node_by_way(rows.p_trial);
                       rows.load_p[j]  = node_by_way(rows.load_p);
                       for (unsigned int t = 0; t < dim - 1; ++t)
                         {
                           rows.q_trial[t][j] = node_by_way(rows.q_trial[t]);
                           rows.load_q[t][j]  = node_by_way(rows.load_q[t]);
                         }
                     });
    if (point.elastic_slip > 0 || point.is_in_an_edge)
      follow_springs(point, interface.state(point, solution, u_start), rows);
  }



  // The change of kappa does nothing where a point sticks.
  template<int dim>
  void ContactKernel<dim>::follow_springs(const ContactPoint<dim> &point,
                                          const ContactState<dim> &now,
                                          Rows                    &rows) const
  {
    const unsigned int n_m   = point.n_multipliers;
    const unsigned int first = dim * point.n_nodes + n_m;
    if (!now.is_elastic)
      {
        const Tensor<2, dim - 1> compliance = point.stick_compliance();
        for (unsigned int t = 0; t < dim - 1; ++t)
          for (unsigned int s = 0; s < dim - 1; ++s)
            for (unsigned int k = 0; k < n_m; ++k)
              rows.q_trial[t][first + s * n_m + k] -=
                compliance[t][s] * point.psi[k];
        return;
      }
    const auto   elastic = interface.elastic_shear(point, now);
    const double by_p =
      interface.bounds.law(point).bound_derivative(now.p_trial);
    const double softer =
      elastic.kappa * elastic.stiffness / point.augmentation_parameter;
    for (unsigned int t = 0; t < dim - 1; ++t)
      for (unsigned int j = 0; j < rows.unknowns.size(); ++j)
        {
          const bool is_shear = j >= first && j < first + (dim - 1) * n_m;
          rows.q_trial[t][j] *= is_shear ? 1 - elastic.kappa : softer;
          rows.q_trial[t][j] +=
            elastic.kappa * by_p * elastic.zeta[t] * rows.p_trial[j];
        }
  }



  template<int dim>
  template<typename Visit>
  void ContactKernel<dim>::for_constraints(const ContactPoint<dim> &point,
                                           const Visit             &visit) const
  {
    const unsigned int n_u   = dim * point.n_nodes;
    const unsigned int n_m   = point.n_multipliers;
    const double       scale = point.weight / point.augmentation_parameter;
    for (unsigned int k = 0; k < n_m; ++k)
      for (unsigned int b = 0; b < (interface.has_friction(point) ? dim : 1);
           ++b)
        visit(n_u + b * n_m + k, k, b, scale);
  }



  // The constraints w psi_k (p - lambda)/c = 0 take the multipliers off.
  template<int dim>
  void ContactKernel<dim>::assemble_residual(const ContactPoint<dim> &point,
                                             const ContactState<dim> &now,
                                             const Traction<dim>     &t,
                                             const Rows              &rows,
                                             Vector<double> &residual) const
  {
    const unsigned int n = rows.unknowns.size();
    residual.reinit(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        residual[i] = t.p * rows.load_p[i] + t.q[0] * rows.load_q[0][i];
        for (unsigned int k = 1; k < dim - 1; ++k)
          residual[i] += t.q[k] * rows.load_q[k][i];
      }
    for_constraints(point,
                    [&](const unsigned int row,
                        const unsigned int k,
                        const unsigned int b,
                        const double       scale) {
                      const double lambda =
                        b == 0 ? now.lambda_n : now.lambda_t[b - 1];
                      residual[row] -= scale * point.psi[k] * lambda;
                    });
  }



  template<int dim>
  void
  ContactKernel<dim>::assemble_matrix(const ContactPoint<dim>    &point,
                                      const GhostedVector        &solution,
                                      const GhostedVector        &u_start,
                                      const ContactLinearization &linearization,
                                      const Traction<dim>        &t,
                                      const Rows                 &rows,
                                      const Vector<double>       &residual,
                                      FullMatrix<double>         &matrix) const
  {
    const unsigned int n   = rows.unknowns.size();
    const unsigned int n_m = point.n_multipliers;
    matrix.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        double by_p = t.dp_dp * rows.load_p[i] + t.dq_dp[0] * rows.load_q[0][i];
        for (unsigned int k = 1; k < dim - 1; ++k)
          by_p += t.dq_dp[k] * rows.load_q[k][i];
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = by_p * rows.p_trial[j];
        for (unsigned int k = 0; k < dim - 1; ++k)
          for (unsigned int l = 0; l < dim - 1; ++l)
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) +=
                t.dq_dq[k][l] * rows.load_q[k][i] * rows.q_trial[l][j];
      }
    for_constraints(point,
                    [&](const unsigned int row,
                        const unsigned int k,
                        const unsigned int,
                        const double scale) {
                      for (unsigned int l = 0; l < n_m; ++l)
                        matrix(row, row - k + l) -=
                          scale * point.psi[k] * point.psi[l];
                    });

    const bool acts =
      point.status.kind != Status::open || !point.change.dofs.empty();
    if (linearization.moving_geometry && !interface.contact_pair(point).tied &&
        acts)
      {
        if constexpr (dim == 2)
          PairingMotion(interface, point, solution, u_start)
            .add_to_tangent(t, residual, matrix);
        for_free_motions(
          interface,
          point,
          [&](const unsigned int j,
              const auto        &node_by_way,
              const unsigned int) {
            for (unsigned int i = 0; i < n; ++i)
              matrix(i, j) =
                node_by_way([&](const unsigned int k) { return matrix(i, k); });
            for (unsigned int i = 0; i < n; ++i)
              matrix(j, i) =
                node_by_way([&](const unsigned int k) { return matrix(k, i); });
          });
        add_turning_loads(interface, point, residual, matrix);
      }
  }



  template<int dim>
  void ContactKernel<dim>::assemble(const GhostedVector        &solution,
                                    const GhostedVector        &u_start,
                                    const ContactLinearization &linearization,
                                    GhostedVector              &rhs,
                                    SparseMatrix<double>       *matrix) const
  {
    const auto        &constraints = interface.discretization.constraints;
    Rows               rows;
    FullMatrix<double> local_matrix;
    Vector<double>     local_rhs, none;
    Vector<double>    &whole = matrix != nullptr ? rhs : none;
    for (const auto q : interface.own_points())
      {
        const ContactPoint<dim> &point = interface.points()[q];
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Traction<dim>     t   = interface.active_set.traction(point, now);
        this->rows(point, solution, u_start, linearization, rows);
        assemble_residual(point, now, t, rows, local_rhs);
        if (matrix != nullptr)
          assemble_matrix(point,
                          solution,
                          u_start,
                          linearization,
                          t,
                          rows,
                          local_rhs,
                          local_matrix);
        local_rhs *= -1;
        if (matrix == nullptr)
          constraints.distribute_local_to_global(local_rhs, rows.unknowns, rhs);
        else
          constraints.distribute_local_to_global(local_matrix,
                                                 local_rhs,
                                                 rows.unknowns,
                                                 *matrix,
                                                 whole);
      }
    const bool is_first = Utilities::MPI::this_mpi_process(
                            interface.discretization.communicator) == 0;
    for (unsigned int k = 0; k < interface.motions.free.size(); ++k)
      {
        const FreeMotion &motion = *interface.motions.free[k];
        const auto        index  = interface.motions.index(k);
        if (!motion.stays && is_first)
          rhs[index] += motion.force;
        if (matrix == nullptr)
          continue;
        interface.discretization.counters.free_motions += !motion.stays;
        matrix->diag_element(index) +=
          motion.stays ? 1 : interface.motions.spring(motion);
      }
  }

  template class ContactKernel<2>;
  template class ContactKernel<3>;
} // namespace Contact
