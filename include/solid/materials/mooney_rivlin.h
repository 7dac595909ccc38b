/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mooney_rivlin_h
#define contact_mooney_rivlin_h

#include "solid/materials/neo_hookean.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The material of Mooney and Rivlin: with C = 2 E + I, J = det(C)^(1/2) and
   * I_2 = 1/2 (tr(C)^2 - tr(C^2)), and C10 + C01 half the shear modulus at zero
   * strain,
   *   W = C10 (J^(-2/3) tr C - 3) + C01 (J^(-4/3) I_2 - 3) + U(J),
   * U that of the neo-Hookean material.
   */
  class MooneyRivlin : public NeoHookean
  {
  public:
    MooneyRivlin(const Material &elastic, const double C01);

    Response shear_part(const SymmetricTensor<2, 3> &E,
                        const double                *history,
                        const bool with_tangent) const override;

  private:
    const double C01;
  };
} // namespace Contact

#endif
