/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The stiffness of the bodies, and the sum of the indicators of their cells.

#ifndef contact_tests_error_indicators_h
#define contact_tests_error_indicators_h

#include <numeric>

#include "solid/stress_recovery.h"
#include "tests.h"

namespace Tests
{
  inline const double youngs_modulus = 1000;



  inline double sum(const Vector<float> &indicators)
  {
    return std::accumulate(indicators.begin(), indicators.end(), 0.);
  }
} // namespace Tests

#endif
