/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/report.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "base/string_utilities.h"
#include "contact/force_probes.h"
#include "output/accuracy.h"
#include "output/effects.h"
#include "output/estimated_effects.h"
#include "output/result_tables.h"

namespace Contact
{
  namespace
  {
    /// A vector out of the body at a facet, undeformed.
    Tensor<1, 2> outward(const Surface<2> &surface, const unsigned int e)
    {
      const auto &nodes = surface.facets[e].nodes;
      return cross_product_2d(surface.nodes[nodes[1]].X -
                              surface.nodes[nodes[0]].X);
    }

    Tensor<1, 3> outward(const Surface<3> &surface, const unsigned int e)
    {
      const auto &nodes = surface.facets[e].nodes;
      return cross_product_3d(surface.nodes[nodes[1]].X -
                                surface.nodes[nodes[0]].X,
                              surface.nodes[nodes[2]].X -
                                surface.nodes[nodes[0]].X);
    }
  } // namespace



  template<int dim>
  Report<dim>::Report(const Parameters::All  &parameters,
                      const ParameterHandler &prm,
                      const bool              verbose,
                      const MPI_Comm          communicator)
    : communicator(communicator)
    , screen(std::cout,
             verbose && parameters.output.screen == Parameters::Screen::full &&
               Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(std::cout, TimerOutput::never, TimerOutput::cpu_and_wall_times)
    , parameters(parameters)
    , prm(prm)
  {
    summary.case_name = parameters.name;
    summary.mesh_file =
      std::filesystem::path(parameters.mesh.file).filename().string();
  }



  template<int dim>
  void Report<dim>::open_files(const Discretization<dim> &discretization)
  {
    this->discretization = &discretization;
    result_files = std::make_unique<ResultFiles<dim>>(parameters.directory(),
                                                      discretization);
    if (!parameters.restart)
      result_files->remove_increments();
    summary.message = "the run has not ended";
    write_summary();
  }



  template<int dim>
  void Report<dim>::begin_anew(const Discretization<dim> &discretization)
  {
    summary.increments.clear();
    replace_results(discretization);
  }



  template<int dim>
  void Report<dim>::replace_results(const Discretization<dim> &discretization)
  {
    result_files = std::make_unique<ResultFiles<dim>>(parameters.directory(),
                                                      discretization);
    result_files->remove_increments();
  }



  template<int dim>
  void Report<dim>::record_size(const ContactModel<dim> &model)
  {
    summary.in_space        = dim == 3;
    summary.n_displacements = model.n_displacements();
    summary.n_multipliers   = model.n_multipliers();
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
    screen << "Increment " << increment << " of "
           << parameters.solution.n_increments << ", load factor "
           << load_factor << std::endl;
  }



  template<int dim>
  void Report<dim>::end_increment()
  {
    IncrementRecord &record = increment();
    record.converged        = true;
    screen << "  converged: " << record.newton_iterations << " Newton steps, "
           << record.friction_iterations << " friction turns, "
           << record.geometry_iterations << " geometry turns" << std::endl;
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

    screen << "Case " << parameters.name << ": "
           << model.mesh->triangulation.n_global_active_cells() << " cells of "
           << summary.mesh_file << ", " << summary.n_displacements
           << " displacements, " << summary.n_multipliers << " multipliers"
           << std::endl;
    if (screen.is_active())
      print_effects(screen.get_stream(), effects);
    print_note_on_histories(*model.discretization);
    if (model.interface)
      for (const auto &contact_pair : parameters.pairs())
        print_note_on_arcs(model, contact_pair);
    if (model.interface)
      {
        print_note_on_facing(*model.interface);
        print_note_on_roles(model);
      }
  }



  // Loads and supports have their values at the ends of increments alone: where
  // a history turns back in between, its peak is never there.
  template<int dim>
  void Report<dim>::print_note_on_histories(
    const Discretization<dim> &discretization)
  {
    const unsigned int n         = parameters.solution.n_increments;
    const unsigned int n_samples = 32; // of an increment
    for (const auto &[entry, is_set] :
         parameters.boundary.entries_with_history())
      {
        if (!is_set || parameters.boundary.histories.count(entry) == 0)
          continue;
        double size = 0, missed = 0, where = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double first = discretization.factor(entry, 1. * k / n);
            const double last  = discretization.factor(entry, (k + 1.) / n);
            size = std::max({size, std::abs(first), std::abs(last)});
            for (unsigned int i = 1; i < n_samples; ++i)
              {
                const double t      = (k + 1. * i / n_samples) / n;
                const double factor = discretization.factor(entry, t);
                const double beyond = std::max(factor - std::max(first, last),
                                               std::min(first, last) - factor);
                if (beyond > missed)
                  {
                    missed = beyond;
                    where  = t;
                  }
              }
          }
        if (missed > 1e-3 * std::max(size, missed))
          print_error(
            ": note: the history of '" + entry +
            "' turns back inside an increment, at about t = " + brief(where) +
            ": only its values at the ends of increments are "
            "applied. Take more increments, so that one ends there");
      }
  }



  // A slave that hardly deforms leaves the conditions of its many nodes to the
  // few of the master: too many for its displacements (inf-sup condition). With
  // moduli of 3, 5 and 10 to 1, quadratic elements and edges of 0.6 to 1, the
  // peak was 1.2, 1.6 and 1.8 times that of the exchanged roles.
  template<int dim>
  void Report<dim>::print_note_on_roles(const ContactModel<dim> &model)
  {
    struct Side
    {
      double length = 0, stiffness = 0;
    };
    const auto mean = [&](const Surface<dim> &surface) {
      Side side;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        {
          side.length += surface.reference_length(e) / surface.facets.size();
          side.stiffness +=
            model.elasticity->youngs_modulus(surface.facets[e].body) /
            surface.facets.size();
        }
      return side;
    };
    const auto entries = parameters.pairs();
    for (unsigned int z = 0; z < entries.size(); ++z)
      {
        const ContactPair<dim> &contact_pair = *model.interface->pairs[z];
        if (!contact_pair.master || contact_pair.tied)
          continue;
        const Side slave  = mean(contact_pair.slave);
        const Side master = mean(*contact_pair.master);
        if (slave.stiffness > 5 * master.stiffness &&
            slave.length < 0.9 * master.length)
          print_error(": note: the slave '" + entries[z].slave +
                      "' is stiffer than its master and has shorter edges: "
                      "pressures oscillate, and their peaks may be twice too "
                      "high. Take the softer surface as slave");
      }
  }



  // A wrong group, or an obstacle whose normal points the other way, would show
  // as a scene without contact.
  template<int dim>
  void Report<dim>::print_note_on_facing(const ContactInterface<dim> &interface)
  {
    const auto entries = parameters.pairs();
    for (unsigned int z = 0; z < entries.size(); ++z)
      {
        const auto          points = interface.points_of(*interface.pairs[z]);
        const Surface<dim> &slave  = interface.pairs[z]->slave;
        const auto          faces  = [&](const ContactPoint<dim> &point) {
          return point.facing &&
                 (point.is_master_corner || entries[z].obstacle.empty() ||
                  outward(slave, point.slave_facet) * point.normal < 0);
        };
        if (std::none_of(points.begin(), points.end(), faces))
          print_error(": note: no point of the slave '" + entries[z].slave +
                      "' faces its " +
                      (entries[z].master.empty()
                         ? "obstacle"
                         : "master '" + entries[z].master + "'") +
                      " to begin with: check the groups, and on which side of "
                      "an obstacle its normal is");
      }
  }



  // A mesh has only a polygon of a circle.
  template<int dim>
  void Report<dim>::print_note_on_arcs(const ContactModel<dim>   &model,
                                       const Parameters::Contact &contact_pair)
  {
    if (parameters.element.degree == 1 && parameters.mesh.refinements == 0 &&
        !parameters.has_levels())
      return;
    for (const std::string &name : {contact_pair.slave, contact_pair.master})
      {
        if (name.empty() || parameters.mesh.is_round(name))
          continue;
        const double bend =
          Surface<dim>(*model.discretization,
                       model.mesh->boundary(name, contact_pair.section()),
                       name)
            .largest_bend();
        if (bend > 0.1)
          screen
            << "Note: '" << name << "' bends by up to " << bend
            << " degrees at a node and is no arc: at degree 2 and on finer "
               "meshes it keeps its corners. "
            << (dim == 2
                  ? "For a circle: Mesh/Arcs = " + name + ": x, y, radius"
                  : "If it is round: Mesh/Spheres, Cylinders, Cones or "
                    "Tori")
            << std::endl;
      }
  }



  template<int dim>
  void Report<dim>::print_level(const ContactModel<dim> &model,
                                const unsigned int       level,
                                const std::string       &system)
  {
    screen << "Level " << level << ": "
           << model.mesh->triangulation.n_global_active_cells() << " cells, "
           << summary.n_displacements << " displacements, "
           << summary.n_multipliers << " multipliers, " << system << std::endl;
  }



  template<int dim>
  void Report<dim>::print_step(const ContactModel<dim> &model,
                               const unsigned int       step,
                               const double             residual,
                               const unsigned int       n_changes)
  {
    screen << "    Newton " << std::setw(2) << step << "  residual "
           << std::scientific << std::setprecision(3) << residual
           << std::defaultfloat << std::setprecision(6);
    if (model.interface)
      {
        const StatusCount count = model.interface->count();
        screen << "  active " << count.active << "  stick " << count.stick
               << "  changes " << n_changes;
      }
    screen << std::endl;
  }



  template<int dim>
  void Report<dim>::record_halvings(const std::vector<double> &residuals)
  {
    increment().halved_steps += residuals.size();
    for (const double residual : residuals)
      screen << "      half of this step: residual " << residual << std::endl;
  }



  template<int dim>
  void Report<dim>::record(const Invariants &found)
  {
    IncrementRecord &record = increment();
    record.invariants       = found.measures();
    record.works            = found.works();
    record.violations       = found.violations;
    record.reactions        = found.reactions;

    std::ostringstream where;
    where << ", load factor " << record.load_factor;
    for (const std::string &note : found.notes)
      print_error(where.str() + ": note: " + note);
    for (const std::string &note :
         notes_on_reactions(parameters.probes, record.probes, record.reactions))
      print_error(where.str() + ": note: " + note);
    for (const std::string &violation : found.violations)
      print_error(where.str() + ": violated: " + violation);
  }



  template<int dim>
  void Report<dim>::print_error(const std::string &message) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      std::cerr << parameters.name << message << std::endl;
  }



  template<int dim>
  void Report<dim>::record(const StrainRange &range)
  {
    summary.strain_range = range;
    screen << "Largest strain " << range.strain << ", largest rotation "
           << range.rotation << " rad" << std::endl;
    const std::string note =
      beyond_range(range,
                   parameters.solids.kinematics == Parameters::Strains::small);
    if (!note.empty())
      print_error(": note: " + note);
  }



  template<int dim>
  void Report<dim>::record(const std::vector<EffectEstimate>   &effects,
                           const std::map<std::string, double> &loop_errors)
  {
    const auto requests      = parameters.probes.requests();
    summary.effect_estimates = effects;
    for (ProbeResult &probe : summary.probes)
      {
        const auto request   = requests.find(probe.name);
        probe.loop_error     = std::abs(loop_errors.at(probe.name));
        probe.accepted_error = request != requests.end()
                                 ? request->second.error_of(probe.value)
                                 : 0.01 * std::abs(probe.value);
      }
  }



  template<int dim>
  void Report<dim>::write_summary() const
  {
    result_files->write_first("summary.json", [this](std::ostream &out) {
      Contact::write_summary(summary, out);
    });
  }



  template<int dim>
  void Report<dim>::finish()
  {
    result_files->write_first("parameters.prm", [this](std::ostream &out) {
      prm.print_parameters(out, ParameterHandler::ShortPRM);
    });
    summary.time     = phase_times(timer);
    summary.counters = discretization->counters.by_name();
    summary.peak_memory_mb =
      Utilities::MPI::sum(peak_memory_mb(), communicator);
    // This file counts, too.
    ++summary.counters["files"];
    write_summary();
    if (summary.converged &&
        Utilities::MPI::this_mpi_process(communicator) == 0)
      std::filesystem::remove(result_files->directory / "restart.bin");

    if (screen.is_active())
      {
        print_levels(screen.get_stream(), summary);
        print_accuracy(screen.get_stream(), summary);
        print_estimated_effects(screen.get_stream(), summary);
        print_counters(screen.get_stream(), summary);
        screen << "Results: " << result_files->directory.string() << std::endl;
      }
  }

  template class Report<2>;
  template class Report<3>;
} // namespace Contact
