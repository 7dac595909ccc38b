/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton_state.h"

#include <sstream>

#include "base/counters.h"
#include "base/errors.h"

namespace Contact
{
  NewtonState::NewtonState(const ContactModel                  &model,
                           const std::unique_ptr<LinearSystem> &system,
                           IncrementState                      &state,
                           Pairing                             &pairing,
                           TimerOutput                         &timer)
    : convergence(model)
    , model(model)
    , system(system)
    , state(state)
    , pairing(pairing)
    , timer(timer)
  {
  }



  void NewtonState::begin_level(const double tolerance)
  {
    rhs.reinit(model.n_unknowns());
    convergence.begin_level(tolerance);
  }



  // Every rank adds the forces that its cells exert.
  void NewtonState::evaluate(const bool after_a_step, const bool one_at_a_time)
  {
    const MPI_Comm communicator = model.discretization->communicator;
    pairing.follow(state.solution, after_a_step);
    {
      TimerOutput::Scope scope(timer, "residual");
      rhs                        = 0;
      const VolumeRatio smallest = model.elasticity->assemble(state.solution,
                                                              state.load_factor,
                                                              rhs,
                                                              nullptr);
      Utilities::MPI::sum(rhs, communicator, rhs);
      smallest_volume = smallest_of_all_ranks(smallest, communicator);
    }
    n_status_changes =
      model.interface ? update_status(after_a_step, one_at_a_time) : 0;

    TimerOutput::Scope scope(timer, "residual");
    if (model.interface)
      model.interface->assemble(state.solution,
                                state.start,
                                pairing.linearization(),
                                rhs,
                                nullptr);
    convergence.evaluate(rhs, state, pairing.linearization().moving_bound);
  }



  // After a step the points decide anew. Before the first one they only would:
  // a change of load, pairing or bounds is not in their tractions yet, and the
  // search of the active set comes first. Returns how many want to change.
  unsigned int NewtonState::update_status(const bool after_a_step,
                                          const bool one_at_a_time)
  {
    ContactInterface &interface    = *model.interface;
    const bool        moving_bound = pairing.linearization().moving_bound;
    if (after_a_step)
      system->recover_multipliers(rhs, state);
    const unsigned int n =
      interface.decide_all(state.solution,
                           state.start,
                           moving_bound,
                           /*keep=*/after_a_step && !one_at_a_time);
    if (after_a_step && n > 0)
      ++counters().active_set_changes;
    // As the search does. Without it the points go on from step to step, and
    // that would begin each turn of the friction loop anew.
    if (system->has_multipliers() && after_a_step && !moving_bound)
      interface.drop_bounds_of_open_points();
    if (after_a_step && one_at_a_time)
      interface.decide_one(state.solution, state.start, moving_bound);
    return n;
  }



  bool NewtonState::is_decided(const bool after_a_step,
                               const bool one_at_a_time) const
  {
    return n_status_changes == 0 ||
           (after_a_step && !one_at_a_time && points_follow_the_law());
  }



  // One whose slip turns round sticks first, though its shear be too large.
  bool NewtonState::points_follow_the_law() const
  {
    const ContactInterface &interface    = *model.interface;
    const bool              moving_bound = pairing.linearization().moving_bound;
    return std::all_of(interface.points.begin(),
                       interface.points.end(),
                       [&](const ContactPoint &point) {
                         const ContactState now =
                           interface.state(point, state.solution, state.start);
                         return interface.decide(point,
                                                 Decision(),
                                                 now.p_trial,
                                                 now.q_trial,
                                                 moving_bound) ==
                                point.decision;
                       });
  }



  std::vector<double>
  NewtonState::search_along_line(const NewtonGuard           &guard,
                                 const Vector<double>        &last,
                                 const std::vector<Decision> &decisions)
  {
    const auto is_a_state = [&]() {
      return std::isfinite(convergence.residual()) && smallest_volume.value > 0;
    };

    std::vector<double> residuals;
    const unsigned int  max_halvings = 6;
    while (residuals.size() < max_halvings &&
           (!is_a_state() || (n_status_changes == 0 &&
                              !guard.accepts(convergence.residual_norm()))))
      {
        state.solution.sadd(0.5, 0.5, last);
        // Supports that were moved are half-way, too: the rest is left to do.
        model.discretization->constrain_update(state.solution,
                                               state.load_factor);
        if (model.interface)
          model.interface->set_decisions(decisions);
        evaluate(/*after_a_step=*/true, /*one_at_a_time=*/false);
        residuals.push_back(convergence.residual());
      }
    return residuals;
  }



  void NewtonState::check() const
  {
    if (!std::isfinite(convergence.residual()))
      throw NotConverged("the residual is not a number");
    if (smallest_volume.value > 0)
      return;
    std::ostringstream message;
    message << "the body '" << model.mesh->body_name(smallest_volume.body)
            << "' turns inside out at X = (" << smallest_volume.X
            << ") mm: det F = " << smallest_volume.value;
    throw NotConverged(message.str());
  }
} // namespace Contact
