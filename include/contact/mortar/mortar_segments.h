/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_segments_h
#define contact_mortar_segments_h

#include <utility>
#include <vector>

#include "contact/mortar/mortar_geometry.h"
#include "contact/surfaces/body_overlap.h"

namespace Contact
{
  using namespace dealii;

  /// Round-off of coordinates and coefficients, which are of the order of one.
  constexpr double mortar_round_off = 1e-11;

  /// The part of a slave edge that faces the master.
  struct MortarOverlap
  {
    /// A part of the edge, in its coordinate.
    struct Part
    {
      double low, high;
    };

    /// An end of a segment: an end of the edge, or where the normal meets a
    /// node of the master.
    struct Cut
    {
      double       xi;
      unsigned int master_node = numbers::invalid_unsigned_int;
    };

    /// A piece of a slave edge that faces one master edge.
    struct Segment
    {
      Cut          low, high;
      unsigned int master_facet;
      double       distance; // in the middle [mm]
    };

    std::vector<Segment> segments;
    std::vector<Part>    parts; // from low to high, with holes between

    /// The distance of the place @p xi from the nearest part; zero within one.
    double distance(const double xi) const;
  };



  /// A quadrature point of a segment, or one of its ends, with no weight.
  template<typename Number>
  struct MortarSample
  {
    Number       xi;     // on the slave edge
    Number       weight; // undeformed length [mm]; of rings, area [mm^2]
    unsigned int master_facet;
    Number       master_xi;
  };

  /// The points to integrate in.
  template<typename Number>
  std::vector<MortarSample<Number>>
  mortar_samples(const MortarGeometry<Number> &geometry,
                 const unsigned int            slave_facet,
                 const MortarOverlap          &overlap);



  /**
   * The segments that slave and master are cut into in one configuration:
   * pieces of a slave edge that face one master edge, by the projection of
   * class MortarGeometry.
   *
   * A line along the normal may meet several edges, of pieces that lie one
   * behind the other or of the far side of a body. Ahead of the slave, and
   * behind it, the first edge hides all others; the nearer one that is face to
   * face (class NormalCone) is the partner.
   *
   * An edge may see a near part of the master and, past a convex edge of it, a
   * far one, as over a tooth and the groove beside it. A dual function is
   * negative somewhere: with it a mean over both would take the far part for
   * an overlap of the near one. The edge faces the near part alone, and what is
   * no further than DeformedSurface::overhang times its length.
   */
  class MortarSegments
  {
  public:
    /// In the configuration @p u, which is that of @p geometry.
    MortarSegments(const MortarGeometry<double> &geometry,
                   const GhostedVector          &u,
                   const BodyOverlap<2>         &bodies);

    /// The part of a slave edge that faces the master.
    MortarOverlap overlap(const unsigned int slave_facet) const;

  private:
    using Cut     = MortarOverlap::Cut;
    using Segment = MortarOverlap::Segment;

    /// All of a slave edge that faces the master edges @p candidates.
    std::vector<Segment>
    segments(const unsigned int               slave_facet,
             const std::vector<unsigned int> &candidates) const;

    /// Those of a slave edge without the parts that are far behind the nearest
    /// one.
    std::vector<Segment>
    nearest_run(const unsigned int          slave_facet,
                const std::vector<Segment> &segments) const;

    /// The master edge that the normal from a place of the slave meets, and
    /// how far away.
    std::pair<unsigned int, double>
    partner(const unsigned int               slave_facet,
            const double                     xi,
            const std::vector<unsigned int> &candidates) const;

    /// The master edges near the lines along the normals of a slave edge, up to
    /// a distance from it.
    std::vector<unsigned int> candidates(const unsigned int slave_facet,
                                         const double       reach) const;

    const MortarGeometry<double> &now;
    const BodyOverlap<2>         &bodies;
    const DeformedSurface<2>      search; // on the master
    double                        size;   // of both surfaces together [mm]
  };
} // namespace Contact

#endif
