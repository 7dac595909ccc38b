/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Lemke's method: a linear complementarity problem of known solution; one whose
// ratios are all equal; one without a solution; and points with Coulomb's
// friction on random bodies, whatever the friction.

#include "solvers/saddle_point/lemke.h"

#include <cmath>
#include <random>

#include "solvers/saddle_point/contact_complementarity.h"
#include "tests.h"

using namespace Tests;

namespace
{
  void
  report(const char *name, const FullMatrix<double> &M, const Vector<double> &r)
  {
    Lemke      lemke(M, r);
    const bool found = lemke.solve();
    std::cout << "  " << name << ": " << (found ? "z" : "no solution");
    if (found)
      for (const double z : lemke.z())
        std::cout << ' ' << z;
    std::cout << std::endl;
  }



  // The violation of the law of friction by the tractions that follow from
  // trial values, by the size of the summands.
  double violation(const FullMatrix<double> &matrix,
                   const Vector<double>     &constant,
                   const Vector<double>     &z,
                   const double              mu)
  {
    Vector<double> t(z.size());
    for (unsigned int i = 0; i < z.size(); i += 2)
      {
        t[i]     = std::max(0., z[i]);
        t[i + 1] = std::clamp(z[i + 1], -mu * t[i], mu * t[i]);
      }
    Vector<double> misfit(constant);
    misfit -= z;
    misfit *= -1;
    matrix.vmult_add(misfit, t);
    return misfit.linfty_norm() /
           (matrix.linfty_norm() * t.linfty_norm() + constant.linfty_norm());
  }



  // Pressures and shears t of n points give gaps and slips A t + b, A symmetric
  // and positive definite, yet soft against two motions, as a body is that weak
  // springs hold.
  FullMatrix<double> random_body(const unsigned int n, std::mt19937 &random)
  {
    std::normal_distribution<double> normal;
    FullMatrix<double>               A(2 * n, 2 * n), root(2 * n, 2 * n);
    for (unsigned int i = 0; i < 2 * n; ++i)
      for (unsigned int j = 0; j < 2 * n; ++j)
        root(i, j) = normal(random) * (j < 2 ? 100 : 1);
    root.mTmult(A, root);
    for (unsigned int i = 0; i < 2 * n; ++i)
      A(i, i) += 1e-3;
    return A;
  }



  void friction(const double mu)
  {
    const unsigned int               n = 8;
    std::mt19937                     random(1);
    std::normal_distribution<double> normal;
    unsigned int                     n_found = 0;
    double                           worst   = 0;

    std::vector<ContactComplementarity::Point> points;
    for (unsigned int i = 0; i < n; ++i)
      points.push_back({2 * i, 2 * i + 1, {0, mu}});
    for (unsigned int body = 0; body < 50; ++body)
      {
        FullMatrix<double> matrix = random_body(n, random);
        Vector<double>     constant(2 * n), z;
        for (unsigned int i = 0; i < 2 * n; ++i)
          {
            matrix(i, i) -= 1;
            constant[i] = 100 * normal(random);
          }
        z.reinit(2 * n);
        if (ContactComplementarity(matrix, constant, points).solve(z))
          {
            ++n_found;
            worst = std::max(worst, violation(matrix, constant, z, mu));
          }
      }
    std::ostringstream name;
    name << "friction " << mu;
    check(name.str() + ": all solved", n_found == 50);
    check_small(name.str() + ": misfit", worst, 1e-8);
  }
} // namespace



int main()
{
  FullMatrix<double> M(2, 2);
  Vector<double>     r(2);
  M(0, 0) = 2;
  M(0, 1) = M(1, 0) = 1;
  M(1, 1)           = 2;
  r[0]              = -5;
  r[1]              = -6;
  report("definite", M, r);

  // All around a pin in its hole: every point is as near as the others.
  FullMatrix<double> ring(6, 6);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      ring(i, j) =
        std::cos((i - 1. * j) * numbers::PI / 3) + (i == j ? 0.1 : 0);
  Vector<double> same(6);
  same = -1;
  report("equal ratios", ring, same);

  M       = 0;
  M(0, 1) = 1;
  M(1, 0) = -1;
  r[0]    = 1;
  r[1]    = -1;
  report("unsolvable", M, r);

  for (const double mu : {0., 0.3, 1., 5.})
    friction(mu);
  return 0;
}
