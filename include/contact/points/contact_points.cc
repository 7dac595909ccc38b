/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/contact_points.h"

#include <deal.II/base/quadrature_lib.h>

namespace Contact
{
  namespace
  {
    /// Fill in the slave side of a point at @p xi of the slave edge @p e.
    template<int dim>
    ContactPoint<dim> make_point(const Surface<dim>    &slave,
                                 const unsigned int     e,
                                 const FacetPoint<dim> &xi)
    {
      const SurfaceFacet<dim> &facet = slave.facets[e];
      const auto values              = FacetShape<dim>::values(*facet.kind, xi);

      ContactPoint<dim> point;
      point.slave_facet = e;
      point.slave_xi    = xi;
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        if (values[a] != 0)
          point.add_node(slave.nodes[facet.nodes[a]], values[a]);
      point.n_slave_nodes = point.n_nodes;
      return point;
    }



    /// A node of a facet and its part in something.
    using NodePart = std::pair<unsigned int, double>;

    std::vector<NodePart> parts_of_nodal_point(const FacetKind<2> &,
                                               const unsigned int a)
    {
      return {{a, 1.}};
    }

    /// The nodes whose places, with these factors, are the factor of the test
    /// function of a node in the place of the surface, the node itself first:
    /// where nodal points act so, a uniform pressure is one of all nodes.
    std::vector<NodePart> parts_of_nodal_point(const FacetKind<3> &kind,
                                               const unsigned int  a)
    {
      const double          own = 1 / (1 - 2 * kind.part_of_sides);
      std::vector<NodePart> parts{{a, 1.}};
      if (kind.part_of_sides == 0 || a < kind.n_vertices)
        return parts;
      parts[0].second = own;
      for (const unsigned int end : kind.vertices_of_node[a])
        parts.emplace_back(end, -kind.part_of_sides * own);
      return parts;
    }



    /// The same of a node of it.
    template<int dim>
    ContactPoint<dim> make_nodal_point(const Surface<dim> &slave,
                                       const unsigned int  e,
                                       const unsigned int  a)
    {
      const SurfaceFacet<dim> &facet = slave.facets[e];
      ContactPoint<dim>        point;
      point.slave_facet = e;
      point.slave_xi    = facet.kind->places[a];
      for (const auto &[node, part] : parts_of_nodal_point(*facet.kind, a))
        point.add_node(slave.nodes[facet.nodes[node]], part);
      point.n_slave_nodes = point.n_nodes;
      return point;
    }



    /// The closest place of an obstacle to a nodal point; of several nodes that
    /// with their gaps.
    template<int dim>
    Point<dim> closest_to_nodes(const ContactPoint<dim> &point,
                                const Obstacle<dim>     &obstacle,
                                const Point<dim>        &closest,
                                const GhostedVector     &u)
    {
      if (point.n_multipliers > 1 || point.n_slave_nodes == 1)
        return closest;
      Point<dim> sum;
      for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
        {
          Point<dim> x = point.X(a);
          for (unsigned int i = 0; i < dim; ++i)
            x[i] += u[point.dofs(a)[i]];
          sum += point.C[a] * Tensor<1, dim>(obstacle.closest_point(x).x);
        }
      return sum;
    }



    /// On an axis at degree 2 the integral vanishes. The node has a gap all the
    /// same, and may take a force: as if on the half of the edge next to it the
    /// pressure were linear.
    void weigh_on_axis(const Surface<2>             &slave,
                       std::vector<ContactPoint<2>> &points)
    {
      for (ContactPoint<2> &point : points)
        if (point.weight <=
            1e-12 * slave.reference_jacobian(slave.facets[point.slave_facet],
                                             EdgeShape(slave.degree, 0)))
          point.weight =
            0.5 * slave.reference_jacobian(slave.facets[point.slave_facet],
                                           EdgeShape(slave.degree,
                                                     point.slave_xi * 2. / 3));
    }

    void weigh_on_axis(const Surface<3> &, std::vector<ContactPoint<3>> &)
    {
    }
  } // namespace



  // Of the integral of its shape function: the trapezoidal rule, and Simpson's.
  double share_of_node(const Surface<2>  &slave,
                       const unsigned int e,
                       const unsigned int a)
  {
    const std::array<double, 3> centroids =
      slave.degree == 1 ? std::array<double, 3>{{-1. / 3, 1. / 3, 0}}
                        : node_coordinates;
    const double share = slave.degree == 1 ? 1. : (a == 2 ? 4. / 3. : 1. / 3.);
    return share *
           slave.reference_jacobian(slave.facets[e],
                                    EdgeShape(slave.degree, centroids[a]));
  }

  double share_of_node(const Surface<3>  &slave,
                       const unsigned int e,
                       const unsigned int a)
  {
    return slave.shares_of_nodes(e)[a];
  }



  template<int dim>
  std::vector<ContactPoint<dim>>
  make_nodal_points(const Surface<dim>           &slave,
                    const std::set<unsigned int> &excluded,
                    MultiplierSpace              &multipliers)
  {
    multipliers.of_node.assign(slave.nodes.size(),
                               numbers::invalid_unsigned_int);
    multipliers.n_multipliers = 0;

    std::vector<ContactPoint<dim>> points;
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.facets[e].n_nodes(); ++a)
        {
          const unsigned int node = slave.facets[e].nodes[a];
          if (excluded.count(node) > 0 || !slave.parents[node].empty())
            continue;

          if (multipliers.of_node[node] == numbers::invalid_unsigned_int)
            {
              multipliers.of_node[node] = multipliers.n_multipliers++;
              points.push_back(make_nodal_point<dim>(slave, e, a));
              points.back().n_multipliers  = 1;
              points.back().multipliers[0] = multipliers.of_node[node];
              points.back().psi[0]         = 1;
              points.back().weight         = 0;
            }
        }
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int a = 0; a < slave.facets[e].n_nodes(); ++a)
        for (const auto &[node, part] :
             slave.receivers(slave.facets[e].nodes[a]))
          if (const unsigned int k = multipliers.of_node[node];
              k != numbers::invalid_unsigned_int)
            points[k].weight += part * share_of_node(slave, e, a);
    weigh_on_axis(slave, points);
    return points;
  }



  std::vector<ContactPoint<2>> make_gauss_points(const Surface<2>  &slave,
                                                 const unsigned int n_points,
                                                 MultiplierSpace   &multipliers)
  {
    multipliers.of_node.resize(slave.nodes.size());
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      multipliers.of_node[i] = i;
    multipliers.n_multipliers = slave.nodes.size();

    const QGauss<1>              quadrature(n_points);
    std::vector<ContactPoint<2>> points;
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const double    xi = 2 * quadrature.point(q)[0] - 1;
          const EdgeShape shape(slave.degree, xi);

          points.push_back(make_point<2>(slave, e, xi));
          ContactPoint<2> &point = points.back();
          point.weight           = 2 * quadrature.weight(q) *
                         slave.reference_jacobian(slave.facets[e], shape);
          point.n_multipliers = slave.n_nodes_per_edge();
          for (unsigned int a = 0; a < point.n_multipliers; ++a)
            {
              point.multipliers[a] = slave.facets[e].nodes[a];
              point.psi[a]         = shape.value[a];
            }
        }
    return points;
  }



  // At first the axis that is furthest from the normal.
  void set_tangents(ContactPoint<3> &point)
  {
    const Tensor<1, 3> &n     = point.normal;
    Tensor<1, 3>       &first = point.tangents[0];
    // The last normal n0, and the rotation about n0 x n that makes n of it.
    const Tensor<1, 3> n0 = cross_product_3d(first, point.tangents[1]);
    if (n0 * n0 > 0 && n0 * n > -0.5)
      first -= (first * n) / (1 + n0 * n) * (n0 + n);
    else
      {
        unsigned int axis = 0;
        for (unsigned int i = 1; i < 3; ++i)
          if (std::abs(n[i]) < std::abs(n[axis]))
            axis = i;
        first = Point<3>::unit_vector(axis);
      }
    first -= (first * n) * n;
    first /= first.norm();
    point.tangents[1] = cross_product_3d(n, first);
  }



  template<int dim>
  Point<dim> slave_position(const ContactPoint<dim> &point,
                            const GhostedVector     &u)
  {
    Point<dim> x;
    for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        x[i] += point.C[a] * (point.X(a)[i] + u[point.dofs(a)[i]]);
    return x;
  }



  template<int dim>
  bool is_free_along(const ContactPoint<dim>      &point,
                     const unsigned int            n_nodes,
                     const Tensor<1, dim>         &normal,
                     const DiscretizedBodies<dim> &discretization)
  {
    const double round_off = 1e-8;
    double       free = 0, all = 0;
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const Tensor<1, dim> part =
          discretization.free_part(point.dofs(a), normal);
        for (unsigned int i = 0; i < dim; ++i)
          {
            all += std::abs(point.C[a] * normal[i]);
            free += std::abs(point.C[a] * part[i]);
          }
      }
    return free > round_off * all;
  }



  template<int dim>
  void skip_where_held(ContactPoint<dim>            &point,
                       const DiscretizedBodies<dim> &discretization,
                       const GhostedVector          &u)
  {
    if (is_free_along(point, point.n_nodes, point.normal, discretization))
      return;
    double gap = 0, size = 0;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      {
        for (unsigned int i = 0; i < dim; ++i)
          gap += point.C[a] * point.normal[i] *
                 (point.X(a)[i] + u[point.dofs(a)[i]]);
        size = std::max(size, point.X(a).distance(point.X(0)));
      }
    point.facing = point.facing && gap < -1e-8 * size;
  }



  namespace
  {
    /// Whether a node of the surface is on its end.
    template<int dim>
    bool is_at_end(const Surface<dim> &surface, const unsigned int node)
    {
      for (const unsigned int e : surface.facets_of_node[node])
        {
          const SurfaceFacet<dim> &facet = surface.facets[e];
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
            for (unsigned int s = 0; s < facet.n_sides(); ++s)
              if (facet.nodes[a] == node && facet.ends_surface(s) &&
                  facet.kind->has_on_side(a, s))
                return true;
        }
      return false;
    }
  } // namespace



  // The normal in the facet; at a node those of all facets around it, in
  // 2-D at first of the edge that ends there.
  template<int dim>
  NormalCone<dim> directions_of(const ContactPoint<dim>    &point,
                                const DeformedSurface<dim> &now)
  {
    const Surface<dim> &slave   = now.surface;
    const auto         &normals = now.facet_normals();
    NormalCone<dim>     directions;
    directions.reach = DeformedSurface<dim>::overhang *
                       slave.reference_length(point.slave_facet);
    const auto &facet = slave.facets[point.slave_facet];
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      if (facet.kind->places[a] == point.slave_xi)
        {
          const unsigned int node = facet.nodes[a];
          directions.at_end       = is_at_end(slave, node);
          for (const unsigned int e : slave.facets_of_node[node])
            for (unsigned int b = 0; b < slave.facets[e].n_nodes(); ++b)
              if (slave.facets[e].nodes[b] == node)
                directions.normals.insert(b == 1 ? directions.normals.begin()
                                                 : directions.normals.end(),
                                          normals[e][b]);
          return directions;
        }

    const auto values = FacetShape<dim>::values(*facet.kind, point.slave_xi);
    Tensor<1, dim> n;
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      n += values[a] * normals[point.slave_facet][a];
    directions.normals.push_back(n / n.norm());
    return directions;
  }



  template<int dim>
  void pair_with_master(ContactPoint<dim>            &point,
                        const NormalCone<dim>        &directions,
                        const DeformedSurface<dim>   &master,
                        const DiscretizedBodies<dim> &discretization,
                        const GhostedVector          &u)
  {
    const Projection<dim> projection =
      master.closest_facing(slave_position(point, u), directions);
    const FacetKind<dim> &kind = *master.surface.facets[projection.facet].kind;
    const double          beyond = (kind.outwardness(projection.xi) - 1) / 2 *
                          master.surface.reference_length(projection.facet);
    point.facing       = !projection.beyond_end && beyond <= directions.reach;
    point.master_facet = projection.facet;
    point.master_xi    = projection.xi;

    point.keep_nodes(point.n_slave_nodes);
    face_master(point, projection, directions, master, discretization, u);
    skip_where_held(point, discretization, u);
    point.has_no_free_tangent = has_no_free_tangent(point, discretization);
  }



  // A node that a support holds against the obstacle needs no pressure, and
  // there would be no unknown for it to act on. Along the tangent the place of
  // a circle is centre + radius n, and its second derivative by the coordinate
  // that is the angle -radius n.
  template<int dim>
  void pair_with_obstacle(ContactPoint<dim>            &point,
                          const Obstacle<dim>          &obstacle,
                          const DiscretizedBodies<dim> &discretization,
                          const GhostedVector          &u)
  {
    const auto projection = obstacle.closest_point(slave_position(point, u));
    point.facing          = is_free_along(point,
                                 point.n_slave_nodes,
                                 projection.normal,
                                 discretization);
    point.master_facet    = numbers::invalid_unsigned_int;
    point.projection      = closest_to_nodes(point, obstacle, projection.x, u);
    point.normal          = projection.normal;
    set_tangents(point);
    point.metric = projection.radius == 0 ? 1 : std::abs(projection.radius);
    point.projection_curvature = -projection.radius * projection.normal;
    point.projection_motion    = projection.motion;
    point.projection_stretch   = projection.stretch;
    point.motions              = projection.motions;
    point.has_no_free_tangent  = has_no_free_tangent(point, discretization);
  }

#define INSTANTIATE(dim)                                                      \
  template std::vector<ContactPoint<dim>> make_nodal_points(                  \
    const Surface<dim> &,                                                     \
    const std::set<unsigned int> &,                                           \
    MultiplierSpace &);                                                       \
  template bool            is_free_along(const ContactPoint<dim> &,           \
                                         const unsigned int,                  \
                                         const Tensor<1, dim> &,              \
                                         const DiscretizedBodies<dim> &);     \
  template void            skip_where_held(ContactPoint<dim> &,               \
                                           const DiscretizedBodies<dim> &,    \
                                           const GhostedVector &);            \
  template Point<dim>      slave_position(const ContactPoint<dim> &,          \
                                          const GhostedVector &);             \
  template NormalCone<dim> directions_of(const ContactPoint<dim> &,           \
                                         const DeformedSurface<dim> &);       \
  template void            pair_with_master(ContactPoint<dim> &,              \
                                            const NormalCone<dim> &,          \
                                            const DeformedSurface<dim> &,     \
                                            const DiscretizedBodies<dim> &,   \
                                            const GhostedVector &);           \
  template void            pair_with_obstacle(ContactPoint<dim> &,            \
                                              const Obstacle<dim> &,          \
                                              const DiscretizedBodies<dim> &, \
                                              const GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
