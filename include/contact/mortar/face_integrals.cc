/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_integrals.h"

#include <deal.II/base/vectorization.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// Some places of integration, whose shares in the integrals of all test
    /// functions are added at once: most of the time would go into the transfer
    /// of the sums from and to the memory.
    template<typename Row>
    class PlaceBlock
    {
    public:
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

      /// Add all places of a facet of so many nodes to the integrals, and
      /// forget them.
      void add_to(std::vector<Row> &integrals, const unsigned int n_nodes)
      {
        for (unsigned int j = 0; j < integrals.size() && n > 0; ++j)
          {
            for (unsigned int k = n; k < size; ++k)
              factors[j][k] = 0;
            switch (n_nodes)
              {
                case 3:
                  add<3>(factors[j], integrals[j]);
                  break;
                case 4:
                  add<4>(factors[j], integrals[j]);
                  break;
                case 6:
                  add<6>(factors[j], integrals[j]);
                  break;
                default:
                  add<9>(factors[j], integrals[j]);
              }
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

      unsigned int          n = 0;
      std::array<Row, size> places{};
      std::vector<Factors>  factors;
    };
  } // namespace



  FaceIntegrals::FaceIntegrals(const Surface<3>             &slave,
                               const Surface<3>             &master,
                               const std::set<unsigned int> &excluded,
                               const std::vector<double>    &master_bends)
    : slave(slave)
    , master(master)
    , master_bends(master_bends)
    , carries(slave.facets.size())
  {
    find_carriers(excluded);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      shares.push_back(slave.shares_of_nodes(e));
  }



  // The other receiver of a hanging node has it all if one has no multiplier.
  void FaceIntegrals::find_carriers(const std::set<unsigned int> &excluded)
  {
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.facets[e].n_nodes(); ++a)
        {
          double whole = 0;
          for (const auto &receiver : slave.receivers(slave.facets[e].nodes[a]))
            if (excluded.count(receiver.first) == 0)
              {
                carries[e][a].push_back(receiver);
                whole += receiver.second;
              }
          for (auto &receiver : carries[e][a])
            receiver.second /= whole;
        }
  }



  std::set<unsigned int>
  FaceIntegrals::carriers_of(const unsigned int slave_facet) const
  {
    std::set<unsigned int> nodes;
    for (unsigned int a = 0; a < slave.facets[slave_facet].n_nodes(); ++a)
      for (const auto &carrier : carries[slave_facet][a])
        nodes.insert(carrier.first);
    return nodes;
  }



  KeptFunctions FaceIntegrals::add(const unsigned int             e,
                                   const std::vector<FaceSample> &points,
                                   const FaceConfiguration       &now,
                                   const KeptFunctions           &at_start,
                                   std::vector<Tensor<1, 3>>     &distances,
                                   std::vector<NodeIntegrals> &of_nodes) const
  {
    double covered = 0, whole = 0;
    for (const FaceSample &point : points)
      covered += point.weight;
    for (const double share : shares[e])
      whole += share;
    if (covered <= 1e-8 * whole)
      return {};
    for (const FaceSample &point : points)
      {
        distances.push_back(point.distance);
        if (point.distance_at_corner)
          distances.push_back(*point.distance_at_corner);
      }

    const FacetDualFunctions     dual(*slave.facets[e].kind,
                                  points,
                                  shares[e],
                                  carries[e],
                                  at_start);
    std::vector<NodeIntegrals *> carriers;
    for (const unsigned int node : dual.nodes())
      {
        carriers.push_back(&of_nodes[node]);
        carriers.back()->distances.push_back(&distances);
      }
    const auto segments = make_segments(e, dual, points, now, carriers);
    add_slave(e, dual, points, carriers);
    add_master(dual, segments, carriers);
    add_normals(dual, segments, now, carriers);
    add_changes(e, dual, segments, carriers);
    return dual.kept_functions();
  }



  // Gradients are along the master.
  std::vector<FaceIntegrals::Segment> FaceIntegrals::make_segments(
    const unsigned int                  e,
    const FacetDualFunctions           &dual,
    const std::vector<FaceSample>      &points,
    const FaceConfiguration            &now,
    const std::vector<NodeIntegrals *> &carriers) const
  {
    const FacetKind<3> &slave_kind = *slave.facets[e].kind;
    const auto          kind_of    = [&](const unsigned int m) -> const auto &
    {
      return *master.facets[m].kind;
    };
    const bool has_changes = std::any_of(carriers.begin(),
                                         carriers.end(),
                                         [](const NodeIntegrals *carrier) {
                                           return carrier->change.has_value();
                                         });
    const auto add_change  = [&](const FaceSample                 &point,
                                const FacetDualFunctions::Values &phi,
                                const Segment::Row               &place,
                                Segment                          &segment) {
      const FacetKind<3>         &master_kind = kind_of(point.master_facet);
      const unsigned int          n           = master_kind.n_nodes;
      FaceMortarChange::Gradients gradients{};
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int i = 0; i < 3; ++i)
          gradients[b][i] = place[(1 + i) * n + b];
      for (unsigned int k = 0; k < phi.size(); ++k)
        if (segment.changes[k])
          segment.changes[k]->add(point.weight * phi[k],
                                  slave_kind.projected_values(point.slave_xi),
                                  master_kind.projected_values(point.master_xi),
                                  gradients);
    };
    std::vector<Segment>      segments;
    PlaceBlock<Segment::Row>  block;
    PerFacetNode<3, Point<3>> x;
    const auto                finish = [&]() {
      if (!segments.empty())
        block.add_to(segments.back().rows,
                     kind_of(segments.back().master_facet).n_nodes);
    };
    block.reserve(carriers.size());
    for (const FaceSample &point : points)
      {
        const unsigned int n = kind_of(point.master_facet).n_nodes;
        if (segments.empty() ||
            segments.back().master_facet != point.master_facet)
          {
            finish();
            segments.push_back(
              {point.master_facet,
               std::vector<Segment::Row>(carriers.size(), Segment::Row{}),
               {}});
            for (const NodeIntegrals *carrier : carriers)
              segments.back().changes.emplace_back(
                carrier->change
                  ? new FaceMortarChange::OfFacets(slave_kind.n_nodes, n)
                  : nullptr);
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
          finish();
      }
    finish();
    return segments;
  }



  // Where the dual functions are dual to the shape functions, all integrals but
  // the own one are round-off, which is large where the master covers a sliver
  // of the facet.
  void
  FaceIntegrals::add_slave(const unsigned int                  e,
                           const FacetDualFunctions           &dual,
                           const std::vector<FaceSample>      &points,
                           const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto        &A      = dual.coefficients();
    const unsigned int n      = slave.facets[e].n_nodes();
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
  void
  FaceIntegrals::add_master(const FacetDualFunctions           &dual,
                            const std::vector<Segment>         &segments,
                            const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto               &A = dual.coefficients();
    std::vector<unsigned int> nodes;
    for (const Segment &segment : segments)
      {
        const SurfaceFacet<3> &facet = master.facets[segment.master_facet];
        nodes.insert(nodes.end(),
                     facet.nodes.begin(),
                     facet.nodes.begin() + facet.n_nodes());
      }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());

    // Of each node a value and a gradient.
    const unsigned int  length = 4 * nodes.size();
    std::vector<double> of_tests(carriers.size() * length, 0.);
    for (const Segment &segment : segments)
      for (unsigned int b = 0,
                        n = master.facets[segment.master_facet].n_nodes();
           b < n;
           ++b)
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
  void
  FaceIntegrals::add_normals(const FacetDualFunctions           &dual,
                             const std::vector<Segment>         &segments,
                             const FaceConfiguration            &now,
                             const std::vector<NodeIntegrals *> &carriers) const
  {
    const auto               &A = dual.coefficients();
    std::vector<Tensor<1, 3>> normals(carriers.size());
    std::vector<double>       bends(carriers.size(), 0.);
    for (const Segment &segment : segments)
      {
        const unsigned int  m = segment.master_facet;
        std::vector<double> parts(carriers.size(), 0.);
        for (unsigned int b = 0; b < master.facets[m].n_nodes(); ++b)
          for (unsigned int j = 0; j < carriers.size(); ++j)
            {
              const double value = segment.rows[j][b];
              parts[j] += value;
              normals[j] += value * now.master_normals[m][b];
              bends[j] += value * master_bends[master.facets[m].nodes[b]];
            }
        for (unsigned int k = 0; k < carriers.size(); ++k)
          for (unsigned int j = 0; j < carriers.size(); ++j)
            carriers[k]->master_facets[m] += A(k, j) * parts[j];
      }
    for (unsigned int k = 0; k < carriers.size(); ++k)
      for (unsigned int j = 0; j < carriers.size(); ++j)
        {
          carriers[k]->master_normal += A(k, j) * normals[j];
          carriers[k]->master_bend += A(k, j) * bends[j];
        }
  }



  void
  FaceIntegrals::add_changes(const unsigned int                  e,
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
            for (unsigned int b = 0,
                              n = master.facets[segment.master_facet].n_nodes();
                 b < n;
                 ++b)
              {
                double &sum = carriers[k]->normals[{segment.master_facet, b}];
                for (unsigned int j = 0; j < carriers.size(); ++j)
                  sum += A(k, j) * segment.rows[j][b];
              }
          }
  }
} // namespace Contact
