/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/convergence_test.h"

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



  template<int dim>
  double ConvergenceTest<dim>::evaluate(const Vector<double>      &rhs,
                                        const IncrementState<dim> &state,
                                        const bool                 moving_bound)
  {
    double square =
      model.interface ? std::pow(model.interface->constraint_norm(rhs), 2) : 0.;
    for (unsigned int i = 0; i < model.n_displacements(); ++i)
      square += rhs[i] * rhs[i];
    norm  = Utilities::MPI::max(std::sqrt(square),
                               model.discretization->communicator);
    force = scale->in(state.solution,
                      state.start,
                      state.load_factor,
                      newton_tolerance,
                      moving_bound);
    return norm;
  }

  template class ConvergenceTest<2>;
  template class ConvergenceTest<3>;
} // namespace Contact
