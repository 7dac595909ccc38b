/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/saddle_point_form.h"

#include <cmath>

namespace Contact
{
  SaddlePointForm::SaddlePointForm(const ContactModel<2>      &model,
                                   const Parameters::All      &parameters,
                                   const ContactLinearization &linearization,
                                   ConditionalOStream         &screen,
                                   TimerOutput                &timer)
    : model(model)
    , screen(screen)
    , system(*model.discretization,
             *model.elasticity,
             model.interface.get(),
             linearization,
             model.geometry_follows(parameters.solution),
             keeps_factorization(model, parameters),
             timer,
             parameters.solution.linear_solver ==
               Parameters::SolverKind::umfpack)
  {
  }



  // The step under the present status, then the search for the status that
  // the linearised problem has.
  unsigned int SaddlePointForm::make_step(const Step        &step,
                                          GhostedVector     &rhs,
                                          IncrementState<2> &state)
  {
    const unsigned int n_motions =
      model.interface ? model.interface->motions.free.size() : 0;
    double missing = 0;
    for (unsigned int k = 0; k < n_motions; ++k)
      missing += std::abs(rhs[model.interface->motions.index(k)]) /
                 model.interface->motions.free[k]->lever;
    const bool settled = system.solve(state.solution,
                                      state.start,
                                      state.load_factor,
                                      step.residual,
                                      step.last_residual,
                                      searches,
                                      rhs);
    if (system.has_unstable_bodies())
      screen << "      the stiffness of the bodies is not positive "
                "definite: factorized by UMFPACK"
             << std::endl;
    if (missing > step.tolerance * step.force)
      for (unsigned int k = 0; k < n_motions; ++k)
        if (!model.interface->motions.free[k]->stays)
          model.interface->motions.check(*model.interface->motions.free[k],
                                         rhs[model.interface->motions.index(k)],
                                         missing);
    state.solution += rhs;
    model.discretization->project_on_rigid_motions(state.solution,
                                                   state.load_factor);
    model.discretization->constrain_update(state.solution, state.load_factor);
    if (!settled)
      screen << "      the search of the active set does not settle: the "
                "statuses change from step to step"
             << std::endl;
    searches = searches && settled;
    return 0;
  }



  // Under friction the part of the tangent that is not symmetric decides as
  // well.
  bool SaddlePointForm::tangent_is_indefinite(const IncrementState<2> &state,
                                              const bool               may_cost)
  {
    is_indefinite =
      may_cost && model.may_be_unstable() &&
      system.is_indefinite(state.solution, state.start, state.load_factor);
    return is_indefinite && !model.has_friction();
  }



  std::string SaddlePointForm::open_stability() const
  {
    return is_indefinite ? friction_leaves_stability_open : "";
  }



  // In loops around Newton's method little changes from one to the next. With
  // the pairing in the tangent there are none: it is there for its
  // quadratic convergence.
  bool SaddlePointForm::keeps_factorization(const ContactModel<2> &model,
                                            const Parameters::All &parameters)
  {
    return parameters.geometry(model.n_displacements()) !=
           Parameters::GeometryLoop::newton;
  }
} // namespace Contact
