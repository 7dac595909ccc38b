/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/cell_values.h"

namespace Contact
{
  template<int dim>
  CellValues values_on_cells(const Discretization<dim>          &discretization,
                             const std::vector<GhostedVector *> &vectors)
  {
    const auto [first, end] = discretization.distribution->local_range();
    std::vector<bool>                    seen(end - first);
    std::vector<types::global_dof_index> dofs;
    CellValues                           values;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          auto &here = values[cell->id()];
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (dofs[i] >= first && dofs[i] < end && !seen[dofs[i] - first])
              {
                seen[dofs[i] - first] = true;
                here.push_back(i);
                for (const GhostedVector *vector : vectors)
                  here.push_back((*vector)[dofs[i]]);
              }
        }
    return values;
  }



  template<int dim>
  void take_from_cells(const Discretization<dim>          &discretization,
                       const CellValues                   &values,
                       const std::vector<GhostedVector *> &vectors)
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        if (const auto found = values.find(cell->id()); found != values.end())
          {
            dofs.resize(cell->get_fe().n_dofs_per_cell());
            cell->get_dof_indices(dofs);
            for (auto value = found->second.begin();
                 value != found->second.end();)
              {
                const auto dof = dofs[static_cast<unsigned int>(*value++)];
                for (GhostedVector *vector : vectors)
                  (*vector)[dof] = *value++;
              }
          }
  }

  template CellValues values_on_cells(const Discretization<2> &,
                                      const std::vector<GhostedVector *> &);
  template CellValues values_on_cells(const Discretization<3> &,
                                      const std::vector<GhostedVector *> &);
  template void       take_from_cells(const Discretization<2> &,
                                      const CellValues &,
                                      const std::vector<GhostedVector *> &);
  template void       take_from_cells(const Discretization<3> &,
                                      const CellValues &,
                                      const std::vector<GhostedVector *> &);
} // namespace Contact
