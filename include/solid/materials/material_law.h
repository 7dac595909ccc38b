/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_material_law_h
#define contact_material_law_h

#include <deal.II/base/symmetric_tensor.h>

namespace Contact
{
  using namespace dealii;

  /**
   * A material, as a function of the strain E in 3-D [-] (small strain, or that
   * of Green and Lagrange) and of the history of a point at the start of an
   * increment, for the stress S = dW/dE [MPa] (or the second one of Piola and
   * Kirchhoff): W = shear part(E, history) + U(d(E)), d a measure of volume.
   * The cells put the projected P d in the place of d where they have to, see
   * Elasticity. How to add one: CONTRIBUTING.md.
   */
  class MaterialLaw
  {
  public:
    virtual ~MaterialLaw() = default;

    /// Whether the stress is linear in the strain: LinearElastic.
    virtual bool is_linear() const
    {
      return false;
    }

    /// Stress [MPa], if it is asked for its derivative with respect to E, and
    /// the energy by volume.
    struct Response
    {
      SymmetricTensor<2, 3> stress;
      SymmetricTensor<4, 3> tangent;
      double                energy;
    };

    /// Of the part without U, at the end of the increment.
    virtual Response shear_part(const SymmetricTensor<2, 3> &E,
                                const double                *history,
                                const bool with_tangent) const = 0;

    /// Its stress alone, and with the same digits.
    virtual SymmetricTensor<2, 3> shear_stress(const SymmetricTensor<2, 3> &E,
                                               const double *history) const
    {
      return shear_part(E, history, /*with_tangent=*/false).stress;
    }

    /// d(E) [-] and its derivatives.
    struct Volume
    {
      double                value;
      SymmetricTensor<2, 3> slope;
    };
    virtual Volume volume(const SymmetricTensor<2, 3> &E) const = 0;

    /// The second one; zero where d is linear.
    virtual SymmetricTensor<4, 3>
    volume_curvature(const SymmetricTensor<2, 3> &) const
    {
      return SymmetricTensor<4, 3>();
    }

    /// U(d) and its derivatives [MPa].
    struct VolumeEnergy
    {
      double energy, pressure, modulus;
    };
    virtual VolumeEnergy volume_energy(const double d) const = 0;

    /// The ratio det F of volumes that has this d; of large displacement alone.
    virtual double volume_ratio(const double d) const
    {
      return d;
    }

    /// The derivative of the stress of the shear part without what the stress
    /// itself makes of it, positive semidefinite; of large displacement alone.
    virtual SymmetricTensor<4, 3>
    moduli_without_stress(const SymmetricTensor<2, 3> &,
                          const double *history) const
    {
      const SymmetricTensor<2, 3> rest;
      return shear_part(rest, history, /*with_tangent=*/true).tangent;
    }

    /// Numbers of the history of a point, zero at first; the first one is the
    /// equivalent plastic strain [-].
    virtual unsigned int n_history() const
    {
      return 0;
    }

    /// Whether a point of a material with a history yields, and the moduli of
    /// the shear part where none does [MPa].
    virtual bool yields(const SymmetricTensor<2, 3> &, const double *) const
    {
      return false;
    }
    virtual SymmetricTensor<4, 3> elastic_moduli() const
    {
      return SymmetricTensor<4, 3>();
    }

    /// The history at the end of an increment.
    virtual void advance(const SymmetricTensor<2, 3> &, double *) const
    {
    }

    /**
     * By volume [MPa] of an increment from E_0 to E_1: what it dissipates, D,
     * and what energy W and D are more than the work by the trapezoidal rule,
     *   path = W_1 - W_0 + D - 1/2 (S_0 + S_1) : (E_1 - E_0),
     * by a formula of its own; and that work, by the strain that the law itself
     * is one of. Of the shear part, and only of materials with a history.
     */
    struct Works
    {
      double dissipation = 0, path = 0, trapezoid = 0;
    };
    virtual Works works(const SymmetricTensor<2, 3> &,
                        const SymmetricTensor<2, 3> &,
                        const double *) const
    {
      return Works();
    }
  };
} // namespace Contact

#endif
