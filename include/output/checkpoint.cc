/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/checkpoint.h"

#include <sstream>

#include "base/files.h"
#include "base/restart_file.h"

namespace Contact
{
  template<int dim>
  Checkpoint<dim>::Checkpoint(
    const Parameters::All                      &parameters,
    const ParameterHandler                     &prm,
    const ContactModel<dim>                    &model,
    const std::unique_ptr<InvariantCheck<dim>> &invariants,
    IncrementState<dim>                        &state,
    Pairing<dim>                               &pairing,
    ConvergenceTest<dim>                       &convergence,
    Report<dim>                                &report)
    : parameters(parameters)
    , prm(prm)
    , model(model)
    , invariants(invariants)
    , state(state)
    , pairing(pairing)
    , convergence(convergence)
    , report(report)
  {
  }



  template<int dim>
  void Checkpoint<dim>::write(LoadSteps &steps)
  {
    if (steps.finished())
      return;
    TimerOutput::Scope scope(report.timer, "output");
    report.write_summary();
    report.files().write_first("restart.bin", [&](std::ostream &out) {
      write_restart(out, key(), [&](auto &archive) {
        serialize(archive, steps);
      });
    });
  }



  template<int dim>
  void Checkpoint<dim>::read(LoadSteps &steps)
  {
    const auto file = report.files().directory / "restart.bin";
    if (!std::filesystem::exists(file))
      {
        report.screen << "Nothing to go on from: no " << file << std::endl;
        return;
      }
    read_restart(file, key(), [&](auto &archive) {
      serialize(archive, steps);
    });
    report.files().write_series();
    report.screen << "Restart behind the load factor "
                  << report.increment().load_factor << std::endl;
  }



  template<int dim>
  template<class Archive>
  void Checkpoint<dim>::serialize(Archive &archive, LoadSteps &steps)
  {
    archive  &steps;
    archive  &convergence;
    archive &*invariants;
    archive  &report.summary.increments;
    archive  &report.files();
    archive  &state.solution;
    if (Archive::is_loading::value)
      pairing.pair(state.solution);
    if (model.interface)
      archive &*model.interface;
  }



  // All that has to be the same for a run to be the continuation of another.
  template<int dim>
  std::string Checkpoint<dim>::key() const
  {
    std::ostringstream key;
    key << "contact restart 2, ranks "
        << Utilities::MPI::n_mpi_processes(model.discretization->communicator)
        << ", unknowns " << state.solution.size() << ", mesh "
        << checksum(parameters.mesh.file) << '\n';
    prm.print_parameters(key, ParameterHandler::ShortPRM);
    return key.str();
  }

  template class Checkpoint<2>;
  template class Checkpoint<3>;
} // namespace Contact
