/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_linear_elastic_h
#define contact_linear_elastic_h

#include "solid/materials/kinematics.h"
#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Linear elasticity, with the strain of Green and Lagrange the material of
   * St. Venant and Kirchhoff:
   *   W = mu E : E + lambda/2 tr(E)^2.
   * The integrals over cells know it by its type, so that its functions are
   * inline and its moduli two numbers.
   */
  class LinearElastic final : public MaterialLaw
  {
  public:
    explicit LinearElastic(const Material &elastic)
      : lambda(elastic.lambda)
      , mu(elastic.mu)
    {
    }

    const double lambda, mu; // [MPa]

    bool is_linear() const override
    {
      return true;
    }

    Response shear_part(const SymmetricTensor<2, 3> &E,
                        const double *,
                        const bool with_tangent) const override
    {
      return {2 * mu * E,
              with_tangent ? 2 * mu * identity_tensor<3>()
                           : SymmetricTensor<4, 3>(),
              mu * (E * E)};
    }

    SymmetricTensor<2, 3> shear_stress(const SymmetricTensor<2, 3> &E,
                                       const double *) const override
    {
      return 2 * mu * E;
    }

    Volume volume(const SymmetricTensor<2, 3> &E) const override
    {
      return {trace(E), unit_symmetric_tensor<3>()};
    }

    VolumeEnergy volume_energy(const double d) const override
    {
      return {0.5 * lambda * d * d, lambda * d, lambda};
    }
  };
} // namespace Contact

#endif
