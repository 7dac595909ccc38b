/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/algebraic_multigrid.h"

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "solvers/direct/negative_curvature.h"

namespace Contact
{
  AlgebraicMultigrid::AlgebraicMultigrid(
    const DefiniteSolver::CoarseSpace &coarse_space,
    Counters                          &counters)
    : coarse_space(coarse_space)
    , n_modes(coarse_space.modes.size())
    , counters(counters)
  {
    for (const auto &mode : coarse_space.modes)
      null_space.insert(null_space.end(), mode.begin(), mode.end());
  }



  void AlgebraicMultigrid::make(const Matrix &matrix, const bool)
  {
    ++counters.symbolic_factorizations;
    ++counters.numeric_factorizations;
    cycle.clear();
    if (coarse_space.interpolation)
      cycle.add_degree(matrix, coarse_space.interpolation());
    const Matrix &lowest = cycle.lowest(matrix);
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.smoother_sweeps       = 2;
    data.aggregation_threshold = 0;
    Teuchos::ParameterList              parameters;
    std::unique_ptr<Epetra_MultiVector> no_modes;
    data.set_parameters(parameters, no_modes, lowest);

    parameters.set("PDE equations", static_cast<int>(n_components()));
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: add default vectors", false);
    parameters.set("null space: dimension", static_cast<int>(n_modes));
    parameters.set("null space: vectors", null_space.data());
    parameters.set("low memory usage", true);
    cycle.initialize(lowest, parameters);
  }



  bool AlgebraicMultigrid::finds_indefinite(const Matrix &matrix) const
  {
    Vector r(matrix.locally_owned_range_indices(),
             matrix.get_mpi_communicator());
    fill_at_random(r.begin(),
                   r.end(),
                   Utilities::MPI::this_mpi_process(
                     matrix.get_mpi_communicator()));
    Vector diagonal(r);
    for (const auto i : r.locally_owned_elements())
      diagonal(i) = std::abs(matrix.diag_element(i));
    diagonal.compress(VectorOperation::insert);
    return has_negative_curvature(matrix, *this, diagonal, r);
  }
} // namespace Contact
