/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_degree_cycle_h
#define contact_degree_cycle_h

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>

namespace Contact
{
  using namespace dealii;

  /**
   * Algebraic multigrid, for a matrix A of elements of degree 2 below one level
   * more: Chebyshev's iteration on A, a correction by the linear elements,
   * whose matrix is P^T A P with the interpolation P, and Chebyshev's iteration
   * again. An aggregate has so the nodes of a linear mesh, which have an eighth
   * of the unknowns, and next to no couplings of both signs.
   */
  class DegreeCycle
  {
  public:
    using Matrix = TrilinosWrappers::SparseMatrix;
    using Vector = TrilinosWrappers::MPI::Vector;

    /// The matrix has to live on.
    void add_degree(const Matrix           &matrix,
                    std::unique_ptr<Matrix> interpolation);

    /// The matrix that algebraic multigrid is for: this one, or that of the
    /// linear elements.
    const Matrix &lowest(const Matrix &matrix) const
    {
      return linear.m() > 0 ? linear : matrix;
    }

    void initialize(const Matrix &lowest, Teuchos::ParameterList &parameters)
    {
      amg.initialize(lowest, parameters);
    }

    void clear();

    void vmult(Vector &dst, const Vector &src) const;

  private:
    using Jacobi   = TrilinosWrappers::PreconditionJacobi;
    using Smoother = PreconditionChebyshev<Matrix, Vector, Jacobi>;

    const Matrix                     *fine = nullptr;
    std::unique_ptr<Matrix>           interpolation;
    Matrix                            linear; // P^T A P
    Smoother                          smoother;
    TrilinosWrappers::PreconditionAMG amg;
    mutable Vector                    residual, rhs, correction;
  };
} // namespace Contact

#endif
