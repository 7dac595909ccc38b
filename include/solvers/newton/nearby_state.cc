/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/nearby_state.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Contact
{
  template<int dim>
  bool is_nearby(const Discretization<dim> &discretization,
                 const GhostedVector       &solution,
                 const GhostedVector       &place,
                 const GhostedVector       &start)
  {
    const double        hundredth = 0.01, round_off = 1e-8;
    const GhostedVector u = discretization.displacements(solution);
    std::vector<double> largest{0, 0, 0}; // distance, way, and displacement
    for (unsigned int i = 0; i < u.n_held(); ++i)
      {
        const double now = u.begin()[i];
        largest[0] = std::max(largest[0], std::abs(now - place.begin()[i]));
        largest[1] = std::max(largest[1], std::abs(now - start.begin()[i]));
        largest[2] = std::max(largest[2], std::abs(now));
      }
    Utilities::MPI::max(largest, discretization.communicator, largest);
    return largest[0] <=
           std::max(hundredth * largest[1], round_off * largest[2]);
  }

  template bool is_nearby(const Discretization<2> &discretization,
                          const GhostedVector     &solution,
                          const GhostedVector     &place,
                          const GhostedVector     &start);
  template bool is_nearby(const Discretization<3> &discretization,
                          const GhostedVector     &solution,
                          const GhostedVector     &place,
                          const GhostedVector     &start);
} // namespace Contact
