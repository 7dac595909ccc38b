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
           std::all_of(probes.begin(), probes.end(), [](const auto &probe) {
             return probe.within();
           });
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
              {"reference", to_json(probe.reference)},
              {"relative_deviation", to_json(probe.relative_deviation())},
              {"tolerance", to_json(probe.tolerance)}};
    }



    Json to_json(const IncrementRecord &increment)
    {
      return {{"level", increment.level},
              {"load_factor", increment.load_factor},
              {"newton_iterations", increment.newton_iterations},
              {"linear_iterations", increment.linear_iterations},
              {"friction_iterations", increment.friction_iterations},
              {"geometry_iterations", increment.geometry_iterations},
              {"active", increment.active},
              {"stick", increment.stick},
              {"slip", increment.slip},
              {"converged", increment.converged}};
    }



    Json to_json(const RunSummary &summary)
    {
      Json json{{"converged", summary.converged},
                {"probes", Json::array()},
                {"increments", Json::array()},
                {"unknowns",
                 {{"displacement", summary.n_displacements},
                  {"multipliers", summary.n_multipliers}}},
                {"time", Json::object()},
                {"peak_memory_mb", summary.peak_memory_mb},
                {"effects", Json::object()}};
      for (const ProbeResult &probe : summary.probes)
        json["probes"].push_back(to_json(probe));
      for (const IncrementRecord &increment : summary.increments)
        json["increments"].push_back(to_json(increment));
      for (const auto &[phase, time] : summary.time)
        json["time"][phase] = {{"cpu", time.cpu}, {"wall", time.wall}};
      for (const auto &[effect, value] : summary.effects)
        json["effects"][effect] = value;
      return json;
    }



    // The columns of the final table.
    constexpr unsigned int n_columns = 8;
    using Line                       = std::array<std::string, n_columns>;

    const Line header{{"case",
                       "mesh",
                       "probe",
                       "computed",
                       "reference",
                       "deviation",
                       "tolerance",
                       "ok"}};

    /// Numbers stand to the right.
    bool is_number(const unsigned int column)
    {
      return column >= 3 && column <= 6;
    }



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
      Line line{{summary.case_name,
                 std::filesystem::path(summary.mesh_file).stem().string(),
                 probe.name + " [" + probe.unit + "]",
                 format_value(probe, probe.value),
                 "-",
                 "-",
                 "-",
                 "-"}};
      if (probe.reference && probe.tolerance)
        {
          line[4] = format_value(probe, *probe.reference);
          line[5] = format_deviation(*probe.relative_deviation());
          line[6] = format("%g %%", 100 * *probe.tolerance);
          line[7] = probe.within() ? "yes" : "NO";
        }
      return line;
    }



    std::vector<Line> make_lines(const RunSummary &summary)
    {
      std::vector<Line> lines;
      if (summary.converged)
        for (const ProbeResult &probe : summary.probes)
          lines.push_back(make_line(summary, probe));
      else
        lines.push_back(
          {{summary.case_name,
            std::filesystem::path(summary.mesh_file).stem().string(),
            "-",
            "-",
            "-",
            "-",
            "-",
            "NO"}});
      return lines;
    }
  } // namespace



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

    std::array<std::size_t, n_columns> width{};
    for (const Line &line : lines)
      for (unsigned int c = 0; c < n_columns; ++c)
        width[c] = std::max(width[c], line[c].size());

    for (unsigned int l = 0; l < lines.size(); ++l)
      {
        std::string text, rule;
        for (unsigned int c = 0; c < n_columns; ++c)
          {
            const std::string fill(width[c] - lines[l][c].size(), ' ');
            text += c == 0 ? "" : " | ";
            text += is_number(c) ? fill + lines[l][c] : lines[l][c] + fill;
            rule += c == 0 ? "" : "-+-";
            rule += std::string(width[c], '-');
          }
        out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
        if (l == 0)
          out << rule << '\n';
      }

    for (const RunSummary &summary : summaries)
      if (!summary.converged)
        out << summary.case_name << ": " << summary.message << '\n';
  }
} // namespace Contact
