/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_cells_h
#define contact_surface_cells_h

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>

#include <functional>
#include <map>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// The unknowns of some active cells of a mesh, those at surfaces and
  /// supports, by the name of the cell and on all ranks.
  template<int dim>
  class SurfaceCells
  {
  public:
    using Dofs   = std::vector<types::global_dof_index>;
    using Choice = std::function<bool(
      const typename DoFHandler<dim>::active_cell_iterator &cell)>;

    /// Collective.
    SurfaceCells(const DoFHandler<dim> &dof_handler, const Choice &choice);

    const std::map<CellId, Dofs> &all() const
    {
      return dofs;
    }

    bool has(const CellId &cell) const
    {
      return dofs.count(cell) > 0;
    }

    /// The cell that a refined one is a child of.
    static CellId parent(const CellId &child);

    /// Its number among these.
    static unsigned int last_child(const CellId &child)
    {
      const auto children = child.get_child_indices();
      return children[children.size() - 1];
    }

  private:
    std::map<CellId, Dofs> dofs;
  };
} // namespace Contact

#endif
