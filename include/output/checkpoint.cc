/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/checkpoint.h"

#include <limits>
#include <sstream>

#include "base/all_ranks.h"
#include "base/files.h"
#include "base/restart_file.h"
#include "solid/cell_values.h"

namespace Contact
{
  namespace
  {
    /// The statuses and bounds of points and the multipliers in a solution, by
    /// place: numbers depend on the number of ranks.
    template<class Archive, int dim>
    void serialize_contact(Archive               &archive,
                           ContactInterface<dim> &interface,
                           GhostedVector         &solution)
    {
      const auto              &points    = interface.points();
      std::vector<signed char> codes     = interface.active_set.signature();
      Vector<double>           of_points = interface.bounds.values();
      std::vector<Point<dim>>  places, facets;
      for (unsigned int k = 0; k < interface.motions.free.size(); ++k)
        archive &solution[interface.motions.index(k)];
      for (const ContactPoint<dim> &point : points)
        {
          const auto &contact_pair = interface.contact_pair(point);
          places.push_back(contact_pair.place(point));
          facets.push_back(contact_pair.place_of_facets(point));
        }
      // Which of all points comes next: the closest to its place, up to
      // round-off, that has not been one yet.
      std::vector<bool> is_taken(points.size(), false);
      const auto        next = [&](unsigned int q) {
        unsigned int                pair     = points[q].contact_pair;
        bool                        on_slave = points[q].is_on_slave(0);
        Point<dim>                  X        = places[q];
        Point<dim>                  around   = facets[q];
        archive &pair &on_slave &X &around;
        double closest = std::numeric_limits<double>::max();
        for (unsigned int k = 0;
             Archive::is_loading::value && k < places.size();
             ++k)
          if (const double distance = X.distance_square(places[k]) +
                                      around.distance_square(facets[k]);
              distance < closest && points[k].contact_pair == pair &&
              points[k].is_on_slave(0) == on_slave && !is_taken[k])
            {
              closest = distance;
              q       = k;
            }
        is_taken[q] = true;
        return q;
      };
      for (unsigned int n = 0; n < points.size(); ++n)
        {
          const unsigned int       q     = next(n);
          const ContactPoint<dim> &point = points[q];
          archive                 &codes[q] & of_points[q];
          for (unsigned int m = 0; m < point.n_multipliers; ++m)
            {
              const unsigned int k = point.multipliers[m];
              archive           &solution[interface.normal_index(k)];
              for (unsigned int t = 0;
                   t < dim - 1 && interface.has_friction(point);
                   ++t)
                archive &solution[interface.tangential_index(k, t)];
            }
        }
      if (!Archive::is_loading::value)
        return;
      std::vector<PointStatus<dim>> all;
      for (const auto code : codes)
        all.push_back(PointStatus<dim>::from_code(code));
      interface.active_set.set_statuses(all);
      interface.bounds.set(of_points);
    }
  } // namespace



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
    report.write_history();
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
    report.open_log();
    report.files().remove_series();
    report.files().write_series();
    report.screen << "Restart behind t = " << report.increment().load_factor
                  << std::endl;
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
    archive &report.summary.findings;
    archive &report.files();
    if (Archive::is_loading::value)
      {
        const double reached = report.increment().load_factor;
        if (model.interface)
          model.interface->motions.move(reached, reached, state.solution);
        pairing.pair(state.solution);
      }
    if (model.interface)
      serialize_contact(archive, *model.interface, state.solution);
  }



  // All that has to be the same for a run to be the continuation of another.
  // The order of unknowns and points is that of the ranks.
  template<int dim>
  std::string Checkpoint<dim>::key()
  {
    if (!mesh_checksum)
      mesh_checksum = checksum(parameters.mesh.file);
    std::ostringstream key;
    key << "contact restart 6, ranks "
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
