/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/refined_state.h"

#include "adaptivity/refinement.h"

namespace Contact
{
  RefinedState::RefinedState(const Parameters::All      &parameters,
                             const ContactModel<2>      &coarse,
                             const IncrementState<2>    &coarse_state,
                             const ContactLinearization &linearization,
                             std::vector<GhostedVector> &duals)
    : linearization(linearization)
  {
    model.mesh = std::make_unique<Mesh<2>>(*coarse.mesh);
    model.discretization =
      std::make_unique<Discretization<2>>(*model.mesh, parameters);

    SurfaceStates duals_on_surfaces;
    if (coarse.interface)
      for (const GhostedVector &dual : duals)
        duals_on_surfaces.push_back(save_surfaces(*coarse.interface, dual));

    std::vector<GhostedVector> transferred = duals;
    transferred.push_back(coarse_state.solution);
    transferred.push_back(coarse_state.start);
    flag_all_cells(*model.mesh);
    refine_and_transfer(*model.mesh, *model.discretization, transferred);

    model.elasticity =
      std::make_unique<Elasticity<2>>(*model.discretization, parameters.solids);
    if (coarse.interface)
      make_interface(parameters);
    for (GhostedVector &vector : transferred)
      {
        GhostedVector grown = model.zero();
        std::copy(vector.begin(), vector.end(), grown.begin());
        vector = grown;
      }

    state.load_factor  = coarse_state.load_factor;
    state.start_factor = coarse_state.start_factor;
    state.start        = transferred.back();
    transferred.pop_back();
    state.solution = transferred.back();
    transferred.pop_back();
    duals.swap(transferred);
    model.elasticity->set_thermal_strain(state.start_factor, state.load_factor);
    model.discretization->prescribe(state.solution, state.load_factor);
    if (coarse.interface)
      transfer_contact(*coarse.interface,
                       coarse_state.solution,
                       duals_on_surfaces,
                       duals);
  }



  void RefinedState::make_interface(const Parameters::All &parameters)
  {
    model.interface =
      std::make_unique<ContactInterface<2>>(*model.discretization,
                                            *model.elasticity,
                                            parameters.pairs());
  }



  // Statuses follow the pressures of the state: it comes last.
  void RefinedState::transfer_contact(const ContactInterface<2> &coarse,
                                      const GhostedVector &coarse_solution,
                                      const SurfaceStates &duals_on_surfaces,
                                      std::vector<GhostedVector> &duals)
  {
    if (linearization.moving_geometry)
      model.interface->pair_and_begin_increment(state.start_factor,
                                                state.start);
    model.interface->motions.move(state.start_factor, state.load_factor);
    PairingMode mode;
    mode.with_derivatives = linearization.moving_geometry;
    model.interface->pair(linearization.moving_geometry ? state.solution
                                                        : model.zero(),
                          mode);
    model.interface->find_edges(state.start);
    model.interface->active_set.set_support_motion(
      model.discretization->support_motion(state.start, state.load_factor));
    for (unsigned int k = 0; k < duals.size(); ++k)
      restore_surfaces(duals_on_surfaces[k], *model.interface, duals[k]);
    restore_surfaces(save_surfaces(coarse, coarse_solution),
                     *model.interface,
                     state.solution);
    if (state.start_factor > 0)
      model.interface->set_shear_at_start(state.solution, state.start);
    update_statuses();
    for (const ContactPoint<2> &point : model.interface->points())
      if (point.status.kind == Status::open)
        for (GhostedVector &dual : duals)
          set_multipliers(point, 0., dual);
  }



  // At the end of the contact a point is part of it if what presses it is more
  // than what its gap takes to close: the pressure against the stiffness E/h.
  // Its slip tells likewise whether it sticks: its own shear is none yet,
  // and a point that sticks where its neighbors slide would hold the body.
  void RefinedState::update_statuses()
  {
    const ContactInterface<2>   &interface = *model.interface;
    std::vector<ContactPoint<2>> points    = interface.points();
    for (ContactPoint<2> &point : points)
      {
        if (!point.facing || interface.contact_pair(point).tied)
          continue;
        const ContactState<2> now =
          interface.state(point, state.solution, state.start);
        const double stiffness = interface.contact_pair(point).stiffness(point);
        const double p_trial   = now.lambda_n - stiffness * now.gap;
        const bool   is_open   = point.status.kind == Status::open;
        if (is_open != (p_trial <= 0))
          point.status =
            interface.active_set.updated_status(point,
                                                PointStatus<2>(),
                                                p_trial,
                                                now.lambda_t -
                                                  stiffness * now.slip);
        if (point.status.kind == Status::open)
          set_multipliers(point, 0., state.solution);
      }
    model.interface->set_points(points);
  }



  void RefinedState::set_multipliers(const ContactPoint<2> &point,
                                     const double           value,
                                     GhostedVector         &vector) const
  {
    const ContactInterface<2> &interface = *model.interface;
    for (unsigned int k = 0; k < point.n_multipliers; ++k)
      {
        vector[interface.normal_index(point.multipliers[k])] = value;
        if (interface.has_friction(point))
          vector[interface.tangential_index(point.multipliers[k])] = value;
      }
  }
} // namespace Contact
