/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surface_checks.h"

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    /// The connected parts of the mesh that a surface has lines of.
    std::set<unsigned int> parts_of(const Surface &surface)
    {
      std::set<unsigned int> parts;
      for (const Surface::Edge &edge : surface.edges)
        parts.insert(edge.part);
      return parts;
    }



    /// The lines of a surface that are on one of these parts.
    std::string lines_on(const Surface                &surface,
                         const std::set<unsigned int> &parts)
    {
      const auto at = [&](const unsigned int node) {
        const Point<2> &X = surface.nodes[node].X;
        return "(" + brief(X[0]) + ", " + brief(X[1]) + ")";
      };
      const unsigned int n_named = 3;
      std::string        names;
      unsigned int       n = 0;
      for (const Surface::Edge &edge : surface.edges)
        if (parts.count(edge.part) > 0 && n++ < n_named)
          names += (n > 1 ? ", " : "") + at(edge.nodes[0]) + " to " +
                   at(edge.nodes[1]);
      return names + (n > n_named
                        ? " and " + std::to_string(n - n_named) + " more"
                        : "");
    }



    void check_bodies(const Surface             &slave,
                      const Surface             &master,
                      const Discretization      &discretization,
                      const Parameters::Contact &parameters)
    {
      const auto of_slave = parts_of(slave), of_master = parts_of(master);
      std::set<unsigned int> common;
      for (const unsigned int part : of_slave)
        if (of_master.count(part) > 0)
          common.insert(part);
      if (common.empty() || (of_slave.size() == 1 && of_master.size() == 1))
        return;

      const bool     in_slave = of_slave.size() > 1;
      const Surface &wrong    = in_slave ? slave : master;
      const auto     edge     = std::find_if(wrong.edges.begin(),
                                     wrong.edges.end(),
                                     [&](const auto &edge) {
                                       return common.count(edge.part) > 0;
                                     });
      throw InputError(
        (in_slave ? "the slave '" + parameters.slave
                  : "the master '" + parameters.master) +
          "' has lines of a body that the " +
          (in_slave ? "master '" + parameters.master
                    : "slave '" + parameters.slave) +
          "' belongs to, '" + discretization.mesh.body_name(edge->body) +
          "': " + lines_on(wrong, common),
        parameters.section() + (in_slave ? "/Slave" : "/Master"),
        "take these lines out of the group: contact of a body with itself is "
        "between two groups of that body alone");
    }



    void check_nodes(const Surface             &slave,
                     const Surface             &master,
                     const Parameters::Contact &parameters)
    {
      for (const Surface::Node &a : slave.nodes)
        for (const Surface::Node &b : master.nodes)
          if (a.dofs == b.dofs)
            throw InputError("slave '" + parameters.slave + "' and master '" +
                               parameters.master +
                               "' overlap: both have the "
                               "node at (" +
                               std::to_string(a.X[0]) + ", " +
                               std::to_string(a.X[1]) + ")",
                             parameters.section() + "/Slave, " +
                               parameters.section() + "/Master",
                             "name two surfaces without a common node");
    }
  } // namespace



  void check_surfaces(const Surface             &slave,
                      const Surface             &master,
                      const Discretization      &discretization,
                      const Parameters::Contact &parameters)
  {
    check_nodes(slave, master, parameters);
    check_bodies(slave, master, discretization, parameters);
  }
} // namespace Contact
