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
    double seconds(const LevelRecord &level,
                   double PhaseTime::*clock = &PhaseTime::wall)
    {
      double sum = 0;
      for (const auto &[phase, time] : level.time)
        sum += time.*clock;
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



    /// The exponent by which the time grows with the unknowns. That of two
    /// short runs scatters; no method here is cheaper than its unknowns, or
    /// dearer than a sparse factorization in 2-D.
    double rate_of_time(const LevelRecord &coarse,
                        const LevelRecord &fine,
                        const double       on_coarse,
                        const double       on_fine)
    {
      return std::clamp(rate(coarse, fine, on_coarse, on_fine), 1., 1.5);
    }



    /// Whether a level has an estimated error of its own for each probe.
    bool has_estimates(const LevelRecord &level)
    {
      return !level.errors.mesh.empty();
    }



    bool all_have_estimates(const std::vector<LevelRecord> &levels)
    {
      return !levels.empty() &&
             std::all_of(levels.begin(), levels.end(), has_estimates);
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



  } // namespace



  std::optional<Forecast> forecast(const std::vector<LevelRecord> &levels,
                                   const double                    growth)
  {
    if (levels.size() < 2 || !all_have_estimates(levels))
      return {};
    const LevelRecord &coarse = levels[levels.size() - 2];
    const LevelRecord &fine   = levels.back();
    const auto extrapolate    = [&](const double before, const double now) {
      return now * std::pow(growth, rate(coarse, fine, before, now));
    };

    Forecast next;
    next.n_displacements = growth * fine.n_displacements;
    next.seconds =
      seconds(fine) *
      std::pow(growth,
               rate_of_time(coarse, fine, seconds(coarse), seconds(fine)));
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



    /// The change of a probe from the mesh before to that of the number @p k.
    double step_to(const std::vector<LevelRecord> &levels,
                   const unsigned int              k,
                   const std::string              &probe)
    {
      return std::abs(levels[k].probes.at(probe) -
                      levels[k - 1].probes.at(probe));
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
  } // namespace



  double error_by_values(const std::vector<LevelRecord> &levels,
                         const unsigned int              k,
                         const std::string              &probe)
  {
    if (k == 0)
      return std::numeric_limits<double>::infinity();
    const double step = step_to(levels, k, probe);
    if (k == 1)
      return step;
    const auto value = [&](const unsigned int l) {
      return levels[l].probes.at(probe);
    };
    if (value(k - 2) == 0 && value(k - 1) == 0 && value(k) == 0)
      return std::numeric_limits<double>::infinity();
    const bool goes_on =
      (value(k) - value(k - 1)) * (value(k - 1) - value(k - 2)) > 0;
    const double fastest = goes_on ? 1. / 8 : 1. / 2;
    return std::max({step,
                     fastest * step_to(levels, k - 1, probe),
                     std::abs(rest(value(k - 2), value(k - 1), value(k)))});
  }



  double believed_error(const std::vector<LevelRecord> &levels,
                        const unsigned int              k,
                        const std::string              &probe)
  {
    if (!has_estimates(levels[k]))
      return error_by_values(levels, k, probe);
    const double jump =
      k == 0 ? 0. : limit(levels[k], probe) - limit(levels[k - 1], probe);
    return std::max({2 * std::abs(levels[k].errors.mesh.at(probe)),
                     std::abs(jump),
                     drift(levels, k, probe)});
  }



  std::string doubt(const std::vector<LevelRecord> &levels,
                    const unsigned int              k,
                    const std::string              &probe)
  {
    if (levels[k].errors.unresolved.count(probe) > 0)
      return "the contact there is less than four facets wide";
    if (k < 3 || !has_estimates(levels[k]))
      return "";
    const auto step = [&](const unsigned int l) {
      return levels[l].probes.at(probe) - levels[l - 1].probes.at(probe);
    };
    // Steps of a small part of the error tell of the refinement elsewhere.
    const double equal = 0.9, small = 0.5;
    const double least = small * std::abs(levels[k].errors.mesh.at(probe));
    for (const unsigned int l : {k - 1, k})
      if (!(step(l) * step(l - 1) > 0 &&
            std::abs(step(l)) > equal * std::abs(step(l - 1)) &&
            std::abs(step(l)) > least))
        return "";
    return "it goes on in equal steps from mesh to mesh, as a logarithm does";
  }



  bool is_confirmed(const std::vector<LevelRecord> &levels,
                    const unsigned int              k,
                    const std::string              &probe)
  {
    if (!has_estimates(levels[k]))
      return agrees_with_last(levels, k, probe);
    return k > 0 && levels[k].errors.at_corners.count(probe) == 0 &&
           doubt(levels, k, probe).empty();
  }



  namespace
  {
    /// The error that an accuracy is judged by: believed_error() of at least
    /// two meshes; without estimates, the error by the values on at least
    /// three.
    double uncertainty(const std::vector<LevelRecord> &levels,
                       const unsigned int              k,
                       const std::string              &probe)
    {
      const bool estimated = has_estimates(levels[k]);
      if (k < (estimated ? 1 : 2) || !doubt(levels, k, probe).empty())
        return std::numeric_limits<double>::infinity();
      if (!estimated)
        return agrees_with_last(levels, k, probe)
                 ? error_by_values(levels, k, probe)
                 : std::numeric_limits<double>::infinity();
      return believed_error(levels, k, probe);
    }



    /// Whether a probe was zero within its error on the last three meshes.
    bool vanishes(const std::vector<LevelRecord> &levels,
                  const std::string              &probe)
    {
      const unsigned int n_meshes = 3;
      if (levels.size() <= n_meshes)
        return false;
      for (unsigned int k = levels.size() - n_meshes; k < levels.size(); ++k)
        if (std::abs(levels[k].probes.at(probe)) >
            std::max(has_estimates(levels[k]) ? believed_error(levels, k, probe)
                                              : uncertainty(levels, k, probe),
                     step_to(levels, k, probe)))
          return false;
      return true;
    }
  } // namespace



  std::string Levels::inaccurate(const std::vector<LevelRecord> &levels) const
  {
    std::string inaccurate;
    for (const auto &[name, request] : parameters.probes.requests())
      {
        const double error    = uncertainty(levels, levels.size() - 1, name);
        const double accepted = request.error_of(levels.back().probes.at(name));
        const std::string reason = doubt(levels, levels.size() - 1, name);
        if (!(error <= accepted))
          inaccurate +=
            (inaccurate.empty() ? "" : "; ") + name + " to " +
            (std::isfinite(error) ? rounded(error)
                                  : "what so few meshes do not tell") +
            " instead of " + rounded(accepted) +
            (reason.empty() ? "" : " (" + reason + ")");
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
    for (const auto &[name, request] : parameters.probes.requests())
      if (request.is_relative() && vanishes(levels, name))
        {
          missed = "the accuracy is not reached: " + name +
                   " is zero within its error: ask for it in its unit, not in "
                   "% of the value";
          return true;
        }
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
    if (number == 0 || levels[number].errors.at_corners.count(probe) > 0)
      return false;
    if (!has_estimates(levels[number]))
      return number > 1 && 2 * step_to(levels, number, probe) <=
                             step_to(levels, number - 1, probe);
    return std::max(std::abs(limit(levels[number], probe) -
                             limit(levels[number - 1], probe)),
                    drift(levels, number, probe)) <=
           2 * std::abs(levels[number].errors.mesh.at(probe));
  }



  namespace
  {
    /// The error of a probe on a mesh with sign, as it is estimated, or by
    /// values.
    double error_on(const std::vector<LevelRecord> &levels,
                    const unsigned int              number,
                    const std::string              &probe)
    {
      return has_estimates(levels[number])
               ? levels[number].errors.mesh.at(probe)
               : error_by_values(levels, number, probe);
    }



    // The meshes to come, if the error and the unknowns go on as from the last
    // mesh but one to the last. Errors that change their sign, or grow, have no
    // rate.
    std::string next_digit(const std::vector<LevelRecord> &levels,
                           const std::string              &probe)
    {
      const unsigned int last = levels.size() - 1;
      if (last < (has_estimates(levels[last]) ? 1 : 2))
        return "";
      if (!agrees_with_last(levels, last, probe))
        return "no rate of the error yet";
      const double ratio =
        error_on(levels, last, probe) / error_on(levels, last - 1, probe);
      const double growth = static_cast<double>(levels[last].n_displacements) /
                            levels[last - 1].n_displacements;
      if (!(ratio > 0 && ratio < 1 && growth > 1))
        return "no rate of the error yet";
      const double now = seconds(levels[last], &PhaseTime::cpu);
      const double time =
        rate_of_time(levels[last - 1],
                     levels[last],
                     seconds(levels[last - 1], &PhaseTime::cpu),
                     now);
      const double n_meshes = std::ceil(std::log(0.1) / std::log(ratio));
      double       sum      = 0;
      for (unsigned int n = 1; n <= n_meshes; ++n)
        sum += now * std::pow(growth, n * time);
      return "the next digit costs about " + rounded(sum) +
             " s of CPU time: " + rounded(n_meshes) +
             (n_meshes > 1 ? " meshes" : " mesh") + ", the last one of " +
             rounded(levels[last].n_displacements *
                     std::pow(growth, n_meshes)) +
             " unknowns";
    }



    /// The errors on all levels, and what they cost.
    void print_levels(std::ostream                   &out,
                      const std::vector<LevelRecord> &levels,
                      const std::string              &probe)
    {
      double so_far    = 0;
      bool   all_known = true;
      for (unsigned int k = 0; k < levels.size(); ++k)
        {
          const bool   known = is_confirmed(levels, k, probe);
          const double error = believed_error(levels, k, probe);
          all_known          = all_known && known;
          so_far += seconds(levels[k]);
          out << std::setw(12) << levels[k].n_displacements << ' '
              << std::setw(15) << std::setprecision(8)
              << levels[k].probes.at(probe) << "  " << std::setw(10);
          if (std::isfinite(error))
            out << std::scientific << std::setprecision(1) << error
                << std::defaultfloat;
          else
            out << "unknown";
          out << (known ? "  " : "? ") << std::setw(14) << std::setprecision(3)
              << so_far << '\n';
        }
      if (!all_known)
        out
          << "    ?: no mesh before confirms it, or it may be larger: "
          << (has_estimates(levels.back())
                ? "at a corner in\n       contact, where contact is less than "
                  "four facets wide, of a value that goes on\n       in equal "
                  "steps\n"
                : "steps from mesh to\n       mesh do not halve\n");
    }
  } // namespace



  void print_accuracy(std::ostream &out, const RunSummary &summary)
  {
    if (summary.levels.size() < 2)
      return;
    out << "Accuracy and its price:\n";
    for (const ProbeResult &probe : summary.probes)
      {
        const bool estimated = has_estimates(summary.levels.back());
        out << "  " << probe.name << " [" << probe.unit << "]\n"
            << "    unknowns           value  "
            << (estimated ? "     error" : " by values")
            << "  seconds so far\n";
        print_levels(out, summary.levels, probe.name);
        if (estimated)
          out << "    error by source: "
              << budget(summary.levels.back(), probe.name) << '\n';
        const std::string next = next_digit(summary.levels, probe.name);
        if (!next.empty())
          out << "    " << next << '\n';
      }
    out << std::setprecision(6);
  }
} // namespace Contact
