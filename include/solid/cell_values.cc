/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/cell_values.h"

#include <map>

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
    std::vector<double>                 &numbers = values.numbers;
    numbers.reserve((end - first) * (vectors.size() + 2));
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          values.cells.push_back(cell->id());
          const auto n = numbers.size();
          numbers.push_back(0);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (dofs[i] >= first && dofs[i] < end && !seen[dofs[i] - first])
              {
                seen[dofs[i] - first] = true;
                ++numbers[n];
                numbers.push_back(i);
                for (const GhostedVector *vector : vectors)
                  numbers.push_back((*vector)[dofs[i]]);
              }
        }
    return values;
  }



  template<int dim>
  void take_from_cells(const Discretization<dim>          &discretization,
                       const CellValues                   &values,
                       const std::vector<GhostedVector *> &vectors)
  {
    std::map<CellId, const double *> of_cell;
    const double                    *here = values.numbers.data();
    for (const CellId &cell : values.cells)
      {
        of_cell[cell] = here;
        here += 1 + static_cast<unsigned int>(*here) * (1 + vectors.size());
      }
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        if (const auto found = of_cell.find(cell->id()); found != of_cell.end())
          {
            dofs.resize(cell->get_fe().n_dofs_per_cell());
            cell->get_dof_indices(dofs);
            const double *number = found->second;
            for (double n = *number++; n > 0; --n)
              {
                const auto dof = dofs[static_cast<unsigned int>(*number++)];
                for (GhostedVector *vector : vectors)
                  (*vector)[dof] = *number++;
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
