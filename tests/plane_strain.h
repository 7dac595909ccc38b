/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Hooke's law in plane strain, and points on a circle about the origin.

#ifndef contact_tests_plane_strain_h
#define contact_tests_plane_strain_h

#include "tests.h"

namespace Tests
{
  inline constexpr double pi = numbers::PI;

  /// Hooke's law in plane strain, solved for the strain.
  inline SymmetricTensor<2, 2> strain(const SymmetricTensor<2, 2> &stress,
                                      const double youngs_modulus,
                                      const double poisson)
  {
    return (1 + poisson) / youngs_modulus *
           (stress - poisson * trace(stress) * unit_symmetric_tensor<2>());
  }



  /// The point at an angle from the x axis.
  inline Point<2> on_circle(const double r, const double theta)
  {
    return Point<2>(r * std::cos(theta), r * std::sin(theta));
  }
} // namespace Tests

#endif
