/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "verification/invariants.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/dimension.h"
#include "solid/followers.h"
#include "solid/strain_range.h"

namespace Contact
{
  namespace
  {
    const std::string wrong_forces =
      "Do not use this increment: lower 'Solution/Newton tolerance'; if that "
      "does not help, it is an error of the program.";
  } // namespace



  template<int dim>
  InvariantCheck<dim>::InvariantCheck(const Discretization<dim> &discretization,
                                      const Elasticity<dim>     &elasticity,
                                      const ContactInterface<dim> *interface,
                                      const Parameters::Solution  &parameters)
    : discretization(discretization)
    , elasticity(elasticity)
    , interface(interface)
    , parameters(parameters)
  {
    start.displacement = GhostedVector(discretization.distribution);
    for (unsigned int k = 1; k <= parameters.increments.size(); ++k)
      {
        const double t    = parameters.increments.at(k);
        double       load = elasticity.dead_loads.magnitude(t);
        if (interface != nullptr)
          for (const FreeMotion *motion : interface->motions.free)
            load += std::abs(motion->force_at(Point<1>(t))) / motion->lever;
        largest_load = std::max(largest_load, load);
      }
  }



  template<int dim>
  Invariants InvariantCheck<dim>::check(const GhostedVector &solution,
                                        const double         load_factor,
                                        const double         newton_tolerance,
                                        const double         reference_force,
                                        const GhostedVector *hold_forces,
                                        const double         moved,
                                        const double         given_force)
  {
    Invariants found;
    end                       = State();
    static_cast<Works &>(end) = start;
    end.displacement          = discretization.displacements(solution);

    const double force = reference_force > 0 ? reference_force : 1;
    Slack        slack{force, newton_tolerance, newton_tolerance * force};
    if (interface != nullptr)
      {
        const ContactCheck<dim> contact(discretization,
                                        *interface,
                                        parameters,
                                        solution,
                                        start.displacement,
                                        moved,
                                        /*ends_run=*/load_factor >= 1);
        contact.widen(slack);
        end.pressures = GhostedVector(discretization.distribution);
        if (std::any_of(interface->pairs.begin(),
                        interface->pairs.end(),
                        [](const auto &contact_pair) {
                          return !contact_pair->law.is_frictionless();
                        }))
          end.shears = GhostedVector(discretization.distribution);
        contact.add_forces(end.pressures, end.shears, end.dissipation);
        for (const auto &contact_pair : interface->pairs)
          if (contact_pair->obstacle)
            end.obstacles.push_back(obstacle_forces(*interface,
                                                    *contact_pair,
                                                    solution,
                                                    start.displacement));
        start.obstacles.resize(end.obstacles.size());
        end.motions       = interface->motions.values(solution);
        end.motion_forces = interface->motions.forces(solution,
                                                      start.displacement,
                                                      /*of_multipliers=*/false);
        start.motions.resize(end.motions.size());
        start.motion_forces.resize(end.motions.size());
        contact.check(slack, found);
      }
    found.supports =
      discretization.distance_from_supports(end.displacement, load_factor);
    found.check("supports",
                found.supports,
                std::numeric_limits<double>::epsilon() *
                  discretization.largest_prescribed(),
                "a supported node is " + brief(found.supports) +
                  " mm from where it has to be",
                wrong_forces);
    const double change =
      change_of_edges(discretization, elasticity, end.displacement);
    found.check("small strain",
                change,
                0.5,
                "edges of cells in small strain change their length by up to " +
                  brief(100 * change) + " %",
                "Set 'Solids/Kinematics = large displacement'; or check the "
                "units: moduli in MPa, lengths in mm, loads in N.");
    balance_bodies(load_factor, slack, hold_forces, given_force, found);
    check_energy(slack, found);
    return found;
  }



  // @sect4{The bodies}
  //
  // The forces of the bodies less those of contact, loads and springs:
  // reactions where the constraints hold an unknown by itself, or a node along
  // a normal, nothing elsewhere. The force on an unknown that others move goes
  // to those. Every rank knows the constraints of its own unknowns.
  template<int dim>
  void InvariantCheck<dim>::balance_bodies(const double         load_factor,
                                           const Slack         &slack,
                                           const GhostedVector *hold_forces,
                                           const double         given_force,
                                           Invariants          &found)
  {
    if (hold_forces != nullptr)
      end.holds = *hold_forces;
    GhostedVector left = elasticity.forces(end.displacement, load_factor);
    for (const auto *forces : {&end.pressures, &end.shears, &end.holds})
      if (forces->size() > 0)
        left -= *forces;
    hand_over_from_followers(discretization, left);

    const auto   &constraints = discretization.constraints;
    GhostedVector reactions(discretization.distribution), residual(reactions);
    for (const auto dof : discretization.dof_handler.locally_owned_dofs())
      if (!constraints.is_constrained(dof))
        residual[dof] += left[dof];
      else if (const auto *entries = constraints.get_constraint_entries(dof);
               entries == nullptr || entries->empty())
        reactions[dof] = left[dof];
      else
        for (const auto &[other, coefficient] : *entries)
          residual[other] += coefficient * left[dof];
    for (const auto &line : discretization.normal_supports.lines())
      if (discretization.dof_handler.locally_owned_dofs().is_element(
            line.pivot))
        {
          reactions[line.pivot] += left[line.pivot];
          for (const auto &[other, coefficient] : line.entries)
            reactions[other] -= coefficient * left[line.pivot];
        }
    reactions.compress_add();
    residual.compress_add();

    for (const RigidBoundary<dim> &boundary : discretization.rigid_boundaries())
      add_rigid(boundary, load_factor, left, reactions, found);
    end.external = elasticity.loads(end.displacement, load_factor);
    end.external += reactions;
    add_up(reactions, found);
    judge_balance(residual.l2_norm(), slack, hold_forces != nullptr, found);
    double acting = reactions.l1_norm();
    for (const auto *forces : {&end.pressures, &end.shears})
      if (forces->size() > 0)
        acting += forces->l1_norm();
    judge_resolution(std::hypot(residual.l2_norm(), missing_in_motions()),
                     given_force,
                     acting,
                     slack,
                     found);
  }



  template<int dim>
  double InvariantCheck<dim>::missing_in_motions() const
  {
    double square = 0;
    for (unsigned int k = 0; k < end.motion_forces.size(); ++k)
      if (const FreeMotion &motion = *interface->motions.free[k]; !motion.stays)
        square +=
          std::pow((motion.force - end.motion_forces[k]) / motion.lever, 2);
    return std::sqrt(square);
  }



  template<int dim>
  std::string InvariantCheck<dim>::in_words(const double force) const
  {
    return brief(force) + " N" + discretization.per_thickness();
  }



  // Of a coarser level only a start is asked for. The first loads of a history
  // may be so small that round-off takes them, whatever the tolerance.
  // Displacements that are given by a history may go through zero, up to
  // round-off: what counts are the largest forces that they have made so far.
  template<int dim>
  void InvariantCheck<dim>::judge_resolution(const double residual,
                                             const double given_force,
                                             const double acting,
                                             const Slack &slack,
                                             Invariants  &found)
  {
    const double loads = largest_load;
    if (given_force > 0)
      largest_acting = std::max({largest_acting, given_force, acting});
    const double scale = loads > 0         ? loads
                         : given_force > 0 ? largest_acting
                                           : 0.;
    if (scale == 0 || slack.relative > parameters.newton_tolerance ||
        residual > slack.force + slack.shear_force)
      return;
    found.check(
      "resolution",
      residual / scale,
      1e-3,
      (loads > 0
         ? "of loads of " + in_words(loads) + " " + in_words(residual) +
             " are lost"
         : "given displacements make forces of " + in_words(scale) +
             " at most, and of these " + in_words(residual) + " are lost") +
        " in the tolerance of " + in_words(slack.force) +
        ", of the largest forces and the round-off of the stiffest body",
      "Lower 'Solution/Newton tolerance'; if the round-off of a stiff body is "
      "the cause, lower its Young's modulus or take an obstacle instead of "
      "it.");
  }



  template<int dim>
  void InvariantCheck<dim>::judge_balance(const double residual,
                                          const Slack &slack,
                                          const bool   is_held,
                                          Invariants  &found) const
  {
    const double allowed = (slack.force + slack.shear_force) / slack.reference;
    found.equilibrium    = residual / slack.reference;
    if (is_held)
      found.check("stabilization",
                  end.holds.l2_norm() / slack.reference,
                  1e-3,
                  "springs that hold a body still carry " +
                    in_words(end.holds.l2_norm()),
                  "Support the body in the motion that is named above, or "
                  "refine its surfaces.");
    found.check("equilibrium",
                found.equilibrium,
                allowed,
                "a force of " + in_words(residual) +
                  " is left over where no support acts",
                wrong_forces);
  }



  // The reactions of a rigid boundary, beside its forces and moments, at P.
  template<int dim>
  void InvariantCheck<dim>::add_rigid(const RigidBoundary<dim> &boundary,
                                      const double              load_factor,
                                      const GhostedVector      &left,
                                      GhostedVector            &reactions,
                                      Invariants               &found) const
  {
    for (const auto &node : boundary.nodes)
      for (const auto dof : node.dofs)
        reactions[dof] = left[dof];
    const auto resultant =
      boundary.resultant(boundary.motion(end.displacement,
                                         discretization.targets(boundary,
                                                                load_factor)),
                         left,
                         discretization.dof_handler.locally_owned_dofs());
    for (unsigned int k = 0; k < 6; ++k)
      if (k < 3 ? k < dim : k >= 3 + Dimension<dim>::first_axis)
        found.reactions[boundary.name][(k < 3 ? "" : "moment ") +
                                       std::string(1, "xyz"[k % 3])] =
          Utilities::MPI::sum(resultant[k], discretization.communicator);
  }



  // Each rank adds up the reactions of its own unknowns.
  template<int dim>
  void InvariantCheck<dim>::add_up(const GhostedVector &reactions,
                                   Invariants          &found) const
  {
    const auto &owned = discretization.dof_handler.locally_owned_dofs();
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto &[group, unknowns] : discretization.supports[c])
        {
          double sum = 0;
          for (const auto dof : unknowns)
            if (owned.is_element(dof))
              sum += reactions[dof];
          found.reactions[group][std::string(1, "xyz"[c])] =
            Utilities::MPI::sum(sum, discretization.communicator);
        }
  }



  template<int dim>
  void InvariantCheck<dim>::check_energy(const Slack &slack, Invariants &found)
  {
    GhostedVector d(end.displacement);
    d -= start.displacement;
    end.strain_energy = elasticity.strain_energy(end.displacement);

    // By the trapezoidal rule.
    const auto work_of = [&](const GhostedVector &forces) {
      return forces.size() > 0 ? forces * d : 0.;
    };
    const auto work = [&](const GhostedVector State::*forces) {
      return 0.5 * (work_of(start.*forces) + work_of(end.*forces));
    };
    const auto   of_obstacles = work_of_obstacles();
    const double external =
      work(&State::external) + of_obstacles[0] + of_obstacles[1];
    const double contact       = work(&State::pressures) - of_obstacles[0];
    const double friction      = work(&State::shears) - of_obstacles[1];
    const double stabilization = work(&State::holds);
    const double sum           = external + contact + friction + stabilization;

    typename Elasticity<dim>::Works of_bodies;
    if (!elasticity.is_elastic() || elasticity.has_thermal_strain())
      of_bodies = elasticity.works(start.displacement, end.displacement);
    else if (!elasticity.is_linear())
      of_bodies.path = 2. / 3 * (work_at_middle(d) - sum);
    const double path = of_bodies.path;

    end.external_work += external;
    end.contact_work += contact;
    end.friction_work += friction;
    end.stabilization_work += stabilization;
    end.path_work += path;
    end.plastic_work += of_bodies.dissipation;
    end.thermal_work += of_bodies.thermal;

    const double change =
      end.strain_energy - start.strain_energy + of_bodies.dissipation;
    const double missing = std::abs(change - sum - path - of_bodies.thermal);
    const double scale   = std::abs(change) + std::abs(external) +
                         std::abs(contact) + std::abs(friction) +
                         std::abs(stabilization) + std::abs(path) +
                         std::abs(of_bodies.thermal);
    // In increments that do nothing round-off is no more than that of all
    // works.
    const double works = end.strain_energy + std::abs(end.external_work);
    // Of sums of as many terms as there are unknowns.
    const double round_off = std::numeric_limits<double>::epsilon() * d.size() *
                             (scale + start.strain_energy + end.strain_energy);

    static_cast<Works &>(found) = end;
    if (scale == 0)
      return;
    found.energy_imbalance = missing / std::max(scale, works);
    found.check("energy",
                missing / scale,
                ((slack.force + slack.shear_force) * d.l2_norm() + round_off +
                 of_bodies.error) /
                  scale,
                "strain energy and works differ by " + brief(missing) +
                  " N mm" + discretization.per_thickness() +
                  " in this increment",
                wrong_forces);
  }



  template<int dim>
  std::array<double, 2> InvariantCheck<dim>::work_of_obstacles() const
  {
    std::array<double, 2> works{};
    unsigned int          n = 0;
    if (interface == nullptr)
      return works;
    for (const auto &contact_pair : interface->pairs)
      if (contact_pair->obstacle)
        {
          const auto motion = contact_pair->obstacle->motion();
          for (unsigned int k = 0; k < 2; ++k)
            works[k] += 0.5 * (start.obstacles[n][k].work(motion) +
                               end.obstacles[n][k].work(motion));
          ++n;
        }
      else if (!contact_pair->free_motions.empty())
        {
          const unsigned int k = contact_pair->first_motion;
          works[0] += 0.5 * (start.motion_forces[k] + end.motion_forces[k]) *
                      (end.motions[k] - start.motions[k]);
        }
    return works;
  }



  template<int dim>
  double InvariantCheck<dim>::work_at_middle(const GhostedVector &d) const
  {
    GhostedVector middle(start.displacement);
    middle.add(0.5, d);
    double work = 0;
    elasticity.visit_cells(middle,
                           /*with_tangent=*/false,
                           [&](const std::vector<types::global_dof_index> &dofs,
                               const FullMatrix<double> &,
                               const Vector<double> &forces) {
                             for (unsigned int i = 0; i < dofs.size(); ++i)
                               work += forces[i] * d[dofs[i]];
                           });
    return Utilities::MPI::sum(work, discretization.communicator);
  }

  template class InvariantCheck<2>;
  template class InvariantCheck<3>;
} // namespace Contact
