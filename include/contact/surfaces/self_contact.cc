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
    /// A direction in which no two places of a surface with axes or planes of
    /// symmetry are alike: along the first facets, seen from the middle of all,
    /// and across, by golden sections.
    template<int dim>
    Tensor<1, dim> oblique_direction(const Surface<dim> &surface)
    {
      const double golden = 0.618033988749895, smallest_sine = 1e-3;
      Point<dim>   centre;
      for (const SurfaceFacet<dim> &facet : surface.facets)
        centre += facet.middle;
      centre /= static_cast<double>(surface.facets.size());

      std::vector<Tensor<1, dim>> basis;
      Tensor<1, dim>              direction;
      double                      part = 1;
      for (const SurfaceFacet<dim> &facet : surface.facets)
        {
          Tensor<1, dim> rest     = facet.middle - centre;
          const double   distance = rest.norm();
          for (const Tensor<1, dim> &known : basis)
            rest -= (rest * known) * known;
          if (rest.norm() <= smallest_sine * distance)
            continue;
          basis.push_back(rest / rest.norm());
          direction += part * basis.back();
          part *= golden;
        }
      return direction;
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
                                const Surface<dim> &master)
  {
    const Tensor<1, dim> direction = oblique_direction(master);
    for (const SurfaceFacet<dim> &facet : slave.facets)
      slave_places.push_back(direction * facet.middle);
    std::map<FacetName<dim>, unsigned int> by_name;
    for (unsigned int m = 0; m < master.facets.size(); ++m)
      {
        master_places.push_back(direction * master.facets[m].middle);
        by_name[master.facets[m].name] = m;
      }
    for (const SurfaceFacet<dim> &facet : slave.facets)
      around.push_back(
        facets_around(master, facets_around(master, {by_name.at(facet.name)})));
  }

  template<int dim>
  bool SelfContact<dim>::are_back_to_back(const SurfacePlace<dim> &place,
                                          const SurfacePlace<dim> &other)
  {
    const double                  cosine = 0.5, part = 0.1;
    const Tensor<1, dim>          r = place.X() - other.X();
    PerFacetNode<dim, Point<dim>> X;
    for (unsigned int a = 0; a < other.surface.facets[other.facet].n_nodes();
         ++a)
      X[a] = other.surface.nodes[other.surface.facets[other.facet].nodes[a]].X;
    const Tensor<1, dim> normal =
      facet_normal<dim>(*other.surface.facets[other.facet].kind, X, other.xi);
    return r * normal < -cosine * r.norm() &&
           place.x.distance(other.x) > part * r.norm();
  }



  template class SelfContact<2>;
  template class SelfContact<3>;
} // namespace Contact
