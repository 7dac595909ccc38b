/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/definite_solver.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <cholmod.h>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <umfpack.h>

#include "base/errors.h"
#include "solvers/definiteness.h"
#include "solvers/negative_curvature.h"

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
            throw NotConverged("MUMPS can not factorize the matrix: a body can "
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



    /**
     * Conjugate gradients, or GMRES where the matrix is unsymmetric, with
     * smoothed aggregation. A hierarchy is kept, also for a matrix with other
     * values, until it has become clearly worse than it was when it was new and
     * has cost more iterations than a new one would, or is about to: a
     * constraint more or less costs the conjugate gradients about one
     * iteration.
     */
    class Multigrid : public DefiniteSolver
    {
    public:
      Multigrid(const Modes &modes, Counters &counters)
        : DefiniteSolver(counters)
        , n_modes(modes.size())
      {
        for (const auto &mode : modes)
          null_space.insert(null_space.end(), mode.begin(), mode.end());
      }

      void set_matrix(const Matrix &matrix,
                      const bool    symmetric,
                      const bool    new_pattern,
                      const Dofs   &eliminated) override
      {
        this->matrix     = &matrix;
        this->symmetric  = symmetric;
        this->eliminated = eliminated;
        indefinite.reset();
        if (new_pattern || n_changed() > price_in_space ||
            (per_digit > 1.3 * per_digit_when_new &&
             excess >= price_of_hierarchy()))
          build();
      }

      void release() override
      {
        preconditioner.clear();
        indefinite = false;
      }

      bool is_indefinite(const bool may_cost) override
      {
        if (!is_for_cg())
          return false;
        if (!indefinite && !may_cost)
          return false;
        if (!indefinite)
          {
            Vector r(matrix->locally_owned_range_indices(),
                     matrix->get_mpi_communicator());
            fill_at_random(r.begin(),
                           r.end(),
                           Utilities::MPI::this_mpi_process(
                             matrix->get_mpi_communicator()));
            Vector diagonal(r);
            for (const auto i : r.locally_owned_elements())
              diagonal(i) = std::abs(matrix->diag_element(i));
            diagonal.compress(VectorOperation::insert);
            indefinite =
              has_negative_curvature(*matrix, preconditioner, diagonal, r);
          }
        return *indefinite;
      }

      bool knows_definiteness() const override
      {
        return is_for_cg();
      }

      unsigned int
      solve(const Vector &b, const double tolerance, Vector &x) override
      {
        SolverControl control(max_iterations, tolerance);
        try
          {
            iterate(control, b, x);
          }
        catch (const SolverControl::NoConvergence &)
          {
            if (!is_new)
              {
                build();
                return solve(b, tolerance, x);
              }
            std::ostringstream residual;
            residual << control.last_value();
            throw NotConverged((is_for_cg() ? "conjugate gradients" : "GMRES") +
                               std::string(" with AMG stall at the "
                                           "residual ") +
                               residual.str() + " N/mm (rings: N) after " +
                               std::to_string(max_iterations) +
                               " iterations; set Solution/Linear solver = "
                               "CHOLMOD, or MUMPS with several ranks");
          }

        // Solves of different depth compare by their iterations per digit.
        const double digits =
          std::log10(control.initial_value() / control.last_value());
        per_digit = digits > 0 ? control.last_step() / digits : 0.;
        if (is_new)
          {
            per_digit_when_new = per_digit;
            excess             = 0;
          }
        excess +=
          std::max(0., control.last_step() - digits * per_digit_when_new);
        is_new = false;
        return control.last_step();
      }

    private:
      bool is_for_cg() const
      {
        return symmetric && symmetric_when_new;
      }

      /// The displacements of a node.
      int n_components() const
      {
        return n_modes == 3 ? 2 : 3; // of as many rigid motions
      }

      /// The unknowns eliminated or freed since the hierarchy was new.
      std::size_t n_changed() const
      {
        Dofs changed;
        std::set_symmetric_difference(eliminated.begin(),
                                      eliminated.end(),
                                      eliminated_when_new.begin(),
                                      eliminated_when_new.end(),
                                      std::back_inserter(changed));
        return changed.size();
      }

      /// A hierarchy costs as much as so many iterations, roughly. In the plane
      /// it is less, and one that has become worse is renewed at once.
      static constexpr unsigned int price_in_space = 30;

      double price_of_hierarchy() const
      {
        return n_components() == 2 ? 0. : price_in_space;
      }

      void iterate(SolverControl &control, const Vector &b, Vector &x) const
      {
        ++counters.linear_solves;
        x = 0;
        if (is_for_cg())
          SolverCG<Vector>(control).solve(*matrix, x, b, preconditioner);
        else // the residual of the system itself is what is measured
          SolverGMRES<Vector>(
            control,
            SolverGMRES<Vector>::AdditionalData(/*max_n_tmp_vectors=*/102,
                                                /*right_preconditioning=*/true))
            .solve(*matrix, x, b, preconditioner);
      }

      void build()
      {
        ++counters.symbolic_factorizations;
        ++counters.numeric_factorizations;
        preconditioner.clear();
        TrilinosWrappers::PreconditionAMG::AdditionalData data;
        data.elliptic              = true;
        data.smoother_sweeps       = 2;
        data.aggregation_threshold = 0;
        Teuchos::ParameterList              parameters;
        std::unique_ptr<Epetra_MultiVector> no_modes;
        data.set_parameters(parameters, no_modes, *matrix);

        parameters.set("PDE equations", n_components());
        parameters.set("null space: type", "pre-computed");
        parameters.set("null space: add default vectors", false);
        parameters.set("null space: dimension", n_modes);
        parameters.set("null space: vectors", null_space.data());
        parameters.set("low memory usage", true);
        preconditioner.initialize(*matrix, parameters);
        is_new              = true;
        eliminated_when_new = eliminated;
        symmetric_when_new  = symmetric;
      }

      static constexpr unsigned int max_iterations = 500;

      const int                         n_modes;
      std::vector<double>               null_space; // one mode after the other
      const Matrix                     *matrix = nullptr;
      TrilinosWrappers::PreconditionAMG preconditioner;
      bool                              is_new = false;
      bool   symmetric = true, symmetric_when_new = true;
      double per_digit = 0, per_digit_when_new = 0;
      Dofs   eliminated, eliminated_when_new;

      /// Of the present matrix, once somebody has asked.
      std::optional<bool> indefinite = false;

      /// Iterations beyond those that the hierarchy took when it was new.
      double excess = 0;
    };
  } // namespace



  std::unique_ptr<DefiniteSolver>
  DefiniteSolver::create(const Parameters::SolverKind kind,
                         const bool                   symmetric,
                         const bool                   may_be_indefinite,
                         const Modes                 &modes,
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
          return std::make_unique<Multigrid>(modes, counters);
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
