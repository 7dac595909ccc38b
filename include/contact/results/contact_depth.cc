/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_depth.h"

#include <algorithm>
#include <cmath>

#include "contact/points/corner_points.h"

namespace Contact
{
  namespace
  {
    /// By how much the polygon of an edge may be beside the curve that it
    /// stands for, at one of its nodes. A corner, or an end, stands for itself.
    double sagitta(const Surface<2>  &surface,
                   const unsigned int e,
                   const unsigned int a)
    {
      const SurfaceFacet<2> &edge = surface.facets[e];
      const bool             stands_for_itself =
        a < 2 &&
        (edge.corner[a] || (a == 0 ? edge.begins_surface : edge.ends_surface));
      return stands_for_itself
               ? 0.
               : surface.turns[edge.nodes[a]] * surface.reference_length(e) / 4;
    }



    /// The deepest node of @p surface.
    void look(const Surface<2>    &surface,
              const Surface<2>    &other,
              const bool           is_master,
              const GhostedVector &u,
              const bool           as_drawn,
              ContactDepth<2>     &deepest)
    {
      const SurfaceSearch<2> search(other, u);
      const auto             normals = surface.facet_normals(u);
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          {
            const unsigned int  i          = surface.facets[e].nodes[a];
            const Point<2>      x          = surface.position(i, u);
            const Projection<2> projection = search.closest_point(x);
            if (projection.off_the_end || projection.clipped)
              continue;

            const EdgeShape shape(other.degree, projection.xi);
            const auto     &edge = other.facets[projection.facet];
            Tensor<1, 2>    r    = x, along;
            for (unsigned int b = 0; b < other.n_nodes_per_facet(); ++b)
              {
                r -= shape.value[b] * other.position(edge.nodes[b], u);
                along += shape.first[b] * other.position(edge.nodes[b], u);
              }
            const Tensor<1, 2> outward = cross_product_2d(along) / along.norm();
            // A node further behind the other surface than its edge is long has
            // come there around it, and a face that stands on the surface does
            // not look at it: where the ends of a shaft and its hub are in one
            // plane, one of them moves a little behind the end of the other.
            const double behind = -(r * outward);
            const double facing = std::sin(numbers::PI / 180 * inclination);
            if (outward * normals[e][a] >= -facing ||
                behind >= other.reference_length(projection.facet))
              continue;
            const double allowance =
              sagitta(surface, e, a) +
              std::max(sagitta(other, projection.facet, 0),
                       sagitta(other, projection.facet, 1));
            const double depth = as_drawn ? behind : behind - allowance;
            if (depth > deepest.depth)
              deepest = {depth,
                         is_master,
                         surface.nodes[i].X,
                         is_master ? projection.facet : e};
          }
    }



    /// Places of a facet, with its nodes or between them only.
    template<int dim>
    std::vector<FacetPoint<dim>> places_of_facet(const bool with_nodes);

    template<>
    std::vector<FacetPoint<2>> places_of_facet<2>(const bool with_nodes)
    {
      if (with_nodes)
        return {-1., -0.5, 0., 0.5, 1.};
      return {-0.5, 0., 0.5};
    }

    template<>
    std::vector<FacetPoint<3>> places_of_facet<3>(const bool with_nodes)
    {
      std::vector<FacetPoint<3>> places;
      for (const double xi : places_of_facet<2>(with_nodes))
        for (const double eta : places_of_facet<2>(with_nodes))
          places.emplace_back(xi, eta);
      return places;
    }
  } // namespace



  template<int dim>
  void look_at_obstacle(const Surface<dim>  &slave,
                        const Obstacle<dim> &obstacle,
                        const GhostedVector &u,
                        const bool           as_drawn,
                        const bool           at_nodes,
                        ContactDepth<dim>   &deepest)
  {
    const auto places = places_of_facet<dim>(at_nodes);
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      for (const FacetPoint<dim> &xi : places)
        {
          const FacetShape<dim> shape(slave.degree, xi);
          Point<dim>            x, X;
          for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
            {
              const unsigned int i = slave.facets[e].nodes[a];
              x += shape.value[a] * slave.position(i, u);
              X += shape.value[a] * slave.nodes[i].X;
            }
          const auto   closest = obstacle.closest_point(x);
          const double h       = // from corner to opposite corner
            std::sqrt(dim - 1.) * slave.reference_length(e);
          const double chord =
            h <= closest.radius ? h * h / (8 * closest.radius) : 0.;
          const double behind = (closest.x - x) * closest.normal;
          const double depth  = as_drawn ? behind : behind - chord;
          if (depth > deepest.depth)
            deepest = {depth, false, X, e};
        }
  }

  template void look_at_obstacle(const Surface<2> &,
                                 const Obstacle<2> &,
                                 const GhostedVector &,
                                 const bool,
                                 const bool,
                                 ContactDepth<2> &);
  template void look_at_obstacle(const Surface<3> &,
                                 const Obstacle<3> &,
                                 const GhostedVector &,
                                 const bool,
                                 const bool,
                                 ContactDepth<3> &);



  ContactDepth<2> largest_depth(const ContactPair<2> &contact_pair,
                                const GhostedVector  &u,
                                const bool            as_drawn)
  {
    ContactDepth<2> deepest;
    if (contact_pair.master)
      {
        look(contact_pair.slave,
             *contact_pair.master,
             false,
             u,
             as_drawn,
             deepest);
        look(*contact_pair.master,
             contact_pair.slave,
             true,
             u,
             as_drawn,
             deepest);
      }
    else
      look_at_obstacle(contact_pair.slave,
                       *contact_pair.obstacle,
                       u,
                       as_drawn,
                       !contact_pair.has_point_per_multiplier(),
                       deepest);
    return deepest;
  }
} // namespace Contact
