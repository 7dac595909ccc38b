/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_preconditioner_h
#define contact_preconditioner_h

#include <optional>

#include "solvers/direct/definite_solver.h"

namespace Contact
{
  using namespace dealii;

  /// A factorization, or a multigrid hierarchy: made from a matrix at a price,
  /// it serves for others near that.
  class Preconditioner
  {
  public:
    using Matrix = DefiniteSolver::Matrix;
    using Vector = DefiniteSolver::Vector;

    virtual ~Preconditioner() = default;

    /// Make it from a symmetric matrix, which it may look at until it is
    /// clear()ed. Whether the pattern is not that of the last one. Throws
    /// NotConverged if it cannot be made.
    virtual void make(const Matrix &matrix, const bool new_pattern) = 0;

    /// Make it the inverse of a matrix that may be unsymmetric, at a higher
    /// price. Returns whether there is one.
    virtual bool make_inverse(const Matrix &)
    {
      return false;
    }

    /// Let go of the matrix.
    virtual void clear() = 0;

    virtual void vmult(Vector &dst, const Vector &src) const = 0;

    /// Whether it is the inverse of the matrix that it has been made from: that
    /// does not look at the matrix, and serves for others of another pattern.
    virtual bool is_inverse() const = 0;

    /// Whether it is symmetric.
    virtual bool is_symmetric() const = 0;

    /// The price of making it, in iterations, roughly.
    virtual double price() const = 0;

    /// Whether a symmetric matrix is found to be indefinite. An inverse has
    /// been made from it.
    virtual bool finds_indefinite(const Matrix &matrix) const = 0;

    /// Whether the symmetric part of a matrix is indefinite; nothing if that is
    /// not known.
    virtual std::optional<bool> has_indefinite_part(const Matrix &) const
    {
      return {};
    }
  };
} // namespace Contact

#endif
