/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/summary.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "base/command_line.h"
#include "output/accuracy.h"
#include "output/estimated_effects.h"

namespace Contact
{
  std::optional<double> ProbeResult::relative_deviation() const
  {
    if (!reference)
      return {};
    return value / *reference - 1;
  }



  bool ProbeResult::within() const
  {
    // Written such that a value that is not a number is outside.
    return !reference || !tolerance ||
           std::abs(*relative_deviation()) <= *tolerance;
  }



  // A mesh that is refined makes starts only: the next one has all increments.
  bool RunSummary::passed() const
  {
    return converged && accuracy_missed.empty() &&
           std::none_of(findings.begin(),
                        findings.end(),
                        [&](const auto &finding) {
                          return finding.is_violated &&
                                 finding.level == increments.back().level;
                        }) &&
           std::all_of(probes.begin(), probes.end(), [](const auto &probe) {
             return probe.within();
           });
  }



  std::map<std::string, PhaseTime> phase_times(const dealii::TimerOutput &timer)
  {
    using dealii::TimerOutput;
    std::map<std::string, PhaseTime> times;
    for (const auto &[phase, time] :
         timer.get_summary_data(TimerOutput::total_cpu_time))
      times[phase].cpu = time;
    for (const auto &[phase, time] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      times[phase].wall = time;
    for (const auto &[phase, n] : timer.get_summary_data(TimerOutput::n_calls))
      times[phase].calls = n;
    return times;
  }



  double peak_memory_mb()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    return memory.VmHWM / 1024.; // from kB
  }



  namespace
  {
    using Json = nlohmann::ordered_json;

    /// A value that may be missing is null then.
    Json to_json(const std::optional<double> &value)
    {
      return value ? Json(*value) : Json();
    }



    Json to_json(const ProbeResult &probe)
    {
      return {{"name", probe.name},
              {"value", probe.value},
              {"unit", probe.unit},
              {"estimated_error", to_json(probe.error)},
              {"estimator", probe.error ? Json(probe.estimator) : Json()},
              {"error_is_confirmed",
               probe.error ? Json(probe.error_is_confirmed) : Json()},
              {"error_may_be_larger",
               probe.error ? Json(probe.error_may_be_larger) : Json()},
              {"not_estimated", probe.not_estimated},
              {"reference", to_json(probe.reference)},
              {"relative_deviation", to_json(probe.relative_deviation())},
              {"tolerance", to_json(probe.tolerance)},
              {"accepted_error", to_json(probe.accepted_error)},
              {"loop_error", to_json(probe.loop_error)}};
    }



    Json to_json(const EffectEstimate           &estimate,
                 const std::vector<ProbeResult> &probes)
    {
      Json json{{"effect", estimate.effect},
                {"on", estimate.is_on},
                {"entries", estimate.entries},
                {"changes", estimate.changes},
                {"uncertainties", estimate.uncertainties},
                {"status_changes", estimate.n_status_changes},
                {"price", to_json(estimate.price)},
                {"unknown", estimate.unknown},
                {"verdicts", Json::object()}};
      for (const ProbeResult &probe : probes)
        json["verdicts"][probe.name] = name_of(verdict_on(estimate, probe));
      return json;
    }



    using ByPair = std::map<std::string, std::map<std::string, double>>;

    /// The unnamed pair is there in any case.
    void add_pairs(const ByPair &pairs, Json &json)
    {
      json["contact"] = Json::object();
      for (const auto &[contact_pair, values] : pairs)
        json[contact_pair.empty() ? "contact" : "contact " + contact_pair] =
          values;
    }



    /// In the order of the @p names, those without one at the end.
    Json in_order(const std::map<std::string, double> &values,
                  const std::vector<std::string>      &names)
    {
      Json json = Json::object();
      for (const std::string &name : names)
        if (const auto value = values.find(name); value != values.end())
          json[name] = value->second;
      json.update(Json(values));
      return json;
    }



    Json to_json(const IncrementRecord          &increment,
                 const std::vector<std::string> &probe_names)
    {
      Json json{{"level", increment.level},
                {"load_factor", increment.load_factor},
                {"newton_iterations", increment.newton_iterations},
                {"linear_iterations", increment.linear_iterations},
                {"friction_iterations", increment.friction_iterations},
                {"geometry_iterations", increment.geometry_iterations},
                {"active", increment.active},
                {"stick", increment.stick},
                {"slip", increment.slip},
                {"halved_steps", increment.halved_steps},
                {"cycles", increment.cycles},
                {"hold_work", increment.hold_work},
                {"converged", increment.converged},
                {"message", increment.message},
                {"invariants", increment.invariants},
                {"works", increment.works},
                {"probes", in_order(increment.probes, probe_names)},
                {"reactions", increment.reactions}};
      add_pairs(increment.contact, json);
      if (!increment.bodies.empty())
        json["bodies"] = increment.bodies;
      return json;
    }



    Json to_json(const std::map<std::string, PhaseTime> &times)
    {
      Json json = Json::object();
      for (const auto &[phase, time] : times)
        {
          json[phase] = {{"cpu", time.cpu}, {"wall", time.wall}};
          if (time.calls > 0)
            json[phase]["calls"] = time.calls;
        }
      return json;
    }



    Json to_json(const LevelRecord              &level,
                 const std::vector<std::string> &probe_names)
    {
      return {{"cells", level.n_cells},
              {"displacements", level.n_displacements},
              {"multipliers", level.n_multipliers},
              {"system", level.system},
              {"newton_iterations", level.newton_iterations},
              {"linear_iterations", level.linear_iterations},
              {"probes", in_order(level.probes, probe_names)},
              {"estimated_errors", level.errors.mesh},
              {"loop_errors", level.errors.loops},
              {"time", to_json(level.time)},
              {"peak_memory_mb", level.peak_memory_mb}};
    }



    /// Of a level that grows as the one with the number @p k has.
    Json forecast_after(const std::vector<LevelRecord> &levels,
                        const unsigned int              k)
    {
      if (k == 0)
        return {};
      const auto next =
        forecast({levels.begin(), levels.begin() + k + 1},
                 static_cast<double>(levels[k].n_displacements) /
                   levels[k - 1].n_displacements);
      if (!next)
        return {};
      return {{"displacements", next->n_displacements},
              {"seconds", next->seconds},
              {"errors", next->errors}};
    }



    Json to_json(const RunSummary &summary)
    {
      Json json{{"case", summary.case_name},
                {"mesh", summary.mesh_file},
                {"program", program_version()},
                {"date", Utilities::System::get_date()},
                {"time_of_day", Utilities::System::get_time()},
                {"converged", summary.converged},
                {"interrupted", summary.interrupted},
                {"message", summary.message},
                {"accuracy_missed", summary.accuracy_missed},
                {"findings", Json::array()},
                {"probes", Json::array()},
                {"increments", Json::array()},
                {"levels", Json::array()},
                {"unknowns",
                 {{"displacement", summary.n_displacements},
                  {"multipliers", summary.n_multipliers}}},
                {"displacements_on_a_process", summary.n_held},
                {"contact", Json::object()},
                {"time", to_json(summary.time)},
                {"peak_memory_mb", summary.peak_memory_mb},
                {"effects", Json::object()},
                {"counters", summary.counters}};
      for (const Finding &finding : summary.findings)
        json["findings"].push_back(
          {{"severity", finding.is_violated ? "violated" : "note"},
           {"where", finding.where},
           {"text", finding.text}});
      for (const ProbeResult &probe : summary.probes)
        json["probes"].push_back(to_json(probe));
      for (const IncrementRecord &increment : summary.increments)
        json["increments"].push_back(to_json(increment, summary.probe_names));
      for (unsigned int k = 0; k < summary.levels.size(); ++k)
        {
          json["levels"].push_back(
            to_json(summary.levels[k], summary.probe_names));
          for (const auto &[name, value] : summary.levels[k].probes)
            if (const double error = believed_error(summary.levels, k, name);
                std::isfinite(error))
              json["levels"].back()["errors"][name] = error;
          json["levels"].back()["forecast"] = forecast_after(summary.levels, k);
        }
      add_pairs(summary.contact, json);
      for (const auto &[effect, value] : summary.effects)
        json["effects"][effect] = value;
      if (!summary.bodies.empty())
        json["bodies"] = summary.bodies;
      if (summary.strain_range)
        json["largest"] = {{"strain", summary.strain_range->strain},
                           {"rotation", summary.strain_range->rotation}};
      for (const EffectEstimate &estimate : summary.effect_estimates)
        json["estimated_effects"].push_back(to_json(estimate, summary.probes));
      return json;
    }
  } // namespace



  void take_errors_of_level(RunSummary &summary)
  {
    const unsigned int last = summary.levels.size() - 1;
    for (ProbeResult &probe : summary.probes)
      {
        probe.error     = believed_error(summary.levels, last, probe.name);
        probe.estimator = "dual weighted residuals";
        probe.error_is_confirmed =
          is_confirmed(summary.levels, last, probe.name);
        probe.error_may_be_larger =
          !probe.error_is_confirmed &&
          (last > 0 ||
           summary.levels[last].errors.at_corners.count(probe.name) > 0 ||
           !doubt(summary.levels, last, probe.name).empty());
      }
  }



  void estimate_errors(RunSummary &summary)
  {
    const auto coarser =
      std::find_if(summary.levels.rbegin(),
                   summary.levels.rend(),
                   [&](const LevelRecord &level) {
                     return 2 * level.n_displacements <=
                            summary.levels.back().n_displacements;
                   });
    if (coarser == summary.levels.rend())
      {
        for (ProbeResult &probe : summary.probes)
          probe.not_estimated = summary.levels.back().errors.not_estimated;
        return;
      }
    const unsigned int n_refinements = coarser - summary.levels.rbegin();
    const auto         has_become    = [&](const unsigned int children) {
      return summary.levels.back().n_cells ==
             coarser->n_cells * std::pow(children, n_refinements);
    };
    const bool is_uniform = has_become(4) || has_become(8);
    for (ProbeResult &probe : summary.probes)
      {
        probe.estimator = "difference from a coarser level";
        probe.error = std::abs(probe.value - coarser->probes.at(probe.name));
        probe.error_is_confirmed = is_uniform;
        if (is_uniform && n_refinements == 1 && summary.levels.size() > 2)
          {
            const unsigned int last = summary.levels.size() - 1;
            probe.error = error_by_values(summary.levels, last, probe.name);
            if (!std::isfinite(*probe.error))
              probe.error.reset();
            probe.error_is_confirmed =
              agrees_with_last(summary.levels, last, probe.name);
          }
        probe.error_may_be_larger = !probe.error_is_confirmed;
      }
  }



  void estimate_errors(RunSummary                     &summary,
                       const std::vector<ProbeResult> &finer)
  {
    for (unsigned int i = 0; i < summary.probes.size(); ++i)
      {
        summary.probes[i].error =
          2 * std::abs(summary.probes[i].value - finer[i].value);
        summary.probes[i].estimator = "difference from the mesh refined once";
      }
  }



  void write_summary(const RunSummary &summary, std::ostream &out)
  {
    // Names of the user need not be UTF-8.
    out << to_json(summary).dump(2,
                                 ' ',
                                 /*ensure_ascii=*/false,
                                 Json::error_handler_t::replace)
        << '\n';
  }



  bool has_converged(const std::filesystem::path &directory)
  {
    std::ifstream file(directory / "summary.json");
    const auto summary = Json::parse(file, nullptr, /*allow_exceptions=*/false);
    return summary.is_object() && summary.value("converged", false);
  }
} // namespace Contact
