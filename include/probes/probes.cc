/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "probes/probes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "contact/interface/obstacle_forces.h"
#include "solid/stress_recovery.h"

namespace Contact
{
  using Parameters::Quantity;

  bool is_displacement(const Quantity quantity)
  {
    return quantity == Quantity::displacement_x ||
           quantity == Quantity::displacement_y ||
           quantity == Quantity::displacement_z;
  }



  bool is_energy(const Quantity quantity)
  {
    return quantity == Quantity::strain_energy;
  }



  bool is_stress(const Quantity quantity)
  {
    return !is_displacement(quantity) && !is_contact_traction(quantity) &&
           !is_force(quantity) && !is_energy(quantity) &&
           !is_of_obstacle(quantity) && !is_of_rigid(quantity) &&
           quantity != Quantity::plastic_strain;
  }



  double stress_component(const Quantity               quantity,
                          const SymmetricTensor<2, 3> &stress)
  {
    switch (quantity)
      {
        case Quantity::stress_xx:
          return stress[0][0];
        case Quantity::stress_yy:
          return stress[1][1];
        case Quantity::stress_zz:
          return stress[2][2];
        case Quantity::stress_xy:
          return stress[0][1];
        case Quantity::stress_xz:
          return stress[0][2];
        case Quantity::stress_yz:
          return stress[1][2];
        case Quantity::von_mises:
          return von_mises(stress);
        default:
          break;
      }
    AssertThrow(false, ExcInternalError());
    return 0;
  }



  template<int dim>
  double body_energy(const std::string       &body,
                     const ContactModel<dim> &model,
                     const GhostedVector     &u)
  {
    return model.elasticity->strain_energy(u,
                                           model.mesh->body(body,
                                                            "Probes/Probes"));
  }



  template<int dim>
  double probe_value(const Quantity                            quantity,
                     const Place<dim>                         &place,
                     const Discretization<dim>                &discretization,
                     const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                     const GhostedVector                      &u)
  {
    if (is_displacement(quantity))
      return place.displacement(component_of(quantity), u);
    return stress_component(quantity,
                            place.interpolate(vertex_stresses,
                                              discretization.communicator));
  }



  namespace
  {
    template<int dim>
    void add_derivative_of_displacement(const Quantity    quantity,
                                        const Place<dim> &place,
                                        const double      factor,
                                        GhostedVector    &derivative)
    {
      for (const auto &[dof, weight] : place.unknowns[component_of(quantity)])
        derivative[dof] += factor * weight;
    }



    // Central differences over the unknowns of the cells around the place.
    template<int dim>
    void add_derivative_of_stress(const Quantity           quantity,
                                  const Place<dim>        &place,
                                  const double             factor,
                                  const ContactModel<dim> &model,
                                  const GhostedVector     &solution,
                                  GhostedVector           &derivative)
    {
      const StressRecovery<dim> recovery(*model.discretization);
      const auto                cells = recovery.cells_at(place);

      std::set<types::global_dof_index>    unknowns;
      std::vector<types::global_dof_index> dofs;
      double                               diameter = 0;
      for (const auto &[vertex, at_vertex] : cells)
        for (const auto &cell : at_vertex)
          {
            dofs.resize(cell->get_fe().dofs_per_cell);
            cell->get_dof_indices(dofs);
            unknowns.insert(dofs.begin(), dofs.end());
            diameter = std::max(diameter, cell->diameter());
          }

      const double step =
        std::cbrt(std::numeric_limits<double>::epsilon()) * diameter;
      GhostedVector u           = solution;
      const auto    stress_with = [&](const types::global_dof_index dof,
                                   const double                  value) {
        u[dof]              = value;
        const double stress = stress_component(
          quantity,
          recovery.stress_at(place, cells, *model.elasticity, u));
        u[dof] = solution[dof];
        return stress;
      };
      for (const auto dof : unknowns)
        derivative[dof] += factor *
                           (stress_with(dof, solution[dof] + step) -
                            stress_with(dof, solution[dof] - step)) /
                           (2 * step);
    }



    template<int dim>
    void add_derivative_at(const Quantity           quantity,
                           const std::string       &point,
                           const double             factor,
                           const ContactModel<dim> &model,
                           const GhostedVector     &solution,
                           GhostedVector           &derivative)
    {
      const Place<dim> &place =
        model.discretization->place(point, "Probes/Probes");
      if (is_contact_traction(quantity))
        add_traction_derivative(quantity,
                                place,
                                factor,
                                *model.interface,
                                solution,
                                derivative);
      else if (is_displacement(quantity))
        add_derivative_of_displacement(quantity, place, factor, derivative);
      else
        add_derivative_of_stress(quantity,
                                 place,
                                 factor,
                                 model,
                                 solution,
                                 derivative);
    }
  } // namespace



  namespace
  {
    template<int dim>
    double value_at(const Quantity             quantity,
                    const std::string         &name,
                    const ContactModel<dim>   &model,
                    const IncrementState<dim> &state)
    {
      if (is_force(quantity))
        return force_value(quantity, name, model, state);
      if (is_energy(quantity))
        return body_energy(name, model, state.solution);
      if (is_of_rigid(quantity))
        return rigid_value(quantity,
                           name,
                           model,
                           state.solution,
                           state.load_factor);
      const Place<dim> &place =
        model.discretization->place(name, "Probes/Probes");
      if (is_contact_traction(quantity))
        return contact_traction(quantity,
                                place,
                                model.interface.get(),
                                state.solution);
      const StressRecovery<dim> recovery(*model.discretization);
      if (quantity == Quantity::plastic_strain)
        return model.elasticity->has_history()
                 ? place.interpolate(recovery.vertex_strains(*model.elasticity),
                                     model.discretization->communicator)
                 : 0.;
      if (is_displacement(quantity))
        return place.displacement(component_of(quantity), state.solution);
      return stress_component(quantity,
                              recovery.stress_at(place,
                                                 recovery.cells_at(place),
                                                 *model.elasticity,
                                                 state.solution));
    }
  } // namespace



  template<int dim>
  double probe_value(const Parameters::Probes::Definition &probe,
                     const ContactModel<dim>              &model,
                     const IncrementState<dim>            &state)
  {
    double value  = 0;
    double factor = 1;
    for (const std::string &place : probe.places)
      {
        value += factor * value_at(probe.quantity, place, model, state);
        factor = -1;
      }
    return value;
  }



  template<int dim>
  GhostedVector probe_derivative(const Parameters::Probes::Definition &probe,
                                 const ContactModel<dim>              &model,
                                 const GhostedVector                  &solution)
  {
    GhostedVector derivative = model.zero();
    double        factor     = 1;
    for (const std::string &place : probe.places)
      {
        if (is_force(probe.quantity))
          resultant(probe.quantity, place, model)
            .add_derivative(solution, factor, derivative);
        else if (is_energy(probe.quantity))
          model.elasticity->add_internal_forces(
            model.mesh->body(place, "Probes/Probes"),
            factor,
            solution,
            derivative);
        else
          add_derivative_at(probe.quantity,
                            place,
                            factor,
                            model,
                            solution,
                            derivative);
        factor = -1;
      }
    return derivative;
  }

  template double
  probe_value(const Parameters::Quantity                quantity,
              const Place<2>                           &place,
              const Discretization<2>                  &discretization,
              const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
              const GhostedVector                      &u);
  template double
                  probe_value(const Parameters::Quantity                quantity,
                              const Place<3>                           &place,
                              const Discretization<3>                  &discretization,
                              const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                              const GhostedVector                      &u);
  template double body_energy(const std::string     &body,
                              const ContactModel<2> &model,
                              const GhostedVector   &u);
  template double body_energy(const std::string     &body,
                              const ContactModel<3> &model,
                              const GhostedVector   &u);
  template double probe_value(const Parameters::Probes::Definition &probe,
                              const ContactModel<2>                &model,
                              const IncrementState<2>              &state);

  template GhostedVector
  probe_derivative(const Parameters::Probes::Definition &probe,
                   const ContactModel<2>                &model,
                   const GhostedVector                  &solution);
} // namespace Contact
