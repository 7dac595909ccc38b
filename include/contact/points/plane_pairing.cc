/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The pairing of a contact point with the edges of the master.

#include "contact/points/contact_points.h"

namespace Contact
{
  NormalCone<2> directions_of(const ContactPoint<2> &point,
                              const Surface<2>      &slave,
                              const FacetNormals<2> &normals)
  {
    const auto     &edge = slave.facets[point.slave_facet];
    const EdgeShape shape(slave.degree, point.slave_xi);
    Tensor<1, 2>    n;
    for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
      n += shape.value[a] * normals[point.slave_facet][a];
    n /= n.norm();

    NormalCone<2> directions{n, n};
    directions.reach =
      SurfaceSearch<2>::overhang * slave.reference_length(point.slave_facet);
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
    Tensor<1, 2> add_master(ContactPoint<2>     &point,
                            const Surface<2>    &master,
                            const unsigned int   edge,
                            const double         xi,
                            const GhostedVector &u)
    {
      const EdgeShape shape(master.degree, xi);
      Tensor<1, 2>    along;
      for (unsigned int a = 0; a < master.n_nodes_per_facet(); ++a)
        {
          const unsigned int node = master.facets[edge].nodes[a];
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
    unsigned int other_edge(const Projection<2>    &projection,
                            const SurfaceSearch<2> &search)
    {
      if (projection.twin == numbers::invalid_unsigned_int)
        return projection.twin;
      const double side = projection.xi > 0 ? 1 : -1;
      // Of unit normals; less is round-off.
      return (search.normal(projection.facet, side) -
              search.normal(projection.twin, -side))
                   .norm() > 1e-8
               ? projection.twin
               : numbers::invalid_unsigned_int;
    }



    /// The projection at the vertex of two edges: the sum of their tangents,
    /// whose nodes come in the order of the chain.
    Tensor<1, 2> add_vertex(ContactPoint<2>     &point,
                            const Surface<2>    &master,
                            const unsigned int   other,
                            const GhostedVector &u)
    {
      const double side = point.master_xi > 0 ? 1 : -1;
      point.master_xi   = side;
      Tensor<1, 2> along =
        add_master(point, master, point.master_facet, side, u);

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



  void pair_with_master(ContactPoint<2>         &point,
                        const NormalCone<2>     &directions,
                        const Surface<2>        &master,
                        const SurfaceSearch<2>  &search,
                        const Discretization<2> &discretization,
                        const GhostedVector     &u,
                        const bool               keeps_edge)
  {
    const Point<2> x = slave_position(point, u);
    Projection<2>  projection;
    if (keeps_edge && point.facing)
      projection =
        search.project(x, point.master_facet, SurfaceSearch<2>::overhang);
    if (!keeps_edge || !point.facing || projection.clipped)
      projection = search.closest_facing(x, directions);
    const double beyond = (std::abs(projection.xi) - 1) / 2 *
                          master.reference_length(projection.facet);
    point.facing       = !projection.off_the_end && beyond <= directions.reach;
    point.master_facet = projection.facet;
    point.master_xi    = projection.xi;

    point.keep_nodes(point.n_slave_nodes);
    const unsigned int other     = other_edge(projection, search);
    const bool         at_vertex = other != numbers::invalid_unsigned_int;
    const Tensor<1, 2> along =
      at_vertex ? add_vertex(point, master, other, u)
                : add_master(point, master, projection.facet, projection.xi, u);
    point.projection_is_clipped = projection.clipped || at_vertex;

    // The body lies to the left of the edge: n is along, turned by -90
    // degrees, and along is n turned by +90.
    point.metric               = along.norm();
    const Tensor<1, 2> tangent = along / point.metric;
    point.tangents[0]          = tangent;
    point.normal               = Tensor<1, 2>({tangent[1], -tangent[0]});

    skip_where_held(point, discretization, u);
    point.tangential_row_is_void =
      tangential_row_is_void(point, discretization);
  }
} // namespace Contact
