/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/symmetry_planes.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  SymmetryPlanes::SymmetryPlanes(const Surface<3>           &slave,
                                 const Surface<3>           &master,
                                 const DiscretizedBodies<3> &discretization)
    : discretization(discretization)
  {
    const double tolerance = 1e-6 * slave.reference_length(0);
    const double round_off = 1e-8;
    for (const SurfaceNode<3> &node : slave.nodes)
      {
        auto directions = discretization.held_normals(node.dofs);
        for (const unsigned int c : {0, 1, 2})
          directions.push_back(Point<3>::unit_vector(c));
        for (const Tensor<1, 3> &across : directions)
          {
            const Plane plane{across, across * node.X, tolerance, node.dofs};
            if (discretization.free_part(node.dofs, across).norm() >
                  round_off ||
                std::any_of(planes.begin(), planes.end(), [&](const Plane &p) {
                  return std::abs(p.across * across) > 1 - round_off &&
                         is_on(p, node);
                }))
              continue;
            if (std::any_of(master.nodes.begin(),
                            master.nodes.end(),
                            [&](const SurfaceNode<3> &other) {
                              return is_on(plane, other);
                            }))
              planes.push_back(plane);
          }
      }
  }



  bool SymmetryPlanes::is_on(const Plane          &plane,
                             const SurfaceNode<3> &node) const
  {
    return std::abs(plane.across * node.X - plane.place) < plane.tolerance &&
           discretization.are_held_alike(plane.held, node.dofs, plane.across);
  }



  // A surface that lies in 2-D or meets it at a slant has its own normal.
  FacetNormals<3>
  SymmetryPlanes::facet_normals(const DeformedSurface<3> &now) const
  {
    const Surface<3> &surface = now.surface;
    FacetNormals<3>   normals = now.facet_normals();
    const double      smooth  = Surface<3>::sine_of_smooth_slant();
    for (unsigned int e = 0; e < surface.facets.size() && !planes.empty(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        for (const Plane &plane : planes)
          {
            Tensor<1, 3> &normal = normals[e][a];
            const double  across = normal * plane.across;
            if (std::abs(across) < smooth &&
                is_on(plane, surface.nodes[surface.facets[e].nodes[a]]))
              {
                normal -= across * plane.across;
                normal /= normal.norm();
              }
          }
    return normals;
  }



  // With its mirror image the surface goes on there.
  bool SymmetryPlanes::is_in_plane(const Surface<3>      &surface,
                                   const SurfaceFacet<3> &facet,
                                   const unsigned int     side) const
  {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane &plane) {
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        if (facet.kind->has_on_side(a, side) &&
            !is_on(plane, surface.nodes[facet.nodes[a]]))
          return false;
      return true;
    });
  }



  std::vector<double> SymmetryPlanes::bends(const Surface<3> &surface,
                                            const bool        with_ends) const
  {
    const DeformedSurface<3>  drawn(surface, {});
    const auto                means = facet_normals(drawn);
    std::vector<double>       bends(surface.nodes.size(), 0.);
    std::vector<Tensor<1, 3>> mean(surface.nodes.size());
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        mean[surface.facets[e].nodes[a]] += means[e][a];
    for (unsigned int e = 0; e < surface.facets.size(); ++e)
      for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
        {
          const unsigned int node = surface.facets[e].nodes[a];
          const Tensor<1, 3> own =
            drawn.normal(e, surface.facets[e].kind->places[a]);
          bends[node] = std::max(bends[node],
                                 (own - mean[node] / mean[node].norm()).norm());
        }

    if (!with_ends)
      return bends;

    // The body ends there, or it goes on with another side: by a right angle,
    // half of it from either side to the mean. In a hollow each side pushes
    // along its own normal.
    const double half_of_right_angle = 2 * std::sin(numbers::PI / 8);
    for (const SurfaceFacet<3> &facet : surface.facets)
      for (unsigned int s = 0; s < facet.n_sides(); ++s)
        if (facet.ends_surface(s) && !facet.is_hollow[s] &&
            !is_in_plane(surface, facet, s))
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
            if (facet.kind->has_on_side(a, s))
              bends[facet.nodes[a]] =
                std::max(bends[facet.nodes[a]], half_of_right_angle);
    return bends;
  }
} // namespace Contact
