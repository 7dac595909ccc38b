/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_dual_quantities_h
#define contact_dual_quantities_h

#include "parameters/quantities.h"

namespace Contact
{
  namespace Parameters
  {
    /// Whether a quantity is the force in a cut or its shortening; whether it
    /// is that, or is exerted by an obstacle, or the motion of one.
    inline bool is_of_cut(const Quantity quantity)
    {
      return quantity == Quantity::preload || quantity == Quantity::shortening;
    }
    inline bool is_of_obstacle(const Quantity quantity)
    {
      return quantity >= Quantity::obstacle_force_x &&
             quantity <= Quantity::shortening;
    }

    /// Whether it is the resultant of supports without that of contact.
    inline bool is_of_supports_alone(const Quantity quantity)
    {
      return quantity >= Quantity::support_x && quantity <= Quantity::support_z;
    }

    /// Whether the derivative of a quantity by the displacements is known: not
    /// of those of obstacles and rigid boundaries, of supports without contact,
    /// nor of plastic strains.
    inline bool has_dual_problem(const Quantity quantity)
    {
      return (quantity < Quantity::support_x ||
              quantity > Quantity::rotation_z) &&
             !is_of_obstacle(quantity) &&
             quantity != Quantity::plastic_strain &&
             quantity != Quantity::true_pressure;
    }
  } // namespace Parameters
} // namespace Contact

#endif
