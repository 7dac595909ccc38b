/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/assembled_system.h"
#include "solvers/condensed_form.h"
#include "solvers/multigrid/matrix_free_system.h"
#include "solvers/newton/linear_system.h"
#include "solvers/saddle_point/saddle_point_system.h"

namespace Contact
{
  template<int dim>
  std::unique_ptr<LinearSystem<dim>>
  LinearSystem<dim>::create(const ContactModel<dim>    &model,
                            const Parameters::All      &parameters,
                            const ContactLinearization &linearization,
                            ConditionalOStream         &screen,
                            TimerOutput                &timer)
  {
    // In loops around Newton's method little changes from one to the next. With
    // the pairing in the tangent there are none: it is there for its quadratic
    // convergence.
    const bool keeps_factorization =
      parameters.geometry(model.n_displacements()) !=
      Parameters::GeometryLoop::newton;
    if constexpr (dim == 2)
      if (!parameters.is_condensed(model.n_displacements()))
        return std::make_unique<SaddlePointSystem>(
          model,
          linearization,
          model.geometry_follows(parameters.solution),
          keeps_factorization,
          timer,
          parameters.solution.linear_solver == Parameters::SolverKind::umfpack,
          &screen);
    return std::make_unique<CondensedForm<dim>>(model,
                                                parameters,
                                                screen,
                                                timer);
  }



  template<int dim>
  std::unique_ptr<CondensedSystem<dim>>
  CondensedSystem<dim>::create(const Discretization<dim>   &discretization,
                               const Elasticity<dim>       &elasticity,
                               const ContactInterface<dim> *interface,
                               ContactElimination<dim>     &elimination,
                               const Parameters::SolverKind solver_kind,
                               TimerOutput                 &timer)
  {
    if (solver_kind == Parameters::SolverKind::gmg)
      return std::make_unique<MatrixFreeSystem<dim>>(discretization,
                                                     elasticity,
                                                     interface,
                                                     elimination,
                                                     timer);
    return std::make_unique<AssembledSystem<dim>>(discretization,
                                                  elasticity,
                                                  interface,
                                                  elimination,
                                                  solver_kind,
                                                  timer);
  }

#define INSTANTIATE(dim)                                                       \
  template std::unique_ptr<LinearSystem<dim>> LinearSystem<dim>::create(       \
    const ContactModel<dim> &,                                                 \
    const Parameters::All &,                                                   \
    const ContactLinearization &,                                              \
    ConditionalOStream &,                                                      \
    TimerOutput &);                                                            \
  template std::unique_ptr<CondensedSystem<dim>> CondensedSystem<dim>::create( \
    const Discretization<dim> &,                                               \
    const Elasticity<dim> &,                                                   \
    const ContactInterface<dim> *,                                             \
    ContactElimination<dim> &,                                                 \
    const Parameters::SolverKind,                                              \
    TimerOutput &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
