/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_level_transfer_h
#define contact_level_transfer_h

#include "base/errors.h"
#include "base/exchange.h"
#include "solvers/multigrid/multigrid_level.h"
#include "solvers/multigrid/nested_transfer.h"
#include "solvers/multigrid/surface_cells.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Between a level of ContactMultigrid and the next finer one: the
   * interpolation of a correction, its transpose, and the lines of contact and
   * the supports that the coarse level gets from the fine one. The line of an
   * unknown is that of the fine one at the same node, with the others
   * interpolated. It is made by the rank that owns the fine unknown, which asks
   * the owners of the others for what these are interpolated from.
   */
  template<int dim>
  class LevelTransfer
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Level  = MultigridLevel<dim>;
    using Vector = typename Level::Vector;

    /// Of the cells @p fine_cells at the surfaces, which the coarse level gets
    /// its own for, coarse_cells(). Collective.
    LevelTransfer(Level                   &coarse,
                  Level                   &fine,
                  const SurfaceCells<dim> &fine_cells);

    const SurfaceCells<dim> &coarse_cells() const
    {
      return cells;
    }

    /// This rank's unknowns of the coarse level where fine ones are @p fixed,
    /// of which each rank gives its own. In ascending order. Collective.
    Dofs at_same_nodes(const Dofs &fixed) const;

    /// After both levels have their supports. Collective.
    void initialize();

    /// Give the coarse level the lines and the springs of the fine one. Returns
    /// whether they are others than before. Throws SolverStalls where a line
    /// has unknowns that no cell at the surfaces or supports has, as hanging
    /// nodes in a concave corner may follow. Collective.
    bool hand_down();

    /// The displacement of the fine level on the coarse one.
    void interpolate() const
    {
      transfer.interpolate(coarse.solution, fine.solution);
    }

    /// Restrict the residual of the fine level to the right-hand side of the
    /// coarse one.
    void restrict_residual() const;

    /// Correct the solution of the fine level by that of the coarse one.
    void correct() const;

  private:
    using Sum = SurfaceRows::Sum;

    /// The place of a fine unknown, as the coarse level sees it.
    enum class Place : unsigned char
    {
      at_node,
      at_constrained_node,
      between
    };

    void
         make_rows(const SurfaceCells<dim>                               &of_fine,
                   const std::vector<typename SurfaceCells<dim>::Coarse> &coarse);
    void resolve_constraints();
    void get_rows(const Dofs &fine_dofs);
    bool lacks_rows(const Dofs &own, const Dofs &needed) const;

    /// Add a fine unknown times @p factor to @p sum, by unknowns of the coarse
    /// level that are not constrained.
    void add_coarse(const Dof fine_dof, const double factor, Sum &sum) const;

    SurfaceRows lines_at_nodes(const SurfaceRows &lines) const;
    void add_lines_between(const SurfaceRows &lines, SurfaceRows &made) const;
    std::vector<SurfaceSpring> coarse_springs() const;

    Level                                      &coarse, &fine;
    const MPI_Comm                              communicator;
    const UnknownOwners                         fine_owners, coarse_owners;
    SurfaceCells<dim>                           cells; // coarse ones
    NestedTransfer<dim, typename Level::Number> transfer;

    /// This rank's fine unknowns at the surfaces by coarse ones, and those of
    /// other ranks that its lines have needed.
    SurfaceRows        rows, others;
    std::vector<Place> places; // of the own ones
  };
} // namespace Contact

#endif
