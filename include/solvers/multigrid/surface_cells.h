/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_cells_h
#define contact_surface_cells_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>

#include <functional>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// Some active cells of a mesh that this rank owns, those at surfaces of
  /// contact and at supports, and their unknowns.
  template<int dim>
  class SurfaceCells
  {
  public:
    using Dofs   = std::vector<types::global_dof_index>;
    using Choice = std::function<bool(
      const typename DoFHandler<dim>::active_cell_iterator &cell)>;

    SurfaceCells() = default;

    SurfaceCells(const DoFHandler<dim> &dof_handler, const Choice &choice);

    /// The cell of a coarser mesh that a cell is, or is a child of.
    struct Coarse
    {
      Dofs dofs;
      bool is_refined;
    };

    /// Set those of each of these cells, whose owners may be other ranks, in
    /// the mesh of @p coarse, and return those of this rank that cells of any
    /// rank have. Collective.
    SurfaceCells coarser(const DoFHandler<dim> &coarse,
                         std::vector<Coarse>   &of_cells) const;

    /// The cells in ascending order, and the unknowns of each.
    std::vector<CellId> names;
    std::vector<Dofs>   dofs;

    /// The number of a refined cell among the children.
    static unsigned int last_child(const CellId &child)
    {
      const auto children = child.get_child_indices();
      return children[children.size() - 1];
    }
  };
} // namespace Contact

#endif
