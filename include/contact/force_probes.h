/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_force_probes_h
#define contact_force_probes_h

#include <string>

#include "contact/contact_model.h"
#include "solid/resultant.h"

namespace Contact
{
  using namespace dealii;

  /// Whether a quantity is the resultant of the forces of supports.
  bool is_reaction(const Parameters::Quantity quantity);

  /// Whether a quantity is the resultant of forces at a boundary.
  bool is_force(const Parameters::Quantity quantity);

  /// Check that supports, or contact, act on a named boundary. Throws
  /// InputError with the name of the @p probe. Collective.
  template<int dim>
  void check_force(const std::string         &probe,
                   const Parameters::Quantity quantity,
                   const std::string         &boundary,
                   const ContactModel<dim>   &model);

  /// The resultant that a quantity means at a boundary group.
  template<int dim>
  Resultant<dim> resultant(const Parameters::Quantity quantity,
                           const std::string         &boundary,
                           const ContactModel<dim>   &model);
} // namespace Contact

#endif
