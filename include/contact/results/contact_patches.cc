/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_patches.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  namespace
  {
    /// The zero of a function that is linear in s and has the values f1 and f2
    /// at s1 and s2, but not outside of the two bounds.
    double root(const double s1,
                const double f1,
                const double s2,
                const double f2,
                const double bound_1,
                const double bound_2)
    {
      const double zero = f1 == f2 ? s1 : s1 - f1 * (s2 - s1) / (f2 - f1);
      return std::clamp(zero,
                        std::min(bound_1, bound_2),
                        std::max(bound_1, bound_2));
    }



    /// p^2 falls to zero linearly.
    double end_of_contact(const PatchSample *before,
                          const PatchSample &last,
                          const PatchSample &next)
    {
      if (before == nullptr || !before->touches || before->p <= last.p)
        return (last.s + next.s) / 2;
      return root(last.s,
                  last.p * last.p,
                  before->s,
                  before->p * before->p,
                  last.s,
                  next.s);
    }



    /// |slip|^(2/3) grows from zero linearly.
    double end_of_stick(const PatchSample &last,
                        const PatchSample &next,
                        const PatchSample *beyond)
    {
      if (next.is_held)
        return next.s;
      if (beyond == nullptr || !beyond->touches || beyond->slip <= next.slip)
        return (last.s + next.s) / 2;
      return root(next.s,
                  std::pow(next.slip, 2. / 3),
                  beyond->s,
                  std::pow(beyond->slip, 2. / 3),
                  last.s,
                  next.s);
    }
  } // namespace



  ContactPatches::ContactPatches(const Surface<2>            &slave,
                                 const std::vector<Point<2>> &positions)
    : slave(slave)
  {
    s_of_node = slave.arc_length(positions);

    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      {
        const SurfaceFacet<2> &edge = slave.facets[e];
        const auto             s    = s_of_edge(e);
        if (e == 0 || edge.neighbors[0] != e - 1)
          {
            chains.emplace_back();
            chains.back().begin = s[0];
          }
        chains.back().end       = s[1];
        chains.back().is_closed = !edge.ends_surface(1);
        chain_of_edge.push_back(chains.size() - 1);
      }
  }



  double ContactPatches::arc_length(const unsigned int edge,
                                    const double       xi) const
  {
    const EdgeShape shape(slave.degree, xi);
    const auto      s_of_nodes = s_of_edge(edge);
    double          s          = 0;
    for (unsigned int a = 0; a < s_of_nodes.size(); ++a)
      s += shape.value[a] * s_of_nodes[a];
    return s;
  }



  void ContactPatches::add(const ContactPoint<2> &point, PatchSample sample)
  {
    sample.s = arc_length(point.slave_facet, point.slave_xi);
    chains[chain_of_edge[point.slave_facet]].samples.push_back(sample);
  }



  void ContactPatches::add_corner(const ContactPoint<2> &corner, const bool end)
  {
    Chain &chain = chains[chain_of_edge[corner.master_facet]];
    (end ? chain.ends : chain.corners)
      .push_back(
        arc_length(corner.master_facet,
                   std::clamp(static_cast<double>(corner.master_xi), -1., 1.)));
  }



  double ContactPatches::width() const
  {
    return length(&PatchSample::touches);
  }



  double ContactPatches::stick_width() const
  {
    return length(&PatchSample::sticks);
  }



  std::vector<double> ContactPatches::s_of_edge(const unsigned int e) const
  {
    const SurfaceFacet<2> &edge = slave.facets[e];
    std::vector<double>    s;
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      s.push_back(s_of_node[edge.nodes[a]]);
    if (s[1] < s[0])
      {
        const unsigned int last = slave.degree == 2 ? 2 : 0;
        s[1] = s[last] + slave.nodes[edge.nodes[last]].X.distance(
                           slave.nodes[edge.nodes[1]].X);
      }
    return s;
  }



  double ContactPatches::length(bool PatchSample::*inside) const
  {
    double sum = 0;
    for (const Chain &chain : chains)
      sum += length(chain, inside);
    return sum;
  }



  double ContactPatches::cut_at_corners(const Chain       &chain,
                                        double             end,
                                        const PatchSample *before,
                                        const PatchSample &last,
                                        const PatchSample &next)
  {
    const double period    = chain.end - chain.begin;
    const double round_off = 1e-10 * period;
    const double outwards  = next.s > last.s ? 1 : -1;
    const auto   cut       = [&](const double from, double at) {
      // Samples of a loop have the arc length of one of several periods.
      if (chain.is_closed)
        at += period * std::round((last.s - at) / period);
      if (outwards * (at - from) >= -round_off && outwards * (end - at) > 0)
        end = at;
    };
    for (const double at : chain.corners)
      cut(last.s, at);
    for (const double at : chain.ends)
      cut(before ? before->s : last.s, at);
    return end;
  }



  double ContactPatches::length(const Chain &chain, bool PatchSample::*inside)
  {
    std::vector<PatchSample> row = chain.samples;
    std::sort(row.begin(), row.end(), [](const auto &a, const auto &b) {
      return a.s < b.s;
    });

    // Of a loop four periods, so that each sample of the two in the middle has
    // neighbors.
    std::vector<PatchSample> samples;
    const int                n         = row.size();
    const int                n_periods = chain.is_closed ? 4 : 1;
    for (int period = 0; period < n_periods; ++period)
      for (PatchSample sample : row)
        {
          sample.s += period * (chain.end - chain.begin);
          samples.push_back(sample);
        }
    const auto at = [&](const int i) {
      return 0 <= i && i < n_periods * n ? &samples[i] : nullptr;
    };
    const auto end_at = [&](const int i, const int outwards) {
      const PatchSample *next = at(i + outwards);
      if (next == nullptr)
        return outwards > 0 ? chain.end : chain.begin;
      if (next->touches && inside == &PatchSample::sticks)
        return end_of_stick(samples[i], *next, at(i + 2 * outwards));
      const PatchSample *before = at(i - outwards);
      return cut_at_corners(chain,
                            end_of_contact(before, samples[i], *next),
                            before,
                            samples[i],
                            *next);
    };

    // A period begins where a patch does not go on.
    int begin = 0;
    if (chain.is_closed && n > 0)
      {
        begin = n;
        while (begin < 2 * n && samples[begin].*inside)
          ++begin;
        if (begin == 2 * n)
          return chain.end - chain.begin;
      }
    const double round_off = 1e-10 * (chain.end - chain.begin);
    double       sum       = 0;
    for (int i = begin; i < begin + n; ++i)
      {
        if (!(samples[i].*inside))
          continue;
        const int first = i;
        while (i + 1 < begin + n && samples[i + 1].*inside)
          ++i;
        double from = end_at(first, -1), to = end_at(i, +1);
        // Of a single node beyond the end of the master what presses is the
        // part that the master covers of the edge between.
        if (inside == &PatchSample::touches && to < from - round_off)
          {
            if (first < i)
              to = from;
            else if (to < samples[i].s)
              from = samples[i - 1].s;
            else
              to = samples[i + 1].s;
          }
        sum += to - from;
      }
    return sum;
  }
} // namespace Contact
