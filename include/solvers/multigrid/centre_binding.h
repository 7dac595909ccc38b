/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_centre_binding_h
#define contact_centre_binding_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Which cells of serendipity elements bind their centres themselves, from
   * the values of the cell, and the constraints of all other unknowns: to look
   * the leaders of every centre up takes longer than to add what they hand
   * over. Such a cell has all bound nodes of the element, and no support or
   * hanging node has a part in these.
   */
  template<int dim, typename Number>
  class CentreBinding
  {
  public:
    /// Of elements without bound centres.
    CentreBinding(const AffineConstraints<Number> &constraints)
      : all(constraints)
    {
    }

    /// @p constraints are closed, and have the supports, hanging nodes and
    /// bound centres of a mesh, which may be a coarser one; they have to live
    /// on.
    CentreBinding(const Discretization<dim>       &discretization,
                  const DoFHandler<dim>           &dof_handler,
                  const AffineConstraints<Number> &constraints);

    /// Without those of the cells.
    const AffineConstraints<Number> &constraints() const
    {
      return in_cell.empty() ? all : others;
    }

    bool has_any() const
    {
      return !in_cell.empty();
    }

    bool is_in_cell(const unsigned int active_cell_index) const
    {
      return !in_cell.empty() && in_cell[active_cell_index];
    }

  private:
    const AffineConstraints<Number> &all;
    AffineConstraints<Number>        others;
    std::vector<bool>                in_cell;
  };
} // namespace Contact

#endif
