/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/load_steps.h"

#include <utility>

namespace Contact
{
  LoadSteps::LoadSteps(const Parameters::Increments &increments,
                       const unsigned int            max_cuts)
    : increments(increments)
    , max_cuts(max_cuts)
  {
  }



  bool LoadSteps::finished() const
  {
    return increment > increments.size();
  }



  double LoadSteps::load_factor(const std::uint32_t position) const
  {
    // Exact at the ends of increments, and what it is without cuts.
    if (position == whole())
      return increments.at(increment);
    return increments.at(increment - 1 +
                         static_cast<double>(position) / whole());
  }



  LoadSteps::Step LoadSteps::next() const
  {
    const std::uint32_t end = position + (whole() >> depth);
    return {load_factor(position),
            load_factor(end),
            increment,
            static_cast<double>(position) / whole(),
            static_cast<double>(end) / whole(),
            depth == 0,
            position == 0,
            end == whole(),
            depth == max_cuts};
  }



  void LoadSteps::accept(const unsigned int n_newton_steps)
  {
    position += whole() >> depth;
    if (position == whole())
      {
        position = 0;
        ++increment;
      }
    if (depth <= failed)
      failed = never;
    n_easy = n_newton_steps <= few_newton_steps ? n_easy + 1 : 0;

    // A step of twice the length has to start where such steps do. Two of the
    // length that has failed are four of its half.
    const unsigned int n_needed = depth > 0 && depth - 1 == failed ? 4 : 1;
    if (depth > 0 && n_easy >= n_needed &&
        position % (whole() >> (depth - 1)) == 0)
      --depth;
  }



  bool LoadSteps::cut()
  {
    if (depth == max_cuts)
      return false;
    failed = depth++;
    n_easy = 0;
    return true;
  }



  bool LoadSteps::begin_small()
  {
    return std::exchange(depth, max_cuts) < max_cuts;
  }
} // namespace Contact
