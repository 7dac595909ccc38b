/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_mortar.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <limits>

namespace Contact
{
  namespace
  {
    /// Values that belong to nodes, those of hanging ones handed over to the
    /// nodes that they follow.
    std::map<unsigned int, double>
    followed(const Surface<3>                     &surface,
             const std::map<unsigned int, double> &of)
    {
      std::map<unsigned int, double> values;
      for (const auto &[node, value] : of)
        for (const auto &[leader, part] : surface.followed_by(node))
          values[leader] += part * value;
      return values;
    }

    /// The functions of the nodes that facets are projected with.
    FacetShape<3>::Values projected_values(const unsigned int degree,
                                           const Point<2>    &xi)
    {
      return degree == 1 ? FacetShape<3>::values(1, xi)
                         : piecewise_bilinear(xi);
    }
  } // namespace



  MortarDiscretization<3>::MortarDiscretization(
    const Surface<3>             &slave,
    const Surface<3>             &master,
    const Discretization<3>      &discretization,
    const std::set<unsigned int> &excluded)
    : slave(slave)
    , master(master)
    , discretization(discretization)
    , excluded(excluded)
    , carries(slave.facets.size())
    , planes(slave, master, discretization)
    , slave_bends(planes.bends(slave))
    , master_bends(planes.bends(master))
  {
    find_carriers();
  }



  // Where one heir of a hanging node has no multiplier, the other has it all.
  void MortarDiscretization<3>::find_carriers()
  {
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
        {
          double whole = 0;
          for (const auto &heir : slave.heirs(slave.facets[e].nodes[a]))
            if (excluded.count(heir.first) == 0)
              {
                carries[e][a].push_back(heir);
                whole += heir.second;
              }
          for (auto &heir : carries[e][a])
            heir.second /= whole;
        }
  }



  std::vector<ContactPoint<3>>
  MortarDiscretization<3>::make_points(MultiplierSpace &multipliers) const
  {
    return make_nodal_points(slave, excluded, multipliers);
  }



  unsigned int
  MortarDiscretization<3>::slave_node(const ContactPoint<3> &point) const
  {
    const auto  &nodes = slave.facets[point.slave_facet].nodes;
    unsigned int a     = 0;
    while (!(node_place<3>(a) == point.slave_xi))
      ++a;
    return nodes[a];
  }



  bool MortarDiscretization<3>::pair(const ArrayView<ContactPoint<3>> &points,
                                     const GhostedVector              &u,
                                     const bool with_derivatives) const
  {
    if (!point_shares)
      point_shares.emplace(points.size(), discretization.communicator);
    Timer             timer;
    std::vector<bool> is_own(slave.nodes.size(), false);
    for (unsigned int q = point_shares->first(); q < point_shares->end(); ++q)
      is_own[slave_node(points[q])] = true;

    const FaceConfiguration    now(slave, master, planes, u);
    const FaceSegments         segments(slave, master, now);
    std::vector<NodeIntegrals> of_nodes(slave.nodes.size());
    for (unsigned int q = point_shares->first(); q < point_shares->end(); ++q)
      if (with_derivatives && points[q].status.kind != Status::open)
        of_nodes[slave_node(points[q])].change.emplace();
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      if (carries_any(e, is_own))
        integrate(e, segments.samples(e), now, of_nodes);

    std::vector<PointPairing<3>::PerNode<NodeDoFs<3>>> old_dofs;
    for (ContactPoint<3> &point : points)
      {
        old_dofs.push_back(point.dofs);
        point.change = PairingChange<3>();
      }
    for (unsigned int q = point_shares->first(); q < point_shares->end(); ++q)
      {
        const unsigned int node = slave_node(points[q]);
        fill_in(of_nodes[node], node, now, u, points[q]);
        if (of_nodes[node].change && points[q].facing)
          differentiate(of_nodes[node], node, now, points[q]);
      }
    point_shares->exchange(points, timer.wall_time());
    return !std::equal(points.begin(),
                       points.end(),
                       old_dofs.begin(),
                       [](const ContactPoint<3> &point, const auto &old) {
                         return point.dofs == old;
                       });
  }



  bool
  MortarDiscretization<3>::carries_any(const unsigned int       e,
                                       const std::vector<bool> &nodes) const
  {
    for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
      for (const auto &carrier : carries[e][a])
        if (nodes[carrier.first])
          return true;
    return false;
  }



  void
  MortarDiscretization<3>::integrate(const unsigned int             e,
                                     const std::vector<FaceSample> &points,
                                     const FaceConfiguration       &now,
                                     std::vector<NodeIntegrals> &of_nodes) const
  {
    const auto shares  = slave.shares_of_nodes(e);
    double     covered = 0, whole = 0;
    for (const FaceSample &point : points)
      covered += point.weight;
    for (const double share : shares)
      whole += share;
    discretization.counters.projections += points.size();
    if (covered <= 1e-8 * whole)
      return;

    const FacetDualFunctions     dual(slave.degree,
                                  {points.begin(), points.end()},
                                  shares,
                                  carries[e]);
    const auto                  &nodes = slave.facets[e].nodes;
    std::vector<NodeIntegrals *> carriers;
    for (const unsigned int node : dual.nodes())
      carriers.push_back(&of_nodes[node]);

    PerFacetNode<3, PerFacetNode<3, double>> of_slave{};
    std::vector<Segment>                     segments;
    for (const FaceSample &point : points)
      {
        if (segments.empty() ||
            segments.back().master_facet != point.master_facet)
          {
            segments.push_back({point.master_facet, {}, {}, {}});
            for (const NodeIntegrals *carrier : carriers)
              segments.back().changes.emplace_back(
                carrier->change ? new FaceMortarChange::OfFacets() : nullptr);
          }
        const auto values = FacetShape<3>::values(slave.degree, point.slave_xi);
        FacetDualFunctions::Values phi = dual.values(point.slave_xi);
        for (unsigned int k = 0; k < phi.size(); ++k)
          {
            phi[k] *= point.weight;
            for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
              of_slave[k][a] += phi[k] * values[a];
          }
        const FacetShape<3> shape(master.degree, point.master_xi);
        add_master(point, phi, shape, now, segments.back());
        add_normals(point, phi, shape, now, carriers);
      }
    for (unsigned int k = 0; k < carriers.size(); ++k)
      {
        if (dual.are_dual_to_shapes())
          keep_own(of_slave[k],
                   std::find(nodes.begin(), nodes.end(), dual.nodes()[k]) -
                     nodes.begin());
        for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
          carriers[k]->slave[nodes[a]] += of_slave[k][a];
        for (const Segment &segment : segments)
          for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
            {
              const unsigned int m =
                master.facets[segment.master_facet].nodes[b];
              carriers[k]->master[m] += segment.values[k][b];
              carriers[k]->gradients[m] += segment.gradients[k][b];
            }
        for (const Segment &segment : segments)
          if (carriers[k]->change)
            {
              const auto &facet = master.facets[segment.master_facet];
              carriers[k]->change->add(slave.facets[e],
                                       facet,
                                       slave,
                                       master,
                                       *segment.changes[k]);
              for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
                carriers[k]->normals[{segment.master_facet, b}] +=
                  segment.values[k][b];
            }
      }
  }



  // Gradients are along the master.
  void
  MortarDiscretization<3>::add_master(const FaceSample                 &point,
                                      const FacetDualFunctions::Values &phi,
                                      const FacetShape<3>              &shape,
                                      const FaceConfiguration          &now,
                                      Segment &segment) const
  {
    const auto                 &facet = master.facets[point.master_facet];
    std::array<Tensor<1, 3>, 2> t;
    for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
      for (unsigned int i = 0; i < 2; ++i)
        t[i] += shape.first[i][b] * now.master_x[facet.nodes[b]];
    const auto                  d = dual_basis(t);
    FaceMortarChange::Gradients gradients{};
    for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
      gradients[b] = shape.first[0][b] * d[0] + shape.first[1][b] * d[1];

    for (unsigned int k = 0; k < phi.size(); ++k)
      {
        for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
          {
            segment.values[k][b] += phi[k] * shape.value[b];
            segment.gradients[k][b] += phi[k] * gradients[b];
          }
        if (segment.changes[k])
          segment.changes[k]->add(
            phi[k],
            projected_values(slave.degree, point.slave_xi),
            projected_values(master.degree, point.master_xi),
            gradients);
      }
  }



  void MortarDiscretization<3>::add_normals(
    const FaceSample                   &point,
    const FacetDualFunctions::Values   &phi,
    const FacetShape<3>                &shape,
    const FaceConfiguration            &now,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto  &facet = master.facets[point.master_facet];
    Tensor<1, 3> normal;
    double       bend = 0;
    for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
      {
        normal += shape.value[b] * now.master_normals[point.master_facet][b];
        bend += shape.value[b] * master_bends[facet.nodes[b]];
      }
    for (unsigned int k = 0; k < phi.size(); ++k)
      {
        carriers[k]->weight += phi[k];
        carriers[k]->master_normal += phi[k] * normal;
        carriers[k]->master_bend += phi[k] * bend;
        carriers[k]->distances.push_back(point.distance);
        carriers[k]->distances.push_back(point.distance_at_corner);
      }
  }



  void MortarDiscretization<3>::fill_in(const NodeIntegrals     &integrals,
                                        const unsigned int       node,
                                        const FaceConfiguration &now,
                                        const GhostedVector     &u,
                                        ContactPoint<3>         &point) const
  {
    const double length = slave.reference_length(point.slave_facet);
    point.keep_nodes(0);
    point.projection = Point<3>();
    point.facing     = integrals.weight > 0;
    point.normal     = normal(integrals, node, now);
    if (!point.facing)
      {
        point.weight = slave.shares_of_nodes(point.slave_facet)[0];
        point.add_node(slave.nodes[node], 1, 0, 0);
        point.n_slave_nodes = 1;
        set_tangents(point);
        return;
      }

    point.weight = integrals.weight;
    add_nodes(integrals, node, point);
    point.projection = bulge(integrals);
    make_symmetric(point, discretization, u, 1e-6 * length);
    const Tensor<1, 3> r = move_feet(integrals, now, point);

    // A mean with weights of either sign is no less than the least of the
    // distances, which at a corner of the slave is that of the node itself; a
    // ten-thousandth of a facet is left to it.
    double smallest = std::numeric_limits<double>::max();
    for (const Tensor<1, 3> &distance : integrals.distances)
      smallest = std::min(smallest, distance * point.normal);
    const double excess = r * point.normal - smallest + 1e-4 * length;
    if (excess < 0)
      point.projection += excess * point.normal;
    point.tangential_row_is_void =
      tangential_row_is_void(point, discretization);
    skip_where_held(point, discretization, u);
  }



  // Of the facets around the node, and of the master; which of the two counts
  // more is the one that bends less.
  Tensor<1, 3>
  MortarDiscretization<3>::normal(const NodeIntegrals     &integrals,
                                  const unsigned int       node,
                                  const FaceConfiguration &now) const
  {
    Tensor<1, 3> slave_normal;
    for (const unsigned int e : slave.facets_of_node[node])
      {
        const auto &nodes = slave.facets[e].nodes;
        slave_normal +=
          now.slave_normals[e][std::find(nodes.begin(), nodes.end(), node) -
                               nodes.begin()];
      }
    slave_normal /= slave_normal.norm();

    const double of_slave = slave_bends[node];
    const double flat     = 1e-8;
    if (integrals.weight <= 0 || of_slave <= flat)
      return -slave_normal;
    const double of_master =
      std::max(0., integrals.master_bend / integrals.weight);
    const Tensor<1, 3> sum = -of_master * of_master * slave_normal +
                             of_slave * of_slave * integrals.master_normal /
                               integrals.master_normal.norm();
    return sum / sum.norm();
  }



  // Round-off in the integrals of the others is large where the master covers a
  // sliver of the facet.
  void MortarDiscretization<3>::keep_own(PerFacetNode<3, double> &of_slave,
                                         const unsigned int       own)
  {
    double sum = 0;
    for (const double integral : of_slave)
      sum += integral;
    of_slave      = {};
    of_slave[own] = sum;
  }



  // Biorthogonality leaves round-off where the coefficient is zero. What hangs
  // is replaced by what it follows.
  void MortarDiscretization<3>::add_nodes(const NodeIntegrals &integrals,
                                          const unsigned int   node,
                                          ContactPoint<3>     &point) const
  {
    const double round_off = 1e-10;
    const auto   add = [&](const SurfaceNode<3> &of, const double integral) {
      point.add_node(of, integral / integrals.weight, 0, 0);
    };
    const auto of_slave  = followed(slave, integrals.slave);
    const auto of_master = followed(master, integrals.master);
    add(slave.nodes[node], of_slave.at(node));
    for (const auto &[a, integral] : of_slave)
      if (a != node && std::abs(integral) > round_off * integrals.weight)
        add(slave.nodes[a], integral);
    point.n_slave_nodes = point.n_nodes;
    for (const auto &[m, integral] : of_master)
      add(master.nodes[m], -integral);
  }



  // On round boundaries a hanging node is beside the side that it follows, as
  // the displacement of the undeformed body says nothing of.
  Point<3> MortarDiscretization<3>::bulge(const NodeIntegrals &integrals) const
  {
    const auto add = [&](const Surface<3>                     &surface,
                         const std::map<unsigned int, double> &of,
                         const double                          sign,
                         Point<3>                             &sum) {
      for (const auto &[node, integral] : of)
        if (!surface.leaders[node].empty())
          {
            Tensor<1, 3> beside(surface.nodes[node].X);
            for (const auto &[leader, part] : surface.leaders[node])
              beside -= part * Tensor<1, 3>(surface.nodes[leader].X);
            sum -= sign * integral / integrals.weight * beside;
          }
    };
    Point<3> sum;
    add(slave, integrals.slave, 1, sum);
    add(master, integrals.master, -1, sum);
    return sum;
  }



  // Facets that are far from tangential to the point do not carry it along.
  Tensor<2, 3>
  MortarDiscretization<3>::way_of_feet(const NodeIntegrals     &integrals,
                                       const FaceConfiguration &now,
                                       const ContactPoint<3>   &point) const
  {
    Tensor<2, 3> moves; // of x_master by tau
    for (const auto &[m, gradient] : integrals.gradients)
      moves += outer_product(Tensor<1, 3>(now.master_x[m]), gradient) /
               integrals.weight;
    Tensor<2, 2> E;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        E[i][j] = point.tangents[i] * (moves * point.tangents[j]);

    // One, where the master is smooth.
    const double smallest = 0.1;
    Tensor<2, 3> way;
    if (determinant(E) <= smallest)
      return way;
    const Tensor<2, 2> inverse = invert(E);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        way +=
          inverse[i][j] * outer_product(point.tangents[i], point.tangents[j]);
    return way;
  }



  // Returns the rest of the distance.
  Tensor<1, 3>
  MortarDiscretization<3>::move_feet(const NodeIntegrals     &integrals,
                                     const FaceConfiguration &now,
                                     ContactPoint<3>         &point) const
  {
    Tensor<1, 3> r;
    for (const auto &[a, integral] : integrals.slave)
      r += integral / integrals.weight * now.slave_x[a];
    for (const auto &[m, integral] : integrals.master)
      r -= integral / integrals.weight * now.master_x[m];
    const Tensor<1, 3>             tau = way_of_feet(integrals, now, point) * r;
    std::map<unsigned int, double> changes;
    for (const auto &[m, gradient] : integrals.gradients)
      {
        changes[m] = gradient * tau / integrals.weight;
        r -= changes[m] * now.master_x[m];
      }
    unsigned int a = point.n_slave_nodes;
    for (const auto &[m, change] : followed(master, changes))
      point.C[a++] -= change;
    return r;
  }
} // namespace Contact
