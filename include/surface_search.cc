/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "surface_search.h"

#include <algorithm>
#include <limits>

#include "counters.h"

namespace Contact
{
  SurfaceSearch::SurfaceSearch(const Surface &surface, const Vector<double> &u)
    : surface(surface)
  {
    for (unsigned int i = 0; i < surface.nodes.size(); ++i)
      positions.push_back(surface.position(i, u));

    std::vector<std::pair<Box, unsigned int>> entries;
    for (unsigned int e = 0; e < surface.edges.size(); ++e)
      {
        // All that project() can answer with: the edge with its overhang. A
        // parabola stays within the triangle of its ends and the point where
        // their tangents meet.
        const auto [low, high]    = coordinate_range(e);
        const auto              x = edge_positions(e);
        const EdgeShape         first(surface.degree, low);
        const EdgeShape         last(surface.degree, high);
        std::array<Point<2>, 3> hull;
        for (unsigned int a = 0; a < surface.n_nodes_per_edge(); ++a)
          {
            hull[0] += first.value[a] * x[a];
            hull[1] += last.value[a] * x[a];
            hull[2] +=
              (first.value[a] + (high - low) / 2 * first.first[a]) * x[a];
          }
        entries.emplace_back(Box(
                               std::vector<Point<2>>(hull.begin(), hull.end())),
                             e);
      }
    tree = pack_rtree(entries);
  }



  std::pair<double, double>
  SurfaceSearch::coordinate_range(const unsigned int edge) const
  {
    return {surface.edges[edge].begins_surface ? -1 - overhang : -1.,
            surface.edges[edge].ends_surface ? 1 + overhang : 1.};
  }



  std::array<Point<2>, 3>
  SurfaceSearch::edge_positions(const unsigned int edge) const
  {
    std::array<Point<2>, 3> x;
    for (unsigned int a = 0; a < surface.n_nodes_per_edge(); ++a)
      x[a] = positions[surface.edges[edge].nodes[a]];
    return x;
  }



  Projection SurfaceSearch::closest_point(const Point<2> &x) const
  {
    namespace bgi = boost::geometry::index;

    ++counters().projections;
    Projection best{0, 0, false, false};
    double     best_distance = std::numeric_limits<double>::max();
    for (auto entry = tree.qbegin(bgi::nearest(x, surface.edges.size()));
         entry != tree.qend();
         ++entry)
      {
        const double to_box =
          boost::geometry::comparable_distance(x, entry->first);
        if (to_box > best_distance)
          break;
        ++counters().candidate_pairs;
        const Projection candidate = project(x, entry->second);
        const double     distance  = distance_square(x, candidate);
        if (distance < best_distance)
          {
            best          = candidate;
            best_distance = distance;
          }
      }
    return best;
  }



  // Newton's method for (x - x_m(xi)) . x_m'(xi) = 0 from the projection onto
  // the chord; on a straight edge the first step is exact. Where the curvature
  // of the distance is not positive, Gauss-Newton takes over.
  Projection SurfaceSearch::project(const Point<2>    &x,
                                    const unsigned int edge) const
  {
    const auto         nodes = edge_positions(edge);
    const Tensor<1, 2> chord = nodes[1] - nodes[0];
    double xi = 2 * ((x - nodes[0]) * chord) / chord.norm_square() - 1;

    if (surface.degree == 2)
      {
        xi = std::max(-1.5, std::min(1.5, xi));
        for (unsigned int iteration = 0; iteration < 50; ++iteration)
          {
            const EdgeShape shape(2, xi);
            Tensor<1, 2>    r = x, tangent, curvature;
            for (unsigned int a = 0; a < 3; ++a)
              {
                r -= shape.value[a] * nodes[a];
                tangent += shape.first[a] * nodes[a];
                curvature += shape.second[a] * nodes[a];
              }
            const double full  = tangent.norm_square() - r * curvature;
            const double slope = full > 0 ? full : tangent.norm_square();
            const double step  = (r * tangent) / slope;
            xi                 = std::max(-2., std::min(2., xi + step));
            if (std::abs(step) < 1e-14)
              break;
          }
      }

    const auto &flags      = surface.edges[edge];
    const auto [low, high] = coordinate_range(edge);
    const bool off =
      (flags.begins_surface && xi < low) || (flags.ends_surface && xi > high);
    return {edge,
            std::max(low, std::min(high, xi)),
            off,
            xi < low || xi > high};
  }



  double SurfaceSearch::distance_square(const Point<2>   &x,
                                        const Projection &projection) const
  {
    const auto      nodes = edge_positions(projection.edge);
    const EdgeShape shape(surface.degree, projection.xi);
    Tensor<1, 2>    r = x;
    for (unsigned int a = 0; a < surface.n_nodes_per_edge(); ++a)
      r -= shape.value[a] * nodes[a];
    return r.norm_square();
  }
} // namespace Contact
