/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mortar_segments.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  namespace
  {
    const unsigned int none = numbers::invalid_unsigned_int;

    /// Of coordinates, which are of the order of one.
    const double round_off = 1e-11;

    double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /// Newton's method for a root of a smooth function near @p xi; edges are
    /// short against their curvature, so that few steps suffice.
    template<typename Function>
    double find_root(double xi, const Function &value_and_slope)
    {
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          const auto [value, slope] = value_and_slope(xi);
          if (slope == 0)
            break;
          const double step = -value / slope;
          xi                = std::max(-3., std::min(3., xi + step));
          if (std::abs(step) < 1e-14)
            break;
        }
      return xi;
    }
  } // namespace



  Tensor<1, 2> free_part(const Tensor<1, 2>   &direction,
                         const Surface::Node  &node,
                         const Discretization &discretization)
  {
    Tensor<1, 2> free = direction;
    for (unsigned int c = 0; c < 2; ++c)
      if (discretization.is_fixed(node.dofs[c]))
        free[c] = 0;
    return free;
  }



  double MortarOverlap::distance(const double xi) const
  {
    double nearest = std::numeric_limits<double>::max();
    for (const Part &part : parts)
      nearest =
        std::min(nearest, std::max({0., part.low - xi, xi - part.high}));
    return nearest;
  }



  MortarSegments::MortarSegments(const Surface        &slave,
                                 const Surface        &master,
                                 const Discretization &discretization,
                                 const Vector<double> &u)
    : slave_normals(slave.edge_normals(u))
    , master_normals(master.edge_normals(u))
    , slave(slave)
    , master(master)
    , search(master, u)
  {
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      slave_x.push_back(slave.position(i, u));
    for (unsigned int i = 0; i < master.nodes.size(); ++i)
      master_x.push_back(master.position(i, u));

    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const auto   &node   = slave.nodes[slave.edges[e].nodes[a]];
          Tensor<1, 2> &normal = slave_normals[e][a];
          normal *= -1;
          // Against a support the node carries no multiplier, and its own
          // normal serves for the projection.
          const auto free = free_part(normal, node, discretization);
          if (free.norm_square() > 0.5)
            normal = free / free.norm();
        }

    Tensor<1, 2> low = slave_x[0], high = low;
    for (const auto *all : {&slave_x, &master_x})
      for (const Tensor<1, 2> &x : *all)
        for (unsigned int i = 0; i < 2; ++i)
          {
            low[i]  = std::min(low[i], x[i]);
            high[i] = std::max(high[i], x[i]);
          }
    size = (high - low).norm();
  }



  Tensor<1, 2> MortarSegments::at(const std::vector<Tensor<1, 2>> &values,
                                  const Surface::Edge             &edge,
                                  const std::array<double, 3>     &shape)
  {
    // A shape function that an edge of degree 1 does not have is zero, and so
    // is the number of its node.
    Tensor<1, 2> sum;
    for (unsigned int a = 0; a < 3; ++a)
      sum += shape[a] * values[edge.nodes[a]];
    return sum;
  }



  double MortarSegments::foot_on_edge(const Tensor<1, 2> &x,
                                      const Tensor<1, 2> &n,
                                      const unsigned int  master_edge) const
  {
    const auto &edge = master.edges[master_edge];
    return find_root(0, [&](const double xi) {
      const EdgeShape shape(master.degree, xi);
      return std::make_pair(cross(at(master_x, edge, shape.value) - x, n),
                            cross(at(master_x, edge, shape.first), n));
    });
  }



  Tensor<1, 2>
  MortarSegments::slave_normal(const unsigned int           slave_edge,
                               const std::array<double, 3> &shape) const
  {
    Tensor<1, 2> sum;
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      sum += shape[a] * slave_normals[slave_edge][a];
    return sum;
  }



  double MortarSegments::slave_coordinate(const unsigned int  slave_edge,
                                          const Tensor<1, 2> &x) const
  {
    const auto &edge = slave.edges[slave_edge];
    return find_root(0, [&](const double xi) {
      const EdgeShape    shape(slave.degree, xi);
      const Tensor<1, 2> r = at(slave_x, edge, shape.value) - x;
      return std::make_pair(cross(r, slave_normal(slave_edge, shape.value)),
                            cross(at(slave_x, edge, shape.first),
                                  slave_normal(slave_edge, shape.value)) +
                              cross(r, slave_normal(slave_edge, shape.first)));
    });
  }



  // What is near is looked at first; further and further away, until all of
  // the edge has a partner that nothing can hide.
  MortarOverlap MortarSegments::overlap(const unsigned int slave_edge) const
  {
    const auto &ends  = slave.edges[slave_edge].nodes;
    double      reach = 2 * (slave_x[ends[1]] - slave_x[ends[0]]).norm();
    std::vector<Segment> found;
    while (true)
      {
        found          = segments(slave_edge, candidates(slave_edge, reach));
        double covered = 0, distance = 0;
        for (const Segment &segment : found)
          {
            covered += segment.high - segment.low;
            distance = std::max(distance, segment.distance);
          }
        if (reach >= size || (covered > 2 - round_off && distance < reach / 2))
          break;
        reach *= 4;
      }

    MortarOverlap overlap;
    for (const Segment &segment : found)
      add_samples(slave_edge, segment, overlap);
    return overlap;
  }



  std::vector<unsigned int>
  MortarSegments::candidates(const unsigned int slave_edge,
                             const double       reach) const
  {
    const auto           &nodes = slave.edges[slave_edge].nodes;
    std::vector<Point<2>> corners;
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      for (const double side : {-1., 1.})
        corners.emplace_back(slave_x[nodes[a]] +
                             side * reach * slave_normals[slave_edge][a]);

    // Of the edges near by those between the lines: not all on one side of all
    // of them.
    std::vector<unsigned int> candidates;
    for (const unsigned int m : search.edges_in(BoundingBox<2>(corners)))
      {
        bool left = false, right = false;
        for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
          for (const Tensor<1, 2> &x : search.hull(m))
            {
              const double side =
                cross(x - slave_x[nodes[a]], slave_normals[slave_edge][a]);
              left  = left || side >= 0;
              right = right || side <= 0;
            }
        if (left && right)
          candidates.push_back(m);
      }
    return candidates;
  }



  // Lines from the nodes of the master cut the edge into intervals that face
  // one edge each, or none.
  std::vector<MortarSegments::Segment>
  MortarSegments::segments(const unsigned int               slave_edge,
                           const std::vector<unsigned int> &candidates) const
  {
    std::vector<double> cuts{-1, 1};
    for (const unsigned int m : candidates)
      for (unsigned int a = 0; a < 2; ++a)
        cuts.push_back(std::max(
          -1.,
          std::min(1.,
                   slave_coordinate(slave_edge,
                                    master_x[master.edges[m].nodes[a]]))));
    std::sort(cuts.begin(), cuts.end());

    std::vector<Segment> segments;
    for (unsigned int i = 1; i < cuts.size(); ++i)
      {
        // Shorter segments are round-off at nodes that face each other.
        if (cuts[i] - cuts[i - 1] < round_off)
          continue;
        const auto [m, distance] =
          partner(slave_edge, (cuts[i - 1] + cuts[i]) / 2, candidates);
        if (m == none)
          continue;
        if (!segments.empty() && segments.back().master_edge == m &&
            cuts[i - 1] - segments.back().high < round_off)
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
  MortarSegments::partner(const unsigned int               slave_edge,
                          const double                     xi,
                          const std::vector<unsigned int> &candidates) const
  {
    struct Hit
    {
      unsigned int master_edge = none;
      double       distance    = std::numeric_limits<double>::max();
      bool         faces       = false;
    };
    Hit ahead, behind;

    const EdgeShape shape(slave.degree, xi);
    const auto      x = at(slave_x, slave.edges[slave_edge], shape.value);
    auto            n = slave_normal(slave_edge, shape.value);
    n /= n.norm();
    const NormalCone direction{-n, -n};
    for (const unsigned int m : candidates)
      {
        const double master_xi = foot_on_edge(x, n, m);
        if (std::abs(master_xi) > 1)
          continue;
        const EdgeShape foot(master.degree, master_xi);
        const auto      r = x - at(master_x, master.edges[m], foot.value);
        // A line beside a parallel edge has no foot there.
        if (std::abs(cross(r, n)) > 1e-8 * size)
          continue;
        Hit &hit = r * n >= 0 ? ahead : behind;
        if (std::abs(r * n) < hit.distance)
          hit = {m,
                 std::abs(r * n),
                 direction.faces(search.normal(m, master_xi))};
      }
    if (!behind.faces || (ahead.faces && ahead.distance <= behind.distance))
      std::swap(ahead, behind);
    return behind.faces ? std::make_pair(behind.master_edge, behind.distance)
                        : std::make_pair(none, 0.);
  }



  void MortarSegments::add_samples(const unsigned int slave_edge,
                                   const Segment     &segment,
                                   MortarOverlap     &overlap) const
  {
    const auto  &s_edge = slave.edges[slave_edge];
    const double length = segment.high - segment.low;
    const auto   add    = [&](const double part, const double weight) {
      const double    xi = segment.low + part * length;
      const EdgeShape shape(slave.degree, xi);
      overlap.samples.push_back(
        {xi,
         weight * length * slave.reference_jacobian(s_edge, shape),
         segment.master_edge,
         foot_on_edge(at(slave_x, s_edge, shape.value),
                      slave_normal(slave_edge, shape.value),
                      segment.master_edge)});
    };
    const QGauss<1> quadrature(slave.degree + 2);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      add(quadrature.point(q)[0], quadrature.weight(q));
    // The ends count for the distances only.
    for (const double end : {0., 1.})
      add(end, 0);

    if (!overlap.parts.empty() &&
        segment.low - overlap.parts.back().high < round_off)
      overlap.parts.back().high = segment.high;
    else
      overlap.parts.push_back({segment.low, segment.high});
  }
} // namespace Contact
