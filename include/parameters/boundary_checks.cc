/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Checks of supports, ties and loads beyond those of the entries' patterns.

#include <deal.II/base/patterns.h>

#include <algorithm>

#include "base/string_utilities.h"
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
                       const std::string &entry)
    {
      try
        {
          parse_formula<n_variables>(formula, variables, entry);
        }
      catch (const std::runtime_error &error)
        {
          throw EntryError(error.what(),
                           {entry},
                           "write a formula such as '2*" +
                             variables.substr(0, 1) +
                             " + 1'; there are ^, sin, min(a, b), "
                             "if(condition, a, b), pi and others");
        }
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

  } // namespace



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
      moves_freely(force_x, "Force x", displacement_x);
      moves_freely(force_y, "Force y", displacement_y);
      moves_freely(resultant_force_x, "Resultant force x", displacement_x);
      moves_freely(resultant_force_y, "Resultant force y", displacement_y);
      moves_freely(traction_x, "Traction x", displacement_x);
      moves_freely(traction_y, "Traction y", displacement_y);
      moves_freely(tied_y, "Tied y", displacement_y);
      const auto check_formulas = [&](const auto        &formulas,
                                      const std::string &entry) {
        for (const auto &[group, formula] : formulas)
          check_formula<2>(formula, "x,y", section + entry);
      };
      check_formulas(pressure, "Pressure");
      check_formulas(traction_x, "Traction x");
      check_formulas(traction_y, "Traction y");
      check_formulas(body_force_x, "Body force x");
      check_formulas(body_force_y, "Body force y");
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
      for (const auto &[follower, leader] : tied_y)
        if (tied_y.count(leader) > 0)
          throw EntryError(in_quotes(follower) + " is tied to " +
                             in_quotes(leader) + ", which is tied itself.",
                           {section + "Tied y"},
                           "tie points to one that is not tied");
    }



    std::vector<std::pair<std::string, bool>>
    Boundary::entries_with_history() const
    {
      return {{"Displacement x", !displacement_x.empty()},
              {"Displacement y", !displacement_y.empty()},
              {"Force x", !force_x.empty()},
              {"Force y", !force_y.empty()},
              {"Resultant force x", !resultant_force_x.empty()},
              {"Resultant force y", !resultant_force_y.empty()},
              {"Pressure", !pressure.empty()},
              {"Traction x", !traction_x.empty()},
              {"Traction y", !traction_y.empty()},
              {"Body force x", !body_force_x.empty()},
              {"Body force y", !body_force_y.empty()}};
    }
  } // namespace Parameters
} // namespace Contact
