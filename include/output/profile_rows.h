/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_profile_rows_h
#define contact_profile_rows_h

#include <vector>

#include "output/profile.h"

namespace Contact
{
  using namespace dealii;

  /// The rows of a surface with all that does not ask for the other one:
  /// places, displacements @p u, and the pressure of the stresses @p
  /// vertex_stresses by vertex of the triangulation. Collective.
  template<int dim>
  std::vector<ProfileRow<dim>>
  make_rows(const Surface<dim>                       &surface,
            const Discretization<dim>                &discretization,
            const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
            const GhostedVector                      &u);
} // namespace Contact

#endif
