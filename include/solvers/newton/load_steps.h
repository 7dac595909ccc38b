/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_load_steps_h
#define contact_load_steps_h

#include <cstdint>

#include "parameters/increments.h"

namespace Contact
{
  /**
   * The way of the load factor t from 0 to 1: the increments of the plan. A
   * step that does not converge is cut in half and tried again, up to a given
   * depth. After a step that took few Newton steps the next one is twice as
   * long, if it still ends where an increment does; the length that has failed
   * is tried again only behind four of its half that were easy. A step that was
   * hard is followed by one of the same length. Every increment of the plan is
   * reached exactly.
   */
  class LoadSteps
  {
  public:
    /// A step of the load factor.
    struct Step
    {
      double       from, to;
      unsigned int increment;          // of the plan, from 1
      double       from_part, to_part; // of that increment, 0 to 1
      bool         is_whole;           // the whole of that increment
      bool         starts_increment;
      bool         ends_increment; // "to" is where the plan wants results
      bool         is_smallest;    // it will not be cut
    };

    /// An increment is cut at most @p max_cuts times to half, < 32.
    LoadSteps(const Parameters::Increments &increments,
              const unsigned int            max_cuts);

    /// Whether t = 1 is reached.
    bool finished() const;

    /// The step to try now.
    Step next() const;

    /// It converged after so many Newton steps: go on behind it.
    void accept(const unsigned int n_newton_steps);

    /// It did not: half of it next. Returns false, and changes nothing, if it
    /// is not to be cut any further.
    bool cut();

    /// The next step is as small as may be. Returns whether it was not.
    bool begin_small();

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &increment &position &depth &n_easy &failed;
    }

    /// Above, a step was hard: half of the 16 after which implicit codes
    /// commonly give up.
    static constexpr unsigned int few_newton_steps = 8;

  private:
    /// Positions within an increment and lengths of steps are counted in the
    /// smallest step: no round-off.
    std::uint32_t whole() const
    {
      return std::uint32_t(1) << max_cuts;
    }

    double load_factor(const std::uint32_t position) const;

    const Parameters::Increments increments;
    const unsigned int           max_cuts;
    unsigned int                 increment = 1;     // of the plan
    std::uint32_t                position  = 0;     // in it
    unsigned int                 depth     = 0;     // how often the step is cut
    unsigned int                 n_easy    = 0;     // steps, the last ones
    unsigned int                 failed    = never; // the depth that did

    static constexpr unsigned int never = static_cast<unsigned int>(-1);
  };
} // namespace Contact

#endif
