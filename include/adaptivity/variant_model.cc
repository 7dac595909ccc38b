/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/variant_model.h"

#include <algorithm>

#include "base/errors.h"
#include "solvers/rigid_body_modes.h"

namespace Contact
{
  VariantModel::VariantModel(const Parameters::All   &parameters,
                             const ContactModel<2>   &scene,
                             const IncrementState<2> &from,
                             TimerOutput             &timer)
  {
    model.mesh = std::make_unique<Mesh<2>>(*scene.mesh);
    model.discretization =
      std::make_unique<Discretization<2>>(*model.mesh, parameters);
    model.elasticity =
      std::make_unique<Elasticity<2>>(*model.discretization, parameters.solids);
    model.elasticity->heat(from.start_factor, from.load_factor);
    std::vector<Parameters::Contact> pairs = parameters.pairs();
    for (Parameters::Contact &of_pair : pairs)
      for (const auto &known : scene.interface->pairs)
        if (known->name == of_pair.name)
          of_pair.ends_are_corners = known->sees_ends();
    if (!pairs.empty())
      model.interface =
        std::make_unique<ContactInterface<2>>(*model.discretization,
                                              *model.elasticity,
                                              pairs);

    state.reinit(model);
    state.load_factor  = from.load_factor;
    state.start_factor = from.start_factor;
    std::copy_n(from.solution.begin(),
                model.n_displacements(),
                state.solution.begin());
    if (!has_new_shear(scene))
      std::copy_n(from.start.begin(),
                  model.n_displacements(),
                  state.start.begin());

    linearization = {model.geometry_follows(parameters.solution),
                     model.interface &&
                       model.interface->has_coulomb_friction()};
    system        = std::make_unique<SaddlePointSystem>(*model.discretization,
                                                 *model.elasticity,
                                                 model.interface.get(),
                                                 linearization,
                                                 linearization.moving_geometry,
                                                 /*keeps_factorization=*/false,
                                                 timer);
    if (model.interface)
      {
        if (linearization.moving_geometry)
          model.interface->pair_and_begin_increment(state.start_factor,
                                                    state.start);
        model.interface->move_obstacles(state.start_factor, state.load_factor);
        pair();
        model.interface->set_support_motion(
          model.discretization->support_motion(state.start, state.load_factor));
        take_surfaces(*scene.interface, from.solution);
      }
    check_supports();
  }



  void VariantModel::check_supports() const
  {
    if (!rigid_body_modes<2>(*model.discretization, model.interface.get())
           .empty())
      throw NotConverged("nothing holds a body");
  }



  // Shear that the scene does not have would have acted since the beginning,
  // not only in the last increment.
  bool VariantModel::has_new_shear(const ContactModel<2> &scene) const
  {
    if (model.interface)
      for (const auto &now : model.interface->pairs)
        for (const auto &known : scene.interface->pairs)
          if (known->name == now->name &&
              (known->tied != now->tied ||
               known->law.is_frictionless() != now->law.is_frictionless()))
            return true;
    return false;
  }



  // Pairs by their names, their points one by one.
  void VariantModel::take_surfaces(const ContactInterface<2> &from,
                                   const GhostedVector       &solution)
  {
    std::vector<ContactPoint<2>> points = model.interface->points();
    for (const auto &of_pair : model.interface->pairs)
      for (const auto &known : from.pairs)
        if (known->name == of_pair->name)
          for (unsigned int q = 0; q < of_pair->n_points; ++q)
            take_multipliers(from,
                             from.points()[known->first_point + q],
                             solution,
                             points[of_pair->first_point + q]);
    model.interface->set_points(points);
    model.interface->update_statuses(state.solution,
                                     state.start,
                                     linearization.moving_bound,
                                     /*keep=*/true);
  }



  void VariantModel::take_multipliers(const ContactInterface<2> &from,
                                      const ContactPoint<2>     &point,
                                      const GhostedVector       &solution,
                                      ContactPoint<2>           &here)
  {
    const ContactInterface<2> &interface = *model.interface;
    for (unsigned int k = 0; k < here.n_multipliers; ++k)
      {
        const unsigned int m = here.multipliers[k];
        const unsigned int n = point.multipliers[k];
        state.solution[interface.normal_index(m)] =
          solution[from.normal_index(n)];
        if (interface.has_friction(here) && from.has_friction(point))
          state.solution[interface.tangential_index(m)] =
            solution[from.tangential_index(n)];
      }
    here.status         = point.status;
    here.friction_bound = interface.contact_pair(here).law.tresca_limit;
  }



  void VariantModel::pair()
  {
    const GhostedVector undeformed(state.solution.size());
    PairingMode         mode;
    mode.with_derivatives = linearization.moving_geometry;
    system->update_pattern(model.interface->pair(linearization.moving_geometry
                                                   ? state.solution
                                                   : undeformed,
                                                 mode));
  }



  double VariantModel::make_step()
  {
    if (model.interface)
      pair();
    else
      system->update_pattern(false);
    if (model.elasticity->is_linear())
      model.discretization->prescribe(state.solution, state.load_factor);
    else
      model.discretization->constrain_update(state.solution, state.load_factor);

    GhostedVector        step = model.zero();
    const VolumeRatio<2> smallest =
      model.elasticity->assemble(state.solution,
                                 state.load_factor,
                                 step,
                                 nullptr);
    if (smallest.value <= 0)
      throw NotConverged("a body turns inside out");
    if (model.interface)
      ContactKernel<2>(*model.interface)
        .assemble(state.solution, state.start, linearization, step, nullptr);
    if (!system->solve(state.solution,
                       state.start,
                       state.load_factor,
                       /*residual=*/1,
                       /*last_residual=*/1,
                       StatusSearch::later,
                       step))
      throw NotConverged("no active set agrees with the linearised problem");
    state.solution += step;
    model.discretization->settle(state.solution, state.load_factor);
    if (model.interface)
      update_statuses();
    return model.discretization->displacements(step).linfty_norm();
  }



  void VariantModel::update_statuses()
  {
    n_status_changes +=
      model.interface->update_statuses(state.solution,
                                       state.start,
                                       linearization.moving_bound,
                                       /*keep=*/true);
  }
} // namespace Contact
