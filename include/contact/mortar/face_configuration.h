/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_configuration_h
#define contact_face_configuration_h

#include "contact/surfaces/deformed_surface.h"
#include "contact/surfaces/symmetry_planes.h"

namespace Contact
{
  using namespace dealii;

  /// A ball around a deformed facet [mm].
  struct FacetBall
  {
    FacetBall(const SurfaceFacet<3> &facet, const std::vector<Point<3>> &x);

    /// The distance of a place from the line through the centre along a unit
    /// vector.
    double distance_across(const Tensor<1, 3> &along, const Point<3> &x) const
    {
      const Tensor<1, 3> way = x - centre;
      return (way - (way * along) * along).norm();
    }

    Point<3> centre;
    double   radius = 0;
  };



  /// Both surfaces of a contact pair in 3-D, where the bodies are.
  struct FaceConfiguration
  {
    FaceConfiguration(const Surface<3>     &slave,
                      const Surface<3>     &master,
                      const SymmetryPlanes &planes,
                      const GhostedVector  &u);

    std::vector<Point<3>>    slave_x, master_x;
    FacetNormals<3>          slave_normals, master_normals;
    const DeformedSurface<3> search; // of the master

    /// The outward normals in the middle of the facets.
    std::vector<Tensor<1, 3>> slave_middles, master_middles;

    std::vector<FacetBall> master_balls;
  };
} // namespace Contact

#endif
