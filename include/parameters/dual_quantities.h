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
    /// Whether the derivative of a quantity by the displacements is known: not
    /// of those of obstacles and rigid boundaries, of supports without contact,
    /// nor of plastic strains.
    inline bool has_dual_problem(const Quantity quantity)
    {
      return (quantity < Quantity::support_x ||
              quantity > Quantity::rotation_z) &&
             (quantity < Quantity::obstacle_force_x ||
              quantity > Quantity::shortening) &&
             quantity != Quantity::plastic_strain;
    }
  } // namespace Parameters
} // namespace Contact

#endif
