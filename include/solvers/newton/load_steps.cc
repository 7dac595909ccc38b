/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/load_steps.h"

namespace Contact
{
  LoadSteps::LoadSteps(const unsigned int n_increments,
                       const unsigned int max_cuts)
    : n_increments(n_increments)
    , max_cuts(max_cuts)
  {
  }



  bool LoadSteps::finished() const
  {
    return increment > n_increments;
  }



  double LoadSteps::load_factor(const std::uint32_t position) const
  {
    // Exact at the ends of increments, and what it is without cuts.
    if (position == whole())
      return static_cast<double>(increment) / n_increments;
    return (increment - 1 + static_cast<double>(position) / whole()) /
           n_increments;
  }



  LoadSteps::Step LoadSteps::next() const
  {
    const std::uint32_t end = position + (whole() >> depth);
    return {load_factor(position),
            load_factor(end),
            increment,
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
    // A step of twice the length has to start where such steps do.
    if (depth > 0 && n_newton_steps <= few_newton_steps &&
        position % (whole() >> (depth - 1)) == 0)
      --depth;
  }



  bool LoadSteps::cut()
  {
    if (depth == max_cuts)
      return false;
    ++depth;
    return true;
  }
} // namespace Contact
