/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_values_h
#define contact_cell_values_h

#include <deal.II/grid/cell_id.h>

#include <map>
#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Values of vectors by cell, which any number of ranks numbers alike: on each
   * cell some of its unknowns, by the number on the cell, and the values of all
   * vectors there.
   */
  using CellValues = std::map<CellId, std::vector<double>>;

  /// What this rank owns of @p vectors, each unknown once.
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
