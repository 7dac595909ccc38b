/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/interface_couplings.h"

#include <algorithm>

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
      for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
        for (unsigned int b = 0; b < surface.n_nodes_per_facet(); ++b)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const NodeDoFs<dim> &around = surface.nodes[edge.nodes[b]].dofs;
              neighbors[surface.nodes[edge.nodes[a]].dofs[c]]
                .insert(around.begin(), around.end());
            }
  }



  template<int dim>
  typename InterfaceCouplings<dim>::Dofs
  InterfaceCouplings<dim>::reachable(const ContactPoint<dim> &point) const
  {
    std::set<types::global_dof_index> dofs;
    for (unsigned int a = 1; a < point.n_nodes; ++a)
      for (const auto dof : point.dofs[a])
        {
          dofs.insert(dof);
          if (const auto around = neighbors.find(dof);
              around != neighbors.end())
            dofs.insert(around->second.begin(), around->second.end());
        }
    return Dofs(dofs.begin(), dofs.end());
  }



  template<int dim>
  void InterfaceCouplings<dim>::make()
  {
    provided.clear();
    partners.clear();
    if (interface == nullptr)
      return;
    for (const ContactPoint<dim> &point : interface->points())
      {
        provided.push_back(reachable(point));
        for (const auto dof : point.dofs[0])
          {
            auto &of_dof = partners[dof];
            of_dof.insert(point.dofs[0].begin(), point.dofs[0].end());
            of_dof.insert(provided.back().begin(), provided.back().end());
          }
      }
  }



  template<int dim>
  bool InterfaceCouplings<dim>::serve() const
  {
    if (interface == nullptr)
      return true;
    for (unsigned int q = 0; q < interface->points().size(); ++q)
      {
        const ContactPoint<dim> &point = interface->points()[q];
        for (unsigned int a = 1; a < point.n_nodes; ++a)
          if (!std::binary_search(provided[q].begin(),
                                  provided[q].end(),
                                  point.dofs[a][0]))
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
      if (partners[line].insert(dof).second)
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
          for (unsigned int a = 0; a < contact_pair->slave.n_nodes_per_facet();
               ++a)
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



  template<int dim>
  std::set<types::global_dof_index> InterfaceCouplings<dim>::all() const
  {
    std::set<types::global_dof_index> all;
    for (const auto &[dof, of_dof] : partners)
      {
        all.insert(dof);
        all.insert(of_dof.begin(), of_dof.end());
      }
    return all;
  }

  template class InterfaceCouplings<2>;
  template class InterfaceCouplings<3>;
} // namespace Contact
