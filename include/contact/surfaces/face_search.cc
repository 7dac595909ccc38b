/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/face_search.h"

#include <algorithm>
#include <limits>

namespace Contact
{
  bool NormalCone<3>::faces(const Tensor<1, 3> &normal) const
  {
    double largest = -1;
    for (const Tensor<1, 3> &n : normals)
      largest = std::max(largest, -(normal * n));
    return largest >= NormalCone<2>::smallest_cosine() &&
           std::none_of(others.begin(), others.end(), [&](const auto &n) {
             return -(normal * n) > largest;
           });
  }



  bool NormalCone<3>::is_beside(const Tensor<1, 3> &normal) const
  {
    return std::any_of(normals.begin(), normals.end(), [&](const auto &n) {
      return -(normal * n) > -NormalCone<2>::smallest_cosine();
    });
  }



  // A facet of degree 2 may lie outside of the box of its nodes, by no more
  // than the largest size of the box; and so may the overhang.
  SurfaceSearch<3>::SurfaceSearch(const Surface<3>    &surface,
                                  const GhostedVector &u)
    : surface(surface)
  {
    for (unsigned int i = 0; i < surface.nodes.size(); ++i)
      positions.push_back(surface.position(i, u));

    std::vector<std::pair<Box, unsigned int>> entries;
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      {
        const auto nodes = facet_positions(e);
        Box        box(
          std::vector<Point<3>>(nodes.begin(),
                                nodes.begin() + surface.n_nodes_per_facet()));
        double largest = 0;
        for (unsigned int c = 0; c < 3; ++c)
          largest = std::max(largest, box.side_length(c));
        box.extend((surface.degree == 2 ? 0.25 + overhang : overhang) *
                   largest);
        hulls.push_back(hull(e, nodes));
        entries.emplace_back(box, e);
      }
    tree = pack_rtree(entries);
  }



  // That of the facet's control points, as of a surface of Bezier: at degree 2
  // the middle one of three nodes a, m, b of a line is 2 m - (a + b) / 2. With
  // an overhang the line goes on to where its own control points are.
  SurfaceSearch<3>::Box SurfaceSearch<3>::hull(const unsigned int facet,
                                               const Nodes       &nodes) const
  {
    Nodes      points  = nodes;
    const auto control = [&](const unsigned int first,
                             const unsigned int last,
                             const unsigned int middle,
                             const unsigned int k) {
      const auto  &ends  = surface.facets[facet].ends_face;
      const double begin = ends[2 * k] ? -1 - overhang : -1,
                   end   = ends[2 * k + 1] ? 1 + overhang : 1;
      const Point<3> a = points[first], b = points[last];
      if (surface.degree == 1)
        {
          const Tensor<1, 3> slope = 0.5 * (b - a);
          points[first]            = a + (begin + 1) * slope;
          points[last]             = b + (end - 1) * slope;
          return;
        }
      const Point<3>     m     = points[middle];
      const Tensor<1, 3> slope = 0.5 * (b - a);
      const Tensor<1, 3> bend  = 0.5 * ((a - m) + (b - m));
      points[first]            = m + begin * slope + begin * begin * bend;
      points[last]             = m + end * slope + end * end * bend;
      points[middle] = m + 0.5 * (begin + end) * slope + begin * end * bend;
    };
    control(0, 1, 6, 0);
    control(2, 3, 7, 0);
    if (surface.degree == 2)
      control(4, 5, 8, 0);
    control(0, 2, 4, 1);
    control(1, 3, 5, 1);
    if (surface.degree == 2)
      control(6, 7, 8, 1);
    return Box(
      std::vector<Point<3>>(points.begin(),
                            points.begin() + surface.n_nodes_per_facet()));
  }



  SurfaceSearch<3>::Nodes
  SurfaceSearch<3>::facet_positions(const unsigned int facet) const
  {
    Nodes x;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      x[a] = positions[surface.facets[facet].nodes[a]];
    return x;
  }



  std::vector<bool>
  SurfaceSearch<3>::may_be_close(const SurfaceSearch<3> &other,
                                 const double            distance) const
  {
    std::vector<bool> by_facet;
    for (Box box : other.hulls)
      {
        box.extend(distance);
        by_facet.push_back(
          std::any_of(tree.qbegin(boost::geometry::index::intersects(box)),
                      tree.qend(),
                      [&](const auto &entry) {
                        return boost::geometry::intersects(box,
                                                           hulls[entry.second]);
                      }));
      }
    return by_facet;
  }



  std::vector<unsigned int>
  SurfaceSearch<3>::facets_in(const BoundingBox<3> &box) const
  {
    std::vector<unsigned int> facets;
    for (auto entry = tree.qbegin(boost::geometry::index::intersects(box));
         entry != tree.qend();
         ++entry)
      facets.push_back(entry->second);
    std::sort(facets.begin(), facets.end());
    return facets;
  }



  Projection<3>
  SurfaceSearch<3>::closest_facing(const Point<3>      &x,
                                   const NormalCone<3> &directions) const
  {
    Projection<3> found = choose(x, [&](const Projection<3> &candidate) {
      return directions.faces(normal(candidate.facet, candidate.xi));
    });
    if (found.off_the_end && directions.at_end)
      {
        const Projection<3> next =
          choose(x, [&](const Projection<3> &candidate) {
            return directions.is_beside(normal(candidate.facet, candidate.xi));
          });
        if (!next.off_the_end)
          found = next;
      }
    return found;
  }



  Projection<3> SurfaceSearch<3>::closest_point(const Point<3> &x) const
  {
    return choose(x, [](const Projection<3> &) { return true; });
  }



  Projection<3> SurfaceSearch<3>::closest_alone(const Point<3> &x) const
  {
    return closest(x, [](const Projection<3> &) { return true; });
  }



  Point<3> SurfaceSearch<3>::position(const Projection<3> &projection) const
  {
    const auto  values = FacetShape<3>::values(surface.degree, projection.xi);
    const auto &nodes  = surface.facets[projection.facet].nodes;
    Point<3>    x;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      x += values[a] * positions[nodes[a]];
    return x;
  }



  Projection<3> SurfaceSearch<3>::choose(const Point<3> &x,
                                         const Accept   &accept) const
  {
    Projection<3> found = closest(x, accept);
    if (found.facet == numbers::invalid_unsigned_int)
      {
        // Only to have a distance.
        found             = closest_alone(x);
        found.off_the_end = true;
        return found;
      }
    find_twins(x, accept, found);
    return found;
  }



  Projection<3> SurfaceSearch<3>::closest(const Point<3> &x,
                                          const Accept   &accept) const
  {
    namespace bgi = boost::geometry::index;

    const double round_off = 1e-10;
    ++surface.counters().projections;
    Projection<3> best;
    double        best_distance = std::numeric_limits<double>::max();
    for (auto entry = tree.qbegin(bgi::nearest(x, surface.facets.size()));
         entry != tree.qend();
         ++entry)
      {
        if (boost::geometry::comparable_distance(x, entry->first) >
            best_distance)
          break;
        if (boost::geometry::comparable_distance(x, hulls[entry->second]) >
            (1 + round_off) * best_distance)
          continue;
        ++surface.counters().candidate_pairs;
        const Projection<3> candidate = project(x, entry->second);
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



  bool SurfaceSearch<3>::is_closest_around(const Point<3>      &x,
                                           const Projection<3> &candidate) const
  {
    if (!candidate.clipped)
      return true;
    const double distance  = distance_square(x, candidate);
    const double round_off = 1e-10;
    const auto  &facet     = surface.facets[candidate.facet];
    for (unsigned int s = 0; s < 4; ++s)
      {
        const double at = s % 2 == 0 ? -1 : 1;
        if (candidate.xi[s / 2] == at && !facet.corner[s] &&
            facet.neighbors[s] != numbers::invalid_unsigned_int &&
            distance_square(x, project(x, facet.neighbors[s])) <
              (1 - round_off) * distance)
          return false;
      }
    return true;
  }



  // Round-off of coordinates, against a facet.
  void SurfaceSearch<3>::find_twins(const Point<3> &x,
                                    const Accept   &accept,
                                    Projection<3>  &found) const
  {
    const auto is_at = [](const double xi) { return std::abs(xi) == 1; };
    if (!is_at(found.xi[0]) && !is_at(found.xi[1]))
      return;
    const double   round_off = 1e-8 * surface.reference_length(found.facet);
    const Point<3> here      = position(found);
    std::set<unsigned int> around;
    for (unsigned int a = 0; a < 4; ++a)
      for (const unsigned int e :
           surface.facets_of_node[surface.facets[found.facet].nodes[a]])
        if (e != found.facet)
          around.insert(e);
    for (const unsigned int e : around)
      {
        const Projection<3> other = project(x, e);
        if (position(other).distance(here) <= round_off && accept(other))
          found.twins.emplace_back(e, other.xi);
      }
  }



  Tensor<1, 3> SurfaceSearch<3>::normal(const unsigned int facet,
                                        const Point<2>    &xi) const
  {
    const auto                  nodes = facet_positions(facet);
    const FacetShape<3>         shape(surface.degree, xi);
    std::array<Tensor<1, 3>, 2> tangents;
    for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
      for (unsigned int k = 0; k < 2; ++k)
        tangents[k] += shape.first[k][a] * nodes[a];
    const Tensor<1, 3> outward = outward_normal(tangents);
    return outward / outward.norm();
  }



  std::pair<double, double>
  SurfaceSearch<3>::range(const unsigned int facet,
                          const unsigned int k,
                          const double       extension) const
  {
    const auto &ends = surface.facets[facet].ends_face;
    return {-1 - std::max(extension, ends[2 * k] ? overhang : 0.),
            1 + std::max(extension, ends[2 * k + 1] ? overhang : 0.)};
  }



  // Where the Hessian of half the squared distance is not positive definite,
  // Gauss-Newton takes over. Iterates stay near the facet. Where it is far from
  // the origin, the round-off of places may be more than the tolerance: then
  // the last steps do not become shorter.
  Point<2> SurfaceSearch<3>::minimize(const Point<3>            &x,
                                      const Nodes               &nodes,
                                      Point<2>                   xi,
                                      const std::array<bool, 2> &is_free) const
  {
    const double small = 1e-8;
    double       last  = std::numeric_limits<double>::max();
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        const FacetShape<3>         shape(surface.degree, xi);
        Tensor<1, 3>                r = x, mixed;
        std::array<Tensor<1, 3>, 2> t, second;
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          {
            r -= shape.value[a] * nodes[a];
            mixed += shape.mixed[a] * nodes[a];
            for (unsigned int k = 0; k < 2; ++k)
              {
                t[k] += shape.first[k][a] * nodes[a];
                second[k] += shape.second[k][a] * nodes[a];
              }
          }
        Tensor<1, 2> step;
        if (is_free[0] && is_free[1])
          {
            double       a = t[0] * t[0] - r * second[0];
            double       b = t[0] * t[1] - r * mixed;
            double       d = t[1] * t[1] - r * second[1];
            const double gauss =
              (t[0] * t[0]) * (t[1] * t[1]) - (t[0] * t[1]) * (t[0] * t[1]);
            if (!(a > 0 && a * d - b * b > 1e-3 * gauss))
              {
                a = t[0] * t[0];
                b = t[0] * t[1];
                d = t[1] * t[1];
              }
            const double f = r * t[0], g = r * t[1], det = a * d - b * b;
            step[0] = (d * f - b * g) / det;
            step[1] = (a * g - b * f) / det;
          }
        else
          for (unsigned int k = 0; k < 2; ++k)
            if (is_free[k])
              {
                const double full = t[k] * t[k] - r * second[k];
                step[k] = (r * t[k]) / (full > 0 ? full : t[k] * t[k]);
              }
        for (unsigned int k = 0; k < 2; ++k)
          xi[k] = std::max(-2., std::min(2., xi[k] + step[k]));
        const double length = step.norm();
        if (length < 1e-14 || (length < small && length >= last))
          break;
        last = length;
      }
    return xi;
  }



  // Outside, the closest point is on one of the sides.
  Projection<3> SurfaceSearch<3>::project(const Point<3>    &x,
                                          const unsigned int facet,
                                          const double       extension) const
  {
    const auto nodes = facet_positions(facet);
    const std::array<std::pair<double, double>, 2> box{
      {range(facet, 0, extension), range(facet, 1, extension)}};

    Projection<3> found;
    found.facet        = facet;
    found.xi           = minimize(x, nodes, Point<2>(), {{true, true}});
    const auto outside = [&](const unsigned int k) {
      return found.xi[k] < box[k].first || found.xi[k] > box[k].second;
    };
    found.clipped = outside(0) || outside(1);
    if (!found.clipped)
      return found;

    const Point<2> whole    = found.xi;
    double         smallest = std::numeric_limits<double>::max();
    for (unsigned int s = 0; s < 4; ++s)
      {
        const unsigned int k = s / 2, l = 1 - k;
        Projection<3>      on_side = found;
        on_side.xi[k]              = s % 2 == 0 ? box[k].first : box[k].second;
        on_side.xi[l] = std::clamp(whole[l], box[l].first, box[l].second);
        on_side.xi    = minimize(x, nodes, on_side.xi, {{k != 0, k != 1}});
        on_side.xi[l] = std::clamp(on_side.xi[l], box[l].first, box[l].second);
        const double distance = distance_square(x, on_side);
        if (distance < smallest)
          {
            smallest = distance;
            found.xi = on_side.xi;
          }
      }
    const auto &ends = surface.facets[facet].ends_face;
    for (unsigned int k = 0; k < 2; ++k)
      if ((whole[k] < box[k].first && ends[2 * k]) ||
          (whole[k] > box[k].second && ends[2 * k + 1]))
        found.off_the_end = true;
    return found;
  }



  double
  SurfaceSearch<3>::distance_square(const Point<3>      &x,
                                    const Projection<3> &projection) const
  {
    return (x - position(projection)).norm_square();
  }
} // namespace Contact
