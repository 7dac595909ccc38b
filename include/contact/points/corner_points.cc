/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/corner_points.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  namespace
  {
    /// Whether a projection lies at the end of a face, from where on both sides
    /// the overhang counts.
    bool is_at_end_of_face(const Surface<2>      &surface,
                           const ContactPoint<2> &point)
    {
      const SurfaceFacet<2> &edge = surface.facets[point.master_facet];
      const double           last = 1 - DeformedSurface<2>::overhang;
      return (edge.ends_face[0] && point.master_xi < -last) ||
             (edge.ends_face[1] && point.master_xi > last);
    }
  } // namespace



  std::vector<ContactPoint<2>> make_corner_points(const Surface<2> &master)
  {
    std::vector<unsigned int> corners;
    for (unsigned int e = 0; e < master.facets.size(); ++e)
      {
        const SurfaceFacet<2> &edge = master.facets[e];
        const bool is_corner        = edge.corner[0] && edge.ends_face[0] &&
                               master.turn_of_curves(e) >
                                 numbers::PI / 180 * Surface<2>::feature_angle;
        if (is_corner || edge.ends_surface(0))
          corners.push_back(edge.nodes[0]);
        if (edge.ends_surface(1))
          corners.push_back(edge.nodes[1]);
      }
    if (corners.empty())
      return {};

    MultiplierSpace              numbering;
    const auto                   all = make_nodal_points(master, {}, numbering);
    std::vector<ContactPoint<2>> points;
    for (const unsigned int node : corners)
      {
        points.push_back(all[numbering.of_node[node]]);
        points.back().is_master_corner = true;
        points.back().multipliers[0]   = points.size() - 1;
      }
    return points;
  }



  double distance(const ContactPoint<2> &corner, const GhostedVector &u)
  {
    double sum = 0;
    for (unsigned int a = 0; a < corner.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        sum += corner.normal[i] * corner.C[a] *
               (corner.X(a)[i] + u[corner.dofs(a)[i]]);
    return sum;
  }



  void pair_corner_points(const ArrayView<ContactPoint<2>> &corners,
                          const DeformedSurface<2>         &master,
                          const DeformedSurface<2>         &slave,
                          const Discretization<2>          &discretization,
                          const GhostedVector              &u)
  {
    for (ContactPoint<2> &corner : corners)
      {
        // A slave edge beside the end of the master does not obstruct it.
        NormalCone<2> directions = directions_of(corner, master);
        directions.at_end        = false;
        pair_with_master(corner, directions, slave, discretization, u);
        const double length =
          slave.surface.reference_length(corner.master_facet);
        corner.facing = corner.facing && distance(corner, u) > -length &&
                        !is_at_end_of_face(slave.surface, corner);
        corner.projection = Point<2>(-corner_slack * length * corner.normal);
      }
  }



  unsigned int node_at_foot(const ContactPoint<2> &corner,
                            const Surface<2>      &slave)
  {
    const double close = 1e-2;
    const auto  &nodes = slave.facets[corner.master_facet].nodes;
    if (corner.facing)
      {
        if (std::abs(corner.master_xi) > 1 - close)
          return nodes[corner.master_xi > 0 ? 1 : 0];
        if (slave.degree == 2 && std::abs(corner.master_xi) < close)
          return nodes[2];
      }
    return numbers::invalid_unsigned_int;
  }
} // namespace Contact
