/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_cycle_control_h
#define contact_pairing_cycle_control_h

#include <limits>

#include "solvers/newton/projection_mismatch.h"

namespace Contact
{
  /**
   * Decides when the pairing, renewed before each Newton step, is to stay.
   *
   * Renewing it converges where the surfaces are smooth. Where a slave point
   * passes a vertex of the master, it may be paired with the edges on either
   * side in turn, and no state is a solution under the pairing it leads to. The
   * pairing is frozen after four steps that each moved the surfaces by less
   * than the geometry tolerance, relative to their way since the start of the
   * increment, and after four steps in a row without progress. Then points are
   * paired anew where Newton's method has converged, until the surfaces are
   * within this tolerance of that place. Where that has twice come no closer,
   * by a half, the pairing jumps between two states for good. Either is
   * accepted, with a note, if the gaps of the closest points differ from its
   * own by no more than this tolerance of the way of a whole increment, and if
   * these move the forces by no more than that part of the size of the slave:
   * displacements then change by no more than that part of themselves, see
   * ProjectionMismatch. Otherwise the increment is made in shorter steps.
   */
  class PairingCycleControl
  {
  public:
    explicit PairingCycleControl(const double geometry_tolerance)
      : tolerance(geometry_tolerance)
    {
    }

    /// A Newton step has moved the surfaces by @p step [mm], since the start of
    /// the increment by @p way [mm]. Progress is a residual below all before.
    void advance(const double step, const double way, const bool progress)
    {
      n_short += step <= tolerance * way;
      n_stalled = progress ? 0 : n_stalled + 1;
      frozen    = frozen || n_short == patience || n_stalled == patience;
    }

    void freeze()
    {
      frozen = true;
    }

    bool is_frozen() const
    {
      return frozen;
    }

    /// The points are paired anew where Newton's method has converged, @p moved
    /// [mm] from where they were paired.
    void renew(const double moved)
    {
      n_idle += moved > last / 2;
      last = moved;
    }

    bool cycles() const
    {
      return n_idle >= 2;
    }

    /// Whether a solution is accepted, @p moved [mm] from where the surfaces
    /// were paired.
    bool accepts(const double moved, const double way) const
    {
      return moved <= tolerance * way;
    }

    /// Whether a solution is accepted that its closest points do not agree
    /// with, where the surfaces move by @p way [mm] in a whole increment.
    bool accepts(const ProjectionMismatch &mismatch, const double way) const
    {
      return accepts(mismatch.gap, way) && mismatch.offset <= tolerance;
    }

  private:
    static constexpr unsigned int patience = 4;

    double       tolerance;
    unsigned int n_short   = 0; // steps that hardly moved a surface
    unsigned int n_stalled = 0; // steps in a row without progress
    unsigned int n_idle    = 0; // renewals that led no closer
    double       last      = std::numeric_limits<double>::max(); // moved [mm]
    bool         frozen    = false;
  };
} // namespace Contact

#endif
