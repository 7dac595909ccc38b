/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_kinematics_h
#define contact_kinematics_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Contact
{
  using namespace dealii;

  /// The part of a stress in the space of the mesh: in 2-D, or all of it.
  template<int dim>
  SymmetricTensor<2, dim> in_space(const SymmetricTensor<2, 3> &stress)
  {
    SymmetricTensor<2, dim> s;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        s[i][j] = stress[i][j];
    return s;
  }



  /// The part of a stress in 2-D.
  inline SymmetricTensor<2, 2> in_plane(const SymmetricTensor<2, 3> &stress)
  {
    return in_space<2>(stress);
  }



  /**
   * Isotropic linear elasticity, by Young's modulus and Poisson's ratio, which
   * make the Lame parameters [MPa]:
   * stress = lambda tr(strain) I + 2 mu strain. With the Green-Lagrange strain
   * and the second Piola-Kirchhoff stress it is the St. Venant-Kirchhoff
   * material.
   */
  struct Material
  {
    Material(const double youngs_modulus, const double poisson)
      : youngs_modulus(youngs_modulus)
      , lambda(youngs_modulus * poisson / ((1 + poisson) * (1 - 2 * poisson)))
      , mu(youngs_modulus / (2 * (1 + poisson)))
    {
    }

    /// Whether it hardly changes its volume: nu > 5/11.
    bool is_nearly_incompressible() const
    {
      return lambda > 10 * mu;
    }

    /// The stress in 2-D, in plane strain; or in 3-D.
    template<int dim>
    SymmetricTensor<2, dim> stress(const SymmetricTensor<2, dim> &strain) const
    {
      return lambda * trace(strain) * unit_symmetric_tensor<dim>() +
             2 * mu * strain;
    }

    /**
     * s : D^-1 : s in plane strain [MPa], twice the energy of the stress s in
     * 2-D. From s = lambda tr(e) I + 2 mu e follow
     *   tr(e) = tr(s) / (2 (lambda + mu)),
     *   s : e = (s : s - lambda tr(s) tr(e)) / (2 mu).
     */
    double energy_density(const SymmetricTensor<2, 2> &s) const
    {
      const double tr = trace(s) / (2 * (lambda + mu));
      return (s * s - lambda * trace(s) * tr) / (2 * mu);
    }

    /// The same of any stress: tr(e) = tr(s) / (3 lambda + 2 mu).
    double energy_density(const SymmetricTensor<2, 3> &s) const
    {
      const double tr = trace(s) / (3 * lambda + 2 * mu);
      return (s * s - lambda * trace(s) * tr) / (2 * mu);
    }

    const double youngs_modulus; // [MPa]
    const double lambda;
    const double mu;
  };



  /**
   * The two kinematics have the same functions, of the displacement gradient
   * H = grad u with respect to the reference configuration, and of h across the
   * plane, where the third axis stretches but does not turn (see
   * symmetry.h; in plane strain and in 3-D h = 0):
   *  - strain(H), strain(h) and their variations through the gradient of motion
   *    F: delta strain = sym(F^T grad delta u), f delta h;
   *  - cauchy(H, h, S): the true stress of a material stress S;
   *  - has_geometric_stiffness: whether the strain itself depends on H to the
   *    second order, which adds S : (grad delta u^T grad u) to the tangent,
   *    and across the plane S33 delta h delta h.
   */
  struct SmallStrain
  {
    static constexpr bool has_geometric_stiffness = false;

    template<int dim>
    static Tensor<2, dim> gradient_of_motion(const Tensor<2, dim> &)
    {
      return unit_symmetric_tensor<dim>();
    }

    static double gradient_of_motion(const double)
    {
      return 1;
    }

    template<int dim>
    static SymmetricTensor<2, dim> strain(const Tensor<2, dim> &H)
    {
      return symmetrize(H);
    }

    static double strain(const double h)
    {
      return h;
    }

    template<int dim>
    static SymmetricTensor<2, 3>
    cauchy(const Tensor<2, dim> &, const double, const SymmetricTensor<2, 3> &S)
    {
      return S;
    }
  };



  /// Total Lagrangian: F = I + H, E = (F^T F - I)/2, sigma = F S F^T / det F.
  struct LargeDisplacement
  {
    static constexpr bool has_geometric_stiffness = true;

    template<int dim>
    static Tensor<2, dim> gradient_of_motion(const Tensor<2, dim> &H)
    {
      return H + static_cast<Tensor<2, dim>>(unit_symmetric_tensor<dim>());
    }

    static double gradient_of_motion(const double h)
    {
      return 1 + h;
    }

    template<int dim>
    static SymmetricTensor<2, dim> strain(const Tensor<2, dim> &H)
    {
      return symmetrize(H) + 0.5 * symmetrize(transpose(H) * H);
    }

    static double strain(const double h)
    {
      return h + 0.5 * h * h;
    }

    template<int dim>
    static SymmetricTensor<2, 3> cauchy(const Tensor<2, dim>        &H,
                                        const double                 h,
                                        const SymmetricTensor<2, 3> &S)
    {
      Tensor<2, 3> F;
      F[2][2] = h;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          F[i][j] = H[i][j];
      for (unsigned int i = 0; i < 3; ++i)
        F[i][i] += 1;
      return symmetrize(F * static_cast<Tensor<2, 3>>(S) * transpose(F)) /
             determinant(F);
    }
  };
} // namespace Contact

#endif
