/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_symmetry_planes_h
#define contact_symmetry_planes_h

#include "contact/surfaces/deformed_surface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Planes that slave and master are symmetric to: supports hold nodes of both
   * across them, alike and in the same place. The facets around a node there
   * are those of one side only; the mean of their normals with their images is
   * along the plane.
   */
  class SymmetryPlanes
  {
  public:
    SymmetryPlanes(const Surface<3>           &slave,
                   const Surface<3>           &master,
                   const DiscretizedBodies<3> &discretization);

    /// DeformedSurface::facet_normals() of either surface, along the planes
    /// that their nodes are on.
    FacetNormals<3> facet_normals(const DeformedSurface<3> &now) const;

    /// By node of the undeformed surface, the largest angle [rad] between a
    /// facet there and the mean, that of all facets around an edge or a corner,
    /// too.
    std::vector<double> bends(const Surface<3> &surface,
                              const bool        with_ends) const;

  private:
    struct Plane
    {
      Tensor<1, 3> across;
      double       place;     // undeformed [mm]
      double       tolerance; // [mm]
      NodeDoFs<3>  held;      // a node of the slave
    };

    bool is_on(const Plane &plane, const SurfaceNode<3> &node) const;
    bool is_in_plane(const Surface<3>      &surface,
                     const SurfaceFacet<3> &facet,
                     const unsigned int     side) const;

    const DiscretizedBodies<3> &discretization;
    std::vector<Plane>          planes;
  };
} // namespace Contact

#endif
