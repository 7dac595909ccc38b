/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_crossing_h
#define contact_contact_crossing_h

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

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &of_master &X &depth;
    }
  };

  /**
   * Look for a node of one surface of a contact pair that goes into the other
   * body by one side of it and on to the opposite one while the displacement
   * changes from @p from to @p to: its closest place on the other surface jumps
   * there, inside, from one side to the other. Behind a thin body a node
   * is outside again: its gap there, from the far side, is positive, and says
   * nothing. Paths are taken to be straight, of an obstacle those against its
   * material. A node that cuts a corner does not count: the facets before and
   * after have a common vertex there. Through a round obstacle it goes half of
   * the radius deep. Returns the deepest one, or the depth zero. Collective.
   */
  template<int dim>
  ContactCrossing<dim> find_crossing(const ContactPair<dim> &contact_pair,
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
