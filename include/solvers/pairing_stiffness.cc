/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/pairing_stiffness.h"

namespace Contact
{
  namespace
  {
    using Parts = std::vector<std::pair<types::global_dof_index, double>>;

    /// The unknowns, with their parts, that those of nodes that hang follow.
    /// The constraints of a process know them of its own cells and those
    /// beside.
    template<int dim>
    std::map<types::global_dof_index, Parts>
    leaders_of_hanging_nodes(const ContactInterface<dim> &interface)
    {
      std::map<types::global_dof_index, Parts> leaders;
      const auto add = [&](const Surface<dim> &surface) {
        for (unsigned int n = 0; n < surface.nodes.size(); ++n)
          if (!surface.leaders[n].empty())
            for (unsigned int i = 0; i < dim; ++i)
              {
                Parts &parts = leaders[surface.nodes[n].dofs[i]];
                parts.clear();
                for (const auto &[leader, part] : surface.leaders[n])
                  parts.emplace_back(surface.nodes[leader].dofs[i], part);
              }
      };
      for (const auto &contact_pair : interface.pairs)
        {
          add(contact_pair->slave);
          if (contact_pair->master)
            add(*contact_pair->master);
        }
      return leaders;
    }



    /// The columns of nodes that hang become parts of those that they follow.
    template<int dim>
    void
    hand_over_columns(const std::map<types::global_dof_index, Parts> &leaders,
                      PairingStiffness<dim>                          &term)
    {
      std::map<types::global_dof_index, unsigned int> number;
      const auto number_of = [&](const types::global_dof_index dof) {
        return number.emplace(dof, number.size()).first->second;
      };
      std::vector<std::vector<std::pair<unsigned int, double>>> parts;
      for (const auto dof : term.columns)
        {
          parts.emplace_back();
          if (const auto found = leaders.find(dof); found != leaders.end())
            for (const auto &[leader, part] : found->second)
              parts.back().emplace_back(number_of(leader), part);
          else
            parts.back().emplace_back(number_of(dof), 1.);
        }
      FullMatrix<double> stiffness(term.rows.size(), number.size());
      for (unsigned int j = 0; j < term.columns.size(); ++j)
        for (const auto &[column, part] : parts[j])
          for (unsigned int i = 0; i < term.rows.size(); ++i)
            stiffness(i, column) += part * term.stiffness(i, j);
      term.stiffness = stiffness;
      term.columns.resize(number.size());
      for (const auto &[dof, column] : number)
        term.columns[column] = dof;
    }
  } // namespace



  template<int dim>
  std::vector<PairingStiffness<dim>>
  PairingStiffness<dim>::terms(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start)
  {
    std::vector<PairingStiffness<dim>> all;
    const auto      leaders = leaders_of_hanging_nodes(interface);
    const IndexSet &owned =
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
        if (!leaders.empty())
          hand_over_columns(leaders, term);
      }
    return all;
  }

  template struct PairingStiffness<2>;
  template struct PairingStiffness<3>;
} // namespace Contact
