/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_mortar.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace Contact
{
  namespace
  {
    /// Values that belong to nodes, those of hanging ones handed over to the
    /// nodes that they follow.
    template<typename Map, typename Value>
    boost::container::flat_map<unsigned int, double>
    followed(const Surface<3> &surface, const Map &of, const Value &value_of)
    {
      boost::container::flat_map<unsigned int, double> values;
      values.reserve(of.size());
      for (const auto &[node, integrals] : of)
        if (surface.parents[node].empty())
          values[node] += value_of(integrals);
        else
          for (const auto &[parent, part] : surface.parents[node])
            values[parent] += part * value_of(integrals);
      return values;
    }



    using Clock = std::chrono::steady_clock;

    double seconds_since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }
  } // namespace



  MortarDiscretization<3>::MortarDiscretization(
    const Surface<3>             &slave,
    const Surface<3>             &master,
    const DiscretizedBodies<3>   &discretization,
    const std::set<unsigned int> &excluded)
    : slave(slave)
    , master(master)
    , discretization(discretization)
    , excluded(excluded)
    , planes(slave, master, discretization)
    , slave_bends(planes.bends(slave, /*with_ends=*/true))
    , master_bends(planes.bends(master, /*with_ends=*/false))
    , kept(slave.facets.size())
    , kept_at_start(slave.facets.size())
    , face_integrals(slave, master, excluded, master_bends)
  {
  }



  unsigned int
  MortarDiscretization<3>::slave_node(const ContactPoint<3> &point) const
  {
    const SurfaceFacet<3> &facet = slave.facets[point.slave_facet];
    unsigned int           a     = 0;
    while (!(facet.kind->places[a] == point.slave_xi))
      ++a;
    return facet.nodes[a];
  }



  bool MortarDiscretization<3>::pair(const ArrayView<ContactPoint<3>> &points,
                                     const GhostedVector              &u,
                                     const PairingMode                &mode,
                                     const BodyOverlap<3> &bodies) const
  {
    std::vector<PointPairing<3>::PerNode<const SurfaceNode<3> *>> old_nodes;
    for (const ContactPoint<3> &point : points)
      old_nodes.push_back(point.nodes);
    const auto numbers = keep_pairings(points, u, mode);
    if (!numbers.empty())
      pair_anew(points, numbers, u, mode.with_derivatives, bodies);
    for (const unsigned int q : numbers)
      {
        last.weights[q]         = points[q].weight;
        last.pairings[q]        = points[q];
        last.pairings[q].change = PairingChange<3>();
        last.is_present[q]      = true;
      }
    return !std::equal(points.begin(),
                       points.end(),
                       old_nodes.begin(),
                       [](const ContactPoint<3> &point, const auto &old) {
                         return point.nodes == old;
                       });
  }



  void
  MortarDiscretization<3>::pair_anew(const ArrayView<ContactPoint<3>> &points,
                                     const std::vector<unsigned int>  &numbers,
                                     const GhostedVector              &u,
                                     const bool            with_derivatives,
                                     const BodyOverlap<3> &bodies) const
  {
    if (!point_shares)
      point_shares.emplace(points.size(), discretization.communicator);
    std::vector<bool> changes(points.size(), false);
    for (const unsigned int q : numbers)
      changes[q] = with_derivatives && points[q].status.kind != Status::open;
    const std::vector<unsigned int> own = point_shares->own(numbers, changes);
    std::vector<bool>               is_own(slave.nodes.size(), false);
    for (const unsigned int q : own)
      is_own[slave_node(points[q])] = true;

    const FaceConfiguration                now(slave, master, planes, u);
    FaceSegments                           segments(slave, master, now, bodies);
    std::vector<NodeIntegrals>             of_nodes(slave.nodes.size());
    std::vector<float>                     seconds(slave.nodes.size(), 0);
    std::vector<unsigned long>             kept_now(slave.facets.size(), 0);
    std::vector<std::vector<Tensor<1, 3>>> distances(slave.facets.size());
    for (const unsigned int q : own)
      if (changes[q])
        of_nodes[slave_node(points[q])].change.emplace();
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      {
        std::vector<unsigned int> carriers;
        for (const unsigned int node : face_integrals.carriers_of(e))
          if (is_own[node])
            carriers.push_back(node);
        if (carriers.empty())
          continue;
        const auto  start   = Clock::now();
        const auto &samples = segments.samples(e);
        discretization.counters.projections += samples.size();
        kept_now[e] =
          face_integrals
            .add(e, samples, now, kept_at_start[e], distances[e], of_nodes)
            .to_ulong();
        const double of_each = seconds_since(start) / carriers.size();
        for (const unsigned int node : carriers)
          seconds[node] += of_each;
      }

    Utilities::MPI::max(kept_now, discretization.communicator, kept_now);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      if (kept_now[e] > 0)
        kept[e] = kept_now[e];

    std::vector<float> of_points(points.size(), 0);
    for (const unsigned int q : own)
      {
        const unsigned int node  = slave_node(points[q]);
        const auto         start = Clock::now();
        fill_in(of_nodes[node], node, now, u, points[q]);
        if (of_nodes[node].change && points[q].facing)
          differentiate(of_nodes[node], node, now, points[q]);
        of_points[q] = seconds[node] + seconds_since(start);
      }
    point_shares
      ->exchange(points, slave, master, numbers, own, changes, of_points);
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
        point.weight = face_integrals.shares_of(point.slave_facet)[0];
        point.add_node(slave.nodes[node], 1);
        point.n_slave_nodes = 1;
        set_tangents(point);
        return;
      }

    point.weight       = integrals.weight;
    point.master_facet = std::max_element(integrals.master_facets.begin(),
                                          integrals.master_facets.end(),
                                          [](const auto &a, const auto &b) {
                                            return a.second < b.second;
                                          })
                           ->first;
    add_nodes(integrals, node, point);
    point.projection = bulge(integrals);
    make_symmetric(point, discretization, u, 1e-6 * length);
    const Tensor<1, 3> r = move_projections(integrals, now, point);

    // A mean with weights of either sign is no less than the least of the
    // distances, which at a corner of the slave is that of the node itself; a
    // ten-thousandth of a facet is left to it.
    double smallest = std::numeric_limits<double>::max();
    for (const auto *of_facet : integrals.distances)
      for (const Tensor<1, 3> &distance : *of_facet)
        smallest = std::min(smallest, distance * point.normal);
    const double excess = r * point.normal - smallest + 1e-4 * length;
    if (excess < 0)
      point.projection += excess * point.normal;
    point.has_no_free_tangent = has_no_free_tangent(point, discretization);
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
      slave_normal += now.slave_normals[e][slave.number_in(e, node)];
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



  // Biorthogonality leaves round-off where the coefficient is zero. What hangs
  // is replaced by what it follows.
  void MortarDiscretization<3>::add_nodes(const NodeIntegrals &integrals,
                                          const unsigned int   node,
                                          ContactPoint<3>     &point) const
  {
    const double round_off = 1e-10;
    const auto   itself    = [](const double value) { return value; };
    const auto value_of = [](const OfMaster &of_node) { return of_node.value; };
    const auto add      = [&](const SurfaceNode<3> &of, const double integral) {
      point.add_node(of, integral / integrals.weight);
    };
    const auto of_slave  = followed(slave, integrals.slave, itself);
    const auto of_master = followed(master, integrals.master, value_of);
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
    Point<3>   sum;
    const auto add = [&](const Surface<3>  &surface,
                         const unsigned int node,
                         const double       integral) {
      if (surface.parents[node].empty())
        return;
      Tensor<1, 3> beside(surface.nodes[node].X);
      for (const auto &[parent, part] : surface.parents[node])
        beside -= part * Tensor<1, 3>(surface.nodes[parent].X);
      sum -= integral / integrals.weight * beside;
    };
    for (const auto &[a, integral] : integrals.slave)
      add(slave, a, integral);
    for (const auto &[m, of_node] : integrals.master)
      add(master, m, -of_node.value);
    return sum;
  }



  // Facets that are far from tangential to the point do not carry it along.
  Tensor<2, 3> MortarDiscretization<3>::way_of_projections(
    const NodeIntegrals     &integrals,
    const FaceConfiguration &now,
    const ContactPoint<3>   &point) const
  {
    Tensor<2, 3> moves; // of x_master by tau
    for (const auto &[m, of_node] : integrals.master)
      moves += outer_product(Tensor<1, 3>(now.master_x[m]), of_node.gradient) /
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
  MortarDiscretization<3>::move_projections(const NodeIntegrals     &integrals,
                                            const FaceConfiguration &now,
                                            ContactPoint<3> &point) const
  {
    Tensor<1, 3> r;
    for (const auto &[a, integral] : integrals.slave)
      r += integral / integrals.weight * now.slave_x[a];
    for (const auto &[m, of_node] : integrals.master)
      r -= of_node.value / integrals.weight * now.master_x[m];
    const Tensor<1, 3> tau = way_of_projections(integrals, now, point) * r;
    const auto         change_of = [&](const OfMaster &of_node) {
      return of_node.gradient * tau / integrals.weight;
    };
    for (const auto &[m, of_node] : integrals.master)
      r -= change_of(of_node) * now.master_x[m];
    unsigned int a = point.n_slave_nodes;
    for (const auto &[m, change] :
         followed(master, integrals.master, change_of))
      point.C[a++] -= change;
    return r;
  }
} // namespace Contact
