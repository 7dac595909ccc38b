/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/factorizations.h"

#include <Epetra_CrsMatrix.h>
#include <algorithm>

#include "base/errors.h"
#include "solvers/direct/definiteness.h"

namespace Contact
{
  namespace
  {
    /// The compressed rows of a matrix on one rank, which are its columns, too.
    struct Columns
    {
      explicit Columns(const DefiniteSolver::Matrix &matrix)
        : n(matrix.m())
      {
        const int error =
          matrix.trilinos_matrix().ExtractCrsDataPointers(starts, rows, values);
        AssertThrow(error == 0, ExcMessage("the matrix is not compressed"));
      }

      const int n;
      int      *starts = nullptr, *rows = nullptr;
      double   *values = nullptr;
    };



    /// The lower triangle of a matrix as CHOLMOD sees it, without a copy.
    cholmod_sparse view_of(const Columns &columns)
    {
      cholmod_sparse view{};
      view.nrow   = columns.n;
      view.ncol   = columns.n;
      view.nzmax  = columns.starts[columns.n];
      view.p      = columns.starts;
      view.i      = columns.rows;
      view.x      = columns.values;
      view.stype  = -1;
      view.itype  = CHOLMOD_INT;
      view.xtype  = CHOLMOD_REAL;
      view.dtype  = CHOLMOD_DOUBLE;
      view.sorted = 0;
      view.packed = 1;
      return view;
    }
  } // namespace



  Umfpack::Umfpack(const Matrix &matrix, Counters &counters)
  {
    umfpack_di_defaults(control.data());
    // Newton's method corrects what round-off leaves.
    control[UMFPACK_IRSTEP] = 0;

    ++counters.symbolic_factorizations;
    ++counters.numeric_factorizations;
    const Columns columns(matrix);
    void         *handle = nullptr;
    int           status = umfpack_di_symbolic(columns.n,
                                     columns.n,
                                     columns.starts,
                                     columns.rows,
                                     columns.values,
                                     &handle,
                                     control.data(),
                                     info.data());
    const Handle  symbolic(handle,
                          [](void *p) { umfpack_di_free_symbolic(&p); });
    handle = nullptr;
    if (status == UMFPACK_OK)
      status = umfpack_di_numeric(columns.starts,
                                  columns.rows,
                                  columns.values,
                                  symbolic.get(),
                                  &handle,
                                  control.data(),
                                  info.data());
    numeric = Handle(handle, [](void *p) { umfpack_di_free_numeric(&p); });
    if (status != UMFPACK_OK)
      throw NotConverged(
        status == UMFPACK_WARNING_singular_matrix
          ? "the matrix is singular: a body can move without resistance"
          : "UMFPACK failed with status " + std::to_string(status) +
              "; set Solution/Linear solver = AMG if it lacked memory");
  }



  // Of the compressed rows, which are the columns of the transpose. Without
  // iterative refinement it does not look at the matrix.
  void Umfpack::vmult(Vector &dst, const Vector &src) const
  {
    umfpack_di_solve(UMFPACK_At,
                     nullptr,
                     nullptr,
                     nullptr,
                     dst.begin(),
                     src.begin(),
                     numeric.get(),
                     control.data(),
                     nullptr);
  }



  Factorization::Factorization(const bool may_be_indefinite, Counters &counters)
    : may_be_indefinite(may_be_indefinite)
    , counters(counters)
  {
    cholmod_start(&common);
    common.supernodal                 = CHOLMOD_SUPERNODAL;
    common.print                      = 0;
    common.quick_return_if_not_posdef = 1;
  }



  Factorization::~Factorization()
  {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }



  void Factorization::make(const Matrix &matrix, const bool new_pattern)
  {
    with_pivots.reset();
    const Columns  columns(matrix);
    cholmod_sparse view = view_of(columns);
    if (factor == nullptr || new_pattern)
      {
        ++counters.symbolic_factorizations;
        cholmod_free_factor(&factor, &common);
        factor = cholmod_analyze(&view, &common);
      }
    ++counters.numeric_factorizations;
    cholmod_factorize(&view, factor, &common);
    is_definite = common.status == CHOLMOD_OK;
    if (is_definite)
      return;
    if (common.status != CHOLMOD_NOT_POSDEF)
      throw NotConverged("CHOLMOD failed with status " +
                         std::to_string(common.status) +
                         "; set Solution/Linear solver = AMG if it lacked "
                         "memory");
    if (!may_be_indefinite)
      throw NotConverged(
        "the matrix is not positive definite: a body can move without "
        "resistance, or has lost its stability; if friction alone holds it, "
        "try another 'Solution/Friction' or more increments");
    make_inverse(matrix);
  }



  bool Factorization::make_inverse(const Matrix &matrix)
  {
    with_pivots = std::make_unique<Umfpack>(matrix, counters);
    return true;
  }



  void Factorization::vmult(Vector &dst, const Vector &src) const
  {
    if (with_pivots)
      return with_pivots->vmult(dst, src);
    cholmod_dense view{};
    view.nrow  = src.size();
    view.ncol  = 1;
    view.nzmax = src.size();
    view.d     = src.size();
    view.x     = const_cast<double *>(src.begin());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;

    cholmod_dense *result = cholmod_solve(CHOLMOD_A, factor, &view, &common);
    std::copy_n(static_cast<double *>(result->x), src.size(), dst.begin());
    cholmod_free_dense(&result, &common);
  }



  std::optional<bool>
  Factorization::has_indefinite_part(const Matrix &matrix) const
  {
    const Columns columns(matrix);
    return !has_definite_symmetric_part(columns.n,
                                        columns.starts,
                                        columns.rows,
                                        columns.values);
  }
} // namespace Contact
