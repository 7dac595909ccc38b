/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/linear_solver.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <umfpack.h>

#include "base/errors.h"
#include "solvers/direct/definiteness.h"

namespace Contact
{
  void DirectSolver::initialize(const SparsityPattern &pattern)
  {
    const unsigned int n = pattern.n_rows();
    row_starts.assign(1, 0);
    columns.clear();
    positions.resize(pattern.n_nonzero_elements());
    for (unsigned int row = 0; row < n; ++row)
      {
        const unsigned int        length = pattern.row_length(row);
        std::vector<unsigned int> order(length);
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
          return pattern.column_number(row, a) < pattern.column_number(row, b);
        });
        for (const unsigned int k : order)
          {
            positions[row_starts.back() + k] = columns.size();
            columns.push_back(pattern.column_number(row, k));
          }
        row_starts.push_back(columns.size());
      }
    values.resize(columns.size());
    symbolic.reset();
    numeric.reset();
    bordered_serves = false;
  }



  void DirectSolver::initialize(const SparsityPattern   &pattern,
                                const std::vector<bool> &border)
  {
    initialize(pattern);
    if (!BorderedFactorization::is_worthwhile(
          pattern.n_rows(),
          std::count(border.begin(), border.end(), true)))
      {
        bordered.reset();
        return;
      }
    if (!bordered)
      bordered = std::make_unique<BorderedFactorization>(counters);
    this->border  = border;
    border_is_new = true;
  }



  void DirectSolver::factorize(const SparseMatrix<double> &matrix)
  {
    auto position = positions.begin();
    for (const auto &entry : matrix)
      values[*position++] = entry.value();

    numeric.reset();
    if (bordered && border_is_new)
      {
        bordered->initialize(row_starts, columns, border);
        border_is_new = false;
      }
    bordered_serves = bordered && bordered->factorize(values);
    if (!bordered_serves)
      factorize_by_umfpack();
  }



  bool DirectSolver::is_definite_under_constraints(
    const std::vector<bool> &is_constraint) const
  {
    if (bordered_serves)
      return bordered->is_definite_under_constraints(values, is_constraint);
    SparseRows rows(row_starts.size() - 1);
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
        rows[i].emplace_back(columns[k], values[k]);
    return Contact::is_definite_under_constraints(rows, is_constraint);
  }



  void DirectSolver::factorize_by_umfpack()
  {
    std::array<double, UMFPACK_CONTROL> control;
    umfpack_di_defaults(control.data());

    const int n      = row_starts.size() - 1;
    int       status = UMFPACK_OK;
    if (symbolic == nullptr)
      {
        ++counters.symbolic_factorizations;
        void *handle = nullptr;
        status       = umfpack_di_symbolic(n,
                                     n,
                                     row_starts.data(),
                                     columns.data(),
                                     values.data(),
                                     &handle,
                                     control.data(),
                                     nullptr);
        symbolic =
          Handle(handle, [](void *p) { umfpack_di_free_symbolic(&p); });
      }
    if (status == UMFPACK_OK)
      {
        ++counters.numeric_factorizations;
        void *handle = nullptr;
        status       = umfpack_di_numeric(row_starts.data(),
                                    columns.data(),
                                    values.data(),
                                    symbolic.get(),
                                    &handle,
                                    control.data(),
                                    nullptr);
        numeric = Handle(handle, [](void *p) { umfpack_di_free_numeric(&p); });
      }
    if (status != UMFPACK_OK)
      throw NotConverged(
        status == UMFPACK_WARNING_singular_matrix
          ? "the matrix is singular: a body, or an obstacle under its force, "
            "can move without resistance, or supports and contact hold a node "
            "twice"
        : status == UMFPACK_ERROR_out_of_memory
          ? "UMFPACK lacks memory for the factors of " +
              std::to_string(columns.size()) +
              " entries: fewer levels, or without multipliers and errors of "
              "probes (Solution/System = condensed, Probes/Dual weighted "
              "residuals = false)"
          : "UMFPACK failed with status " + std::to_string(status));
  }



  // Compressed rows are the compressed columns of the transpose.
  void DirectSolver::solve(Vector<double> &b) const
  {
    solve(UMFPACK_At, b);
  }



  void DirectSolver::solve_transposed(Vector<double> &b) const
  {
    solve(UMFPACK_A, b);
  }



  void DirectSolver::solve_at_border(std::vector<Vector<double>> &b) const
  {
    if (bordered_serves)
      {
        counters.linear_solves += b.size();
        bordered->solve_at_border(b);
      }
    else
      for (Vector<double> &load : b)
        solve(load);
  }



  void DirectSolver::solve(const int system, Vector<double> &b) const
  {
    ++counters.linear_solves;
    if (bordered_serves)
      {
        bordered->solve(b, /*transposed=*/system == UMFPACK_A);
        return;
      }
    const Vector<double> rhs(b);
    // Newton's method corrects what round-off leaves better than iterative
    // refinement would.
    std::array<double, UMFPACK_CONTROL> control;
    umfpack_di_defaults(control.data());
    control[UMFPACK_IRSTEP] = 0;

    umfpack_di_solve(system,
                     row_starts.data(),
                     columns.data(),
                     values.data(),
                     b.begin(),
                     rhs.begin(),
                     numeric.get(),
                     control.data(),
                     nullptr);
  }
} // namespace Contact
