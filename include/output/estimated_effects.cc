/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/estimated_effects.h"

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "base/string_utilities.h"

namespace Contact
{
  std::string name_of(const Verdict verdict)
  {
    switch (verdict)
      {
        case Verdict::called_for:
          return "called for";
        case Verdict::can_be_left_out:
          return "can be left out";
        case Verdict::cannot_be_told:
          return "cannot be told";
      }
    AssertThrow(false, dealii::ExcInternalError());
    return "";
  }



  Verdict verdict_on(const EffectEstimate &estimate, const ProbeResult &probe)
  {
    if (!estimate.unknown.empty())
      return Verdict::cannot_be_told;
    const double change      = std::abs(estimate.changes.at(probe.name));
    const double uncertainty = std::abs(estimate.uncertainties.at(probe.name));
    if (change - uncertainty > *probe.accepted_error)
      return Verdict::called_for;
    if (change + uncertainty <= *probe.accepted_error)
      return Verdict::can_be_left_out;
    return Verdict::cannot_be_told;
  }



  namespace
  {
    /// A line of a probe.
    void print_line(std::ostream         &out,
                    const EffectEstimate &estimate,
                    const ProbeResult    &probe)
    {
      std::ostringstream change, price;
      if (estimate.unknown.empty())
        change << std::showpos << std::scientific << std::setprecision(1)
               << estimate.changes.at(probe.name) << std::noshowpos << " +- "
               << std::abs(estimate.uncertainties.at(probe.name));
      if (estimate.price)
        price << std::setprecision(2) << *estimate.price;
      out << "    " << std::left << std::setw(38) << estimate.effect
          << std::setw(5) << (estimate.is_on ? "on" : "off") << std::setw(22)
          << change.str() << std::setw(7) << price.str()
          << name_of(verdict_on(estimate, probe))
          << (estimate.unknown.empty() ? "" : ": " + estimate.unknown)
          << std::right << '\n';
    }
  } // namespace



  void accept_errors(const Parameters::Probes &probes, RunSummary &summary)
  {
    const auto requests = probes.requests();
    for (ProbeResult &probe : summary.probes)
      {
        const auto request   = requests.find(probe.name);
        probe.accepted_error = request != requests.end()
                                 ? request->second.error_of(probe.value)
                                 : 0.01 * std::abs(probe.value);
      }
  }



  void print_estimated_effects(std::ostream &out, const RunSummary &summary)
  {
    if (summary.effect_estimates.empty())
      return;
    out << "Estimated change of the probes if an effect were taken off, or "
           "added; price: time of a "
        << (summary.in_space ? "run" : "Newton step")
        << " by that of the scene\n";
    for (const ProbeResult &probe : summary.probes)
      {
        out << "  " << probe.name << " = " << probe.value << ' ' << probe.unit
            << ", asked for to " << brief(*probe.accepted_error) << ' '
            << probe.unit;
        if (probe.loop_error)
          out << "; its loops and solvers leave " << brief(*probe.loop_error);
        out << "\n    effect" << std::string(32, ' ') << "     change"
            << std::string(16, ' ') << "price  verdict\n";
        for (const EffectEstimate &estimate : summary.effect_estimates)
          print_line(out, estimate, probe);
      }
  }
} // namespace Contact
