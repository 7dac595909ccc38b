/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/surface_checks.h"

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    /// The connected parts of the mesh that a surface has lines of.
    template<int dim>
    std::set<unsigned int> parts_of(const Surface<dim> &surface)
    {
      std::set<unsigned int> parts;
      for (const SurfaceFacet<dim> &edge : surface.facets)
        parts.insert(edge.part);
      return parts;
    }



    /// The lines of a surface that are on one of these parts.
    template<int dim>
    std::string lines_on(const Surface<dim>           &surface,
                         const std::set<unsigned int> &parts)
    {
      const auto at = [&](const unsigned int node) {
        const Point<dim> &X = surface.nodes[node].X;
        return "(" + brief(X[0]) + ", " + brief(X[1]) + ")";
      };
      const unsigned int n_named = 3;
      std::string        names;
      unsigned int       n = 0;
      for (const SurfaceFacet<dim> &edge : surface.facets)
        if (parts.count(edge.part) > 0 && n++ < n_named)
          names += (n > 1 ? ", " : "") + at(edge.nodes[0]) + " to " +
                   at(edge.nodes[1]);
      return names + (n > n_named
                        ? " and " + std::to_string(n - n_named) + " more"
                        : "");
    }



    template<int dim>
    void check_bodies(const Surface<dim>           &slave,
                      const Surface<dim>           &master,
                      const DiscretizedBodies<dim> &discretization,
                      const Parameters::Contact    &parameters)
    {
      const auto of_slave = parts_of(slave), of_master = parts_of(master);
      std::set<unsigned int> common;
      for (const unsigned int part : of_slave)
        if (of_master.count(part) > 0)
          common.insert(part);
      if (common.empty() || (of_slave.size() == 1 && of_master.size() == 1))
        return;

      const bool          in_slave = of_slave.size() > 1;
      const Surface<dim> &wrong    = in_slave ? slave : master;
      const auto          edge     = std::find_if(wrong.facets.begin(),
                                     wrong.facets.end(),
                                     [&](const auto &edge) {
                                       return common.count(edge.part) > 0;
                                     });
      throw InputError(
        (in_slave ? "the slave '" + parameters.slave
                  : "the master '" + parameters.master) +
          "' has lines of a body that the " +
          (in_slave ? "master '" + parameters.master
                    : "slave '" + parameters.slave) +
          "' belongs to, '" + discretization.body_name(edge->body) +
          "': " + lines_on(wrong, common),
        parameters.section() + (in_slave ? "/Slave" : "/Master"),
        "take these lines out of the group: contact of a body with itself is "
        "between two groups of that body alone");
    }



    template<int dim>
    void check_nodes(const Surface<dim>        &slave,
                     const Surface<dim>        &master,
                     const Parameters::Contact &parameters)
    {
      for (const SurfaceNode<dim> &a : slave.nodes)
        for (const SurfaceNode<dim> &b : master.nodes)
          if (a.dofs == b.dofs)
            throw InputError("slave '" + parameters.slave + "' and master '" +
                               parameters.master +
                               "' overlap: both have the "
                               "node at (" +
                               brief(a.X) + ") mm",
                             parameters.section() + "/Slave, " +
                               parameters.section() + "/Master",
                             "name two surfaces without a common node");
    }
  } // namespace



  template<int dim>
  void check_surfaces(const Surface<dim>           &slave,
                      const Surface<dim>           &master,
                      const DiscretizedBodies<dim> &discretization,
                      const Parameters::Contact    &parameters)
  {
    check_nodes(slave, master, parameters);
    check_bodies(slave, master, discretization, parameters);
  }



  template<int dim>
  void check_ties(const Surface<dim>           &slave,
                  const Surface<dim>           *master,
                  const std::set<unsigned int> &excluded,
                  const DiscretizedBodies<dim> &discretization,
                  const Parameters::Contact    &parameters)
  {
    std::map<types::global_dof_index, unsigned int> on_slave;
    std::set<types::global_dof_index>               on_master;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (excluded.count(i) == 0)
        for (const auto dof : slave.nodes[i].dofs)
          on_slave[dof] = i;
    if (master != nullptr)
      for (const SurfaceNode<dim> &node : master->nodes)
        on_master.insert(node.dofs.begin(), node.dofs.end());

    const bool all_is_rigid =
      std::all_of(on_slave.begin(), on_slave.end(), [&](const auto &of_node) {
        return discretization.is_rigid(of_node.first);
      });
    for (const auto &[dof, node] : on_slave)
      if (discretization.is_rigid(dof))
        throw InputError(
          "the node of the slave '" + parameters.slave + "' at (" +
            brief(slave.nodes[node].X) +
            ") mm is on a rigid boundary: it would be held twice",
          "Boundary conditions/Rigid, " + parameters.section() + "/Slave",
          all_is_rigid ? "take the rigid surface as master"
                       : "let the slave end before the rigid boundary, or "
                         "name that point in '" +
                           parameters.section() + "/Excluded points'");

    const auto check = [&](const types::global_dof_index own,
                           const types::global_dof_index other) {
      const auto found = on_slave.find(own);
      if (found == on_slave.end())
        return;
      const bool is_on_slave = on_slave.count(other) > 0;
      if (is_on_slave || on_master.count(other) > 0)
        throw InputError("the node of the slave '" + parameters.slave +
                           "' at (" + brief(slave.nodes[found->second].X) +
                           ") mm is tied to " +
                           (is_on_slave ? "another one" : "the master") +
                           ": it would be held twice, and how tie and contact "
                           "share the force is not determined",
                         "Boundary conditions/Tied x, Tied y, Tied z, " +
                           parameters.section() + "/Slave",
                         is_on_slave
                           ? "take the tied surface as master, or remove the "
                             "tie"
                           : "name the point in '" + parameters.section() +
                               "/Excluded points', or remove the tie");
    };
    for (const auto &[dof, leader] : discretization.tied())
      {
        if (const auto found = on_slave.find(dof);
            found != on_slave.end() && parameters.frictional())
          throw InputError("the node of the slave '" + parameters.slave +
                             "' at (" + brief(slave.nodes[found->second].X) +
                             ") mm is tied: friction would hold it twice",
                           "Boundary conditions/Tied x, Tied y, Tied z, " +
                             parameters.section() + "/Friction coefficient",
                           "name the point in '" + parameters.section() +
                             "/Excluded points', or remove the tie");
        check(dof, leader);
        check(leader, dof);
      }
  }



  template<int dim>
  bool overlap(const Surface<dim> &a, const Surface<dim> &b)
  {
    std::set<FacetName<dim>> of_a;
    for (const SurfaceFacet<dim> &facet : a.facets)
      of_a.insert(facet.name);
    return std::any_of(b.facets.begin(),
                       b.facets.end(),
                       [&](const auto &facet) {
                         return of_a.count(facet.name) > 0;
                       });
  }

#define INSTANTIATE(dim)                                                     \
  template void check_surfaces(const Surface<dim>           &slave,          \
                               const Surface<dim>           &master,         \
                               const DiscretizedBodies<dim> &discretization, \
                               const Parameters::Contact    &parameters);       \
  template void check_ties(const Surface<dim>           &slave,              \
                           const Surface<dim>           *master,             \
                           const std::set<unsigned int> &excluded,           \
                           const DiscretizedBodies<dim> &discretization,     \
                           const Parameters::Contact    &parameters);           \
  template bool overlap(const Surface<dim> &a, const Surface<dim> &b);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
