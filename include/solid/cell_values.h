/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_values_h
#define contact_cell_values_h

#include <deal.II/grid/cell_id.h>

#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Values of vectors by cell, which any number of ranks names alike: for each
   * cell how many of its unknowns follow, and of each the number on the cell
   * and the values of all vectors.
   */
  struct CellValues
  {
    std::vector<CellId> cells;
    std::vector<double> numbers;

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &cells &numbers;
    }
  };

  /// The values of @p vectors that this rank owns, each unknown once.
  template<int dim>
  CellValues values_on_cells(const Discretization<dim>          &discretization,
                             const std::vector<GhostedVector *> &vectors);

  /// Take over what is of the cells that this rank knows.
  template<int dim>
  void take_from_cells(const Discretization<dim>          &discretization,
                       const CellValues                   &values,
                       const std::vector<GhostedVector *> &vectors);
} // namespace Contact

#endif
