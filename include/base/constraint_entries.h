/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_constraint_entries_h
#define contact_constraint_entries_h

#include <deal.II/lac/affine_constraints.h>

namespace Contact
{
  using namespace dealii;

  /// Visits of the unknowns that an unknown stands for, with their factors:
  /// itself, or what a constraint expresses it by, which is nothing where it is
  /// held.
  template<typename Number, class Visitor>
  void visit_leaders(const AffineConstraints<Number> &constraints,
                     const types::global_dof_index    dof,
                     const Visitor                   &visit)
  {
    if (const auto *entries = constraints.get_constraint_entries(dof))
      for (const auto &[leader, factor] : *entries)
        visit(leader, factor);
    else
      visit(dof, 1.);
  }
} // namespace Contact

#endif
