/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/mortar_segments.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  double MortarOverlap::distance(const double xi) const
  {
    double nearest = std::numeric_limits<double>::max();
    for (const Part &part : parts)
      nearest =
        std::min(nearest, std::max({0., part.low - xi, xi - part.high}));
    return nearest;
  }



  MortarSegments::MortarSegments(const MortarGeometry<double> &geometry,
                                 const GhostedVector          &u,
                                 const BodyOverlap<2>         &bodies)
    : now(geometry)
    , bodies(bodies)
    , search(geometry.master, u)
  {
    Tensor<1, 2> low = now.slave_x[0], high = low;
    for (const auto *all : {&now.slave_x, &now.master_x})
      for (const Tensor<1, 2> &x : *all)
        for (unsigned int i = 0; i < 2; ++i)
          {
            low[i]  = std::min(low[i], x[i]);
            high[i] = std::max(high[i], x[i]);
          }
    size = (high - low).norm();
  }



  // The search begins near the edge and goes further and further away, until
  // all of the edge has a partner that nothing can hide.
  MortarOverlap MortarSegments::overlap(const unsigned int slave_facet) const
  {
    const auto &ends = now.slave.facets[slave_facet].nodes;
    double reach     = 2 * (now.slave_x[ends[1]] - now.slave_x[ends[0]]).norm();
    std::vector<Segment> found;
    while (true)
      {
        found          = segments(slave_facet, candidates(slave_facet, reach));
        double covered = 0, distance = 0;
        for (const Segment &segment : found)
          {
            covered += segment.high.xi - segment.low.xi;
            distance = std::max(distance, segment.distance);
          }
        if (reach >= size ||
            (covered > 2 - mortar_round_off && distance < reach / 2))
          break;
        reach *= 4;
      }

    MortarOverlap overlap;
    overlap.segments = found = nearest_run(slave_facet, found);
    for (const Segment &segment : found)
      if (!overlap.parts.empty() &&
          segment.low.xi - overlap.parts.back().high < mortar_round_off)
        overlap.parts.back().high = segment.high.xi;
      else
        overlap.parts.push_back({segment.low.xi, segment.high.xi});
    return overlap;
  }



  // Runs are segments that follow each other on edges of the master that do.
  // The distance of one to what the edge sees beside it is a jump.
  std::vector<MortarSegments::Segment>
  MortarSegments::nearest_run(const unsigned int          slave_facet,
                              const std::vector<Segment> &segments) const
  {
    std::vector<unsigned int> run_of;
    std::vector<double>       distances; // of the runs
    for (unsigned int i = 0; i < segments.size(); ++i)
      {
        const auto &neighbors =
          now.master.facets[segments[i].master_facet].neighbors;
        const bool goes_on =
          i > 0 && std::count(neighbors.begin(),
                              neighbors.end(),
                              segments[i - 1].master_facet) > 0;
        if (!goes_on)
          distances.push_back(segments[i].distance);
        run_of.push_back(distances.size() - 1);
        distances.back() = std::min(distances.back(), segments[i].distance);
      }
    if (distances.size() < 2)
      return segments;
    const double largest =
      *std::min_element(distances.begin(), distances.end()) +
      DeformedSurface<2>::overhang * now.slave.reference_length(slave_facet);
    std::vector<Segment> near;
    for (unsigned int i = 0; i < segments.size(); ++i)
      if (distances[run_of[i]] <= largest)
        near.push_back(segments[i]);
    return near;
  }



  std::vector<unsigned int>
  MortarSegments::candidates(const unsigned int slave_facet,
                             const double       reach) const
  {
    const auto           &nodes = now.slave.facets[slave_facet].nodes;
    std::vector<Point<2>> corners;
    for (unsigned int a = 0; a < now.slave.n_nodes_per_edge(); ++a)
      for (const double side : {-1., 1.})
        corners.emplace_back(now.slave_x[nodes[a]] +
                             side * reach * now.slave_normals[slave_facet][a]);

    // Of the edges near by those between the lines: not all on one side of all
    // of them.
    std::vector<unsigned int> candidates;
    for (const unsigned int m : search.facets_in(BoundingBox<2>(corners)))
      {
        bool left = false, right = false;
        for (unsigned int a = 0; a < now.slave.n_nodes_per_edge(); ++a)
          for (const Tensor<1, 2> &x : search.hull(m))
            {
              const double side = cross(x - now.slave_x[nodes[a]],
                                        now.slave_normals[slave_facet][a]);
              left              = left || side >= 0;
              right             = right || side <= 0;
            }
        if (left && right && bodies.may_face(slave_facet, m))
          candidates.push_back(m);
      }
    return candidates;
  }



  // Lines from the nodes of the master cut the edge into intervals that face
  // one edge each, or none.
  std::vector<MortarSegments::Segment>
  MortarSegments::segments(const unsigned int               slave_facet,
                           const std::vector<unsigned int> &candidates) const
  {
    std::vector<Cut> cuts{{-1}, {1}};
    for (const unsigned int m : candidates)
      for (unsigned int a = 0; a < 2; ++a)
        {
          const unsigned int node = now.master.facets[m].nodes[a];
          const double       xi =
            now.slave_coordinate(slave_facet, now.master_x[node]);
          if (std::abs(xi) < 1)
            cuts.push_back({xi, node});
        }
    std::sort(cuts.begin(), cuts.end(), [](const Cut &a, const Cut &b) {
      return a.xi < b.xi;
    });

    std::vector<Segment> segments;
    for (unsigned int i = 1; i < cuts.size(); ++i)
      {
        // Shorter segments are round-off at nodes that face each other.
        if (cuts[i].xi - cuts[i - 1].xi < mortar_round_off)
          continue;
        const auto [m, distance] =
          partner(slave_facet, (cuts[i - 1].xi + cuts[i].xi) / 2, candidates);
        if (m == numbers::invalid_unsigned_int)
          continue;
        if (!segments.empty() && segments.back().master_facet == m &&
            cuts[i - 1].xi - segments.back().high.xi < mortar_round_off)
          {
            segments.back().high = cuts[i];
            segments.back().distance =
              std::max(segments.back().distance, distance);
          }
        else
          segments.push_back({cuts[i - 1], cuts[i], m, distance});
      }
    return segments;
  }



  std::pair<unsigned int, double>
  MortarSegments::partner(const unsigned int               slave_facet,
                          const double                     xi,
                          const std::vector<unsigned int> &candidates) const
  {
    struct Hit
    {
      unsigned int master_facet = numbers::invalid_unsigned_int;
      double       distance     = std::numeric_limits<double>::max();
      bool         faces        = false;
    };
    Hit ahead, behind;

    const EdgeShape shape(now.slave.degree, xi);
    const auto      x = MortarGeometry<double>::at(now.slave_x,
                                              now.slave.facets[slave_facet],
                                              shape.value);
    auto            n = now.slave_normal(slave_facet, shape.value);
    n /= n.norm();
    const NormalCone<2> direction{{-n}};
    const double        slack =
      DeformedSurface<2>::overhang * now.slave.reference_length(slave_facet);
    for (const unsigned int m : candidates)
      {
        const double master_xi = now.projection_on_edge(x, n, m);
        if (std::abs(master_xi) > 1)
          continue;
        const EdgeShape projection(now.master.degree, master_xi);
        const auto      r = x - MortarGeometry<double>::at(now.master_x,
                                                      now.master.facets[m],
                                                      projection.value);
        // A line beside a parallel edge has no projection there.
        if (std::abs(cross(r, n)) > 1e-8 * size)
          continue;
        Hit &hit = r * n >= 0 ? ahead : behind;
        if (std::abs(r * n) < hit.distance &&
            (-(r * n) <= slack ||
             bodies.is_between({Point<2>(x), now.slave, slave_facet, xi},
                               0,
                               {Point<2>(x - r), now.master, m, master_xi})))
          hit = {m,
                 std::abs(r * n),
                 direction.faces(search.normal(m, master_xi))};
      }
    if (!behind.faces || (ahead.faces && ahead.distance <= behind.distance))
      std::swap(ahead, behind);
    return behind.faces ? std::make_pair(behind.master_facet, behind.distance)
                        : std::make_pair(numbers::invalid_unsigned_int, 0.);
  }



  template<typename Number>
  std::vector<MortarSample<Number>>
  mortar_samples(const MortarGeometry<Number> &geometry,
                 const unsigned int            slave_facet,
                 const MortarOverlap          &overlap)
  {
    const Surface<2>      &slave  = geometry.slave;
    const SurfaceFacet<2> &s_edge = slave.facets[slave_facet];
    const QGauss<1>        quadrature(slave.degree + 2);
    const auto             coordinate = [&](const MortarOverlap::Cut &cut) {
      return cut.master_node == numbers::invalid_unsigned_int
                           ? Number(cut.xi)
                           : geometry.slave_coordinate(slave_facet,
                                           geometry.master_x[cut.master_node]);
    };

    std::vector<MortarSample<Number>> samples;
    for (const auto &segment : overlap.segments)
      {
        const Number low    = coordinate(segment.low);
        const Number length = coordinate(segment.high) - low;
        const auto   add    = [&](const double part, const double weight) {
          const Number             xi = low + part * length;
          const EdgeShapes<Number> shape(slave.degree, xi);
          const Number             master_xi = geometry.projection_on_edge(
            MortarGeometry<Number>::at(geometry.slave_x, s_edge, shape.value),
            geometry.slave_normal(slave_facet, shape.value),
            segment.master_facet);
          samples.push_back(
            {xi,
             weight * length * slave.reference_jacobian(s_edge, shape),
             segment.master_facet,
             master_xi});
        };
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          add(quadrature.point(q)[0], quadrature.weight(q));
        // The ends count for the distances only.
        for (const double end : {0., 1.})
          add(end, 0);
      }
    return samples;
  }



  template std::vector<MortarSample<double>>
  mortar_samples(const MortarGeometry<double> &,
                 const unsigned int,
                 const MortarOverlap &);
  template std::vector<MortarSample<WithDerivatives>>
  mortar_samples(const MortarGeometry<WithDerivatives> &,
                 const unsigned int,
                 const MortarOverlap &);
} // namespace Contact
