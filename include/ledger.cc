/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "ledger.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Contact
{
  namespace
  {
    /// What an effect entails, and which entry asks for it.
    struct Cause
    {
      std::string entails;
      std::string entry;
    };



    std::string pairing(const std::string &geometry)
    {
      if (geometry == "undeformed")
        return "paired once";
      if (geometry == "fixed point")
        return "a loop that pairs the bodies and solves";
      if (geometry == "each step")
        return "paired before each Newton step";
      return "paired before each Newton step, projections in the tangent";
    }



    std::string bound(const Parameters::All &parameters)
    {
      if (parameters.contact.tied)
        return "normal and tangential multipliers, no decisions";
      if (!parameters.contact.frictional())
        return "no tangential unknowns";
      if (parameters.contact.tresca_limit > 0)
        return "tangential multipliers, a bound that stays";
      if (parameters.solution.friction == "fixed point")
        return "tangential multipliers, a loop over Tresca problems";
      if (parameters.solution.friction == "each step")
        return "tangential multipliers, a bound for each Newton step";
      return "tangential multipliers, the bound in the tangent";
    }



    /// By the names of RunSummary::effects.
    std::map<std::string, Cause> find_causes(const RunSummary      &summary,
                                             const Parameters::All &parameters)
    {
      const auto       &output = parameters.output;
      const std::string solve =
        parameters.contact.slave.empty() || parameters.contact.tied
          ? "no active set"
          : "active set";
      const bool linear = parameters.solids.kinematics == "small strain";
      std::map<std::string, Cause> causes{
        {"kinematics",
         {linear ? "one tangent on a mesh" : "a tangent for each Newton step",
          "Solids/Kinematics"}},
        {"element",
         {std::to_string(summary.n_displacements) + " displacements",
          "Element/Degree"}},
        {"contact",
         {std::to_string(summary.n_multipliers) + " multipliers, " + solve,
          parameters.contact.tied ? "Contact/Tied" : "Contact/Slave"}},
        {"friction",
         {bound(parameters),
          parameters.contact.tresca_limit > 0
            ? "Contact/Tresca limit"
            : "Contact/Friction coefficient"}},
        {"geometry",
         {parameters.contact.tied ? "paired once"
                                  : pairing(parameters.solution.geometry),
          "Solution/Geometry"}},
        {"system",
         {parameters.is_condensed() ? "multipliers eliminated"
                                    : "multipliers are unknowns",
          parameters.solution.linear_solver != "automatic"
            ? "Solution/Linear solver"
            : "Solution/System"}},
        {"increments",
         {"each starts from the last one", "Solution/Increments"}},
        {"levels",
         {parameters.refinement.strategy == "adaptive" &&
              parameters.refinement.n_levels > 0
            ? "stresses recovered and errors estimated on each"
            : "each starts from the last one",
          "Refinement/Levels"}},
        {"files",
         {output.vtu || output.profile ? "stresses recovered"
                                       : "no stress for them",
          output.vtu ? "Output/VTU" : "Output/Profile"}}};
      return causes;
    }
  } // namespace



  void print_effects(std::ostream          &out,
                     const RunSummary      &summary,
                     const Parameters::All &parameters)
  {
    const auto  causes = find_causes(summary, parameters);
    std::size_t width  = 0;
    for (const auto &[effect, choice] : summary.effects)
      width = std::max(width, choice.size());
    for (const auto &[effect, choice] : summary.effects)
      {
        const Cause &cause = causes.at(effect);
        out << "  " << std::left << std::setw(12) << effect
            << std::setw(width + 2) << choice << std::right << cause.entails
            << " (" << cause.entry << ")\n";
      }
    out << std::flush;
  }



  void print_counters(std::ostream &out, const RunSummary &summary)
  {
    std::string done, not_done;
    for (const auto &[counter, n] : summary.counters)
      {
        std::string name = counter;
        std::replace(name.begin(), name.end(), '_', ' ');
        std::string &list = n > 0 ? done : not_done;
        list += (list.empty() ? "" : ", ") + name;
        if (n > 0)
          list += ' ' + std::to_string(n);
      }
    for (const auto &[head, list] : {std::make_pair("Done: ", done),
                                     std::make_pair("Not at all: ", not_done)})
      if (!list.empty())
        {
          std::string indent;
          for (const std::string &line :
               dealii::Utilities::break_text_into_lines(head + list, 78))
            {
              out << indent << line << '\n';
              indent = "  ";
            }
        }
  }
} // namespace Contact
