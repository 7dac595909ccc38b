/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_degree_transfer_h
#define contact_degree_transfer_h

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "solid/discretization.h"
#include "solvers/direct/definite_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * From displacements that are linear in each cell to those of degree 2 on the
   * same mesh: a node between vertices has the sum of their linear shape
   * functions there times their displacements. Where an unknown of a vertex is
   * constrained, its line takes its place, and a constrained unknown between
   * vertices gets nothing: the matrix has an empty row for it. The linear space
   * keeps constrained unknowns of vertices, each for itself.
   */
  template<int dim>
  class DegreeTransfer
  {
  public:
    using Dof = types::global_dof_index;

    /// Collective.
    explicit DegreeTransfer(const Discretization<dim> &discretization);

    /// The interpolation under the constraints of the bodies and the @p lines
    /// of contact, which come first. Collective.
    std::unique_ptr<DefiniteSolver::Matrix>
    interpolation(const AffineConstraints<double> &lines) const;

    /// Of values by the owned unknowns of degree 2 those of the owned linear
    /// ones. Unknowns of a vertex are on the same rank in both spaces.
    std::vector<double> restricted(const std::vector<double> &values) const;

  private:
    using Row = std::vector<std::pair<Dof, double>>;

    template<class Visitor>
    void visit_rows(const Visitor &visit) const;

    Row constrained_row(const Dof                           dof,
                        const Row                          &row,
                        const AffineConstraints<double>    &lines,
                        const std::unordered_map<Dof, Row> &of_leaders) const;

    const std::vector<std::pair<Dof, double>> *
    entries(const Dof dof, const AffineConstraints<double> &lines) const;

    const Discretization<dim> &discretization;
    const IndexSet             owned;
    DoFHandler<dim>            linear;

    /// Of each kind of cell, by node: the vertices that it is between, and
    /// their shape functions there.
    std::vector<std::vector<std::vector<std::pair<unsigned int, double>>>>
      weights;

    /// The unknowns of both spaces at the same vertex, on the cells of this
    /// rank.
    std::unordered_map<Dof, Dof> of_degree_2, of_degree_1;
  };
} // namespace Contact

#endif
