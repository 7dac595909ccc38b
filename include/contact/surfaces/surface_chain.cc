/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Surface on what edges in 2-D are: chains.

#include <algorithm>
#include <map>

#include "contact/surfaces/surface.h"

namespace Contact
{
  namespace
  {
    /// The angle from a to b, positive to the left [rad].
    double angle(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
    }



    /// From the first node of an edge to its last one [mm].
    Tensor<1, 2> chord(const Surface<2> &chain, const SurfaceFacet<2> &edge)
    {
      return chain.nodes[edge.nodes[1]].X - chain.nodes[edge.nodes[0]].X;
    }



    /// The direction of an edge at its coordinate xi, undeformed.
    Tensor<1, 2> tangent_of(const Surface<2>      &chain,
                            const SurfaceFacet<2> &edge,
                            const double           xi)
    {
      const EdgeShape shape(chain.degree, xi);
      Tensor<1, 2>    tangent;
      for (unsigned int a = 0; a < chain.n_nodes_per_edge(); ++a)
        tangent += shape.first[a] * chain.nodes[edge.nodes[a]].X;
      return tangent;
    }



    /// Put edges in the order in which each goes on where one ends.
    void chain_edges(std::vector<SurfaceFacet<2>> &facets)
    {
      std::map<unsigned int, unsigned int> begins_at;
      std::set<unsigned int>               ends;
      for (unsigned int e = 0; e < facets.size(); ++e)
        {
          begins_at[facets[e].nodes[0]] = e;
          ends.insert(facets[e].nodes[1]);
        }

      // Follow every open chain from its beginning, then what is left: loops.
      std::vector<SurfaceFacet<2>> chained;
      std::vector<bool>            taken(facets.size(), false);
      const auto                   follow = [&](unsigned int e) {
        while (!taken[e])
          {
            taken[e] = true;
            chained.push_back(facets[e]);
            if (const auto next = begins_at.find(facets[e].nodes[1]);
                next != begins_at.end())
              e = next->second;
          }
      };
      for (unsigned int e = 0; e < facets.size(); ++e)
        if (ends.count(facets[e].nodes[0]) == 0)
          follow(e);
      for (unsigned int e = 0; e < facets.size(); ++e)
        follow(e);
      facets = chained;
    }



    /// Number the nodes along the chain.
    void renumber_nodes(Surface<2> &chain)
    {
      std::vector<unsigned int>   new_number(chain.nodes.size(),
                                           numbers::invalid_unsigned_int);
      std::vector<SurfaceNode<2>> ordered;
      for (SurfaceFacet<2> &edge : chain.facets)
        {
          // Along the edge: first, (middle,) last.
          std::vector<unsigned int> along{0, 1};
          if (chain.degree == 2)
            along = {0, 2, 1};
          for (const unsigned int a : along)
            {
              unsigned int &node = edge.nodes[a];
              if (new_number[node] == numbers::invalid_unsigned_int)
                {
                  new_number[node] = ordered.size();
                  ordered.push_back(chain.nodes[node]);
                }
              node = new_number[node];
            }
        }
      chain.nodes = ordered; // none of them hangs
    }



    /// Tell edges their neighbors.
    void link_edges(std::vector<SurfaceFacet<2>> &facets)
    {
      std::map<unsigned int, unsigned int> begins_at;
      for (unsigned int e = 0; e < facets.size(); ++e)
        begins_at[facets[e].nodes[0]] = e;
      for (unsigned int e = 0; e < facets.size(); ++e)
        if (const auto next = begins_at.find(facets[e].nodes[1]);
            next != begins_at.end())
          {
            facets[e].neighbors[1]            = next->second;
            facets[next->second].neighbors[0] = e;
          }
    }



    // With the body on the left, the surface turns to the left where it is
    // convex.
    void find_corners(Surface<2> &chain)
    {
      for (SurfaceFacet<2> &edge : chain.facets)
        {
          if (edge.ends_surface(0))
            continue;
          SurfaceFacet<2> &before = chain.facets[edge.neighbors[0]];
          const double     turn =
            angle(tangent_of(chain, before, 1), tangent_of(chain, edge, -1));
          const double limit = numbers::PI / 180 * Surface<2>::feature_angle;
          before.corner[1] = edge.corner[0] = std::abs(turn) > limit;
          before.ends_side[1] = edge.ends_side[0] = turn > limit;
        }
    }



    // The middle of an arc of two edges turns by as much as both of its ends do
    // together, on longer arcs every kink turns by less. Beside an end of the
    // surface nothing is known of how it goes on.
    void find_features(Surface<2> &chain)
    {
      const auto turn_at = [&chain](const unsigned int e) {
        return e == numbers::invalid_unsigned_int ||
                   chain.facets[e].ends_surface(0)
                 ? numbers::PI
                 : std::abs(angle(
                     tangent_of(chain,
                                chain.facets[chain.facets[e].neighbors[0]],
                                1),
                     tangent_of(chain, chain.facets[e], -1)));
      };
      for (unsigned int e = 0; e < chain.facets.size(); ++e)
        {
          SurfaceFacet<2> &edge = chain.facets[e];
          if (edge.ends_surface(0))
            continue;
          const double turn = turn_at(e);
          const bool   is_alone =
            turn > numbers::PI / 360 * Surface<2>::feature_angle &&
            turn_at(edge.neighbors[0]) + turn_at(edge.neighbors[1]) < turn / 2;
          chain.facets[edge.neighbors[0]].is_feature[1] = edge.is_feature[0] =
            edge.corner[0] || is_alone;
        }
    }



    void measure_turns(Surface<2> &chain)
    {
      chain.turning_angles.assign(chain.nodes.size(), 0.);
      for (const SurfaceFacet<2> &edge : chain.facets)
        {
          if (!edge.ends_surface(0))
            chain.turning_angles[edge.nodes[0]] =
              std::abs(angle(chord(chain, chain.facets[edge.neighbors[0]]),
                             chord(chain, edge)));
          if (chain.degree == 2)
            chain.turning_angles[edge.nodes[2]] = std::abs(
              angle(tangent_of(chain, edge, -1), tangent_of(chain, edge, 1)));
        }

      // The body ends there, or it goes on with a side that is in no group. In
      // a hollow each side pushes along its own normal.
      for (const SurfaceFacet<2> &edge : chain.facets)
        for (unsigned int a = 0; a < 2; ++a)
          if (edge.ends_surface(a) && !edge.is_hollow[a])
            chain.turning_angles[edge.nodes[a]] = numbers::PI / 2;
    }
  } // namespace



  // On an arc the angle between the chords of its halves is half of what it
  // turns by, and each chord is a quarter of that off the tangent at its end.
  template<>
  double Surface<2>::turn_of_curves(const unsigned int e) const
  {
    if (facets[e].ends_surface(0))
      return 0;
    const auto half = [this](const SurfaceFacet<2> &edge,
                             const unsigned int     a) {
      const Point<2> end = nodes[edge.nodes[a]].X;
      return a == 0 ? edge.middle - end : end - edge.middle;
    };
    const SurfaceFacet<2> &before = facets[facets[e].neighbors[0]];
    return angle(half(before, 1), half(facets[e], 0)) -
           0.5 * (angle(half(before, 0), half(before, 1)) +
                  angle(half(facets[e], 0), half(facets[e], 1)));
  }



  // Edges stand for one curve where that turns by less than they do, however
  // few of them draw it.
  template<>
  std::vector<unsigned int> Surface<2>::same_side(const unsigned int e,
                                                  const unsigned int a) const
  {
    const unsigned int node = facets[e].nodes[a];
    const bool         is_cut =
      a < 2 && facets[e].is_feature[a] && !facets[e].ends_surface(a) &&
      (!facets[e].corner[a] ||
       std::abs(turn_of_curves(a == 0 ? e : facets[e].neighbors[1])) >
         numbers::PI / 180 * feature_angle);
    return is_cut ? std::vector<unsigned int>{e} : facets_of_node[node];
  }



  // The chain goes on in the same order, and ends at each cut.
  template<>
  void Surface<2>::cut_links()
  {
    for (SurfaceFacet<2> &edge : facets)
      {
        edge.neighbors.fill(numbers::invalid_unsigned_int);
        edge.ends_side.fill(true);
      }
    arrange();
    for (SurfaceFacet<2> &edge : facets)
      edge.corner = edge.is_feature = {{false, false}};
  }



  template<>
  void Surface<2>::arrange()
  {
    chain_edges(facets);
    renumber_nodes(*this);
    collect_facets_of_nodes();
    link_edges(facets);
    find_corners(*this);
    find_features(*this);
    measure_turns(*this);
  }



  template<>
  std::vector<double>
  Surface<2>::arc_length(const std::vector<Point<2>> &x) const
  {
    std::vector<double> s(nodes.size(), 0.);
    for (unsigned int i = 1; i < s.size(); ++i)
      s[i] = s[i - 1] + x[i].distance(x[i - 1]);
    return s;
  }



  template<>
  double Surface<2>::largest_bend() const
  {
    const auto is_straight = [this](const SurfaceFacet<2> &edge) {
      const Point<2> &a = nodes[edge.nodes[0]].X, &b = nodes[edge.nodes[1]].X;
      return edge.middle.distance(a + 0.5 * (b - a)) <= 1e-6 * a.distance(b);
    };
    double largest = 0;
    for (const SurfaceFacet<2> &edge : facets)
      if (!edge.ends_surface(0))
        {
          const double bend =
            180 / numbers::PI *
            std::abs(angle(chord(*this, facets[edge.neighbors[0]]),
                           chord(*this, edge)));
          if (!edge.corner[0] && is_straight(edge))
            largest = std::max(largest, bend);
        }
    return largest;
  }
} // namespace Contact
