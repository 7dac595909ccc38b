/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_probes_h
#define contact_probes_h

#include <string>
#include <vector>

#include "model/increment_state.h"
#include "probes/force_probes.h"
#include "probes/traction_probes.h"

namespace Contact
{
  using namespace dealii;

  /// Whether a quantity is a displacement.
  bool is_displacement(const Parameters::Quantity quantity);

  /// Whether a quantity is an energy of a body.
  bool is_energy(const Parameters::Quantity quantity);

  /// Whether a quantity is a stress in a body.
  bool is_stress(const Parameters::Quantity quantity);

  /// The stress [MPa] that a quantity means.
  double stress_component(const Parameters::Quantity   quantity,
                          const SymmetricTensor<2, 3> &stress);

  /// A displacement [mm] or a stress [MPa] at a place. For a displacement @p
  /// vertex_stresses may be empty. Collective.
  template<int dim>
  double probe_value(const Parameters::Quantity                quantity,
                     const Place<dim>                         &place,
                     const Discretization<dim>                &discretization,
                     const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                     const GhostedVector                      &u);

  /// The energy [N mm per mm of thickness] of a named body. Collective.
  template<int dim>
  double body_energy(const std::string       &body,
                     const ContactModel<dim> &model,
                     const GhostedVector     &u);

  /// A probe in a state [mm, MPa, N or N mm per mm of thickness]; at points by
  /// the cells around them alone. On one rank.
  template<int dim>
  double probe_value(const Parameters::Probes::Definition &probe,
                     const ContactModel<dim>              &model,
                     const IncrementState<dim>            &state);

  /// The derivative of a probe with respect to all unknowns, in a state: of
  /// tractions without the forces of corners of the master.
  template<int dim>
  GhostedVector probe_derivative(const Parameters::Probes::Definition &probe,
                                 const ContactModel<dim>              &model,
                                 const GhostedVector &solution);
} // namespace Contact

#endif
