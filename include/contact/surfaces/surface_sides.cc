/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Surface on what quadrangles in 3-D are: sides in common.

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>

#include "contact/surfaces/deformed_surface.h"

namespace Contact
{
  namespace
  {
    /// Two nodes, or a facet and the number of a side.
    using Side = std::pair<unsigned int, unsigned int>;



    // A side that two smaller facets share has the first of them as its
    // neighbor.
    void link_halves_of_sides(Surface<3> &surface)
    {
      std::map<Side, std::vector<unsigned int>> middles; // by the ends
      for (unsigned int node = 0; node < surface.nodes.size(); ++node)
        if (surface.parents[node].size() == 2)
          middles[std::minmax(surface.parents[node][0].first,
                              surface.parents[node][1].first)]
            .push_back(node);

      std::map<Side, Side> side_of; // by the ends of halves
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < 4; ++s)
          {
            const auto [a, b] = corners_of_side[s];
            const Side ends   = std::minmax(surface.facets[e].nodes[a],
                                          surface.facets[e].nodes[b]);
            const auto halve  = [&](const unsigned int middle) {
              side_of.emplace(std::minmax(ends.first, middle), Side(e, s));
              side_of.emplace(std::minmax(middle, ends.second), Side(e, s));
            };
            if (surface.degree == 2)
              halve(surface.facets[e].nodes[4 + s]);
            else if (const auto found = middles.find(ends);
                     found != middles.end())
              for (const unsigned int middle : found->second)
                halve(middle);
          }

      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < 4; ++s)
          {
            const auto [a, b] = corners_of_side[s];
            const auto larger =
              side_of.find(std::minmax(surface.facets[e].nodes[a],
                                       surface.facets[e].nodes[b]));
            if (!surface.facets[e].ends_surface(s) || larger == side_of.end())
              continue;
            const auto [other, side]       = larger->second;
            surface.facets[e].neighbors[s] = other;
            if (surface.facets[other].ends_surface(side))
              surface.facets[other].neighbors[side] = e;
          }
    }



    void link_sides(Surface<3> &surface)
    {
      std::map<Side, Side> side_of;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < 4; ++s)
          {
            const auto [a, b] = corners_of_side[s];
            const Side ends   = std::minmax(surface.facets[e].nodes[a],
                                          surface.facets[e].nodes[b]);
            const auto found  = side_of.emplace(ends, Side(e, s));
            if (found.second)
              continue;
            const auto [other, side]              = found.first->second;
            surface.facets[e].neighbors[s]        = other;
            surface.facets[other].neighbors[side] = e;
          }
      link_halves_of_sides(surface);
    }



    // The surface.facets meet in a corner if their normals at the middle of the
    // side differ: a convex one if the other facet falls off behind the plane
    // of this one.
    void find_corners(Surface<3> &surface)
    {
      const DeformedSurface<3> drawn(surface, {});
      const auto normal_at = [&](const unsigned int e, const Side &ends) {
        Tensor<1, 3> sum;
        for (unsigned int a = 0; a < 4; ++a)
          if (surface.facets[e].nodes[a] == ends.first ||
              surface.facets[e].nodes[a] == ends.second)
            sum += drawn.normal(e, node_place<3>(a));
        return sum / sum.norm();
      };
      const double smallest_cosine =
        std::cos(numbers::PI / 180 * Surface<3>::feature_angle);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < 4; ++s)
          {
            SurfaceFacet<3> &facet = surface.facets[e];
            if (facet.ends_surface(s))
              continue;
            const auto [a, b] = corners_of_side[s];
            const Side         ends(facet.nodes[a], facet.nodes[b]);
            const Tensor<1, 3> own  = normal_at(e, ends);
            const Tensor<1, 3> next = normal_at(facet.neighbors[s], ends);
            facet.corner[s]         = own * next < smallest_cosine;
            facet.ends_side[s] =
              facet.corner[s] &&
              own * (surface.facets[facet.neighbors[s]].middle -
                     surface.nodes[ends.first].X) <
                0;
          }
    }
  } // namespace



  template<>
  void Surface<3>::arrange()
  {
    collect_facets_of_nodes();
    link_sides(*this);
    find_corners(*this);
  }



  template<>
  std::vector<unsigned int> Surface<3>::same_side(const unsigned int facet,
                                                  const unsigned int a) const
  {
    return smooth_around(facet, a);
  }



  template<>
  void Surface<3>::cut_links()
  {
    for (SurfaceFacet<3> &facet : facets)
      for (unsigned int s = 0; s < 4; ++s)
        if (facet.corner[s])
          {
            facet.neighbors[s] = numbers::invalid_unsigned_int;
            facet.corner[s]    = false;
            facet.ends_side[s] = true;
          }
  }



  // Flat facets stand for themselves.
  template<>
  double Surface<3>::largest_bend() const
  {
    const DeformedSurface<3> drawn(*this, {});
    double                   smallest_cosine = 1;
    for (unsigned int e = 0; e < facets.size(); ++e)
      {
        const SurfaceFacet<3> &facet = facets[e];
        Tensor<1, 3>           centre;
        for (unsigned int a = 0; a < 4; ++a)
          centre += 0.25 * Tensor<1, 3>(nodes[facet.nodes[a]].X);
        const double size =
          nodes[facet.nodes[0]].X.distance(nodes[facet.nodes[3]].X);
        if ((facet.middle - centre).norm() > 1e-6 * size)
          continue;
        for (unsigned int s = 0; s < 4; ++s)
          if (!facet.corner[s] && !facet.ends_surface(s))
            smallest_cosine =
              std::min(smallest_cosine,
                       drawn.normal(e, node_place<3>(0)) *
                         drawn.normal(facet.neighbors[s], node_place<3>(0)));
      }
    return 180 / numbers::PI * std::acos(std::max(-1., smallest_cosine));
  }



  template<>
  std::vector<double>
  Surface<3>::shares_of_nodes(const unsigned int facet) const
  {
    static const std::array<QGauss<2>, 2> rules{{QGauss<2>(2), QGauss<2>(3)}};
    const QGauss<2>                      &quadrature = rules[degree - 1];
    std::vector<double>                   shares(n_nodes_per_facet());
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<2>      xi(2 * quadrature.point(q)[0] - 1,
                          2 * quadrature.point(q)[1] - 1);
        const FacetShape<3> shape(degree, xi);
        const double        jacobian = reference_jacobian(facets[facet], shape);
        for (unsigned int a = 0; a < shares.size(); ++a)
          shares[a] += 4 * quadrature.weight(q) * shape.value[a] * jacobian;
      }
    return shares;
  }
} // namespace Contact
