/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_motion_h
#define contact_pairing_motion_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /// The motion of the pairing of a contact point in 2-D with the bodies:
  /// derivatives with respect to its unknowns.
  class PairingMotion
  {
  public:
    PairingMotion(const ContactInterface<2> &interface,
                  const ContactPoint<2>     &point,
                  const GhostedVector       &solution,
                  const GhostedVector       &u_start);

    /// Add it to the derivatives of the trial values of the point.
    void add_to_trial_values(Vector<double> &p_trial,
                             Vector<double> &q_trial) const;

    /// Add the motion of the loads of the point under its tractions to its
    /// tangent.
    void add_to_tangent(const Traction<2>    &t,
                        const Vector<double> &residual,
                        FullMatrix<double>   &matrix) const;

  private:
    void follow_projection(const GhostedVector &solution,
                           const Tensor<1, 2>  &r);
    void follow_change();

    const ContactInterface<2> &interface;
    const ContactPoint<2>     &point;
    std::vector<unsigned int>  columns; // the places of the unknowns

    FullMatrix<double>  C;      // of the coefficients, by node
    std::vector<double> weight; // of the weight, relative
    std::vector<double> omega;  // d_n = -omega t, d_t = omega n
    std::vector<double> gap;    // of the gap, but for n . sum C_a du_a
    std::vector<double> slip;   // of the slip, but for t . sum C_a du_a
  };
} // namespace Contact

#endif
