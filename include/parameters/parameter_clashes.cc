/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Conditions on entries of several sections together.

#include <algorithm>

#include "base/string_utilities.h"
#include "parameters/dual_quantities.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    namespace
    {
      const std::string system_entry = "Solution/System";
      const std::string solver_entry = "Solution/Linear solver";
    } // namespace



    void All::check() const
    {
      mesh.check();
      element.check();
      solids.check();
      boundary.check();
      contact.check();
      std::vector<std::string> automatic;
      if (contact.is_automatic())
        automatic.push_back(contact.section() + "/Surfaces");
      for (const auto &[name, further] : further_contacts)
        {
          further.check();
          if (further.is_automatic())
            automatic.push_back(further.section() + "/Surfaces");
        }
      if (automatic.size() > 1)
        throw EntryError("Two sections stand for pairs of all bodies.",
                         automatic,
                         "name the surfaces in one of them");
      solution.check();
      refinement.check();
      probes.check(solids.symmetry);

      if (element.degree > 1 && !solids.incompatible_modes.empty())
        throw EntryError("Cells of degree 2 bend without incompatible modes.",
                         {"Solids/Incompatible modes", "Element/Degree"},
                         "remove the modes, or set 'Degree = 1'");
      if (solution.geometry == GeometryLoop::undeformed &&
          !solids.kinematics.all_are(Strains::small))
        throw EntryError("Large displacements are not those of undeformed "
                         "surfaces.",
                         {"Solution/Geometry", "Solids/Kinematics"},
                         "set 'Kinematics = small strain', or another "
                         "geometry");
      check_points();
      check_obstacles();
      check_dual_problems();
      check_limits();
      if (n_ranks > 1)
        check_ranks();
      if (is_condensed())
        check_condensed();
      else
        check_saddle_point();
    }



    // Every multiplier is seen by a point, or the saddle point is singular.
    void All::check_points() const
    {
      for (const Contact &contact_pair : pairs())
        if (contact_pair.discretization == ContactDiscretization::gauss &&
            contact_pair.n_gauss_points <= element.degree)
          throw EntryError(
            "With " + std::to_string(contact_pair.n_gauss_points) +
              " Gauss points an edge there are multipliers that no point sees.",
            {contact_pair.section() + "/Gauss points", "Element/Degree"},
            "set 'Gauss points = " + std::to_string(element.degree + 1) +
              "' or more");
    }



    std::optional<Contact> All::shared_pair() const
    {
      for (const Contact &contact_pair : pairs())
        if (!contact_pair.has_point_per_multiplier())
          return contact_pair;
      return {};
    }



    std::optional<EntryError>
    All::missing_derivative(const std::string &entry) const
    {
      const std::string remedy =
        "set 'Errors = next mesh', or compare two runs";
      for (const Contact &contact_pair : pairs())
        if (contact_pair.has_free_motion())
          return EntryError("There is no dual problem for motions that follow "
                            "from forces.",
                            {entry,
                             contact_pair.section() + (contact_pair.tied
                                                         ? "/Preload"
                                                         : "/Obstacle force")},
                            remedy);
      for (const auto &[name, probe] : probes.definitions())
        if (is_of_obstacle(probe.quantity) && !is_of_cut(probe.quantity))
          return EntryError("There is no dual problem for what an obstacle "
                            "exerts, the probe '" +
                              name + "'.",
                            {entry, "Probes/Probes"},
                            "ask for the contact force of the slave");
        else if (is_of_supports_alone(probe.quantity))
          return EntryError(
            "There is no dual problem for the force of supports "
            "alone, the probe '" +
              name + "'.",
            {entry, "Probes/Probes"},
            "ask for the reaction");
      return {};
    }



    // Multipliers of the dual problems are transferred by nodes.
    std::optional<EntryError>
    All::missing_dual_problem(const std::string &entry) const
    {
      const std::string other = "set 'Errors = next mesh', or compare two runs";
      if (in_space)
        return EntryError("Dual problems are those of a plane mesh.",
                          {entry},
                          other);
      if (!solids.is_elastic())
        return EntryError("Dual problems are those of elastic bodies.",
                          {entry, "Solids/Material"},
                          other);
      if (n_ranks > 1)
        return EntryError("Dual problems are solved by one process, here are " +
                            std::to_string(n_ranks) + ".",
                          {entry},
                          "run it without mpirun, or without this entry");
      if (const auto shared = shared_pair())
        return EntryError("There are no dual problems for the discretization " +
                            shared->discretization.name() + ".",
                          {entry, shared->section() + "/Discretization"},
                          "set 'Discretization = mortar' or 'Discretization = "
                          "nodal', or 'Errors = next mesh' instead");
      for (const auto &[name, probe] : probes.definitions())
        if (!has_dual_problem(probe.quantity))
          return EntryError("There is no dual problem for the " +
                              probe.quantity.name() + " of the probe '" + name +
                              "'.",
                            {entry, "Probes/Probes"},
                            "ask for displacements of the boundary, or set "
                            "'Errors = next mesh' instead");
      return missing_derivative(entry);
    }



    void All::check_dual_problems() const
    {
      if (probes.errors == Errors::dual_weighted_residuals)
        if (const auto missing = missing_dual_problem("Probes/Errors"))
          throw EntryError(*missing);
    }



    void All::check_effects_in_plane() const
    {
      if (!solution.estimate_effects)
        return;
      const std::string entry = "Solution/Estimate effects";
      if (n_ranks > 1)
        throw EntryError("Effects are estimated by one process, here are " +
                           std::to_string(n_ranks) + ".",
                         {entry},
                         "run it without mpirun, or without this entry");
      if (const auto missing = missing_derivative(entry))
        throw EntryError(*missing);
    }



    void All::check_limits() const
    {
      for (const auto &[name, value] : refinement.limits)
        if ((name != "unknowns" && name != "seconds" && name != "megabytes") ||
            !(value > 0))
          throw EntryError("There is no limit '" + name +
                             "', or it is not "
                             "positive.",
                           {"Refinement/Limits"},
                           "choose of unknowns, seconds and megabytes, and a "
                           "number greater than 0");
      if (asks_for_accuracy() && restart)
        throw EntryError(
          "A run towards an accuracy does not go on where it was "
          "interrupted.",
          {"Probes/Accuracy"},
          "begin it anew, without --restart");
    }



    // Entries that one process alone can serve.
    void All::check_ranks() const
    {
      const std::string here = ", here are " + std::to_string(n_ranks) + ".";
      if (const auto shared = shared_pair())
        throw EntryError(
          "The discretization " + shared->discretization.name() +
            " is solved by one process" + here,
          {shared->section() + "/Discretization"},
          "run it without mpirun, or set 'Discretization = mortar' or "
          "'Discretization = nodal'");
      if (solution.linear_solver == SolverKind::cholmod)
        throw EntryError("CHOLMOD works in one process" + here,
                         {solver_entry},
                         "set 'Linear solver = AMG' or 'Linear solver = "
                         "MUMPS'");
      if (!is_condensed())
        throw EntryError("A saddle point system is solved by one process.",
                         {system_entry},
                         "run it without mpirun, or set 'System = condensed'");
    }



    void All::check_saddle_point() const
    {
      if (solution.linear_solver != SolverKind::automatic &&
          solution.linear_solver != SolverKind::umfpack)
        throw EntryError("A saddle point system is not positive definite: " +
                           solution.linear_solver.name() + " cannot solve it.",
                         {solver_entry, system_entry},
                         "set 'Linear solver = UMFPACK', or 'System = "
                         "condensed'");
      if (has_levels())
        throw EntryError(
          "Nested iteration needs the condensed system.",
          {"Refinement/Levels", system_entry},
          "set 'System = condensed', with the nodal discretization or "
          "mortar, or refine the first mesh with "
          "Mesh/Refinements");
    }



    void All::check_condensed() const
    {
      if (solution.linear_solver == SolverKind::umfpack)
        throw EntryError("UMFPACK is for saddle point systems.",
                         {solver_entry, system_entry},
                         "set 'Linear solver = CHOLMOD'");
      if (const auto shared = shared_pair())
        throw EntryError(
          "The multipliers of the discretization " +
            shared->discretization.name() + " cannot be eliminated: " +
            (solution.linear_solver == SolverKind::automatic
               ? "a condensed system"
               : solution.linear_solver.name()) +
            " is not for it.",
          {shared->section() + "/Discretization",
           solution.system != SystemKind::automatic ? system_entry
           : solution.linear_solver != SolverKind::automatic
             ? solver_entry
             : "Refinement/Levels"},
          "set 'Discretization = mortar' or 'Discretization = nodal'; the discretization " +
            shared->discretization.name() +
            " takes 'System = saddle point' and UMFPACK");
      if (!pairs().empty() && solution.geometry == GeometryLoop::newton)
        throw EntryError("The condensed system does not know how projections "
                         "move.",
                         {"Solution/Geometry", system_entry},
                         "set 'Geometry = each step'");
    }


    std::map<std::string, std::string> All::idle_entries() const
    {
      std::map<std::string, std::string> idle;
      const auto                         note = [&](const bool         is_idle,
                            const std::string &path,
                            const std::string &reason) {
        if (is_idle)
          idle[path] = reason;
      };
      for (const Contact &contact_pair : pairs())
        {
          note(contact_pair.tied && contact_pair.friction_coefficient != 0,
               contact_pair.section() + "/Friction coefficient",
               "the surfaces are glued");
          note(contact_pair.discretization != ContactDiscretization::gauss &&
                 contact_pair.n_gauss_points != Contact().n_gauss_points,
               contact_pair.section() + "/Gauss points",
               "the discretization is " + contact_pair.discretization.name());
        }
      if (!has_levels())
        {
          const Refinement  standard;
          const std::string reason = "there are no levels";
          note(refinement.strategy != standard.strategy,
               "Refinement/Strategy",
               reason);
          note(refinement.fraction != standard.fraction,
               "Refinement/Fraction",
               reason);
          note(refinement.tolerance != standard.tolerance,
               "Refinement/Tolerance",
               reason);
        }
      for (const auto &[entry, is_set] : boundary.entries_with_history())
        note(!is_set && boundary.histories.count(entry) > 0,
             "Boundary conditions/Histories",
             in_quotes(entry) + " is not set");
      return idle;
    }
  } // namespace Parameters
} // namespace Contact
