/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_checkpoint_h
#define contact_checkpoint_h

#include <optional>

#include "model/increment_state.h"
#include "output/report.h"
#include "solvers/newton/convergence_test.h"
#include "solvers/newton/load_steps.h"
#include "solvers/newton/pairing.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The files that a run which was interrupted goes on from: all that an
   * increment leaves to the next one, restart.bin, and of the vectors a part by
   * each rank, restart_INCREMENTS.RANK.bin. As many ranks go on. Levels below
   * the last one are computed again, which costs less than to keep their
   * meshes.
   */
  template<int dim>
  class Checkpoint
  {
  public:
    Checkpoint(const Parameters::All                      &parameters,
               const ContactModel<dim>                    &model,
               const std::unique_ptr<InvariantCheck<dim>> &invariants,
               IncrementState<dim>                        &state,
               Pairing<dim>                               &pairing,
               ConvergenceTest<dim>                       &convergence,
               Report<dim>                                &report);

    /// Unless the steps are finished; also the summary so far, should the run
    /// not come to its end.
    void write(LoadSteps &steps);

    /// Go on where the file ends, if there is one. Throws InputError if it
    /// belongs to another run.
    void read(LoadSteps &steps);

  private:
    using State = typename InvariantCheck<dim>::State;

    template<class Archive>
    void serialize(Archive &archive, LoadSteps &steps, State &start);

    /// The file of a rank, and the vectors in it.
    std::filesystem::path        part(const unsigned int rank) const;
    std::vector<GhostedVector *> vectors(State &start) const;

    std::string key();

    const Parameters::All                      &parameters;
    const ContactModel<dim>                    &model;
    const std::unique_ptr<InvariantCheck<dim>> &invariants;
    IncrementState<dim>                        &state;
    Pairing<dim>                               &pairing;
    ConvergenceTest<dim>                       &convergence;
    Report<dim>                                &report;
    std::optional<unsigned int>                 mesh_checksum;
    unsigned int                                n_parts = 0;
    unsigned int                                number = 0; // of the increments
  };
} // namespace Contact

#endif
