/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of MortarDiscretization<3> that tells which points keep their last
// pairing.

#include <algorithm>

#include "contact/mortar/face_mortar.h"

namespace Contact
{
  std::vector<double>
  MortarDiscretization<3>::motion(const GhostedVector &u) const
  {
    std::vector<double> values;
    if (u.size() == 0)
      return values;
    for (const Surface<3> *surface : {&slave, &master})
      for (const SurfaceNode<3> &node : surface->nodes)
        for (const auto dof : node.dofs)
          values.push_back(u[dof]);
    return values;
  }



  std::vector<unsigned int> MortarDiscretization<3>::keep_pairings(
    const ArrayView<ContactPoint<3>> &points,
    const GhostedVector              &u,
    const PairingMode                &mode) const
  {
    const bool          is_known = last.pairings.size() == points.size();
    std::vector<double> now      = motion(u);
    if (!is_known || now != last.motion)
      last.is_present.assign(points.size(), false);
    last.motion = std::move(now);
    last.weights.resize(points.size());
    last.pairings.resize(points.size());

    std::vector<bool> touches;
    if (is_known && mode.keeps_open_points)
      touches = may_touch(u, 0);
    const auto stays_open = [&](const unsigned int q) {
      const PointPairing<3> &pairing = last.pairings[q];
      if (touches.empty() || touches[slave_node(points[q])] ||
          !points[q].motions.empty())
        return false;
      Tensor<1, 3> r = -pairing.projection;
      for (unsigned int a = 0; a < pairing.n_nodes; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          r[i] += pairing.C[a] * (pairing.X(a)[i] + u[pairing.dofs(a)[i]]);
      return !pairing.facing || pairing.normal * r > 0;
    };

    std::vector<unsigned int> others;
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        if (mode.is_rest && last.is_present[q])
          continue;
        points[q].change   = PairingChange<3>();
        const bool is_open = points[q].status.kind == Status::open;
        const bool has_all = !mode.with_derivatives || is_open;
        if ((last.is_present[q] && has_all) || (is_open && stays_open(q)))
          {
            const auto motions                        = points[q].motions;
            points[q].weight                          = last.weights[q];
            static_cast<PointPairing<3> &>(points[q]) = last.pairings[q];
            points[q].motions                         = motions;
          }
        else
          others.push_back(q);
      }
    return !is_known && mode.leaves_far_points
             ? leave_far_points(points, others, u)
             : others;
  }



  std::vector<unsigned int> MortarDiscretization<3>::leave_far_points(
    const ArrayView<ContactPoint<3>> &points,
    const std::vector<unsigned int>  &numbers,
    const GhostedVector              &u) const
  {
    double size = 0;
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      size = std::max(size, slave.reference_length(e));
    const std::vector<bool>   is_close = may_touch(u, size);
    const FaceConfiguration   now(slave, master, planes, u);
    std::vector<unsigned int> close;
    for (const unsigned int q : numbers)
      if (is_close[slave_node(points[q])] || !points[q].motions.empty())
        close.push_back(q);
      else
        {
          fill_in(NodeIntegrals(), slave_node(points[q]), now, u, points[q]);
          last.weights[q]  = points[q].weight;
          last.pairings[q] = points[q];
        }
    return close;
  }



  std::vector<bool>
  MortarDiscretization<3>::may_touch(const GhostedVector &u,
                                     const double         distance) const
  {
    const DeformedSurface<3> of_slave(slave, u), of_master(master, u);
    const auto        facets = of_master.may_be_close(of_slave, distance);
    std::vector<bool> nodes(slave.nodes.size(), false);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      if (facets[e])
        for (const unsigned int node : face_integrals.carriers_of(e))
          nodes[node] = true;
    return nodes;
  }
} // namespace Contact
