/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_stiffness_h
#define contact_pairing_stiffness_h

#include <deal.II/lac/full_matrix.h>

#include "contact/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The stiffness of the pairing of a point: under tractions that stay its
   * forces w C_a (p n + q) change, because coefficients and normal do
   * (PairingChange), and with the normal the tangents:
   *   K_ab = -w (d_C_a (p n + q) + C_a (p d_n - n (q . d_n))) / d_u_b.
   * That the point neither penetrates nor slips changes with the pairing by
   * terms of the order of the gap and of the curvature, which are left out. K
   * is unsymmetric: of use where the matrix is.
   */
  template<int dim>
  struct PairingStiffness
  {
    using Dofs = std::vector<types::global_dof_index>;

    Dofs               rows, columns;
    FullMatrix<double> stiffness; // [N/mm]

    /// Of the points in contact whose slave nodes this rank owns.
    static std::vector<PairingStiffness>
    terms(const ContactInterface<dim> &interface,
          const GhostedVector         &solution,
          const GhostedVector         &u_start);
  };
} // namespace Contact

#endif
