/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_elastic_plastic_h
#define contact_elastic_plastic_h

#include <utility>
#include <vector>

#include "solid/materials/kinematics.h"
#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The yield stress by the equivalent plastic strain a: initial, linear and
   * Voce's part,
   *   Y(a) = Y_0 + H a + (Y_s - Y_0) (1 - exp(-r a)),
   * or linear between the pairs (a, Y) of a curve, and constant beyond.
   * Stresses and moduli in MPa. It never falls.
   */
  struct Hardening
  {
    double initial    = 0;
    double linear     = 0;
    double saturation = 0; // Y_s - Y_0
    double rate       = 0; // [-]
    double kinematic  = 0; // H_k, see ElasticPlastic

    std::vector<std::pair<double, double>> curve = {};

    /// Y(a), dY/da, and the integral of Y - Y_0 from 0 to a.
    struct Values
    {
      double stress, slope, energy;
    };
    Values at(const double a) const;
  };



  /**
   * Elasto-plasticity of von Mises in small strain, with isotropic and linear
   * kinematic hardening (J. C. Simo and T. J. R. Hughes, Computational
   * Inelasticity, 1998, section 3.3). With the deviators e of the strain and
   * s = 2 mu (e - e_p) of the stress, and the back stress 2/3 H_k e_p,
   *   xi = s - 2/3 H_k e_p,   sqrt(3/2) |xi| <= Y(a),
   *   de_p = sqrt(3/2) da xi/|xi|,
   * by the implicit Euler method: radial return, with its consistent tangent.
   * The history is (a, e_p); the energy that of elastic strains and of the
   * hardening, and what is dissipated Y_0 da.
   */
  class ElasticPlastic : public MaterialLaw
  {
  public:
    /// The tangent of a point on the yield surface, as at the start of an
    /// increment, is that of yielding if it @p loads_on: else a neck would
    /// begin each increment as an elastic bar.
    ElasticPlastic(const Material  &elastic,
                   const Hardening &hardening,
                   const bool       loads_on = false);

    Response              shear_part(const SymmetricTensor<2, 3> &E,
                                     const double                *history,
                                     const bool with_tangent) const override;
    SymmetricTensor<2, 3> shear_stress(const SymmetricTensor<2, 3> &E,
                                       const double *history) const override;
    Volume                volume(const SymmetricTensor<2, 3> &E) const override;
    VolumeEnergy          volume_energy(const double d) const override;
    unsigned int          n_history() const override;
    bool                  yields(const SymmetricTensor<2, 3> &E,
                                 const double                *history) const override;

    SymmetricTensor<4, 3> elastic_moduli() const override
    {
      return moduli_of_deviators;
    }

    void  advance(const SymmetricTensor<2, 3> &E,
                  double                      *history) const override;
    Works works(const SymmetricTensor<2, 3> &E_0,
                const SymmetricTensor<2, 3> &E_1,
                const double                *history) const override;

  private:
    struct Trial;
    struct Return;
    Trial  trial(const SymmetricTensor<2, 3> &E, const double *history) const;
    Return return_to_surface(const SymmetricTensor<2, 3> &E,
                             const double                *history) const;
    double plastic_increment(const double q, const double a) const;

    const double    mu, bulk_modulus;
    const Hardening hardening;
    const bool      loads_on;

    /// Of a material that has not yielded yet.
    const Hardening::Values at_first;

    const SymmetricTensor<4, 3> moduli_of_deviators;
  };
} // namespace Contact

#endif
