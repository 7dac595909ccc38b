/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_complementarity_h
#define contact_contact_complementarity_h

#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

#include "contact/points/friction_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Contact with Coulomb's friction on bodies whose trial values are affine in
   * the tractions, z = constant - matrix t: a linear complementarity problem in
   * the tractions (A. Klarbring, Int. J. Numer. Methods Eng. 24, 1987),
   *   0 <= p     _|_  c g >= 0,                        c g = p - p_trial,
   *   0 <= q_+   _|_  l + c s >= 0,   q = q_+ - q_-,   c s = q - q_trial,
   *   0 <= q_-   _|_  l - c s >= 0,
   *   0 <= l     _|_  limit + mu p - q_+ - q_- >= 0.
   * If the stiffness of the bodies is symmetric and positive definite, its
   * matrix is copositive, and Lemke's method ends at a solution for every mu
   * (A. Klarbring and J.-S. Pang, SIAM J. Optim. 8, 1998).
   */
  class ContactComplementarity
  {
  public:
    /// A contact point: where its p and q are in t and z. Without friction its
    /// q is an invalid index.
    struct Point
    {
      unsigned int p, q;
      FrictionLaw  law;
    };

    ContactComplementarity(const FullMatrix<double> &matrix,
                           const Vector<double>     &constant,
                           const std::vector<Point> &points);

    /// Find the trial values @p z of a solution. Returns whether there is one.
    bool solve(Vector<double> &z) const;

  private:
    static bool has_shear(const Point &point)
    {
      return point.q != numbers::invalid_unsigned_int;
    }

    /// The row of c g or, with the sign of q, of c s.
    void fill_row(const unsigned int  row,
                  const unsigned int  response,
                  const double        sign,
                  FullMatrix<double> &M,
                  Vector<double>     &r) const;

    /// The units of the variables, and of their rows.
    Vector<double> scales() const;

    const FullMatrix<double> &matrix;
    const Vector<double>     &constant;
    const std::vector<Point> &points;

    /// Of each point its first variable: p, and behind it q_+, q_-, l.
    std::vector<unsigned int> first;
    unsigned int              n_variables = 0;
  };
} // namespace Contact

#endif
