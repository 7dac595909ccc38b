/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "invariants.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Contact
{
  namespace
  {
    /// The larger one; what is not a number is larger than all.
    double larger(const double a, const double b)
    {
      return b <= a ? a : b;
    }



    std::string text(const double value)
    {
      std::ostringstream out;
      out.precision(3);
      out << value;
      return out.str();
    }



    /// Add a sentence if @p value is above @p limit, or not a number.
    void judge(const std::string        &name,
               const double              value,
               const double              limit,
               const std::string        &sentence,
               const std::string        &advice,
               std::vector<std::string> &violations)
    {
      if (value <= limit)
        return;
      violations.push_back(name + ": " + sentence + "; relative " +
                           text(value) + ", allowed " + text(limit) + ". " +
                           advice);
    }



    const std::string wrong_set =
      "Do not use this increment: the active set is not that of this state; "
      "try smaller increments, or 'Solution/Geometry = Newton'.";
    const std::string wrong_forces =
      "Do not use this increment: lower 'Solution/Newton tolerance'; if that "
      "does not help, it is an error of the program.";



    std::string at(const Point<2> &place)
    {
      return " at X = (" + text(place[0]) + ", " + text(place[1]) + ") mm";
    }
  } // namespace



  // What is not a number is worse than all.
  template<class Say>
  void InvariantCheck::Worst::add(const double value,
                                  const double slack,
                                  const Say   &say)
  {
    this->value = larger(this->value, value);
    if (value - slack <= excess || std::isnan(excess))
      return;
    excess   = value - slack;
    sentence = say();
  }



  bool InvariantCheck::Worst::is_violated() const
  {
    return !(excess <= 0);
  }



  InvariantCheck::InvariantCheck(const Discretization       &discretization,
                                 const Elasticity           &elasticity,
                                 const ContactInterface     *interface,
                                 const Parameters::Solution &parameters)
    : discretization(discretization)
    , elasticity(elasticity)
    , interface(interface)
    , moving_bound(parameters.friction == "Newton")
    , undeformed_geometry(parameters.geometry == "undeformed")
    , friction_tolerance(parameters.friction == "fixed point"
                           ? parameters.friction_tolerance
                           : 0)
    , geometry_tolerance(parameters.geometry == "fixed point"
                           ? parameters.geometry_tolerance
                           : 0)
  {
    for (Vector<double> *vector : {&start.displacement,
                                   &start.external,
                                   &start.pressures,
                                   &start.shears,
                                   &start.holds})
      vector->reinit(discretization.dof_handler.n_dofs());
    end = start;
  }



  void InvariantCheck::advance()
  {
    start = end;
  }



  const InvariantCheck::State &InvariantCheck::state() const
  {
    return start;
  }



  void InvariantCheck::restore(const State &state)
  {
    start = state;
  }



  Invariants InvariantCheck::check(const Vector<double> &solution,
                                   const double          load_factor,
                                   const double          newton_tolerance,
                                   const double          reference_force,
                                   const Vector<double> *hold_forces)
  {
    Invariants found;
    end = start;
    std::copy(solution.begin(),
              solution.begin() + end.displacement.size(),
              end.displacement.begin());
    end.pressures = 0;
    end.shears    = 0;

    force = reference_force > 0 ? reference_force : 1;
    Slack slack{newton_tolerance * force, newton_tolerance};
    if (interface != nullptr)
      {
        find_tractions(solution);
        if (interface->has_coulomb_friction())
          slack.shear = friction_tolerance * largest_bound;
        for (unsigned int i = 0; i < tractions.size(); ++i)
          if (interface->points[i].decision.status == Status::slip)
            slack.shear_force += slack.shear * interface->points[i].weight;

        add_forces();
        for (const auto &zone : interface->zones)
          if (zone->master)
            check_balance(*zone, slack, found);
        check_normal(slack, found);
        check_tangential(slack, found);
      }
    balance_bodies(load_factor, force, slack, hold_forces, found);
    check_energy(slack, found);
    return found;
  }



  // @sect4{The points}
  void InvariantCheck::find_tractions(const Vector<double> &solution)
  {
    states.clear();
    tractions.clear();
    largest_bound = 0;
    for (const ContactPoint &point : interface->points)
      {
        states.push_back(interface->state(point, solution, start.displacement));
        tractions.push_back(interface->traction(point,
                                                point.decision,
                                                states.back().p_trial,
                                                states.back().q_trial,
                                                moving_bound));
        const ContactZone &zone = interface->zone(point);
        if (!zone.tied && point.decision.status != Status::open)
          largest_bound =
            std::max(largest_bound, zone.law.bound(tractions.back().p));
      }
  }



  void InvariantCheck::add_forces()
  {
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint &point = interface->points[k];
        const Traction     &t     = tractions[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double share = point.weight * point.C[a];
              end.pressures[point.dofs[a][i]] += share * t.p * point.normal[i];
              end.shears[point.dofs[a][i]] += share * t.q * point.tangent[i];
            }
        // Implicit Euler.
        if (!interface->zone(point).tied)
          end.dissipation -= point.weight * t.q * states[k].slip;
      }
  }



  void InvariantCheck::check_balance(const ContactZone &zone,
                                     const Slack       &slack,
                                     Invariants        &found) const
  {
    const Vector<double> &u = end.displacement;
    double                d = 0; // the largest displacement of this increment
    for (unsigned int i = 0; i < u.size(); ++i)
      d = larger(d, std::abs(u[i] - start.displacement[i]));
    // A tolerance of one promises nothing.
    const double foot_moves =
      geometry_tolerance < 1
        ? std::sqrt(2.) * geometry_tolerance / (1 - geometry_tolerance) * d
        : std::numeric_limits<float>::max();
    const Vector<double> none(u.size());
    const auto position = [&](const Surface &surface, const unsigned int node) {
      return surface.position(node, undeformed_geometry ? none : u);
    };

    // The middle of the slave and its size.
    Point<2> low = position(zone.slave, 0), high = low;
    for (unsigned int n = 1; n < zone.slave.nodes.size(); ++n)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Point<2> x = position(zone.slave, n);
          low[i]           = std::min(low[i], x[i]);
          high[i]          = std::max(high[i], x[i]);
        }
    const Point<2> middle = low + 0.5 * (high - low);
    const double   size   = low.distance(high);

    // A node may see other zones as well.
    std::map<types::global_dof_index, Tensor<1, 2>> forces;
    for (unsigned int k = zone.first_point;
         k < zone.first_point + zone.n_points;
         ++k)
      {
        const ContactPoint &point = interface->points[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          forces[point.dofs[a][0]] +=
            point.weight * point.C[a] *
            (tractions[k].p * point.normal + tractions[k].q * point.tangent);
      }

    double       moment = 0, magnitude = 0;
    Tensor<1, 2> sum;
    for (const Surface *surface : {&zone.slave, &*zone.master})
      for (unsigned int n = 0; n < surface->nodes.size(); ++n)
        {
          const Tensor<1, 2> f   = forces[surface->nodes[n].dofs[0]];
          const Tensor<1, 2> arm = position(*surface, n) - middle;
          sum += f;
          moment += arm[0] * f[1] - arm[1] * f[0];
          magnitude += f.norm();
        }
    if (magnitude == 0)
      return;

    // The moment that the rule leaves.
    double own_moment = 0;
    for (unsigned int k = zone.first_point;
         k < zone.first_point + zone.n_points;
         ++k)
      {
        const ContactPoint &point = interface->points[k];
        Tensor<1, 2>        r;
        double              sum_of_C = 0;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            sum_of_C += std::abs(point.C[a]);
            for (unsigned int i = 0; i < 2; ++i)
              r[i] +=
                point.C[a] * (point.X[a][i] +
                              (undeformed_geometry ? 0. : u[point.dofs[a][i]]));
          }
        const double offset = point.foot_is_clipped || zone.tied
                                ? std::abs(r * point.tangent)
                                : foot_moves * sum_of_C;
        own_moment +=
          point.weight * (std::abs(tractions[k].q * (r * point.normal)) +
                          std::abs(tractions[k].p) * offset);
      }

    const double of_forces = sum.norm() / magnitude;
    found.force_imbalance  = larger(found.force_imbalance, of_forces);
    judge("balance of forces",
          of_forces,
          slack.relative,
          "the forces of contact on both bodies add up to " + text(sum.norm()) +
            " N/mm of " + text(magnitude) + " N/mm",
          "The coefficients of a point do not add up to zero: an error of the "
          "program.",
          found.violations);
    // The forces on a ring have none in the plane.
    if (discretization.axisymmetric)
      return;
    const double of_moments = std::abs(moment) / (magnitude * size);
    found.moment_imbalance  = larger(found.moment_imbalance, of_moments);
    judge("balance of moments",
          of_moments,
          slack.relative + own_moment / (magnitude * size),
          "the forces of contact on both bodies have the moment " +
            text(moment) + " N",
          "Slave points and their feet are apart along the surface: lower "
          "'Solution/Geometry tolerance'.",
          found.violations);
  }



  // The conditions in the normal direction: weak ones by multiplier, signs by
  // point.
  void InvariantCheck::check_normal(const Slack &slack, Invariants &found) const
  {
    const auto               &points = interface->points;
    const unsigned int        n      = interface->n_normal_multipliers();
    std::vector<double>       weak(n), stiff(n);
    std::vector<unsigned int> point_of(n);
    Worst                     worst;
    double                    largest_pressure = 0, largest_penalty = 0;
    unsigned int              worst_penalty = 0;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const ContactPoint &point   = points[k];
        const ContactState &now     = states[k];
        const bool          is_open = point.decision.status == Status::open;
        const ContactZone  &zone    = interface->zone(point);
        if (!is_open && !zone.tied && !zone.has_point_per_multiplier())
          {
            largest_pressure = std::max(largest_pressure, tractions[k].p);
            if (const double penalty = tractions[k].p - now.lambda_n;
                penalty > largest_penalty)
              {
                largest_penalty = penalty;
                worst_penalty   = k;
              }
          }
        for (unsigned int m = 0; m < point.n_multipliers; ++m)
          {
            const unsigned int l = point.multipliers[m];
            weak[l] += point.weight * point.psi[m] *
                       (tractions[k].p - now.lambda_n) / point.complementarity;
            stiff[l]    = zone.stiffness(point);
            point_of[l] = k;
          }
        if (zone.tied || !point.facing)
          continue;

        if (!is_open)
          worst.add(-point.weight * tractions[k].p, 0, [&]() {
            return "the pressure in contact is " + text(tractions[k].p) +
                   " MPa" + at(place(point));
          });
        else if (zone.has_point_per_multiplier())
          worst.add(-point.weight * zone.stiffness(point) * now.gap,
                    slack.force,
                    [&]() {
                      return "where it is open, the gap is " + text(now.gap) +
                             " mm" + at(place(point));
                    });

        if (-now.gap > found.penetration)
          {
            found.penetration          = -now.gap;
            found.relative_penetration = -now.gap / slave_edge_length(point);
            found.deepest              = place(point);
          }
      }
    for (unsigned int l = 0; l < n; ++l)
      worst.add(stiff[l] * std::abs(weak[l]), slack.force, [&]() {
        return "the condition p = max(0, lambda - c g) fails by the force " +
               text(stiff[l] * weak[l]) + " N/mm" +
               at(place(points[point_of[l]]));
      });

    // With c far below the stiffness of the bodies, what is penalty instead of
    // multiplier is no pressure: see the header.
    if (largest_pressure > 0)
      judge("penetration",
            largest_penalty / largest_pressure,
            0.5,
            "of the largest pressure " + text(largest_pressure) + " MPa, " +
              text(largest_penalty) + " MPa come from a penetration of " +
              text(-states[worst_penalty].gap) + " mm" +
              at(place(points[worst_penalty])),
            "An edge of the slave faces the master with a part of its points "
            "only: take the other surface as the slave, or another rule.",
            found.violations);

    found.complementarity = worst.value / force;
    if (worst.is_violated())
      judge("complementarity",
            worst.value / force,
            (worst.value - worst.excess) / force,
            worst.sentence,
            wrong_set,
            found.violations);
  }



  // The same in the tangential direction.
  void InvariantCheck::check_tangential(const Slack &slack,
                                        Invariants  &found) const
  {
    if (!interface->has_friction())
      return;
    const auto               &points = interface->points;
    const unsigned int        n      = interface->n_normal_multipliers();
    std::vector<double>       weak(n), stiff(n), moved(n);
    std::vector<unsigned int> point_of(n);
    Worst                     cone, slip;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const ContactPoint &point = points[k];
        const ContactState &now   = states[k];
        const double        q     = tractions[k].q;
        const bool          slips = point.decision.status == Status::slip;
        const ContactZone  &zone  = interface->zone(point);
        const FrictionLaw  &law   = zone.law;
        if (zone.tied || law.is_frictionless())
          continue;
        const double per_traction =
          zone.stiffness(point) / point.complementarity;
        for (unsigned int m = 0; m < point.n_multipliers; ++m)
          {
            const unsigned int l     = point.multipliers[m];
            const double       share = point.weight * point.psi[m];
            weak[l] += share * (q - now.lambda_t) / point.complementarity;
            moved[l] += slips ? std::abs(share) * slack.shear : 0.;
            stiff[l]    = zone.stiffness(point);
            point_of[l] = k;
          }
        if (point.decision.status == Status::open)
          continue;

        cone.add(std::abs(q) - law.bound(tractions[k].p),
                 slack.shear + slack.relative * largest_bound,
                 [&]() {
                   return "the shear is " + text(q) + " MPa under a bound of " +
                          text(law.bound(tractions[k].p)) + " MPa" +
                          at(place(point));
                 });
        if (slips && q != 0 && zone.has_point_per_multiplier())
          slip.add(point.weight * zone.stiffness(point) *
                     std::copysign(now.slip, now.slip * q),
                   slack.force + point.weight * per_traction * slack.shear,
                   [&]() {
                     return "the slip is " + text(now.slip) +
                            " mm along the shear of " + text(q) + " MPa" +
                            at(place(point));
                   });
      }
    for (unsigned int l = 0; l < n; ++l)
      slip.add(stiff[l] * std::abs(weak[l]),
               slack.force +
                 stiff[l] * moved[l] / points[point_of[l]].complementarity,
               [&]() {
                 return "the slip law q = projection of lambda - c s fails by "
                        "the force " +
                        text(stiff[l] * weak[l]) + " N/mm" +
                        at(place(points[point_of[l]]));
               });

    found.cone = largest_bound > 0 ? cone.value / largest_bound : cone.value;
    found.slip = slip.value / force;
    if (cone.is_violated())
      judge("friction cone",
            found.cone,
            found.cone * (1 - cone.excess / cone.value),
            cone.sentence,
            "Lower 'Solution/Friction tolerance', or set 'Solution/Friction = "
            "Newton'.",
            found.violations);
    if (slip.is_violated())
      judge("slip",
            slip.value / force,
            (slip.value - slip.excess) / force,
            slip.sentence,
            wrong_set,
            found.violations);
  }



  // @sect4{The bodies}
  //
  // What their forces leave where contact, loads and holds have been taken off:
  // reactions where the constraints hold an unknown by itself, nothing
  // elsewhere. The force on an unknown that others move goes to those. Every
  // rank knows the constraints of its own unknowns.
  void InvariantCheck::balance_bodies(const double          load_factor,
                                      const double          force,
                                      const Slack          &slack,
                                      const Vector<double> *hold_forces,
                                      Invariants           &found)
  {
    Vector<double> left = elasticity.forces(end.displacement, load_factor);
    left -= end.pressures;
    left -= end.shears;
    if (hold_forces != nullptr)
      {
        std::copy(hold_forces->begin(),
                  hold_forces->begin() + end.holds.size(),
                  end.holds.begin());
        left -= end.holds;
      }
    else
      end.holds = 0;

    const auto    &constraints = discretization.constraints;
    const auto    &owned = discretization.dof_handler.locally_owned_dofs();
    const MPI_Comm communicator = discretization.communicator;
    if (discretization.mesh.triangulation.has_hanging_nodes())
      {
        // Hanging nodes hand over to their neighbors. Of those that a support
        // fixes the constraints of an update know nothing any longer.
        AffineConstraints<double> hanging;
        DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                                hanging);
        hanging.close();
        Vector<double> handed_over(left.size());
        for (const auto &line : hanging.get_lines())
          if (owned.is_element(line.index))
            {
              handed_over[line.index] -= left[line.index];
              for (const auto &[other, coefficient] : line.entries)
                handed_over[other] += coefficient * left[line.index];
            }
        Utilities::MPI::sum(handed_over, communicator, handed_over);
        left += handed_over;
      }
    Vector<double> reactions(left.size()), residual(left.size());
    for (const auto dof : owned)
      if (!constraints.is_constrained(dof))
        residual[dof] += left[dof];
      else if (const auto *entries = constraints.get_constraint_entries(dof);
               entries == nullptr || entries->empty())
        reactions[dof] = left[dof];
      else
        for (const auto &[other, coefficient] : *entries)
          residual[other] += coefficient * left[dof];
    Utilities::MPI::sum(reactions, communicator, reactions);
    Utilities::MPI::sum(residual, communicator, residual);

    end.external = elasticity.dead_loads.at(load_factor);
    end.external += reactions;

    found.equilibrium = residual.l2_norm() / force;
    judge("equilibrium",
          found.equilibrium,
          (slack.force + slack.shear_force) / force,
          "a force of " + text(residual.l2_norm()) +
            " N/mm is left over where no support acts",
          wrong_forces,
          found.violations);
  }



  void InvariantCheck::check_energy(const Slack &slack, Invariants &found)
  {
    Vector<double> d(end.displacement);
    d -= start.displacement;
    end.strain_energy = elasticity.strain_energy(end.displacement);

    // By the trapezoidal rule.
    const auto work = [&](const Vector<double> State::*forces) {
      return 0.5 * ((start.*forces) * d + (end.*forces) * d);
    };
    const double external      = work(&State::external);
    const double contact       = work(&State::pressures);
    const double friction      = work(&State::shears);
    const double stabilization = work(&State::holds);
    const double sum           = external + contact + friction + stabilization;

    double path = 0;
    if (!elasticity.is_linear())
      {
        Vector<double> middle(start.displacement);
        middle.add(0.5, d);
        double along = 0;
        elasticity.visit_cells(
          middle,
          /*with_tangent=*/false,
          [&](const std::vector<types::global_dof_index> &dofs,
              const FullMatrix<double> &,
              const Vector<double> &forces) {
            for (unsigned int i = 0; i < dofs.size(); ++i)
              along += forces[i] * d[dofs[i]];
          });
        path = 2. / 3 *
               (Utilities::MPI::sum(along, discretization.communicator) - sum);
      }

    end.external_work += external;
    end.contact_work += contact;
    end.friction_work += friction;
    end.stabilization_work += stabilization;
    end.path_work += path;

    const double change  = end.strain_energy - start.strain_energy;
    const double missing = std::abs(change - sum - path);
    const double scale   = std::abs(change) + std::abs(external) +
                         std::abs(contact) + std::abs(friction) +
                         std::abs(stabilization) + std::abs(path);
    // In increments that do nothing round-off is no more than that of all
    // works.
    const double works = end.strain_energy + std::abs(end.external_work);
    // Of sums of as many terms as there are unknowns.
    const double round_off = std::numeric_limits<double>::epsilon() * d.size() *
                             (scale + start.strain_energy + end.strain_energy);

    found.strain_energy      = end.strain_energy;
    found.external_work      = end.external_work;
    found.contact_work       = end.contact_work;
    found.friction_work      = end.friction_work;
    found.stabilization_work = end.stabilization_work;
    found.path_work          = end.path_work;
    found.dissipation        = end.dissipation;
    if (scale == 0)
      return;
    found.energy_imbalance = missing / std::max(scale, works);
    judge("energy",
          missing / scale,
          ((slack.force + slack.shear_force) * d.l2_norm() + round_off) / scale,
          "strain energy and works differ by " + text(missing) +
            " N mm/mm in this increment",
          wrong_forces,
          found.violations);
  }



  // @sect4{Small things}
  double InvariantCheck::slave_edge_length(const ContactPoint &point) const
  {
    return interface->zone(point).slave.reference_length(point.slave_edge);
  }



  Point<2> InvariantCheck::place(const ContactPoint &point) const
  {
    return interface->zone(point).place(point);
  }
} // namespace Contact
