/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_guard_h
#define contact_pairing_guard_h

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
   * increment, and after four steps in a row without progress. A solution under
   * a frozen pairing is accepted by the criterion of the geometry loop: if the
   * surfaces are no further than the geometry tolerance from where they were
   * paired. Otherwise the pairing is renewed again, for twice as many steps.
   */
  class PairingGuard
  {
  public:
    explicit PairingGuard(const double geometry_tolerance)
      : tolerance(geometry_tolerance)
    {
    }

    /// A Newton step has moved the surfaces by @p step [mm], since the start of
    /// the increment by @p way [mm]. Progress is a residual below all before,
    /// or a point that has changed its status.
    void advance(const double step, const double way, const bool progress)
    {
      n_short += step <= tolerance * way;
      n_stalled = progress ? 0 : n_stalled + 1;
    }

    bool is_frozen() const
    {
      return n_short >= patience || n_stalled >= patience;
    }

    /// Newton's method has converged, @p moved [mm] from where the surfaces
    /// were paired.
    bool accepts(const double moved, const double way)
    {
      if (!is_frozen() || moved <= tolerance * way)
        return true;
      patience *= 2;
      n_short = n_stalled = 0;
      return false;
    }

  private:
    const double tolerance;
    unsigned int patience  = 4;
    unsigned int n_short   = 0; // steps that hardly moved a surface
    unsigned int n_stalled = 0; // steps in a row without progress
  };
} // namespace Contact

#endif
