/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_fixed_point_h
#define contact_fixed_point_h

#include <string>
#include <utility>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "solvers/newton/relaxation.h"

namespace Contact
{
  /**
   * A fixed-point iteration. @p iterate(n), n from 1, solves under what is
   * frozen and returns the change since it was, and whether that is small
   * enough; where it is not, @p renew(relaxation) makes what is frozen next.
   * Throws NotConverged after @p max_iterations, with what @p change_of names.
   */
  template<class Iterate, class Renew>
  void fixed_point(const std::string &change_of,
                   const unsigned int max_iterations,
                   const Iterate     &iterate,
                   const Renew       &renew)
  {
    double     change = 0;
    Relaxation relaxation;
    for (unsigned int n = 1; n <= max_iterations; ++n)
      {
        const std::pair<double, bool> end = iterate(n);
        if (end.second)
          return;
        change = end.first;
        renew(relaxation);
      }
    throw NotConverged("the " + change_of + " of " + brief(change) + " after " +
                       std::to_string(max_iterations) + " iterations");
  }
} // namespace Contact

#endif
