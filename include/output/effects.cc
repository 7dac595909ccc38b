/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/effects.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace Contact
{
  namespace
  {
    std::string pairing(const Parameters::GeometryLoop geometry)
    {
      using Parameters::GeometryLoop;
      switch (geometry)
        {
          case GeometryLoop::undeformed:
            return "paired once";
          case GeometryLoop::fixed_point:
            return "a loop that pairs the bodies and solves";
          case GeometryLoop::each_step:
            return "paired before each Newton step";
          case GeometryLoop::newton:
            return "paired before each Newton step, projections in the tangent";
          case GeometryLoop::automatic:
            break;
        }
      AssertThrow(false, ExcInternalError());
      return "";
    }



    std::string following(const Parameters::FrictionLoop friction)
    {
      using Parameters::FrictionLoop;
      switch (friction)
        {
          case FrictionLoop::fixed_point:
            return "tangential multipliers, a loop over Tresca problems";
          case FrictionLoop::newton:
            return "tangential multipliers, the bound in the tangent";
        }
      AssertThrow(false, ExcInternalError());
      return "";
    }



    std::string with_number(const std::string &text, const double number)
    {
      std::ostringstream out;
      out << text << ' ' << number;
      return out.str();
    }



    Effect friction_of(const Parameters::Contact  &contact_pair,
                       const Parameters::Solution &solution)
    {
      const std::string coulomb =
        contact_pair.section() + "/Friction coefficient";
      if (contact_pair.tied)
        return {"friction",
                "none, tied",
                "normal and tangential multipliers, no statuses",
                contact_pair.section() + "/Tied"};
      const std::string elastic =
        contact_pair.elastic_slip.empty()
          ? ""
          : ", elastic slip " + contact_pair.elastic_slip;
      if (contact_pair.friction_coefficient > 0)
        return {"friction",
                with_number("Coulomb", contact_pair.friction_coefficient) +
                  elastic + ", " + solution.friction.name(),
                following(solution.friction),
                coulomb};
      if (contact_pair.tresca_limit > 0)
        return {"friction",
                with_number("Tresca", contact_pair.tresca_limit) + " MPa" +
                  elastic,
                "tangential multipliers, a bound that stays",
                contact_pair.section() + "/Tresca limit"};
      return {"friction", "none", "no tangential unknowns", coulomb};
    }



    /// On an obstacle the nodal and mortar discretizations are one, see
    /// ContactPair.
    template<int dim>
    std::string rule_of(const ContactPair<dim>    &contact_pair,
                        const Parameters::Contact &parameters)
    {
      const std::string points =
        std::to_string(contact_pair.n_points) + " points";
      if (contact_pair.master)
        return parameters.discretization.name() + " discretization, " + points;
      return (parameters.discretization ==
                  Parameters::ContactDiscretization::mortar
                ? "nodal discretization, which mortar is here, "
                : parameters.discretization.name() + " discretization, ") +
             points + " on an obstacle";
    }



    template<int dim>
    void add_pair(const ContactPair<dim>     &contact_pair,
                  const Parameters::Contact  &parameters,
                  const Parameters::Solution &solution,
                  std::vector<Effect>        &effects)
    {
      effects.push_back(
        {"contact",
         rule_of(contact_pair, parameters),
         std::to_string((contact_pair.law.is_frictionless() ? 1 : dim) *
                        contact_pair.multipliers.n_multipliers) +
           " multipliers" + (contact_pair.tied ? "" : ", active set"),
         parameters.section() +
           (contact_pair.tied
              ? "/Tied"
              : (contact_pair.master ? "/Slave" : "/Obstacle"))});
      effects.push_back(friction_of(parameters, solution));
      if (!contact_pair.name.empty())
        for (unsigned int i = 1; i <= 2; ++i)
          effects[effects.size() - i].name += " " + contact_pair.name;
    }



    template<int dim>
    unsigned int nodes_of_element(const bool serendipity)
    {
      // Of eight or twenty nodes they are those of corners and edges.
      return serendipity ? (2 + dim) * Utilities::pow(2, dim - 1)
                         : Utilities::pow(3, dim);
    }

    /// The numbers of nodes of the kinds of cells, as in "20 and 10".
    template<int dim>
    std::string nodes_of_elements(const Discretization<dim> &discretization)
    {
      std::string text;
      for (unsigned int e = 0; e < discretization.fe.size(); ++e)
        text +=
          (e == 0 ? "" : " and ") +
          std::to_string(discretization.fe[e].reference_cell().is_hyper_cube()
                           ? nodes_of_element<dim>(discretization.serendipity)
                           : discretization.fe[e].n_dofs_per_cell() / dim);
      return text;
    }



    template<int dim>
    std::vector<Effect>
    effects_of_bodies(const Parameters::All     &parameters,
                      const Discretization<dim> &discretization)
    {
      const auto &kinematics   = parameters.solids.kinematics;
      const auto &symmetry     = parameters.solids.symmetry;
      const bool  has_symmetry = symmetry != Parameters::Symmetry::plane_strain;
      const bool  has_modes    = !parameters.solids.incompatible_modes.empty();
      return {{"kinematics",
               kinematics.name() + (has_symmetry ? ", " + symmetry.name() : ""),
               kinematics.all_are(Parameters::Strains::small)
                 ? "one tangent on a mesh"
                 : "a tangent for each Newton step",
               has_symmetry ? "Solids/Kinematics, Solids/Symmetry"
                            : "Solids/Kinematics"},
              {"element",
               parameters.element.degree == 1
                 ? std::string("linear") +
                     (has_modes ? ", with incompatible modes" : "")
                 : "quadratic, " + nodes_of_elements(discretization) + " nodes",
               std::to_string(discretization.dof_handler.n_dofs()) +
                 " displacements",
               has_modes ? "Element/Degree, Solids/Incompatible modes"
                         : "Element/Degree"}};
    }



    template<int dim>
    void add_contact(const Parameters::All       &parameters,
                     const std::size_t            n_displacements,
                     const ContactInterface<dim> *interface,
                     std::vector<Effect>         &effects)
    {
      const auto pairs = parameters.pairs();
      for (unsigned int z = 0; z < pairs.size(); ++z)
        add_pair(*interface->pairs[z], pairs[z], parameters.solution, effects);
      if (pairs.empty())
        effects.push_back(
          {"contact", "none", "no multipliers", "Contact/Slave"});
      else if (!interface->is_tied())
        {
          const auto geometry = parameters.geometry(n_displacements);
          effects.push_back(
            {"geometry",
             Parameters::Choice<Parameters::GeometryLoop>(geometry).name(),
             pairing(geometry),
             "Solution/Geometry"});
        }
    }



    Effect effect_of_files(const Parameters::Output &output,
                           const bool                has_profile)
    {
      return {
        "files",
        std::string("summary") + (output.vtu ? ", VTU of each increment" : "") +
          (has_profile ? ", profile" : "") + (output.nodes ? ", nodes" : ""),
        output.vtu || has_profile ? "stresses recovered" : "no stress for them",
        output.vtu ? "Output/VTU" : "Output/Profile"};
    }
  } // namespace



  template<int dim>
  std::vector<Effect> find_effects(const Parameters::All       &parameters,
                                   const Discretization<dim>   &discretization,
                                   const ContactInterface<dim> *interface,
                                   const std::string           &system)
  {
    const auto          n_displacements = discretization.dof_handler.n_dofs();
    const auto         &refinement      = parameters.refinement;
    std::vector<Effect> effects = effects_of_bodies(parameters, discretization);
    add_contact(parameters, n_displacements, interface, effects);
    effects.push_back(
      {"system",
       system,
       parameters.is_condensed(n_displacements) ? "multipliers eliminated"
                                                : "multipliers are unknowns",
       parameters.solution.linear_solver != Parameters::SolverKind::automatic
         ? "Solution/Linear solver"
         : "Solution/System"});
    effects.push_back({"increments",
                       parameters.solution.increments.text(),
                       "each starts from the last one",
                       "Solution/Increments"});
    const bool adaptive =
      parameters.refines_adaptively(discretization.mesh.has_only_hypercubes());
    if (parameters.has_levels())
      effects.push_back({"levels",
                         (parameters.asks_for_accuracy()
                            ? "towards an accuracy"
                            : std::to_string(refinement.n_levels)) +
                           (adaptive ? ", adaptive" : ", uniform"),
                         adaptive
                           ? "stresses recovered and errors estimated on each"
                           : "each starts from the last one",
                         "Refinement/Levels"});
    if (parameters.solves_dual_problems() && !parameters.has_levels())
      effects.push_back({"errors",
                         "dual weighted residuals",
                         "a linear solve for each probe",
                         "Probes/Errors"});
    effects.push_back(
      effect_of_files(parameters.output,
                      parameters.output.profile && interface != nullptr));
    return effects;
  }



  void print_effects(std::ostream &out, const std::vector<Effect> &effects)
  {
    std::size_t name = 0, choice = 0;
    for (const Effect &effect : effects)
      {
        name   = std::max(name, effect.name.size());
        choice = std::max(choice, effect.choice.size());
      }
    for (const Effect &effect : effects)
      out << "  " << std::left << std::setw(name + 2) << effect.name
          << std::setw(choice + 2) << effect.choice << std::right
          << effect.entails << " (" << effect.entry << ")\n";
    out << std::flush;
  }



  void print_counters(std::ostream &out, const RunSummary &summary)
  {
    std::string done, not_done;
    for (const auto &[counter, n] : summary.counters)
      {
        std::string name = counter;
        std::replace(name.begin(), name.end(), '_', ' ');
        std::string &list = n > 0 ? done : not_done;
        list += (list.empty() ? "" : ", ") + name;
        if (n > 0)
          list += ' ' + std::to_string(n);
      }
    for (const auto &[head, list] : {std::make_pair("Done: ", done),
                                     std::make_pair("Not at all: ", not_done)})
      if (!list.empty())
        {
          std::string indent;
          for (const std::string &line :
               dealii::Utilities::break_text_into_lines(head + list, 78))
            {
              out << indent << line << '\n';
              indent = "  ";
            }
        }
  }

  template std::vector<Effect>
  find_effects(const Parameters::All     &parameters,
               const Discretization<2>   &discretization,
               const ContactInterface<2> *interface,
               const std::string         &system);
  template std::vector<Effect>
  find_effects(const Parameters::All     &parameters,
               const Discretization<3>   &discretization,
               const ContactInterface<3> *interface,
               const std::string         &system);
} // namespace Contact
