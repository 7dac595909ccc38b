/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/materials/mooney_rivlin.h"

#include <cmath>

namespace Contact
{
  MooneyRivlin::MooneyRivlin(const Material &elastic, const double C01)
    : NeoHookean(elastic, elastic.mu - 2 * C01)
    , C01(C01)
  {
  }



  // With y and z of Distortion the energy of I_2 is
  //   3 C01 ((1 - z) (1 - y)^(-2/3) - 1);
  // with G = C^-1, A = dI_2/dC = tr(C) I - C and m = 2 C01 J^(-4/3), besides
  // the neo-Hookean part
  //   S = m (A - 2/3 I_2 G),
  //   dS/dE = 2 m (I x I - 1 - 2/3 (A x G + G x A) + 4/9 I_2 G x G
  //                + 2/3 I_2 (G . G)).
  MaterialLaw::Response MooneyRivlin::shear_part(const SymmetricTensor<2, 3> &E,
                                                 const double *history,
                                                 const bool with_tangent) const
  {
    Response     response = NeoHookean::shear_part(E, history, with_tangent);
    const auto   I        = unit_symmetric_tensor<3>();
    const auto   C        = 2 * E + I;
    const auto   G        = invert(C);
    const auto   A        = trace(C) * I - C;
    const double I_2      = 0.5 * (A * C);
    const double m        = 2 * C01 * std::pow(determinant(C), -2. / 3);
    response.stress += m * (A - 2. / 3 * I_2 * G);
    const Distortion distortion(C);
    const double     more = std::expm1(-2 * std::log1p(-distortion.y) / 3);
    response.energy += 3 * C01 * (more - distortion.z * (1 + more));
    if (with_tangent)
      response.tangent +=
        2 * m *
        (outer_product(I, I) - identity_tensor<3>() -
         2. / 3 * (outer_product(A, G) + outer_product(G, A)) +
         4. / 9 * I_2 * outer_product(G, G) + 2. / 3 * I_2 * inverse_twice(G));
    return response;
  }
} // namespace Contact
