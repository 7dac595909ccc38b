/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/interface_couplings.h"

#include <algorithm>

#include "base/exchange.h"

namespace Contact
{
  template<int dim>
  InterfaceCouplings<dim>::InterfaceCouplings(
    const Discretization<dim>   &discretization,
    const ContactInterface<dim> *interface)
    : discretization(discretization)
    , interface(interface)
  {
    if (interface != nullptr)
      for (const auto &contact_pair : interface->pairs)
        {
          if (contact_pair->master)
            collect_neighbors(*contact_pair->master);
          if (contact_pair->has_corner_points())
            collect_neighbors(contact_pair->slave);
        }
  }



  template<int dim>
  void InterfaceCouplings<dim>::collect_neighbors(const Surface<dim> &surface)
  {
    for (const SurfaceFacet<dim> &edge : surface.facets)
      for (unsigned int a = 0; a < edge.n_nodes(); ++a)
        {
          Dofs &around = neighbors[surface.nodes[edge.nodes[a]].dofs[0]];
          for (unsigned int b = 0; b < edge.n_nodes(); ++b)
            {
              const NodeDoFs<dim> &node = surface.nodes[edge.nodes[b]].dofs;
              around.insert(around.end(), node.begin(), node.end());
            }
        }
    for (auto &of_node : neighbors)
      sort_unique(of_node.second);
  }



  template<int dim>
  typename InterfaceCouplings<dim>::Dofs
  InterfaceCouplings<dim>::reachable(const ContactPoint<dim> &point) const
  {
    Dofs       dofs;
    const auto add_around = [&](const types::global_dof_index dof) {
      if (const auto around = neighbors.find(dof); around != neighbors.end())
        dofs.insert(dofs.end(), around->second.begin(), around->second.end());
    };
    for (unsigned int a = 1; a < point.n_nodes; ++a)
      {
        dofs.insert(dofs.end(), point.dofs(a).begin(), point.dofs(a).end());
        add_around(point.dofs(a)[0]);
      }
    for (const auto dof : point.change.dofs)
      {
        dofs.push_back(dof);
        add_around(dof);
      }
    sort_unique(dofs);
    return dofs;
  }



  template<int dim>
  void InterfaceCouplings<dim>::make()
  {
    provided.clear();
    partners.clear();
    has_room_for_changes = changes_are_in_tangent();
    if (interface == nullptr)
      return;
    for (const ContactPoint<dim> &point : interface->points())
      {
        provided.push_back(reachable(point));
        for (const auto dof : point.dofs(0))
          {
            Dofs &of_dof = partners[dof];
            of_dof.insert(of_dof.end(),
                          point.dofs(0).begin(),
                          point.dofs(0).end());
            of_dof.insert(of_dof.end(),
                          provided.back().begin(),
                          provided.back().end());
            sort_unique(of_dof);
          }
      }
  }



  // With friction they are there from the first slip on, without it where an
  // increment is solved once more with them.
  template<int dim>
  bool InterfaceCouplings<dim>::changes_are_in_tangent() const
  {
    if (interface == nullptr)
      return false;
    const auto &points = interface->points();
    return interface->has_friction() ||
           std::any_of(points.begin(), points.end(), [](const auto &point) {
             return !point.change.dofs.empty();
           });
  }



  template<int dim>
  bool InterfaceCouplings<dim>::serve() const
  {
    if (interface == nullptr)
      return true;
    if (changes_are_in_tangent() && !has_room_for_changes)
      return false;
    for (unsigned int q = 0; q < interface->points().size(); ++q)
      {
        const ContactPoint<dim> &point = interface->points()[q];
        const auto is_provided = [&](const types::global_dof_index dof) {
          return std::binary_search(provided[q].begin(),
                                    provided[q].end(),
                                    dof);
        };
        for (unsigned int a = 1; a < point.n_nodes; ++a)
          if (!is_provided(point.dofs(a)[0]))
            return false;
        if (!std::all_of(point.change.dofs.begin(),
                         point.change.dofs.end(),
                         is_provided))
          return false;
      }
    return true;
  }



  template<int dim>
  bool InterfaceCouplings<dim>::add_missing(
    const ContactElimination<dim> &elimination)
  {
    bool misses = false;
    elimination.for_each_entry([&](const types::global_dof_index line,
                                   const types::global_dof_index dof) {
      Dofs      &of_line = partners[line];
      const auto place = std::lower_bound(of_line.begin(), of_line.end(), dof);
      if (place != of_line.end() && *place == dof)
        return;
      of_line.insert(place, dof);
      misses = true;
    });
    return misses;
  }



  template<int dim>
  void InterfaceCouplings<dim>::add_partners(
    const types::global_dof_index      dof,
    std::set<types::global_dof_index> &coupled) const
  {
    const auto add = [&](const types::global_dof_index of) {
      if (const auto found = partners.find(of); found != partners.end())
        coupled.insert(found->second.begin(), found->second.end());
    };
    add(dof);
    if (const auto *entries =
          discretization.constraints.get_constraint_entries(dof))
      for (const auto &entry : *entries)
        {
          coupled.insert(entry.first);
          add(entry.first);
        }
  }



  template<int dim>
  void
  InterfaceCouplings<dim>::add_facets(DynamicSparsityPattern &pattern) const
  {
    if (interface == nullptr)
      return;
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    for (const auto &contact_pair : interface->pairs)
      for (const SurfaceFacet<dim> &facet : contact_pair->slave.facets)
        {
          std::set<types::global_dof_index> coupled;
          bool                              is_own = false;
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
            for (const auto dof :
                 contact_pair->slave.nodes[facet.nodes[a]].dofs)
              {
                is_own = is_own || owned.is_element(dof);
                coupled.insert(dof);
                add_partners(dof, coupled);
              }
          if (is_own)
            discretization.constraints.add_entries_local_to_global(
              Dofs(coupled.begin(), coupled.end()),
              pattern,
              /*keep_constrained_entries=*/false);
        }
  }



  // The stiffness of the pairing of a point couples slave nodes that no facet
  // has in common, and whatever these follow.
  template<int dim>
  void
  InterfaceCouplings<dim>::add_points(DynamicSparsityPattern &pattern) const
  {
    if (!has_room_for_changes)
      return;
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    for (unsigned int q = 0; q < interface->points().size(); ++q)
      {
        const auto &own = interface->points()[q].dofs(0);
        if (!owned.is_element(own[0]))
          continue;
        std::set<types::global_dof_index> coupled(own.begin(), own.end());
        for (const Dofs &dofs : {Dofs(own.begin(), own.end()), provided[q]})
          for (const auto dof : dofs)
            {
              coupled.insert(dof);
              add_partners(dof, coupled);
            }
        discretization.constraints.add_entries_local_to_global(
          Dofs(coupled.begin(), coupled.end()),
          pattern,
          /*keep_constrained_entries=*/false);
      }
  }



  template<int dim>
  typename InterfaceCouplings<dim>::Dofs InterfaceCouplings<dim>::all() const
  {
    std::vector<bool> is_one(discretization.dof_handler.n_dofs(), false);
    for (const auto &[dof, of_dof] : partners)
      {
        is_one[dof] = true;
        for (const auto partner : of_dof)
          is_one[partner] = true;
      }
    Dofs all;
    for (types::global_dof_index i = 0; i < is_one.size(); ++i)
      if (is_one[i])
        all.push_back(i);
    return all;
  }

  template class InterfaceCouplings<2>;
  template class InterfaceCouplings<3>;
} // namespace Contact
