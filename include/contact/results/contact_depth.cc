/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/results/body_boundary.h"

namespace Contact
{
  template<int dim>
  std::vector<double> sagittas(const DeformedSurface<dim> &drawn)
  {
    const Surface<dim> &surface = drawn.surface;
    const auto         &means   = drawn.facet_normals();
    std::vector<double> sagittas(surface.facets.size(), 0.);
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        {
          const double cosine =
            std::clamp(drawn.normal(e, surface.facets[e].kind->places[a]) *
                         means[e][a],
                       -1.,
                       1.);
          sagittas[e] =
            std::max(sagittas[e],
                     2 * std::acos(cosine) * surface.reference_length(e) / 4);
        }
    return sagittas;
  }



  namespace
  {
    /// The largest displacement of a node [mm].
    template<int dim>
    double largest_way(const DeformedSurface<dim> &now)
    {
      double largest = 0;
      for (unsigned int i = 0; i < now.positions.size(); ++i)
        largest =
          std::max(largest, now.positions[i].distance(now.surface.nodes[i].X));
      return largest;
    }



    /// A straight piece of an edge of a surface, where facets of different
    /// sides meet or the surface ends, and its ends in coordinates of the
    /// facet.
    struct EdgePiece
    {
      Point<3>      from, to;
      FacetPoint<3> xi_from, xi_to;
    };

    std::vector<EdgePiece> edge_pieces(const DeformedSurface<3> &surface,
                                       const unsigned int        facet)
    {
      const SurfaceFacet<3> &of = surface.surface.facets[facet];
      const unsigned int     n  = surface.surface.degree;
      std::vector<EdgePiece> pieces;
      for (unsigned int side = 0; side < of.n_sides(); ++side)
        if (of.corner[side] || of.ends_surface(side))
          for (unsigned int piece = 0; piece < n; ++piece)
            {
              const auto     &ends  = of.kind->sides[side].ends;
              const Point<2> &begin = of.kind->places[ends[0]],
                             &end   = of.kind->places[ends[1]];
              EdgePiece edge;
              edge.xi_from = begin + 1. * piece / n * (end - begin);
              edge.xi_to   = begin + 1. * (piece + 1) / n * (end - begin);
              edge.from    = surface.position(facet, edge.xi_from);
              edge.to      = surface.position(facet, edge.xi_to);
              pieces.push_back(edge);
            }
      return pieces;
    }



    /// The place of an edge that is closest to another one, both as lines, if
    /// it is between the ends of both.
    std::optional<FacetPoint<3>> closest_to(const EdgePiece &other,
                                            const EdgePiece &own)
    {
      const Tensor<1, 3> d = own.to - own.from, e = other.to - other.from,
                         r = own.from - other.from;
      const double dd = d * d, ee = e * e, de = d * e;
      const double sine_square = 1 - de * de / (dd * ee);
      if (!(sine_square > std::numeric_limits<double>::epsilon()))
        return {};
      const double s = (de * (e * r) / ee - d * r) / (dd * sine_square);
      const double t = (e * r - de * (d * r) / dd) / (ee * sine_square);
      if (s < 0 || s > 1 || t < 0 || t > 1)
        return {};
      return own.xi_from + s * (own.xi_to - own.xi_from);
    }



    /// The places of a facet where its edges are closest to those of another
    /// surface: in 3-D two edges that cross may be inside of each other there
    /// alone. In 2-D an edge is a node.
    std::vector<FacetPoint<3>> crossings(const DeformedSurface<3> &own,
                                         const unsigned int        facet,
                                         const DeformedSurface<3> &other)
    {
      std::vector<FacetPoint<3>> places;
      for (const EdgePiece &edge : edge_pieces(own, facet))
        for (const unsigned int f : other.facets_in(
               BoundingBox<3>(std::vector<Point<3>>{edge.from, edge.to})))
          for (const EdgePiece &crossed : edge_pieces(other, f))
            if (const auto place = closest_to(crossed, edge))
              places.push_back(*place);
      return places;
    }

    std::vector<FacetPoint<2>> crossings(const DeformedSurface<2> &,
                                         const unsigned int,
                                         const DeformedSurface<2> &)
    {
      return {};
    }



    /// The deepest place of a surface inside of the other body. Each process
    /// looks at its share of the facets. A place deeper than @p way has not
    /// come there from outside: it is of the same body.
    template<int dim>
    void look(const DeformedSurface<dim> &own,
              const DeformedSurface<dim> &boundary,
              const DeformedSurface<dim> &slave,
              const MPI_Comm              communicator,
              const double                way,
              const bool                  as_drawn,
              ContactDepth<dim>          &deepest)
    {
      const bool                 is_master = &own != &slave;
      const DeformedSurface<dim> drawn(own.surface, {}),
        boundary_drawn(boundary.surface, {});
      const auto of_own = sagittas(drawn), of_other = sagittas(boundary_drawn);
      const BoundingBox<dim> box(boundary.positions);
      const auto             look_at = [&](const unsigned int     e,
                               const FacetPoint<dim> &xi) {
        const Point<dim> x = own.position(e, xi);
        if (!box.point_inside(x))
          return;
        const auto         closest = boundary.closest_point(x);
        const unsigned int f       = closest.facet;
        const double       behind = depth_behind(boundary, closest, x);
        const double       depth =
          as_drawn ? behind : behind - of_own[e] - of_other[f];
        if (depth > deepest.depth && behind < way)
          deepest = {depth,
                     is_master,
                     drawn.position(e, xi),
                     is_master ? slave.closest_alone(x).facet : e,
                     (boundary.position(f, closest.xi) - x) / behind};
      };
      for (const unsigned int e :
           Utilities::MPI::create_evenly_distributed_partitioning(
             communicator,
             own.surface.facets.size()))
        {
          for (const FacetPoint<dim> &xi :
               own.surface.facets[e].kind->lattice(/*with_nodes=*/true))
            look_at(e, xi);
          for (const FacetPoint<dim> &xi : crossings(own, e, boundary))
            look_at(e, xi);
        }
    }



    /// The deepest place of the slave inside of an obstacle: between the nodes,
    /// where each node has a point that looks there, else at nodes as well. Not
    /// beside nodes that supports hold along the normal, which a note tells.
    template<int dim>
    void look_at_obstacle(const ContactPair<dim> &contact_pair,
                          const GhostedVector    &u,
                          const bool              as_drawn,
                          ContactDepth<dim>      &deepest)
    {
      const Surface<dim>           &slave = contact_pair.slave;
      const DeformedSurface<dim>    now(slave, u), drawn(slave, {});
      const Obstacle<dim>          &obstacle = *contact_pair.obstacle;
      const DiscretizedBodies<dim> &discretization =
        contact_pair.discretization;
      const bool at_nodes = !contact_pair.has_point_per_multiplier();
      const auto is_held  = [&](const SurfaceFacet<dim> &facet,
                               const Tensor<1, dim>    &normal) {
        const double round_off = 1e-8;
        for (unsigned int a = 0; a < facet.n_nodes(); ++a)
          if (discretization.free_part(slave.nodes[facet.nodes[a]].dofs, normal)
                .norm() < round_off)
            return true;
        return false;
      };
      for (unsigned int e = 0; e < slave.facets.size(); ++e)
        for (const FacetPoint<dim> &xi :
             slave.facets[e].kind->lattice(at_nodes))
          {
            const Point<dim> x       = now.position(e, xi);
            const auto       closest = obstacle.closest_point(x);
            if (!as_drawn && is_held(slave.facets[e], closest.normal))
              continue;
            const double h = // from corner to opposite corner
              std::sqrt(dim - 1.) * slave.reference_length(e);
            const double chord =
              h <= closest.radius ? h * h / (8 * closest.radius) : 0.;
            const double behind = (closest.x - x) * closest.normal;
            const double depth  = as_drawn ? behind : behind - chord;
            if (depth > deepest.depth)
              deepest = {depth,
                         false,
                         drawn.position(e, xi),
                         e,
                         closest.normal};
          }
    }
  } // namespace



  template<int dim>
  ContactDepth<dim> largest_depth(const ContactPair<dim> &contact_pair,
                                  const GhostedVector    &u,
                                  const DepthOf           kind)
  {
    const bool        as_drawn     = kind == DepthOf::mesh;
    const MPI_Comm    communicator = contact_pair.discretization.communicator;
    ContactDepth<dim> deepest;
    if (contact_pair.master)
      {
        const DeformedSurface<dim> slave(contact_pair.slave, u),
          master(*contact_pair.master, u);
        const double way = kind != DepthOf::motion
                             ? std::numeric_limits<double>::max()
                             : largest_way(slave) + largest_way(master) +
                                 contact_pair.interference->at_start;
        for (const bool of_master : {false, true})
          {
            const BodyBoundary<dim> other(contact_pair, !of_master);
            look(of_master ? master : slave,
                 {other.surface, other.positions(u), /*overhang=*/0.},
                 slave,
                 communicator,
                 way,
                 as_drawn,
                 deepest);
          }
        deepest = deepest_of_all(communicator, deepest);
      }
    else
      look_at_obstacle(contact_pair, u, as_drawn, deepest);
    return deepest;
  }

  template std::vector<double> sagittas(const DeformedSurface<2> &);
  template std::vector<double> sagittas(const DeformedSurface<3> &);
  template ContactDepth<2>
  largest_depth(const ContactPair<2> &, const GhostedVector &, const DepthOf);
  template ContactDepth<3>
  largest_depth(const ContactPair<3> &, const GhostedVector &, const DepthOf);
} // namespace Contact
