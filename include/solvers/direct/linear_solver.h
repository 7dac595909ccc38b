/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_linear_solver_h
#define contact_linear_solver_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <string>
#include <vector>

#include "base/counters.h"
#include "solvers/direct/bordered_factorization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The sparse direct solver UMFPACK for unsymmetric and indefinite systems.
   * SparseDirectUMFPACK of deal.II analyses the pattern anew with every
   * factorization; here the analysis is kept as long as the pattern stands.
   * Where that pays, a symmetric system with a border is left to
   * BorderedFactorization, as long as it is definite inside.
   */
  class DirectSolver
  {
  public:
    /// Operations are counted by @p counters.
    explicit DirectSolver(Counters &counters)
      : counters(counters)
    {
    }

    /// Announce the pattern of the matrices to come.
    void initialize(const SparsityPattern &pattern);

    /// The same, and that the matrices are symmetric but for couplings of the
    /// unknowns of @p border with each other.
    void initialize(const SparsityPattern   &pattern,
                    const std::vector<bool> &border);

    /// Throws NotConverged if the matrix is singular.
    void factorize(const SparseMatrix<double> &matrix);

    /// What it factorizes with, unless a matrix is not definite inside.
    std::string name() const
    {
      return bordered ? "CHOLMOD for the bodies" : "UMFPACK";
    }

    /// Whether it was not definite inside, and UMFPACK has factorized it.
    bool is_indefinite_inside() const
    {
      return bordered && numeric != nullptr;
    }

    /// Whether there is a factorization, and of the announced pattern.
    bool is_factorized() const
    {
      return numeric != nullptr || bordered_serves;
    }

    /// Of the matrix that was factorized last, see
    /// is_definite_under_constraints(); constraints are of the border alone.
    bool
    is_definite_under_constraints(const std::vector<bool> &is_constraint) const;

    /// Replace the right-hand side @p b by the solution.
    void solve(Vector<double> &b) const;

    /// The same with the transposed matrix.
    void solve_transposed(Vector<double> &b) const;

    /// Replace right-hand sides that are zero but at the border by the
    /// solutions there. Elsewhere they may stay zero: see leaves_inside().
    void solve_at_border(std::vector<Vector<double>> &b) const;

    /// Whether solve_at_border() leaves zeros inside, as that is cheap.
    bool leaves_inside() const
    {
      return bordered_serves;
    }

  private:
    void factorize_by_umfpack();
    void solve(const int system, Vector<double> &b) const;

    Counters &counters;

    using Handle = std::unique_ptr<void, void (*)(void *)>;

    // Compressed rows with sorted columns, and the place in them of each value
    // of the deal.II matrix, which has the diagonal first in each row.
    std::vector<int>          row_starts, columns;
    std::vector<unsigned int> positions;
    std::vector<double>       values;

    Handle symbolic{nullptr, nullptr};
    Handle numeric{nullptr, nullptr};

    std::unique_ptr<BorderedFactorization> bordered;
    std::vector<bool>                      border;
    bool                                   border_is_new   = false;
    bool                                   bordered_serves = false;
  };
} // namespace Contact

#endif
