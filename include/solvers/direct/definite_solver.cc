/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/definite_solver.h"

#include <deal.II/lac/trilinos_solver.h>

#include "base/errors.h"
#include "solvers/direct/algebraic_multigrid.h"
#include "solvers/direct/factorizations.h"
#include "solvers/direct/iterative_solver.h"

namespace Contact
{
  namespace
  {
    /// A direct solver of the Amesos package.
    class Mumps : public DefiniteSolver
    {
    public:
      using DefiniteSolver::DefiniteSolver;

      void set_matrix(const Matrix &matrix,
                      const Matrix &,
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
                         const bool                   may_be_indefinite,
                         const CoarseSpace           &coarse_space,
                         Counters                    &counters)
  {
    std::unique_ptr<Preconditioner> preconditioner;
    switch (kind)
      {
        case Parameters::SolverKind::cholmod:
          preconditioner =
            std::make_unique<Factorization>(may_be_indefinite, counters);
          break;
        case Parameters::SolverKind::amg:
          preconditioner =
            std::make_unique<AlgebraicMultigrid>(coarse_space, counters);
          break;
        case Parameters::SolverKind::mumps:
          return std::make_unique<Mumps>(counters);
        case Parameters::SolverKind::automatic:
        case Parameters::SolverKind::gmg: // has no matrix
        case Parameters::SolverKind::umfpack:
          AssertThrow(false, ExcInternalError());
      }
    return std::make_unique<IterativeSolver>(std::move(preconditioner),
                                             counters);
  }



  Parameters::SolverKind DefiniteSolver::choose(const unsigned int dimension,
                                                const std::size_t  n_unknowns,
                                                const unsigned int n_ranks,
                                                const bool         has_friction)
  {
    const std::size_t as_fast = dimension == 2 ? 100000
                                : has_friction ? 50000
                                               : 25000;
    return n_ranks == 1 && n_unknowns < as_fast
             ? Parameters::SolverKind::cholmod
             : Parameters::SolverKind::amg;
  }
} // namespace Contact
