/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/postprocessor.h"

#include "contact/interface/obstacle_forces.h"
#include "model/rotated_tie.h"
#include "output/body_results.h"
#include "output/notes.h"
#include "probes/probes.h"

namespace Contact
{
  template<int dim>
  Postprocessor<dim>::Postprocessor(const Parameters::All   &parameters,
                                    const ContactModel<dim> &model,
                                    IncrementState<dim>     &state,
                                    Report<dim>             &report)
    : parameters(parameters)
    , model(model)
    , state(state)
    , report(report)
  {
    report.summary.probe_names = parameters.probes.order;
  }



  template<int dim>
  void Postprocessor<dim>::check_probes() const
  {
    for (const auto &[name, probe] : parameters.probes.definitions())
      for (const std::string &point : probe.places)
        {
          if (dim == 2 && is_in_space(probe.quantity))
            throw InputError("there is no " + probe.quantity.name() + " in 2-D",
                             "Probes/Probes, '" + name + "'",
                             "remove the probe, or mesh volumes");
          if (is_force(probe.quantity))
            {
              check_force(name, probe.quantity, point, model);
              continue;
            }
          if (is_of_rigid(probe.quantity))
            {
              model.discretization->rigid_boundary(point, "Probes/Probes");
              continue;
            }
          if (is_of_obstacle(probe.quantity))
            {
              check_obstacle(name,
                             probe.quantity,
                             point,
                             model.interface.get());
              continue;
            }
          if (is_energy(probe.quantity))
            {
              model.mesh->body(point, "Probes/Probes");
              continue;
            }
          model.discretization->place(point, "Probes/Probes");
          if (probe.quantity == Parameters::Quantity::plastic_strain &&
              !model.elasticity->has_history())
            throw InputError("no body is elastic-plastic",
                             "Probes/Probes, '" + name + "'",
                             "remove the probe, or set 'Solids/Material'");
          if (is_contact_traction(probe.quantity))
            check_contact_traction(name,
                                   probe.quantity,
                                   point,
                                   model.interface.get(),
                                   *model.discretization);
        }
  }



  template<int dim>
  const std::vector<SymmetricTensor<2, 3>> &
  Postprocessor<dim>::recovered_stresses()
  {
    if (!recovery)
      recovery = std::make_unique<StressRecovery<dim>>(*model.discretization);
    if (stresses.empty())
      {
        ++model.discretization->counters.stress_recoveries;
        stresses = recovery->vertex_stresses(*model.elasticity, state.solution);
      }
    return stresses;
  }



  template<int dim>
  std::vector<double> Postprocessor<dim>::recovered_plastic_strains()
  {
    if (!model.elasticity->has_history())
      return {};
    if (!recovery)
      recovery = std::make_unique<StressRecovery<dim>>(*model.discretization);
    return recovery->vertex_strains(*model.elasticity);
  }



  template<int dim>
  ContactResults
  Postprocessor<dim>::results(const ContactPair<dim> &contact_pair) const
  {
    return contact_results(*model.interface,
                           contact_pair,
                           state.solution,
                           state.start);
  }



  template<int dim>
  void Postprocessor<dim>::record_increment()
  {
    const RotatedTie<dim> glue(model, state.solution);
    IncrementRecord      &record = report.increment();
    if (model.interface)
      {
        const StatusCount count = model.interface->active_set.count();
        record.active           = count.active;
        record.stick            = count.stick;
        record.slip             = count.active - count.stick;
        for (const auto &contact_pair : model.interface->pairs)
          {
            auto &values = record.contact[contact_pair->name];
            values       = results(*contact_pair).template by_name<dim>();
            if (contact_pair->obstacle || !contact_pair->free_motions.empty())
              values.merge(obstacle_values(*model.interface,
                                           *contact_pair,
                                           state.solution,
                                           state.start));
          }
      }
    record_rotations();
    record_probes(/*with_recovery=*/false);
  }



  template<int dim>
  void Postprocessor<dim>::record_probes(const bool with_recovery)
  {
    for (const auto &[name, definition] : parameters.probes.definitions())
      if (with_recovery ==
          (is_stress(definition.quantity) ||
           definition.quantity == Parameters::Quantity::plastic_strain))
        report.increment().probes[name] = probe(definition);
  }



  template<int dim>
  void Postprocessor<dim>::write_increment(const unsigned int k,
                                           const bool         is_complete)
  {
    const RotatedTie<dim> glue(model, state.solution);
    const auto           &output = parameters.output;
    const bool            is_last =
      is_complete && k == parameters.solution.increments.size();
    if (is_complete)
      {
        TimerOutput::Scope scope(report.timer, "output");
        record_probes(/*with_recovery=*/true);
      }
    if (is_last && model.interface)
      report.summary.contact = report.increment().contact;
    if (is_last)
      report.tell(
        notes_on_result(model, parameters, state.solution, report.summary));
    const bool with_profile = is_last && output.profile;
    const bool with_nodes   = is_last && output.nodes;
    const bool with_bodies =
      is_complete &&
      (!parameters.solids.yield_stress.empty() ||
       !parameters.solids.kinematics.all_are(Parameters::Strains::small));
    if (!output.vtu && !with_profile && !with_nodes && !with_bodies)
      return;
    TimerOutput::Scope scope(report.timer, "output");

    GhostedVector forces;
    if (model.interface && (is_last || output.vtu))
      forces = contact_forces(*model.interface, state.solution, state.start);
    if (with_bodies)
      report.record(body_results(model,
                                 parameters.solids,
                                 is_last &&
                                     !parameters.solids.yield_stress.empty()
                                   ? recovered_stresses()
                                   : std::vector<SymmetricTensor<2, 3>>(),
                                 is_last ? recovered_plastic_strains()
                                         : std::vector<double>(),
                                 state.solution,
                                 is_last ? forces : GhostedVector()),
                    is_last);
    if (with_nodes)
      report.files().write_nodes(state.solution, forces);
    if (!output.vtu && !with_profile)
      return;

    std::vector<PairProfile<dim>> profiles;
    if (model.interface)
      profiles = pair_profiles(*model.interface,
                               *model.discretization,
                               recovered_stresses(),
                               state.solution,
                               state.start,
                               /*with_masters=*/with_profile);
    if (output.vtu)
      report.files().write_bodies(k,
                                  state.load_factor,
                                  recovered_stresses(),
                                  state.solution,
                                  forces,
                                  recovered_plastic_strains());
    if (output.vtu && model.interface)
      report.files().write_contact(k, state.load_factor, profiles);
    if (with_profile && model.interface)
      report.files().write_profile(profiles);
  }



  template<int dim>
  void Postprocessor<dim>::record_level(const unsigned int level,
                                        const bool         is_last,
                                        const std::string &system,
                                        const ProbeErrors &errors)
  {
    const RunSummary &summary = report.summary;
    LevelRecord       record;
    {
      TimerOutput::Scope    scope(report.timer, "output");
      const RotatedTie<dim> glue(model, state.solution);
      for (const auto &[name, definition] : parameters.probes.definitions())
        record.probes[name] = probe(definition);
    }
    record.errors          = errors;
    record.n_cells         = model.mesh->triangulation.n_global_active_cells();
    record.n_displacements = model.n_displacements();
    record.n_multipliers   = model.n_multipliers();
    record.system          = system;
    for (const IncrementRecord &increment : summary.increments)
      if (increment.level == level)
        {
          record.newton_iterations += increment.newton_iterations;
          record.linear_iterations += increment.linear_iterations;
        }
    record.time = phase_times(report.timer);
    for (const LevelRecord &before : summary.levels)
      for (const auto &[phase, time] : before.time)
        {
          record.time[phase].cpu -= time.cpu;
          record.time[phase].wall -= time.wall;
          record.time[phase].calls -= time.calls;
        }
    record.peak_memory_mb =
      Utilities::MPI::sum(peak_memory_mb(), model.discretization->communicator);
    report.summary.levels.push_back(record);
    if (is_last)
      report_probes();
  }



  namespace
  {
    bool is_rotation(const Parameters::Quantity quantity)
    {
      using Parameters::Quantity;
      return quantity == Quantity::rotation_x ||
             quantity == Quantity::rotation_y ||
             quantity == Quantity::rotation_z;
    }



    /// Of the vectors of rotation that differ from @p rotation by full turns
    /// the one that is closest to @p last.
    Tensor<1, 3> continued(const Tensor<1, 3> &rotation,
                           const Tensor<1, 3> &last)
    {
      const double       turn  = 2 * numbers::PI;
      const double       small = 1e-8;
      const Tensor<1, 3> along = rotation.norm() > small ? rotation : last;
      if (along.norm() <= small)
        return rotation;
      const Tensor<1, 3> axis = along / along.norm();
      return rotation +
             turn * std::round((last - rotation) * axis / turn) * axis;
    }
  } // namespace



  // A state tells the rotation of a rigid boundary but for full turns.
  template<int dim>
  void Postprocessor<dim>::record_rotations()
  {
    using Parameters::Quantity;
    const std::array<Quantity, 3> components{
      {Quantity::rotation_x, Quantity::rotation_y, Quantity::rotation_z}};
    IncrementRecord &record     = report.increment();
    const auto      &increments = report.summary.increments;
    for (const auto &named : parameters.probes.definitions())
      if (is_rotation(named.second.quantity))
        for (const std::string &boundary : named.second.places)
          {
            Tensor<1, 3> rotation, last;
            for (unsigned int k = 0; k < 3; ++k)
              rotation[k] = rigid_value(components[k],
                                        boundary,
                                        model,
                                        state.solution,
                                        state.load_factor);
            const auto before =
              std::find_if(std::next(increments.rbegin()),
                           increments.rend(),
                           [&](auto &of) {
                             return of.converged && of.level == record.level;
                           });
            if (before != increments.rend())
              last = before->rotations.at(boundary);
            record.rotations[boundary] = continued(rotation, last);
          }
  }



  // The difference between two points, if there are two.
  template<int dim>
  double
  Postprocessor<dim>::probe(const Parameters::Probes::Definition &definition)
  {
    const double first = value(definition.quantity, definition.places[0]);
    return definition.places.size() == 1
             ? first
             : first - value(definition.quantity, definition.places[1]);
  }



  template<int dim>
  double Postprocessor<dim>::value(const Parameters::Quantity quantity,
                                   const std::string         &point)
  {
    if (is_force(quantity))
      return force_value(quantity, point, model, state);
    if (is_rotation(quantity))
      return report.increment().rotations.at(
        point)[static_cast<int>(quantity) -
               static_cast<int>(Parameters::Quantity::rotation_x)];
    if (is_of_rigid(quantity))
      return rigid_value(quantity,
                         point,
                         model,
                         state.solution,
                         state.load_factor);
    if (is_of_obstacle(quantity))
      return obstacle_value(quantity,
                            point,
                            model.interface.get(),
                            state.solution,
                            state.start);
    if (is_energy(quantity))
      return body_energy(point, model, state.solution);
    const Place<dim> &place =
      model.discretization->place(point, "Probes/Probes");
    if (is_contact_traction(quantity))
      return contact_traction(quantity,
                              place,
                              model.interface.get(),
                              state.solution);
    if (quantity == Parameters::Quantity::plastic_strain)
      return place.interpolate(recovered_plastic_strains(),
                               model.discretization->communicator);
    return probe_value(quantity,
                       place,
                       *model.discretization,
                       is_stress(quantity) ? recovered_stresses() : stresses,
                       state.solution);
  }



  template<int dim>
  void Postprocessor<dim>::report_probes()
  {
    report.summary.probes.clear();
    for (const auto &[name, definition] : parameters.probes.definitions())
      {
        ProbeResult result;
        result.name            = name;
        result.is_displacement = is_displacement(definition.quantity);
        result.unit            = unit_of(definition.quantity,
                              parameters.solids.symmetry,
                              /*in_space=*/dim == 3);
        result.value           = report.summary.levels.back().probes.at(name);
        if (parameters.probes.references.count(name) > 0)
          {
            result.reference = parameters.probes.references.at(name);
            result.tolerance = parameters.probes.tolerances.at(name);
          }
        report.summary.probes.push_back(result);
      }
    if (report.summary.levels.back().errors.mesh.empty())
      estimate_errors(report.summary);
    else
      take_errors_of_level(report.summary);
  }

  template class Postprocessor<2>;
  template class Postprocessor<3>;
} // namespace Contact
