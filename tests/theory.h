/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The theory that a model is compared with.

#ifndef contact_tests_theory_h
#define contact_tests_theory_h

#include "tests.h"
#include "verification/exact_solution.h"

namespace Tests
{
  /// The theory of the first contact pair.
  inline ExactSolution exact_solution(const Parameters::All &parameters,
                                      const TwoBodies       &model,
                                      const ContactResults  &results = {})
  {
    return *make_exact_solution(parameters,
                                model.discretization,
                                *model.interface.pairs[0],
                                results);
  }
} // namespace Tests

#endif
