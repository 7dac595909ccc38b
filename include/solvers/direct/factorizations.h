/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_factorizations_h
#define contact_factorizations_h

#include <array>
#include <cholmod.h>
#include <umfpack.h>

#include "solvers/direct/preconditioner.h"

namespace Contact
{
  using namespace dealii;

  /// The price of a factorization in solutions, from its operations and the
  /// entries of its factors: a solution waits for the memory, and takes longer
  /// for each operation, by measurement in 3-D some 24 times.
  inline double price_of_factorization(const double n_operations,
                                       const double n_entries)
  {
    const double slower = 24;
    return n_operations / (slower * 2 * n_entries);
  }



  /// The factors of UMFPACK, of a matrix on one rank.
  class Umfpack
  {
  public:
    using Matrix = Preconditioner::Matrix;
    using Vector = Preconditioner::Vector;

    Umfpack(const Matrix &matrix, Counters &counters);

    void vmult(Vector &dst, const Vector &src) const;

    double price() const
    {
      return price_of_factorization(info[UMFPACK_FLOPS],
                                    info[UMFPACK_LNZ] + info[UMFPACK_UNZ]);
    }

  private:
    using Handle = std::unique_ptr<void, void (*)(void *)>;

    std::array<double, UMFPACK_CONTROL> control;
    std::array<double, UMFPACK_INFO>    info{};
    Handle                              numeric{nullptr, nullptr};
  };



  /// The supernodal Cholesky factorization of SuiteSparse, of a matrix on one
  /// rank. The analysis is kept as long as the pattern stands. A matrix that @p
  /// may_be_indefinite, and is, UMFPACK factorizes.
  class Factorization : public Preconditioner
  {
  public:
    Factorization(const bool may_be_indefinite, Counters &counters);
    ~Factorization() override;

    void make(const Matrix &matrix, const bool new_pattern) override;
    bool make_inverse(const Matrix &matrix) override;
    void vmult(Vector &dst, const Vector &src) const override;

    void clear() override
    {
    }

    bool is_inverse() const override
    {
      return true;
    }

    bool is_symmetric() const override
    {
      return !with_pivots;
    }

    double price() const override
    {
      return with_pivots ? with_pivots->price()
                         : price_of_factorization(common.fl, 2 * common.lnz);
    }

    bool finds_indefinite(const Matrix &) const override
    {
      return !is_definite;
    }

    std::optional<bool>
    has_indefinite_part(const Matrix &matrix) const override;

  private:
    const bool               may_be_indefinite;
    Counters                &counters;
    mutable cholmod_common   common;
    cholmod_factor          *factor      = nullptr;
    bool                     is_definite = true;
    std::unique_ptr<Umfpack> with_pivots;
  };
} // namespace Contact

#endif
