/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_crossing_h
#define contact_contact_crossing_h

#include <optional>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  /// A node of one surface that has gone through the other body.
  template<int dim>
  struct ContactCrossing
  {
    bool       of_master = false;
    Point<dim> X;         // its undeformed place [mm]
    double     depth = 0; // behind the side that it went in by [mm]
  };

  /**
   * Look for a node of one surface of a contact pair that goes into the other
   * body by one side of it and comes out by the opposite one while the
   * displacement changes from @p from to @p to. Behind a thin body a node is
   * outside again: its gap there, from the far side, is positive, and says
   * nothing. One that begins on or in the body has gone in by the side that is
   * closest then. Paths are taken to be straight, of nodes and of edges, and
   * these as polygons through their nodes. A node that goes round a tip does
   * not count: the two edges there have a common vertex. Returns the deepest
   * one.
   *
   * Of an obstacle the path is that against its material. It goes through where
   * the closest side is the opposite one from one place to the next, or the
   * place half of the radius deep. In 3-D nothing is looked for between two
   * bodies.
   */
  template<int dim>
  std::optional<ContactCrossing<dim>>
  find_crossing(const ContactPair<dim> &contact_pair,
                const GhostedVector    &from,
                const GhostedVector    &to);

  /// Throw NotConverged if an obstacle has gone through its slave: behind it
  /// all conditions of contact may hold, on its other side.
  template<int dim>
  void check_obstacles(
    const std::vector<std::unique_ptr<const ContactPair<dim>>> &pairs,
    const GhostedVector                                        &from,
    const GhostedVector                                        &to);
} // namespace Contact

#endif
