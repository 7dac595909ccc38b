/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_traction_probes_h
#define contact_traction_probes_h

#include <string>

#include "contact/interface/contact_interface.h"
#include "solid/discretization.h"
#include "solid/place.h"

namespace Contact
{
  using namespace dealii;

  /// Whether a quantity is a traction of contact.
  bool is_contact_traction(const Parameters::Quantity quantity);

  /// Check that there is one traction of contact at a named point. Throws
  /// InputError with the name of the @p probe and the reason if no slave, or
  /// those of two contact pairs, carry a multiplier there, and for the shear in
  /// 3-D between nodes, whose directions differ.
  template<int dim>
  void check_contact_traction(const std::string           &probe,
                              const Parameters::Quantity   quantity,
                              const std::string           &point,
                              const ContactInterface<dim> *interface,
                              const Discretization<dim>   &discretization);

  /// The traction [MPa] at a place: the multiplier there, between nodes by the
  /// shape functions; zero where there is none, as for the shear without
  /// friction.
  template<int dim>
  double contact_traction(const Parameters::Quantity   quantity,
                          const Place<dim>            &place,
                          const ContactInterface<dim> *interface,
                          const GhostedVector         &solution);

  /// Add the derivative of the traction with respect to all unknowns, without
  /// the forces of corners of the master, times @p factor. At a node of several
  /// multipliers @p solution tells which it is.
  template<int dim>
  void add_traction_derivative(const Parameters::Quantity   quantity,
                               const Place<dim>            &place,
                               const double                 factor,
                               const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               GhostedVector               &derivative);
} // namespace Contact

#endif
