/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_worst_condition_h
#define contact_worst_condition_h

#include <cmath>
#include <string>

namespace Contact
{
  /// The larger one; what is not a number is larger than all.
  inline double larger(const double a, const double b)
  {
    return b <= a ? a : b;
  }



  /// The largest value, and a sentence about the worst one.
  struct Worst
  {
    double      value  = 0; // of all
    double      excess = 0; // over its slack, of all
    std::string sentence;

    /// @p say is asked for the sentence if need be. What is not a number is
    /// worse than all.
    template<class Say>
    void add(const double value, const double slack, const Say &say)
    {
      this->value = larger(this->value, value);
      if (value - slack <= excess || std::isnan(excess))
        return;
      excess   = value - slack;
      sentence = say();
    }

    bool is_violated() const
    {
      return !(excess <= 0);
    }
  };
} // namespace Contact

#endif
