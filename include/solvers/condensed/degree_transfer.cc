/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/degree_transfer.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <limits>
#include <map>

#include "solid/element_spaces.h"

namespace Contact
{
  template<int dim>
  DegreeTransfer<dim>::DegreeTransfer(const Discretization<dim> &discretization)
    : discretization(discretization)
    , owned(discretization.dof_handler.locally_owned_dofs())
    , linear(discretization.mesh.triangulation)
  {
    const hp::FECollection<dim> linear_fe = make_fe(discretization.mesh, 1);
    distribute_dofs(linear_fe, linear);
    for (unsigned int f = 0; f < linear_fe.size(); ++f)
      {
        const auto &vertex = linear_fe[f].base_element(0);
        weights.emplace_back();
        for (const Point<dim> &node :
             discretization.fe[f].base_element(0).get_unit_support_points())
          {
            auto &of_node = weights.back().emplace_back();
            for (unsigned int v = 0; v < vertex.n_dofs_per_cell(); ++v)
              if (const double weight = vertex.shape_value(v, node);
                  weight > std::numeric_limits<float>::epsilon())
                of_node.emplace_back(v, weight);
          }
      }
    visit_rows([&](const Dof dof, const Row &row) {
      if (row.size() == 1)
        {
          of_degree_2.emplace(row[0].first, dof);
          of_degree_1.emplace(dof, row[0].first);
        }
    });
  }



  // All unknowns of the cells of this rank, some of them several times.
  template<int dim>
  template<class Visitor>
  void DegreeTransfer<dim>::visit_rows(const Visitor &visit) const
  {
    std::vector<Dof> dofs, linear_dofs;
    Row              row;
    auto             linear_cell = linear.begin_active();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (cell->is_locally_owned())
          {
            const auto &fe        = cell->get_fe();
            const auto &linear_fe = linear_cell->get_fe();
            const auto &of_nodes  = weights[cell->active_fe_index()];
            dofs.resize(fe.n_dofs_per_cell());
            linear_dofs.resize(linear_fe.n_dofs_per_cell());
            cell->get_dof_indices(dofs);
            linear_cell->get_dof_indices(linear_dofs);
            for (unsigned int a = 0; a < of_nodes.size(); ++a)
              for (unsigned int c = 0; c < dim; ++c)
                {
                  row.clear();
                  for (const auto &[v, weight] : of_nodes[a])
                    row.emplace_back(
                      linear_dofs[linear_fe.component_to_system_index(c, v)],
                      weight);
                  visit(dofs[fe.component_to_system_index(c, a)], row);
                }
          }
        ++linear_cell;
      }
  }



  // By those that lead it, if it is constrained; else null.
  template<int dim>
  const std::vector<std::pair<types::global_dof_index, double>> *
  DegreeTransfer<dim>::entries(const Dof                        dof,
                               const AffineConstraints<double> &lines) const
  {
    return lines.is_constrained(dof)
             ? lines.get_constraint_entries(dof)
             : discretization.constraints.get_constraint_entries(dof);
  }



  template<int dim>
  typename DegreeTransfer<dim>::Row DegreeTransfer<dim>::constrained_row(
    const Dof                           dof,
    const Row                          &row,
    const AffineConstraints<double>    &lines,
    const std::unordered_map<Dof, Row> &of_leaders) const
  {
    if (entries(dof, lines) != nullptr)
      return row.size() == 1 ? row : Row();
    std::map<Dof, double> sum;
    const auto add_if_free = [&](const Row &terms, const double factor) {
      for (const auto &[vertex, weight] : terms)
        if (entries(of_degree_2.at(vertex), lines) == nullptr)
          sum[vertex] += factor * weight;
    };
    for (const auto &[vertex, weight] : row)
      if (const auto *line = entries(of_degree_2.at(vertex), lines))
        for (const auto &[leader, factor] : *line)
          {
            const auto found = of_leaders.find(leader);
            if (found != of_leaders.end())
              add_if_free(found->second, weight * factor);
          }
      else
        sum[vertex] += weight;
    return Row(sum.begin(), sum.end());
  }



  template<int dim>
  std::unique_ptr<DefiniteSolver::Matrix> DegreeTransfer<dim>::interpolation(
    const AffineConstraints<double> &lines) const
  {
    // The rows of what leads constrained unknowns of vertices.
    std::unordered_map<Dof, Row> of_leaders;
    for (const auto &[dof, vertex] : of_degree_1)
      if (const auto *line = entries(dof, lines))
        for (const auto &[leader, factor] : *line)
          of_leaders.emplace(leader, Row());
    std::vector<bool> is_done(owned.n_elements());
    visit_rows([&](const Dof dof, const Row &row) {
      const auto found = of_leaders.find(dof);
      if (found != of_leaders.end())
        found->second = row;
    });

    const IndexSet        &linear_owned = linear.locally_owned_dofs();
    DynamicSparsityPattern pattern(owned.size(), linear_owned.size(), owned);
    std::vector<Row>       rows(owned.n_elements());
    visit_rows([&](const Dof dof, const Row &row) {
      if (!owned.is_element(dof) || is_done[owned.index_within_set(dof)])
        return;
      is_done[owned.index_within_set(dof)] = true;
      Row &made                            = rows[owned.index_within_set(dof)];
      made = constrained_row(dof, row, lines, of_leaders);
      for (const auto &[vertex, weight] : made)
        pattern.add(dof, vertex);
    });
    auto matrix = std::make_unique<DefiniteSolver::Matrix>();
    matrix->reinit(owned, linear_owned, pattern, discretization.communicator);
    for (const Dof dof : owned)
      for (const auto &[vertex, weight] : rows[owned.index_within_set(dof)])
        matrix->set(dof, vertex, weight);
    matrix->compress(VectorOperation::insert);
    return matrix;
  }



  template<int dim>
  std::vector<double>
  DegreeTransfer<dim>::restricted(const std::vector<double> &values) const
  {
    std::vector<double> at_vertices;
    for (const Dof vertex : linear.locally_owned_dofs())
      at_vertices.push_back(
        values[owned.index_within_set(of_degree_2.at(vertex))]);
    return at_vertices;
  }

  template class DegreeTransfer<2>;
  template class DegreeTransfer<3>;
} // namespace Contact
