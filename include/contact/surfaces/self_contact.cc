/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/self_contact.h"

#include <map>

namespace Contact
{
  namespace
  {
    /// Places and what they weigh.
    template<int dim>
    struct Mean
    {
      Tensor<1, dim> sum;
      double         weight = 0;

      void add(const Point<dim> &place, const double of_place)
      {
        sum += of_place * Tensor<1, dim>(place);
        weight += of_place;
      }
    };



    /// A direction in which no two places of a surface with axes or planes of
    /// symmetry are alike: along the facets of the first cells, seen from the
    /// middle of all, and across, by golden sections. It is that of the coarse
    /// mesh, however it is refined, and on any number of processes.
    template<int dim>
    Tensor<1, dim> oblique_direction(const Surface<dim> &surface)
    {
      const double golden = 0.618033988749895, smallest_sine = 1e-3;
      Mean<dim>    all;
      std::map<unsigned int, Mean<dim>> of_cells;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        {
          const SurfaceFacet<dim> &facet = surface.facets[e];
          const double             size =
            Utilities::fixed_power<dim - 1>(surface.reference_length(e));
          all.add(facet.middle, size);
          of_cells[facet.coarse_cell].add(facet.middle, size);
        }

      std::vector<Tensor<1, dim>> basis;
      Tensor<1, dim>              direction;
      double                      part = 1;
      for (const auto &[cell, mean] : of_cells)
        {
          Tensor<1, dim> rest = mean.sum / mean.weight - all.sum / all.weight;
          const double   distance = rest.norm();
          for (const Tensor<1, dim> &known : basis)
            rest -= (rest * known) * known;
          if (rest.norm() <= smallest_sine * distance)
            continue;
          basis.push_back(rest / rest.norm());
          direction += part * basis.back();
          part *= golden;
        }
      return direction / direction.norm();
    }



    /// The outward unit normal at a place of a facet.
    template<int dim>
    Tensor<1, dim> undeformed_normal(const Surface<dim>    &surface,
                                     const unsigned int     facet,
                                     const FacetPoint<dim> &xi)
    {
      PerFacetNode<dim, Point<dim>> X;
      for (unsigned int a = 0; a < surface.facets[facet].n_nodes(); ++a)
        X[a] = surface.nodes[surface.facets[facet].nodes[a]].X;
      return facet_normal<dim>(*surface.facets[facet].kind, X, xi);
    }



    /// All that meet at nodes of these facets.
    template<int dim>
    std::set<unsigned int> facets_around(const Surface<dim>           &surface,
                                         const std::set<unsigned int> &facets)
    {
      std::set<unsigned int> around = facets;
      for (const unsigned int e : facets)
        for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
          {
            const auto &there =
              surface.facets_of_node[surface.facets[e].nodes[a]];
            around.insert(there.begin(), there.end());
          }
      return around;
    }
  } // namespace



  // The slave is cut at corners, the master is not.
  template<int dim>
  SelfContact<dim>::SelfContact(const Surface<dim> &slave,
                                const Surface<dim> &master,
                                const unsigned int  n_rings)
  {
    const Tensor<1, dim> direction = oblique_direction(master);
    const auto           along     = [&](const Surface<dim> &surface) {
      std::vector<Along> all;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        all.push_back(
          {direction * surface.facets[e].middle,
           direction *
             undeformed_normal(surface, e, surface.facets[e].kind->middle)});
      return all;
    };
    of_slave  = along(slave);
    of_master = along(master);
    std::map<FacetName<dim>, unsigned int> by_name;
    for (unsigned int m = 0; m < master.facets.size(); ++m)
      by_name[master.facets[m].name] = m;
    for (const SurfaceFacet<dim> &facet : slave.facets)
      {
        around.push_back({by_name.at(facet.name)});
        for (unsigned int ring = 0; ring < n_rings; ++ring)
          around.back() = facets_around(master, around.back());
      }
  }



  template<int dim>
  bool SelfContact<dim>::are_back_to_back(const SurfacePlace<dim> &place,
                                          const SurfacePlace<dim> &other)
  {
    const double         round_off = 1e-8, part = 0.1;
    const Tensor<1, dim> r = place.X() - other.X();
    return r * undeformed_normal(other.surface, other.facet, other.xi) <
             -round_off * r.norm() &&
           place.x.distance(other.x) > part * r.norm();
  }

  template class SelfContact<2>;
  template class SelfContact<3>;
} // namespace Contact
