/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/screen.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <unistd.h>

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



  namespace
  {
    std::string aligned(const std::string &text, const std::size_t width)
    {
      std::ostringstream out;
      out << std::setw(width) << text;
      return out.str();
    }



    std::string six_digits(const double value)
    {
      std::ostringstream out;
      out << std::setprecision(6) << (std::abs(value) < 1e-99 ? 0 : value);
      return out.str();
    }



    std::optional<double> find(const std::map<std::string, double> &values,
                               const std::string                   &name)
    {
      const auto found = values.find(name);
      return found == values.end() ? std::optional<double>() : found->second;
    }



    std::string format_seconds(const double seconds)
    {
      std::ostringstream out;
      out << std::fixed << std::setprecision(seconds < 10 ? 2 : 0) << seconds;
      return out.str();
    }



    const std::size_t widest_line = 110;
    const std::size_t width_of_number =
      12; // six digits, sign, two of the exponent
    const std::size_t width_of_time = 9;
  } // namespace



  std::size_t IncrementTable::Column::width() const
  {
    return 1 + std::max({name.size(), unit.size() + 2, narrowest});
  }



  void IncrementTable::set_columns(const std::vector<std::string> &pairs,
                                   const HistoryUnits             &units)
  {
    columns = {{"t", "-", 6, [](const auto &i) { return i.load_factor; }},
               {"Newton", "steps", 6, [](const auto &i) {
                  return i.newton_iterations;
                }}};
    const Column pressure{"max pressure",
                          "MPa",
                          width_of_number,
                          [](const auto &i) {
                            std::optional<double> most;
                            for (const auto &of_pair : i.contact)
                              if (const auto p =
                                    find(of_pair.second, "max_pressure"))
                                most = std::max(most.value_or(*p), *p);
                            return most;
                          }};

    std::size_t total = width_of_time + (pairs.empty() ? 0 : pressure.width());
    for (const Column &column : columns)
      total += column.width();
    const auto add = [&](const Column &column, std::vector<Column> &group) {
      is_complete = is_complete && total + column.width() <= widest_line;
      if (total + column.width() > widest_line)
        return;
      total += column.width();
      group.push_back(column);
    };
    std::vector<Column> probes, forces;
    for (const auto &[name, unit] : units.probes)
      add({name,
           unit,
           width_of_number,
           [name = name](const auto &i) { return find(i.probes, name); }},
          probes);
    for (const std::string &name : pairs)
      add({name.empty() ? "contact force" : name + " force",
           units.force,
           width_of_number,
           [name](const auto &i) {
             const auto found = i.contact.find(name);
             return found == i.contact.end()
                      ? std::optional<double>()
                      : find(found->second, "normal_force");
           }},
          forces);
    columns.insert(columns.end(), forces.begin(), forces.end());
    if (!pairs.empty())
      columns.push_back(pressure);
    columns.insert(columns.end(), probes.begin(), probes.end());
  }



  std::string
  IncrementTable::line(const std::function<std::string(const Column &)> &field,
                       const std::string &last) const
  {
    std::string text;
    for (const Column &column : columns)
      text += aligned(field(column), column.width());
    return text + aligned(last, width_of_time) + '\n';
  }



  std::string IncrementTable::head() const
  {
    const auto name = [](const Column &column) { return column.name; };
    const auto unit = [](const Column &column) {
      return '[' + column.unit + ']';
    };
    return line(name, "time") + line(unit, "[s]") +
           (is_complete ? "" : "  (more columns in history.csv)\n");
  }



  std::string IncrementTable::row(const IncrementRecord &increment,
                                  const double           seconds) const
  {
    return line(
      [&](const Column &column) {
        const auto value = column.value(increment);
        return value ? six_digits(*value) : "-";
      },
      format_seconds(seconds));
  }



  std::string
  IncrementTable::row_without_solution(const IncrementRecord &increment,
                                       const double           seconds) const
  {
    std::string text;
    for (unsigned int c = 0; c < 2; ++c)
      text +=
        aligned(six_digits(*columns[c].value(increment)), columns[c].width());
    return text + "  no solution, " + format_seconds(seconds) + " s\n";
  }



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
