/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/pairing_motion.h"

#include <algorithm>
#include <numeric>

namespace Contact
{
  // With tau = d x_m/d xi, kappa = d^2 x_m/d xi^2, m = |tau| and the gap g, the
  // projection of the normal moves as
  //   (m^2 - g n.kappa) d_xi = tau . sum C_a du_a - g n . sum C1_a du_a
  // (C1 carries the minus of the master side), and the edge turns by
  //   omega = n . d_tau / m.
  // The mortar discretization brings derivatives of its own.
  PairingMotion::PairingMotion(const ContactInterface<2> &interface,
                               const ContactPoint<2>     &point,
                               const GhostedVector       &solution,
                               const GhostedVector       &u_start)
    : interface(interface)
    , point(point)
  {
    Tensor<1, 2> r   = -point.projection;
    Tensor<1, 2> d_r = point.interference_at_start - point.projection_motion;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double u = solution[point.dofs(a)[i]];
          r[i] += point.C[a] * (point.X(a)[i] + u);
          d_r[i] += point.C[a] * (u - u_start[point.dofs(a)[i]]);
        }

    if (point.change.dofs.empty())
      follow_projection(solution, r);
    else
      follow_change();
    // Of the gap and of the slip, what C, n and t make.
    const unsigned int n = columns.size();
    slip.resize(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        gap[j] -= (point.tangents[0] * r) * omega[j];
        slip[j] += (point.normal * d_r) * omega[j];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double u = solution[point.dofs(a)[i]];
              gap[j] += C(a, j) * point.normal[i] * (point.X(a)[i] + u);
              slip[j] += C(a, j) * point.tangents[0][i] *
                         (u - u_start[point.dofs(a)[i]]);
            }
      }
  }



  // The projection is on the edge however it moves: along it the gap does not
  // change.
  void PairingMotion::follow_projection(const GhostedVector &solution,
                                        const Tensor<1, 2>  &r)
  {
    Tensor<1, 2> kappa = point.projection_curvature;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        kappa[i] -= point.C2[a] * (point.X(a)[i] + solution[point.dofs(a)[i]]);
    const double distance = point.normal * r;
    const double curve    = point.normal * kappa;
    const double slope    = point.metric * point.metric - distance * curve;

    const unsigned int n = 2 * point.n_nodes;
    columns.resize(n);
    std::iota(columns.begin(), columns.end(), 0);
    C.reinit(point.n_nodes, n);
    weight.resize(n);
    omega.resize(n);
    gap.resize(n);
    slip.resize(n);
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int j    = 2 * a + i;
          double             d_xi = 0;
          if (!point.projection_is_clipped)
            d_xi = (point.metric * point.tangents[0][i] * point.C[a] -
                    distance * point.normal[i] * point.C1[a]) /
                   slope;
          omega[j] =
            (curve * d_xi - point.C1[a] * point.normal[i]) / point.metric;
          slip[j] = -point.projection_stretch * point.metric * d_xi;
          for (unsigned int b = 0; b < point.n_nodes; ++b)
            C(b, j) = point.C1[b] * d_xi;
        }
  }



  // Unknowns that are not of the point's own nodes come behind its multipliers.
  void PairingMotion::follow_change()
  {
    const auto unknowns = interface.unknowns_of(point);
    for (const auto dof : point.change.dofs)
      columns.push_back(std::find(unknowns.begin(), unknowns.end(), dof) -
                        unknowns.begin());
    C      = point.change.C;
    weight = point.change.weight;
    gap    = point.change.projection;
    for (const Tensor<1, 1> &rotation : point.change.rotation)
      omega.push_back(-rotation[0]);
    for (double &derivative : gap)
      derivative *= -1;
  }



  void PairingMotion::add_to_trial_values(Vector<double> &p_trial,
                                          Vector<double> &q_trial) const
  {
    const double c = point.augmentation_parameter;
    for (unsigned int j = 0; j < columns.size(); ++j)
      {
        p_trial[columns[j]] -= c * gap[j];
        if (interface.has_friction(point))
          q_trial[columns[j]] -= c * slip[j];
      }
  }



  // The loads turn and travel with the master edge.
  void PairingMotion::add_to_tangent(const Traction<2>    &t,
                                     const Vector<double> &residual,
                                     FullMatrix<double>   &matrix) const
  {
    const unsigned int n_u = 2 * point.n_nodes;
    const unsigned int n_constraints =
      (interface.has_friction(point) ? 2 : 1) * point.n_multipliers;
    const Tensor<1, 2> along  = t.p * point.normal + t.q[0] * point.tangents[0];
    const Tensor<1, 2> turned = t.q[0] * point.normal - t.p * point.tangents[0];
    for (unsigned int j = 0; j < columns.size(); ++j)
      {
        const unsigned int column = columns[j];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            matrix(2 * a + i, column) -=
              point.weight * (turned[i] * point.C[a] * omega[j] +
                              along[i] * (C(a, j) + point.C[a] * weight[j]));
        for (unsigned int k = n_u; k < n_u + n_constraints; ++k)
          matrix(k, column) += weight[j] * residual[k];
      }
  }
} // namespace Contact
