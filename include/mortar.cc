/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mortar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  namespace
  {
    const unsigned int none = numbers::invalid_unsigned_int;

    /// Of coordinates and coefficients, which are of the order of one.
    const double round_off = 1e-11;

    /// Coordinates of the nodes of an edge: first, last, middle.
    const std::array<double, 3> node_coordinates{{-1, 1, 0}};

    /// The node that a point belongs to, by its number in the slave edge.
    unsigned int node_in_edge(const ContactPoint &point)
    {
      return std::find(node_coordinates.begin(),
                       node_coordinates.end(),
                       point.slave_xi) -
             node_coordinates.begin();
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



  MortarRule::MortarRule(const Surface                &slave,
                         const Surface                &master,
                         const Discretization         &discretization,
                         const std::set<unsigned int> &excluded)
    : slave(slave)
    , master(master)
    , discretization(discretization)
    , carries(slave.edges.size())
  {
    const Vector<double> at_rest(discretization.dof_handler.n_dofs());
    const auto           normals = slave.edge_normals(at_rest);
    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const unsigned int node = slave.edges[e].nodes[a];
          carries[e][a] =
            excluded.count(node) == 0 &&
            free_part(normals[e][a], slave.nodes[node], discretization)
                .norm_square() > 0.5;
        }
  }



  std::vector<ContactPoint>
  MortarRule::make_points(MultiplierSpace &multipliers) const
  {
    multipliers.of_node.assign(slave.nodes.size(), none);
    multipliers.n_multipliers = 0;

    std::vector<ContactPoint> points;
    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const unsigned int node = slave.edges[e].nodes[a];
          if (!carries[e][a] || multipliers.of_node[node] != none)
            continue;
          multipliers.of_node[node] = multipliers.n_multipliers++;

          ContactPoint point;
          point.slave_edge     = e;
          point.slave_xi       = node_coordinates[a];
          point.master_edge    = 0;
          point.weight         = 0;
          point.n_multipliers  = 1;
          point.multipliers[0] = multipliers.of_node[node];
          point.psi[0]         = 1;
          point.add_node(slave.nodes[node], 1, 0, 0);
          point.n_slave_nodes = 1;
          points.push_back(point);
        }
    return points;
  }



  bool MortarRule::pair(const ArrayView<ContactPoint> &points,
                        const Vector<double>          &u) const
  {
    const MortarSegments   now(slave, master, discretization, u);
    std::vector<Integrals> integrals(slave.nodes.size());
    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      {
        const MortarOverlap facing = now.overlap(e);
        if (!facing.samples.empty())
          integrate_edge(now, e, facing, integrals);
      }

    bool changed = false;
    for (ContactPoint &point : points)
      {
        const auto old_dofs = point.dofs;
        fill_in(now, integrals[slave_node(point)], point);
        changed = changed || point.dofs != old_dofs;
      }
    return changed;
  }



  unsigned int MortarRule::slave_node(const ContactPoint &point) const
  {
    return slave.edges[point.slave_edge].nodes[node_in_edge(point)];
  }



  // Where an edge faces the master in part, the nodes beyond the parts have no
  // dual function; if that would be all, the nearest one has, or both if they
  // are as near. On an edge of degree 2 with a hole, the integrals of its shape
  // functions may be negative, those of linear ones are not: there the middle
  // has one only if no end has.
  std::vector<unsigned int>
  MortarRule::carrying_nodes(const unsigned int   slave_edge,
                             const MortarOverlap &overlap) const
  {
    std::vector<unsigned int> candidates, nodes;
    double                    nearest = std::numeric_limits<double>::max();
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      if (carries[slave_edge][a])
        {
          candidates.push_back(a);
          nearest = std::min(nearest, overlap.distance(node_coordinates[a]));
        }
    // The pressures of an edge are others with another set of nodes: where
    // both surfaces end at the same place, the set must not depend on which way
    // they deform.
    for (const unsigned int a : candidates)
      if (overlap.distance(node_coordinates[a]) <=
          nearest + SurfaceSearch::overhang)
        nodes.push_back(a);
    const bool all_seen = overlap.parts.size() == 1 && nearest < round_off;
    if (!all_seen && nodes.size() > 1 && nodes.back() == 2)
      nodes.pop_back();
    return nodes;
  }



  // A node without a dual function leaves its shape function to the nearest
  // node that has one; one in the middle, to both ends. The functions still sum
  // up to one, and their integrals are positive, which those of the linear
  // functions on two of three nodes are not.
  std::vector<double>
  MortarRule::test_functions(const std::vector<unsigned int> &nodes,
                             const EdgeShape                 &shape) const
  {
    std::vector<double> values(nodes.size());
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
  FullMatrix<double>
  MortarRule::dual_functions(const std::vector<unsigned int> &nodes,
                             const MortarOverlap             &overlap) const
  {
    const unsigned int n = nodes.size();
    FullMatrix<double> moments(n, n), coefficients(n, n);
    Vector<double>     integrals(n);
    for (const MortarSample &sample : overlap.samples)
      {
        const auto test =
          test_functions(nodes, EdgeShape(slave.degree, sample.xi));
        for (unsigned int j = 0; j < n; ++j)
          {
            integrals[j] += sample.weight * test[j];
            for (unsigned int i = 0; i < n; ++i)
              moments(i, j) += sample.weight * std::pow(sample.xi, i) * test[j];
          }
      }

    // a M = diag(integrals)
    moments.gauss_jordan();
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = 0; i < n; ++i)
        coefficients(k, i) = integrals[k] * moments(k, i);
    return coefficients;
  }



  void MortarRule::integrate_edge(const MortarSegments   &now,
                                  const unsigned int      slave_edge,
                                  const MortarOverlap    &overlap,
                                  std::vector<Integrals> &integrals) const
  {
    const auto &edge  = slave.edges[slave_edge];
    const auto  nodes = carrying_nodes(slave_edge, overlap);
    if (nodes.empty())
      return;

    const auto dual = dual_functions(nodes, overlap);
    for (const MortarSample &sample : overlap.samples)
      {
        const EdgeShape shape(slave.degree, sample.xi);
        const EdgeShape foot(master.degree, sample.master_xi);
        const auto     &m_edge = master.edges[sample.master_edge];
        const double    metric =
          MortarSegments::at(now.master_x, m_edge, foot.first).norm();

        const Tensor<1, 2> distance =
          MortarSegments::at(now.slave_x, edge, shape.value) -
          MortarSegments::at(now.master_x, m_edge, foot.value);

        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            double phi = 0;
            for (unsigned int i = 0; i < nodes.size(); ++i)
              phi += dual(k, i) * std::pow(sample.xi, i);
            phi *= sample.weight;

            Integrals &of_node = integrals[edge.nodes[nodes[k]]];
            of_node.weight += phi;
            for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
              of_node.slave[edge.nodes[a]] += phi * shape.value[a];
            for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
              {
                of_node.master[m_edge.nodes[a]] += phi * foot.value[a];
                of_node.shift[m_edge.nodes[a]] += phi * foot.first[a] / metric;
              }
            of_node.distances.push_back(distance);
            add_normals(now, slave_edge, nodes[k], sample, phi, of_node);
          }
      }
  }



  void MortarRule::add_normals(const MortarSegments &now,
                               const unsigned int    slave_edge,
                               const unsigned int    a,
                               const MortarSample   &sample,
                               const double          phi,
                               Integrals            &integrals) const
  {
    const auto     &edge = master.edges[sample.master_edge];
    const EdgeShape foot(master.degree, sample.master_xi);
    Tensor<1, 2>    normal;
    double          turn_square = 0;
    for (unsigned int b = 0; b < master.n_nodes_per_edge(); ++b)
      {
        normal += foot.value[b] * now.master_normals[sample.master_edge][b];
        // Beyond a corner is another face, or none: that it is seen, its normal
        // tells.
        if (b == 2 || !(edge.corner[b] ||
                        (b == 0 ? edge.begins_surface : edge.ends_surface)))
          turn_square +=
            std::abs(foot.value[b]) * std::pow(master.turns[edge.nodes[b]], 2);
      }
    const double size = std::abs(phi);
    integrals.slave_normal += phi * now.slave_normals[slave_edge][a];
    integrals.master_normal += phi * normal;
    integrals.magnitude += size;
    integrals.master_turn += size * turn_square;
    integrals.master_square += size * normal.norm_square();
    integrals.master_mean += size * normal;
    integrals.master_edges[sample.master_edge] += size;
  }



  Tensor<1, 2> MortarRule::direction(const unsigned int node,
                                     const Integrals   &integrals) const
  {
    const Tensor<1, 2> n_s =
      integrals.slave_normal / integrals.slave_normal.norm();
    // Flat, but for the digits of a mesh file [rad].
    const double flat = 1e-3;
    if (slave.turns[node] < flat || integrals.master_normal.norm() == 0)
      return n_s;

    // Of the master the turn between its nodes and what its normals differ by.
    const double size = integrals.magnitude;
    const double master_square =
      (integrals.master_turn + integrals.master_square -
       integrals.master_mean.norm_square() / size) /
      size;
    const Tensor<1, 2> n_m =
      integrals.master_normal / integrals.master_normal.norm();
    const Tensor<1, 2> n = free_part(std::max(0., master_square) * n_s +
                                       std::pow(slave.turns[node], 2) * n_m,
                                     slave.nodes[node],
                                     discretization);
    return n.norm_square() == 0 || n * n_s <= 0 ? n_s : n / n.norm();
  }



  // By how much the weighted gap is below all distances that it is a mean of.
  double MortarRule::excess(const MortarSegments &now,
                            const unsigned int    slave_edge,
                            const Integrals      &integrals,
                            const double          shift,
                            const Tensor<1, 2>   &normal) const
  {
    double gap = 0, smallest = std::numeric_limits<double>::max();
    for (const auto &[a, integral] : integrals.slave)
      gap += integral / integrals.weight * (now.slave_x[a] * normal);
    for (const auto &[m, integral] : integrals.master)
      gap -= (integral + shift * integrals.shift.at(m)) / integrals.weight *
             (now.master_x[m] * normal);
    for (const Tensor<1, 2> &distance : integrals.distances)
      smallest = std::min(smallest, distance * normal);
    // Of less than a hundredth of an edge, which counts as touching elsewhere,
    // the moment of the shear would be more than that of the gap.
    const double slack = 0.01 * slave.reference_length(slave_edge);
    return smallest - gap > slack ? gap - smallest : 0.;
  }



  void MortarRule::fill_in(const MortarSegments &now,
                           const Integrals      &integrals,
                           ContactPoint         &point) const
  {
    const unsigned int node = slave_node(point);
    point.facing            = integrals.weight > 0;
    point.weight            = integrals.weight;
    point.normal            = point.facing
                                ? direction(node, integrals)
                                : now.slave_normals[point.slave_edge][node_in_edge(point)];
    point.tangent           = Tensor<1, 2>({-point.normal[1], point.normal[0]});
    point.metric            = 1;
    point.keep_nodes(0);
    if (!point.facing)
      {
        // Only to keep the equation of its multiplier, which is zero. In the
        // middle of the edge, which is never on an axis.
        point.weight = slave.reference_jacobian(slave.edges[point.slave_edge],
                                                EdgeShape(slave.degree, 0));
        point.add_node(slave.nodes[node], 1, 0, 0);
        point.n_slave_nodes = 1;
        return;
      }

    point.master_edge = largest(integrals.master_edges);

    // The offset of the feet along the tangent, and how far a unit of shift
    // carries them.
    const double weight = integrals.weight;
    double       offset = 0, reach = 0;
    for (const auto &[a, integral] : integrals.slave)
      offset += integral * (now.slave_x[a] * point.tangent);
    for (const auto &[m, integral] : integrals.master)
      {
        offset -= integral * (now.master_x[m] * point.tangent);
        reach += integrals.shift.at(m) * (now.master_x[m] * point.tangent);
      }
    const double shift = offset / reach;

    point.add_node(slave.nodes[node], integrals.slave.at(node) / weight, 0, 0);
    const auto add = [&](const Surface::Node &node, const double c) {
      // Biorthogonality leaves round-off where the coefficient is zero.
      if (std::abs(c) > round_off)
        point.add_node(node, c, 0, 0);
    };
    for (const auto &[a, integral] : integrals.slave)
      if (a != node)
        add(slave.nodes[a], integral / weight);
    point.n_slave_nodes = point.n_nodes;
    for (const auto &[m, integral] : integrals.master)
      add(master.nodes[m],
          -(integral + shift * integrals.shift.at(m)) / weight);

    point.foot =
      Point<2>(excess(now, point.slave_edge, integrals, shift, point.normal) *
               point.normal);

    // The node itself has to be free to stick.
    point.tangential_row_is_void = discretization.is_fixed(point.dofs[0][0]) ||
                                   discretization.is_fixed(point.dofs[0][1]);
  }
} // namespace Contact
