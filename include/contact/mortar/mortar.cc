/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/mortar.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "contact/surfaces/surface_checks.h"

namespace Contact
{
  namespace
  {
    /// The node that a point belongs to, by its number in the slave edge.
    unsigned int node_in_edge(const ContactPoint<2> &point)
    {
      return std::find(node_coordinates.begin(),
                       node_coordinates.end(),
                       point.slave_xi) -
             node_coordinates.begin();
    }
  } // namespace



  MortarDiscretization<2>::MortarDiscretization(
    const Surface<2>             &slave,
    const Surface<2>             &master,
    const DiscretizedBodies<2>   &discretization,
    const std::set<unsigned int> &excluded)
    : slave(slave)
    , master(master)
    , discretization(discretization)
    , is_with_itself(overlap(slave, master))
    , carries(slave.facets.size())
  {
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        carries[e][a] = excluded.count(slave.facets[e].nodes[a]) == 0;
  }



  std::vector<ContactPoint<2>>
  MortarDiscretization<2>::make_points(MultiplierSpace &multipliers) const
  {
    multipliers.of_node.assign(slave.nodes.size(),
                               numbers::invalid_unsigned_int);
    multipliers.n_multipliers = 0;

    std::vector<ContactPoint<2>> points;
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const unsigned int node = slave.facets[e].nodes[a];
          if (!carries[e][a] ||
              multipliers.of_node[node] != numbers::invalid_unsigned_int)
            continue;
          multipliers.of_node[node] = multipliers.n_multipliers++;

          ContactPoint<2> point;
          point.slave_facet    = e;
          point.slave_xi       = node_coordinates[a];
          point.master_facet   = 0;
          point.weight         = 0;
          point.n_multipliers  = 1;
          point.multipliers[0] = multipliers.of_node[node];
          point.psi[0]         = 1;
          point.add_node(slave.nodes[node], 1);
          point.n_slave_nodes = 1;
          points.push_back(point);
        }
    return points;
  }



  bool MortarDiscretization<2>::pair(const ArrayView<ContactPoint<2>> &points,
                                     const GhostedVector              &u,
                                     const PairingMode                &mode,
                                     const BodyOverlap<2> &bodies) const
  {
    const MortarGeometry<double> now(slave, master, discretization, u);
    const MortarSegments         segments(now, u, bodies);
    std::vector<MortarOverlap>   overlaps;
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      overlaps.push_back(segments.overlap(e));
    MortarIntegrals<double> integrals(now, carries);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      if (!overlaps[e].segments.empty())
        integrals.add_edge(e, overlaps[e]);

    std::optional<MortarGeometry<WithDerivatives>> moving;
    if (mode.with_derivatives)
      moving.emplace(slave, master, discretization, u);
    bool changed = false;
    for (ContactPoint<2> &point : points)
      {
        const auto old_nodes   = point.nodes;
        const auto old_changes = point.change.dofs;
        fill_in(now, integrals.pairing(slave_node(point)), u, point);
        point.change = PairingChange<2>();
        if (moving && point.facing)
          differentiate(*moving, overlaps, point);
        changed = changed || point.nodes != old_nodes ||
                  point.change.dofs != old_changes;
      }
    return changed;
  }



  unsigned int
  MortarDiscretization<2>::slave_node(const ContactPoint<2> &point) const
  {
    return slave.facets[point.slave_facet].nodes[node_in_edge(point)];
  }



  void MortarDiscretization<2>::fill_in(const MortarGeometry<double> &now,
                                        const MortarPairing<double>  &pairing,
                                        const GhostedVector          &u,
                                        ContactPoint<2> &point) const
  {
    const unsigned int node = slave_node(point);
    point.facing            = pairing.facing;
    point.weight            = pairing.weight;
    point.normal =
      point.facing ? pairing.normal
                   : now.slave_normals[point.slave_facet][node_in_edge(point)];
    point.tangents[0] = Tensor<1, 2>({-point.normal[1], point.normal[0]});
    point.metric      = 1;
    point.keep_nodes(0);
    if (point.facing)
      {
        add_nodes(pairing, point);
        skip_where_held(point, discretization, u);
      }
    if (!point.facing)
      {
        // Only to keep the equation of its multiplier, which is zero. In the
        // middle of the edge, which is never on an axis.
        point.keep_nodes(0);
        point.weight = slave.reference_jacobian(slave.facets[point.slave_facet],
                                                EdgeShape(slave.degree, 0));
        point.add_node(slave.nodes[node], 1);
        point.n_slave_nodes = 1;
        return;
      }

    point.master_facet = pairing.master_facet;
    point.projection   = Point<2>(pairing.excess * point.normal);

    point.has_no_free_tangent = has_no_free_tangent(point, discretization) ||
                                is_on_symmetry_line(point, u);
  }



  // There supports hold the slave node and the master node opposite. Slip is an
  // odd function of the distance from the line, its integral over the dual
  // function and the mirror image of that zero, although the row on this side
  // of the line has other nodes.
  bool
  MortarDiscretization<2>::is_on_symmetry_line(const ContactPoint<2> &point,
                                               const GhostedVector   &u) const
  {
    const auto along_tangent = [&](const unsigned int a) {
      double s = 0;
      for (unsigned int i = 0; i < 2; ++i)
        s += point.tangents[0][i] * (point.X(a)[i] + u[point.dofs(a)[i]]);
      return s;
    };
    const auto move_alike = [&](const unsigned int a) {
      for (const Tensor<1, 2> &across :
           discretization.held_normals(point.dofs(0)))
        if (discretization.free_part(point.dofs(a), across).norm() < 1e-8 &&
            !discretization.are_held_alike(point.dofs(0),
                                           point.dofs(a),
                                           across))
          return false;
      for (unsigned int i = 0; i < 2; ++i)
        if (discretization.is_fixed(point.dofs(0)[i]) &&
            discretization.is_fixed(point.dofs(a)[i]) &&
            !discretization.are_fixed_alike(point.dofs(0)[i], point.dofs(a)[i]))
          return false;
      return true;
    };
    const double tolerance = 1e-6 * slave.reference_length(point.slave_facet);
    for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
      if (std::abs(along_tangent(a) - along_tangent(0)) < tolerance &&
          move_alike(a))
        {
          ContactPoint<2> pair = point;
          pair.keep_nodes(1);
          pair.add_node(*point.nodes[a], -1);
          pair.C[0] = 1;
          if (has_no_free_tangent(pair, discretization))
            return true;
        }
    return false;
  }



  unsigned int
  MortarDiscretization<2>::place_of(const SurfaceNode<2>  &node,
                                    const ContactPoint<2> &point) const
  {
    return std::find_if(point.nodes.begin(),
                        point.nodes.end(),
                        [&](const SurfaceNode<2> *other) {
                          return is_with_itself ? other->dofs == node.dofs
                                                : other == &node;
                        }) -
           point.nodes.begin();
  }



  void MortarDiscretization<2>::add_nodes(const MortarPairing<double> &pairing,
                                          ContactPoint<2> &point) const
  {
    const unsigned int node = slave_node(point);
    point.add_node(slave.nodes[node], pairing.slave.at(node));
    for (const auto &[a, c] : pairing.slave)
      if (a != node)
        point.add_node(slave.nodes[a], c);
    point.n_slave_nodes = point.n_nodes;
    for (const auto &[m, c] : pairing.master)
      if (const unsigned int a = place_of(master.nodes[m], point);
          a < point.n_slave_nodes)
        point.C[a] += c;
      else
        point.add_node(master.nodes[m], c);
  }



  // The pairing depends on the nodes of the edges around the slave node, of the
  // master edges that these face, and of the neighbours of both, by their
  // normals.
  std::array<std::set<unsigned int>, 2> MortarDiscretization<2>::nodes_around(
    const unsigned int                node,
    const std::vector<MortarOverlap> &overlaps) const
  {
    std::set<unsigned int> slave_nodes, master_nodes;
    const auto             add = [](const Surface<2>  &surface,
                        const unsigned int e,
                        auto              &all) {
      for (const unsigned int near :
           {e, surface.facets[e].neighbors[0], surface.facets[e].neighbors[1]})
        if (near != numbers::invalid_unsigned_int)
          for (unsigned int a = 0; a < surface.n_nodes_per_edge(); ++a)
            all.insert(surface.facets[near].nodes[a]);
    };
    for (const unsigned int e : slave.facets_of_node[node])
      {
        add(slave, e, slave_nodes);
        for (const auto &segment : overlaps[e].segments)
          {
            add(master, segment.master_facet, master_nodes);
            for (const auto &cut : {segment.low, segment.high})
              if (cut.master_node != numbers::invalid_unsigned_int)
                master_nodes.insert(cut.master_node);
          }
      }
    return {{slave_nodes, master_nodes}};
  }



  void MortarDiscretization<2>::differentiate(
    MortarGeometry<WithDerivatives>  &now,
    const std::vector<MortarOverlap> &overlaps,
    ContactPoint<2>                  &point) const
  {
    const unsigned int node                = slave_node(point);
    const auto [slave_nodes, master_nodes] = nodes_around(node, overlaps);
    now.follow(slave_nodes, master_nodes);
    MortarIntegrals<WithDerivatives> integrals(now, carries);
    for (const unsigned int e : slave.facets_of_node[node])
      if (!overlaps[e].segments.empty())
        integrals.add_edge(e, overlaps[e], node);
    const MortarPairing<WithDerivatives> pairing = integrals.pairing(node);

    PairingChange<2> &change = point.change;
    for (const unsigned int i : slave_nodes)
      for (const auto dof : slave.nodes[i].dofs)
        change.dofs.push_back(dof);
    for (const unsigned int i : master_nodes)
      for (const auto dof : master.nodes[i].dofs)
        change.dofs.push_back(dof);
    const unsigned int n = change.dofs.size();
    change.C.reinit(point.n_nodes, n);
    change.weight.resize(n);
    change.rotation.resize(n);
    change.projection.resize(n);
    const auto add_coefficients = [&](const Surface<2> &surface,
                                      const auto       &all) {
      for (const auto &[i, c] : all)
        {
          const unsigned int a = place_of(surface.nodes[i], point);
          for (unsigned int j = 0; j < n && a < point.n_nodes; ++j)
            change.C(a, j) += c.dx(j);
        }
    };
    add_coefficients(slave, pairing.slave);
    add_coefficients(master, pairing.master);
    for (unsigned int j = 0; j < n; ++j)
      {
        change.weight[j]     = pairing.weight.dx(j) / point.weight;
        change.projection[j] = pairing.excess.dx(j);
        for (unsigned int i = 0; i < 2; ++i)
          change.rotation[j][0] +=
            point.tangents[0][i] * pairing.normal[i].dx(j);
      }
  }
} // namespace Contact
