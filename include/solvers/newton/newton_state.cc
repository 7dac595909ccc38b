/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/newton_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "contact/results/contact_results.h"
#include "solvers/newton/nearby_state.h"

namespace Contact
{
  template<int dim>
  NewtonState<dim>::NewtonState(
    const ContactModel<dim>                  &model,
    const std::unique_ptr<LinearSystem<dim>> &system,
    IncrementState<dim>                      &state,
    Pairing<dim>                             &pairing,
    TimerOutput                              &timer)
    : convergence(model)
    , model(model)
    , system(system)
    , state(state)
    , pairing(pairing)
    , timer(timer)
    , statuses(model, system, pairing, convergence)
  {
  }



  template<int dim>
  void NewtonState<dim>::begin_level(const double tolerance)
  {
    rhs = model.zero();
    convergence.begin_level(tolerance);
  }



  template<int dim>
  void NewtonState<dim>::begin()
  {
    guard         = NewtonGlobalization();
    n_steps       = 0;
    part          = 0;
    one_at_a_time = false;
    statuses.begin();
    if (model.interface)
      model.interface->active_set.multipliers_are_forces =
        !system->has_multipliers();
    last_residual = std::numeric_limits<double>::max();
    pairing.begin_newton();
    system->begin_newton();
    remember_status();
  }



  template<int dim>
  bool NewtonState<dim>::has_tangent_of_state() const
  {
    return n_steps == 0 || !model.may_be_unstable() ||
           is_nearby(*model.discretization, state.solution, last, state.start);
  }



  template<int dim>
  void NewtonState<dim>::remember_status()
  {
    if (model.interface)
      last_statuses = model.interface->active_set.statuses();
  }



  template<int dim>
  void NewtonState<dim>::evaluate()
  {
    evaluate_with(one_at_a_time);
  }



  template<int dim>
  void NewtonState<dim>::evaluate_with(const bool single_changes)
  {
    const MPI_Comm communicator = model.discretization->communicator;
    {
      TimerOutput::Scope scope(timer, "residual");
      smallest_volume = smallest_of_all_ranks(evaluate_bodies(), communicator);
    }
    if (is_astray())
      {
        convergence.evaluate(rhs, state);
        return;
      }
    pairing.follow(state.solution, /*after_a_step=*/n_steps > 0);
    n_status_changes = model.interface ? update_status(single_changes) : 0;

    TimerOutput::Scope scope(timer, "residual");
    pairing.add_contact(state, rhs);
    convergence.evaluate(rhs, state);
    if (model.interface && has_converged() && close_in_full_pairing())
      evaluate_with(single_changes);
  }



  template<int dim>
  bool NewtonState<dim>::close_in_full_pairing()
  {
    if (!pairing.complete())
      return false;
    const ContactInterface<dim> &interface = *model.interface;
    return std::any_of(interface.points().begin(),
                       interface.points().end(),
                       [&](const ContactPoint<dim> &point) {
                         return point.status.kind == Status::open &&
                                interface.active_set
                                    .status_in(point,
                                               state.solution,
                                               state.start)
                                    .kind != Status::open;
                       });
  }



  // Every rank adds the forces that its cells exert.
  template<int dim>
  VolumeRatio<dim> NewtonState<dim>::evaluate_bodies()
  {
    rhs = 0;
    model.elasticity->add_loads(state.solution, state.load_factor, rhs);
    VolumeRatio<dim> smallest;
    if (!system->subtract_forces(state.solution, rhs))
      smallest = model.elasticity->subtract_forces(state.solution, rhs);
    rhs.compress_add();
    return smallest;
  }



  // After a step the statuses are updated. Before the first one the changes are
  // counted only: a change of load, pairing or bounds is not in the tractions
  // yet, and the search of the active set comes first. Returns their number.
  template<int dim>
  unsigned int NewtonState<dim>::update_status(const bool single_changes)
  {
    ContactInterface<dim> &interface    = *model.interface;
    const bool             after_a_step = n_steps > 0;
    if (after_a_step)
      system->recover_multipliers(rhs, part, state);
    const unsigned int n =
      interface.active_set.update(state.solution,
                                  state.start,
                                  /*keep=*/after_a_step && !single_changes);
    if (after_a_step && n > 0)
      ++model.discretization->counters.active_set_changes;
    // Without the search a reset would begin each friction iteration anew.
    if (system->has_multipliers() && after_a_step && !interface.bounds.follow)
      interface.bounds.reset_of_open_points();
    if (after_a_step && single_changes)
      interface.active_set.update_first(state.solution, state.start);
    return n;
  }



  // In 3-D slip turns with an obstacle: a step finds its direction.
  template<int dim>
  bool NewtonState<dim>::has_converged() const
  {
    if (dim == 3 && n_steps == 0 && model.interface &&
        model.interface->motions.are_moving())
      return false;
    const bool has_statuses =
      n_status_changes == 0 ||
      (n_steps > 0 && !one_at_a_time && satisfies_contact_law());
    return has_statuses && !model.discretization->update_is_prescribed() &&
           convergence.has_converged();
  }



  // One whose slip turns round sticks first, though its shear be too large.
  template<int dim>
  bool NewtonState<dim>::satisfies_contact_law() const
  {
    const ContactInterface<dim> &interface = *model.interface;
    return std::all_of(interface.points().begin(),
                       interface.points().end(),
                       [&](const ContactPoint<dim> &point) {
                         const ContactState<dim> now =
                           interface.state(point, state.solution, state.start);
                         return interface.active_set.updated_status(
                                  point,
                                  PointStatus<dim>(),
                                  now.p_trial,
                                  now.q_trial) == point.status;
                       });
  }



  template<int dim>
  std::vector<double> NewtonState<dim>::shorten_step()
  {
    if (n_steps == 0)
      return {};
    const auto is_admissible = [&]() {
      return std::isfinite(convergence.residual()) &&
             !smallest_volume.is_inside_out();
    };

    std::vector<double> residuals;
    const unsigned int  max_halvings = 6;
    while (residuals.size() < max_halvings && !is_admissible())
      {
        state.solution.sadd(0.5, 0.5, last);
        part *= 0.5;
        // Supports that were moved are half-way, too: the rest is left to do.
        model.discretization->constrain_update(state.solution,
                                               state.load_factor);
        if (model.interface)
          model.interface->active_set.set_statuses(last_statuses);
        evaluate_with(/*single_changes=*/false);
        residuals.push_back(convergence.residual());
      }
    return residuals;
  }



  template<int dim>
  void NewtonState<dim>::accept()
  {
    if (n_steps > 0 || !std::isfinite(convergence.residual()))
      check();
    const bool progress =
      guard.advance(convergence.residual_norm(), n_status_changes);
    if (n_steps > 0)
      pairing.advance(state, last, progress);
    if (pairing.has_been_frozen(guard.circle() == 1))
      guard.move_on();
    if (const unsigned int n = guard.circle();
        n > 0 && !convergence.has_converged())
      throw NotConverged(
        "Newton's method " +
        (n == 1 ? "stands still"
                : "goes round in a circle of " + std::to_string(n) + " steps") +
        ": the residual is " + brief(convergence.residual()) + changes());
  }



  template<int dim>
  void NewtonState<dim>::check() const
  {
    if (!std::isfinite(convergence.residual()))
      throw NotConverged("the residual is not a number");
    if (guard.is_lost(convergence.residual_norm(),
                      convergence.tolerance() * convergence.force_scale()))
      throw NotConverged("Newton's method runs away: the residual is " +
                         brief(convergence.residual()) +
                         ", and its round-off above the tolerance " +
                         brief(convergence.tolerance()) + changes());
    if (!smallest_volume.is_inside_out())
      return;
    std::ostringstream message;
    message << "the body '" << model.mesh->body_name(smallest_volume.body)
            << "' is empty or turns inside out at X = (" << smallest_volume.X
            << ") mm: det F = " << smallest_volume.value;
    throw NotConverged(message.str());
  }



  template<int dim>
  void NewtonState<dim>::pair_anew()
  {
    pairing.renew(state);
    guard.forget();
    remember_status();
    ++n_steps;
    part = 0;
  }



  template<int dim>
  bool NewtonState<dim>::start_single_changes()
  {
    const bool before = one_at_a_time;
    one_at_a_time     = guard.one_at_a_time(n_status_changes);
    if (one_at_a_time)
      statuses.stop();
    return one_at_a_time && !before;
  }



  template<int dim>
  unsigned int NewtonState<dim>::make_step()
  {
    last = state.solution;
    if (model.discretization->update_is_prescribed())
      guard.forget();
    const typename LinearSystem<dim>::Step step{n_steps,
                                                convergence.residual(),
                                                last_residual,
                                                convergence.tolerance(),
                                                convergence.force_scale(),
                                                /*continues=*/false};
    unsigned int n = system->make_step(step, rhs, state);
    n += statuses.search(step, last, rhs, state);
    if (!expected_way)
      expected_way = state.largest_change(model, last);
    model.elasticity->end_first_step();
    last_residual = step.residual;
    part          = part_until_touch();
    if (part < 1)
      {
        state.solution.sadd(part, 1 - part, last);
        model.discretization->constrain_update(state.solution,
                                               state.load_factor);
      }
    remember_status();
    ++n_steps;
    return n;
  }



  template<int dim>
  bool NewtonState<dim>::friction_acts() const
  {
    return model.has_friction() &&
           model.interface->active_set.count().active > 0;
  }



  template<int dim>
  void NewtonState<dim>::begin_increment(const bool starts_elsewhere)
  {
    expected_way.reset();
    if (!model.may_be_unstable() || starts_elsewhere || friction_acts() ||
        !model.discretization->support_motion(state.start, state.load_factor)
           .all_zero())
      expected_way = 0;
  }



  // Loads beyond what a structure carries leave it no state nearby. There may
  // be a stable one far away, which Newton's method can find: the way to it is
  // not one of equilibrium. Where stiffness falls slowly the ratio is below
  // two.
  template<int dim>
  std::string NewtonState<dim>::note_of_leap() const
  {
    const double largest_leap = 5;
    if (expected_way.value_or(0) == 0 || friction_acts())
      return "";
    const double leap =
      state.largest_change(model, state.start) / *expected_way;
    if (leap <= largest_leap)
      return "";
    return "up to t = " + brief(state.load_factor) + " the bodies move " +
           brief(leap) +
           " times as far as the tangent of the increment's start says: they "
           "may have snapped through, or found another support. The way there "
           "is not one of equilibrium. More increments show where it begins; "
           "prescribe the displacement instead of the force to follow it";
  }



  // Nothing in the linear problem stops a body that springs hold alone. The
  // step ends behind the first touch of a point, and before a large turn.
  template<int dim>
  double NewtonState<dim>::part_until_touch() const
  {
    const auto &springs = model.elasticity->springs;
    if (dim == 2 || springs.held().empty() || !model.interface)
      return 1;
    const ContactInterface<dim> &interface = *model.interface;
    double                       part      = 1;
    for (const ContactPoint<dim> &point : interface.points())
      if (point.facing && point.status.kind == Status::open)
        {
          const double depth =
            0.01 * interface.contact_pair(point).edge_length(point);
          const double before = interface.state(point, last, last).gap;
          const double gap = interface.state(point, state.solution, last).gap;
          if (before > -0.5 * depth && gap < -depth)
            part = std::min(part, (before + depth) / (before - gap));
        }

    GhostedVector update = state.solution;
    update -= last;
    const double largest  = 0.05; // [rad]
    const double rotation = springs.largest_rotation(update);
    return model.elasticity->is_linear()
             ? part
             : std::min(part, largest / std::max(rotation, largest));
  }



  template<int dim>
  std::string NewtonState<dim>::unsettled() const
  {
    if (!convergence.has_converged() ||
        model.discretization->update_is_prescribed())
      return {};
    const std::string balanced = ", which is small enough; not settled is ";
    if (!has_converged())
      return balanced + "the status of the points of contact";
    return balanced + "the pairing: " + pairing.unsettled(state);
  }



  template<int dim>
  std::string NewtonState<dim>::changes() const
  {
    return model.interface ? describe_changes(*model.interface,
                                              last_statuses,
                                              state.solution,
                                              state.start)
                           : "";
  }

  template class NewtonState<2>;
  template class NewtonState<3>;
} // namespace Contact
