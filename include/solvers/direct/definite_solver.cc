/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/definite_solver.h"

#include <deal.II/lac/trilinos_solver.h>

#include <Epetra_CrsMatrix.h>
#include <algorithm>
#include <array>
#include <cholmod.h>
#include <optional>
#include <umfpack.h>

#include "base/errors.h"
#include "solvers/direct/algebraic_multigrid.h"
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



    /// The matrix as CHOLMOD sees it, without a copy: its lower triangle, or
    /// all of it.
    cholmod_sparse view_of(const Columns &columns, const bool symmetric)
    {
      cholmod_sparse view{};
      view.nrow   = columns.n;
      view.ncol   = columns.n;
      view.nzmax  = columns.starts[columns.n];
      view.p      = columns.starts;
      view.i      = columns.rows;
      view.x      = columns.values;
      view.stype  = symmetric ? -1 : 0;
      view.itype  = CHOLMOD_INT;
      view.xtype  = CHOLMOD_REAL;
      view.dtype  = CHOLMOD_DOUBLE;
      view.sorted = 0;
      view.packed = 1;
      return view;
    }



    const std::string not_definite =
      "the matrix is not positive definite: a body can move without "
      "resistance, or has lost its stability; if friction alone holds it, try "
      "another 'Solution/Friction' or more increments";



    /// UMFPACK on the compressed rows, which are the columns of the transpose.
    /// The analysis is kept as long as the pattern stands.
    class Umfpack : public DefiniteSolver
    {
    public:
      explicit Umfpack(Counters &counters)
        : DefiniteSolver(counters)
      {
        umfpack_di_defaults(control.data());
        // Newton's method corrects what round-off leaves.
        control[UMFPACK_IRSTEP] = 0;
      }

      void set_matrix(const Matrix &matrix,
                      const bool,
                      const bool new_pattern,
                      const Dofs &) override
      {
        columns = std::make_unique<Columns>(matrix);
        definite.reset();
        int status = UMFPACK_OK;
        if (symbolic == nullptr || new_pattern)
          {
            ++counters.symbolic_factorizations;
            void *handle = nullptr;
            status       = umfpack_di_symbolic(columns->n,
                                         columns->n,
                                         columns->starts,
                                         columns->rows,
                                         columns->values,
                                         &handle,
                                         control.data(),
                                         nullptr);
            symbolic =
              Handle(handle, [](void *p) { umfpack_di_free_symbolic(&p); });
          }
        numeric.reset();
        if (status == UMFPACK_OK)
          {
            ++counters.numeric_factorizations;
            void *handle = nullptr;
            status       = umfpack_di_numeric(columns->starts,
                                        columns->rows,
                                        columns->values,
                                        symbolic.get(),
                                        &handle,
                                        control.data(),
                                        nullptr);
            numeric =
              Handle(handle, [](void *p) { umfpack_di_free_numeric(&p); });
          }
        if (status != UMFPACK_OK)
          throw NotConverged(
            status == UMFPACK_WARNING_singular_matrix
              ? "the matrix is singular: a body can move without resistance"
              : "UMFPACK failed with status " + std::to_string(status) +
                  "; set Solution/Linear solver = AMG if it lacked memory");
      }

      // It looks at the matrix with the next solve.
      void release() override
      {
        numeric.reset();
      }

      unsigned int solve(const Vector &b, const double, Vector &x) override
      {
        ++counters.linear_solves;
        umfpack_di_solve(UMFPACK_At,
                         columns->starts,
                         columns->rows,
                         columns->values,
                         x.begin(),
                         b.begin(),
                         numeric.get(),
                         control.data(),
                         nullptr);
        return 1;
      }

      // A matrix with a definite symmetric part is that of a stable state; of
      // another one nothing is known.
      bool is_indefinite(const bool may_cost) override
      {
        if (!definite && may_cost)
          definite = has_definite_symmetric_part(columns->n,
                                                 columns->starts,
                                                 columns->rows,
                                                 columns->values);
        return definite && !*definite;
      }

      bool knows_definiteness() const override
      {
        return definite && *definite;
      }

    private:
      using Handle = std::unique_ptr<void, void (*)(void *)>;

      std::array<double, UMFPACK_CONTROL> control;
      std::unique_ptr<Columns>            columns;
      Handle                              symbolic{nullptr, nullptr};
      Handle                              numeric{nullptr, nullptr};
      std::optional<bool>                 definite; // its symmetric part
    };



    /// The supernodal Cholesky factorization of SuiteSparse. The analysis is
    /// kept as long as the pattern stands. A matrix that may be indefinite, and
    /// is, is factorized by UMFPACK.
    class Cholmod : public DefiniteSolver
    {
    public:
      Cholmod(const bool may_be_indefinite, Counters &counters)
        : DefiniteSolver(counters)
        , may_be_indefinite(may_be_indefinite)
      {
        cholmod_start(&common);
        common.supernodal                 = CHOLMOD_SUPERNODAL;
        common.print                      = 0;
        common.quick_return_if_not_posdef = 1;
      }

      ~Cholmod() override
      {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
      }

      void set_matrix(const Matrix &matrix,
                      const bool    symmetric,
                      const bool    new_pattern,
                      const Dofs   &eliminated) override
      {
        indefinite.reset();
        const Columns  columns(matrix);
        cholmod_sparse view = view_of(columns, /*symmetric=*/true);

        if (factor == nullptr || new_pattern)
          {
            ++counters.symbolic_factorizations;
            cholmod_free_factor(&factor, &common);
            factor = cholmod_analyze(&view, &common);
          }
        ++counters.numeric_factorizations;
        cholmod_factorize(&view, factor, &common);
        if (common.status == CHOLMOD_NOT_POSDEF)
          {
            if (!may_be_indefinite)
              throw NotConverged(not_definite);
            indefinite = std::make_unique<Umfpack>(counters);
            indefinite->set_matrix(matrix,
                                   symmetric,
                                   /*new_pattern=*/true,
                                   eliminated);
            return;
          }
        if (common.status != CHOLMOD_OK)
          throw NotConverged("CHOLMOD failed with status " +
                             std::to_string(common.status) +
                             "; set Solution/Linear solver = AMG if it lacked "
                             "memory");
      }

      bool is_indefinite(const bool) override
      {
        return indefinite != nullptr;
      }

      bool knows_definiteness() const override
      {
        return true;
      }

      // It keeps a factor of its own.
      void release() override
      {
        indefinite.reset();
      }

      unsigned int
      solve(const Vector &b, const double tolerance, Vector &x) override
      {
        if (indefinite)
          return indefinite->solve(b, tolerance, x);
        ++counters.linear_solves;
        cholmod_dense view{};
        view.nrow  = b.size();
        view.ncol  = 1;
        view.nzmax = b.size();
        view.d     = b.size();
        view.x     = const_cast<double *>(b.begin());
        view.xtype = CHOLMOD_REAL;
        view.dtype = CHOLMOD_DOUBLE;

        cholmod_dense *result =
          cholmod_solve(CHOLMOD_A, factor, &view, &common);
        std::copy_n(static_cast<double *>(result->x), b.size(), x.begin());
        cholmod_free_dense(&result, &common);
        return 1;
      }

    private:
      const bool               may_be_indefinite;
      cholmod_common           common;
      cholmod_factor          *factor = nullptr;
      std::unique_ptr<Umfpack> indefinite;
    };



    /// A direct solver of the Amesos package.
    class Mumps : public DefiniteSolver
    {
    public:
      using DefiniteSolver::DefiniteSolver;

      void set_matrix(const Matrix &matrix,
                      const bool,
                      const bool,
                      const Dofs &) override
      {
        // It does both with every matrix.
        ++counters.symbolic_factorizations;
        ++counters.numeric_factorizations;
        solver = std::make_unique<TrilinosWrappers::SolverDirect>(
          control,
          TrilinosWrappers::SolverDirect::AdditionalData(false,
                                                         "Amesos_Mumps"));
        try
          {
            solver->initialize(matrix);
          }
        catch (const ExceptionBase &)
          {
            throw NotConverged("MUMPS cannot factorize the matrix: a body can "
                               "move without resistance, or memory is short");
          }
      }

      void release() override
      {
        solver.reset();
      }

      unsigned int solve(const Vector &b, const double, Vector &x) override
      {
        ++counters.linear_solves;
        solver->solve(x, b);
        return 1;
      }

    private:
      SolverControl                                   control;
      std::unique_ptr<TrilinosWrappers::SolverDirect> solver;
    };
  } // namespace



  std::unique_ptr<DefiniteSolver>
  DefiniteSolver::create(const Parameters::SolverKind kind,
                         const bool                   symmetric,
                         const bool                   may_be_indefinite,
                         const CoarseSpace           &coarse_space,
                         Counters                    &counters)
  {
    switch (kind)
      {
        case Parameters::SolverKind::cholmod:
          if (symmetric)
            return std::make_unique<Cholmod>(may_be_indefinite, counters);
          return std::make_unique<Umfpack>(counters);
        case Parameters::SolverKind::mumps:
          return std::make_unique<Mumps>(counters);
        case Parameters::SolverKind::amg:
          return std::make_unique<AlgebraicMultigrid>(coarse_space, counters);
        case Parameters::SolverKind::automatic:
        case Parameters::SolverKind::gmg: // has no matrix
        case Parameters::SolverKind::umfpack:
          break;
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }



  Parameters::SolverKind DefiniteSolver::choose(const unsigned int dimension,
                                                const std::size_t  n_unknowns,
                                                const unsigned int n_ranks)
  {
    const std::size_t as_fast = dimension == 2 ? 100000 : 10000;
    return n_ranks == 1 && n_unknowns < as_fast
             ? Parameters::SolverKind::cholmod
             : Parameters::SolverKind::amg;
  }
} // namespace Contact
