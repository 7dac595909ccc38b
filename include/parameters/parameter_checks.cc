/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Conditions on the entries of one section, beyond their patterns.

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "base/string_utilities.h"
#include "parameters/entry_checks.h"
#include "parameters/formula.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace
  {
    using Names = std::vector<std::string>;



    // With a coarser tolerance a loop ends before it begins.
    void check_tolerance(const double       value,
                         const double       coarsest,
                         const std::string &entry)
    {
      check_positive(value, entry);
      if (value > coarsest)
        throw EntryError(entry + " is " + Utilities::to_string(value) +
                           ", above " + Utilities::to_string(coarsest) + ".",
                         {entry},
                         "set a value between 0 and " +
                           Utilities::to_string(coarsest));
    }
  } // namespace



  namespace Parameters
  {
    void Element::check() const
    {
      if (degree == 1 && centre_node == CentreNode::free)
        throw EntryError("An element of degree 1 has no centre node to free.",
                         {"Element/Centre node", "Element/Degree"},
                         "set 'Degree = 2' for the 9-node element, or "
                         "'Centre node = serendipity'");
    }



    void Contact::check() const
    {
      if (is_left_out)
        return;
      if (std::any_of(name.begin(), name.end(), [](const unsigned char c) {
            return !std::isalnum(c) && c != ' ' && c != '_' && c != '-';
          }))
        throw EntryError(
          "The name of a contact pair is more than letters and digits.",
          {section() + "/Slave"},
          "use letters, digits, blanks, '_' and '-'");
      check_surfaces();
      check_positive(augmentation_parameter,
                     section() + "/Augmentation parameter");
      check_friction();
      check_excluded_points();
      check_obstacle_force();
      check_preload();
      if (!interference.empty())
        {
          check_history(interference, section() + "/Interference");
          if (tied || slave.empty())
            throw EntryError("There is no contact that could have an "
                             "interference.",
                             {section() + "/Interference"},
                             "remove the entry, or make it contact: a slave, "
                             "and 'Tied = false'");
        }
    }



    void Contact::check_surfaces() const
    {
      const Names surfaces = {section() + "/Slave", section() + "/Master"};
      if (is_automatic())
        {
          if (tied || !slave.empty() || !master.empty() || !obstacle.empty() ||
              !excluded_points.empty() || !interference.empty())
            throw EntryError("What is named here is not for pairs of all "
                             "bodies.",
                             {section() + "/Surfaces"},
                             "give it a section of its own, 'Contact NAME'");
          return;
        }
      if (!bodies.empty())
        throw EntryError("Bodies are named, and surfaces as well.",
                         {section() + "/Bodies", section() + "/Surfaces"},
                         "set 'Surfaces = automatic', or no bodies");
      if (!obstacle.empty())
        {
          const std::string entry = section() + "/Obstacle";
          if (!master.empty())
            throw EntryError("There is a master and an obstacle.",
                             {surfaces[1], entry},
                             "set one of the two");
          if (slave.empty())
            throw EntryError("Nothing touches the obstacle.",
                             {surfaces[0], entry},
                             "set the slave");
          check_obstacle(entry);
          check_obstacle_motion();
          return;
        }
      if (!obstacle_motion.empty())
        throw EntryError("There is no obstacle to move.",
                         {section() + "/Obstacle motion"},
                         "set the obstacle, or move supports of the master");
      if (slave.empty() != master.empty())
        throw EntryError("Contact takes two surfaces, but there is only one.",
                         surfaces,
                         "set both, or none for a case without contact");
      if (is_with_itself() &&
          (tied || discretization == ContactDiscretization::gauss))
        throw EntryError("A surface is in contact with itself, " +
                           in_quotes(slave) +
                           ", and glued, or paired in Gauss points.",
                         surfaces,
                         "set two different boundary groups, or "
                         "'Discretization = mortar' or 'nodal' without glue");
      if (slave.empty() && !name.empty())
        throw EntryError("A contact pair has no surfaces.",
                         surfaces,
                         "set both, or remove the section");
    }



    void Contact::check_friction() const
    {
      const std::string coulomb = section() + "/Friction coefficient";
      const std::string tresca  = section() + "/Tresca limit";
      if (slave.empty() && !is_automatic() && frictional())
        throw EntryError("There is friction, but no contact.",
                         {friction_coefficient > 0 ? coulomb : tresca,
                          section() + "/Slave",
                          section() + "/Master"},
                         "set slave and master, or no friction");
      if (tied && !has_point_per_multiplier())
        throw EntryError(
          "Surfaces are glued in nodes, and the discretization " +
            discretization.name() + " has none.",
          {section() + "/Tied", section() + "/Discretization"},
          "set 'Discretization = mortar' or 'Discretization = nodal'");
      if (friction_coefficient > 0 && tresca_limit > 0)
        throw EntryError("There are two laws of friction.",
                         {coulomb, tresca},
                         "set one of the two to 0");
      if (!elastic_slip.empty() && (tied || !frictional()))
        throw EntryError("There is no friction that could have an elastic "
                         "slip.",
                         {section() + "/Elastic slip",
                          tied ? section() + "/Tied" : coulomb},
                         "remove the entry, or make it contact with friction");
      try
        {
          parse_length(elastic_slip, 1);
        }
      catch (const std::runtime_error &)
        {
          throw EntryError("The elastic slip " + in_quotes(elastic_slip) +
                             " is no length above 0.",
                           {section() + "/Elastic slip"},
                           "give a length [mm] as '0.001', or a share of the "
                           "slave's edge as '0.5 %'; leave it empty for exact "
                           "sticking");
        }
    }



    void Contact::check_excluded_points() const
    {
      const std::string entry = section() + "/Excluded points";
      if (excluded_points.empty())
        return;
      if (slave.empty())
        throw EntryError("Points are excluded from contact, but there is "
                         "none.",
                         {entry, section() + "/Slave"},
                         "set slave and master, or leave the points empty");
      if (!has_point_per_multiplier())
        throw EntryError(
          "Points of the discretization " + discretization.name() +
            " are inside the faces: there is none to exclude at "
            "a node.",
          {entry, section() + "/Discretization"},
          "set 'Discretization = nodal', or leave the points empty");
      if (std::set<std::string>(excluded_points.begin(), excluded_points.end())
              .size() < excluded_points.size() ||
          std::count(excluded_points.begin(), excluded_points.end(), "") > 0)
        throw EntryError("A group is excluded twice or has no name.",
                         {entry},
                         "write each group once, separated by ','");
    }



    void Refinement::check() const
    {
      check_positive(tolerance, "Refinement/Tolerance");
    }



    void Solution::check() const
    {
      check_tolerance(geometry_tolerance, 0.1, "Solution/Geometry tolerance");
      check_tolerance(friction_tolerance, 0.1, "Solution/Friction tolerance");
      check_tolerance(newton_tolerance, 0.01, "Solution/Newton tolerance");
      check_positive(linear_tolerance, "Solution/Linear tolerance");
      if (!increments.are_ascending())
        throw EntryError("The load factors of the increments do not ascend "
                         "from above 0 to 1.",
                         {"Solution/Increments"},
                         "list where each of them ends: '0.01, 0.1, 1'");
      if (linear_tolerance >= 1)
        throw EntryError("The linear tolerance is not below 1.",
                         {"Solution/Linear tolerance"},
                         "a Newton step has to reduce the residual");
    }



    void Probes::check(const Symmetry symmetry) const
    {
      check_quantities();
      check_references();
      check_accuracy(symmetry);
    }



    void Probes::check_quantities() const
    {
      for (const auto &[name, probe] : probes)
        {
          if (probe.size() < 2 || probe.size() > 3 || probe[1].empty() ||
              probe.back().empty())
            throw EntryError("The probe " + in_quotes(name) +
                               " is not a quantity and a point or two.",
                             {"Probes/Probes"},
                             "write '" + name + ": quantity, point'");
          const auto quantities = named_values(Quantity());
          if (std::none_of(quantities.begin(),
                           quantities.end(),
                           [&what = probe[0]](const auto &quantity) {
                             return quantity.first == what;
                           }))
            throw EntryError("The probe " + in_quotes(name) +
                               " looks at an unknown quantity, " +
                               in_quotes(probe[0]) + ".",
                             {"Probes/Probes"},
                             "choose one of: " + Choice<Quantity>::names(", "));
        }
    }



    Probes::Definitions Probes::definitions() const
    {
      Definitions definitions;
      for (const auto &[name, probe] : probes)
        definitions.push_back(
          {name,
           {Choice<Quantity>(probe[0]), {probe.begin() + 1, probe.end()}}});
      const auto position = [&](const auto &definition) {
        return std::find(order.begin(), order.end(), definition.first);
      };
      std::stable_sort(definitions.begin(),
                       definitions.end(),
                       [&](const auto &a, const auto &b) {
                         return position(a) < position(b);
                       });
      return definitions;
    }



    void Probes::check_accuracy(const Symmetry symmetry) const
    {
      const std::string entry = "Probes/Accuracy";
      check_keys(accuracy, entry, probes, "Probes/Probes");
      for (const auto &[name, request] : requests())
        {
          const std::string unit =
            unit_of(Choice<Quantity>(probes.at(name)[0]), symmetry);
          if (!(request.value > 0) ||
              (request.unit != "%" && request.unit != unit))
            throw EntryError("The accuracy of " + in_quotes(name) + ", " +
                               in_quotes(accuracy.at(name)) +
                               ", is not a positive number of % or " + unit +
                               ".",
                             {entry},
                             "write '" + name + ": 0.1 %', or a number of " +
                               unit);
        }
    }



    std::map<std::string, Probes::Request> Probes::requests() const
    {
      std::map<std::string, Request> requests;
      for (const auto &[name, text] : accuracy)
        {
          std::istringstream in(text);
          Request            request{0, ""};
          std::string        rest;
          in >> request.value >> request.unit >> rest;
          if (!rest.empty())
            request.unit.clear();
          requests.insert({name, request});
        }
      return requests;
    }



    void Probes::check_references() const
    {
      const std::string reference = "Probes/References";
      const std::string tolerance = "Probes/Tolerances";
      check_keys(references, reference, probes, "Probes/Probes");
      check_keys(references, reference, tolerances, tolerance);
      check_keys(tolerances, tolerance, references, reference);
      for (const auto &[name, value] : references)
        if (value == 0)
          throw EntryError("The reference of " + in_quotes(name) +
                             " is 0: nothing can be compared relatively to it.",
                           {reference},
                           "probe a value that is not 0");
      for (const auto &[name, value] : tolerances)
        if (!(value > 0))
          throw EntryError("The tolerance of " + in_quotes(name) +
                             " is not positive.",
                           {tolerance},
                           "set a value greater than 0");
    }
  } // namespace Parameters
} // namespace Contact
