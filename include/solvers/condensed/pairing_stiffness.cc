/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/pairing_stiffness.h"

#include "base/exchange.h"

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
    parents_of_hanging_nodes(const ContactInterface<dim> &interface)
    {
      std::map<types::global_dof_index, Parts> parents;
      const auto add = [&](const Surface<dim> &surface) {
        for (unsigned int n = 0; n < surface.nodes.size(); ++n)
          if (!surface.parents[n].empty())
            for (unsigned int i = 0; i < dim; ++i)
              {
                Parts &parts = parents[surface.nodes[n].dofs[i]];
                parts.clear();
                for (const auto &[parent, part] : surface.parents[n])
                  parts.emplace_back(surface.nodes[parent].dofs[i], part);
              }
      };
      for (const auto &contact_pair : interface.pairs)
        {
          add(contact_pair->slave);
          if (contact_pair->master)
            add(*contact_pair->master);
        }
      return parents;
    }



    /// The columns of nodes that hang become parts of those that they follow.
    void
    hand_over_columns(const std::map<types::global_dof_index, Parts> &parents,
                      std::vector<types::global_dof_index>           &columns,
                      FullMatrix<double>                             &matrix)
    {
      std::map<types::global_dof_index, unsigned int> number;
      const auto number_of = [&](const types::global_dof_index dof) {
        return number.emplace(dof, number.size()).first->second;
      };
      std::vector<std::vector<std::pair<unsigned int, double>>> parts;
      for (const auto dof : columns)
        {
          parts.emplace_back();
          if (const auto found = parents.find(dof); found != parents.end())
            for (const auto &[parent, part] : found->second)
              parts.back().emplace_back(number_of(parent), part);
          else
            parts.back().emplace_back(number_of(dof), 1.);
        }
      FullMatrix<double> sums(matrix.m(), number.size());
      for (unsigned int j = 0; j < columns.size(); ++j)
        for (const auto &[column, part] : parts[j])
          for (unsigned int i = 0; i < matrix.m(); ++i)
            sums(i, column) += part * matrix(i, j);
      matrix = sums;
      columns.resize(number.size());
      for (const auto &[dof, column] : number)
        columns[column] = dof;
    }
  } // namespace



  template<int dim>
  void PairingStiffness<dim>::vmult(Vector<double>       &force,
                                    const Vector<double> &u) const
  {
    const unsigned int n = coefficients.size();
    Vector<double>     change(changes.m());
    changes.vmult(change, u);
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        force[dim * a + i] =
          change[a] * traction[i] + coefficients[a] * change[n + i];
  }



  template<int dim>
  FullMatrix<double> PairingStiffness<dim>::matrix() const
  {
    const unsigned int n = coefficients.size();
    FullMatrix<double> K(rows.size(), columns.size());
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < columns.size(); ++j)
          K(dim * a + i, j) =
            changes(a, j) * traction[i] + coefficients[a] * changes(n + i, j);
    return K;
  }



  // The norms of the rows: a matrix of other entries whose rows have them is
  // that of another pairing, which has other lines as well.
  template<int dim>
  void
  PairingStiffness<dim>::add_signature(std::vector<double> &signature) const
  {
    for (unsigned int i = 0; i < dim; ++i)
      signature.push_back(traction[i]);
    for (unsigned int a = 0; a < changes.m(); ++a)
      {
        double square = 0;
        for (unsigned int j = 0; j < changes.n(); ++j)
          square += changes(a, j) * changes(a, j);
        signature.push_back(square);
      }
  }



  template<int dim>
  std::vector<PairingStiffness<dim>>
  PairingStiffness<dim>::terms(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start)
  {
    std::vector<PairingStiffness<dim>> all;
    const auto parents = parents_of_hanging_nodes(interface);
    for (const ContactPoint<dim> &point : interface.points())
      {
        const PairingChange<dim> &change = point.change;
        if (point.status.kind == Status::open || change.C.empty())
          continue;
        const ContactState<dim> now = interface.state(point, solution, u_start);
        all.emplace_back();
        PairingStiffness<dim> &term = all.back();
        const unsigned int     n    = point.n_nodes;
        for (unsigned int a = 0; a < n; ++a)
          term.rows.insert(term.rows.end(),
                           point.dofs(a).begin(),
                           point.dofs(a).end());
        term.columns = change.dofs;
        term.coefficients.assign(point.C.begin(), point.C.begin() + n);
        term.traction =
          now.lambda_n * point.normal + point.along_tangents(now.lambda_t);
        term.changes.reinit(n + dim, term.columns.size());
        term.changes.fill(change.C);
        term.changes *= -point.weight;
        for (unsigned int j = 0; j < term.columns.size(); ++j)
          {
            const Tensor<1, dim> turned =
              now.lambda_n * point.along_tangents(change.rotation[j]) -
              (now.lambda_t * change.rotation[j]) * point.normal;
            for (unsigned int i = 0; i < dim; ++i)
              term.changes(n + i, j) = -point.weight * turned[i];
          }
        if (!parents.empty())
          hand_over_columns(parents, term.columns, term.changes);
      }
    return all;
  }



  template<int dim>
  std::vector<PairingStiffness<dim>> PairingStiffness<dim>::at_owners(
    const std::vector<PairingStiffness<dim>> &terms,
    const DiscretizedBodies<dim>             &discretization)
  {
    const UnknownOwners owners(discretization.dof_handler.locally_owned_dofs(),
                               discretization.communicator);
    std::map<unsigned int, std::vector<PairingStiffness<dim>>> by_owner;
    for (const auto &term : terms)
      by_owner[owners.owner(term.rows[0])].push_back(term);
    std::vector<PairingStiffness<dim>> own;
    for (const auto &of_rank :
         Utilities::MPI::some_to_some(discretization.communicator, by_owner))
      own.insert(own.end(), of_rank.second.begin(), of_rank.second.end());
    return own;
  }

  template class PairingStiffness<2>;
  template class PairingStiffness<3>;
} // namespace Contact
