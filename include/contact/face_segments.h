/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_segments_h
#define contact_face_segments_h

#include <utility>

#include "contact/face_clipping.h"
#include "contact/face_dual_functions.h"
#include "contact/face_search.h"
#include "contact/symmetry_planes.h"

namespace Contact
{
  using namespace dealii;

  /// Both surfaces of a contact pair in space, where the bodies are.
  struct FaceConfiguration
  {
    FaceConfiguration(const Surface<3>     &slave,
                      const Surface<3>     &master,
                      const SymmetryPlanes &planes,
                      const GhostedVector  &u);

    std::vector<Point<3>>  slave_x, master_x;
    FacetNormals<3>        slave_normals, master_normals;
    const SurfaceSearch<3> slave_search, search;

    /// The outward normals in the middle of the facets.
    std::vector<Tensor<1, 3>> slave_middles, master_middles;
  };



  /// A Gauss point of a segment, the piece of a slave facet that faces one
  /// master facet.
  struct FaceSample : public FacetSample
  {
    Point<2>     master_xi;
    unsigned int master_facet;
    Tensor<1, 3> distance;           // slave less master [mm]
    Tensor<1, 3> distance_at_corner; // in a corner of the triangle around it
  };



  /**
   * The segments that slave and master are cut into in one configuration.
   *
   * Slave and master facets are projected on a plane, the one through the
   * middle of the slave facet across its normal, and clipped (M. A. Puso and T.
   * A. Laursen, Comput. Methods Appl. Mech. Engrg. 193, 2004); facets of degree
   * 2 in four parts, bilinear between their nodes. The common polygons are cut
   * into triangles with Gauss points. Integrals are over the undeformed slave.
   * Of master facets that lie one behind the other, the nearest is the partner.
   */
  class FaceSegments
  {
  public:
    FaceSegments(const Surface<3>        &slave,
                 const Surface<3>        &master,
                 const FaceConfiguration &now);

    /// The Gauss points of a slave facet.
    std::vector<FaceSample> samples(const unsigned int slave_facet) const;

  private:
    /// A slave facet and its parts in the plane that masters are projected on.
    struct SlaveFacet;

    void add_segment(const SlaveFacet        &own,
                     const unsigned int       master_facet,
                     std::vector<FaceSample> &samples) const;
    void remove_hidden(const SlaveFacet        &own,
                       std::vector<FaceSample> &samples) const;

    /// A master facet and its parts in that plane.
    using ProjectedFacet =
      std::pair<const unsigned int, std::vector<PlaneQuadrangle>>;

    bool is_behind(const FaceSample     &sample,
                   const SlaveFacet     &own,
                   const Point<3>       &on_slave,
                   const Point<2>       &place,
                   const ProjectedFacet &facet) const;

    const Surface<3>        &slave, &master;
    const FaceConfiguration &now;
  };
} // namespace Contact

#endif
