/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_progress_bar_h
#define contact_progress_bar_h

#include <chrono>
#include <string>

#include "output/summary.h"

namespace Contact
{
  /**
   * The share of a run that is done, as a bar on the last line of the screen
   * with the time that is left. Only on a terminal: a file gets nothing of it.
   * It is drawn anew ten times a second at most.
   */
  class ProgressBar
  {
  public:
    /// One that is not @p wanted draws nothing. @p n_levels follow the first
    /// mesh, each with about @p growth times the unknowns of the one before.
    ProgressBar(const bool         wanted,
                const unsigned int n_levels,
                const double       growth);
    ~ProgressBar();

    /// Draw it, in an increment behind so many Newton steps.
    void draw(const RunSummary &summary, const unsigned int newton_step);

    /// Remove it: other lines follow.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    /// The share before the present increment: increments count by load factor,
    /// meshes by their unknowns.
    double share_done(const RunSummary &summary) const;

    std::string time_left(const double share) const;

    const bool         is_on;
    const unsigned int n_levels;
    const double       growth;

    bool              is_drawn    = false;
    double            first_share = -1; // a restart goes on behind zero
    Clock::time_point first_time, last_time;
  };
} // namespace Contact

#endif
