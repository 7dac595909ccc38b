/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_negative_curvature_h
#define contact_negative_curvature_h

#include <cmath>
#include <random>

namespace Contact
{
  /// Values between -1/2 and 1/2 from @p begin to @p end, of process @p rank,
  /// the same in each run.
  template<typename Iterator>
  void
  fill_at_random(const Iterator begin, const Iterator end, const unsigned rank)
  {
    std::mt19937 generator(rank + 1);
    const double range = std::mt19937::max();
    for (Iterator value = begin; value != end; ++value)
      *value = generator() / range - 0.5;
  }



  /**
   * Whether a direction p is found with p . A p < 0: then the symmetric @p A is
   * not positive definite. @p M is its preconditioner; both have a vmult(), and
   * vectors are those of deal.II. @p D, not negative, is of the size of the
   * diagonal of A. Collective.
   *
   * The directions are those of conjugate gradients. The load does not serve to
   * start from: that of a straight column is orthogonal to the mode that it
   * buckles in. A vector by chance, @p r, has all modes. What M makes of it has
   * most of those that are the least stiff by D, and the first direction, M D M
   * r, next to nothing else: an inverse iteration for A x = lambda D x, to
   * which a softer body is no softer. Of a good preconditioner one direction is
   * enough: p . A p is what M believes, within a half. Of others as many are
   * taken as gain a digit, of (r . M r)^1/2. M need not be definite.
   *
   * It is no proof of the opposite: what gives way may hide behind what is much
   * more slender and does not.
   */
  template<typename Operator, typename Preconditioner, typename Vector>
  bool has_negative_curvature(const Operator       &A,
                              const Preconditioner &M,
                              const Vector         &D,
                              Vector                r)
  {
    const unsigned int max_steps = 50;
    const double       reduction = 0.1 * 0.1;
    Vector             z(r), p(r), A_p(r);
    auto               weight = D.begin();
    for (auto &value : r)
      value *= std::sqrt(*weight++);
    M.vmult(z, r);
    r = z;
    r.scale(D);
    M.vmult(z, r);
    p                  = z;
    double       r_z   = r * z;
    const double first = std::abs(r_z);
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        A.vmult(A_p, p);
        const double curvature = p * A_p;
        if (!(curvature > 0))
          return curvature < 0;
        if (std::abs(curvature - r_z) <= 0.5 * std::abs(r_z) ||
            std::abs(r_z) <= reduction * first)
          return false;
        r.add(-r_z / curvature, A_p);
        M.vmult(z, r);
        const double last = r_z;
        r_z               = r * z;
        p.sadd(r_z / last, 1, z);
      }
    return false;
  }
} // namespace Contact

#endif
