/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_tangents_h
#define contact_condensed_tangents_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <map>
#include <vector>

#include "solvers/direct/definite_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The sum of local tangents K, in which eliminated unknowns, and hanging
   * ones, follow others by lines: with T from the lines of the displacements,
   * and T' from those of the virtual ones, T'^T (sum of K) T.
   *
   * AffineConstraints makes the product of each cell by itself. It costs the
   * square of the length of the lines for each pair of such unknowns in each
   * cell: too much where lines have hundreds of entries, as along the rim
   * of a master that covers a part of the slave. Here the rows and columns of
   * what follows are added up first, over all cells, and each line enters once.
   */
  class CondensedTangents
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Matrix = DefiniteSolver::Matrix;

    /// The @p matrix gets what is added here.
    CondensedTangents(const AffineConstraints<double> &lines,
                      const AffineConstraints<double> &test_lines,
                      Matrix                          &matrix);

    /// @p tangent and its unknowns have to live on. What follows nothing goes
    /// into the matrix right away.
    void add(const FullMatrix<double> &tangent,
             const Dofs               &rows,
             const Dofs               &columns);

    /// Add the rest.
    void finish();

  private:
    struct Local
    {
      const FullMatrix<double> *tangent;
      const Dofs               *rows, *columns;
    };

    /// A row of a local tangent.
    using Part = std::pair<unsigned int, unsigned int>;

    /// Entries by the number of their column.
    using Row = std::vector<std::pair<unsigned int, double>>;

    /// All columns, and what they follow: themselves, if they are free.
    struct Columns
    {
      Dofs             dofs; // in ascending order: their numbers
      std::vector<Row> leaders;

      unsigned int number(const Dof dof) const;
    };

    /// A sum of rows, of which few entries are not zero.
    class Sum
    {
    public:
      explicit Sum(const unsigned int n_columns)
        : values(n_columns, 0.)
        , is_used(n_columns, false)
      {
      }

      void add(const unsigned int column, const double value);

      /// All that was added; nothing is left.
      Row take();

    private:
      std::vector<double>       values;
      std::vector<char>         is_used;
      std::vector<unsigned int> used;
    };

    /// Whether an unknown has a line with others.
    bool follows(const Dof dof) const;
    bool has_followers(const Dofs &dofs) const;

    /// The part of a tangent that follows nothing.
    void add_free(const FullMatrix<double> &tangent,
                  const Dofs               &rows,
                  const Dofs               &columns);

    Columns find_columns() const;

    /// Of each row that has to do with unknowns that follow, where it is.
    std::map<Dof, std::vector<Part>> find_rows() const;

    /// A sum of rows, as far as it has to do with unknowns that follow, whose
    /// columns are replaced by what they follow.
    Row condensed_row(const Dof                row,
                      const std::vector<Part> &parts,
                      const Columns           &columns,
                      Sum                     &sum) const;

    const AffineConstraints<double> &lines;
    const AffineConstraints<double> &test_lines;
    Matrix                          &matrix;
    std::vector<Local>               locals; // with what follows
  };
} // namespace Contact

#endif
