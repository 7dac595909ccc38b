/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_joining_h
#define contact_point_joining_h

#include <vector>

#include "contact/points/contact_point.h"

namespace Contact
{
  using namespace dealii;

  /// Give the first of the @p joined points the mean of their equations and of
  /// the changes of these, with their weights, see PointFrames.
  template<int dim>
  void join_equations(const std::vector<unsigned int> &joined,
                      std::vector<ContactPoint<dim>>  &points);
} // namespace Contact

#endif
