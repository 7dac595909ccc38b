/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_screen_h
#define contact_screen_h

#include <boost/iostreams/stream.hpp>
#include <boost/iostreams/tee.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "output/history.h"
#include "output/summary.h"
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



  /**
   * The increments on the screen, one a line: t, Newton steps, the contact
   * force of each pair, the largest pressure of all, the probes and the time.
   * Lines end at 110 characters: probes go first, then forces, and what has no
   * place is in history.csv alone.
   */
  class IncrementTable
  {
  public:
    /// The columns, by the names of the contact pairs and the units.
    void set_columns(const std::vector<std::string> &pairs,
                     const HistoryUnits             &units);

    /// The head: names, and units below them.
    std::string head() const;

    /// The row of an increment that took @p seconds. What it has no value of,
    /// as of stresses on coarser meshes, has a dash.
    std::string row(const IncrementRecord &increment,
                    const double           seconds) const;

    /// That of an attempt which has no solution.
    std::string row_without_solution(const IncrementRecord &increment,
                                     const double           seconds) const;

  private:
    struct Column
    {
      std::string name, unit;
      std::size_t narrowest;

      std::function<std::optional<double>(const IncrementRecord &)> value;

      /// With a blank before it.
      std::size_t width() const;
    };

    std::string line(const std::function<std::string(const Column &)> &field,
                     const std::string &last) const;

    std::vector<Column> columns;
    bool                is_complete = true;
  };



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
