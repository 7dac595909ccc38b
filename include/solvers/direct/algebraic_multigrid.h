/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_algebraic_multigrid_h
#define contact_algebraic_multigrid_h

#include <vector>

#include "solvers/direct/degree_cycle.h"
#include "solvers/direct/preconditioner.h"

namespace Contact
{
  using namespace dealii;

  /// Smoothed aggregation, of degree 2 below a DegreeCycle.
  class AlgebraicMultigrid : public Preconditioner
  {
  public:
    AlgebraicMultigrid(const DefiniteSolver::CoarseSpace &coarse_space,
                       Counters                          &counters);

    void make(const Matrix &matrix, const bool new_pattern) override;

    void clear() override
    {
      cycle.clear();
    }

    void vmult(Vector &dst, const Vector &src) const override
    {
      cycle.vmult(dst, src);
    }

    bool is_inverse() const override
    {
      return false;
    }

    bool is_symmetric() const override
    {
      return true;
    }

    /// In 2-D a hierarchy costs less, and one that has become worse is renewed
    /// at once.
    double price() const override
    {
      return n_components() == 2 ? 0. : 30.;
    }

    bool finds_indefinite(const Matrix &matrix) const override;

  private:
    /// The displacements of a node.
    unsigned int n_components() const
    {
      return n_modes == 3 ? 2 : 3; // of as many rigid motions
    }

    const DefiniteSolver::CoarseSpace coarse_space;
    const unsigned int                n_modes;
    std::vector<double>               null_space; // one mode after the other
    DegreeCycle                       cycle;
    Counters                         &counters;
  };
} // namespace Contact

#endif
