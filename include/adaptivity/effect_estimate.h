/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_effect_estimate_h
#define contact_effect_estimate_h

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Contact
{
  /// The change of the probes by an effect that a scene leaves out, or has: by
  /// the step from the scene to its variant.
  struct EffectEstimate
  {
    std::string              effect;
    bool                     is_on = false; // in the scene
    std::vector<std::string> entries;       // of the variant

    /// By probe [mm or MPa], and how far the estimate may be off.
    std::map<std::string, double> changes = {}, uncertainties = {};

    /// The points of contact that open, close, begin or cease to slip.
    unsigned int n_status_changes = 0;

    /// Why there is no estimate, or nothing.
    std::string unknown = {};

    /// The wall time of a Newton step of the variant, by that of the scene [-];
    /// none if it was not made.
    std::optional<double> price = {};
  };
} // namespace Contact

#endif
