/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_effects_h
#define contact_effects_h

#include <iosfwd>
#include <string>
#include <vector>

#include "contact/interface/contact_interface.h"
#include "output/summary.h"

namespace Contact
{
  using namespace dealii;

  /// A line of the list of effects.
  struct Effect
  {
    std::string name;
    std::string choice;  // that the scene makes
    std::string entails; // operations for it
    std::string entry;   // that asks for it
  };

  /**
   * The list of effects at the start of a run: what the scene switches on, what
   * that entails, and the entry that asks for it. @p interface is null without
   * contact, @p system says which linear system is solved how.
   */
  template<int dim>
  std::vector<Effect> find_effects(const Parameters::All       &parameters,
                                   const Discretization<dim>   &discretization,
                                   const ContactInterface<dim> *interface,
                                   const std::string           &system);

  void print_effects(std::ostream &out, const std::vector<Effect> &effects);

  /// At the end of a run: the operations, how often each was done, and those
  /// that were not needed.
  void print_counters(std::ostream &out, const RunSummary &summary);
} // namespace Contact

#endif
