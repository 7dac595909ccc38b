/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_run_log_h
#define contact_run_log_h

#include <boost/iostreams/stream.hpp>
#include <boost/iostreams/tee.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parameters/choices.h"

namespace Contact
{
  /**
   * The log of a run, which has all lines, and the screen, which has those of
   * the log that are asked for. Nothing is written to either but on the first
   * rank. Lines from before the log's file is opened come first in it.
   */
  class RunLog
  {
  public:
    RunLog(const Parameters::Screen screen, const bool is_first_rank);

    /// Write the log to a file from here on, behind what it has if @p appends.
    void open(const std::filesystem::path &file, const bool appends);

    /// The stream of iterations and tables of cost, which the screen only has
    /// if it has everything; that of what the screen has unless it is to have
    /// less than that; and that of the log alone.
    std::ostream &details();
    std::ostream &lines();
    std::ostream &log_only();

    /// Whether the screen has the lines, but not the details.
    bool has_lines_only() const;

    const bool is_active;

  private:
    using Tee = boost::iostreams::tee_device<std::ostream, std::ostream>;

    const Parameters::Screen      screen;
    std::stringbuf                early_lines;
    std::filebuf                  file;
    std::ostream                  log;
    boost::iostreams::stream<Tee> both;
  };
} // namespace Contact

#endif
