/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/status_search.h"

#include <limits>

namespace Contact
{
  template<int dim>
  StatusSearch<dim>::StatusSearch(
    const ContactModel<dim>                  &model,
    const std::unique_ptr<LinearSystem<dim>> &system,
    const Pairing<dim>                       &pairing,
    const ConvergenceTest<dim>               &convergence)
    : model(model)
    , system(system)
    , pairing(pairing)
    , convergence(convergence)
  {
  }



  // Bodies that springs hold go further in the linear problem than they may.
  template<int dim>
  void StatusSearch<dim>::begin()
  {
    searches = dim == 3 && model.interface && !model.interface->is_tied() &&
               model.elasticity->springs.held().empty();
  }



  // Under some statuses nothing holds a body that contact alone holds: the
  // matrix is singular, and its solution beyond all digits of the step's. Where
  // that is so, and where statuses do not settle, they change from step to step
  // from then on. Under the first statuses the first solution is right; this
  // one has what the stiffness of the pairing did in between. What adds little
  // to the residual is left to the next step, which another pairing gives other
  // statuses anyway.
  template<int dim>
  unsigned int StatusSearch<dim>::search(typename LinearSystem<dim>::Step step,
                                         const GhostedVector             &start,
                                         GhostedVector                   &rhs,
                                         IncrementState<dim>             &state)
  {
    if (!searches)
      return 0;
    unsigned int        n              = 0;
    const unsigned int  max_iterations = 10;
    const double        little         = 0.01; // of the residual
    const GhostedVector first          = state.solution;
    const auto          statuses       = model.interface->active_set.statuses();
    const double        largest =
      first.linfty_norm() / std::numeric_limits<double>::epsilon();
    step.continues = true;
    for (unsigned int iteration = 0; searches; ++iteration)
      {
        if (!change_statuses(little * step.residual, start, rhs, state))
          break;
        n += system->make_step(step, rhs, state);
        const bool is_solution = state.solution.linfty_norm() <= largest;
        searches               = iteration + 1 < max_iterations && is_solution;
        if (!is_solution || model.interface->active_set.statuses() == statuses)
          {
            state.solution = first;
            model.interface->active_set.set_statuses(statuses);
          }
      }
    return n;
  }



  // The forces of the bodies have become those of contact under the old
  // statuses, which stay where nothing is to be solved again.
  template<int dim>
  bool StatusSearch<dim>::change_statuses(const double         tolerance,
                                          const GhostedVector &start,
                                          GhostedVector       &rhs,
                                          IncrementState<dim> &state) const
  {
    ActiveSet<dim> &active_set = model.interface->active_set;
    system->recover_multipliers(rhs, 1, state);
    const auto statuses = active_set.statuses();
    const auto changed  = statuses_in(state, start);
    if (changed == statuses)
      return false;
    rhs = 0;
    pairing.add_contact(state, rhs);
    rhs.sadd(-1, 0, rhs);
    active_set.set_statuses(changed);
    pairing.add_contact(state, rhs);
    if (convergence.norm_of(rhs) <= tolerance * convergence.force_scale())
      {
        active_set.set_statuses(statuses);
        return false;
      }
    ++model.discretization->counters.active_set_changes;
    return true;
  }

  template<int dim>
  std::vector<PointStatus<dim>>
  StatusSearch<dim>::statuses_in(const IncrementState<dim> &state,
                                 const GhostedVector       &start) const
  {
    ContactInterface<dim> &interface  = *model.interface;
    ActiveSet<dim>        &active_set = interface.active_set;
    const auto             before     = active_set.statuses();
    active_set.update(state.solution, state.start, /*keep=*/true);
    auto found = active_set.statuses();
    active_set.set_statuses(before);
    for (unsigned int q = 0; q < found.size(); ++q)
      {
        const ContactPoint<dim> &point = interface.points()[q];
        const double             reach =
          interface.contact_pair(point).edge_length(point) / 2;
        if (before[q].kind == Status::open && found[q].kind != Status::open &&
            interface.state(point, state.solution, start).slip.norm() > reach)
          found[q] = before[q];
      }
    return found;
  }

  template class StatusSearch<2>;
  template class StatusSearch<3>;
} // namespace Contact
