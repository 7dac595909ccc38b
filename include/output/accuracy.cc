/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/accuracy.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>

#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    double seconds(const LevelRecord &level)
    {
      double sum = 0;
      for (const auto &[phase, time] : level.time)
        sum += time.wall;
      return sum;
    }



    /// The exponent of a power law through the values on two levels.
    double rate(const LevelRecord &coarse,
                const LevelRecord &fine,
                const double       on_coarse,
                const double       on_fine)
    {
      return std::log(on_fine / on_coarse) /
             std::log(static_cast<double>(fine.n_displacements) /
                      coarse.n_displacements);
    }



    bool has_errors(const std::vector<LevelRecord> &levels)
    {
      return !levels.empty() &&
             std::all_of(levels.begin(), levels.end(), [](const auto &level) {
               return !level.errors.mesh.empty();
             });
    }



    /// The number with two digits.
    std::string rounded(const double number)
    {
      std::ostringstream text;
      text << std::setprecision(2) << number;
      return text.str();
    }



    /// The errors that a mesh and the loops on it have left, by their sources;
    /// the largest one first.
    std::string budget(const LevelRecord &level, const std::string &probe)
    {
      std::vector<std::pair<double, std::string>> sources = {
        {std::abs(level.errors.mesh.at(probe)), "mesh"}};
      for (const auto &[loop, error] : level.errors.loops.at(probe))
        sources.emplace_back(std::abs(error), loop);
      std::sort(sources.rbegin(), sources.rend());
      std::string text;
      for (const auto &[error, source] : sources)
        text += (text.empty() ? "" : ", ") + source + ' ' + rounded(error);
      return text;
    }



    // Errors that change their sign, or grow, have no rate.
    std::string next_digit(const std::vector<LevelRecord> &levels,
                           const std::string              &probe)
    {
      if (levels.size() < 2)
        return "";
      const LevelRecord &fine   = levels.back();
      const LevelRecord &coarse = levels[levels.size() - 2];
      const double       before = coarse.errors.mesh.at(probe);
      const double       error  = fine.errors.mesh.at(probe);
      if (error == 0 || !(error / before > 0) || error / before >= 1)
        return "no rate of the error yet";
      const double growth =
        std::pow(0.1, 1 / rate(coarse, fine, before, error));
      const auto next = forecast(levels, growth);
      return "the next digit costs about " + rounded(next->seconds) +
             " s and " + rounded(next->n_displacements) + " unknowns";
    }
  } // namespace



  std::optional<Forecast> forecast(const std::vector<LevelRecord> &levels,
                                   const double                    growth)
  {
    if (levels.size() < 2 || !has_errors(levels))
      return {};
    const LevelRecord &coarse = levels[levels.size() - 2];
    const LevelRecord &fine   = levels.back();
    const auto extrapolate    = [&](const double before, const double now) {
      return now * std::pow(growth, rate(coarse, fine, before, now));
    };

    Forecast next;
    next.n_displacements = growth * fine.n_displacements;
    next.seconds         = extrapolate(seconds(coarse), seconds(fine));
    for (const auto &[probe, error] : fine.errors.mesh)
      next.errors[probe] =
        extrapolate(std::abs(coarse.errors.mesh.at(probe)), std::abs(error));
    return next;
  }



  namespace
  {
    /// The value of a probe on a fine mesh, as a level estimates it.
    double limit(const LevelRecord &level, const std::string &probe)
    {
      return level.probes.at(probe) + level.errors.mesh.at(probe);
    }



    /// What a sequence that goes on in one direction has before it after three
    /// values, as a geometric one; as far as the last step if it does not get
    /// slower. The singularity of a corner makes steps as slow as that, and an
    /// estimate, which looks one step ahead, is as small as a step.
    double rest(const double first, const double second, const double third)
    {
      const double slowest = 0.9;
      const double step = third - second, last_step = second - first;
      if (!(step * last_step > 0))
        return 0;
      const double ratio = std::min(step / last_step, slowest);
      return step * ratio / (1 - ratio);
    }



    /// The error of a probe on the mesh of the number @p k by its values on
    /// that and the two before, and by the values on a fine mesh that these
    /// estimate.
    double drift(const std::vector<LevelRecord> &levels,
                 const unsigned int              k,
                 const std::string              &probe)
    {
      if (k < 2)
        return 0;
      const auto value = [&](const unsigned int l) {
        return levels[l].probes.at(probe);
      };
      const auto on_fine = [&](const unsigned int l) {
        return limit(levels[l], probe);
      };
      return std::max(std::abs(rest(value(k - 2), value(k - 1), value(k))),
                      std::abs(
                        on_fine(k) - value(k) +
                        rest(on_fine(k - 2), on_fine(k - 1), on_fine(k))));
    }



    /// Twice the estimated error of a probe, which is trusted to that factor
    /// and mostly much better; or how far its value on a fine mesh, as
    /// estimated on one level, is from that of the level before, which was less
    /// accurate; or where the values of the last three lead to.
    double uncertainty(const std::vector<LevelRecord> &levels,
                       const std::string              &probe)
    {
      if (levels.size() < 2)
        return std::numeric_limits<double>::infinity();
      return std::max({2 * std::abs(levels.back().errors.mesh.at(probe)),
                       std::abs(limit(levels.back(), probe) -
                                limit(levels[levels.size() - 2], probe)),
                       drift(levels, levels.size() - 1, probe)});
    }
  } // namespace



  std::string Levels::inaccurate(const std::vector<LevelRecord> &levels) const
  {
    std::string inaccurate;
    for (const auto &[name, request] : parameters.probes.requests())
      {
        const double error    = uncertainty(levels, name);
        const double accepted = request.error_of(levels.back().probes.at(name));
        if (!(error <= accepted))
          inaccurate += (inaccurate.empty() ? "" : "; ") + name + " to " +
                        rounded(error) + " instead of " + rounded(accepted);
      }
    return inaccurate;
  }



  // The limit that another level would break. It is taken to be as much larger
  // as the last one was.
  std::string Levels::broken_limit(const std::vector<LevelRecord> &levels) const
  {
    const double growth =
      levels.size() < 2 ? 4.
                        : static_cast<double>(levels.back().n_displacements) /
                            levels[levels.size() - 2].n_displacements;
    double so_far = 0;
    for (const LevelRecord &level : levels)
      so_far += seconds(level);
    const auto                          next = forecast(levels, growth);
    const std::map<std::string, double> needed{
      {"unknowns", growth * levels.back().n_displacements},
      {"seconds",
       so_far + (next ? next->seconds : growth * seconds(levels.back()))},
      {"megabytes", growth * levels.back().peak_memory_mb}};
    for (const auto &[name, limit] : parameters.refinement.limits)
      if (needed.at(name) > limit)
        return "the next mesh would take some " + rounded(needed.at(name)) +
               ' ' + name + ", and the limit is " + rounded(limit);
    if (parameters.refinement.n_levels > 0 &&
        number >= parameters.refinement.n_levels)
      return "there are no more levels";
    return "";
  }



  bool Levels::end_with(const std::vector<LevelRecord> &levels,
                        std::string                    &missed) const
  {
    missed.clear();
    if (!parameters.asks_for_accuracy())
      return !may_be_followed();
    const std::string probes = inaccurate(levels);
    if (probes.empty())
      return true;
    const std::string limit = broken_limit(levels);
    if (limit.empty())
      return false;
    missed = "the accuracy is not reached: " + probes + ": " + limit;
    return true;
  }



  bool agrees_with_last(const std::vector<LevelRecord> &levels,
                        const unsigned int              number,
                        const std::string              &probe)
  {
    return number > 0 && levels[number].errors.at_corners.count(probe) == 0 &&
           std::max(std::abs(limit(levels[number], probe) -
                             limit(levels[number - 1], probe)),
                    drift(levels, number, probe)) <=
             2 * std::abs(levels[number].errors.mesh.at(probe));
  }



  void print_accuracy(std::ostream &out, const RunSummary &summary)
  {
    if (!has_errors(summary.levels))
      return;
    out << "Accuracy and its price:\n";
    for (const ProbeResult &probe : summary.probes)
      {
        out << "  " << probe.name << " [" << probe.unit << "]\n"
            << "    unknowns           value  est. error  seconds so far\n";
        double so_far       = 0;
        bool   is_confirmed = true;
        for (unsigned int k = 0; k < summary.levels.size(); ++k)
          {
            const LevelRecord &level = summary.levels[k];
            const bool known = agrees_with_last(summary.levels, k, probe.name);
            is_confirmed     = is_confirmed && known;
            so_far += seconds(level);
            out << std::setw(12) << level.n_displacements << ' '
                << std::setw(15) << std::setprecision(8)
                << level.probes.at(probe.name) << "  " << std::setw(10)
                << std::scientific << std::setprecision(1)
                << level.errors.mesh.at(probe.name) << std::defaultfloat
                << (known ? "  " : "? ") << std::setw(14)
                << std::setprecision(3) << so_far << '\n';
          }
        if (!is_confirmed)
          out
            << "    ?: value and error lead elsewhere than on the mesh before, or the "
               "values of three\n       meshes do, by more than twice this error, "
               "or there is no mesh before\n";
        out << "    error by source: "
            << budget(summary.levels.back(), probe.name) << '\n';
        const std::string next = next_digit(summary.levels, probe.name);
        if (!next.empty())
          out << "    " << next << '\n';
      }
    out << std::setprecision(6);
  }
} // namespace Contact
