/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_patches_h
#define contact_contact_patches_h

#include <vector>

#include "contact/points/contact_points.h"
#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A contact point of a surface in 2-D, as seen along its arc length.
  struct PatchSample
  {
    bool   touches, sticks;
    bool   is_held; // by a support: it cannot slip
    double p;       // [MPa]
    double slip;    // magnitude [mm]
    double s = 0;   // arc length [mm]
  };



  /**
   * The patches of contact on a slave in 2-D, and how long they are. A
   * patch is a row of points that touch, or stick, from its first to its last
   * end, also over the place where a closed surface begins. Between two points
   * contact ends where p^2 vanishes, extrapolated linearly from the last two
   * points in contact, and sticking where |slip|^(2/3) vanishes, extrapolated
   * from the first two points that slip: where smooth bodies part, pressure
   * begins with the power 1/2 and a relative displacement with the power 3/2 of
   * the distance (K. L. Johnson, Contact Mechanics, 1985, sections 4.2
   * and 7.2). At the end of a side of the slave contact ends, and so it
   * does opposite to a corner or an end of the master.
   */
  class ContactPatches
  {
  public:
    /// By the arc length at these positions of its nodes.
    ContactPatches(const Surface<2>            &slave,
                   const std::vector<Point<2>> &positions);

    /// Take in what is sampled at a point of the slave.
    void add(const ContactPoint<2> &point, PatchSample sample);

    /// A place of the slave that a corner of the master is opposite to: a patch
    /// that ends in the row of points around it ends there. A point beyond the
    /// @p end of the master touches by its neighbors alone.
    void add_corner(const ContactPoint<2> &corner, const bool end);

    /// The lengths of all patches of points that touch, or that stick [mm].
    double width() const;
    double stick_width() const;

  private:
    /// The edges of a surface that hang together: the arc length goes on from
    /// one such chain to the next, over what is no surface.
    struct Chain
    {
      std::vector<PatchSample> samples;
      std::vector<double>      corners, ends;      // where patches end [mm]
      double                   begin = 0, end = 0; // [mm]
      bool                     is_closed = false;  // the end is the beginning
    };

    double arc_length(const unsigned int edge, const double xi) const;

    /// The arc lengths of the nodes of an edge. That which closes a loop ends
    /// behind all others, not where the loop begins.
    std::vector<double> s_of_edge(const unsigned int edge) const;

    /// The sum over all patches, each from its first to its last end [mm].
    double        length(bool PatchSample::*inside) const;
    static double length(const Chain &chain, bool PatchSample::*inside);

    /// The end of a patch that seems to end at @p end, between its @p last
    /// sample and the @p next one; there is another one @p before.
    static double cut_at_corners(const Chain       &chain,
                                 const double       end,
                                 const PatchSample *before,
                                 const PatchSample &last,
                                 const PatchSample &next);

    const Surface<2>         &slave;
    std::vector<double>       s_of_node;
    std::vector<unsigned int> chain_of_edge;
    std::vector<Chain>        chains;
  };
} // namespace Contact

#endif
