/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The pairing of a contact point with the edges of the master.

#include "contact/points/contact_points.h"

namespace Contact
{
  namespace
  {
    /// The master side of a point at its projection on an edge. Returns the
    /// tangent.
    Tensor<1, 2> add_master(ContactPoint<2>          &point,
                            const DeformedSurface<2> &now,
                            const unsigned int        edge,
                            const double              xi)
    {
      const Surface<2> &master = now.surface;
      const EdgeShape   shape(master.degree, xi);
      Tensor<1, 2>      along;
      for (unsigned int a = 0; a < master.n_nodes_per_facet(); ++a)
        {
          const unsigned int node = master.facets[edge].nodes[a];
          point.add_node(master.nodes[node],
                         -shape.value[a],
                         -shape.first[a],
                         -shape.second[a]);
          along += shape.first[a] * now.positions[node];
        }
      return along;
    }



    /// The edge that the vertex at the projection belongs to as well, and which
    /// has another direction.
    unsigned int other_edge(const Projection<2>      &projection,
                            const DeformedSurface<2> &master)
    {
      const double side = projection.xi > 0 ? 1 : -1;
      // Of unit normals; less is round-off.
      for (const auto &twin : projection.twins)
        if ((master.normal(projection.facet, side) -
             master.normal(twin.first, -side))
              .norm() > 1e-8)
          return twin.first;
      return numbers::invalid_unsigned_int;
    }



    /// The projection at the vertex of two edges: the sum of their tangents,
    /// whose nodes come in the order of the chain.
    Tensor<1, 2> add_vertex(ContactPoint<2>          &point,
                            const DeformedSurface<2> &master,
                            const unsigned int        other)
    {
      const double side  = point.master_xi > 0 ? 1 : -1;
      point.master_xi    = side;
      Tensor<1, 2> along = add_master(point, master, point.master_facet, side);

      const unsigned int n_before = point.n_nodes;
      along += add_master(point, master, other, -side);
      // The vertex is in both.
      const unsigned int at_first = point.n_slave_nodes + (side > 0 ? 1 : 0);
      const unsigned int at_other = n_before + (side > 0 ? 0 : 1);
      point.C1[at_first] += point.C1[at_other];
      point.remove_node(at_other);
      return along;
    }
  } // namespace



  // At a vertex that belongs to two edges alike the tangent is the sum of those
  // of both. The body lies to the left of the edge: n is along, turned by -90
  // degrees, and along is n turned by +90.
  void face_master(ContactPoint<2>          &point,
                   const Projection<2>      &projection,
                   const DeformedSurface<2> &master,
                   const Discretization<2> &,
                   const GhostedVector &)
  {
    const unsigned int other     = other_edge(projection, master);
    const bool         at_vertex = other != numbers::invalid_unsigned_int;
    const Tensor<1, 2> along =
      at_vertex ? add_vertex(point, master, other)
                : add_master(point, master, projection.facet, projection.xi);
    point.projection_is_clipped = projection.clipped || at_vertex;

    point.metric               = along.norm();
    const Tensor<1, 2> tangent = along / point.metric;
    point.tangents[0]          = tangent;
    point.normal               = Tensor<1, 2>({tangent[1], -tangent[0]});
  }
} // namespace Contact
