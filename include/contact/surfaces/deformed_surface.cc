/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/deformed_surface.h"

#include <algorithm>
#include <limits>

namespace Contact
{
  namespace bgi = boost::geometry::index;

  template<int dim>
  DeformedSurface<dim>::DeformedSurface(
    const Surface<dim>            &surface,
    const std::vector<Point<dim>> &positions,
    const double                   overhang)
    : surface(surface)
    , positions(positions)
    , beyond_ends(overhang)
  {
  }



  template<int dim>
  const typename DeformedSurface<dim>::Tree &DeformedSurface<dim>::tree() const
  {
    if (!boxes)
      {
        std::vector<std::pair<Box, unsigned int>> entries;
        for (unsigned int e = 0; e < surface.facets.size(); ++e)
          entries.emplace_back(Box(hull(e)), e);
        boxes = pack_rtree(entries);
      }
    return *boxes;
  }



  template<int dim>
  std::vector<Tensor<1, dim>> DeformedSurface<dim>::normals() const
  {
    std::vector<Tensor<1, dim>> normals(positions.size());
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        normals[surface.facets[e].nodes[a]] +=
          normal(e, surface.facets[e].kind->places[a]);
    for (Tensor<1, dim> &normal : normals)
      normal /= normal.norm();
    return normals;
  }



  template<int dim>
  const FacetNormals<dim> &DeformedSurface<dim>::facet_normals() const
  {
    if (of_facets)
      return *of_facets;
    const auto        mean = normals();
    FacetNormals<dim> by_facet(surface.facets.size());
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        {
          const unsigned int node = surface.facets[e].nodes[a];
          by_facet[e][a]          = mean[node];
          if (surface.parted[e][a].empty())
            continue;
          Tensor<1, dim> sum;
          for (const unsigned int f : surface.parted[e][a])
            sum += normal(
              f,
              surface.facets[f].kind->places[surface.number_in(f, node)]);
          by_facet[e][a] = sum / sum.norm();
        }
    of_facets = std::move(by_facet);
    return *of_facets;
  }



  template<int dim>
  const std::vector<DirectionRange<dim>> &
  DeformedSurface<dim>::normal_ranges() const
  {
    if (!ranges)
      {
        ranges.emplace();
        for (unsigned int e = 0; e < surface.facets.size(); ++e)
          ranges->push_back(
            normal_range(*surface.facets[e].kind, facet_positions(e)));
      }
    return *ranges;
  }



  template<int dim>
  FacetNodes<dim>
  DeformedSurface<dim>::facet_positions(const unsigned int facet) const
  {
    FacetNodes<dim> x;
    for (unsigned int a = 0; a < surface.facets[facet].n_nodes(); ++a)
      x[a] = positions[surface.facets[facet].nodes[a]];
    return x;
  }



  template<int dim>
  typename FacetKind<dim>::Limits
  DeformedSurface<dim>::limits(const unsigned int facet) const
  {
    const SurfaceFacet<dim> &of     = surface.facets[facet];
    auto                     limits = of.kind->without_overhang();
    for (unsigned int s = 0; s < of.n_sides(); ++s)
      if (of.ends_side[s])
        limits[s] = 1 + beyond_ends;
    return limits;
  }



  template<int dim>
  std::vector<Point<dim>>
  DeformedSurface<dim>::hull(const unsigned int facet) const
  {
    return surface.facets[facet].kind->hull(facet_positions(facet),
                                            limits(facet));
  }



  template<int dim>
  std::vector<bool>
  DeformedSurface<dim>::may_be_close(const DeformedSurface<dim> &other,
                                     const double                distance) const
  {
    std::vector<bool> by_facet;
    for (unsigned int e = 0; e < other.surface.facets.size(); ++e)
      {
        Box box(other.hull(e));
        box.extend(distance);
        by_facet.push_back(tree().qbegin(bgi::intersects(box)) !=
                           tree().qend());
      }
    return by_facet;
  }



  template<int dim>
  std::vector<unsigned int>
  DeformedSurface<dim>::facets_in(const BoundingBox<dim> &box) const
  {
    std::vector<unsigned int> facets;
    for (const auto &[hull, facet] :
         tree() | bgi::adaptors::queried(bgi::intersects(box)))
      facets.push_back(facet);
    std::sort(facets.begin(), facets.end());
    return facets;
  }



  template<int dim>
  Projection<dim>
  DeformedSurface<dim>::closest_facing(const Point<dim>      &x,
                                       const NormalCone<dim> &directions) const
  {
    const auto accept = [&](const auto &is_direction) {
      return [&, is_direction](const Projection<dim> &candidate) {
        const Tensor<1, dim> n = normal(candidate.facet, candidate.xi);
        if (!is_direction(n) ||
            (directions.partners && !directions.partners(candidate.facet)))
          return false;
        const Point<dim> y = position(candidate.facet, candidate.xi);
        return (y - x) * n <= directions.reach || !directions.overlap ||
               directions.overlap(x,
                                  {y, surface, candidate.facet, candidate.xi});
      };
    };
    const auto           &ranges = normal_ranges();
    const Projection<dim> found =
      choose(x,
             accept(
               [&](const Tensor<1, dim> &n) { return directions.faces(n); }),
             [&](const unsigned int facet) {
               return directions.may_face(ranges[facet]);
             });
    if (found.beyond_end && directions.at_end)
      if (const Projection<dim> next =
            choose(x, accept([&](const Tensor<1, dim> &n) {
                     return directions.is_beside(n);
                   }));
          !next.beyond_end)
        return next;
    return found;
  }



  template<int dim>
  Point<dim> DeformedSurface<dim>::position(const unsigned int     facet,
                                            const FacetPoint<dim> &xi) const
  {
    const SurfaceFacet<dim> &of     = surface.facets[facet];
    const auto               values = FacetShape<dim>::values(*of.kind, xi);
    Point<dim>               x;
    for (unsigned int a = 0; a < of.n_nodes(); ++a)
      x += values[a] * positions[of.nodes[a]];
    return x;
  }



  template<int dim>
  Projection<dim>
  DeformedSurface<dim>::choose(const Point<dim> &x,
                               const Accept     &accept,
                               const MayAccept  &may_accept) const
  {
    Projection<dim> found = closest(x, accept, may_accept);
    if (found.facet == numbers::invalid_unsigned_int)
      {
        // Only to have a distance.
        found            = closest_alone(x);
        found.beyond_end = true;
        return found;
      }
    found = choose_at_corner(x, found, accept);
    find_twins(x, accept, found);
    return found;
  }



  template<int dim>
  Projection<dim>
  DeformedSurface<dim>::closest(const Point<dim> &x,
                                const Accept     &accept,
                                const MayAccept  &may_accept) const
  {
    ++surface.counters().projections;

    // The tree is asked at once for a number of nearest boxes, which grows
    // until one of them is beyond the closest point: an iterator of Boost
    // before 1.78 goes through whole branches of the tree for each box.
    const std::size_t                         leaf      = 16;
    const double                              round_off = 1e-10;
    std::vector<std::pair<Box, unsigned int>> nearest;
    const std::size_t                         all = surface.facets.size();
    for (std::size_t n = std::min(leaf, all);; n = std::min(n * leaf, all))
      {
        nearest.clear();
        tree().query(bgi::nearest(x, n) && bgi::satisfies([&](const auto &of) {
                       return may_accept(of.second);
                     }),
                     std::back_inserter(nearest));
        std::vector<std::pair<double, unsigned int>> by_distance;
        for (const auto &[box, facet] : nearest)
          by_distance.emplace_back(boost::geometry::comparable_distance(x, box),
                                   facet);
        std::sort(by_distance.begin(), by_distance.end());

        Projection<dim> best;
        double          best_distance = std::numeric_limits<double>::max();
        for (const auto &[to_box, facet] : by_distance)
          {
            if (to_box > (1 + round_off) * best_distance)
              return best;
            ++surface.counters().candidate_pairs;
            const Projection<dim> candidate = project(x, facet);
            const double          distance  = distance_square(x, candidate);
            if (distance < best_distance && accept(candidate) &&
                is_closest_around(x, candidate))
              {
                best          = candidate;
                best_distance = distance;
              }
          }
        if (nearest.size() < n || n == all)
          return best;
      }
  }



  template<int dim>
  bool DeformedSurface<dim>::is_closest_around(
    const Point<dim>      &x,
    const Projection<dim> &candidate) const
  {
    if (!candidate.clipped)
      return true;
    const double distance  = distance_square(x, candidate);
    const double round_off = 1e-10;
    const auto  &facet     = surface.facets[candidate.facet];
    for (unsigned int s = 0; s < facet.n_sides(); ++s)
      if (facet.kind->is_on_side(candidate.xi, s) && !facet.corner[s] &&
          !facet.ends_surface(s) &&
          distance_square(x, project(x, facet.neighbors[s])) <
            (1 - round_off) * distance)
        return false;
    return true;
  }



  template<>
  Projection<2> DeformedSurface<2>::choose_at_corner(const Point<2>      &x,
                                                     const Projection<2> &best,
                                                     const Accept &accept) const
  {
    const auto        &edge  = surface.facets[best.facet];
    const unsigned int other = edge.neighbors[best.xi > 0 ? 1 : 0];
    if (other == numbers::invalid_unsigned_int || std::abs(best.xi) <= 1)
      return best;
    const Projection<2> beside = project(x, other);
    if (best.xi * beside.xi > 0 || std::abs(beside.xi) <= 1 ||
        beside.beyond_end || !accept(beside))
      return best;
    return best.beyond_end ||
               distance_square(x, beside) > distance_square(x, best)
             ? beside
             : best;
  }



  template<>
  Projection<3> DeformedSurface<3>::choose_at_corner(const Point<3> &,
                                                     const Projection<3> &best,
                                                     const Accept &) const
  {
    return best;
  }



  template<>
  void DeformedSurface<2>::find_twins(const Point<2> &x,
                                      const Accept   &accept,
                                      Projection<2>  &found) const
  {
    const auto        &edge  = surface.facets[found.facet];
    const unsigned int other = edge.neighbors[found.xi > 0 ? 1 : 0];
    if (other == numbers::invalid_unsigned_int || found.xi == 0 ||
        std::abs(found.xi) > 1)
      return;
    const Projection<2> beside = project(x, other);

    // Round-off of coordinates, against an edge.
    const auto   nodes     = facet_positions(found.facet);
    const double round_off = 1e-10 * (nodes[1] - nodes[0]).norm();
    if (std::abs(std::sqrt(distance_square(x, beside)) -
                 std::sqrt(distance_square(x, found))) <= round_off &&
        std::abs(beside.xi) <= 1 && accept(beside))
      found.twins.emplace_back(other, beside.xi);
  }



  // Round-off of coordinates, against a facet.
  template<>
  void DeformedSurface<3>::find_twins(const Point<3> &x,
                                      const Accept   &accept,
                                      Projection<3>  &found) const
  {
    const SurfaceFacet<3> &own = surface.facets[found.facet];
    if (std::none_of(own.kind->sides.begin(),
                     own.kind->sides.end(),
                     [&](const auto &side) { return side.at(found.xi) == 1; }))
      return;
    const double   round_off = 1e-8 * surface.reference_length(found.facet);
    const Point<3> here      = position(found.facet, found.xi);
    std::set<unsigned int> around;
    for (unsigned int a = 0; a < own.kind->n_vertices; ++a)
      for (const unsigned int e : surface.facets_of_node[own.nodes[a]])
        if (e != found.facet)
          around.insert(e);
    for (const unsigned int e : around)
      {
        const Projection<3> other = project(x, e);
        if (position(e, other.xi).distance(here) <= round_off && accept(other))
          found.twins.emplace_back(e, other.xi);
      }
  }



  template<int dim>
  Projection<dim> DeformedSurface<dim>::project(const Point<dim>  &x,
                                                const unsigned int facet) const
  {
    const SurfaceFacet<dim> &of   = surface.facets[facet];
    const auto               ends = limits(facet);
    const auto [xi, whole] =
      project_on_facet(*of.kind, x, facet_positions(facet), ends);
    Projection<dim> found;
    found.facet   = facet;
    found.xi      = xi;
    found.clipped = xi != whole;
    for (unsigned int s = 0; s < of.n_sides(); ++s)
      if (of.ends_side[s] && of.kind->sides[s].at(whole) > ends[s])
        found.beyond_end = true;
    return found;
  }



  template<int dim>
  bool DeformedSurface<dim>::is_at_end(const Projection<dim> &projection) const
  {
    const auto &facet = surface.facets[projection.facet];
    for (unsigned int s = 0; s < facet.n_sides(); ++s)
      if (facet.ends_surface(s) && facet.kind->is_on_side(projection.xi, s))
        return true;
    return false;
  }



  template<int dim>
  bool DeformedSurface<dim>::is_behind(const Point<dim>      &x,
                                       const Projection<dim> &projection,
                                       const double           slack) const
  {
    const auto is_behind_one = [&](const unsigned int     facet,
                                   const FacetPoint<dim> &xi) {
      return (x - position(facet, xi)) * normal(facet, xi) < slack;
    };
    return is_behind_one(projection.facet, projection.xi) &&
           std::all_of(projection.twins.begin(),
                       projection.twins.end(),
                       [&](const auto &twin) {
                         return is_behind_one(twin.first, twin.second);
                       });
  }

  template class DeformedSurface<2>;
  template class DeformedSurface<3>;
} // namespace Contact
