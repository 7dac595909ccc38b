/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_friction_law_h
#define contact_friction_law_h

#include <algorithm>
#include <cmath>

namespace Contact
{
  /**
   * Dry friction by two numbers: the shear traction q is bounded by
   *   |q| <= tresca_limit + coulomb_coefficient * max(p, 0),
   * p the contact pressure. Frictionless contact is the law with both numbers
   * zero, Tresca's the one with a zero coefficient.
   */
  struct FrictionLaw
  {
    double tresca_limit        = 0; // [MPa]
    double coulomb_coefficient = 0; // [-]

    bool is_frictionless() const
    {
      return tresca_limit == 0 && coulomb_coefficient == 0;
    }

    /// The largest shear traction [MPa] under the pressure @p p [MPa].
    double bound(const double p) const
    {
      return tresca_limit + coulomb_coefficient * std::max(p, 0.);
    }

    /// d bound / dp, from the side of contact at p = 0.
    double bound_derivative(const double p) const
    {
      return p >= 0 ? coulomb_coefficient : 0.;
    }
  };

} // namespace Contact

#endif
