/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/pairing_stiffness.h"

namespace Contact
{
  template<int dim>
  std::vector<PairingStiffness<dim>>
  PairingStiffness<dim>::terms(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start)
  {
    std::vector<PairingStiffness<dim>> all;
    const IndexSet                    &owned =
      interface.discretization.dof_handler.locally_owned_dofs();
    for (const ContactPoint<dim> &point : interface.points())
      {
        const PairingChange<dim> &change = point.change;
        if (point.status.kind == Status::open || change.dofs.empty() ||
            !owned.is_element(point.dofs[0][0]))
          continue;
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Tensor<1, dim>    traction =
          now.lambda_n * point.normal + point.along_tangents(now.lambda_t);
        all.emplace_back();
        PairingStiffness<dim> &term = all.back();
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          term.rows.insert(term.rows.end(),
                           point.dofs[a].begin(),
                           point.dofs[a].end());
        term.columns = change.dofs;
        term.stiffness.reinit(term.rows.size(), term.columns.size());
        for (unsigned int j = 0; j < term.columns.size(); ++j)
          {
            const Tensor<1, dim> turned =
              now.lambda_n * point.along_tangents(change.turn[j]) -
              (now.lambda_t * change.turn[j]) * point.normal;
            for (unsigned int a = 0; a < point.n_nodes; ++a)
              for (unsigned int i = 0; i < dim; ++i)
                term.stiffness(dim * a + i, j) =
                  -point.weight *
                  (change.C(a, j) * traction[i] + point.C[a] * turned[i]);
          }
      }
    return all;
  }

  template struct PairingStiffness<2>;
  template struct PairingStiffness<3>;
} // namespace Contact
