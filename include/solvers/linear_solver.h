/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_linear_solver_h
#define contact_linear_solver_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

#include "base/counters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The sparse direct solver UMFPACK for unsymmetric and indefinite systems.
   * SparseDirectUMFPACK of deal.II analyses the pattern anew with every
   * factorization; here the analysis is kept as long as the pattern stands.
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

    /// Throws NotConverged if the matrix is singular.
    void factorize(const SparseMatrix<double> &matrix);

    /// Whether there is a factorization, and of the announced pattern.
    bool is_factorized() const
    {
      return numeric != nullptr;
    }

    /// Replace the right-hand side @p b by the solution.
    void solve(Vector<double> &b) const;

    /// The same with the transposed matrix.
    void solve_transposed(Vector<double> &b) const;

  private:
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
  };
} // namespace Contact

#endif
