/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_projection_mismatch_h
#define contact_projection_mismatch_h

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The changes that the closest points make to a state that was found under
   * another pairing.
   *
   * With r = sum C_a x_a, from the master to the slave at a point, and t its
   * traction, a displacement z of the bodies takes the work w t . sum C_a z_a
   * of the point's forces. If the pairing moves the projection point of the
   * point along the master by d, which the tangential part of r tells, this
   * work changes by w t . (grad z d): it is that of a couple of the size w |t|
   * |d|, and the forces of contact do the work w |t| L |grad z|, L the size of
   * the slave. So the displacements, and all that follows from the solution,
   * change by the part sum w |t| |d| / (L sum w |t|) of their own, far from the
   * points; it is also the largest moment that the projection points can lose,
   * as ContactInvariants has it. A point with a force and without a closest
   * point has slid off the end of the master and beyond the reach behind that.
   * It counts with the way from its projection point: the state is a solution
   * with a reach that is so much longer. A point without a force may have its
   * projection point anywhere.
   */
  struct ProjectionMismatch
  {
    /// By how much the gaps of points in contact, and the penetrations of
    /// others, change [mm].
    double gap = 0;

    /// The part above, of the contact pair where it is largest, and of the
    /// forces those of points without a closest point [-].
    double offset = 0;
    double unheld = 0;

    /// The mean of |d| in the contact pair where it is largest [mm].
    double shift = 0;

    /// Whether all of it is below a part of the @p way of the surfaces [mm],
    /// and of the size of the slave.
    bool is_below(const double part, const double way) const
    {
      return gap <= part * way && offset <= part && unheld == 0;
    }
  };

  /// Of the state @p solution in an increment that began with the displacement
  /// @p u_start. Glued points keep what they faced undeformed.
  template<int dim>
  ProjectionMismatch mismatch(const ContactInterface<dim> &interface,
                              const GhostedVector         &solution,
                              const GhostedVector         &u_start);
} // namespace Contact

#endif
