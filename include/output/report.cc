/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/report.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "base/string_utilities.h"
#include "output/accuracy.h"
#include "output/effects.h"
#include "output/estimated_effects.h"
#include "output/history.h"
#include "output/notes.h"
#include "output/result_tables.h"
#include "probes/force_probes.h"

namespace Contact
{
  template<int dim>
  Report<dim>::Report(const Parameters::All  &parameters,
                      const ParameterHandler &prm,
                      const MPI_Comm          communicator)
    : communicator(communicator)
    , run_log(parameters.output.screen,
              Utilities::MPI::this_mpi_process(communicator) == 0)
    , log(run_log.details(), run_log.is_active)
    , screen(run_log.lines(), run_log.is_active)
    , timer(std::cout, TimerOutput::never, TimerOutput::cpu_and_wall_times)
    , parameters(parameters)
    , prm(prm)
    , progress(run_log.is_active && run_log.has_lines_only(),
               parameters.refinement.n_levels,
               Utilities::pow(2, dim))
  {
    summary.case_name = parameters.name;
    summary.mesh_file =
      std::filesystem::path(parameters.mesh.file).filename().string();
    summary.findings = parameters.findings;
  }



  template<int dim>
  void Report<dim>::open_files(const Discretization<dim> &discretization)
  {
    this->discretization = &discretization;
    result_files = std::make_unique<ResultFiles<dim>>(parameters.directory(),
                                                      discretization);
    // What a run is to go on from stays as it is: it may be that of another.
    const bool goes_on =
      std::filesystem::exists(result_files->directory / "restart.bin") &&
      parameters.restart;
    // A scene that cannot be set up has its message already.
    if (summary.message.empty())
      summary.message = "the run has not ended";
    if (goes_on)
      return;
    open_log();
    result_files->remove_series();
    if (!parameters.restart)
      result_files->remove_increments();
    write_summary();
  }



  template<int dim>
  void Report<dim>::open_log()
  {
    run_log.open(result_files->directory / "log.txt",
                 parameters.restart || parameters.is_repeated);
    if (run_log.is_active)
      for (const Finding &finding : parameters.findings)
        run_log.log_only() << line_of(finding) << std::endl;
  }



  template<int dim>
  void Report<dim>::replace_results(const Discretization<dim> &discretization)
  {
    result_files = std::make_unique<ResultFiles<dim>>(parameters.directory(),
                                                      discretization);
    result_files->remove_series();
    result_files->remove_increments();
  }



  template<int dim>
  void Report<dim>::record_size(const ContactModel<dim> &model)
  {
    summary.in_space        = dim == 3;
    summary.n_displacements = model.n_displacements();
    summary.n_multipliers   = model.n_multipliers();
    summary.n_held          = Utilities::MPI::max(
      GhostedVector(model.discretization->distribution).n_held(),
      communicator);
  }



  template<int dim>
  void Report<dim>::begin_increment(const unsigned int level,
                                    const unsigned int increment,
                                    const double       load_factor)
  {
    summary.increments.emplace_back();
    IncrementRecord &record = summary.increments.back();
    record.level            = level;
    record.load_factor      = load_factor;
    increment_timer.restart();
    log << "Increment " << increment << " of "
        << parameters.solution.increments.size() << ", t = " << load_factor
        << std::endl;
  }



  template<int dim>
  void Report<dim>::end_increment()
  {
    IncrementRecord &record = increment();
    record.converged        = true;
    log << "  converged: " << record.newton_iterations << " Newton steps, "
        << record.friction_iterations << " friction iterations, "
        << record.geometry_iterations << " geometry iterations" << std::endl;
  }



  template<int dim>
  void Report<dim>::give_up_increment(const std::string &reason)
  {
    increment().message = reason;
    if (run_log.is_active)
      lines()
        << increment_table.row_without_solution(increment(),
                                                increment_timer.wall_time())
        << std::flush;
    log << "  " << reason << std::endl;
  }



  template<int dim>
  void Report<dim>::print_increment()
  {
    if (run_log.is_active)
      lines() << increment_table.row(increment(), increment_timer.wall_time())
              << std::flush;
  }



  template<int dim>
  std::ostream &Report<dim>::lines()
  {
    progress.clear();
    return run_log.lines();
  }



  template<int dim>
  void Report<dim>::print_scene(const ContactModel<dim> &model,
                                const std::string       &system)
  {
    const std::vector<Effect> effects = find_effects(parameters,
                                                     *model.discretization,
                                                     model.interface.get(),
                                                     system);
    for (const Effect &effect : effects)
      summary.effects[effect.name] = effect.choice;

    if (run_log.is_active)
      print_effects(run_log.details(), effects);
    screen << "Case " << parameters.name << ": "
           << model.mesh->triangulation.n_global_active_cells() << " cells of "
           << summary.mesh_file << ", " << summary.n_displacements
           << " displacements, " << summary.n_multipliers << " multipliers, "
           << system << std::endl;
    tell(notes_on_scene(model, parameters));
    std::vector<std::string> pairs;
    if (model.interface)
      for (const auto &contact_pair : model.interface->pairs)
        pairs.push_back(contact_pair->name);
    increment_table.set_columns(pairs, units());
    screen << increment_table.head() << std::flush;
  }



  template<int dim>
  void Report<dim>::print_level(const ContactModel<dim> &model,
                                const unsigned int       level,
                                const std::string       &system)
  {
    if (run_log.is_active)
      lines() << "Level " << level << ": "
              << model.mesh->triangulation.n_global_active_cells() << " cells, "
              << summary.n_displacements << " displacements, "
              << summary.n_multipliers << " multipliers, " << system
              << std::endl;
  }



  template<int dim>
  void Report<dim>::print_step(const ContactModel<dim> &model,
                               const unsigned int       step,
                               const double             residual,
                               const unsigned int       n_changes)
  {
    log << "    Newton " << std::setw(2) << step << "  residual "
        << std::scientific << std::setprecision(3) << residual
        << std::defaultfloat << std::setprecision(6);
    if (model.interface)
      {
        const StatusCount count = model.interface->active_set.count();
        log << "  active " << count.active << "  stick " << count.stick
            << "  changes " << n_changes;
      }
    log << std::endl;
    progress.draw(summary, step);
  }



  template<int dim>
  void Report<dim>::record_halvings(const std::vector<double> &residuals)
  {
    increment().halved_steps += residuals.size();
    for (const double residual : residuals)
      log << "      half of this step: residual " << residual << std::endl;
  }



  template<int dim>
  void Report<dim>::record(const Invariants &found)
  {
    IncrementRecord &record = increment();
    record.invariants       = found.measures();
    record.works            = found.works();
    record.reactions        = found.reactions;
    tell(found.findings);
    tell(
      notes_on_reactions(parameters.probes, record.probes, record.reactions));
  }



  template<int dim>
  void Report<dim>::tell(const Findings &findings)
  {
    const bool         has_begun = !summary.increments.empty();
    const unsigned int level     = has_begun ? increment().level : 0;
    std::string        where     = parameters.name;
    if (has_begun && parameters.refinement.n_levels > 0)
      where += ", level " + std::to_string(level);
    if (has_begun)
      where += ", t = " + brief(increment().load_factor);
    progress.clear();
    const auto n_told = summary.findings.size();
    for (const Finding &finding : findings)
      Contact::tell({finding.text, finding.is_violated, where, level},
                    summary.findings);
    if (run_log.is_active)
      for (auto i = n_told; i < summary.findings.size(); ++i)
        run_log.log_only() << line_of(summary.findings[i]) << std::endl;
  }



  template<int dim>
  void Report<dim>::record(const std::map<std::string, BodyResult<dim>> &bodies,
                           const bool is_last)
  {
    for (const auto &[name, result] : bodies)
      increment().bodies[name] = result.by_name();
    if (!is_last)
      return;
    summary.bodies = increment().bodies;
    for (const auto &[name, result] : bodies)
      {
        const std::string last = describe(name, result, parameters.solids);
        if (gets_softer(result))
          tell({{last}});
        const IncrementRecord *farthest = &increment();
        for (const IncrementRecord &record : summary.increments)
          if (const auto found = record.bodies.find(name);
              found != record.bodies.end() && record.level == farthest->level)
            for (const char *quantity : {"von_mises", "strain"})
              if (found->second.at(quantity) >
                  farthest->bodies.at(name).at(quantity))
                farthest = &record;
        for (const std::string &text :
             {gets_softer(result) ? "" : last,
              describe_earlier(name,
                               farthest->load_factor,
                               farthest->bodies.at(name),
                               increment().bodies.at(name),
                               parameters.solids)})
          if (!text.empty())
            last_lines += text + '\n';
      }
    const auto &works = increment().works;
    if (const auto found = works.find("plastic_dissipation");
        found != works.end() && found->second > 0)
      last_lines += "Dissipated by yielding: " + brief(found->second) +
                    " N mm" + discretization->per_thickness() + '\n';
  }



  template<int dim>
  void Report<dim>::record(const StrainRange &range)
  {
    summary.strain_range = range;
    screen << "Largest strain " << range.strain << ", largest rotation "
           << range.rotation << " rad" << std::endl;
    tell({{beyond_range(range,
                        parameters.solids.kinematics.all_are(
                          Parameters::Strains::small))}});
  }



  template<int dim>
  void Report<dim>::record(const std::vector<EffectEstimate>   &effects,
                           const std::map<std::string, double> &loop_errors)
  {
    summary.effect_estimates = effects;
    accept_errors(parameters.probes, summary);
    for (ProbeResult &probe : summary.probes)
      probe.loop_error = std::abs(loop_errors.at(probe.name));
  }



  template<int dim>
  void Report<dim>::write_summary() const
  {
    result_files->write_first("summary.json", [this](std::ostream &out) {
      Contact::write_summary(summary, out);
    });
  }



  template<int dim>
  HistoryUnits Report<dim>::units() const
  {
    const auto unit = [&](const Parameters::Quantity quantity) {
      return unit_of(quantity, parameters.solids.symmetry, dim == 3);
    };
    HistoryUnits units{unit(Parameters::Quantity::reaction_x),
                       unit(Parameters::Quantity::strain_energy),
                       {}};
    for (const auto &[name, definition] : parameters.probes.definitions())
      units.probes.emplace_back(name, unit(definition.quantity));
    return units;
  }



  template<int dim>
  void Report<dim>::write_history() const
  {
    result_files->write_first("history.csv", [&](std::ostream &out) {
      Contact::write_history(summary, units(), out);
    });
  }



  template<int dim>
  const std::string &Report<dim>::used_parameters()
  {
    if (printed_parameters.empty())
      {
        std::ostringstream text;
        prm.print_parameters(text, ParameterHandler::ShortPRM);
        printed_parameters = text.str();
      }
    return printed_parameters;
  }



  template<int dim>
  void Report<dim>::finish()
  {
    result_files->write_first("parameters.prm", [this](std::ostream &out) {
      out << used_parameters();
    });
    if (summary.converged)
      for (const std::string &probe : summary.levels.back().errors.at_corners)
        tell(
          {{"'" + probe +
            "' is at a corner in contact, where stresses are singular: "
            "its error can be ten times as large as estimated. Forces, energies "
            "and displacements converge there"}});
    write_history();
    summary.time     = phase_times(timer);
    summary.counters = discretization->counters.by_name();
    summary.peak_memory_mb =
      Utilities::MPI::sum(peak_memory_mb(), communicator);
    // This file counts, too.
    ++summary.counters["files"];
    write_summary();
    if (summary.converged)
      result_files->remove("restart[0-9._]*bin");

    if (run_log.is_active)
      print_end();
  }



  template<int dim>
  void Report<dim>::print_end()
  {
    std::ostream &out = lines();
    print_levels(run_log.details(), summary);
    print_counters(run_log.details(), summary);
    out << last_lines;
    print_accuracy(out, summary);
    print_estimated_effects(out, summary);
    print_table(run_log.log_only(), {summary});
    const auto n_violated =
      std::count_if(summary.findings.begin(),
                    summary.findings.end(),
                    [](const Finding &finding) { return finding.is_violated; });
    double seconds = 0;
    for (const auto &phase : summary.time)
      seconds += phase.second.wall;
    if (!summary.findings.empty())
      out << "Notes: " << summary.findings.size() - n_violated
          << ", violated invariants: " << n_violated
          << " (all in summary.json)\n";
    out << "Results: " << result_files->directory.string() << " ("
        << brief(seconds) << " s, " << brief(summary.peak_memory_mb)
        << " MB; every iteration is in log.txt)" << std::endl;
  }

  template class Report<2>;
  template class Report<3>;
} // namespace Contact
