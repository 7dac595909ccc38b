/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/nested_transfer.h"

#include <deal.II/fe/fe.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <cmath>
#include <vector>

namespace Contact
{
  template<int dim, typename Number>
  void NestedTransfer<dim, Number>::initialize(
    const DoFHandler<dim>           &fine,
    const DoFHandler<dim>           &coarse,
    const AffineConstraints<Number> &of_fine,
    const AffineConstraints<Number> &of_coarse)
  {
    if (fine.get_fe().reference_cell().is_hyper_cube())
      by_cells.reinit_geometric_transfer(fine, coarse, of_fine, of_coarse);
    else
      make_matrix(fine, coarse, of_fine, of_coarse);
  }



  // There are no hanging nodes: what is constrained is supported.
  template<int dim, typename Number>
  void NestedTransfer<dim, Number>::make_matrix(
    const DoFHandler<dim>           &fine,
    const DoFHandler<dim>           &coarse,
    const AffineConstraints<Number> &of_fine,
    const AffineConstraints<Number> &of_coarse)
  {
    using Dof                    = types::global_dof_index;
    const double       round_off = 1e-12;
    const auto        &fe        = fine.get_fe();
    const auto        &node      = fe.base_element(0);
    const unsigned int n         = node.n_dofs_per_cell();
    const auto        &mesh      = fine.get_triangulation();
    std::vector<Dof>   dofs(fe.n_dofs_per_cell()), parents(dofs.size());
    const auto         visit = [&](const auto &visitor) {
      for (const auto &cell : coarse.active_cell_iterators())
        {
          cell->get_dof_indices(parents);
          const auto parent = mesh.create_cell_iterator(cell->id());
          for (unsigned int child = 0; child < parent->n_children(); ++child)
            {
              const typename DoFHandler<dim>::active_cell_iterator at(
                &mesh,
                parent->level() + 1,
                parent->child_index(child),
                &fine);
              at->get_dof_indices(dofs);
              const auto &values = node.get_prolongation_matrix(child);
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int b = 0; b < n; ++b)
                  if (std::abs(values(a, b)) > round_off)
                    for (unsigned int c = 0; c < dim; ++c)
                      visitor(dofs[fe.component_to_system_index(c, a)],
                              parents[fe.component_to_system_index(c, b)],
                              values(a, b));
            }
        }
    };

    at_node.resize(coarse.n_dofs());
    DynamicSparsityPattern couplings(fine.n_dofs(), coarse.n_dofs());
    visit([&](const Dof i, const Dof j, const double value) {
      if (std::abs(value - 1) < round_off)
        at_node[j] = i;
      if (!of_fine.is_constrained(i) && !of_coarse.is_constrained(j))
        couplings.add(i, j);
    });
    pattern.copy_from(couplings);
    matrix.reinit(pattern);
    visit([&](const Dof i, const Dof j, const double value) {
      if (!of_fine.is_constrained(i) && !of_coarse.is_constrained(j))
        matrix.set(i, j, value);
    });
  }



  template<int dim, typename Number>
  void NestedTransfer<dim, Number>::interpolate(Vector       &coarse,
                                                const Vector &fine) const
  {
    if (pattern.empty())
      by_cells.interpolate(coarse, fine);
    else
      for (unsigned int j = 0; j < at_node.size(); ++j)
        coarse.local_element(j) = fine.local_element(at_node[j]);
  }



  template<int dim, typename Number>
  void
  NestedTransfer<dim, Number>::prolongate_and_add(Vector       &fine,
                                                  const Vector &coarse) const
  {
    if (pattern.empty())
      by_cells.prolongate_and_add(fine, coarse);
    else
      matrix.vmult_add(fine, coarse);
  }



  template<int dim, typename Number>
  void NestedTransfer<dim, Number>::restrict_and_add(Vector       &coarse,
                                                     const Vector &fine) const
  {
    if (pattern.empty())
      by_cells.restrict_and_add(coarse, fine);
    else
      matrix.Tvmult_add(coarse, fine);
  }

  template class NestedTransfer<2, float>;
  template class NestedTransfer<3, float>;
} // namespace Contact
