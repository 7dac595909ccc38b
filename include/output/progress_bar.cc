/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace Contact
{
  namespace
  {
    const char *const rest_of_line = "\033[K"; // erases it



    std::string format_duration(const double seconds)
    {
      const long         s = std::lround(seconds);
      std::ostringstream text;
      if (s >= 3600)
        text << s / 3600 << " h ";
      if (s >= 60)
        text << s / 60 % 60 << " min ";
      if (s < 600)
        text << s % 60 << " s ";
      return text.str();
    }
  } // namespace



  ProgressBar::ProgressBar(const bool         wanted,
                           const unsigned int n_levels,
                           const double       growth)
    : is_on(wanted && isatty(STDOUT_FILENO) != 0)
    , n_levels(n_levels)
    , growth(growth)
  {
  }



  ProgressBar::~ProgressBar()
  {
    clear();
  }



  double ProgressBar::share_done(const RunSummary &summary) const
  {
    const unsigned int level  = summary.increments.back().level;
    double             before = 0;
    for (const LevelRecord &record : summary.levels)
      before += record.n_displacements;
    const double here = summary.n_displacements;
    double       next = here, all = before + here;
    for (unsigned int k = level + 1; k <= n_levels; ++k)
      {
        next *= growth;
        all += next;
      }
    const auto   last = std::find_if(summary.increments.rbegin(),
                                   summary.increments.rend(),
                                   [](const IncrementRecord &record) {
                                     return record.converged;
                                   });
    const double t = last != summary.increments.rend() && last->level == level
                       ? last->load_factor
                       : 0.;
    return (before + t * here) / all;
  }



  std::string ProgressBar::time_left(const double share) const
  {
    if (share <= first_share)
      return "";
    const std::chrono::duration<double> so_far = Clock::now() - first_time;
    return format_duration(so_far.count() * (1 - share) /
                           (share - first_share)) +
           "left";
  }



  // The cursor stays at the start of the line: what anybody writes next is
  // written over the bar.
  void ProgressBar::draw(const RunSummary  &summary,
                         const unsigned int newton_step)
  {
    if (!is_on)
      return;
    const auto now = Clock::now();
    if (first_share >= 0 && now < last_time + std::chrono::milliseconds(100))
      return;
    const double share = share_done(summary);
    if (first_share < 0)
      {
        first_share = share;
        first_time  = now;
      }
    last_time                 = now;
    is_drawn                  = true;
    const unsigned int n      = 30;
    const auto         n_done = static_cast<unsigned int>(share * n);
    std::cout << '[' << std::string(n_done, '#') << std::string(n - n_done, '.')
              << "] " << std::lround(100 * share) << " %, t "
              << summary.increments.back().load_factor << ", Newton step "
              << newton_step << "  " << time_left(share) << rest_of_line << '\r'
              << std::flush;
  }



  void ProgressBar::clear()
  {
    if (is_drawn)
      std::cout << rest_of_line << std::flush;
    is_drawn = false;
  }
} // namespace Contact
