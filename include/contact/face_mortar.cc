/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_mortar.h"

#include <deal.II/base/timer.h>
#include <deal.II/base/vectorization.h>

#include <algorithm>
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
        if (surface.leaders[node].empty())
          values[node] += value_of(integrals);
        else
          for (const auto &[leader, part] : surface.leaders[node])
            values[leader] += part * value_of(integrals);
      return values;
    }



    double itself(const double value)
    {
      return value;
    }



    /// Some places of integration, whose shares in the integrals of all test
    /// functions are added at once: most of the time would go into the transfer
    /// of the sums from and to the memory.
    template<typename Row>
    class PlaceBlock
    {
    public:
      PlaceBlock(const unsigned int n_nodes)
        : n_nodes(n_nodes)
      {
      }

      bool is_full() const
      {
        return n == size;
      }

      /// The next place: its row, to be filled in, and what the test functions
      /// are there times its weight.
      Row &push(const FacetDualFunctions::Values &tests, const double weight)
      {
        for (unsigned int j = 0; j < tests.size(); ++j)
          factors[j][n] = weight * tests[j];
        return places[n++];
      }

      /// Add all places to the integrals, and forget them.
      void add_to(std::vector<Row> &integrals)
      {
        for (unsigned int j = 0; j < integrals.size() && n > 0; ++j)
          {
            for (unsigned int k = n; k < size; ++k)
              factors[j][k] = 0;
            if (n_nodes == 4)
              add<4>(factors[j], integrals[j]);
            else
              add<9>(factors[j], integrals[j]);
          }
        n = 0;
      }

      /// Room for so many test functions.
      void reserve(const unsigned int n_tests)
      {
        factors.resize(n_tests);
      }

    private:
      static constexpr unsigned int size = 4;
      using Factors                      = std::array<double, size>;

      template<unsigned int n_nodes>
      void add(const Factors &factor, Row &integrals) const
      {
        using Numbers                    = VectorizedArray<double>;
        constexpr unsigned int    width  = Numbers::size();
        constexpr unsigned int    length = 4 * n_nodes;
        constexpr unsigned int    rest   = length % width;
        std::array<Numbers, size> factors;
        for (unsigned int k = 0; k < size; ++k)
          factors[k] = factor[k];
        for (unsigned int i = 0; i < length - rest; i += width)
          {
            Numbers sum, value;
            sum.load(&integrals[i]);
            for (unsigned int k = 0; k < size; ++k)
              {
                value.load(&places[k][i]);
                sum += factors[k] * value;
              }
            sum.store(&integrals[i]);
          }
        for (unsigned int i = length - rest; i < length; ++i)
          for (unsigned int k = 0; k < size; ++k)
            integrals[i] += factor[k] * places[k][i];
      }

      const unsigned int    n_nodes;
      unsigned int          n = 0;
      std::array<Row, size> places{};
      std::vector<Factors>  factors;
    };



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
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      shares.push_back(slave.shares_of_nodes(e));
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



  bool MortarDiscretization<3>::pair(const ArrayView<ContactPoint<3>> &points,
                                     const GhostedVector              &u,
                                     const PairingMode &mode) const
  {
    std::vector<PointPairing<3>::PerNode<NodeDoFs<3>>> old_dofs;
    for (const ContactPoint<3> &point : points)
      old_dofs.push_back(point.dofs);
    const auto numbers = keep_pairings(points, u, mode);
    if (!numbers.empty())
      pair_anew(points, numbers, u, mode.with_derivatives);
    for (const unsigned int q : numbers)
      {
        last.weights[q]         = points[q].weight;
        last.pairings[q]        = points[q];
        last.pairings[q].change = PairingChange<3>();
        last.is_present[q]      = true;
      }
    return !std::equal(points.begin(),
                       points.end(),
                       old_dofs.begin(),
                       [](const ContactPoint<3> &point, const auto &old) {
                         return point.dofs == old;
                       });
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
      touches = may_touch(u);
    const auto stays_open = [&](const unsigned int q) {
      const PointPairing<3> &pairing = last.pairings[q];
      if (touches.empty() || touches[slave_node(points[q])] ||
          !points[q].motions.empty())
        return false;
      Tensor<1, 3> r = -pairing.projection;
      for (unsigned int a = 0; a < pairing.n_nodes; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          r[i] += pairing.C[a] * (pairing.X[a][i] + u[pairing.dofs[a][i]]);
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
    return others;
  }



  std::vector<bool>
  MortarDiscretization<3>::may_touch(const GhostedVector &u) const
  {
    const SurfaceSearch<3> of_slave(slave, u), of_master(master, u);
    const auto             facets = of_master.may_be_close(of_slave, 0);
    std::vector<bool>      nodes(slave.nodes.size(), false);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_facet() && facets[e]; ++a)
        for (const auto &carrier : carries[e][a])
          nodes[carrier.first] = true;
    return nodes;
  }



  void
  MortarDiscretization<3>::pair_anew(const ArrayView<ContactPoint<3>> &points,
                                     const std::vector<unsigned int>  &numbers,
                                     const GhostedVector              &u,
                                     const bool with_derivatives) const
  {
    if (!point_shares)
      point_shares.emplace(points.size(), discretization.communicator);
    Timer                           timer;
    std::vector<bool>               is_own(slave.nodes.size(), false);
    const std::vector<unsigned int> own = point_shares->own(numbers);
    for (const unsigned int q : own)
      is_own[slave_node(points[q])] = true;

    const FaceConfiguration                now(slave, master, planes, u);
    FaceSegments                           segments(slave, master, now);
    std::vector<NodeIntegrals>             of_nodes(slave.nodes.size());
    std::vector<std::vector<Tensor<1, 3>>> distances(slave.facets.size());
    for (const unsigned int q : own)
      if (with_derivatives && points[q].status.kind != Status::open)
        of_nodes[slave_node(points[q])].change.emplace();
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      if (carries_any(e, is_own))
        integrate(e, segments.samples(e), now, distances[e], of_nodes);

    for (const unsigned int q : own)
      {
        const unsigned int node = slave_node(points[q]);
        fill_in(of_nodes[node], node, now, u, points[q]);
        if (of_nodes[node].change && points[q].facing)
          differentiate(of_nodes[node], node, now, points[q]);
      }
    const double seconds = timer.wall_time();
    point_shares->exchange(points, numbers);
    if (numbers.size() == points.size())
      point_shares->balance(seconds);
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
                                     std::vector<Tensor<1, 3>>     &distances,
                                     std::vector<NodeIntegrals> &of_nodes) const
  {
    double covered = 0, whole = 0;
    for (const FaceSample &point : points)
      covered += point.weight;
    for (const double share : shares[e])
      whole += share;
    discretization.counters.projections += points.size();
    if (covered <= 1e-8 * whole)
      return;
    for (const FaceSample &point : points)
      {
        distances.push_back(point.distance);
        if (point.distance_at_corner)
          distances.push_back(*point.distance_at_corner);
      }

    const FacetDualFunctions dual(slave.degree, points, shares[e], carries[e]);
    std::vector<NodeIntegrals *> carriers;
    for (const unsigned int node : dual.nodes())
      {
        carriers.push_back(&of_nodes[node]);
        carriers.back()->distances.push_back(&distances);
      }
    const auto segments = make_segments(dual, points, now, carriers);
    add_slave(e, dual, points, carriers);
    add_master(dual, segments, carriers);
    add_normals(dual, segments, now, carriers);
    add_changes(e, dual, segments, carriers);
  }



  // Gradients are along the master.
  std::vector<MortarDiscretization<3>::Segment>
  MortarDiscretization<3>::make_segments(
    const FacetDualFunctions           &dual,
    const std::vector<FaceSample>      &points,
    const FaceConfiguration            &now,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const unsigned int n           = master.n_nodes_per_facet();
    const bool         has_changes = std::any_of(carriers.begin(),
                                         carriers.end(),
                                         [](const NodeIntegrals *carrier) {
                                           return carrier->change.has_value();
                                         });
    const auto         add_change = [&](const FaceSample                 &point,
                                const FacetDualFunctions::Values &phi,
                                const Segment::Row               &place,
                                Segment                          &segment) {
      FaceMortarChange::Gradients gradients{};
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int i = 0; i < 3; ++i)
          gradients[b][i] = place[(1 + i) * n + b];
      for (unsigned int k = 0; k < phi.size(); ++k)
        if (segment.changes[k])
          segment.changes[k]->add(
            point.weight * phi[k],
            projected_values(slave.degree, point.slave_xi),
            projected_values(master.degree, point.master_xi),
            gradients);
    };
    std::vector<Segment>      segments;
    PlaceBlock<Segment::Row>  block(n);
    PerFacetNode<3, Point<3>> x;
    block.reserve(carriers.size());
    for (const FaceSample &point : points)
      {
        if (segments.empty() ||
            segments.back().master_facet != point.master_facet)
          {
            if (!segments.empty())
              block.add_to(segments.back().rows);
            segments.push_back(
              {point.master_facet,
               std::vector<Segment::Row>(carriers.size(), Segment::Row{}),
               {}});
            for (const NodeIntegrals *carrier : carriers)
              segments.back().changes.emplace_back(
                carrier->change ? new FaceMortarChange::OfFacets() : nullptr);
            for (unsigned int b = 0; b < n; ++b)
              x[b] = now.master_x[master.facets[point.master_facet].nodes[b]];
          }
        Segment                    &segment = segments.back();
        const FacetBasis           &basis   = point.master_basis;
        std::array<Tensor<1, 3>, 2> t;
        for (unsigned int b = 0; b < n; ++b)
          for (unsigned int i = 0; i < 2; ++i)
            t[i] += basis.first[i][b] * x[b];
        const auto    d = dual_basis(t);
        Segment::Row &place =
          block.push(dual.test_functions(point), point.weight);
        std::copy_n(basis.value.begin(), n, place.begin());
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int b = 0; b < n; ++b)
            place[(1 + i) * n + b] =
              basis.first[0][b] * d[0][i] + basis.first[1][b] * d[1][i];
        if (has_changes)
          add_change(point, dual.values(point), place, segment);
        if (block.is_full())
          block.add_to(segment.rows);
      }
    if (!segments.empty())
      block.add_to(segments.back().rows);
    return segments;
  }



  // Where the dual functions are dual to the shape functions, all integrals but
  // the own one are round-off, which is large where the master covers a sliver
  // of the facet.
  void MortarDiscretization<3>::add_slave(
    const unsigned int                  e,
    const FacetDualFunctions           &dual,
    const std::vector<FaceSample>      &points,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto        &A      = dual.coefficients();
    const unsigned int n      = slave.n_nodes_per_facet();
    const auto        &nodes  = slave.facets[e].nodes;
    const auto         weight = [&](const unsigned int k) {
      double sum = 0;
      for (unsigned int j = 0; j < carriers.size(); ++j)
        sum += A(k, j) * dual.integrals()[j];
      return sum;
    };
    for (unsigned int k = 0; k < carriers.size(); ++k)
      carriers[k]->weight += weight(k);
    if (dual.are_dual_to_shapes())
      {
        for (unsigned int k = 0; k < carriers.size(); ++k)
          carriers[k]->slave[dual.nodes()[k]] += weight(k);
        return;
      }

    std::vector<PerFacetNode<3, double>> of_tests(carriers.size());
    for (const FaceSample &point : points)
      {
        const auto M = dual.test_functions(point);
        for (unsigned int j = 0; j < M.size(); ++j)
          for (unsigned int a = 0; a < n; ++a)
            of_tests[j][a] += point.weight * M[j] * point.slave_values[a];
      }
    for (unsigned int k = 0; k < carriers.size(); ++k)
      for (unsigned int a = 0; a < n; ++a)
        {
          double &sum = carriers[k]->slave[nodes[a]];
          for (unsigned int j = 0; j < carriers.size(); ++j)
            sum += A(k, j) * of_tests[j][a];
        }
  }



  // Facets have nodes in common.
  void MortarDiscretization<3>::add_master(
    const FacetDualFunctions           &dual,
    const std::vector<Segment>         &segments,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto               &A = dual.coefficients();
    const unsigned int        n = master.n_nodes_per_facet();
    std::vector<unsigned int> nodes;
    for (const Segment &segment : segments)
      {
        const auto &of_facet = master.facets[segment.master_facet].nodes;
        nodes.insert(nodes.end(), of_facet.begin(), of_facet.begin() + n);
      }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());

    // Of each node a value and a gradient.
    const unsigned int  length = 4 * nodes.size();
    std::vector<double> of_tests(carriers.size() * length, 0.);
    for (const Segment &segment : segments)
      for (unsigned int b = 0; b < n; ++b)
        {
          const unsigned int m = master.facets[segment.master_facet].nodes[b];
          const unsigned int place =
            std::lower_bound(nodes.begin(), nodes.end(), m) - nodes.begin();
          for (unsigned int j = 0; j < carriers.size(); ++j)
            for (unsigned int i = 0; i < 4; ++i)
              of_tests[j * length + 4 * place + i] +=
                segment.rows[j][i * n + b];
        }

    std::vector<double> sum(length);
    for (unsigned int k = 0; k < carriers.size(); ++k)
      {
        std::fill(sum.begin(), sum.end(), 0.);
        for (unsigned int j = 0; j < carriers.size(); ++j)
          for (unsigned int i = 0; i < length; ++i)
            sum[i] += A(k, j) * of_tests[j * length + i];
        for (unsigned int m = 0; m < nodes.size(); ++m)
          {
            OfMaster &of_node = carriers[k]->master[nodes[m]];
            of_node.value += sum[4 * m];
            for (unsigned int i = 0; i < 3; ++i)
              of_node.gradient[i] += sum[4 * m + 1 + i];
          }
      }
  }



  // At its corners each facet of the master has normals of its own.
  void MortarDiscretization<3>::add_normals(
    const FacetDualFunctions           &dual,
    const std::vector<Segment>         &segments,
    const FaceConfiguration            &now,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto               &A = dual.coefficients();
    std::vector<Tensor<1, 3>> normals(carriers.size());
    std::vector<double>       bends(carriers.size(), 0.);
    for (const Segment &segment : segments)
      for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
        {
          const unsigned int m = segment.master_facet;
          for (unsigned int j = 0; j < carriers.size(); ++j)
            {
              const double value = segment.rows[j][b];
              normals[j] += value * now.master_normals[m][b];
              bends[j] += value * master_bends[master.facets[m].nodes[b]];
            }
        }
    for (unsigned int k = 0; k < carriers.size(); ++k)
      for (unsigned int j = 0; j < carriers.size(); ++j)
        {
          carriers[k]->master_normal += A(k, j) * normals[j];
          carriers[k]->master_bend += A(k, j) * bends[j];
        }
  }



  void MortarDiscretization<3>::add_changes(
    const unsigned int                  e,
    const FacetDualFunctions           &dual,
    const std::vector<Segment>         &segments,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto &A = dual.coefficients();
    for (unsigned int k = 0; k < carriers.size(); ++k)
      if (carriers[k]->change)
        for (const Segment &segment : segments)
          {
            carriers[k]->change->add(slave.facets[e],
                                     master.facets[segment.master_facet],
                                     slave,
                                     master,
                                     *segment.changes[k]);
            for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
              {
                double &sum = carriers[k]->normals[{segment.master_facet, b}];
                for (unsigned int j = 0; j < carriers.size(); ++j)
                  sum += A(k, j) * segment.rows[j][b];
              }
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
        point.weight = shares[point.slave_facet][0];
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
    for (const auto *of_facet : integrals.distances)
      for (const Tensor<1, 3> &distance : *of_facet)
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



  // Biorthogonality leaves round-off where the coefficient is zero. What hangs
  // is replaced by what it follows.
  void MortarDiscretization<3>::add_nodes(const NodeIntegrals &integrals,
                                          const unsigned int   node,
                                          ContactPoint<3>     &point) const
  {
    const double round_off = 1e-10;
    const auto value_of = [](const OfMaster &of_node) { return of_node.value; };
    const auto add      = [&](const SurfaceNode<3> &of, const double integral) {
      point.add_node(of, integral / integrals.weight, 0, 0);
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
      if (surface.leaders[node].empty())
        return;
      Tensor<1, 3> beside(surface.nodes[node].X);
      for (const auto &[leader, part] : surface.leaders[node])
        beside -= part * Tensor<1, 3>(surface.nodes[leader].X);
      sum -= integral / integrals.weight * beside;
    };
    for (const auto &[a, integral] : integrals.slave)
      add(slave, a, integral);
    for (const auto &[m, of_node] : integrals.master)
      add(master, m, -of_node.value);
    return sum;
  }



  // Facets that are far from tangential to the point do not carry it along.
  Tensor<2, 3>
  MortarDiscretization<3>::way_of_feet(const NodeIntegrals     &integrals,
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
  MortarDiscretization<3>::move_feet(const NodeIntegrals     &integrals,
                                     const FaceConfiguration &now,
                                     ContactPoint<3>         &point) const
  {
    Tensor<1, 3> r;
    for (const auto &[a, integral] : integrals.slave)
      r += integral / integrals.weight * now.slave_x[a];
    for (const auto &[m, of_node] : integrals.master)
      r -= of_node.value / integrals.weight * now.master_x[m];
    const Tensor<1, 3> tau       = way_of_feet(integrals, now, point) * r;
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
