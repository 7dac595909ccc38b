/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_logarithmic_strain_h
#define contact_logarithmic_strain_h

#include <memory>

#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The second divided difference of the logarithm at a, b, c > 0,
   *   ln[a, b, c] = (ln[a, b] - ln[b, c])/(a - c),
   * or its limit, -1/(2 a^2) where all are the same; to round-off. The first
   * one is ln[a, b] = (ln a - ln b)/(a - b), or 1/a.
   */
  double divided_logarithm(const double a, const double b);
  double divided_logarithm(double a, double b, double c);



  /**
   * A law of small strain for any strain: a law in the logarithmic strain
   *   e = 1/2 ln C = 1/2 ln(I + 2 E)
   * between two spectral decompositions (C. Miehe, N. Apel and M. Lambrecht,
   * Comput. Methods Appl. Mech. Engrg. 191, 2002, 5383-5425). The energy is
   * W(e), the history that of the law, and plastic strains are subtracted from
   * e. With the stress T = dW/de and the moduli D = dT/de of the law
   *   S = T : P,   dS/dE = P : D : P + T : L,   P = de/dE,   L = dP/dE.
   * Components are those along the eigenvectors of E, with eigenvalues E_i, and
   * c_i = 1 + 2 E_i those of C. The derivatives of the isotropic function e(E)
   * follow from divided differences (Daleckii and Krein): with the first and
   * the second one, f_ij = ln[c_i, c_j] and f_ijk = 2 ln[c_i, c_j, c_k],
   *   (P : X)_ij = f_ij X_ij,
   *   (L : X : Y)_ij = sum_k f_ijk (X_ik Y_kj + Y_ik X_kj).
   * They are continuous where eigenvalues coincide, and so is all that follows.
   *
   * The measure of volume is d = tr e = ln J, dd/dE = C^-1, with the U(d) of
   * the law: where it is projected, the mean of ln J in a cell.
   */
  class LogarithmicStrain : public MaterialLaw
  {
  public:
    explicit LogarithmicStrain(std::unique_ptr<const MaterialLaw> law);

    Response              shear_part(const SymmetricTensor<2, 3> &E,
                                     const double                *history,
                                     const bool with_tangent) const override;
    SymmetricTensor<2, 3> shear_stress(const SymmetricTensor<2, 3> &E,
                                       const double *history) const override;
    SymmetricTensor<4, 3>
           moduli_without_stress(const SymmetricTensor<2, 3> &E,
                                 const double                *history) const override;
    Volume volume(const SymmetricTensor<2, 3> &E) const override;
    SymmetricTensor<4, 3>
    volume_curvature(const SymmetricTensor<2, 3> &E) const override;
    VolumeEnergy volume_energy(const double d) const override;
    double       volume_ratio(const double d) const override;
    unsigned int n_history() const override;
    void         advance(const SymmetricTensor<2, 3> &E,
                         double                      *history) const override;
    Works        works(const SymmetricTensor<2, 3> &E_0,
                       const SymmetricTensor<2, 3> &E_1,
                       const double                *history) const override;

  private:
    const std::unique_ptr<const MaterialLaw> law;
  };
} // namespace Contact

#endif
