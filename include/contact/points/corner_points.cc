/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/corner_points.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace Contact
{
  namespace
  {
    std::vector<unsigned int> corners_and_ends(const Surface<2> &surface)
    {
      std::vector<unsigned int> nodes;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        {
          const SurfaceFacet<2> &edge = surface.facets[e];
          const bool             is_corner =
            edge.corner[0] && edge.ends_side[0] &&
            surface.turn_of_curves(e) >
              numbers::PI / 180 * Surface<2>::feature_angle;
          if (is_corner || edge.ends_surface(0))
            nodes.push_back(edge.nodes[0]);
          if (edge.ends_surface(1))
            nodes.push_back(edge.nodes[1]);
        }
      return nodes;
    }



    // Where ends of faces meet that do not continue each other.
    std::vector<unsigned int> corners_and_ends(const Surface<3> &surface)
    {
      std::map<unsigned int, std::vector<Tensor<1, 3>>> ends_at;
      for (const SurfaceFacet<3> &facet : surface.facets)
        for (unsigned int s = 0; s < facet.n_sides(); ++s)
          if (facet.ends_side[s])
            for (const unsigned int a : facet.kind->sides[s].ends)
              for (const unsigned int b : facet.kind->sides[s].ends)
                if (a != b)
                  {
                    const Tensor<1, 3> along = surface.nodes[facet.nodes[b]].X -
                                               surface.nodes[facet.nodes[a]].X;
                    ends_at[facet.nodes[a]].push_back(along / along.norm());
                  }
      const double least =
        std::cos(numbers::PI / 180 * Surface<3>::feature_angle);
      std::vector<unsigned int> nodes;
      for (const auto &[node, ends] : ends_at)
        if (std::any_of(ends.begin(), ends.end(), [&](const auto &end) {
              return std::abs(end * ends[0]) < least;
            }))
          nodes.push_back(node);
      return nodes;
    }



    /// Whether a projection lies at the end of a face, from where on both sides
    /// the overhang counts.
    template<int dim>
    bool is_at_end_of_face(const Surface<dim>      &surface,
                           const ContactPoint<dim> &point)
    {
      const SurfaceFacet<dim> &facet = surface.facets[point.master_facet];
      for (unsigned int s = 0; s < facet.n_sides(); ++s)
        if (facet.ends_side[s] && facet.kind->sides[s].at(point.master_xi) >
                                    1 - DeformedSurface<dim>::overhang)
          return true;
      return false;
    }
  } // namespace



  template<int dim>
  std::vector<ContactPoint<dim>> make_corner_points(const Surface<dim> &master)
  {
    const auto corners = corners_and_ends(master);
    if (corners.empty())
      return {};

    MultiplierSpace numbering;
    const auto      all = make_nodal_points(master, {}, numbering);
    std::vector<ContactPoint<dim>> points;
    for (const unsigned int node : corners)
      {
        points.push_back(all[numbering.of_node[node]]);
        points.back().is_master_corner = true;
        points.back().multipliers[0]   = points.size() - 1;
      }
    return points;
  }



  template<int dim>
  double distance(const ContactPoint<dim> &corner, const GhostedVector &u)
  {
    double sum = 0;
    for (unsigned int a = 0; a < corner.n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        sum += corner.normal[i] * corner.C[a] *
               (corner.X(a)[i] + u[corner.dofs(a)[i]]);
    return sum;
  }



  template<int dim>
  void pair_corner_points(const ArrayView<ContactPoint<dim>> &corners,
                          const DeformedSurface<dim>         &master,
                          const DeformedSurface<dim>         &slave,
                          const BodyOverlap<dim>             &bodies,
                          const DiscretizedBodies<dim>       &discretization,
                          const GhostedVector                &u)
  {
    for (ContactPoint<dim> &corner : corners)
      {
        // A slave edge beside the end of the master does not obstruct it.
        NormalCone<dim> directions = directions_of(corner, master);
        directions.at_end          = false;
        directions.overlap         = [&](const auto &x, const auto &other) {
          return bodies.is_between(
            {x, master.surface, corner.slave_facet, corner.slave_xi},
            1,
            other);
        };
        corner.projection = Point<dim>();
        pair_with_master(corner, directions, slave, discretization, u);
        const double length =
          slave.surface.reference_length(corner.master_facet);
        corner.facing =
          corner.facing && !is_at_end_of_face(slave.surface, corner);
        corner.projection -= corner_slack * length * corner.normal;
      }
  }



  template<int dim>
  unsigned int node_at_foot(const ContactPoint<dim> &corner,
                            const Surface<dim>      &slave)
  {
    const double close = 1e-2;
    if (!corner.facing)
      return numbers::invalid_unsigned_int;
    const SurfaceFacet<dim> &facet = slave.facets[corner.master_facet];
    const FacetPoint<dim>    xi    = facet.kind->inside(corner.master_xi);
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      {
        double beside = 0;
        for (unsigned int k = 0; k < dim - 1; ++k)
          beside = std::max(beside,
                            std::abs(coordinate(xi, k) -
                                     coordinate(facet.kind->places[a], k)));
        if (beside < close)
          return facet.nodes[a];
      }
    return numbers::invalid_unsigned_int;
  }

#define INSTANTIATE(dim)                                                      \
  template std::vector<ContactPoint<dim>> make_corner_points(                 \
    const Surface<dim> &);                                                    \
  template double distance(const ContactPoint<dim> &, const GhostedVector &); \
  template void   pair_corner_points(const ArrayView<ContactPoint<dim>> &,    \
                                     const DeformedSurface<dim> &,            \
                                     const DeformedSurface<dim> &,            \
                                     const BodyOverlap<dim> &,                \
                                     const DiscretizedBodies<dim> &,          \
                                     const GhostedVector &);                  \
  template unsigned int node_at_foot(const ContactPoint<dim> &,               \
                                     const Surface<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
