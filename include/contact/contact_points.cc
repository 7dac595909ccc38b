/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/contact_points.h"

#include <deal.II/base/quadrature_lib.h>

namespace Contact
{
  namespace
  {
    /// Fill in the slave side of a point at @p xi of the slave edge @p e.
    ContactPoint
    make_point(const Surface &slave, const unsigned int e, const double xi)
    {
      const EdgeShape shape(slave.degree, xi);

      ContactPoint point;
      point.slave_edge = e;
      point.slave_xi   = xi;
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        if (shape.value[a] != 0)
          point.add_node(slave.nodes[slave.edges[e].nodes[a]],
                         shape.value[a],
                         0,
                         0);
      point.n_slave_nodes = point.n_nodes;
      return point;
    }



    /// Whether supports leave one of the first @p n_nodes nodes of a point free
    /// to move along @p normal, other than by round-off of its coefficient.
    bool is_free_along(const ContactPoint      &point,
                       const unsigned int       n_nodes,
                       const Tensor<1, 2>      &normal,
                       const Discretization<2> &discretization)
    {
      const double round_off = 1e-8;
      double       free = 0, all = 0;
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          {
            const double share = std::abs(point.C[a] * normal[i]);
            all += share;
            if (!discretization.is_fixed(point.dofs[a][i]))
              free += share;
          }
      return free > round_off * all;
    }



    /// Scalar products of the normal and the tangential row of a point over the
    /// unknowns that no support fixes.
    struct FreeRows
    {
      FreeRows(const ContactPoint      &point,
               const Discretization<2> &discretization)
      {
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            if (!discretization.is_fixed(point.dofs[a][i]))
              {
                nn += std::pow(point.C[a] * point.normal[i], 2);
                tt += std::pow(point.C[a] * point.tangent[i], 2);
                nt +=
                  point.C[a] * point.C[a] * point.normal[i] * point.tangent[i];
              }
      }

      /// Below this sine of the angle between the rows their two multipliers
      /// would be told apart by the round-off of the pairing alone.
      bool are_parallel() const
      {
        const double sine = 1e-3;
        return tt * nn - nt * nt <= sine * sine * nn * nn;
      }

      double nn = 0, nt = 0, tt = 0;
    };



    Point<2> slave_position(const ContactPoint &point, const Vector<double> &u)
    {
      Point<2> x;
      for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          x[i] += point.C[a] * (point.X[a][i] + u[point.dofs[a][i]]);
      return x;
    }
  } // namespace



  void PointPairing::add_node(const Surface::Node &node,
                              const double         c,
                              const double         c1,
                              const double         c2)
  {
    ++n_nodes;
    dofs.push_back(node.dofs);
    X.push_back(node.X);
    C.push_back(c);
    C1.push_back(c1);
    C2.push_back(c2);
  }



  void PointPairing::keep_nodes(const unsigned int n)
  {
    n_nodes = n;
    dofs.resize(n);
    X.resize(n);
    for (auto *values : {&C, &C1, &C2})
      values->resize(n);
  }



  void PointPairing::remove_node(const unsigned int n)
  {
    --n_nodes;
    dofs.erase(dofs.begin() + n);
    X.erase(X.begin() + n);
    for (auto *values : {&C, &C1, &C2})
      values->erase(values->begin() + n);
  }



  bool tangential_row_is_void(const ContactPoint      &point,
                              const Discretization<2> &discretization)
  {
    return FreeRows(point, discretization).are_parallel();
  }



  double prescribed_slip(const ContactPoint      &point,
                         const Discretization<2> &discretization,
                         const Vector<double>    &motion)
  {
    const FreeRows rows(point, discretization);
    if (!rows.are_parallel())
      return 0;
    const Tensor<1, 2> along =
      point.tangent - (rows.nn > 0 ? rows.nt / rows.nn : 0.) * point.normal;
    double slip = 0, size = 0;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        if (discretization.is_fixed(point.dofs[a][i]))
          {
            const double share =
              point.C[a] * along[i] * motion[point.dofs[a][i]];
            slip += share;
            size += std::abs(share);
          }
    const double round_off = 1e-10;
    return std::abs(slip) > round_off * size ? slip : 0.;
  }



  std::vector<ContactPoint>
  make_nodal_points(const Surface                &slave,
                    const std::set<unsigned int> &excluded,
                    MultiplierSpace              &multipliers)
  {
    multipliers.of_node.assign(slave.nodes.size(),
                               numbers::invalid_unsigned_int);
    multipliers.n_multipliers = 0;

    std::vector<ContactPoint>   points;
    const std::array<double, 3> centroids =
      slave.degree == 1 ? std::array<double, 3>{{-1. / 3, 1. / 3, 0}}
                        : node_coordinates;
    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const unsigned int node = slave.edges[e].nodes[a];
          if (excluded.count(node) > 0)
            continue;

          if (multipliers.of_node[node] == numbers::invalid_unsigned_int)
            {
              multipliers.of_node[node] = multipliers.n_multipliers++;
              points.push_back(make_point(slave, e, node_coordinates[a]));
              points.back().n_multipliers  = 1;
              points.back().multipliers[0] = multipliers.of_node[node];
              points.back().psi[0]         = 1;
              points.back().weight         = 0;
            }

          // The share of this edge in the integral of the shape function.
          const double share =
            slave.degree == 1 ? 1. : (a == 2 ? 4. / 3. : 1. / 3.);
          points[multipliers.of_node[node]].weight +=
            share *
            slave.reference_jacobian(slave.edges[e],
                                     EdgeShape(slave.degree, centroids[a]));
        }

    // On an axis at degree 2 the integral vanishes. The node has a gap all the
    // same, and may take a force: as if on the half of the edge next to it the
    // pressure were linear.
    for (ContactPoint &point : points)
      if (point.weight <=
          1e-12 * slave.reference_jacobian(slave.edges[point.slave_edge],
                                           EdgeShape(slave.degree, 0)))
        point.weight =
          0.5 * slave.reference_jacobian(slave.edges[point.slave_edge],
                                         EdgeShape(slave.degree,
                                                   point.slave_xi * 2. / 3));
    return points;
  }



  std::vector<ContactPoint> make_gauss_points(const Surface     &slave,
                                              const unsigned int n_points,
                                              MultiplierSpace   &multipliers)
  {
    multipliers.of_node.resize(slave.nodes.size());
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      multipliers.of_node[i] = i;
    multipliers.n_multipliers = slave.nodes.size();

    const QGauss<1>           quadrature(n_points);
    std::vector<ContactPoint> points;
    for (unsigned int e = 0; e < slave.edges.size(); ++e)
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const double    xi = 2 * quadrature.point(q)[0] - 1;
          const EdgeShape shape(slave.degree, xi);

          points.push_back(make_point(slave, e, xi));
          ContactPoint &point = points.back();
          point.weight        = 2 * quadrature.weight(q) *
                         slave.reference_jacobian(slave.edges[e], shape);
          point.n_multipliers = slave.n_nodes_per_edge();
          for (unsigned int a = 0; a < point.n_multipliers; ++a)
            {
              point.multipliers[a] = slave.edges[e].nodes[a];
              point.psi[a]         = shape.value[a];
            }
        }
    return points;
  }



  NormalCone
  directions_of(const ContactPoint                                    &point,
                const Surface                                         &slave,
                const std::vector<Surface::PerEdgeNode<Tensor<1, 2>>> &normals)
  {
    const auto     &edge = slave.edges[point.slave_edge];
    const EdgeShape shape(slave.degree, point.slave_xi);
    Tensor<1, 2>    n;
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      n += shape.value[a] * normals[point.slave_edge][a];
    n /= n.norm();

    NormalCone directions{n, n};
    directions.reach =
      SurfaceSearch::overhang * slave.reference_length(point.slave_edge);
    if (point.slave_xi == -1)
      {
        directions.at_end = edge.begins_surface;
        if (!edge.begins_surface)
          directions.first = normals[edge.previous][1];
      }
    else if (point.slave_xi == 1)
      {
        directions.at_end = edge.ends_surface;
        if (!edge.ends_surface)
          directions.last = normals[edge.next][0];
      }
    return directions;
  }



  namespace
  {
    /// The master side of a point at its projection on an edge. Returns the
    /// tangent.
    Tensor<1, 2> add_master(ContactPoint         &point,
                            const Surface        &master,
                            const unsigned int    edge,
                            const double          xi,
                            const Vector<double> &u)
    {
      const EdgeShape shape(master.degree, xi);
      Tensor<1, 2>    along;
      for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
        {
          const unsigned int node = master.edges[edge].nodes[a];
          point.add_node(master.nodes[node],
                         -shape.value[a],
                         -shape.first[a],
                         -shape.second[a]);
          along += shape.first[a] * master.position(node, u);
        }
      return along;
    }



    /// The edge that the vertex at the projection belongs to as well, and which
    /// has another direction.
    unsigned int other_edge(const Projection    &projection,
                            const SurfaceSearch &search)
    {
      if (projection.twin == numbers::invalid_unsigned_int)
        return projection.twin;
      const double side = projection.xi > 0 ? 1 : -1;
      // Of unit normals; less is round-off.
      return (search.normal(projection.edge, side) -
              search.normal(projection.twin, -side))
                   .norm() > 1e-8
               ? projection.twin
               : numbers::invalid_unsigned_int;
    }



    /// The projection at the vertex of two edges: the sum of their tangents,
    /// whose nodes come in the order of the chain.
    Tensor<1, 2> add_vertex(ContactPoint         &point,
                            const Surface        &master,
                            const unsigned int    other,
                            const Vector<double> &u)
    {
      const double side = point.master_xi > 0 ? 1 : -1;
      point.master_xi   = side;
      Tensor<1, 2> along =
        add_master(point, master, point.master_edge, side, u);

      const unsigned int n_before = point.n_nodes;
      along += add_master(point, master, other, -side, u);
      // The vertex is in both.
      const unsigned int at_first = point.n_slave_nodes + (side > 0 ? 1 : 0);
      const unsigned int at_other = n_before + (side > 0 ? 0 : 1);
      point.C1[at_first] += point.C1[at_other];
      point.remove_node(at_other);
      return along;
    }
  } // namespace



  void skip_where_held(ContactPoint            &point,
                       const Discretization<2> &discretization,
                       const Vector<double>    &u)
  {
    if (is_free_along(point, point.n_nodes, point.normal, discretization))
      return;
    double gap = 0, size = 0;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      {
        for (unsigned int i = 0; i < 2; ++i)
          gap += point.C[a] * point.normal[i] *
                 (point.X[a][i] + u[point.dofs[a][i]]);
        size = std::max(size, point.X[a].distance(point.X[0]));
      }
    point.facing = point.facing && gap < -1e-8 * size;
  }



  void pair_with_master(ContactPoint            &point,
                        const NormalCone        &directions,
                        const Surface           &master,
                        const SurfaceSearch     &search,
                        const Discretization<2> &discretization,
                        const Vector<double>    &u,
                        const bool               keeps_edge)
  {
    const Point<2> x = slave_position(point, u);
    Projection     projection;
    if (keeps_edge && point.facing)
      projection =
        search.project(x, point.master_edge, SurfaceSearch::overhang);
    if (!keeps_edge || !point.facing || projection.clipped)
      projection = search.closest_facing(x, directions);
    const double beyond = (std::abs(projection.xi) - 1) / 2 *
                          master.reference_length(projection.edge);
    point.facing      = !projection.off_the_end && beyond <= directions.reach;
    point.master_edge = projection.edge;
    point.master_xi   = projection.xi;

    point.keep_nodes(point.n_slave_nodes);
    const unsigned int other     = other_edge(projection, search);
    const bool         at_vertex = other != numbers::invalid_unsigned_int;
    const Tensor<1, 2> along =
      at_vertex ? add_vertex(point, master, other, u)
                : add_master(point, master, projection.edge, projection.xi, u);
    point.projection_is_clipped = projection.clipped || at_vertex;

    // The body lies to the left of the edge: n is along, turned by -90
    // degrees, and along is n turned by +90.
    point.metric  = along.norm();
    point.tangent = along / point.metric;
    point.normal  = Tensor<1, 2>({point.tangent[1], -point.tangent[0]});

    skip_where_held(point, discretization, u);
    point.tangential_row_is_void =
      tangential_row_is_void(point, discretization);
  }



  // A node that a support holds against the obstacle needs no pressure, and
  // there would be no unknown for it to act on. Along the tangent the place of
  // a circle is centre + radius n, and its second derivative by the coordinate
  // that is the angle -radius n.
  void pair_with_obstacle(ContactPoint            &point,
                          const Obstacle          &obstacle,
                          const Discretization<2> &discretization,
                          const Vector<double>    &u)
  {
    const auto projection = obstacle.closest_point(slave_position(point, u));
    point.facing          = is_free_along(point,
                                 point.n_slave_nodes,
                                 projection.normal,
                                 discretization);
    point.master_edge     = numbers::invalid_unsigned_int;
    point.projection      = projection.x;
    point.normal          = projection.normal;
    point.tangent = Tensor<1, 2>({-projection.normal[1], projection.normal[0]});
    point.metric  = projection.radius == 0 ? 1 : std::abs(projection.radius);
    point.projection_curvature = -projection.radius * projection.normal;
    point.tangential_row_is_void =
      tangential_row_is_void(point, discretization);
  }
} // namespace Contact
