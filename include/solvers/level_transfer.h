/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_level_transfer_h
#define contact_level_transfer_h

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include "solvers/multigrid_level.h"
#include "solvers/surface_cells.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Between a level of ContactMultigrid and the next finer one: the
   * interpolation of a correction, its transpose, and the lines of contact and
   * the supports that the coarse level gets from the fine one. The line of an
   * unknown is that of the fine one at the same node, with the others
   * interpolated.
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

    /// The unknowns of the coarse level where the fine ones are @p fixed.
    std::set<Dof> at_same_nodes(const std::set<Dof> &fixed) const;

    /// After both levels have their supports. Collective.
    void initialize();

    /// Give the coarse level the lines of the fine one. Collective.
    void hand_down() const;

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
    using Row   = std::vector<std::pair<Dof, double>>;
    using Lines = std::map<Dof, std::map<Dof, double>>;

    /// Add a fine unknown times @p factor to @p sum.
    void add_coarse(const Dof              fine_dof,
                    const double           factor,
                    std::map<Dof, double> &sum) const;

    /// Add the line of a fine unknown between coarse ones that have none.
    void add_line_between(const Dof dof, Lines &sums) const;

    Level                          &coarse, &fine;
    SurfaceCells<dim>               cells; // coarse ones
    MGTwoLevelTransfer<dim, Vector> transfer;

    /// Fine unknowns at the surfaces by coarse ones, on all ranks.
    std::map<Dof, Row> rows;

    /// What coarse ones are constrained to.
    std::map<Dof, Row> constrained;
  };
} // namespace Contact

#endif
