/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_ledger_h
#define contact_ledger_h

#include <iosfwd>

#include "parameters.h"
#include "summary.h"

namespace Contact
{
  /**
   * The ledger of a run. At its start: what the scene switches on, what that
   * entails, and the entry that asks for it; one line an effect.
   */
  void print_effects(std::ostream          &out,
                     const RunSummary      &summary,
                     const Parameters::All &parameters);

  /// At its end: what was done, how often, and what was not done at all.
  void print_counters(std::ostream &out, const RunSummary &summary);
} // namespace Contact

#endif
