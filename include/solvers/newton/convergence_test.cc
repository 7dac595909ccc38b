/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/convergence_test.h"

namespace Contact
{
  template<int dim>
  void ConvergenceTest<dim>::begin_level(const double tolerance)
  {
    newton_tolerance = tolerance;
    scale.emplace(*model.discretization,
                  *model.elasticity,
                  model.interface.get());
  }



  // The multipliers, which all have, count once.
  template<int dim>
  double ConvergenceTest<dim>::norm_of(const GhostedVector &rhs) const
  {
    const MPI_Comm communicator = model.discretization->communicator;
    const auto     n = model.discretization->distribution->locally_owned_size();
    double         square =
      model.interface && Utilities::MPI::this_mpi_process(communicator) == 0
                ? std::pow(model.interface->constraint_norm(rhs), 2)
                : 0.;
    for (const double *r = rhs.begin(); r != rhs.begin() + n; ++r)
      square += *r * *r;
    return std::sqrt(Utilities::MPI::sum(square, communicator));
  }



  template<int dim>
  double ConvergenceTest<dim>::evaluate(const GhostedVector       &rhs,
                                        const IncrementState<dim> &state)
  {
    norm  = norm_of(rhs);
    force = scale->in(state.solution,
                      state.start,
                      state.load_factor,
                      newton_tolerance);
    return norm;
  }

  template class ConvergenceTest<2>;
  template class ConvergenceTest<3>;
} // namespace Contact
