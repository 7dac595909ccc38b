/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_definite_solver_h
#define contact_definite_solver_h

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <functional>
#include <memory>
#include <vector>

#include "base/counters.h"
#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A solver for symmetric positive definite systems, distributed by rows, or
   * for the unsymmetric ones that friction with a moving bound makes of them.
   * It decides by itself what to keep from one matrix to the next.
   */
  class DefiniteSolver
  {
  public:
    using Matrix = TrilinosWrappers::SparseMatrix;
    using Vector = TrilinosWrappers::MPI::Vector;

    /// The space of the linear elements, which multigrid works in.
    struct CoarseSpace
    {
      /// The rigid motions of the bodies, each by the values of the unknowns of
      /// this rank.
      std::vector<std::vector<double>> modes;

      /// Makes the interpolation in the space of the matrix, as its constraints
      /// are now; none, if these are the linear elements. Collective.
      std::function<std::unique_ptr<Matrix>()> interpolation;
    };

    /**
     * CHOLMOD (one rank) or AMG, as a preconditioner that is kept
     * (IterativeSolver), or MUMPS. AMG takes the modes of the @p coarse_space
     * as near null space, and alone needs it. A matrix that is not definite, if
     * it
     * @p may_be_indefinite, or unsymmetric with a symmetric part that is not,
     * CHOLMOD leaves to UMFPACK. Operations are counted by @p counters.
     */
    static std::unique_ptr<DefiniteSolver>
    create(const Parameters::SolverKind kind,
           const bool                   may_be_indefinite,
           const CoarseSpace           &coarse_space,
           Counters                    &counters);

    /// The factorization for so many ranks.
    static Parameters::SolverKind direct(const unsigned int n_ranks)
    {
      return n_ranks == 1 ? Parameters::SolverKind::cholmod
                          : Parameters::SolverKind::mumps;
    }

    /**
     * The meaning of "automatic". In two dimensions CHOLMOD is as fast as AMG
     * at a hundred thousand unknowns, in three at some twenty-five thousand,
     * with friction at some fifty thousand: at thirty thousand AMG takes
     * hundreds of iterations where points begin to slip, and twice the time.
     * CHOLMOD is faster the more often an analysis or a factorization serves;
     * beyond, its time and memory grow faster.
     */
    static Parameters::SolverKind choose(const unsigned int dimension,
                                         const std::size_t  n_unknowns,
                                         const unsigned int n_ranks,
                                         const bool         has_friction);

    explicit DefiniteSolver(Counters &counters)
      : counters(counters)
    {
    }

    virtual ~DefiniteSolver() = default;

    using Dofs = std::vector<types::global_dof_index>;

    /**
     * Take the matrix, which has to live until it is replaced. One that is not
     * symmetric has a symmetric and definite one @p nearby; else that is the
     * same. Say whether it has another pattern than the last one, and which
     * unknowns are @p eliminated from it, in ascending order, on all ranks the
     * same. Throws NotConverged if it cannot be factorized: CHOLMOD if it is
     * not positive definite and should be, MUMPS if it is singular; AMG finds
     * out when it solves.
     */
    virtual void set_matrix(const Matrix &matrix,
                            const Matrix &nearby,
                            const bool    new_pattern,
                            const Dofs   &eliminated) = 0;

    /// Whether the matrix is known to be indefinite: by its factorization
    /// (CHOLMOD), or because a direction of negative curvature is found (AMG);
    /// of an unsymmetric one its symmetric part (CHOLMOD). Both are looked for
    /// if that @p may_cost something. MUMPS does not know, nor AMG of an
    /// unsymmetric one. Collective.
    virtual bool is_indefinite(const bool may_cost)
    {
      (void)may_cost;
      return false;
    }

    /// Whether they would know.
    virtual bool knows_definiteness() const
    {
      return false;
    }

    /// Let go of the matrix, which is about to become another one: MUMPS looks
    /// at it when it is destroyed (dealii issue 13686).
    virtual void release() = 0;

    /**
     * Solve A x = b from x = 0 until the residual is below @p tolerance, an
     * absolute one which direct solvers do not need. Returns the number of
     * iterations, 1 for a direct solver. Throws NotConverged.
     */
    virtual unsigned int
    solve(const Vector &b, const double tolerance, Vector &x) = 0;

  protected:
    Counters &counters;
  };
} // namespace Contact

#endif
