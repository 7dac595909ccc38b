/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/variant_model.h"

#include <algorithm>

#include "base/errors.h"
#include "contact/interface/surface_transfer.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"

namespace Contact
{
  namespace
  {
    /// The values of @p u at the nodes of other elements on the same mesh.
    void interpolate(const DoFHandler<2> &dof_handler,
                     const GhostedVector &u,
                     const DoFHandler<2> &other,
                     GhostedVector       &there)
    {
      std::vector<types::global_dof_index> dofs, dofs_there;
      auto                                 to = other.begin_active();
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          const FiniteElement<2> &fe       = cell->get_fe();
          const FiniteElement<2> &fe_there = to->get_fe();
          dofs.resize(fe.n_dofs_per_cell());
          dofs_there.resize(fe_there.n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          to->get_dof_indices(dofs_there);
          for (unsigned int i = 0; i < dofs_there.size(); ++i)
            {
              const unsigned int c =
                fe_there.system_to_component_index(i).first;
              double value = 0;
              for (unsigned int j = 0; j < dofs.size(); ++j)
                if (fe.system_to_component_index(j).first == c)
                  value += u[dofs[j]] *
                           fe.shape_value(j, fe_there.unit_support_point(i));
              there[dofs_there[i]] = value;
            }
          ++to;
        }
    }
  } // namespace



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
    const std::vector<Parameters::Contact> pairs = parameters.pairs();
    if (!pairs.empty())
      model.interface =
        std::make_unique<ContactInterface<2>>(*model.discretization,
                                              *model.elasticity,
                                              pairs);

    state.reinit(model);
    // Without friction the way there is of no consequence, but glue on other
    // elements would keep offsets of the start of the last increment.
    state.load_factor = from.load_factor;
    take_displacements(scene, from.solution, state.solution);
    if ((has_elements_of(scene) || model.has_friction()) &&
        !has_new_shear(scene))
      {
        state.start_factor = from.start_factor;
        take_displacements(scene, from.start, state.start);
      }
    model.elasticity->set_thermal_strain(state.start_factor, state.load_factor);

    linearization = {model.geometry_follows(parameters.solution)};
    system        = std::make_unique<SaddlePointSystem>(model,
                                                 linearization,
                                                 linearization.moving_geometry,
                                                 /*keeps_factorization=*/false,
                                                 timer);
    if (model.interface)
      {
        begin_increment();
        if (has_elements_of(scene) && has_points_of(*scene.interface))
          take_surfaces(*scene.interface, from.solution);
        else
          transfer_surfaces(*scene.interface, from.solution);
        if (state.start_factor > 0)
          model.interface->set_shear_at_start(state.solution, state.start);
        model.interface->active_set.update(state.solution,
                                           state.start,
                                           /*keep=*/true);
      }
    check_supports();
  }



  // As an increment of the scene does.
  void VariantModel::begin_increment()
  {
    if (linearization.moving_geometry)
      model.interface->pair_and_begin_increment(state.start_factor,
                                                state.start);
    model.interface->motions.move(state.start_factor, state.load_factor);
    pair();
    model.interface->find_edges(state.start);
    model.interface->active_set.set_support_motion(
      model.discretization->support_motion(state.start, state.load_factor));
  }



  void VariantModel::change_start(const VariantModel &scene,
                                  const VariantModel &at_once,
                                  const VariantModel &scene_at_once)
  {
    GhostedVector of_scene(state.solution.size());
    take_displacements(scene.model, scene_at_once.state.solution, of_scene);
    take_displacements(scene.model, scene.state.start, state.start);
    state.start_factor = scene.state.start_factor;
    const double share = state.start_factor / state.load_factor;
    for (unsigned int i = 0; i < model.n_displacements(); ++i)
      state.start[i] += share * (at_once.state.solution[i] - of_scene[i]);
    model.elasticity->set_thermal_strain(state.start_factor, state.load_factor);
    begin_increment();
    update_statuses();
  }



  bool VariantModel::has_elements_of(const ContactModel<2> &scene) const
  {
    return model.discretization->degree == scene.discretization->degree;
  }



  void VariantModel::take_displacements(const ContactModel<2> &scene,
                                        const GhostedVector   &of_scene,
                                        GhostedVector         &here) const
  {
    if (has_elements_of(scene))
      std::copy_n(of_scene.begin(), model.n_displacements(), here.begin());
    else
      interpolate(scene.discretization->dof_handler,
                  of_scene,
                  model.discretization->dof_handler,
                  here);
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
              ((now->tied && !known->tied) ||
               (!now->law.is_frictionless() && known->law.is_frictionless())))
            return true;
    return false;
  }



  // A tie has no points at ends and corners, which contact has there.
  bool VariantModel::has_points_of(const ContactInterface<2> &from) const
  {
    for (const auto &of_pair : model.interface->pairs)
      for (const auto &known : from.pairs)
        if (known->name == of_pair->name &&
            known->n_points != of_pair->n_points)
          return false;
    return true;
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
  }



  // The Gauss-point discretization has no points to take over: what touches is
  // the first guess.
  void VariantModel::transfer_surfaces(const ContactInterface<2> &from,
                                       const GhostedVector       &solution)
  {
    const auto &pairs = model.interface->pairs;
    if (std::all_of(pairs.begin(), pairs.end(), [](const auto &of_pair) {
          return of_pair->has_point_per_multiplier();
        }))
      restore_surfaces(save_surfaces(from, solution),
                       *model.interface,
                       state.solution);
    else
      model.interface->active_set.initialize(state.solution);
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
                       /*searches=*/true,
                       step))
      throw NotConverged("no active set agrees with the linearised problem");
    state.solution += step;
    model.discretization->project_on_rigid_motions(state.solution,
                                                   state.load_factor);
    if (model.interface)
      update_statuses();
    return model.discretization->displacements(step).linfty_norm();
  }



  void VariantModel::update_statuses()
  {
    n_status_changes += model.interface->active_set.update(state.solution,
                                                           state.start,
                                                           /*keep=*/true);
  }
} // namespace Contact
