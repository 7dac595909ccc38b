/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/contact_tractions.h"

#include <algorithm>

#include "contact/results/contact_results.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    std::map<FacetName<dim>, unsigned int>
    name_facets(const Surface<dim> &surface)
    {
      std::map<FacetName<dim>, unsigned int> facets;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        facets.emplace(surface.facets[e].name, e);
      return facets;
    }



    /// In terms of an edge's own outward normal n, which on the slave is that
    /// of the master reversed, both sides have -(p n + q t), t = n turned by
    /// +90 degrees.
    Tensor<1, 2> in_frame(const FacetPlace<2> &place,
                          const Tensor<1, 2>  &p_and_q,
                          const bool)
    {
      const Tensor<1, 2> t = place.along[0] / place.along[0].norm();
      return -(p_and_q[0] * cross_product_2d(t) + p_and_q[1] * t);
    }

    Tensor<1, 3> in_frame(const FacetPlace<3> &,
                          const Tensor<1, 3> &on_slave,
                          const bool          is_slave)
    {
      return is_slave ? on_slave : -on_slave;
    }
  } // namespace



  template<int dim>
  FacetPlace<dim>::FacetPlace(const Surface<dim>      &surface,
                              const SurfaceFacet<dim> &facet,
                              const FacetPoint<dim>   &xi,
                              const GhostedVector     &u)
    : shape(*facet.kind, xi)
  {
    std::array<Tensor<1, dim>, dim - 1> along_undeformed;
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      {
        const unsigned int node     = facet.nodes[a];
        const Point<dim>   position = surface.position(node, u);
        x += shape.value[a] * position;
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            along[k] += shape.derivative(a, k) * position;
            along_undeformed[k] +=
              shape.derivative(a, k) * surface.nodes[node].X;
          }
      }
    area            = outward_normal(along);
    undeformed_area = outward_normal(along_undeformed);
  }



  template<int dim>
  bool is_tied(const Discretization<dim> &discretization,
               const Surface<dim>        &surface,
               const SurfaceFacet<dim>   &facet)
  {
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      for (const auto dof : surface.nodes[facet.nodes[a]].dofs)
        if (discretization.is_tied(dof))
          return true;
    return false;
  }



  template<int dim>
  ContactTractions<dim>::ContactTractions(
    const Discretization<dim>   &discretization,
    const ContactInterface<dim> &interface,
    const ContactPair<dim>      &contact_pair,
    const GhostedVector         &solution)
    : discretization(discretization)
    , contact_pair(contact_pair)
    , slave(contact_pair.slave)
    , solution(solution)
    , slave_now(slave, solution)
    , slave_facets(name_facets(slave))
    , at_nodes(slave.nodes.size())
  {
    if (contact_pair.master)
      master_facets = name_facets(*contact_pair.master);
    find_values(interface);
  }



  template<int dim>
  void
  ContactTractions<dim>::find_values(const ContactInterface<dim> &interface)
  {
    const bool has_shear = !contact_pair.law.is_frictionless();
    if constexpr (dim == 2)
      {
        at_nodes = corner_tractions(interface, contact_pair, solution);
        at_nodes.resize(slave.nodes.size());
        for (unsigned int i = 0; i < at_nodes.size(); ++i)
          if (const auto k = multiplier_at(interface, contact_pair, i);
              k != numbers::invalid_unsigned_int)
            {
              at_nodes[i][0] += solution[interface.normal_index(k)];
              if (has_shear)
                at_nodes[i][1] += solution[interface.tangential_index(k)];
            }
        return;
      }
    std::vector<Tensor<1, dim>> of_multiplier(interface.n_normal_multipliers());
    const auto points = contact_pair.points_of_slave(interface.points());
    const auto acting = interface.acting_points(contact_pair);
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const ContactPoint<dim> &point = acting[q];
        const unsigned int       k     = point.multipliers[0];
        Tensor<1, dim> &of_point = of_multiplier[points[q].multipliers[0]];
        of_point = solution[interface.normal_index(k)] * point.normal;
        Tensor<1, dim - 1> shear;
        if (has_shear)
          for (unsigned int t = 0; t < dim - 1; ++t)
            shear[t] = solution[interface.tangential_index(k, t)];
        of_point += point.along_tangents(shear);
      }
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      for (const auto &[k, part] : contact_pair.pressure_at(i))
        at_nodes[i] += part * of_multiplier[k];
  }



  template<int dim>
  std::optional<Tensor<1, dim>>
  ContactTractions<dim>::operator()(const FacetName<dim>  &name,
                                    const FacetPlace<dim> &place,
                                    const double           reach) const
  {
    // A surface in contact with itself is both.
    Tensor<1, dim> sum;
    if (const auto own = slave_facets.find(name); own != slave_facets.end())
      sum = in_frame(place,
                     interpolate(own->second, place),
                     /*is_slave=*/true);
    if (const auto own = master_facets.find(name); own != master_facets.end())
      {
        const auto facing = of_facing_slave(own->second, place, reach);
        if (!facing)
          return {};
        sum += *facing;
      }
    return sum;
  }



  template<int dim>
  Tensor<1, dim>
  ContactTractions<dim>::interpolate(const unsigned int     facet,
                                     const FacetPlace<dim> &place) const
  {
    Tensor<1, dim> traction;
    for (unsigned int a = 0; a < slave.facets[facet].n_nodes(); ++a)
      {
        const unsigned int node = slave.facets[facet].nodes[a];
        traction += place.shape.value[a] * at_nodes[node];
      }
    return traction;
  }



  // Both sides agree on the force by deformed area.
  template<int dim>
  std::optional<Tensor<1, dim>>
  ContactTractions<dim>::of_facing_slave(const unsigned int     master_facet,
                                         const FacetPlace<dim> &place,
                                         const double           reach) const
  {
    const Projection<dim> projection =
      contact_pair.facing_slave(slave_now,
                                place.x,
                                {{place.area / place.area.norm()}},
                                {master_facet});
    if (projection.beyond_end ||
        slave_now.distance_square(place.x, projection) > reach * reach)
      return Tensor<1, dim>();

    const SurfaceFacet<dim> &facet = slave.facets[projection.facet];
    if (is_tied(discretization, slave, facet))
      return {};
    // Values are not extrapolated to the overhang beyond the end.
    const FacetPlace<dim> there(slave,
                                facet,
                                facet.kind->inside(projection.xi),
                                solution);
    return in_frame(place,
                    place.stretch() / there.stretch() *
                      interpolate(projection.facet, there),
                    /*is_slave=*/false);
  }

  template struct FacetPlace<2>;
  template struct FacetPlace<3>;
  template class ContactTractions<2>;
  template class ContactTractions<3>;
  template bool is_tied(const Discretization<2> &,
                        const Surface<2> &,
                        const SurfaceFacet<2> &);
  template bool is_tied(const Discretization<3> &,
                        const Surface<3> &,
                        const SurfaceFacet<3> &);
} // namespace Contact
