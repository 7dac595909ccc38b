/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/algebraic_multigrid.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "base/errors.h"
#include "solvers/direct/negative_curvature.h"

namespace Contact
{
  AlgebraicMultigrid::AlgebraicMultigrid(const CoarseSpace &coarse_space,
                                         Counters          &counters)
    : DefiniteSolver(counters)
    , coarse_space(coarse_space)
    , n_modes(coarse_space.modes.size())
  {
    for (const auto &mode : coarse_space.modes)
      null_space.insert(null_space.end(), mode.begin(), mode.end());
  }



  void AlgebraicMultigrid::set_matrix(const Matrix &matrix,
                                      const bool    symmetric,
                                      const bool    new_pattern,
                                      const Dofs   &eliminated)
  {
    this->matrix     = &matrix;
    this->symmetric  = symmetric;
    this->eliminated = eliminated;
    indefinite.reset();
    if (new_pattern || n_changed() > price_in_space ||
        (per_digit > 1.3 * per_digit_when_new &&
         excess >= price_of_hierarchy()))
      build();
  }



  void AlgebraicMultigrid::release()
  {
    preconditioner.clear();
    indefinite = false;
  }



  bool AlgebraicMultigrid::is_indefinite(const bool may_cost)
  {
    if (!is_for_cg())
      return false;
    if (!indefinite && !may_cost)
      return false;
    if (!indefinite)
      {
        Vector r(matrix->locally_owned_range_indices(),
                 matrix->get_mpi_communicator());
        fill_at_random(r.begin(),
                       r.end(),
                       Utilities::MPI::this_mpi_process(
                         matrix->get_mpi_communicator()));
        Vector diagonal(r);
        for (const auto i : r.locally_owned_elements())
          diagonal(i) = std::abs(matrix->diag_element(i));
        diagonal.compress(VectorOperation::insert);
        indefinite =
          has_negative_curvature(*matrix, preconditioner, diagonal, r);
      }
    return *indefinite;
  }



  bool AlgebraicMultigrid::knows_definiteness() const
  {
    return is_for_cg();
  }



  unsigned int
  AlgebraicMultigrid::solve(const Vector &b, const double tolerance, Vector &x)
  {
    SolverControl control(max_iterations, tolerance);
    try
      {
        iterate(control, b, x);
      }
    catch (const SolverControl::NoConvergence &)
      {
        if (!is_new)
          {
            build();
            return solve(b, tolerance, x);
          }
        std::ostringstream residual;
        residual << control.last_value();
        throw SolverStalls((is_for_cg() ? "conjugate gradients" : "GMRES") +
                           std::string(" with AMG stall at the residual ") +
                           residual.str() + " N/mm (rings: N) after " +
                           std::to_string(max_iterations) + " iterations");
      }

    // Solves of different depth compare by their iterations per digit.
    const double digits =
      std::log10(control.initial_value() / control.last_value());
    per_digit = digits > 0 ? control.last_step() / digits : 0.;
    if (is_new)
      {
        per_digit_when_new = per_digit;
        excess             = 0;
      }
    excess += std::max(0., control.last_step() - digits * per_digit_when_new);
    is_new = false;
    return control.last_step();
  }



  bool AlgebraicMultigrid::is_for_cg() const
  {
    return symmetric && symmetric_when_new;
  }



  unsigned int AlgebraicMultigrid::n_components() const
  {
    return n_modes == 3 ? 2 : 3; // of as many rigid motions
  }



  std::size_t AlgebraicMultigrid::n_changed() const
  {
    Dofs changed;
    std::set_symmetric_difference(eliminated.begin(),
                                  eliminated.end(),
                                  eliminated_when_new.begin(),
                                  eliminated_when_new.end(),
                                  std::back_inserter(changed));
    return changed.size();
  }



  double AlgebraicMultigrid::price_of_hierarchy() const
  {
    return n_components() == 2 ? 0. : price_in_space;
  }



  void AlgebraicMultigrid::iterate(SolverControl &control,
                                   const Vector  &b,
                                   Vector        &x) const
  {
    ++counters.linear_solves;
    x = 0;
    if (is_for_cg())
      SolverCG<Vector>(control).solve(*matrix, x, b, preconditioner);
    else // the residual of the system itself is what is measured
      SolverGMRES<Vector>(
        control,
        SolverGMRES<Vector>::AdditionalData(/*max_n_tmp_vectors=*/102,
                                            /*right_preconditioning=*/true))
        .solve(*matrix, x, b, preconditioner);
  }



  void AlgebraicMultigrid::build()
  {
    ++counters.symbolic_factorizations;
    ++counters.numeric_factorizations;
    preconditioner.clear();
    if (coarse_space.interpolation)
      preconditioner.add_degree(*matrix, coarse_space.interpolation());
    const Matrix &lowest = preconditioner.lowest(*matrix);
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
    preconditioner.initialize(lowest, parameters);
    is_new              = true;
    eliminated_when_new = eliminated;
    symmetric_when_new  = symmetric;
  }
} // namespace Contact
