/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mortar_segments.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

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



  MortarSegments::MortarSegments(const Surface        &slave,
                                 const Surface        &master,
                                 const Discretization &discretization,
                                 const Vector<double> &u)
    : normals(slave.normals(u))
    , slave(slave)
    , master(master)
    , search(master, u)
  {
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      slave_x.push_back(slave.position(i, u));
    for (unsigned int i = 0; i < master.nodes.size(); ++i)
      master_x.push_back(master.position(i, u));

    for (unsigned int i = 0; i < normals.size(); ++i)
      {
        Tensor<1, 2> free = -normals[i];
        for (unsigned int c = 0; c < 2; ++c)
          if (discretization.is_fixed(slave.nodes[i].dofs[c]))
            free[c] = 0;
        // Against a support the node carries no multiplier, and its own normal
        // serves for the projection.
        normals[i] =
          free.norm_square() > 0.5 ? free / free.norm() : -normals[i];
      }
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



  double MortarSegments::slave_coordinate(const unsigned int  slave_edge,
                                          const Tensor<1, 2> &x) const
  {
    const auto &edge = slave.edges[slave_edge];
    return find_root(0, [&](const double xi) {
      const EdgeShape    shape(slave.degree, xi);
      const Tensor<1, 2> r = at(slave_x, edge, shape.value) - x;
      const Tensor<1, 2> n = at(normals, edge, shape.value);
      return std::make_pair(cross(r, n),
                            cross(at(slave_x, edge, shape.first), n) +
                              cross(r, at(normals, edge, shape.first)));
    });
  }



  // The normals at both ends of the slave edge meet the chain of the master in
  // two edges; those from one to the other may be faced, and each cuts a
  // segment out of the slave edge. The chains run in opposite directions.
  MortarOverlap MortarSegments::overlap(const unsigned int slave_edge) const
  {
    const auto        &nodes = slave.edges[slave_edge].nodes;
    const unsigned int last  = facing_edge(nodes[0]);
    unsigned int       faced = facing_edge(nodes[1]);

    MortarOverlap overlap;
    for (unsigned int n = 0; n < master.edges.size() && faced != none; ++n)
      {
        add_segment(slave_edge, faced, overlap);
        if (faced == last)
          break;
        faced = master.edges[faced].next;
      }
    return overlap;
  }



  // From the closest edge along the chain to the one that the normal meets, or
  // to the end of the chain.
  unsigned int MortarSegments::facing_edge(const unsigned int slave_node) const
  {
    const Tensor<1, 2> &x         = slave_x[slave_node];
    const Tensor<1, 2> &n         = normals[slave_node];
    unsigned int        candidate = search.closest_point(Point<2>(x)).edge;
    int                 last_step = 0;
    while (true)
      {
        const double xi       = foot_on_edge(x, n, candidate);
        const int    step     = xi > 1 ? 1 : (xi < -1 ? -1 : 0);
        const auto   neighbor = step == 0  ? none
                                : step > 0 ? master.edges[candidate].next
                                           : master.edges[candidate].previous;
        if (neighbor == none || step == -last_step)
          return candidate;
        candidate = neighbor;
        last_step = step;
      }
  }



  void MortarSegments::add_segment(const unsigned int slave_edge,
                                   const unsigned int master_edge,
                                   MortarOverlap     &overlap) const
  {
    const auto  &s_edge = slave.edges[slave_edge];
    const auto  &m_edge = master.edges[master_edge];
    const double low =
      std::max(-1., slave_coordinate(slave_edge, master_x[m_edge.nodes[1]]));
    const double high =
      std::min(1., slave_coordinate(slave_edge, master_x[m_edge.nodes[0]]));
    // Shorter segments are round-off at nodes that face each other.
    if (high - low < round_off)
      return;

    const QGauss<1>           quadrature(slave.degree + 2);
    std::vector<MortarSample> samples;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double    xi = low + quadrature.point(q)[0] * (high - low);
        const EdgeShape shape(slave.degree, xi);
        const auto      x = at(slave_x, s_edge, shape.value);
        const auto      n = at(normals, s_edge, shape.value);

        const double    master_xi = foot_on_edge(x, n, master_edge);
        const EdgeShape foot(master.degree, master_xi);
        const auto      along = at(master_x, m_edge, foot.first);
        // Back to back is not face to face.
        if (cross(n, along) <= 0)
          return;

        samples.push_back({xi,
                           quadrature.weight(q) * (high - low) *
                             slave.reference_jacobian(s_edge, shape),
                           master_edge,
                           master_xi});
      }
    overlap.samples.insert(overlap.samples.end(),
                           samples.begin(),
                           samples.end());
    overlap.low  = std::min(overlap.low, low);
    overlap.high = std::max(overlap.high, high);
  }
} // namespace Contact
