/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_derivatives_h
#define contact_tests_derivatives_h

#include "tests.h"

namespace Tests
{
  /// The distance of forces and tangent of bodies from being derivatives.
  struct Deviations
  {
    double forces    = 0; // from those of the energy, by the largest force
    double tangent   = 0; // from that of the forces, by its largest entry
    double asymmetry = 0; // likewise
  };



  /// Compare with central differences, by all unknowns and without constraints.
  /// The forces belong to @p energy, a function of the displacement.
  template<int dim, class Energy>
  Deviations compare_with_differences(const BodiesIn<dim> &bodies,
                                      const GhostedVector &u,
                                      const Energy        &energy)
  {
    FullMatrix<double> K(u.size(), u.size());
    bodies.elasticity->visit_cells(
      u,
      /*with_tangent=*/true,
      [&](const std::vector<types::global_dof_index> &dofs,
          const FullMatrix<double>                   &of_cell,
          const Vector<double> &) {
        for (unsigned int i = 0; i < dofs.size(); ++i)
          for (unsigned int j = 0; j < dofs.size(); ++j)
            K(dofs[i], dofs[j]) += of_cell(i, j);
      });

    Deviations          largest;
    const GhostedVector forces = bodies.elasticity->forces(u, 0);
    const double        h      = 1e-5;
    for (unsigned int j = 0; j < u.size(); ++j)
      {
        GhostedVector before(u), after(u);
        before[j] -= h;
        after[j] += h;
        const double slope = (energy(after) - energy(before)) / (2 * h);
        largest.forces = std::max(largest.forces, std::abs(slope - forces[j]));

        GhostedVector column = bodies.elasticity->forces(after, 0);
        column -= bodies.elasticity->forces(before, 0);
        column /= 2 * h;
        for (unsigned int i = 0; i < u.size(); ++i)
          {
            largest.tangent =
              std::max(largest.tangent, std::abs(column[i] - K(i, j)));
            largest.asymmetry =
              std::max(largest.asymmetry, std::abs(K(i, j) - K(j, i)));
          }
      }
    double largest_entry = 0;
    for (const auto &entry : K)
      largest_entry = std::max(largest_entry, std::abs(entry.value()));
    return {largest.forces / forces.linfty_norm(),
            largest.tangent / largest_entry,
            largest.asymmetry / largest_entry};
  }
} // namespace Tests

#endif
