/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_strain_range_h
#define contact_strain_range_h

#include <string>

#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /// The largest values among the quadrature points of all bodies.
  struct StrainRange
  {
    double strain   = 0; // modulus of a principal value of E(u) [-]
    double rotation = 0; // of the polar decomposition of F [rad]
  };

  /**
   * That of the displacements @p u: with the strain of Green and Lagrange,
   * E = (F^T F - 1)/2, the hoop strain of rings included. In a plane the
   * rotation of F is atan2(F_21 - F_12, F_11 + F_22); in 3-D, with the
   * rotation R next to F, acos((tr R - 1)/2).
   */
  template<int dim>
  StrainRange strain_range(const Discretization<dim> &discretization,
                           const Vector<double>      &u);

  /// The largest change of the length of a cell's edge in bodies of small
  /// strain, by that length. Collective.
  template<int dim>
  double change_of_edges(const Discretization<dim> &discretization,
                         const Elasticity<dim>     &elasticity,
                         const GhostedVector       &u);

  /**
   * Whether the kinematics are beyond their range there: a sentence, or
   * nothing.
   *
   * Small strain forgets that a rotation by w lengthens by w^2/2: no more than
   * a tenth of the largest strain. In large displacement the law of Saint
   * Venant and Kirchhoff is one of many that are alike while strains are small:
   * along one direction its stress by undeformed area is E (1 + 2 E)^(1/2) by
   * Young's modulus, that of Hencky's logarithmic law log(1 + 2 E)/2 / (1 + 2
   * E)^(1/2). They may differ by a tenth.
   */
  std::string beyond_range(const StrainRange &range,
                           const bool         is_small_strain);
} // namespace Contact

#endif
