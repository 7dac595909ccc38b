/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Surface on what facets in 3-D have: sides in common.

#include <algorithm>
#include <map>

#include "contact/surfaces/deformed_surface.h"

namespace Contact
{
  namespace
  {
    /// Two nodes, or a facet and the number of a side.
    using Side = std::pair<unsigned int, unsigned int>;



    Side ends_of_side(const SurfaceFacet<3> &facet, const unsigned int side)
    {
      return std::minmax(facet.end_of_side(side, 0),
                         facet.end_of_side(side, 1));
    }



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
        for (unsigned int s = 0; s < surface.facets[e].n_sides(); ++s)
          {
            const SurfaceFacet<3> &facet = surface.facets[e];
            const Side             ends  = ends_of_side(facet, s);
            const auto             halve = [&](const unsigned int middle) {
              side_of.emplace(std::minmax(ends.first, middle), Side(e, s));
              side_of.emplace(std::minmax(middle, ends.second), Side(e, s));
            };
            if (surface.degree == 2)
              halve(facet.nodes[facet.kind->middle_of_side(s)]);
            else if (const auto found = middles.find(ends);
                     found != middles.end())
              for (const unsigned int middle : found->second)
                halve(middle);
          }

      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < surface.facets[e].n_sides(); ++s)
          {
            const auto larger =
              side_of.find(ends_of_side(surface.facets[e], s));
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
        for (unsigned int s = 0; s < surface.facets[e].n_sides(); ++s)
          {
            const Side ends  = ends_of_side(surface.facets[e], s);
            const auto found = side_of.emplace(ends, Side(e, s));
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
        Tensor<1, 3>           sum;
        const SurfaceFacet<3> &facet = surface.facets[e];
        for (unsigned int a = 0; a < facet.kind->n_vertices; ++a)
          if (facet.nodes[a] == ends.first || facet.nodes[a] == ends.second)
            sum += drawn.normal(e, facet.kind->places[a]);
        return sum / sum.norm();
      };
      const double smallest_cosine =
        std::cos(numbers::PI / 180 * Surface<3>::feature_angle);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int s = 0; s < surface.facets[e].n_sides(); ++s)
          {
            SurfaceFacet<3> &facet = surface.facets[e];
            if (facet.ends_surface(s))
              continue;
            const Side ends(facet.end_of_side(s, 0), facet.end_of_side(s, 1));
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
      for (unsigned int s = 0; s < facet.n_sides(); ++s)
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
        const unsigned int     n     = facet.kind->n_vertices;
        Tensor<1, 3>           centre;
        for (unsigned int a = 0; a < n; ++a)
          centre += 1. / n * Tensor<1, 3>(nodes[facet.nodes[a]].X);
        const double size =
          nodes[facet.nodes[0]].X.distance(nodes[facet.nodes[n - 1]].X);
        if ((facet.middle - centre).norm() > 1e-6 * size)
          continue;
        const auto normal_at_first = [&](const unsigned int of) {
          return drawn.normal(of, facets[of].kind->places[0]);
        };
        for (unsigned int s = 0; s < facet.n_sides(); ++s)
          if (!facet.corner[s] && !facet.ends_surface(s))
            smallest_cosine = std::min(smallest_cosine,
                                       normal_at_first(e) *
                                         normal_at_first(facet.neighbors[s]));
      }
    return 180 / numbers::PI * std::acos(std::max(-1., smallest_cosine));
  }



  template<>
  std::vector<double>
  Surface<3>::shares_of_nodes(const unsigned int facet) const
  {
    const FacetKind<3> &kind = *facets[facet].kind;
    std::vector<double> shares(kind.n_nodes);
    for (unsigned int q = 0; q < kind.rule_places.size(); ++q)
      {
        const FacetShape<3> shape(kind, kind.rule_places[q]);
        const auto          tests    = kind.tests(shape.value);
        const double        jacobian = reference_jacobian(facets[facet], shape);
        for (unsigned int a = 0; a < shares.size(); ++a)
          shares[a] += kind.rule_weights[q] * tests[a] * jacobian;
      }
    return shares;
  }
} // namespace Contact
