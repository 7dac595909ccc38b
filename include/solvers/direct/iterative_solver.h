/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_iterative_solver_h
#define contact_iterative_solver_h

#include <deal.II/lac/solver_control.h>

#include <optional>

#include "solvers/direct/preconditioner.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Conjugate gradients, or GMRES where the matrix or the preconditioner is
   * unsymmetric. The preconditioner is kept, also for matrices with other
   * values, until it has become clearly worse than it was when it was new and
   * has cost more iterations than a new one would, or is about to: a constraint
   * more or less costs conjugate gradients about one iteration. The costs are
   * then some twice those of the best choice of matrices to make it from, as
   * far as prices are known (the problem of renting or buying). The inverse of
   * the matrix itself takes no iteration.
   */
  class IterativeSolver : public DefiniteSolver
  {
  public:
    IterativeSolver(std::unique_ptr<Preconditioner> preconditioner,
                    Counters                       &counters);

    void set_matrix(const Matrix &matrix,
                    const Matrix &nearby,
                    const bool    new_pattern,
                    const Dofs   &eliminated) override;

    void release() override;

    bool is_indefinite(const bool may_cost) override;

    bool knows_definiteness() const override;

    unsigned int
    solve(const Vector &b, const double tolerance, Vector &x) override;

  private:
    bool is_symmetric() const
    {
      return matrix == nearby;
    }

    bool is_for_cg() const;

    /// The unknowns eliminated or freed since the preconditioner was new.
    std::size_t n_changed() const;

    unsigned int max_iterations() const;
    void iterate(SolverControl &control, const Vector &b, Vector &x) const;
    void make();

    const std::unique_ptr<Preconditioner> preconditioner;
    const Matrix                         *matrix = nullptr, *nearby = nullptr;

    bool   is_made     = false;
    bool   is_new      = false; // made from the present matrix
    bool   new_pattern = true;  // since it was made
    bool   is_exact    = false; // the inverse of that
    double per_digit = 0, per_digit_when_new = 0;
    Dofs   eliminated, eliminated_when_new;

    /// Of the present matrix, once somebody has asked.
    std::optional<bool> indefinite = false;

    /// Iterations beyond those that the preconditioner took when it was new.
    double excess = 0;
  };
} // namespace Contact

#endif
