/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/checkpoint.h"

#include <sstream>

#include "base/all_ranks.h"
#include "base/files.h"
#include "base/restart_file.h"
#include "solid/cell_values.h"

namespace Contact
{
  template<int dim>
  Checkpoint<dim>::Checkpoint(
    const Parameters::All                      &parameters,
    const ContactModel<dim>                    &model,
    const std::unique_ptr<InvariantCheck<dim>> &invariants,
    IncrementState<dim>                        &state,
    Pairing<dim>                               &pairing,
    ConvergenceTest<dim>                       &convergence,
    Report<dim>                                &report)
    : parameters(parameters)
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
    const auto key          = this->key();
    auto       start        = invariants->state();
    const auto communicator = model.discretization->communicator;
    const auto rank         = Utilities::MPI::this_mpi_process(communicator);
    const auto part_before  = part(rank);
    n_parts                 = Utilities::MPI::n_mpi_processes(communicator);
    number                  = report.summary.increments.size();
    on_all_ranks(communicator, [&]() {
      write_file(part(rank), [&](std::ostream &out) {
        const auto values =
          values_on_cells(*model.discretization, vectors(start));
        const auto history =
          model.elasticity->history(/*of_yielded_alone=*/true);
        write_restart(out, key, [&](auto &archive) {
          archive &values &history;
        });
      });
    });
    report.files().write_first("restart.bin", [&](std::ostream &out) {
      write_restart(out, key, [&](auto &archive) {
        archive &n_parts &number;
        serialize(archive, steps, start);
      });
    });
    std::filesystem::remove(part_before);
  }



  // Each rank looks at the parts of all one by one: cells may be elsewhere now.
  template<int dim>
  void Checkpoint<dim>::read(LoadSteps &steps)
  {
    const auto file = report.files().directory / "restart.bin";
    if (!std::filesystem::exists(file))
      {
        report.screen << "Nothing to go on from: no " << file << std::endl;
        return;
      }
    const auto key   = this->key();
    auto       start = invariants->state();
    read_restart(file, key, [&](auto &archive) {
      archive &n_parts &number;
      for (unsigned int r = 0; r < n_parts; ++r)
        {
          CellValues values, history;
          read_restart(part(r), key, [&](auto &archive) {
            archive &values &history;
          });
          take_from_cells(*model.discretization, values, vectors(start));
          model.elasticity->restore(history);
        }
      for (GhostedVector *vector : vectors(start))
        vector->update_ghosts();
      serialize(archive, steps, start);
    });
    invariants->restore(start);
    report.files().write_series();
    report.screen << "Restart behind the load factor "
                  << report.increment().load_factor << std::endl;
  }



  template<int dim>
  template<class Archive>
  void
  Checkpoint<dim>::serialize(Archive &archive, LoadSteps &steps, State &start)
  {
    archive &steps;
    archive &convergence;
    archive &start;
    archive &report.summary.increments;
    archive &report.files();
    if (Archive::is_loading::value)
      pairing.pair(state.solution);
    if (model.interface)
      model.interface->serialize(archive, state.solution);
  }



  // All that has to be the same for a run to be the continuation of another.
  // The order of unknowns and points is that of the ranks.
  template<int dim>
  std::string Checkpoint<dim>::key()
  {
    if (!mesh_checksum)
      mesh_checksum = checksum(parameters.mesh.file);
    std::ostringstream key;
    key << "contact restart 4, ranks "
        << Utilities::MPI::n_mpi_processes(model.discretization->communicator)
        << ", unknowns " << state.solution.size() << ", mesh " << *mesh_checksum
        << '\n'
        << report.used_parameters();
    return key.str();
  }



  template<int dim>
  std::filesystem::path Checkpoint<dim>::part(const unsigned int rank) const
  {
    return report.files().directory / ("restart_" + std::to_string(number) +
                                       "." + std::to_string(rank) + ".bin");
  }



  template<int dim>
  std::vector<GhostedVector *> Checkpoint<dim>::vectors(State &start) const
  {
    auto all = start.vectors(model.discretization->distribution);
    all.push_back(&state.solution);
    return all;
  }

  template class Checkpoint<2>;
  template class Checkpoint<3>;
} // namespace Contact
