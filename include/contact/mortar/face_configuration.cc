/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_configuration.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The outward unit normals in the middle of the facets.
    std::vector<Tensor<1, 3>> middle_normals(const Surface<3> &surface,
                                             const std::vector<Point<3>> &x)
    {
      std::vector<Tensor<1, 3>> normals;
      for (const SurfaceFacet<3> &facet : surface.facets)
        {
          PerFacetNode<3, Point<3>> of_facet;
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
            of_facet[a] = x[facet.nodes[a]];
          normals.push_back(
            facet_normal<3>(*facet.kind, of_facet, facet.kind->middle));
        }
      return normals;
    }
  } // namespace



  // The nodes bound the facet, whose parts are (bi)linear between them.
  FacetBall::FacetBall(const SurfaceFacet<3>       &facet,
                       const std::vector<Point<3>> &x)
  {
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      centre += x[facet.nodes[a]] / facet.n_nodes();
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      radius = std::max(radius, centre.distance(x[facet.nodes[a]]));
  }



  FaceConfiguration::FaceConfiguration(const Surface<3>     &slave,
                                       const Surface<3>     &master,
                                       const SymmetryPlanes &planes,
                                       const GhostedVector  &u)
    : slave_normals(planes.facet_normals({slave, u}))
    , master_normals(planes.facet_normals({master, u}))
    , search(master, u)
  {
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      slave_x.push_back(slave.position(i, u));
    for (unsigned int i = 0; i < master.nodes.size(); ++i)
      master_x.push_back(master.position(i, u));
    slave_middles  = middle_normals(slave, slave_x);
    master_middles = middle_normals(master, master_x);
    for (const SurfaceFacet<3> &facet : master.facets)
      master_balls.emplace_back(facet, master_x);
  }
} // namespace Contact
