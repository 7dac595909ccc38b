/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "summary.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

namespace Contact
{
  std::optional<double> ProbeResult::relative_deviation() const
  {
    if (!reference)
      return {};
    return value / *reference - 1;
  }



  bool ProbeResult::within() const
  {
    // Written such that a value that is not a number is outside.
    return !reference || !tolerance ||
           std::abs(*relative_deviation()) <= *tolerance;
  }



  bool RunSummary::passed() const
  {
    return converged &&
           std::all_of(increments.begin(),
                       increments.end(),
                       [](const auto &increment) {
                         return increment.violations.empty();
                       }) &&
           std::all_of(probes.begin(), probes.end(), [](const auto &probe) {
             return probe.within();
           });
  }



  std::map<std::string, PhaseTime> phase_times(const dealii::TimerOutput &timer)
  {
    using dealii::TimerOutput;
    std::map<std::string, PhaseTime> times;
    for (const auto &[phase, time] :
         timer.get_summary_data(TimerOutput::total_cpu_time))
      times[phase].cpu = time;
    for (const auto &[phase, time] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      times[phase].wall = time;
    for (const auto &[phase, n] : timer.get_summary_data(TimerOutput::n_calls))
      times[phase].calls = n;
    return times;
  }



  double peak_memory_mb()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    return memory.VmHWM / 1024.; // from kB
  }



  namespace
  {
    using Json = nlohmann::ordered_json;

    /// A value that may be missing is null then.
    Json to_json(const std::optional<double> &value)
    {
      return value ? Json(*value) : Json();
    }



    Json to_json(const ProbeResult &probe)
    {
      return {{"name", probe.name},
              {"value", probe.value},
              {"estimated_error", to_json(probe.error)},
              {"reference", to_json(probe.reference)},
              {"relative_deviation", to_json(probe.relative_deviation())},
              {"tolerance", to_json(probe.tolerance)}};
    }



    using ByZone = std::map<std::string, std::map<std::string, double>>;

    void add_zones(const ByZone &zones, Json &json)
    {
      for (const auto &[zone, values] : zones)
        json[zone.empty() ? "contact" : "contact " + zone] = values;
    }



    Json to_json(const IncrementRecord &increment)
    {
      Json json{{"level", increment.level},
                {"load_factor", increment.load_factor},
                {"newton_iterations", increment.newton_iterations},
                {"linear_iterations", increment.linear_iterations},
                {"friction_iterations", increment.friction_iterations},
                {"geometry_iterations", increment.geometry_iterations},
                {"active", increment.active},
                {"stick", increment.stick},
                {"slip", increment.slip},
                {"halved_steps", increment.halved_steps},
                {"cycles", increment.cycles},
                {"hold_work", increment.hold_work},
                {"converged", increment.converged},
                {"message", increment.message},
                {"invariants", increment.invariants},
                {"works", increment.works},
                {"violations", increment.violations},
                {"probes", increment.probes}};
      add_zones(increment.contact, json);
      return json;
    }



    Json to_json(const std::map<std::string, PhaseTime> &times)
    {
      Json json = Json::object();
      for (const auto &[phase, time] : times)
        {
          json[phase] = {{"cpu", time.cpu}, {"wall", time.wall}};
          if (time.calls > 0)
            json[phase]["calls"] = time.calls;
        }
      return json;
    }



    Json to_json(const LevelRecord &level)
    {
      return {{"cells", level.n_cells},
              {"displacements", level.n_displacements},
              {"multipliers", level.n_multipliers},
              {"newton_iterations", level.newton_iterations},
              {"linear_iterations", level.linear_iterations},
              {"probes", level.probes},
              {"time", to_json(level.time)},
              {"peak_memory_mb", level.peak_memory_mb}};
    }



    Json to_json(const RunSummary &summary)
    {
      Json json{{"converged", summary.converged},
                {"interrupted", summary.interrupted},
                {"message", summary.message},
                {"probes", Json::array()},
                {"increments", Json::array()},
                {"levels", Json::array()},
                {"unknowns",
                 {{"displacement", summary.n_displacements},
                  {"multipliers", summary.n_multipliers}}},
                {"contact", Json::object()},
                {"exact", summary.exact},
                {"errors", summary.errors},
                {"time", to_json(summary.time)},
                {"peak_memory_mb", summary.peak_memory_mb},
                {"effects", Json::object()},
                {"counters", summary.counters}};
      for (const ProbeResult &probe : summary.probes)
        json["probes"].push_back(to_json(probe));
      for (const IncrementRecord &increment : summary.increments)
        json["increments"].push_back(to_json(increment));
      for (const LevelRecord &level : summary.levels)
        json["levels"].push_back(to_json(level));
      add_zones(summary.contact, json);
      for (const auto &[effect, value] : summary.effects)
        json["effects"][effect] = value;
      return json;
    }



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
      return format(probe.unit == "MPa" ? "%.4f" : "%.7f", value);
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
                probe.error ? format("%.1e", *probe.error) : "-",
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



    std::vector<Line> make_lines(const RunSummary &summary)
    {
      std::vector<Line> lines;
      if (summary.converged)
        for (const ProbeResult &probe : summary.probes)
          lines.push_back(make_line(summary, probe));
      else
        lines.push_back(
          {summary.case_name,
           std::filesystem::path(summary.mesh_file).stem().string(),
           "-",
           "-",
           "-",
           "-",
           "-",
           "-",
           "NO"});
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



  void estimate_errors(RunSummary &summary)
  {
    const auto coarser =
      std::find_if(summary.levels.rbegin(),
                   summary.levels.rend(),
                   [&](const LevelRecord &level) {
                     return 2 * level.n_displacements <=
                            summary.levels.back().n_displacements;
                   });
    if (coarser != summary.levels.rend())
      for (ProbeResult &probe : summary.probes)
        probe.error = std::abs(probe.value - coarser->probes.at(probe.name));
  }



  void estimate_errors(RunSummary                     &summary,
                       const std::vector<ProbeResult> &finer)
  {
    for (unsigned int i = 0; i < summary.probes.size(); ++i)
      summary.probes[i].error =
        2 * std::abs(summary.probes[i].value - finer[i].value);
  }



  void write_summary(const RunSummary &summary, std::ostream &out)
  {
    out << to_json(summary).dump(2) << '\n';
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

    for (const RunSummary &summary : summaries)
      if (!summary.converged)
        out << summary.case_name << ": " << summary.message << '\n';
  }
} // namespace Contact
