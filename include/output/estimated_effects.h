/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_estimated_effects_h
#define contact_estimated_effects_h

#include <iosfwd>
#include <string>

#include "output/summary.h"

namespace Contact
{
  /// Whether a scene has to have an effect, for an accuracy that is asked for.
  enum class Verdict
  {
    called_for,
    can_be_left_out,
    cannot_be_told
  };

  /// The verdict in words.
  std::string name_of(const Verdict verdict);

  /// By the change of a probe and the error that is accepted of it.
  Verdict verdict_on(const EffectEstimate &estimate, const ProbeResult &probe);

  /// The error that is accepted of each probe: 1 % unless an accuracy is asked
  /// for.
  void accept_errors(const Parameters::Probes &probes, RunSummary &summary);

  /// Print the estimates as a table. Nothing if there are none.
  void print_estimated_effects(std::ostream &out, const RunSummary &summary);
} // namespace Contact

#endif
