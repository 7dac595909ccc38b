/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/followers.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  // FE_Q(2) numbers the corners 0-3, the mid-sides 4-7, the centre 8.
  void bind_centres(const DoFHandler<2>       &dof_handler,
                    AffineConstraints<double> &constraints)
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && cell->reference_cell().is_hyper_cube())
        {
          dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          for (unsigned int c = 0; c < 2; ++c)
            {
              const auto dof = [&](const unsigned int node) {
                return dofs[cell->get_fe().component_to_system_index(c, node)];
              };
              constraints.add_line(dof(8));
              for (unsigned int node = 0; node < 4; ++node)
                constraints.add_entry(dof(8), dof(node), -0.25);
              for (unsigned int node = 4; node < 8; ++node)
                constraints.add_entry(dof(8), dof(node), 0.5);
            }
        }
  }



  AffineConstraints<double> followers(const Discretization &discretization)
  {
    AffineConstraints<double> constraints;
    if (discretization.mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                              constraints);
    for (const auto &[dof, leader] : discretization.tied())
      {
        constraints.add_line(dof);
        constraints.add_entry(dof, leader, 1.);
      }
    if (discretization.serendipity)
      bind_centres(discretization.dof_handler, constraints);
    constraints.close();
    return constraints;
  }



  void hand_over_from_followers(const Discretization &discretization,
                                Vector<double>       &forces)
  {
    const auto constraints = followers(discretization);
    if (Utilities::MPI::max(constraints.n_constraints(),
                            discretization.communicator) == 0)
      return;
    Vector<double> handed_over(forces.size());
    for (const auto &line : constraints.get_lines())
      if (discretization.dof_handler.locally_owned_dofs().is_element(
            line.index))
        {
          handed_over[line.index] -= forces[line.index];
          for (const auto &[other, coefficient] : line.entries)
            handed_over[other] += coefficient * forces[line.index];
        }
    Utilities::MPI::sum(handed_over, discretization.communicator, handed_over);
    forces += handed_over;
  }
} // namespace Contact
