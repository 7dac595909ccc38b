/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_segments_h
#define contact_face_segments_h

#include <memory>
#include <optional>
#include <utility>

#include "contact/mortar/face_configuration.h"
#include "contact/mortar/face_dual_functions.h"
#include "contact/mortar/facet_parts.h"
#include "contact/surfaces/body_overlap.h"

namespace Contact
{
  using namespace dealii;

  /// A Gauss point of a segment, the piece of a slave facet that faces one
  /// master facet.
  struct FaceSample : public FacetSample
  {
    FaceSample(const FacetSample  &on_slave,
               const Point<2>     &master_xi,
               const unsigned int  master_facet,
               const FacetKind<3> &master_kind)
      : FacetSample(on_slave)
      , master_xi(master_xi)
      , master_facet(master_facet)
      , master_basis(master_kind, master_xi)
    {
    }

    Point<2>     master_xi;
    unsigned int master_facet;
    FacetBasis   master_basis;
    Tensor<1, 3> distance; // slave less master [mm]

    /// In a corner of the triangle around it, if it stands for one.
    std::optional<Tensor<1, 3>> distance_at_corner;

    /// How many there are in the triangle, if it is the first one.
    unsigned int n_of_triangle = 0;
  };



  /**
   * The segments that slave and master are cut into in one configuration.
   *
   * Slave and master facets are projected on a plane, the one through the
   * middle of the slave facet across its normal, and clipped (M. A. Puso and T.
   * A. Laursen, Comput. Methods Appl. Mech. Engrg. 193, 2004); facets of degree
   * 2 in four parts, (bi)linear between their nodes. The common polygons are
   * cut into triangles with Gauss points. Integrals are over the undeformed
   * slave. Of master facets that lie one behind the other, the nearest is the
   * partner. A far side of a body is none.
   */
  class FaceSegments
  {
  public:
    FaceSegments(const Surface<3>        &slave,
                 const Surface<3>        &master,
                 const FaceConfiguration &now,
                 const BodyOverlap<3>    &bodies);

    /// The Gauss points of a slave facet, in a list that is used again.
    const std::vector<FaceSample> &samples(const unsigned int slave_facet);

  private:
    /// A slave facet and its parts in the plane that masters are projected on.
    struct SlaveFacet;

    /// The closest point of the master to a node of the slave.
    struct Closest
    {
      double       distance; // [mm]
      Tensor<1, 3> normal;
    };
    const Closest &closest_to(const unsigned int slave_node);

    double distance_to_master(const unsigned int   slave_node,
                              const NormalCone<3> &directions);

    /// False if no facet of the master is in front of or behind a slave facet
    /// and face to face with it.
    bool has_partners(const SlaveFacet    &own,
                      const NormalCone<3> &directions) const;

    void add_segment(const SlaveFacet &own, const unsigned int master_facet);
    void remove_far_sides(const SlaveFacet &own);
    void remove_hidden(const SlaveFacet &own);

    /// A facet and its parts in that plane.
    using ProjectedFacet = std::pair<unsigned int, std::vector<ProjectedPart>>;

    /// The distance along the normal of @p own of its @p on_slave from another
    /// facet of a surface, whose nodes are at @p x, if that is there.
    std::optional<double> distance_along(const SlaveFacet            &own,
                                         const Point<3>              &on_slave,
                                         const Surface<3>            &surface,
                                         const std::vector<Point<3>> &x,
                                         const ProjectedFacet &facet) const;

    ProjectedFacet projected(const SlaveFacet            &own,
                             const Surface<3>            &surface,
                             const std::vector<Point<3>> &x,
                             const unsigned int           facet) const;

    Point<3> place_of(const FaceSample &sample, const SlaveFacet &own) const;

    const Surface<3>        &slave, &master;
    const FaceConfiguration &now;
    const BodyOverlap<3>    &bodies;

    /// By node, as far as they have been asked for.
    std::vector<std::optional<Closest>> closest;

    std::vector<FaceSample> of_facet;
  };
} // namespace Contact

#endif
