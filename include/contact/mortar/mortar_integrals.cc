/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/mortar_integrals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  namespace
  {
    template<typename Number>
    Number absolute(const Number &x)
    {
      return value_of(x) < 0 ? Number(-x) : x;
    }

    template<typename Number>
    Number square(const Number &x)
    {
      return x * x;
    }

    template<typename Number>
    Number square_of(const Tensor<1, 2, Number> &x)
    {
      return x * x;
    }

    /// The key of the largest value.
    unsigned int largest(const std::map<unsigned int, double> &values)
    {
      return std::max_element(values.begin(),
                              values.end(),
                              [](const auto &a, const auto &b) {
                                return a.second < b.second;
                              })
        ->first;
    }
  } // namespace



  template<typename Number>
  MortarIntegrals<Number>::MortarIntegrals(
    const MortarGeometry<Number> &geometry,
    const Carriers               &carries)
    : now(geometry)
    , slave(geometry.slave)
    , master(geometry.master)
    , carries(carries)
  {
  }



  // On an edge that faces the master in part, the nodes beyond the parts have
  // no dual function; if that would be all, the nearest one has, or both if
  // they are as near. On an edge of degree 2 with a hole, the integrals of its
  // shape functions may be negative, those of linear ones are not: there the
  // middle has one only if no end has.
  template<typename Number>
  std::vector<unsigned int>
  MortarIntegrals<Number>::carrying_nodes(const unsigned int   slave_facet,
                                          const MortarOverlap &overlap) const
  {
    std::vector<unsigned int> candidates, nodes;
    double                    nearest = std::numeric_limits<double>::max();
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      if (carries[slave_facet][a])
        {
          candidates.push_back(a);
          nearest = std::min(nearest, overlap.distance(node_coordinates[a]));
        }
    // The pressures of an edge are others with another set of nodes: where
    // both surfaces end at the same place, the set must not depend on which way
    // they deform.
    for (const unsigned int a : candidates)
      if (overlap.distance(node_coordinates[a]) <=
          nearest + DeformedSurface<2>::overhang)
        nodes.push_back(a);
    const bool all_seen =
      overlap.parts.size() == 1 && nearest < mortar_round_off;
    if (!all_seen && nodes.size() > 1 && nodes.back() == 2)
      nodes.pop_back();
    return nodes;
  }



  // A node without a dual function leaves its shape function to the nearest
  // node that has one; one in the middle, to both ends. The functions still sum
  // up to one, and their integrals are positive, which those of the linear
  // functions on two of three nodes are not.
  template<typename Number>
  std::array<Number, 3> MortarIntegrals<Number>::test_functions(
    const std::vector<unsigned int> &nodes,
    const EdgeShapes<Number>        &shape) const
  {
    std::array<Number, 3> values{{0, 0, 0}};
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      {
        const auto distance = [&](const unsigned int b) {
          return std::abs(node_coordinates[a] - node_coordinates[b]);
        };
        double       nearest = 3;
        unsigned int n       = 0;
        for (const unsigned int b : nodes)
          {
            n       = distance(b) < nearest ? 1 : n + (distance(b) == nearest);
            nearest = std::min(nearest, distance(b));
          }
        for (unsigned int j = 0; j < nodes.size(); ++j)
          if (distance(nodes[j]) == nearest)
            values[j] += shape.value[a] / n;
      }
    return values;
  }



  // Phi_k = sum_i a_ki xi^i with as many terms as there are nodes, from
  //   sum_i a_ki integral xi^i M_j ds = delta_kj integral M_j ds
  // with the test functions M_j: on a full edge the shape functions. Summed
  // over k this says that sum_k Phi_k - 1 is orthogonal to all M_j: the dual
  // functions sum up to one. Summed over j, that D_k = integral M_k ds.
  template<typename Number>
  typename MortarIntegrals<Number>::Table
  MortarIntegrals<Number>::dual_functions(
    const std::vector<unsigned int>         &nodes,
    const std::vector<MortarSample<Number>> &samples) const
  {
    const unsigned int    n = nodes.size();
    std::array<Number, 3> integrals{{0, 0, 0}};

    // moments(i, j), without terms and nodes that are not there
    Tensor<2, 3, Number> moments;
    for (unsigned int i = n; i < 3; ++i)
      moments[i][i] = 1;
    for (const auto &sample : samples)
      {
        const auto test =
          test_functions(nodes, EdgeShapes<Number>(slave.degree, sample.xi));
        for (unsigned int j = 0; j < n; ++j)
          {
            Number term = sample.weight * test[j];
            integrals[j] += term;
            for (unsigned int i = 0; i < n; ++i)
              {
                moments[i][j] += term;
                term *= sample.xi;
              }
          }
      }

    // a M = diag(integrals)
    const Tensor<2, 3, Number> inverse = invert(moments);
    Table                      coefficients;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = 0; i < n; ++i)
        coefficients[k][i] = integrals[k] * inverse[k][i];
    return coefficients;
  }



  template<typename Number>
  void MortarIntegrals<Number>::add_edge(const unsigned int   slave_facet,
                                         const MortarOverlap &overlap,
                                         const unsigned int   only)
  {
    const auto &edge  = slave.facets[slave_facet];
    const auto  nodes = carrying_nodes(slave_facet, overlap);
    if (nodes.empty())
      return;

    const auto  samples = mortar_samples(now, slave_facet, overlap);
    const Table dual    = dual_functions(nodes, samples);
    for (const auto &sample : samples)
      {
        const EdgeShapes<Number> shape(slave.degree, sample.xi);
        const EdgeShapes<Number> projection(master.degree, sample.master_xi);
        const auto              &m_edge = master.facets[sample.master_facet];
        const Number             metric = length(
          MortarGeometry<Number>::at(now.master_x, m_edge, projection.first));

        const Tensor<1, 2, Number> distance =
          MortarGeometry<Number>::at(now.slave_x, edge, shape.value) -
          MortarGeometry<Number>::at(now.master_x, m_edge, projection.value);

        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const unsigned int node = edge.nodes[nodes[k]];
            if (only != numbers::invalid_unsigned_int && node != only)
              continue;
            Number phi = 0, power = 1;
            for (unsigned int i = 0; i < nodes.size(); ++i)
              {
                phi += dual[k][i] * power;
                power *= sample.xi;
              }
            phi *= sample.weight;

            OfNode &of_node = of_nodes[node];
            of_node.weight += phi;
            for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
              of_node.slave[edge.nodes[a]] += phi * shape.value[a];
            for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
              {
                of_node.master[m_edge.nodes[a]] += phi * projection.value[a];
                of_node.shift[m_edge.nodes[a]] +=
                  phi * projection.first[a] / metric;
              }
            of_node.distances.push_back(distance);
            add_normals(slave_facet, nodes[k], sample, phi, of_node);
          }
      }
  }



  template<typename Number>
  void MortarIntegrals<Number>::add_normals(const unsigned int slave_facet,
                                            const unsigned int a,
                                            const MortarSample<Number> &sample,
                                            const Number               &phi,
                                            OfNode &integrals) const
  {
    const auto              &edge = master.facets[sample.master_facet];
    const EdgeShapes<Number> projection(master.degree, sample.master_xi);
    Tensor<1, 2, Number>     normal;
    Number                   turn_square = 0;
    for (unsigned int b = 0; b < master.n_nodes_per_edge(); ++b)
      {
        normal +=
          projection.value[b] * now.master_normals[sample.master_facet][b];
        // Beyond a corner is another face, or none: that it is seen, its normal
        // tells.
        if (b == 2 || !(edge.is_feature[b] || edge.ends_surface(b)))
          turn_square += absolute(projection.value[b]) *
                         square(master.turning_angles[edge.nodes[b]]);
      }
    const Number size = absolute(phi);
    integrals.slave_normal += phi * now.slave_normals[slave_facet][a];
    integrals.master_normal += phi * normal;
    integrals.magnitude += size;
    integrals.master_turn += size * turn_square;
    integrals.master_square += size * square_of(normal);
    integrals.master_mean += size * normal;
    integrals.master_edges[sample.master_facet] += value_of(size);
  }



  template<typename Number>
  Tensor<1, 2, Number>
  MortarIntegrals<Number>::direction(const unsigned int node,
                                     const OfNode      &integrals) const
  {
    const auto normalized = [](const Tensor<1, 2, Number> &a) {
      const Number         size = length(a);
      Tensor<1, 2, Number> unit = a;
      unit /= size;
      return unit;
    };
    const Tensor<1, 2, Number> n_s = normalized(integrals.slave_normal);
    // Flat, but for the digits of a mesh file [rad].
    const double flat = 1e-3;
    if (slave.turning_angles[node] < flat ||
        value_of(integrals.master_normal).norm_square() == 0)
      return n_s;

    // Of the master the turn between its nodes and what its normals differ by.
    Number master_square =
      (integrals.master_turn + integrals.master_square -
       square_of(integrals.master_mean) / integrals.magnitude) /
      integrals.magnitude;
    if (value_of(master_square) < 0)
      master_square = 0;
    const Tensor<1, 2, Number> n_m = normalized(integrals.master_normal);
    const Number slave_square      = square(slave.turning_angles[node]);
    const Tensor<1, 2, Number> sum = master_square * n_s + slave_square * n_m;
    if (value_of(sum) * value_of(n_s) <= 0)
      return n_s;
    Tensor<1, 2, Number> n = normalized(sum);
    for (const unsigned int e : slave.facets_of_node[node])
      for (unsigned int a = 0; a < 2; ++a)
        if (slave.facets[e].nodes[a] == node)
          n = now.symmetric(n, e, a);
    return n;
  }



  template<typename Number>
  Number
  MortarIntegrals<Number>::excess(const unsigned int           node,
                                  const OfNode                &integrals,
                                  const MortarPairing<Number> &pairing) const
  {
    Number gap = 0, smallest = std::numeric_limits<double>::max();
    for (const auto &[a, c] : pairing.slave)
      gap += c * (now.slave_x[a] * pairing.normal);
    for (const auto &[m, c] : pairing.master)
      gap += c * (now.master_x[m] * pairing.normal);
    for (const auto &distance : integrals.distances)
      {
        const Number along = distance * pairing.normal;
        if (value_of(along) < value_of(smallest))
          smallest = along;
      }
    // A ten-thousandth of an edge is left to the mean: flat surfaces that touch
    // are as uneven as that.
    const double slack =
      1e-4 * slave.reference_length(slave.facets_of_node[node].front());
    const Number excess = gap - smallest + slack;
    return value_of(excess) < 0 ? excess : Number(0);
  }



  template<typename Number>
  MortarPairing<Number>
  MortarIntegrals<Number>::pairing(const unsigned int node) const
  {
    MortarPairing<Number> pairing;
    const auto            found = of_nodes.find(node);
    if (found == of_nodes.end() || value_of(found->second.weight) <= 0)
      return pairing;

    const OfNode &integrals = found->second;
    pairing.facing          = true;
    pairing.weight          = integrals.weight;
    pairing.normal          = direction(node, integrals);
    pairing.master_facet    = largest(integrals.master_edges);

    // The offset of the projections along the tangent, and how far a unit of
    // shift carries them.
    Number     offset = 0, reach = 0;
    const auto along = [&](const Tensor<1, 2, Number> &x) {
      return Number(pairing.normal[0] * x[1] - pairing.normal[1] * x[0]);
    };
    for (const auto &[a, integral] : integrals.slave)
      offset += integral * along(now.slave_x[a]);
    for (const auto &[m, integral] : integrals.master)
      {
        offset -= integral * along(now.master_x[m]);
        reach += integrals.shift.at(m) * along(now.master_x[m]);
      }
    const Number shift = offset / reach;

    for (const auto &[a, integral] : integrals.slave)
      {
        const Number c = integral / integrals.weight;
        // Biorthogonality leaves round-off where the coefficient is zero.
        if (a == node || std::abs(value_of(c)) > mortar_round_off)
          pairing.slave[a] = c;
      }
    for (const auto &[m, integral] : integrals.master)
      {
        const Number c =
          -(integral + shift * integrals.shift.at(m)) / integrals.weight;
        if (std::abs(value_of(c)) > mortar_round_off)
          pairing.master[m] = c;
      }
    pairing.excess = excess(node, integrals, pairing);
    return pairing;
  }



  template class MortarIntegrals<double>;
  template class MortarIntegrals<WithDerivatives>;
} // namespace Contact
