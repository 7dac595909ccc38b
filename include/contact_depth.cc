/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact_depth.h"

#include <cmath>

namespace Contact
{
  namespace
  {
    void look(const Surface        &surface,
              const Surface        &other,
              const bool            is_master,
              const Vector<double> &u,
              ContactDepth         &deepest)
    {
      const SurfaceSearch search(other, u);
      const auto          normals = surface.normals(u);
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          const Point<2>   x    = surface.position(i, u);
          const Projection foot = search.closest_point(x);
          if (foot.off_the_end || foot.clipped)
            continue;

          const EdgeShape shape(other.degree, foot.xi);
          const auto     &edge = other.edges[foot.edge];
          Tensor<1, 2>    r    = x, along;
          for (unsigned int a = 0; a < other.n_nodes_per_edge(); ++a)
            {
              r -= shape.value[a] * other.position(edge.nodes[a], u);
              along += shape.first[a] * other.position(edge.nodes[a], u);
            }
          const Tensor<1, 2> outward =
            Tensor<1, 2>({along[1], -along[0]}) / along.norm();
          // What is further behind the other surface than its edge is long has
          // come there around it.
          const bool   faces = outward * normals[i] < 0;
          const double depth = -(r * outward);
          if (faces && depth > deepest.depth &&
              depth < other.reference_length(foot.edge))
            deepest = {depth, is_master, surface.nodes[i].X};
        }
    }
  } // namespace



  ContactDepth largest_depth(const ContactZone &zone, const Vector<double> &u)
  {
    ContactDepth deepest;
    if (zone.master)
      {
        look(zone.slave, *zone.master, false, u, deepest);
        look(*zone.master, zone.slave, true, u, deepest);
      }
    return deepest;
  }
} // namespace Contact
