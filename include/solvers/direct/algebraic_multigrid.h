/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_algebraic_multigrid_h
#define contact_algebraic_multigrid_h

#include <deal.II/lac/solver_control.h>

#include <optional>

#include "solvers/direct/definite_solver.h"
#include "solvers/direct/degree_cycle.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Conjugate gradients, or GMRES where the matrix is unsymmetric, with
   * smoothed aggregation, of degree 2 below a DegreeCycle. A hierarchy is kept,
   * also for a matrix with other values, until it has become clearly worse than
   * it was when it was new and has cost more iterations than a new one would,
   * or is about to: a constraint more or less costs the conjugate gradients
   * about one iteration.
   */
  class AlgebraicMultigrid : public DefiniteSolver
  {
  public:
    AlgebraicMultigrid(const CoarseSpace &coarse_space, Counters &counters);

    void set_matrix(const Matrix &matrix,
                    const bool    symmetric,
                    const bool    new_pattern,
                    const Dofs   &eliminated) override;

    void release() override;

    bool is_indefinite(const bool may_cost) override;

    bool knows_definiteness() const override;

    unsigned int
    solve(const Vector &b, const double tolerance, Vector &x) override;

  private:
    bool is_for_cg() const;

    /// The displacements of a node.
    unsigned int n_components() const;

    /// The unknowns eliminated or freed since the hierarchy was new.
    std::size_t n_changed() const;

    /// A hierarchy costs as much as so many iterations, roughly. In 2-D
    /// it is less, and one that has become worse is renewed at once.
    static constexpr unsigned int price_in_space = 30;

    double price_of_hierarchy() const;

    void iterate(SolverControl &control, const Vector &b, Vector &x) const;
    void build();

    static constexpr unsigned int max_iterations = 500;

    const CoarseSpace   coarse_space;
    const unsigned int  n_modes;
    std::vector<double> null_space; // one mode after the other
    const Matrix       *matrix = nullptr;
    DegreeCycle         preconditioner;
    bool                is_new    = false;
    bool                symmetric = true, symmetric_when_new = true;
    double              per_digit = 0, per_digit_when_new = 0;
    Dofs                eliminated, eliminated_when_new;

    /// Of the present matrix, once somebody has asked.
    std::optional<bool> indefinite = false;

    /// Iterations beyond those that the hierarchy took when it was new.
    double excess = 0;
  };
} // namespace Contact

#endif
