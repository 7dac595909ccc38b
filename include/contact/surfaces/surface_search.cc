/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/surface_search.h"

#include <algorithm>
#include <limits>


namespace Contact
{
  bool NormalCone<2>::faces(const Tensor<1, 2> &normal) const
  {
    const Tensor<1, 2> to = -normal;
    for (const Tensor<1, 2> &other : others)
      if (to * other > std::max(to * first, to * last))
        return false;
    return to * first >= smallest_cosine() || to * last >= smallest_cosine() ||
           (cross(first, to) > 0 && cross(to, last) > 0 &&
            cross(first, last) > 0);
  }



  bool NormalCone<2>::is_beside(const Tensor<1, 2> &normal) const
  {
    return std::max(-normal * first, -normal * last) > -smallest_cosine();
  }



  SurfaceSearch<2>::SurfaceSearch(const Surface<2>    &surface,
                                  const GhostedVector &u)
    : surface(surface)
  {
    for (unsigned int i = 0; i < surface.nodes.size(); ++i)
      positions.push_back(surface.position(i, u));

    std::vector<std::pair<Box, unsigned int>> entries;
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      {
        const auto corners = hull(e);
        entries.emplace_back(Box(std::vector<Point<2>>(corners.begin(),
                                                       corners.end())),
                             e);
      }
    tree = pack_rtree(entries);
  }



  std::pair<double, double>
  SurfaceSearch<2>::coordinate_range(const unsigned int edge) const
  {
    return {surface.facets[edge].begins_face ? -1 - overhang : -1.,
            surface.facets[edge].ends_face ? 1 + overhang : 1.};
  }



  // All that project() can answer with. A parabola stays within the triangle of
  // its ends and the point where their tangents meet.
  std::array<Point<2>, 3> SurfaceSearch<2>::hull(const unsigned int edge) const
  {
    const auto [low, high]    = coordinate_range(edge);
    const auto              x = edge_positions(edge);
    const EdgeShape         first(surface.degree, low);
    const EdgeShape         last(surface.degree, high);
    std::array<Point<2>, 3> hull;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      {
        hull[0] += first.value[a] * x[a];
        hull[1] += last.value[a] * x[a];
        hull[2] += (first.value[a] + (high - low) / 2 * first.first[a]) * x[a];
      }
    return hull;
  }



  std::array<Point<2>, 3>
  SurfaceSearch<2>::edge_positions(const unsigned int edge) const
  {
    std::array<Point<2>, 3> x;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      x[a] = positions[surface.facets[edge].nodes[a]];
    return x;
  }



  Projection<2> SurfaceSearch<2>::closest_point(const Point<2> &x) const
  {
    return choose(x, [](const Projection<2> &) { return true; });
  }



  Projection<2>
  SurfaceSearch<2>::closest_facing(const Point<2>      &x,
                                   const NormalCone<2> &directions) const
  {
    const auto opposite = [&](const Projection<2> &candidate) {
      return directions.faces(normal(candidate.facet, candidate.xi));
    };
    Projection<2> found = choose(x, opposite);
    if (found.off_the_end && directions.at_end)
      {
        const auto beside = [&](const Projection<2> &candidate) {
          return directions.is_beside(normal(candidate.facet, candidate.xi));
        };
        const Projection<2> next = choose(x, beside);
        if (!next.off_the_end)
          found = next;
      }
    return found;
  }



  Projection<2> SurfaceSearch<2>::choose(const Point<2> &x,
                                         const Accept   &accept) const
  {
    Projection<2> found = closest(x, accept);
    if (found.facet == numbers::invalid_unsigned_int)
      {
        // Only to have a distance.
        found = closest(x, [](const Projection<2> &) { return true; });
        found.off_the_end = true;
        return found;
      }
    found      = choose_at_corner(x, found, accept);
    found.twin = find_twin(x, found, accept);
    return found;
  }



  Projection<2> SurfaceSearch<2>::closest(const Point<2> &x,
                                          const Accept   &accept) const
  {
    namespace bgi = boost::geometry::index;

    ++surface.counters().projections;
    Projection<2> best;
    double        best_distance = std::numeric_limits<double>::max();
    for (auto entry = tree.qbegin(bgi::nearest(x, surface.facets.size()));
         entry != tree.qend();
         ++entry)
      {
        const double to_box =
          boost::geometry::comparable_distance(x, entry->first);
        if (to_box > best_distance)
          break;
        ++surface.counters().candidate_pairs;
        const Projection<2> candidate = project(x, entry->second);
        const double        distance  = distance_square(x, candidate);
        if (distance < best_distance && accept(candidate) &&
            is_closest_around(x, candidate))
          {
            best          = candidate;
            best_distance = distance;
          }
      }
    return best;
  }



  bool SurfaceSearch<2>::is_closest_around(const Point<2>      &x,
                                           const Projection<2> &candidate) const
  {
    const unsigned int other = neighbor(candidate);
    if (!candidate.clipped || other == numbers::invalid_unsigned_int ||
        surface.facets[candidate.facet].corner[candidate.xi > 0 ? 1 : 0])
      return true;
    const Projection<2> beside         = project(x, other);
    const bool          is_same_vertex = beside.xi * candidate.xi == -1;
    return is_same_vertex ||
           distance_square(x, beside) >= distance_square(x, candidate);
  }



  unsigned int SurfaceSearch<2>::neighbor(const Projection<2> &projection) const
  {
    const auto &edge = surface.facets[projection.facet];
    return projection.xi > 0   ? edge.next
           : projection.xi < 0 ? edge.previous
                               : numbers::invalid_unsigned_int;
  }



  Projection<2> SurfaceSearch<2>::choose_at_corner(const Point<2>      &x,
                                                   const Projection<2> &best,
                                                   const Accept &accept) const
  {
    const unsigned int other = neighbor(best);
    if (other == numbers::invalid_unsigned_int || std::abs(best.xi) <= 1)
      return best;
    const Projection<2> beside = project(x, other);
    if (best.xi * beside.xi > 0 || std::abs(beside.xi) <= 1 ||
        beside.off_the_end || !accept(beside))
      return best;
    return best.off_the_end ||
               distance_square(x, beside) > distance_square(x, best)
             ? beside
             : best;
  }



  unsigned int SurfaceSearch<2>::find_twin(const Point<2>      &x,
                                           const Projection<2> &found,
                                           const Accept        &accept) const
  {
    const unsigned int other = neighbor(found);
    if (other == numbers::invalid_unsigned_int || std::abs(found.xi) > 1)
      return numbers::invalid_unsigned_int;
    const Projection<2> beside = project(x, other);

    // Round-off of coordinates, against an edge.
    const auto   nodes     = edge_positions(found.facet);
    const double round_off = 1e-10 * (nodes[1] - nodes[0]).norm();
    return std::abs(std::sqrt(distance_square(x, beside)) -
                    std::sqrt(distance_square(x, found))) <= round_off &&
               std::abs(beside.xi) <= 1 && accept(beside)
             ? other
             : numbers::invalid_unsigned_int;
  }



  std::vector<unsigned int>
  SurfaceSearch<2>::edges_in(const BoundingBox<2> &box) const
  {
    std::vector<unsigned int> edges;
    for (auto entry = tree.qbegin(boost::geometry::index::intersects(box));
         entry != tree.qend();
         ++entry)
      edges.push_back(entry->second);
    return edges;
  }



  Tensor<1, 2> SurfaceSearch<2>::normal(const unsigned int edge,
                                        const double       xi) const
  {
    const auto      nodes = edge_positions(edge);
    const EdgeShape shape(surface.degree, xi);
    Tensor<1, 2>    along;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      along += shape.first[a] * nodes[a];
    return cross_product_2d(along) / along.norm();
  }



  // Newton's method for (x - x_m(xi)) . x_m'(xi) = 0 from the projection onto
  // the chord; on a straight edge the first step is exact. Where the curvature
  // of the distance is not positive, Gauss-Newton takes over.
  Projection<2> SurfaceSearch<2>::project(const Point<2>    &x,
                                          const unsigned int edge,
                                          const double       extension) const
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

    const auto  &flags = surface.facets[edge];
    const auto   range = coordinate_range(edge);
    const double low   = std::min(range.first, -1 - extension);
    const double high  = std::max(range.second, 1 + extension);
    const bool   off =
      (flags.begins_face && xi < low) || (flags.ends_face && xi > high);
    return {edge,
            std::max(low, std::min(high, xi)),
            off,
            xi < low || xi > high};
  }



  Point<2> SurfaceSearch<2>::position(const Projection<2> &projection) const
  {
    const auto      nodes = edge_positions(projection.facet);
    const EdgeShape shape(surface.degree, projection.xi);
    Point<2>        x;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      x += shape.value[a] * nodes[a];
    return x;
  }



  std::vector<bool>
  SurfaceSearch<2>::may_be_close(const SurfaceSearch<2> &other,
                                 const double            distance) const
  {
    std::vector<bool> by_facet;
    for (unsigned int e = 0; e < other.surface.facets.size(); ++e)
      {
        const auto corners = other.hull(e);
        Box        box(std::vector<Point<2>>(corners.begin(), corners.end()));
        box.extend(distance);
        by_facet.push_back(
          tree.qbegin(boost::geometry::index::intersects(box)) != tree.qend());
      }
    return by_facet;
  }



  double
  SurfaceSearch<2>::distance_square(const Point<2>      &x,
                                    const Projection<2> &projection) const
  {
    return x.distance_square(position(projection));
  }
} // namespace Contact
