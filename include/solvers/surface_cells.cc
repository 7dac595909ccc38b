/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/surface_cells.h"

namespace Contact
{
  template<int dim>
  SurfaceCells<dim>::SurfaceCells(const DoFHandler<dim> &dof_handler,
                                  const Choice          &choice)
  {
    using Entry = std::pair<CellId::binary_type, Dofs>;
    std::vector<Entry> own;
    Dofs               of_cell(dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && choice(cell))
        {
          cell->get_dof_indices(of_cell);
          own.emplace_back(cell->id().template to_binary<dim>(), of_cell);
        }
    for (const auto &of_rank :
         Utilities::MPI::all_gather(dof_handler.get_communicator(), own))
      for (const auto &[id, of_this] : of_rank)
        dofs.emplace(CellId(id), of_this);
  }



  template<int dim>
  CellId SurfaceCells<dim>::parent(const CellId &child)
  {
    const auto                children = child.get_child_indices();
    std::vector<std::uint8_t> path(children.begin(), children.end());
    path.pop_back();
    return {child.get_coarse_cell_id(), path};
  }

  template class SurfaceCells<2>;
  template class SurfaceCells<3>;
} // namespace Contact
