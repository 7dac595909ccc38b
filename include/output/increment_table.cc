/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/increment_table.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

namespace Contact
{
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
      out << std::setprecision(6) << value;
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



    const std::size_t widest_line     = 110;
    const std::size_t width_of_number = 12; // six digits, sign and exponent
    const std::size_t width_of_time   = 9;
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
} // namespace Contact
