/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/history.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <ostream>
#include <utility>

namespace Contact
{
  namespace
  {
    /// Columns in the order of the table, and their values by name.
    using Row = std::vector<std::pair<std::string, double>>;

    /// The unit of what a contact pair or a group of supports has, by a part of
    /// its name.
    std::string unit_of(const std::string &name, const HistoryUnits &units)
    {
      const std::vector<std::pair<std::string, std::string>> by_part{
        {"pressure", "MPa"},
        {"shear", "MPa"},
        {"width", "mm"},
        {"area", "mm^2"},
        {"moment", units.work},
        {"motion", "mm"},
        {"shortening", "mm"},
        {"turn", "degrees"}};
      const auto found =
        std::find_if(by_part.begin(), by_part.end(), [&](const auto &entry) {
          return name.find(entry.first) != std::string::npos;
        });
      return found == by_part.end() ? units.force : found->second;
    }



    Row row_of(const IncrementRecord &increment, const HistoryUnits &units)
    {
      Row        row{{"t [-]", increment.load_factor},
              {"Newton steps [-]", increment.newton_iterations}};
      const auto add = [&](const std::string &name,
                           const std::string &unit,
                           const double       value) {
        row.emplace_back(name + " [" + unit + "]", value);
      };
      for (const auto &[name, unit] : units.probes)
        if (const auto probe = increment.probes.find(name);
            probe != increment.probes.end())
          add(name, unit, probe->second);
      for (const auto &[name, values] : increment.contact)
        for (const auto &[key, value] : values)
          add("contact " + name + (name.empty() ? "" : " ") + key,
              unit_of(key, units),
              value);
      for (const auto &[group, values] : increment.reactions)
        for (const auto &[direction, value] : values)
          add("reaction " + group + " " + direction,
              unit_of(direction, units),
              value);
      for (const auto &[kind, value] : increment.works)
        add("work " + kind, units.work, value);
      return row;
    }



    /// Names are quoted, as those of groups may have commas.
    void print_names(const std::vector<std::string> &names, std::ostream &out)
    {
      std::string separator;
      for (const std::string &name : names)
        {
          out << separator << std::quoted(name, '"', '"');
          separator = ",";
        }
      out << '\n';
    }
  } // namespace



  void write_history(const RunSummary   &summary,
                     const HistoryUnits &units,
                     std::ostream       &out)
  {
    std::vector<Row>         rows;
    std::vector<std::string> names;
    for (const IncrementRecord &increment : summary.increments)
      if (increment.converged &&
          increment.level == summary.increments.back().level)
        {
          rows.push_back(row_of(increment, units));
          for (const auto &[name, value] : rows.back())
            if (std::find(names.begin(), names.end(), name) == names.end())
              names.push_back(name);
        }
    print_names(names, out);
    out << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (const Row &row : rows)
      {
        std::string separator;
        for (const std::string &name : names)
          {
            out << separator;
            const auto value =
              std::find_if(row.begin(), row.end(), [&](const auto &field) {
                return field.first == name;
              });
            if (value != row.end())
              out << value->second;
            separator = ",";
          }
        out << '\n';
      }
  }
} // namespace Contact
