/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/definiteness.h"

#include <algorithm>
#include <cholmod.h>
#include <cmath>

namespace Contact
{
  namespace
  {
    /// The lower triangle of the symmetric part of a matrix, from the entries
    /// of that one by one.
    struct SymmetricPart
    {
      std::vector<int>    rows, columns;
      std::vector<double> values;

      void add(const int row, const int column, const double value)
      {
        rows.push_back(std::max(row, column));
        columns.push_back(std::min(row, column));
        values.push_back(row == column ? value : value / 2);
      }

      cholmod_triplet view(const int n)
      {
        cholmod_triplet view{};
        view.nrow  = n;
        view.ncol  = n;
        view.nzmax = values.size();
        view.nnz   = values.size();
        view.i     = rows.data();
        view.j     = columns.data();
        view.x     = values.data();
        view.stype = -1;
        view.itype = CHOLMOD_INT;
        view.xtype = CHOLMOD_REAL;
        view.dtype = CHOLMOD_DOUBLE;
        return view;
      }
    };



    bool is_definite(SymmetricPart &matrix, const int n)
    {
      cholmod_common common;
      cholmod_start(&common);
      common.supernodal                 = CHOLMOD_SUPERNODAL; // no L D L^T
      common.nmethods                   = 1;
      common.method[0].ordering         = CHOLMOD_AMD;
      common.print                      = 0;
      common.quick_return_if_not_posdef = 1;
      auto triplets                     = matrix.view(n);
      auto lower  = cholmod_triplet_to_sparse(&triplets, 0, &common);
      auto factor = cholmod_analyze(lower, &common);
      cholmod_factorize(lower, factor, &common);
      const bool is_definite = common.status == CHOLMOD_OK;
      cholmod_free_factor(&factor, &common);
      cholmod_free_sparse(&lower, &common);
      cholmod_finish(&common);
      return is_definite;
    }
  } // namespace



  bool has_definite_symmetric_part(const int           n,
                                   const int *const    starts,
                                   const int *const    columns,
                                   const double *const values)
  {
    SymmetricPart matrix;
    for (int i = 0; i < n; ++i)
      for (int k = starts[i]; k < starts[i + 1]; ++k)
        matrix.add(i, columns[k], values[k]);
    return is_definite(matrix, n);
  }



  bool is_definite_under_constraints(const SparseRows        &matrix,
                                     const std::vector<bool> &is_constraint)
  {
    std::vector<int> number;
    int              n       = 0;
    double           largest = 0;
    for (unsigned int i = 0; i < matrix.size(); ++i)
      {
        number.push_back(is_constraint[i] ? -1 : n++);
        double diagonal = 0;
        for (const auto &[j, value] : matrix[i])
          if (j == i && !is_constraint[i])
            diagonal += value;
        largest = std::max(largest, std::abs(diagonal));
      }
    const double gamma = 1000 * largest;

    SymmetricPart with_springs;
    for (unsigned int i = 0; i < matrix.size(); ++i)
      {
        SparseRows::value_type row;
        double                 square = 0;
        for (const auto &[j, value] : matrix[i])
          if (number[j] >= 0 && value != 0)
            {
              row.emplace_back(number[j], value);
              square += value * value;
            }
        for (const auto &[j, value] : row)
          if (!is_constraint[i])
            with_springs.add(number[i], j, value);
          else
            for (const auto &[k, other] : row)
              with_springs.add(k, j, gamma / square * value * other);
      }
    return is_definite(with_springs, n);
  }
} // namespace Contact
