/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "verification/contact_check.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "contact/contact_depth.h"

namespace Contact
{
  namespace
  {
    /// The larger one; what is not a number is larger than all.
    double larger(const double a, const double b)
    {
      return b <= a ? a : b;
    }



    /// The largest value, and a sentence about the worst one.
    struct Worst
    {
      double      value  = 0; // of all
      double      excess = 0; // over its slack, of all
      std::string sentence;

      /// @p say is asked for the sentence if need be. What is not a number is
      /// worse than all.
      template<class Say>
      void add(const double value, const double slack, const Say &say)
      {
        this->value = larger(this->value, value);
        if (value - slack <= excess || std::isnan(excess))
          return;
        excess   = value - slack;
        sentence = say();
      }

      bool is_violated() const
      {
        return !(excess <= 0);
      }
    };



    const std::string wrong_set =
      "Do not use this increment: the active set is not that of this state; "
      "try smaller increments, or 'Solution/Geometry = Newton'.";
  } // namespace



  void ContactInvariants::judge(const std::string &name,
                                const double       value,
                                const double       limit,
                                const std::string &sentence,
                                const std::string &advice)
  {
    if (value <= limit)
      return;
    violations.push_back(name + ": " + sentence + "; relative " + brief(value) +
                         ", allowed " + brief(limit) + ". " + advice);
  }



  ContactCheck::ContactCheck(const Discretization       &discretization,
                             const ContactInterface     &interface,
                             const Parameters::Solution &parameters,
                             const Vector<double>       &solution,
                             const Vector<double>       &u_start,
                             const double                moved)
    : discretization(discretization)
    , interface(interface)
    , parameters(parameters)
    , solution(solution)
    , u_start(u_start)
    , moved(moved)
  {
    for (const ContactPoint &point : interface.points)
      {
        states.push_back(interface.state(point, solution, u_start));
        tractions.push_back(
          interface.traction(point,
                             point.decision,
                             states.back().p_trial,
                             states.back().q_trial,
                             parameters.friction ==
                               Parameters::FrictionLoop::newton));
        const ContactZone &zone = interface.zone(point);
        if (!zone.tied && point.decision.status != Status::open)
          largest_bound =
            std::max(largest_bound, zone.law.bound(tractions.back().p));
      }
  }



  void ContactCheck::widen(Slack &slack) const
  {
    if (parameters.friction == Parameters::FrictionLoop::fixed_point &&
        interface.has_coulomb_friction())
      slack.shear = parameters.friction_tolerance * largest_bound;
    for (const ContactPoint &point : interface.points)
      if (point.decision.status == Status::slip)
        slack.shear_force += slack.shear * point.weight;
  }



  void ContactCheck::add_forces(Vector<double> &pressures,
                                Vector<double> &shears,
                                double         &dissipation) const
  {
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint &point = interface.points[k];
        const Traction     &t     = tractions[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double share = point.weight * point.C[a];
              pressures[point.dofs[a][i]] += share * t.p * point.normal[i];
              shears[point.dofs[a][i]] += share * t.q * point.tangent[i];
            }
        // Implicit Euler.
        if (!interface.zone(point).tied)
          dissipation -= point.weight * t.q * states[k].slip;
      }
  }



  void ContactCheck::check(const Slack &slack, ContactInvariants &found) const
  {
    for (const auto &zone : interface.zones)
      if (zone->master)
        {
          check_balance(*zone, slack, found);
          if (!zone->tied)
            check_depth(*zone, found);
        }
    check_normal(slack, found);
    check_tangential(slack, found);
  }



  void ContactCheck::check_balance(const ContactZone &zone,
                                   const Slack       &slack,
                                   ContactInvariants &found) const
  {
    const bool undeformed =
      parameters.geometry == Parameters::GeometryLoop::undeformed;
    const double         foot_moves = std::sqrt(2.) * moved;
    const Vector<double> none(u_start.size());
    const auto position = [&](const Surface &surface, const unsigned int node) {
      return surface.position(node, undeformed ? none : solution);
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
        const ContactPoint &point = interface.points[k];
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
        const ContactPoint &point = interface.points[k];
        Tensor<1, 2>        r;
        double              sum_of_C = 0;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            sum_of_C += std::abs(point.C[a]);
            for (unsigned int i = 0; i < 2; ++i)
              r[i] +=
                point.C[a] * (point.X[a][i] +
                              (undeformed ? 0. : solution[point.dofs[a][i]]));
          }
        const double offset = point.foot_is_clipped || zone.tied
                                ? std::abs(r * point.tangent)
                                : foot_moves * sum_of_C;
        own_moment +=
          point.weight * (std::abs(tractions[k].q * (r * point.normal)) +
                          std::abs(tractions[k].p) * offset);
      }

    const std::string unit      = " N" + discretization.per_thickness();
    const double      of_forces = sum.norm() / magnitude;
    found.force_imbalance       = larger(found.force_imbalance, of_forces);
    found.judge(
      "balance of forces",
      of_forces,
      slack.relative,
      "the forces of contact on both bodies add up to " + brief(sum.norm()) +
        unit + " of " + brief(magnitude) + unit,
      "The coefficients of a point do not add up to zero: an error of the "
      "program.");
    // The forces on a ring have none in the plane.
    if (discretization.axisymmetric)
      return;
    const double of_moments = std::abs(moment) / (magnitude * size);
    found.moment_imbalance  = larger(found.moment_imbalance, of_moments);
    found.judge(
      "balance of moments",
      of_moments,
      slack.relative + own_moment / (magnitude * size),
      "the forces of contact on both bodies have the moment " + brief(moment) +
        " N",
      "Slave points and their feet are apart along the surface: lower "
      "'Solution/Geometry tolerance'.");
  }



  void ContactCheck::check_depth(const ContactZone &zone,
                                 ContactInvariants &found) const
  {
    const Vector<double> none(u_start.size());
    const ContactDepth   now = largest_depth(zone, solution);
    if (now.depth == 0)
      return;
    double way = 0;
    for (const Surface *surface : {&zone.slave, &*zone.master})
      for (const Surface::Node &node : surface->nodes)
        for (const auto dof : node.dofs)
          way = std::max(way, std::abs(solution[dof]));
    const double overlap = largest_depth(zone, none).depth;
    if (now.depth - overlap <= 0.5 * way)
      return;
    const std::string what =
      "the node of the " + std::string(now.of_master ? "master" : "slave") +
      " at X = (" + brief(now.X[0]) + ", " + brief(now.X[1]) + ") mm is " +
      brief(now.depth) +
      " mm inside of the other body, of surfaces that move "
      "by " +
      brief(way) + " mm";
    const std::string advice =
      now.of_master ? "The slave's edges are too long to see a corner of the "
                      "master: exchange slave and master, or refine the slave."
                    : "No contact point looks there: refine the mesh.";
    // Surfaces that push each other overlap by what the mesh does not resolve;
    // others have passed each other unseen.
    if (carries_force(zone, now.slave_edge))
      found.notes.push_back("depth: " + what + ". " + advice);
    else
      found.judge("depth",
                  now.depth - overlap,
                  0.5 * way,
                  what + ", and no force acts there",
                  advice);
  }



  bool ContactCheck::carries_force(const ContactZone &zone,
                                   const unsigned int slave_edge) const
  {
    for (const ContactPoint &point : interface.points)
      if (&interface.zone(point) == &zone &&
          point.decision.status != Status::open)
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int b = 0; b < zone.slave.n_nodes_per_edge(); ++b)
            if (point.is_on_slave(a) &&
                point.dofs[a] ==
                  zone.slave.nodes[zone.slave.edges[slave_edge].nodes[b]].dofs)
              return true;
    return false;
  }



  // The conditions in the normal direction: weak ones by multiplier, signs by
  // point.
  void ContactCheck::check_normal(const Slack       &slack,
                                  ContactInvariants &found) const
  {
    const auto               &points = interface.points;
    const unsigned int        n      = interface.n_normal_multipliers();
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
        const ContactZone  &zone    = interface.zone(point);
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
            return "the pressure in contact is " + brief(tractions[k].p) +
                   " MPa" + at(point);
          });
        else if (zone.has_point_per_multiplier())
          worst.add(-point.weight * zone.stiffness(point) * now.gap,
                    slack.force,
                    [&]() {
                      return "where it is open, the gap is " + brief(now.gap) +
                             " mm" + at(point);
                    });

        if (-now.gap > found.penetration)
          {
            found.penetration          = -now.gap;
            found.relative_penetration = -now.gap / zone.edge_length(point);
            found.deepest              = zone.place(point);
          }
      }
    for (unsigned int l = 0; l < n; ++l)
      worst.add(stiff[l] * std::abs(weak[l]), slack.force, [&]() {
        return "the condition p = max(0, lambda - c g) fails by the force " +
               brief(stiff[l] * weak[l]) + " N" +
               discretization.per_thickness() + at(points[point_of[l]]);
      });

    // With c far below the stiffness of the bodies, what is penalty instead of
    // multiplier is no pressure: see the header.
    if (largest_pressure > 0)
      found.judge(
        "penetration",
        largest_penalty / largest_pressure,
        0.5,
        "of the largest pressure " + brief(largest_pressure) + " MPa, " +
          brief(largest_penalty) + " MPa come from a penetration of " +
          brief(-states[worst_penalty].gap) + " mm" + at(points[worst_penalty]),
        "An edge of the slave faces the master with a part of its points "
        "only: take the other surface as the slave, or another rule.");

    found.complementarity = worst.value / slack.reference;
    if (worst.is_violated())
      found.judge("complementarity",
                  worst.value / slack.reference,
                  (worst.value - worst.excess) / slack.reference,
                  worst.sentence,
                  wrong_set);
  }



  // The same in the tangential direction.
  void ContactCheck::check_tangential(const Slack       &slack,
                                      ContactInvariants &found) const
  {
    if (!interface.has_friction())
      return;
    const auto               &points = interface.points;
    const unsigned int        n      = interface.n_normal_multipliers();
    std::vector<double>       weak(n), stiff(n), moved(n);
    std::vector<unsigned int> point_of(n);
    Worst                     cone, slip;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const ContactPoint &point = points[k];
        const ContactState &now   = states[k];
        const double        q     = tractions[k].q;
        const bool          slips = point.decision.status == Status::slip;
        const ContactZone  &zone  = interface.zone(point);
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
                   return "the shear is " + brief(q) +
                          " MPa under a bound of " +
                          brief(law.bound(tractions[k].p)) + " MPa" + at(point);
                 });
        if (slips && q != 0 && zone.has_point_per_multiplier())
          slip.add(point.weight * zone.stiffness(point) *
                     std::copysign(now.slip, now.slip * q),
                   slack.force + point.weight * per_traction * slack.shear,
                   [&]() {
                     return "the slip is " + brief(now.slip) +
                            " mm along the shear of " + brief(q) + " MPa" +
                            at(point);
                   });
      }
    for (unsigned int l = 0; l < n; ++l)
      slip.add(stiff[l] * std::abs(weak[l]),
               slack.force +
                 stiff[l] * moved[l] / points[point_of[l]].complementarity,
               [&]() {
                 return "the slip law q = projection of lambda - c s fails by "
                        "the force " +
                        brief(stiff[l] * weak[l]) + " N" +
                        discretization.per_thickness() +
                        at(points[point_of[l]]);
               });

    found.cone = largest_bound > 0 ? cone.value / largest_bound : cone.value;
    found.slip = slip.value / slack.reference;
    if (cone.is_violated())
      found.judge(
        "friction cone",
        found.cone,
        found.cone * (1 - cone.excess / cone.value),
        cone.sentence,
        "Lower 'Solution/Friction tolerance', or set 'Solution/Friction = "
        "Newton'.");
    if (slip.is_violated())
      found.judge("slip",
                  slip.value / slack.reference,
                  (slip.value - slip.excess) / slack.reference,
                  slip.sentence,
                  wrong_set);
  }



  std::string ContactCheck::at(const ContactPoint &point) const
  {
    const Point<2> place = interface.zone(point).place(point);
    return " at X = (" + brief(place[0]) + ", " + brief(place[1]) + ") mm";
  }
} // namespace Contact
