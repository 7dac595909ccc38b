/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_force_probes_h
#define contact_force_probes_h

#include <string>

#include "model/increment_state.h"
#include "solid/resultant.h"

namespace Contact
{
  using namespace dealii;

  /// Whether a quantity is the resultant of the forces on nodes that supports
  /// hold.
  bool is_reaction(const Parameters::Quantity quantity);

  /// Whether a quantity is the resultant of forces at a boundary, of supports
  /// also at a point.
  bool is_force(const Parameters::Quantity quantity);

  /// Whether a quantity is a rotation of a rigid boundary, or its moment.
  bool is_of_rigid(const Parameters::Quantity quantity);

  /// The rotation [rad] of a rigid boundary, in large displacement a component
  /// of the vector of rotation, or the moment about its point that its supports
  /// exert. Throws InputError if it is none. Collective.
  template<int dim>
  double rigid_value(const Parameters::Quantity quantity,
                     const std::string         &boundary,
                     const ContactModel<dim>   &model,
                     const GhostedVector       &solution,
                     const double               load_factor);

  /// Check that supports, or contact, act on a named group. Throws
  /// InputError with the name of the @p probe. Collective.
  template<int dim>
  void check_force(const std::string         &probe,
                   const Parameters::Quantity quantity,
                   const std::string         &boundary,
                   const ContactModel<dim>   &model);

  /// The resultant that a quantity means at a boundary group, that of supports
  /// also at a point group.
  template<int dim>
  Resultant<dim> resultant(const Parameters::Quantity quantity,
                           const std::string         &boundary,
                           const ContactModel<dim>   &model);

  /// The force that a quantity means there, in a state. Collective.
  template<int dim>
  double force_value(const Parameters::Quantity quantity,
                     const std::string         &boundary,
                     const ContactModel<dim>   &model,
                     const IncrementState<dim> &state);

  /// A sentence on each reaction that is another than the force of the supports
  /// alone, because contact acts on nodes that they hold: by name the values of
  /// the @p probes, and the @p reactions of the groups of supports by
  /// direction.
  Findings notes_on_reactions(
    const Parameters::Probes                                   &probes,
    const std::map<std::string, double>                        &values,
    const std::map<std::string, std::map<std::string, double>> &reactions);
} // namespace Contact

#endif
