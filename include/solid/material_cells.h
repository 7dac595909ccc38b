/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_material_cells_h
#define contact_material_cells_h

#include <memory>

#include "solid/cell_kernel.h"
#include "solid/symmetry.h"

namespace Contact
{
  using namespace dealii;

  /// Call @p create with the types of a kinematics and of a symmetry.
  template<int dim, class Create>
  auto with_kinematics(const bool    is_small_strain,
                       const bool    axisymmetric,
                       const Create &create)
  {
    const auto with = [&](const auto symmetry) {
      return is_small_strain ? create(SmallStrain(), symmetry)
                             : create(LargeDisplacement(), symmetry);
    };
    if constexpr (dim == 3)
      return with(Space());
    else
      return axisymmetric ? with(Axisymmetric()) : with(PlaneStrain());
  }

  /**
   * The cells of a body of any MaterialLaw. With the measure of volume d,
   * theta = P d and p = P U'(theta), P the identity or the projection of
   * Elasticity,
   *   S = shear part + p dd/dE,
   * and the tangent has the moduli of the shear part + p d2d/dE2 and
   *   sum_mn H_mn g_m g_n^T,   H_mn = sum_q JxW U''(theta) phi_m phi_n,
   *   g_m = sum_q JxW phi_m (dd/dE : B).
   */
  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  make_material_cells(const Material    &elastic,
                      const MaterialLaw &law,
                      const bool         is_small_strain,
                      const bool         axisymmetric);
} // namespace Contact

#endif
