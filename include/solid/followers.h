/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_followers_h
#define contact_followers_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

namespace Contact
{
  using namespace dealii;

  class Discretization;

  /// Add the constraints of serendipity elements: the centre of a quadrangle of
  /// degree 2 follows the corners (-1/4) and the mid-side nodes (1/2).
  void bind_centres(const DoFHandler<2>       &dof_handler,
                    AffineConstraints<double> &constraints);

  /**
   * The unknowns that follow others: hanging nodes, bound centres, ties;
   * without supports. The constraints of an update no longer know of those
   * whose leaders a support fixes.
   */
  AffineConstraints<double> followers(const Discretization &discretization);

  /// Hand over forces on followers to the unknowns that they follow: then a
  /// node carries what it exerts on its support. Collective.
  void hand_over_from_followers(const Discretization &discretization,
                                Vector<double>       &forces);
} // namespace Contact

#endif
