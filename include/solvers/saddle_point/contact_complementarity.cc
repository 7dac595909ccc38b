/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/contact_complementarity.h"

#include <cmath>

#include "solvers/saddle_point/lemke.h"

namespace Contact
{
  ContactComplementarity::ContactComplementarity(
    const FullMatrix<double> &matrix,
    const Vector<double>     &constant,
    const std::vector<Point> &points)
    : matrix(matrix)
    , constant(constant)
    , points(points)
  {
    for (const Point &point : points)
      {
        first.push_back(n_variables);
        n_variables += has_shear(point) ? 4 : 1;
      }
  }



  void ContactComplementarity::fill_row(const unsigned int  row,
                                        const unsigned int  response,
                                        const double        sign,
                                        FullMatrix<double> &M,
                                        Vector<double>     &r) const
  {
    const auto coefficient = [&](const unsigned int traction) {
      return sign *
             (matrix(response, traction) + (response == traction ? 1 : 0));
    };
    r[row] = -sign * constant[response];
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        M(row, first[i]) = coefficient(points[i].p);
        if (has_shear(points[i]))
          {
            M(row, first[i] + 1) = coefficient(points[i].q);
            M(row, first[i] + 2) = -coefficient(points[i].q);
          }
      }
  }



  // A piece held by stabilization springs yields to a traction a million times
  // more than elastic bodies do. Each point is scaled to ones on the diagonal
  // and between shear and slip, so that round-off can be told from all else.
  Vector<double> ContactComplementarity::scales() const
  {
    const auto unit = [this](const unsigned int traction) {
      return 1 / std::sqrt(std::abs(1 + matrix(traction, traction)));
    };
    Vector<double> scale(n_variables);
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        scale[first[i]] = unit(points[i].p);
        if (!has_shear(points[i]))
          continue;
        scale[first[i] + 1] = scale[first[i] + 2] = unit(points[i].q);
        scale[first[i] + 3]                       = 1 / unit(points[i].q);
      }
    return scale;
  }



  bool ContactComplementarity::solve(Vector<double> &z) const
  {
    FullMatrix<double> M(n_variables, n_variables);
    Vector<double>     r(n_variables);
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const unsigned int p = first[i];
        fill_row(p, points[i].p, 1, M, r);
        if (!has_shear(points[i]))
          continue;
        const unsigned int plus = p + 1, minus = p + 2, slip = p + 3;
        fill_row(plus, points[i].q, 1, M, r);
        fill_row(minus, points[i].q, -1, M, r);
        M(plus, slip) = M(minus, slip) = 1;
        M(slip, plus) = M(slip, minus) = -1;
        M(slip, p)                     = points[i].law.coulomb_coefficient;
        r[slip]                        = points[i].law.tresca_limit;
      }
    const Vector<double> scale = scales();
    for (unsigned int i = 0; i < n_variables; ++i)
      {
        r[i] *= scale[i];
        for (unsigned int j = 0; j < n_variables; ++j)
          M(i, j) *= scale[i] * scale[j];
      }
    Lemke lemke(M, r);
    if (!lemke.solve())
      return false;
    Vector<double> found = lemke.z();
    found.scale(scale);

    Vector<double> t(constant.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        t[points[i].p] = found[first[i]];
        if (has_shear(points[i]))
          t[points[i].q] = found[first[i] + 1] - found[first[i] + 2];
      }
    matrix.vmult(z, t);
    z.sadd(-1, 1, constant);
    return true;
  }
} // namespace Contact
