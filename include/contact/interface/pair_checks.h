/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pair_checks_h
#define contact_pair_checks_h

#include <memory>
#include <vector>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  /// Check that no two pairs are about the same lines, and that no slave is
  /// drawn inside of its obstacle. Throws InputError.
  template<int dim>
  void
  check_pairs(const std::vector<std::unique_ptr<const ContactPair<dim>>> &pairs,
              const std::vector<Parameters::Contact> &parameters);
} // namespace Contact

#endif
