/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_grid_h
#define contact_contact_grid_h

#include "output/profile.h"
#include "output/vtu/vtu_file.h"

namespace Contact
{
  /// The slave surface of a contact pair as a grid, with the values of its
  /// rows: displacement, pressure, shear, gap, slip and status; shear and slip
  /// are vectors in 3-D, along t in 2-D. An edge of degree 2 is two lines
  /// through its middle node, a facet in 3-D has its degree.
  template<int dim>
  VtuGrid contact_grid(const PairProfile<dim> &contact_pair);
} // namespace Contact

#endif
