/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_mortar.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

namespace Contact
{
  namespace
  {
    /// The parts of a facet that are projected as quadrangles: one, or at
    /// degree 2 four. Their corners are nodes of the facet.
    struct Part
    {
      std::array<unsigned int, 4> corners;
      Point<2>                    middle; // in the coordinates of the facet
      double                      scale;  // of the coordinates of the part
    };

    const std::vector<Part> &parts_of_facet(const unsigned int degree)
    {
      static const std::vector<Part> one{{{{0, 1, 2, 3}}, Point<2>(), 1}};
      static const std::vector<Part> four{
        {{{0, 6, 4, 8}}, Point<2>(-0.5, -0.5), 0.5},
        {{{6, 1, 8, 5}}, Point<2>(0.5, -0.5), 0.5},
        {{{4, 8, 2, 7}}, Point<2>(-0.5, 0.5), 0.5},
        {{{8, 5, 7, 3}}, Point<2>(0.5, 0.5), 0.5}};
      return degree == 1 ? one : four;
    }



    PlaneQuadrangle project(const ProjectionPlane               &plane,
                            const Part                          &part,
                            const PerFacetNode<3, unsigned int> &nodes,
                            const std::vector<Point<3>>         &x)
    {
      PlaneQuadrangle quadrangle;
      for (unsigned int a = 0; a < 4; ++a)
        quadrangle[a] = plane.project(x[nodes[part.corners[a]]]);
      return quadrangle;
    }



    bool is_parallelogram(const PlaneQuadrangle &q)
    {
      const double round_off = 1e-10;
      return ((q[3] - q[2]) - (q[1] - q[0])).norm() <=
             round_off * (q[3] - q[0]).norm();
    }



    /// The Gauss points of a triangle. Of parallelograms products of two shape
    /// functions are polynomials, and integrated exactly; of others they are
    /// quotients.
    const Quadrature<2> &rule(const unsigned int degree, const bool polynomial)
    {
      static const QWitherdenVincentSimplex<2> linear(3), quadratic(5), most(7);
      return !polynomial ? most : degree == 1 ? linear : quadratic;
    }



    /// The determinant of the bilinear map of a quadrangle.
    double jacobian(const PlaneQuadrangle &q, const Point<2> &xi)
    {
      const FacetShape<3> shape(1, xi);
      Tensor<1, 2>        a, b;
      for (unsigned int k = 0; k < 4; ++k)
        {
          a += shape.first[0][k] * q[k];
          b += shape.first[1][k] * q[k];
        }
      return std::abs(a[0] * b[1] - a[1] * b[0]);
    }



    /// The largest angle between a facet at a node and the mean there.
    std::vector<double> bends(const Surface<3>        &surface,
                              const Discretization<3> &discretization)
    {
      const Vector<double>   undeformed(discretization.dof_handler.n_dofs());
      const auto             means = surface.facet_normals(undeformed);
      const SurfaceSearch<3> search(surface, undeformed);
      std::vector<double>    bends(surface.nodes.size(), 0.);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          {
            const Tensor<1, 3> own  = search.normal(e, node_place<3>(a));
            double            &bend = bends[surface.facets[e].nodes[a]];
            bend = std::max(bend, (own - means[e][a]).norm());
          }
      return bends;
    }
  } // namespace



  struct MortarDiscretization<3>::Configuration
  {
    Configuration(const Surface<3>     &slave,
                  const Surface<3>     &master,
                  const Vector<double> &u)
      : slave_normals(slave.facet_normals(u))
      , master_normals(master.facet_normals(u))
      , slave_search(slave, u)
      , search(master, u)
    {
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        slave_x.push_back(slave.position(i, u));
      for (unsigned int i = 0; i < master.nodes.size(); ++i)
        master_x.push_back(master.position(i, u));
    }

    std::vector<Point<3>>  slave_x, master_x;
    FacetNormals<3>        slave_normals, master_normals;
    const SurfaceSearch<3> slave_search, search;
  };



  MortarDiscretization<3>::MortarDiscretization(
    const Surface<3>             &slave,
    const Surface<3>             &master,
    const Discretization<3>      &discretization,
    const std::set<unsigned int> &excluded)
    : slave(slave)
    , master(master)
    , discretization(discretization)
    , excluded(excluded)
    , slave_bends(bends(slave, discretization))
    , master_bends(bends(master, discretization))
  {
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
                                     const Vector<double>             &u,
                                     const bool) const
  {
    const Configuration        now(slave, master, u);
    std::vector<NodeIntegrals> of_nodes(slave.nodes.size());
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      integrate(e, gauss_points(e, now), now, of_nodes);

    bool changed = false;
    for (ContactPoint<3> &point : points)
      {
        const auto         old_dofs = point.dofs;
        const unsigned int node     = slave_node(point);
        fill_in(of_nodes[node], node, now, u, point);
        changed = changed || point.dofs != old_dofs;
      }
    return changed;
  }



  // The master facets that face a slave facet are in its box, widened by the
  // distance of the surfaces there.
  std::vector<MortarDiscretization<3>::GaussPoint>
  MortarDiscretization<3>::gauss_points(const unsigned int   e,
                                        const Configuration &now) const
  {
    const auto           &nodes = slave.facets[e].nodes;
    std::vector<Point<3>> x;
    for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
      x.push_back(now.slave_x[nodes[a]]);
    const Tensor<1, 3> normal = now.slave_search.normal(e, Point<2>());
    NormalCone<3>      directions;
    directions.normals = {normal};

    double distance = 0;
    for (const Point<3> &corner : x)
      {
        const Projection<3> foot =
          now.search.closest_facing(corner, directions);
        distance =
          std::max(distance,
                   std::sqrt(now.search.distance_square(corner, foot)));
      }
    BoundingBox<3> box(x);
    box.extend(distance + 0.1 * slave.reference_length(e));
    std::vector<GaussPoint> points;
    for (const unsigned int m : now.search.facets_in(box))
      if (directions.faces(now.search.normal(m, Point<2>())))
        add_segment(e, m, now, points);
    discretization.counters.projections += points.size();
    return points;
  }



  void
  MortarDiscretization<3>::add_segment(const unsigned int       e,
                                       const unsigned int       m,
                                       const Configuration     &now,
                                       std::vector<GaussPoint> &points) const
  {
    const auto             &own = slave.facets[e], &other = master.facets[m];
    const SurfaceSearch<3> &search = now.slave_search;
    Projection<3>           centre;
    centre.facet = e;
    const ProjectionPlane plane(search.position(centre),
                                search.normal(e, Point<2>()));
    for (const Part &part : parts_of_facet(slave.degree))
      for (const Part &other_part : parts_of_facet(master.degree))
        {
          const auto s = project(plane, part, own.nodes, now.slave_x);
          const auto t = project(plane, other_part, other.nodes, now.master_x);
          const Quadrature<2> &quadrature =
            rule(std::max(slave.degree, master.degree),
                 is_parallelogram(s) && is_parallelogram(t));
          for (const PlaneTriangle &triangle : intersection(s, t))
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const Point<2> &eta = quadrature.point(q);
                const Point<2>  place(triangle[0] +
                                     eta[0] * (triangle[1] - triangle[0]) +
                                     eta[1] * (triangle[2] - triangle[0]));
                const Point<2>  in_s = coordinates_in(s, place);
                const Point<2>  in_t = coordinates_in(t, place);
                GaussPoint      point;
                point.slave_xi  = part.middle + part.scale * in_s;
                point.master_xi = other_part.middle + other_part.scale * in_t;
                point.master_facet = m;
                point.weight =
                  2 * area(triangle) * quadrature.weight(q) /
                  jacobian(s, in_s) * part.scale * part.scale *
                  slave.reference_jacobian(own,
                                           FacetShape<3>(slave.degree,
                                                         point.slave_xi));
                Projection<3> on_slave, on_master;
                on_slave.facet  = e;
                on_slave.xi     = point.slave_xi;
                on_master.facet = m;
                on_master.xi    = point.master_xi;
                point.distance =
                  search.position(on_slave) - now.search.position(on_master);
                points.push_back(point);
              }
        }
  }



  void
  MortarDiscretization<3>::integrate(const unsigned int             e,
                                     const std::vector<GaussPoint> &points,
                                     const Configuration           &now,
                                     std::vector<NodeIntegrals> &of_nodes) const
  {
    const unsigned int n       = slave.n_nodes_per_facet();
    double             covered = 0, whole = 0;
    for (const GaussPoint &point : points)
      covered += point.weight;
    for (const double share : slave.shares_of_nodes(e))
      whole += share;
    if (covered <= 1e-8 * whole)
      return;

    FullMatrix<double> mass(n, n), dual(n, n);
    Vector<double>     D(n);
    for (const GaussPoint &point : points)
      {
        const FacetShape<3> shape(slave.degree, point.slave_xi);
        for (unsigned int k = 0; k < n; ++k)
          {
            D[k] += point.weight * shape.value[k];
            for (unsigned int j = 0; j < n; ++j)
              mass(k, j) += point.weight * shape.value[k] * shape.value[j];
          }
      }
    mass.gauss_jordan();
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        dual(k, j) = D[k] * mass(k, j);

    const auto &nodes = slave.facets[e].nodes;
    for (unsigned int k = 0; k < n; ++k)
      of_nodes[nodes[k]].weight += D[k];
    std::vector<double>  phi(n);
    std::vector<Segment> segments;
    for (const GaussPoint &point : points)
      {
        if (segments.empty() ||
            segments.back().master_facet != point.master_facet)
          segments.push_back({point.master_facet, {}, {}});
        const FacetShape<3> shape(slave.degree, point.slave_xi);
        for (unsigned int k = 0; k < n; ++k)
          {
            phi[k] = 0;
            for (unsigned int j = 0; j < n; ++j)
              phi[k] += point.weight * dual(k, j) * shape.value[j];
            of_nodes[nodes[k]].distances.push_back(point.distance);
          }
        add_master(point, phi, now, nodes, segments.back(), of_nodes);
      }
    for (const Segment &segment : segments)
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
          {
            const unsigned int m = master.facets[segment.master_facet].nodes[b];
            of_nodes[nodes[k]].master[m] += segment.values[k][b];
            of_nodes[nodes[k]].gradients[m] += segment.gradients[k][b];
          }
  }



  // Gradients are along the master: by the dual basis of its tangents.
  void MortarDiscretization<3>::add_master(
    const GaussPoint                    &point,
    const std::vector<double>           &phi,
    const Configuration                 &now,
    const PerFacetNode<3, unsigned int> &slave_nodes,
    Segment                             &segment,
    std::vector<NodeIntegrals>          &of_nodes) const
  {
    const FacetShape<3>         shape(master.degree, point.master_xi);
    const auto                 &facet = master.facets[point.master_facet];
    std::array<Tensor<1, 3>, 2> t;
    Tensor<1, 3>                normal;
    double                      bend = 0;
    for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
      {
        for (unsigned int i = 0; i < 2; ++i)
          t[i] += shape.first[i][b] * now.master_x[facet.nodes[b]];
        normal += shape.value[b] * now.master_normals[point.master_facet][b];
        bend += shape.value[b] * master_bends[facet.nodes[b]];
      }
    const double       g00 = t[0] * t[0], g01 = t[0] * t[1], g11 = t[1] * t[1];
    const double       det = g00 * g11 - g01 * g01;
    const Tensor<1, 3> d0  = (g11 * t[0] - g01 * t[1]) / det;
    const Tensor<1, 3> d1  = (g00 * t[1] - g01 * t[0]) / det;

    for (unsigned int k = 0; k < phi.size(); ++k)
      {
        of_nodes[slave_nodes[k]].master_normal += phi[k] * normal;
        of_nodes[slave_nodes[k]].master_bend += phi[k] * bend;
        for (unsigned int b = 0; b < master.n_nodes_per_facet(); ++b)
          {
            segment.values[k][b] += phi[k] * shape.value[b];
            segment.gradients[k][b] +=
              phi[k] * (shape.first[0][b] * d0 + shape.first[1][b] * d1);
          }
      }
  }



  void MortarDiscretization<3>::fill_in(const NodeIntegrals  &integrals,
                                        const unsigned int    node,
                                        const Configuration  &now,
                                        const Vector<double> &u,
                                        ContactPoint<3>      &point) const
  {
    // The mean of the facets around the node.
    Tensor<1, 3> slave_normal;
    for (const unsigned int e : slave.facets_of_node[node])
      {
        const auto &nodes = slave.facets[e].nodes;
        slave_normal +=
          now.slave_normals[e][std::find(nodes.begin(), nodes.end(), node) -
                               nodes.begin()];
      }
    slave_normal /= slave_normal.norm();

    point.keep_nodes(0);
    point.add_node(slave.nodes[node], 1, 0, 0);
    point.n_slave_nodes = 1;
    point.projection    = Point<3>();
    point.normal        = -slave_normal;
    point.facing        = integrals.weight > 0;
    point.weight        = point.facing ? integrals.weight
                                       : slave.shares_of_nodes(point.slave_facet)[0];
    if (!point.facing)
      {
        set_tangents(point);
        return;
      }

    const double of_slave = slave_bends[node];
    const double of_master =
      std::max(0., integrals.master_bend / integrals.weight);
    const double least = 1e-8;
    if (of_slave > least)
      {
        const Tensor<1, 3> master_normal =
          integrals.master_normal / integrals.master_normal.norm();
        point.normal = -of_master * of_master * slave_normal +
                       of_slave * of_slave * master_normal;
        point.normal /= point.normal.norm();
      }
    set_tangents(point);

    for (const auto &[m, integral] : integrals.master)
      point.add_node(master.nodes[m], -integral / integrals.weight, 0, 0);

    // The feet move along the master by the tau that leaves no offset between
    // slave and master along the tangents: E tau = r.
    Tensor<1, 3> r = now.slave_x[node] - Point<3>();
    for (const auto &[m, integral] : integrals.master)
      r -= integral / integrals.weight * now.master_x[m];
    Tensor<2, 3> moves; // of x_master by tau
    for (const auto &[m, gradient] : integrals.gradients)
      moves += outer_product(Tensor<1, 3>(now.master_x[m]), gradient) /
               integrals.weight;
    Tensor<2, 2> E;
    Tensor<1, 2> offset;
    for (unsigned int i = 0; i < 2; ++i)
      {
        offset[i] = r * point.tangents[i];
        for (unsigned int j = 0; j < 2; ++j)
          E[i][j] = point.tangents[i] * (moves * point.tangents[j]);
      }
    if (determinant(E) > 0.1)
      {
        const Tensor<1, 3> tau = point.along_tangents(invert(E) * offset);
        unsigned int       a   = 1;
        for (const auto &[m, gradient] : integrals.gradients)
          {
            const double change = gradient * tau / integrals.weight;
            point.C[a++] -= change;
            r -= change * now.master_x[m];
          }
      }

    // A mean with weights of either sign is no less than the least of the
    // distances; a ten-thousandth of a facet is left to it.
    double smallest = std::numeric_limits<double>::max();
    for (const Tensor<1, 3> &distance : integrals.distances)
      smallest = std::min(smallest, distance * point.normal);
    const double excess = r * point.normal - smallest +
                          1e-4 * slave.reference_length(point.slave_facet);
    if (excess < 0)
      point.projection = Point<3>(excess * point.normal);
    find_void_slip(now, node, integrals, point);
    point.tangential_row_is_void =
      tangential_row_is_void(point, discretization);
    skip_where_held(point, discretization, u);
  }



  // Supports hold the slave node and a master node opposite alike.
  void MortarDiscretization<3>::find_void_slip(const Configuration &now,
                                               const unsigned int   node,
                                               const NodeIntegrals &integrals,
                                               ContactPoint<3>     &point) const
  {
    const double tolerance = 1e-6 * slave.reference_length(point.slave_facet);
    for (unsigned int c = 0; c < 3; ++c)
      {
        point.slip_is_void[c] = false;
        for (const auto &[m, integral] : integrals.master)
          if (std::abs(now.slave_x[node][c] - now.master_x[m][c]) < tolerance &&
              discretization.are_fixed_alike(slave.nodes[node].dofs[c],
                                             master.nodes[m].dofs[c]))
            point.slip_is_void[c] = true;
      }
  }
} // namespace Contact
