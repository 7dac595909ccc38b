/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/result_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

namespace Contact
{
  namespace
  {
    /// The fields of a line of a table, as many as its first line has.
    using Line = std::vector<std::string>;

    const Line header{"case",
                      "mesh",
                      "probe",
                      "computed",
                      "error est.",
                      "reference",
                      "deviation",
                      "tolerance",
                      "ok"};



    template<typename... Numbers>
    std::string format(const char *pattern, const Numbers... numbers)
    {
      std::array<char, 64> text;
      std::snprintf(text.data(), text.size(), pattern, numbers...);
      return text.data();
    }



    /// Eight digits, with the decimal points of one unit below each other.
    std::string format_value(const ProbeResult &probe, const double value)
    {
      return format(probe.is_displacement ? "%.7f" : "%.4f", value);
    }



    /// In percent; a deviation below the last digit has no sign.
    std::string format_deviation(const double relative)
    {
      const std::string text = format("%+.5f", 100 * relative);
      const bool none = text.find_first_of("123456789") == std::string::npos;
      return (none && std::isfinite(relative) ? "0.00000" : text) + " %";
    }



    Line make_line(const RunSummary &summary, const ProbeResult &probe)
    {
      Line line{summary.case_name,
                std::filesystem::path(summary.mesh_file).stem().string(),
                probe.name + " [" + probe.unit + "]",
                format_value(probe, probe.value),
                probe.error ? (probe.error_may_be_larger ? ">" : "") +
                                format("%.1e", *probe.error)
                            : "-",
                "-",
                "-",
                "-",
                "-"};
      if (probe.reference && probe.tolerance)
        {
          line[5] = format_value(probe, *probe.reference);
          line[6] = format_deviation(*probe.relative_deviation());
          line[7] = format("%g %%", 100 * *probe.tolerance);
          line[8] = probe.within() ? "yes" : "NO";
        }
      return line;
    }



    /// Print lines as a table, the first one as its head; the columns that are
    /// @p numbers to the right, those that are empty not at all.
    void print_lines(std::ostream                 &out,
                     const std::vector<Line>      &lines,
                     const std::set<unsigned int> &numbers)
    {
      const unsigned int       n_columns = lines.front().size();
      std::vector<std::size_t> width(n_columns, 0);
      for (const Line &line : lines)
        for (unsigned int c = 0; c < n_columns; ++c)
          width[c] = std::max(width[c], line[c].size());

      for (unsigned int l = 0; l < lines.size(); ++l)
        {
          std::string text, rule;
          for (unsigned int c = 0; c < n_columns; ++c)
            {
              if (width[c] == 0)
                continue;
              const std::string fill(width[c] - lines[l][c].size(), ' ');
              text += c == 0 ? "" : " | ";
              text +=
                numbers.count(c) > 0 ? fill + lines[l][c] : lines[l][c] + fill;
              rule += c == 0 ? "" : "-+-";
              rule += std::string(width[c], '-');
            }
          out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
          if (l == 0)
            out << rule << '\n';
        }
    }



    /// The estimator of the error of a probe, or why there is none.
    std::string kind_of_error(const ProbeResult &probe)
    {
      if (!probe.error)
        return probe.not_estimated.empty()
                 ? ""
                 : "not estimated: " + probe.not_estimated;
      // No mesh before says anything for it or against it.
      if (!probe.error_is_confirmed && !probe.error_may_be_larger)
        return "twice the estimate by " + probe.estimator +
               " on this mesh alone";
      return probe.estimator +
             (probe.error_may_be_larger ? "; >: it may be larger" : "");
    }



    /// A line for each kind, with its cases if there are others.
    void print_kinds_of_errors(std::ostream                  &out,
                               const std::vector<RunSummary> &summaries)
    {
      std::map<std::string, std::set<std::string>> kinds;
      for (const RunSummary &summary : summaries)
        if (summary.converged)
          for (const ProbeResult &probe : summary.probes)
            if (const std::string kind = kind_of_error(probe); !kind.empty())
              kinds[kind].insert(summary.case_name);
      for (const auto &[kind, cases] : kinds)
        {
          out << "error est.";
          if (cases.size() < summaries.size())
            for (const std::string &name : cases)
              out << (name == *cases.begin() ? " of " : ", ") << name;
          out << ": " << kind << '\n';
        }
    }



    std::vector<Line> make_lines(const RunSummary &summary)
    {
      std::vector<Line> lines;
      if (summary.converged)
        for (const ProbeResult &probe : summary.probes)
          lines.push_back(make_line(summary, probe));
      else
        {
          Line line(header.size(), "-");
          line[0] = summary.case_name;
          line[1] = std::filesystem::path(summary.mesh_file).stem().string();
          line.back() = "NO";
          lines.push_back(line);
        }
      return lines;
    }
  } // namespace



  void print_levels(std::ostream &out, const RunSummary &summary)
  {
    std::set<std::string> phases;
    for (const LevelRecord &level : summary.levels)
      for (const auto &[phase, time] : level.time)
        phases.insert(phase);

    Line header{"cells", "unknowns", "Newton", "linear"};
    header.insert(header.end(), phases.begin(), phases.end());
    for (const char *name : {"total", "growth", "MB"})
      header.push_back(name);

    std::vector<Line> lines{header};
    double            last_total = 0, last_unknowns = 0;
    for (const LevelRecord &level : summary.levels)
      {
        Line   line{std::to_string(level.n_cells),
                  std::to_string(level.n_displacements),
                  std::to_string(level.newton_iterations),
                  std::to_string(level.linear_iterations)};
        double total = 0;
        for (const std::string &phase : phases)
          {
            const auto   found = level.time.find(phase);
            const double wall =
              found == level.time.end() ? 0. : found->second.wall;
            line.push_back(format("%.3f", wall));
            total += wall;
          }
        const double unknowns = level.n_displacements;
        line.push_back(format("%.3f", total));
        line.push_back(last_total > 0 && unknowns > 1.5 * last_unknowns
                         ? format("%.2f",
                                  std::log(total / last_total) /
                                    std::log(unknowns / last_unknowns))
                         : "-");
        line.push_back(format("%.0f", level.peak_memory_mb));
        lines.push_back(line);
        last_total    = total;
        last_unknowns = unknowns;
      }

    std::set<unsigned int> numbers;
    for (unsigned int column = 0; column < header.size(); ++column)
      numbers.insert(column);
    out << "Wall time in seconds:\n";
    print_lines(out, lines, numbers);
  }



  void print_table(std::ostream &out, const std::vector<RunSummary> &summaries)
  {
    std::vector<Line> lines{header};
    for (const RunSummary &summary : summaries)
      for (const Line &line : make_lines(summary))
        lines.push_back(line);

    // Nothing was estimated: no column for it.
    const unsigned int column = 4;
    if (std::all_of(lines.begin() + 1, lines.end(), [&](const Line &line) {
          return line[column] == "-";
        }))
      for (Line &line : lines)
        line[column].clear();

    // Names to the left, numbers to the right.
    print_lines(out, lines, {3, 4, 5, 6, 7});
    print_kinds_of_errors(out, summaries);

    for (const RunSummary &summary : summaries)
      if (!summary.converged)
        out << summary.case_name << ": " << summary.message << '\n';
  }
} // namespace Contact
