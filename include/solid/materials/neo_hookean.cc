/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/materials/neo_hookean.h"

#include <cmath>

namespace Contact
{
  namespace
  {
    SymmetricTensor<2, 3> right_cauchy_green(const SymmetricTensor<2, 3> &E)
    {
      return 2 * E + unit_symmetric_tensor<3>();
    }
  } // namespace



  Distortion::Distortion(const SymmetricTensor<2, 3> &C)
  {
    const double t      = trace(C) / 3;
    const auto   D      = deviator(C) / t;
    const double square = D * D;
    y                   = square / 2 - determinant(D);
    z                   = square / 6;
  }



  SymmetricTensor<4, 3> inverse_twice(const SymmetricTensor<2, 3> &G)
  {
    SymmetricTensor<4, 3> product;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            product[i][j][k][l] = 0.5 * (G[i][k] * G[j][l] + G[i][l] * G[j][k]);
    return product;
  }



  NeoHookean::NeoHookean(const Material &elastic)
    : NeoHookean(elastic, elastic.mu)
  {
  }



  NeoHookean::NeoHookean(const Material &elastic, const double mu)
    : mu(mu)
    , bulk_modulus(elastic.lambda + 2. / 3 * elastic.mu)
  {
  }



  // With G = C^-1 and m = mu J^(-2/3), and y of Distortion:
  //   W = 3/2 mu ((1 - y)^(-1/3) - 1),
  //   S = m (I - tr(C)/3 G),
  //   dS/dE = 2/3 m (tr(C)/3 G x G - G x I - I x G + tr(C) (G . G)).
  MaterialLaw::Response NeoHookean::shear_part(const SymmetricTensor<2, 3> &E,
                                               const double *,
                                               const bool with_tangent) const
  {
    const auto   C  = right_cauchy_green(E);
    const auto   G  = invert(C);
    const auto   I  = unit_symmetric_tensor<3>();
    const double tr = trace(C);
    const double m  = mu * std::pow(determinant(C), -1. / 3);
    Response     response;
    response.stress = m * (I - tr / 3 * G);
    response.energy = 1.5 * mu * std::expm1(-std::log1p(-Distortion(C).y) / 3);
    if (with_tangent)
      response.tangent = 2. / 3 * m *
                         (tr / 3 * outer_product(G, G) - outer_product(G, I) -
                          outer_product(I, G) + tr * inverse_twice(G));
    return response;
  }



  // dJ/dE = J G.
  MaterialLaw::Volume NeoHookean::volume(const SymmetricTensor<2, 3> &E) const
  {
    const auto   C = right_cauchy_green(E);
    const double J = std::sqrt(determinant(C));
    return {J, J * invert(C)};
  }



  SymmetricTensor<4, 3>
  NeoHookean::volume_curvature(const SymmetricTensor<2, 3> &E) const
  {
    const auto C = right_cauchy_green(E);
    const auto G = invert(C);
    return std::sqrt(determinant(C)) *
           (outer_product(G, G) - 2 * inverse_twice(G));
  }



  MaterialLaw::VolumeEnergy NeoHookean::volume_energy(const double d) const
  {
    const double x = d - 1;
    return {0.25 * bulk_modulus * (x * (2 + x) - 2 * std::log1p(x)),
            0.5 * bulk_modulus * (d - 1 / d),
            0.5 * bulk_modulus * (1 + 1 / (d * d))};
  }
} // namespace Contact
