/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/linear_system.h"

#include "solvers/condensed_form.h"
#include "solvers/saddle_point_form.h"

namespace Contact
{
  template<>
  std::unique_ptr<LinearSystem<2>>
  LinearSystem<2>::create(const ContactModel<2>      &model,
                          const Parameters::All      &parameters,
                          const ContactLinearization &linearization,
                          ConditionalOStream         &screen,
                          TimerOutput                &timer)
  {
    if (parameters.is_condensed(model.n_displacements()))
      return std::make_unique<CondensedForm<2>>(model,
                                                parameters,
                                                linearization.moving_bound,
                                                screen,
                                                timer);
    return std::make_unique<SaddlePointForm>(model,
                                             parameters,
                                             linearization,
                                             screen,
                                             timer);
  }



  template<>
  std::unique_ptr<LinearSystem<3>>
  LinearSystem<3>::create(const ContactModel<3>      &model,
                          const Parameters::All      &parameters,
                          const ContactLinearization &linearization,
                          ConditionalOStream         &screen,
                          TimerOutput                &timer)
  {
    return std::make_unique<CondensedForm<3>>(model,
                                              parameters,
                                              linearization.moving_bound,
                                              screen,
                                              timer);
  }
} // namespace Contact
