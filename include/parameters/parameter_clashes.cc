/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// What the entries of several sections have to be together.

#include <algorithm>

#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void All::check() const
    {
      mesh.check();
      element.check();
      solids.check();
      boundary.check();
      contact.check();
      for (const auto &further : further_contacts)
        further.second.check();
      solution.check();
      refinement.check();
      probes.check();

      check_theory();
      if (solution.geometry == GeometryLoop::undeformed &&
          solids.kinematics != Strains::small)
        throw EntryError("Large displacements are not those of undeformed "
                         "surfaces.",
                         {"Solution/Geometry", "Solids/Kinematics"},
                         "set 'Kinematics = small strain', or another "
                         "geometry");
      check_system();
    }



    // Which closed form belongs to which scene.
    void All::check_theory() const
    {
      const bool plane = solids.symmetry == Symmetry::plane_strain;
      if (!probes.hertz.empty() && !plane)
        throw EntryError("The line contact of Hertz is one of plane strain.",
                         {"Probes/Hertz", "Solids/Symmetry"},
                         "leave Hertz empty, or set 'Symmetry = plane strain'");
      if (!probes.concentric_cylinders.empty() && !plane)
        throw EntryError("The concentric cylinders are a section in x and y, "
                         "not rings about y.",
                         {"Probes/Concentric cylinders", "Solids/Symmetry"},
                         "leave the cylinders empty, or set 'Symmetry = plane "
                         "strain'");
      if (!probes.hertz.empty() && contact.master.empty())
        throw EntryError("There is no contact pressure to compare with Hertz.",
                         {"Probes/Hertz", "Contact/Slave"},
                         "set slave and master, or leave Hertz empty");
      if (!probes.concentric_cylinders.empty() && contact.master.empty())
        throw EntryError("Concentric cylinders are compared with contact, but "
                         "there is none.",
                         {"Probes/Concentric cylinders", "Contact/Slave"},
                         "set slave and master, or leave the cylinders empty");
    }



    // What goes with which linear system.
    void All::check_system() const
    {
      const std::string system = "Solution/System";
      const std::string solver = "Solution/Linear solver";
      // The first zone that has something, if there is one.
      const auto zones = this->zones();
      const auto find  = [&](const auto &has) {
        return std::find_if(zones.begin(), zones.end(), has);
      };
      const auto shared = find(
        [](const Contact &zone) { return !zone.has_point_per_multiplier(); });
      const bool is_frictional = find([](const Contact &zone) {
                                   return zone.frictional();
                                 }) != zones.end();
      const auto clash         = [](const std::string              &problem,
                            const std::vector<std::string> &entries,
                            const std::string              &remedy) {
        throw EntryError(problem, entries, remedy);
      };

      for (const Contact &zone : zones)
        if (zone.rule == Rule::gauss && zone.n_gauss_points <= element.degree)
          clash("With " + std::to_string(zone.n_gauss_points) +
                  " Gauss points an edge there are multipliers that no point "
                  "sees.",
                {zone.section() + "/Gauss points", "Element/Degree"},
                "set 'Gauss points = " + std::to_string(element.degree + 1) +
                  "' or more");
      if (n_ranks > 1 && shared != zones.end())
        clash("The rule " + shared->rule.name() +
                " is solved by one process, here are " +
                std::to_string(n_ranks) + ".",
              {shared->section() + "/Rule"},
              "run it without mpirun, or set 'Rule = mortar' or 'Rule = "
              "nodal'");
      if (n_ranks > 1 && solution.linear_solver == SolverKind::cholmod)
        clash("CHOLMOD works in one process, here are " +
                std::to_string(n_ranks) + ".",
              {solver},
              "set 'Linear solver = AMG' or 'Linear solver = MUMPS'");

      if (!is_condensed())
        {
          if (n_ranks > 1)
            clash("A saddle point system is solved by one process.",
                  {system},
                  "run it without mpirun, or set 'System = condensed'");
          if (is_frictional && solution.friction == FrictionLoop::each_step)
            clash("With multipliers the bound follows in a loop or in the "
                  "tangent.",
                  {"Solution/Friction", system},
                  "set 'Friction = Newton', or 'System = condensed'");
          if (solution.linear_solver != SolverKind::automatic &&
              solution.linear_solver != SolverKind::umfpack)
            clash("A saddle point system is not positive definite: " +
                    solution.linear_solver.name() + " can not solve it.",
                  {solver, system},
                  "set 'Linear solver = UMFPACK', or 'System = condensed'");
          if (refinement.n_levels > 0)
            clash("Nested iteration needs the condensed system.",
                  {"Refinement/Levels", system},
                  "set 'System = condensed', with the rule nodal or mortar, or "
                  "refine the first mesh with Mesh/Refinements");
          return;
        }

      if (solution.linear_solver == SolverKind::umfpack)
        clash("UMFPACK is for saddle point systems.",
              {solver, system},
              "set 'Linear solver = CHOLMOD'");
      if (shared != zones.end())
        clash("The multipliers of the rule " + shared->rule.name() +
                " can not be eliminated: " +
                (solution.linear_solver == SolverKind::automatic
                   ? "a condensed system"
                   : solution.linear_solver.name()) +
                " is not for it.",
              {shared->section() + "/Rule",
               solution.system != SystemKind::automatic ? system
               : solution.linear_solver != SolverKind::automatic
                 ? solver
                 : "Refinement/Levels"},
              "set 'Rule = mortar' or 'Rule = nodal'; the rule " +
                shared->rule.name() +
                " takes 'System = saddle point' and UMFPACK");
      if (!zones.empty() && solution.geometry == GeometryLoop::newton)
        clash("The condensed system does not know how projections move.",
              {"Solution/Geometry", system},
              "set 'Geometry = each step'");
    }
  } // namespace Parameters
} // namespace Contact
