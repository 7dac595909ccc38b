/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_transfer_h
#define contact_surface_transfer_h

#include "contact/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /// The part of the solution that belongs to the points, by the place on the
  /// slave: its reference arc length as a part of the whole.
  struct SurfaceState
  {
    std::vector<double>      place;
    std::vector<double>      pressure, shear, bound; // [MPa]
    std::vector<PointStatus> statuses;

    /// Corners of the master, which every mesh has: force and shear [N per
    /// mm], bound [MPa].
    struct Corner
    {
      double      force, shear, bound;
      PointStatus status;
    };
    std::vector<Corner> corners;
  };



  /// The states of all contact pairs, to be carried from one mesh to a finer
  /// one: of discretizations with a point per node.
  std::vector<SurfaceState> save_surfaces(const ContactInterface &interface,
                                          const Vector<double>   &solution);

  /// Set statuses and bounds of the points, and the multipliers in @p solution.
  void restore_surfaces(const std::vector<SurfaceState> &states,
                        ContactInterface                &interface,
                        Vector<double>                  &solution);
} // namespace Contact

#endif
