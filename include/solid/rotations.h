/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rotations_h
#define contact_rotations_h

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace Contact
{
  using namespace dealii;

  /// W with W a = w x a.
  inline Tensor<2, 3> spin(const Tensor<1, 3> &w)
  {
    Tensor<2, 3> W;
    for (unsigned int k = 0; k < 3; ++k)
      {
        const unsigned int i = (k + 1) % 3, j = (k + 2) % 3;
        W[j][i] = w[k];
        W[i][j] = -w[k];
      }
    return W;
  }

  /// The vector w of any tensor.
  inline Tensor<1, 3> axis(const Tensor<2, 3> &W)
  {
    Tensor<1, 3> w;
    for (unsigned int k = 0; k < 3; ++k)
      w[k] = 0.5 * (W[(k + 2) % 3][(k + 1) % 3] - W[(k + 1) % 3][(k + 2) % 3]);
    return w;
  }

  inline Tensor<2, 3> identity()
  {
    return static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>());
  }

  /// The change of the vector of rotation phi by a turn omega:
  ///   d = I - [phi]/2 + (1/t^2 - (1 + cos t)/(2 t sin t)) [phi]^2, t =
  ///   |phi|.
  inline Tensor<2, 3> change_of_vector(const Tensor<1, 3> &phi)
  {
    const double       t = phi.norm();
    const Tensor<2, 3> W = spin(phi);
    const double       c =
      t < 1e-3 ? 1. / 12
                     : 1 / (t * t) - (1 + std::cos(t)) / (2 * t * std::sin(t));
    return identity() - 0.5 * W + c * (W * W);
  }

  /// The vector of rotation of a proper orthogonal tensor, of a length up to
  /// pi, and that tensor of any vector.
  inline Tensor<1, 3> rotation_vector(const Tensor<2, 3> &R)
  {
    const Tensor<1, 3> w = axis(R);
    const double       s = w.norm();
    const double       t = std::atan2(s, 0.5 * (trace(R) - 1));
    return s > 0 ? t / s * w : w;
  }

  inline Tensor<2, 3> rotation_by(const Tensor<1, 3> &vector)
  {
    const double t = vector.norm();
    if (t == 0)
      return identity();
    const Tensor<2, 3> W    = spin(vector / t);
    const double       half = std::sin(0.5 * t);
    return identity() + std::sin(t) * W + 2 * half * half * (W * W);
  }
} // namespace Contact

#endif
