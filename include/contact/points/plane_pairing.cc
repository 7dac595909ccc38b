/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The pairing of a contact point with the edges of the master, and what is free
// at it in 2-D.

#include "contact/points/contact_points.h"

namespace Contact
{
  namespace
  {
    /// Scalar products of the normal and the tangential row of a point over the
    /// unknowns that no support fixes.
    struct FreeRows
    {
      FreeRows(const ContactPoint<2>      &point,
               const DiscretizedBodies<2> &discretization)
      {
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            const Tensor<1, 2> n =
              discretization.free_part(point.dofs(a), point.normal);
            const Tensor<1, 2> t =
              discretization.free_part(point.dofs(a), point.tangents[0]);
            for (unsigned int i = 0; i < 2; ++i)
              {
                nn += std::pow(point.C[a] * n[i], 2);
                tt += std::pow(point.C[a] * t[i], 2);
                nt += point.C[a] * point.C[a] * n[i] * t[i];
              }
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
      for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
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



  std::vector<Tensor<1, 1>>
  free_slips(const ContactPoint<2>      &point,
             const DiscretizedBodies<2> &discretization)
  {
    if (FreeRows(point, discretization).are_parallel())
      return {};
    return {Tensor<1, 1>({1.})};
  }



  Tensor<1, 1> prescribed_slip(const ContactPoint<2>      &point,
                               const DiscretizedBodies<2> &discretization,
                               const GhostedVector        &motion)
  {
    const FreeRows rows(point, discretization);
    if (!rows.are_parallel())
      return {};
    const Tensor<1, 2> along =
      point.tangents[0] - (rows.nn > 0 ? rows.nt / rows.nn : 0.) * point.normal;
    double slip = point.tangents[0] * point.interference_at_start -
                  along * point.projection_motion,
           size = std::abs(slip);
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      {
        const Tensor<1, 2> held =
          along - discretization.free_part(point.dofs(a), along);
        for (unsigned int i = 0; i < 2; ++i)
          {
            const double share =
              point.C[a] * held[i] * motion[point.dofs(a)[i]];
            slip += share;
            size += std::abs(share);
          }
      }
    const double round_off = 1e-10;
    return Tensor<1, 1>({std::abs(slip) > round_off * size ? slip : 0.});
  }



  void set_tangents(ContactPoint<2> &point)
  {
    point.tangents[0] = Tensor<1, 2>({-point.normal[1], point.normal[0]});
  }



  // At a vertex that belongs to two edges alike the tangent is the sum of those
  // of both. The body lies to the left of the edge: n is along, turned by -90
  // degrees, and along is n turned by +90.
  void face_master(ContactPoint<2>     &point,
                   const Projection<2> &projection,
                   const NormalCone<2> &,
                   const DeformedSurface<2> &master,
                   const DiscretizedBodies<2> &,
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
