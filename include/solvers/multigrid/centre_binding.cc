/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/centre_binding.h"

#include <deal.II/dofs/dof_tools.h>

#include <unordered_set>

#include "solid/followers.h"

namespace Contact
{
  // A support has no leaders. A centre all of whose leaders are supported has
  // none either, and is one.
  template<int dim, typename Number>
  CentreBinding<dim, Number>::CentreBinding(
    const Discretization<dim>       &discretization,
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<Number> &constraints)
    : all(constraints)
  {
    if (!discretization.serendipity || discretization.mesh.has_simplices())
      return;
    others.reinit(constraints.get_local_lines());
    DoFTools::make_hanging_node_constraints(dof_handler, others);
    for (const auto &line : constraints.get_lines())
      if (line.entries.empty() && !others.is_constrained(line.index))
        others.add_line(line.index);
    std::unordered_set<types::global_dof_index> used;
    for (const auto &line : others.get_lines())
      {
        used.insert(line.index);
        for (const auto &entry : line.entries)
          used.insert(entry.first);
      }

    const std::vector<BoundNode> &of_element = bound_nodes_of_element<dim>();
    std::vector<types::global_dof_index> dofs;
    in_cell.resize(dof_handler.get_triangulation().n_active_cells());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          bool is_regular =
            bound_nodes(discretization, cell).size() == of_element.size();
          for (const BoundNode &follower : of_element)
            for (unsigned int c = 0; c < dim && is_regular; ++c)
              is_regular =
                used.count(
                  dofs[cell->get_fe()
                         .component_to_system_index(c, follower.node)]) == 0;
          in_cell[cell->active_cell_index()] = is_regular;
        }
    bind_centres(discretization, dof_handler, others, in_cell);
    others.close();
  }

  template class CentreBinding<2, double>;
  template class CentreBinding<3, double>;
  template class CentreBinding<2, float>;
  template class CentreBinding<3, float>;
} // namespace Contact
