/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/run_log.h"

#include <iostream>

namespace Contact
{
  // Without a buffer of its own: lines to one and to both keep their order.
  RunLog::RunLog(const Parameters::Screen screen, const bool is_first_rank)
    : is_active(is_first_rank)
    , screen(screen)
    , log(&early_lines)
    , both(Tee(std::cout, log), /*buffer_size=*/0)
  {
  }



  void RunLog::open(const std::filesystem::path &path, const bool appends)
  {
    if (!is_active || file.is_open())
      return;
    file.open(path,
              std::ios::out | (appends ? std::ios::app : std::ios::trunc));
    log.rdbuf(&file);
    log << early_lines.str() << std::flush;
  }



  std::ostream &RunLog::details()
  {
    return screen == Parameters::Screen::full ? both : log;
  }



  std::ostream &RunLog::lines()
  {
    return screen == Parameters::Screen::full || has_lines_only() ? both : log;
  }



  std::ostream &RunLog::log_only()
  {
    return log;
  }



  bool RunLog::has_lines_only() const
  {
    return screen == Parameters::Screen::increments;
  }
} // namespace Contact
