/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_enhanced_cells_h
#define contact_enhanced_cells_h

#include <memory>

#include "solid/cell_kernel.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The cells of an elastic body of degree 1 with assumed strains
   *   E + sum_m alpha_m M_m,
   * E that of the displacement, the alpha_m those of the least energy: a cell
   * bends without shear (J. C. Simo and M. S. Rifai, Int. J. Numer. Methods
   * Eng. 29, 1990, 1595-1638; the incompatible modes of Wilson and Taylor).
   * With the Jacobian J, that in the centre J_0 and the coordinates xi_i from
   * -1/2 to 1/2 the modes are combinations of
   *   J_0^-T e_ij J_0^-1 xi_k / det J - its mean,   i <= j, k = i or j:
   * a constant stress does no work on them, so the patch test is passed.
   *
   * With integral M_m : D : M_n = delta_mn and the stresses T_m = D M_m they
   * leave no unknown, in large displacement as well, where strains are those of
   * Green and Lagrange, because S is linear in the strain:
   *   alpha_m = -integral T_m : E,   S = D E + sum_m alpha_m T_m,
   *   energy = that of E - 1/2 sum_m alpha_m^2,
   * and the tangent is that of D E, under the stress S, minus sum_m g_m g_m^T,
   * g_m the internal forces of T_m. Cells that are compressed by much may
   * buckle in the pattern of an hourglass (P. Wriggers and S. Reese, Comput.
   * Methods Appl. Mech. Eng. 135, 1996, 201-209).
   */
  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  make_enhanced_cells(const Material                  &elastic,
                      std::unique_ptr<CellKernel<dim>> compatible,
                      const bool                       axisymmetric);
} // namespace Contact

#endif
