/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_neo_hookean_h
#define contact_neo_hookean_h

#include "solid/materials/kinematics.h"
#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * What is lost where energies near zero are differences of numbers near one:
   * with t = tr(C)/3 and D the deviator of C,
   *   det C = t^3 (1 - y),   I_2 = 3 t^2 (1 - z),
   *   y = D : D/(2 t^2) - det(D)/t^3,   z = D : D/(6 t^2).
   */
  struct Distortion
  {
    explicit Distortion(const SymmetricTensor<2, 3> &C);

    double y, z;
  };



  /// -d(C^-1)/dE/2 by the inverse G = C^-1, symmetric in each pair: the double
  /// contraction with X is G X G.
  SymmetricTensor<4, 3> inverse_twice(const SymmetricTensor<2, 3> &G);



  /**
   * The neo-Hookean material, of any compressibility: with C = 2 E + I,
   * J = det(C)^(1/2), shear modulus mu and bulk modulus K at zero strain
   *   W = mu/2 (J^(-2/3) tr C - 3) + K/4 (J^2 - 1 - 2 ln J)
   * (J. C. Simo and T. J. R. Hughes, Computational Inelasticity, 1998, section
   * 9.2). The measure of volume is J: mean dilatation where it is projected.
   */
  class NeoHookean : public MaterialLaw
  {
  public:
    explicit NeoHookean(const Material &elastic);

    /// With another shear modulus [MPa], of a material that has more.
    NeoHookean(const Material &elastic, const double mu);

    Response shear_part(const SymmetricTensor<2, 3> &E,
                        const double                *history,
                        const bool with_tangent) const override;
    Volume   volume(const SymmetricTensor<2, 3> &E) const override;
    SymmetricTensor<4, 3>
    volume_curvature(const SymmetricTensor<2, 3> &E) const override;
    VolumeEnergy volume_energy(const double d) const override;

  private:
    const double mu, bulk_modulus;
  };
} // namespace Contact

#endif
