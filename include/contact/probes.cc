/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/probes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/errors.h"
#include "contact/contact_results.h"
#include "contact/obstacle_forces.h"
#include "solid/stress_recovery.h"

namespace Contact
{
  using Parameters::Choice;
  using Parameters::Quantity;

  bool is_displacement(const Quantity quantity)
  {
    return quantity == Quantity::displacement_x ||
           quantity == Quantity::displacement_y ||
           quantity == Quantity::displacement_z;
  }



  bool is_contact_traction(const Quantity quantity)
  {
    return quantity == Quantity::pressure || quantity == Quantity::shear;
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



  namespace
  {
    /// A place on the slave of a contact pair: nodes with a pressure, and
    /// their weights.
    template<int dim>
    struct PlaceOnSlave
    {
      const ContactPair<dim>                      *contact_pair;
      std::vector<std::pair<unsigned int, double>> nodes;
    };



    /// The node of a surface that has this unknown, or none.
    template<int dim>
    unsigned int node_with(const Surface<dim>           &surface,
                           const types::global_dof_index dof)
    {
      for (unsigned int n = 0; n < surface.nodes.size(); ++n)
        if (surface.nodes[n].dofs[0] == dof)
          return n;
      return numbers::invalid_unsigned_int;
    }



    /// The place on all slaves that have it, at most one of each contact pair.
    template<int dim>
    std::vector<PlaceOnSlave<dim>>
    on_slaves(const Place<dim> &place, const ContactInterface<dim> *interface)
    {
      std::vector<PlaceOnSlave<dim>> found;
      if (interface == nullptr)
        return found;
      for (const auto &contact_pair : interface->pairs)
        {
          PlaceOnSlave<dim> here{contact_pair.get(), {}};
          for (const auto &[dof, weight] : place.unknowns[0])
            {
              const unsigned int n = node_with(contact_pair->slave, dof);
              if (n != numbers::invalid_unsigned_int &&
                  !contact_pair->pressure_at(n).empty())
                here.nodes.emplace_back(n, weight);
            }
          if (here.nodes.size() == place.unknowns[0].size())
            found.push_back(here);
        }
      return found;
    }



    template<int dim>
    bool is_on(const Surface<dim> &surface, const Place<dim> &place)
    {
      return std::all_of(place.unknowns[0].begin(),
                         place.unknowns[0].end(),
                         [&](const auto &term) {
                           return node_with(surface, term.first) !=
                                  numbers::invalid_unsigned_int;
                         });
    }



    /// Why no multiplier is at a place.
    template<int dim>
    std::string why_no_multiplier(const Place<dim>            &place,
                                  const ContactInterface<dim> *interface)
    {
      if (interface == nullptr)
        return "the scene has no contact";
      for (const auto &contact_pair : interface->pairs)
        {
          const std::string name =
            contact_pair->name.empty()
              ? ""
              : " of the contact pair '" + contact_pair->name + "'";
          if (is_on(contact_pair->slave, place))
            return "it is on the slave" + name + ", but no point of contact is";
          if (contact_pair->master && is_on(*contact_pair->master, place))
            return "it is on the master" + name +
                   ", and the tractions are those of the slave";
        }
      return "it is on no slave";
    }
  } // namespace



  template<int dim>
  void check_contact_traction(const std::string           &probe,
                              const Quantity               quantity,
                              const std::string           &point,
                              const ContactInterface<dim> *interface,
                              const Discretization<dim>   &discretization)
  {
    const Place<dim> &place = discretization.place(point, "Probes/Probes");
    if (dim == 3 && quantity == Quantity::shear && place.is_between_nodes())
      throw InputError("the point '" + point +
                         "' lies between nodes, whose shears have directions "
                         "of their own",
                       "Probes/Probes, '" + probe + "'",
                       "name a node; 'Output/Profile' has the vectors");
    const auto found = on_slaves(place, interface);
    if (found.empty())
      throw InputError("there is no " + Choice<Quantity>(quantity).name() +
                         " of contact at the point '" + point +
                         "': " + why_no_multiplier(place, interface),
                       "Probes/Probes, '" + probe + "'",
                       "name a point group on a slave, or a stress");
    if (found.size() > 1)
      throw InputError("the point '" + point + "' has a " +
                         Choice<Quantity>(quantity).name() +
                         " of contact in two contact pairs, '" +
                         found[0].contact_pair->name + "' and '" +
                         found[1].contact_pair->name + "'",
                       "Probes/Probes, '" + probe + "'",
                       "name a point of one contact pair only, or a stress; "
                       "'Output/Profile' has both");
  }



  namespace
  {
    /// The shear at a node of the slave without the force of a corner; in space
    /// its magnitude.
    template<int dim>
    double shear_of_node(const ContactInterface<dim> &interface,
                         const ContactPair<dim>      &contact_pair,
                         const unsigned int           n,
                         const GhostedVector         &solution)
    {
      const unsigned int k = contact_pair.multipliers.of_node[n];
      if (contact_pair.law.is_frictionless() ||
          k == numbers::invalid_unsigned_int)
        return 0;
      if (dim == 2)
        return solution[interface.tangential_index(k)];
      Tensor<1, dim - 1> shear;
      for (unsigned int t = 0; t < dim - 1; ++t)
        shear[t] = solution[interface.tangential_index(k, t)];
      return shear.norm();
    }
  } // namespace



  template<int dim>
  double contact_traction(const Quantity               quantity,
                          const Place<dim>            &place,
                          const ContactInterface<dim> *interface,
                          const GhostedVector         &solution)
  {
    const auto found = on_slaves(place, interface);
    if (found.empty())
      return 0;
    const ContactPair<dim> &contact_pair = *found[0].contact_pair;
    const bool              is_normal    = quantity == Quantity::pressure;
    const auto of_corners = corner_loads(*interface, contact_pair, solution);
    double     sum        = 0;
    for (const auto &[n, weight] : found[0].nodes)
      {
        const double of_multiplier =
          is_normal ? interface->pressure(contact_pair.pressure_at(n), solution)
                    : shear_of_node(*interface, contact_pair, n, solution);
        const double of_corner =
          of_corners.empty() ? 0. : of_corners[n].traction()[is_normal ? 0 : 1];
        sum += weight * (of_multiplier + of_corner);
      }
    return sum;
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
    return model.elasticity->strain_energy(model.mesh->body(body,
                                                            "Probes/Probes"),
                                           u);
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



    template<int dim>
    void add_derivative_of_traction(const Quantity           quantity,
                                    const Place<dim>        &place,
                                    const double             factor,
                                    const ContactModel<dim> &model,
                                    GhostedVector           &derivative)
    {
      const ContactInterface<dim> &interface = *model.interface;
      const auto [contact_pair, nodes] = on_slaves(place, &interface).at(0);
      for (const auto &[n, weight] : nodes)
        if (quantity == Quantity::pressure)
          for (const auto &[k, part] : contact_pair->pressure_at(n))
            derivative[interface.normal_index(k)] += factor * weight * part;
        else if (const unsigned int k = contact_pair->multipliers.of_node[n];
                 !contact_pair->law.is_frictionless() &&
                 k != numbers::invalid_unsigned_int)
          derivative[interface.tangential_index(k)] += factor * weight;
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
        add_derivative_of_traction(quantity, place, factor, model, derivative);
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
        return resultant(quantity, name, model)
          .value(state.solution, state.load_factor);
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

  template void   check_contact_traction(const std::string         &probe,
                                         const Parameters::Quantity quantity,
                                         const std::string         &point,
                                         const ContactInterface<2> *interface,
                                         const Discretization<2> &discretization);
  template void   check_contact_traction(const std::string         &probe,
                                         const Parameters::Quantity quantity,
                                         const std::string         &point,
                                         const ContactInterface<3> *interface,
                                         const Discretization<3> &discretization);
  template double contact_traction(const Parameters::Quantity quantity,
                                   const Place<2>            &place,
                                   const ContactInterface<2> *interface,
                                   const GhostedVector       &solution);
  template double contact_traction(const Parameters::Quantity quantity,
                                   const Place<3>            &place,
                                   const ContactInterface<3> *interface,
                                   const GhostedVector       &solution);
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
