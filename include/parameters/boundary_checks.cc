/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Checks of supports, ties and loads beyond those of the entries' patterns.

#include <deal.II/base/patterns.h>

#include <algorithm>

#include "base/string_utilities.h"
#include "parameters/declared_entry.h"
#include "parameters/entry_checks.h"
#include "parameters/formula.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace
  {
    // Two entries that act on the same group although only one of them can.
    template<typename A, typename B>
    void check_disjoint(const std::map<std::string, A> &map,
                        const std::string              &entry,
                        const std::map<std::string, B> &other,
                        const std::string              &other_entry)
    {
      for (const auto &[key, value] : map)
        if (other.count(key) > 0)
          throw EntryError(in_quotes(key) + " is in " + entry + " and in " +
                             other_entry + ", which contradict each other.",
                           {entry, other_entry},
                           "remove " + in_quotes(key) + " from one of the two");
    }



    template<int n_variables>
    void check_formula(const std::string &formula,
                       const std::string &variables,
                       const std::string &entry,
                       const bool         in_time = false)
    {
      try
        {
          if (in_time)
            parse_formula_in_time<std::max(n_variables, 2)>(formula,
                                                            variables,
                                                            entry);
          else
            parse_formula<n_variables>(formula, variables, entry);
        }
      catch (const std::runtime_error &error)
        {
          const std::string unit = unit_behind_number(formula);
          const bool        is_variable =
            ("," + variables + ",").find("," + unit + ",") != std::string::npos;
          throw EntryError(error.what(),
                           {entry},
                           (unit.empty() || is_variable
                              ? std::string()
                              : "numbers have no unit here, such as " +
                                  in_quotes(unit) + "; ") +
                             "write a formula such as '2*" +
                             variables.substr(0, 1) +
                             " + 1'; there are ^, sin, min(a, b), "
                             "if(condition, a, b), pi and others");
        }
    }
  } // namespace



  void check_place_formula(const std::string &formula, const std::string &entry)
  {
    check_formula<3>(formula, "x,y,z", entry);
  }



  void check_history(const std::string &history, const std::string &entry)
  {
    if (!is_table(history))
      return check_formula<1>(history, "t", entry);
    try
      {
        parse_history(history, entry);
      }
    catch (const std::runtime_error &error)
      {
        throw EntryError(error.what(),
                         {entry},
                         "write pairs of t and a factor, with growing t, "
                         "such as 'table(0 0, 0.5 1, 1 -1)'");
      }
  }



  namespace Parameters
  {
    void Boundary::check() const
    {
      const std::string section      = "Boundary conditions/";
      const auto        moves_freely = [&](const auto        &loads,
                                    const std::string &entry,
                                    const auto        &displacement) {
        check_disjoint(loads,
                       section + entry,
                       displacement,
                       section + "Displacement " + entry.back());
      };
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::string in = std::string(" ") + "xyz"[c];
          moves_freely(force[c], "Force" + in, displacement[c]);
          moves_freely(resultant_force[c],
                       "Resultant force" + in,
                       displacement[c]);
          moves_freely(traction[c], "Traction" + in, displacement[c]);
          moves_freely(tied[c], "Tied" + in, displacement[c]);
          check_disjoint(moment[c],
                         section + "Moment" + in,
                         rotation[c],
                         section + "Rotation" + in);
          check_disjoint(displacement[c],
                         section + "Displacement" + in,
                         displacement_formula[c],
                         section + "Displacement formula" + in);
          for (const auto &[group, formula] : displacement_formula[c])
            check_formula<3>(formula,
                             "x,y,z,t",
                             section + "Displacement formula" + in,
                             /*in_time=*/true);
        }
      const auto check_formulas = [&](const auto        &formulas,
                                      const std::string &entry) {
        for (const auto &[group, formula] : formulas)
          check_place_formula(formula, section + entry);
      };
      check_formulas(pressure, "Pressure");
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::string in = std::string(" ") + "xyz"[c];
          check_formulas(traction[c], "Traction" + in);
          check_formulas(body_force[c], "Body force" + in);
        }
      std::vector<std::string> with_history;
      for (const auto &entry : entries_with_history())
        with_history.push_back(entry.first);
      for (const auto &[entry, formula] : histories)
        {
          if (std::count(with_history.begin(), with_history.end(), entry) == 0)
            throw EntryError(in_quotes(entry) + " has no history.",
                             {section + "Histories"},
                             "choose one of: " +
                               Patterns::Tools::to_string(with_history));
          check_history(formula, section + "Histories");
        }
      for (unsigned int c = 0; c < 3; ++c)
        for (const auto &[follower, leader] : tied[c])
          if (tied[c].count(leader) > 0)
            throw EntryError(in_quotes(follower) + " is tied to " +
                               in_quotes(leader) + ", which is tied itself.",
                             {section + "Tied " + "xyz"[c]},
                             "tie to a point that is not tied");
      check_rigid();
    }



    void Boundary::check_rigid() const
    {
      const std::string section = "Boundary conditions/", R = section + "Rigid";
      check_disjoint(displacement_normal,
                     section + "Displacement normal",
                     rigid,
                     R);
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::string in = std::string(" ") + "xyz"[c];
          check_disjoint(tied[c], section + "Tied" + in, rigid, R);
          check_keys(rotation[c], section + "Rotation" + in, rigid, R);
          check_keys(moment[c], section + "Moment" + in, rigid, R);
        }
    }



    std::vector<std::pair<std::string, bool>>
    Boundary::entries_with_history() const
    {
      std::vector<std::pair<std::string, bool>> entries;
      const auto add = [&](const std::string &entry, const auto &values) {
        for (unsigned int c = 0; c < 3; ++c)
          entries.emplace_back(entry + ' ' + "xyz"[c], !values[c].empty());
      };
      add("Displacement", displacement);
      entries.emplace_back("Displacement normal", !displacement_normal.empty());
      add("Rotation", rotation);
      add("Moment", moment);
      add("Force", force);
      add("Resultant force", resultant_force);
      entries.emplace_back("Pressure", !pressure.empty());
      add("Traction", traction);
      add("Body force", body_force);
      return entries;
    }



    std::string Boundary::entry_in_space() const
    {
      if (!displacement_formula[2].empty())
        return "Displacement formula z";
      if (!tied[2].empty())
        return "Tied z";
      for (const auto &[entry, is_set] : entries_with_history())
        {
          const bool is_rotation =
            entry.rfind("Rotation", 0) == 0 || entry.rfind("Moment", 0) == 0;
          const bool is_across = is_rotation == (entry.back() != 'z');
          if (is_across && (is_set || histories.count(entry) > 0))
            return entry;
        }
      return "";
    }
  } // namespace Parameters
} // namespace Contact
