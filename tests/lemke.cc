/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Lemke's method: a linear complementarity problem of known solution; one whose
// ratios are all equal; one without a solution; and points with Coulomb's
// friction on random bodies, whatever the friction.

#include "solvers/lemke.h"

#include <cmath>
#include <random>

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



  // Of a solution: w - r - M z, and how far w and z are from being
  // complementary.
  double violation(const FullMatrix<double> &M,
                   const Vector<double>     &r,
                   const Lemke              &lemke)
  {
    Vector<double> misfit(r);
    M.vmult_add(misfit, lemke.z());
    misfit -= lemke.w();
    double largest = misfit.linfty_norm();
    for (unsigned int i = 0; i < r.size(); ++i)
      largest =
        std::max(largest, std::abs(std::min(lemke.z()[i], lemke.w()[i])));
    return largest / std::max(1., lemke.z().linfty_norm());
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
    for (unsigned int body = 0; body < 50; ++body)
      {
        const FullMatrix<double> A = random_body(n, random);
        FullMatrix<double>       M(4 * n, 4 * n);
        Vector<double>           r(4 * n);
        // Variables: p, q_+, q_-, l of each point.
        for (unsigned int i = 0; i < n; ++i)
          {
            const double gap = normal(random), slip = normal(random);
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  M(4 * i + a, 4 * j + b) = (a == 2 ? -1 : 1) *
                                            (b == 2 ? -1 : 1) *
                                            A(2 * i + (a > 0), 2 * j + (b > 0));
            M(4 * i + 1, 4 * i + 3) = M(4 * i + 2, 4 * i + 3) = 1;
            M(4 * i + 3, 4 * i + 1) = M(4 * i + 3, 4 * i + 2) = -1;
            M(4 * i + 3, 4 * i)                               = mu;
            r[4 * i]                                          = 100 * gap;
            r[4 * i + 1]                                      = 100 * slip;
            r[4 * i + 2]                                      = -100 * slip;
          }
        Lemke lemke(M, r);
        n_found += lemke.solve();
        worst = std::max(worst, violation(M, r, lemke));
      }
    std::ostringstream name;
    name << "friction " << mu << ": all bodies";
    check(name.str(), n_found == 50 && worst < 1e-8);
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
}
