/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// GMRES with a preconditioner on the right: the solution fulfils the equations
// to the tolerance, n iterations apply the preconditioner n times, which may be
// another one in each, a full space of directions is exact, more iterations
// than the basis has vectors begin anew, and what has no solution is said.

#include "solvers/flexible_gmres.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <iostream>

using namespace Contact;

namespace
{
  // Scales the unknowns, by other factors each time.
  class Scaling
  {
  public:
    Scaling(const double change)
      : change(change)
    {
    }

    void vmult(Vector<double> &y, const Vector<double> &x) const
    {
      ++n_applied;
      for (unsigned int i = 0; i < x.size(); ++i)
        y[i] = x[i] / (1 + i) * (1 + change * (n_applied % 2));
    }

    mutable unsigned int n_applied = 0;

  private:
    const double change;
  };



  // Unsymmetric, with eigenvalues from 1 to n.
  FullMatrix<double> convection(const unsigned int n)
  {
    FullMatrix<double> A(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        A(i, i) = 1 + i;
        if (i + 1 < n)
          A(i, i + 1) = 0.4 * (1 + i);
        if (i > 0)
          A(i, i - 1) = -0.3 * (1 + i);
      }
    return A;
  }



  void solve(const unsigned int n, const double tolerance, const double change)
  {
    const FullMatrix<double> A = convection(n);
    Vector<double>           x(n), b(n), r(n);
    for (unsigned int i = 0; i < n; ++i)
      b[i] = 1 + i % 3;
    SolverControl control(400, tolerance * b.l2_norm());
    const Scaling scaling(change);
    FlexibleGMRES<Vector<double>>(control).solve(A, x, b, scaling);
    A.vmult(r, x);
    r -= b;
    std::cout << n << " unknowns: residual "
              << (r.l2_norm() <= 1.01 * tolerance * b.l2_norm() ? "ok"
                                                                : "FAILED")
              << ", preconditioner once in an iteration "
              << (scaling.n_applied == control.last_step() ? "ok" : "FAILED")
              << ", at most n iterations "
              << (control.last_step() <= n ? "yes" : "no") << std::endl;
  }
} // namespace



int main()
{
  solve(1, 1e-12, 0);
  solve(6, 1e-13, 0);
  solve(40, 1e-10, 0.5);
  solve(300, 1e-12, 0.5);

  // The second row is not reached.
  FullMatrix<double> A(2, 2);
  A(0, 0) = 1;
  Vector<double> x(2), b(2);
  b[1] = 1;
  SolverControl control(10, 1e-10);
  try
    {
      FlexibleGMRES<Vector<double>>(control).solve(A, x, b, Scaling(0));
      std::cout << "singular: FAILED" << std::endl;
    }
  catch (const SolverControl::NoConvergence &)
    {
      std::cout << "singular: refused" << std::endl;
    }
}
