/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "probes/force_probes.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "contact/results/contact_results.h"
#include "parameters/dual_quantities.h"
#include "solid/followers.h"

namespace Contact
{
  using Parameters::Choice;
  using Parameters::Quantity;

  bool is_reaction(const Quantity quantity)
  {
    return (quantity >= Quantity::reaction_x &&
            quantity <= Quantity::reaction_z) ||
           is_of_supports_alone(quantity);
  }



  bool is_force(const Quantity quantity)
  {
    return is_reaction(quantity) || quantity == Quantity::contact_force_x ||
           quantity == Quantity::contact_force_y ||
           quantity == Quantity::contact_force_z;
  }



  bool is_of_rigid(const Quantity quantity)
  {
    return quantity >= Quantity::reaction_moment_x &&
           quantity <= Quantity::rotation_z;
  }



  template<int dim>
  double rigid_value(const Quantity           quantity,
                     const std::string       &boundary,
                     const ContactModel<dim> &model,
                     const GhostedVector     &solution,
                     const double             load_factor)
  {
    const Discretization<dim> &discretization = *model.discretization;
    const auto                &rigid =
      discretization.rigid_boundary(boundary, "Probes/Probes");
    const auto motion =
      rigid.motion(solution, discretization.targets(rigid, load_factor));
    const unsigned int k =
      static_cast<unsigned int>(quantity) -
      static_cast<unsigned int>(Quantity::reaction_moment_x);
    if (k >= 3)
      return rigid.rotation(motion)[k - 3];
    GhostedVector forces = model.elasticity->forces(solution, load_factor);
    hand_over_from_followers(discretization, forces);
    return Utilities::MPI::sum(
      rigid.resultant(motion,
                      forces,
                      discretization.dof_handler.locally_owned_dofs())[3 + k],
      discretization.communicator);
  }



  template<int dim>
  Resultant<dim> resultant(const Quantity           quantity,
                           const std::string       &boundary,
                           const ContactModel<dim> &model)
  {
    const std::string  entry     = "Probes/Probes";
    const Mesh<dim>   &mesh      = *model.mesh;
    const unsigned int direction = component_of(quantity);
    if (is_reaction(quantity) && mesh.boundaries.count(boundary) == 0)
      return Resultant<dim>(*model.elasticity,
                            *model.discretization,
                            model.discretization->nodes_of(boundary, entry),
                            direction,
                            /*of_supports=*/true);
    return Resultant<dim>(*model.elasticity,
                          *model.discretization,
                          mesh.boundary(boundary, entry),
                          direction,
                          is_reaction(quantity));
  }



  template<int dim>
  double force_value(const Quantity             quantity,
                     const std::string         &boundary,
                     const ContactModel<dim>   &model,
                     const IncrementState<dim> &state)
  {
    const bool without_contact =
      is_of_supports_alone(quantity) && model.interface;
    return resultant(quantity, boundary, model)
      .value(state.solution,
             state.load_factor,
             without_contact
               ? contact_forces(*model.interface, state.solution, state.start)
               : GhostedVector());
  }



  namespace
  {
    /// Whether one of these unknowns is on a slave or a master.
    template<int dim>
    bool is_on_contact(const IndexSet              &unknowns,
                       const ContactInterface<dim> *interface)
    {
      const auto has_one = [&](const Surface<dim> &surface) {
        return std::any_of(surface.nodes.begin(),
                           surface.nodes.end(),
                           [&](const auto &node) {
                             return std::any_of(node.dofs.begin(),
                                                node.dofs.end(),
                                                [&](const auto dof) {
                                                  return unknowns.is_element(
                                                    dof);
                                                });
                           });
      };
      return interface != nullptr &&
             std::any_of(interface->pairs.begin(),
                         interface->pairs.end(),
                         [&](const auto &contact_pair) {
                           return has_one(contact_pair->slave) ||
                                  (contact_pair->master &&
                                   has_one(*contact_pair->master));
                         });
    }
  } // namespace



  template<int dim>
  void check_force(const std::string       &probe,
                   const Quantity           quantity,
                   const std::string       &boundary,
                   const ContactModel<dim> &model)
  {
    const IndexSet unknowns = resultant(quantity, boundary, model).unknowns();
    const bool     is_known = is_reaction(quantity)
                                ? unknowns.n_elements() > 0
                                : is_on_contact(unknowns, model.interface.get());
    const auto     on_any_process = [&](const bool holds) {
      return Utilities::MPI::max(static_cast<int>(holds),
                                 model.discretization->communicator) > 0;
    };
    const bool has_unknowns = on_any_process(unknowns.n_elements() > 0);
    if (!on_any_process(is_known))
      throw InputError(
        "there is no " + Choice<Quantity>(quantity).name() + " at '" +
          boundary + "': " +
          (is_reaction(quantity) ? "no support holds it in this direction"
           : has_unknowns        ? "it is part of no slave and no master"
                                 : "supports hold all of it in this direction"),
        "Probes/Probes, '" + probe + "'",
        is_reaction(quantity)
          ? "name a group of 'Boundary conditions/Displacement', or ask for a "
            "contact force"
          : "name a boundary of 'Contact', or ask for a reaction");
  }

  Findings notes_on_reactions(
    const Parameters::Probes                                   &probes,
    const std::map<std::string, double>                        &values,
    const std::map<std::string, std::map<std::string, double>> &reactions)
  {
    const double      noticed = 1e-3, round_off = 1e-9;
    const std::string prefix = "reaction ";
    Findings          findings;
    for (const auto &[name, definition] : probes.definitions())
      {
        const std::string quantity =
          Choice<Quantity>(definition.quantity).name();
        const auto value = values.find(name);
        const auto group = reactions.find(definition.places[0]);
        if (quantity.compare(0, prefix.size(), prefix) != 0 ||
            value == values.end() || definition.places.size() > 1 ||
            group == reactions.end())
          continue;
        const std::string component   = quantity.substr(prefix.size());
        const auto        of_supports = group->second.find(component);
        if (of_supports == group->second.end())
          continue;
        // Of all forces, or all moments, of the group.
        double largest = std::abs(value->second);
        for (const auto &[other, reaction] : group->second)
          if (other.size() == component.size())
            largest = std::max(largest, std::abs(reaction));
        const double difference = std::abs(value->second - of_supports->second);
        if (difference <= round_off * largest ||
            difference <= noticed * std::max(std::abs(value->second),
                                             std::abs(of_supports->second)))
          continue;
        const bool        is_moment = component.size() > 1;
        const std::string unit      = is_moment ? " N mm" : " N";
        findings.push_back(
          {"the probe '" + name + "' is " + brief(value->second) + unit +
           ", of which supports exert " + brief(of_supports->second) + unit +
           " and contact the rest: it acts on nodes that they hold; the supports "
           "alone " +
           (is_moment ? "are in summary.json, increments/reactions"
                      : "are 'support " + component + "'")});
      }
    return findings;
  }



  template void check_force(const std::string         &probe,
                            const Parameters::Quantity quantity,
                            const std::string         &boundary,
                            const ContactModel<2>     &model);
  template void check_force(const std::string         &probe,
                            const Parameters::Quantity quantity,
                            const std::string         &boundary,
                            const ContactModel<3>     &model);

  template double rigid_value(const Quantity         quantity,
                              const std::string     &boundary,
                              const ContactModel<2> &model,
                              const GhostedVector   &solution,
                              const double           load_factor);
  template double rigid_value(const Quantity         quantity,
                              const std::string     &boundary,
                              const ContactModel<3> &model,
                              const GhostedVector   &solution,
                              const double           load_factor);

  template double force_value(const Quantity           quantity,
                              const std::string       &boundary,
                              const ContactModel<2>   &model,
                              const IncrementState<2> &state);
  template double force_value(const Quantity           quantity,
                              const std::string       &boundary,
                              const ContactModel<3>   &model,
                              const IncrementState<3> &state);

  template Resultant<2> resultant(const Parameters::Quantity quantity,
                                  const std::string         &boundary,
                                  const ContactModel<2>     &model);
  template Resultant<3> resultant(const Parameters::Quantity quantity,
                                  const std::string         &boundary,
                                  const ContactModel<3>     &model);
} // namespace Contact
