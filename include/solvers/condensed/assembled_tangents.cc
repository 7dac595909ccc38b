/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of AssembledSystem that assembles the tangents of the bodies.

#include <Epetra_CrsMatrix.h>
#include <set>

#include "solvers/condensed/assembled_system.h"

namespace Contact
{
  template<int dim>
  void AssembledSystem<dim>::assemble_all(const GhostedVector  &solution,
                                          const StressStiffness stiffness)
  {
    matrix = 0;
    elasticity.visit_cells(
      solution,
      /*with_tangent=*/true,
      [&](const Dofs               &dofs,
          const FullMatrix<double> &tangent,
          const Vector<double> &) {
        discretization.constraints.distribute_local_to_global(tangent,
                                                              dofs,
                                                              matrix);
      },
      &bulk_cells,
      stiffness);
    elasticity.add_rigid_stiffness(solution, matrix);
    matrix.compress(VectorOperation::add);
    changes.clear();
    if (elasticity.changes_by_yielding() && elasticity.springs.held().empty())
      changes =
        yielding_changes(elasticity.yielding(bulk_cells, solution), solution);
  }



  template<int dim>
  std::map<unsigned int, FullMatrix<double>>
  AssembledSystem<dim>::yielding_changes(const std::vector<unsigned int> &cells,
                                         const GhostedVector &solution) const
  {
    std::map<unsigned int, FullMatrix<double>> found;
    auto                                       cell = cells.begin();
    elasticity.visit_cells(
      solution,
      /*with_tangent=*/true,
      [&](const Dofs &,
          const FullMatrix<double> &change,
          const Vector<double> &) { found.emplace(*cell++, change); },
      &cells,
      StressStiffness::change_by_yielding);
    return found;
  }



  // From the matrix of the last tangents to that of now, if it differs in a few
  // cells that yield or do so no longer. Returns whether it is done.
  template<int dim>
  bool AssembledSystem<dim>::change_bulk(const GhostedVector &solution)
  {
    if (!elasticity.changes_by_yielding() ||
        on_any_rank(!tangents_are_known || !elasticity.springs.held().empty() ||
                    tangent_version != elasticity.tangent_version()))
      return false;
    auto now = elasticity.yielding(bulk_cells, solution);
    if (on_any_rank(2 * (now.size() + changes.size()) > bulk_cells.size()))
      return false;

    restore_interface_rows();
    auto before = yielding_changes(now, solution);
    before.swap(changes);
    const auto add = [&](const unsigned int cell, FullMatrix<double> &change) {
      discretization.constraints.distribute_local_to_global(
        change,
        elasticity.dofs_of_cell(cell),
        matrix);
    };
    for (auto &[cell, change] : before)
      {
        change *= -1;
        if (const auto found = changes.find(cell); found != changes.end())
          change.add(1, found->second);
        add(cell, change);
      }
    for (auto &[cell, change] : changes)
      if (before.count(cell) == 0)
        add(cell, change);
    matrix.compress(VectorOperation::add);
    return true;
  }



  template<int dim>
  void
  AssembledSystem<dim>::assemble_bulk(const GhostedVector  &solution,
                                      const StressStiffness stress_stiffness)
  {
    if (!change_bulk(solution))
      {
        assemble_all(solution, stress_stiffness);
        set_bound_centres();
      }
  }



  // They are in no cell.
  template<int dim>
  void AssembledSystem<dim>::set_bound_centres()
  {
    if (!discretization.serendipity)
      return;
    const std::set<types::global_dof_index> of_interface(interface_dofs.begin(),
                                                         interface_dofs.end());
    for (const auto i : owned)
      if (discretization.constraints.is_constrained(i) &&
          of_interface.count(i) == 0 && matrix.diag_element(i) == 0)
        matrix.set(i, i, elasticity.youngs_modulus(0));
    matrix.compress(VectorOperation::insert);
  }



  template<int dim>
  void AssembledSystem<dim>::keep_interface_rows()
  {
    kept_rows.clear();
    for_interface_rows([&](const int n, double *values) {
      kept_rows.emplace_back(values, values + n);
    });
  }



  template<int dim>
  void AssembledSystem<dim>::restore_interface_rows()
  {
    auto kept = kept_rows.begin();
    for_interface_rows([&](const int, double *values) {
      std::copy(kept->begin(), kept->end(), values);
      ++kept;
    });
  }



  template<int dim>
  void AssembledSystem<dim>::for_interface_rows(
    const std::function<void(const int n, double *values)> &visit)
  {
    for (const auto dof : interface_dofs)
      if (owned.is_element(dof))
        {
          int     n       = 0;
          double *values  = nullptr;
          int    *columns = nullptr;
          matrix.trilinos_matrix().ExtractMyRowView(owned.index_within_set(dof),
                                                    n,
                                                    values,
                                                    columns);
          visit(n, values);
        }
  }

  template class AssembledSystem<2>;
  template class AssembledSystem<3>;
} // namespace Contact
