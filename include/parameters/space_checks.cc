/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The entries that are for scenes in 2-D alone.

#include "parameters/parameters.h"

namespace Contact::Parameters
{
  namespace
  {
    void refuse(const bool         is_set,
                const std::string &entry,
                const std::string &what,
                const std::string &remedy)
    {
      if (is_set)
        throw EntryError("The mesh has volumes: " + what + ".",
                         {entry},
                         remedy);
    }
  } // namespace



  All All::for_space(const bool has_tetrahedra) const
  {
    refuse(solids.symmetry != Symmetry::plane_strain,
           "Solids/Symmetry",
           "it is one of a section",
           "remove the entry, or mesh the section: gmsh -2");
    refuse(solution.system == SystemKind::saddle_point,
           "Solution/System",
           "multipliers are always eliminated there",
           "set 'System = condensed'");
    refuse(solution.linear_solver == SolverKind::umfpack,
           "Solution/Linear solver",
           "UMFPACK is for saddle point systems",
           "set 'Linear solver = CHOLMOD'");
    refuse(solution.geometry == GeometryLoop::newton,
           "Solution/Geometry",
           "points are paired before each Newton step there",
           "set 'Geometry = automatic'");
    for (const Contact &pair : pairs())
      {
        refuse(pair.discretization == ContactDiscretization::gauss,
               pair.section() + "/Discretization",
               "the Gauss-point discretization is one for the plane",
               "take the mortar or the nodal discretization");
      }
    refuse(probes.errors == Errors::dual_weighted_residuals,
           "Probes/Errors",
           "dual problems are those of a plane mesh",
           "set 'Errors = next mesh', or 'Levels'");
    refuse(solution.estimate_effects && refinement.n_levels > 0 &&
             refinement.strategy == Strategy::adaptive,
           "Refinement/Strategy",
           "effects there are differences of runs on the same meshes",
           "set 'Strategy = uniform', or 'Estimate effects = false'");
    All all      = *this;
    all.in_space = true;
    if (has_tetrahedra && element.degree_is_automatic)
      all.element.degree = 2;

    // The solution does not depend on it; in 3-D a small one would let
    // round-off into the residual, times E/h/c.
    const double of_plane = Contact().augmentation_parameter;
    const auto   set      = [&](Contact &pair) {
      if (!(pair.augmentation_parameter != of_plane))
        pair.augmentation_parameter = 1;
    };
    set(all.contact);
    for (auto &[name, pair] : all.further_contacts)
      set(pair);
    return all;
  }
} // namespace Contact::Parameters
