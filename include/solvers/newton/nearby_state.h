/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_nearby_state_h
#define contact_nearby_state_h

#include <algorithm>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// Whether the bodies are so close to where they are in @p place that a
  /// tangent made there tells of the stability of the state @p solution: within
  /// a hundredth of their way from @p start, the start of the load increment,
  /// in the largest displacement. Collective.
  template<int dim>
  bool is_nearby(const Discretization<dim> &discretization,
                 const GhostedVector       &solution,
                 const GhostedVector       &place,
                 const GhostedVector       &start)
  {
    const double        hundredth = 0.01, round_off = 1e-8;
    const GhostedVector u             = discretization.displacements(solution);
    const auto          distance_from = [&](const GhostedVector &other) {
      GhostedVector way = u;
      way -= discretization.displacements(other);
      return way.linfty_norm();
    };
    return distance_from(place) <= std::max(hundredth * distance_from(start),
                                            round_off * u.linfty_norm());
  }
} // namespace Contact

#endif
