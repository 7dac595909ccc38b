/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "verification/contact_check.h"

#include <algorithm>
#include <limits>

#include "contact/results/contact_crossing.h"
#include "contact/results/contact_depth.h"
#include "verification/rigid_fit.h"

namespace Contact
{
  void ContactInvariants::check(const std::string &name,
                                const double       value,
                                const double       limit,
                                const std::string &sentence,
                                const std::string &advice)
  {
    if (value <= limit)
      return;
    findings.push_back({name + ": " + sentence + "; relative " + brief(value) +
                          ", allowed " + brief(limit) + ". " + advice,
                        /*is_violated=*/true});
  }



  template<int dim>
  ContactCheck<dim>::ContactCheck(const Discretization<dim>   &discretization,
                                  const ContactInterface<dim> &interface,
                                  const Parameters::Solution  &parameters,
                                  const GhostedVector         &solution,
                                  const GhostedVector         &u_start,
                                  const double                 moved,
                                  const bool                   ends_run)
    : discretization(discretization)
    , interface(interface)
    , parameters(parameters)
    , solution(solution)
    , u_start(u_start)
    , moved(moved)
    , ends_run(ends_run)
  {
    for (const ContactPoint<dim> &point : interface.points())
      {
        states.push_back(interface.state(point, solution, u_start));
        tractions.push_back(
          interface.active_set.traction(point, states.back()));
        const ContactPair<dim> &contact_pair = interface.contact_pair(point);
        if (!contact_pair.tied && point.status.kind != Status::open)
          largest_bound =
            std::max(largest_bound, contact_pair.law.bound(tractions.back().p));
      }
  }



  template<int dim>
  void ContactCheck<dim>::widen(Slack &slack) const
  {
    slack.relative =
      std::max(slack.relative,
               tractions.size() * std::numeric_limits<double>::epsilon());
    if (parameters.friction == Parameters::FrictionLoop::fixed_point &&
        interface.has_coulomb_friction())
      slack.shear = parameters.friction_tolerance * largest_bound;
    for (const ContactPoint<dim> &point : interface.points())
      if (point.status.kind == Status::slip)
        slack.shear_force += slack.shear * point.weight;
  }



  template<int dim>
  void ContactCheck<dim>::add_forces(GhostedVector &pressures,
                                     GhostedVector &shears,
                                     double        &dissipation) const
  {
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint<dim> &point = interface.points()[k];
        const Traction<dim>     &t     = tractions[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            {
              const double share = point.weight * point.C[a];
              pressures[point.dofs(a)[i]] += share * t.p * point.normal[i];
              for (unsigned int k = 0;
                   k < dim - 1 && interface.has_friction(point);
                   ++k)
                shears[point.dofs(a)[i]] +=
                  share * t.q[k] * point.tangents[k][i];
            }
        // Implicit Euler.
        if (!interface.contact_pair(point).tied)
          dissipation -= point.weight * t.q * states[k].slip;
      }
  }



  template<int dim>
  void ContactCheck<dim>::check(const Slack       &slack,
                                ContactInvariants &found) const
  {
    for (const auto &contact_pair : interface.pairs)
      {
        if (contact_pair->master)
          check_balance(*contact_pair, slack, found);
        if (!contact_pair->tied)
          {
            check_depth(*contact_pair, found);
            if (contact_pair->master) // obstacles: see solve_increment()
              check_crossing(*contact_pair, found);
          }
      }
    check_normal(slack, found);
    check_tangential(slack, found);
  }



  namespace
  {
    /// By how much surfaces may overlap in the mesh before they touch [mm].
    template<int dim>
    double clearance(const ContactPair<dim> &contact_pair)
    {
      return std::max(0., -contact_pair.interference->added());
    }
  } // namespace



  template<int dim>
  void ContactCheck<dim>::check_depth(const ContactPair<dim> &contact_pair,
                                      ContactInvariants      &found) const
  {
    // Where no force has undone an overlap, the bodies passed through each
    // other, or are a press fit of polygons that leave more open than that.
    const bool        pushes = carries_force(contact_pair);
    ContactDepth<dim> now =
      largest_depth(contact_pair,
                    solution,
                    pushes ? DepthOf::motion : DepthOf::mesh);
    now.depth -= clearance(contact_pair);
    if (now.depth <= 0)
      return;
    const double of_obstacle =
      contact_pair.obstacle ? contact_pair.obstacle->way(now.X).norm() : 0.;
    // The way until the surfaces touched says nothing of the forces; the bodies
    // may not have deformed yet before the end of a run.
    double     way = of_obstacle, deformed = 0;
    const auto along =
      deformations_along(discretization,
                         fit_rigid_motions(discretization, solution),
                         solution,
                         now.normal);
    const auto look_at = [&](const Surface<dim> &surface) {
      for (const SurfaceNode<dim> &node : surface.nodes)
        for (const auto dof : node.dofs)
          way = std::max(way, std::abs(solution[dof]));
      for (const SurfaceFacet<dim> &facet : surface.facets)
        deformed = std::max(deformed, along.at(facet.body));
    };
    look_at(contact_pair.slave);
    if (contact_pair.master)
      look_at(*contact_pair.master);
    // No less than the digits of a mesh file resolve.
    const auto half = [&](const double of) {
      return std::max(0.5 * of,
                      contact_pair.slave.unresolved_length(now.slave_facet));
    };
    // Where forces act, surfaces overlap by what the mesh does not resolve: a
    // part of what the bodies have approached each other by along the way out,
    // which forces deform them by. Beyond half of that, forces may be off by a
    // factor.
    if (now.depth <= half(deformed))
      return;
    const std::string what =
      std::string("the place of the ") +
      std::string(now.of_master ? "master" : "slave") + " at X = (" +
      brief(now.X) + ") mm is " + brief(now.depth) + " mm inside of the " +
      (contact_pair.obstacle ? "obstacle" : "other body") +
      ", of bodies that deform by " + brief(deformed) + " mm that way" +
      (carries_force(contact_pair, now.slave_facet)
         ? ": forces may be off by a factor"
         : ", and no force acts there");
    const std::string advice =
      !pushes && contact_pair.master
        ? "The meshes do not resolve it: refine the slave, or exchange it with "
          "the master; round surfaces want degree 2."
      : now.of_master
        ? "The slave's edges are too long to see a corner of the "
          "master: exchange slave and master, or refine the slave."
        : "No contact point looks there: refine the mesh.";
    if (ends_run || now.depth > half(way))
      found.check("depth", now.depth, half(deformed), what, advice);
    else
      found.findings.push_back({"depth: " + what + ". " + advice});
  }



  template<int dim>
  void ContactCheck<dim>::check_crossing(const ContactPair<dim> &contact_pair,
                                         ContactInvariants      &found) const
  {
    const auto crossing = find_crossing(contact_pair, u_start, solution);
    if (crossing.depth <= clearance(contact_pair))
      return;
    found.check("depth",
                crossing.depth,
                0,
                "the node of the " +
                  std::string(crossing.of_master ? "master" : "slave") +
                  " at X = (" + brief(crossing.X) +
                  ") mm has gone through the other body in this increment, and "
                  "is " +
                  brief(crossing.depth) + " mm behind the side it went in by",
                "Take only the side that is to be touched as master, or more "
                "increments.");
  }



  template<int dim>
  bool
  ContactCheck<dim>::carries_force(const ContactPair<dim> &contact_pair) const
  {
    const auto body = [](const Surface<dim> &surface) {
      return surface.facets[0].body;
    };
    const auto is_of_these = [&](const ContactPair<dim> &other) {
      return &other == &contact_pair ||
             (other.master && contact_pair.master &&
              body(other.slave) == body(contact_pair.slave) &&
              body(*other.master) == body(*contact_pair.master));
    };
    const auto &points = interface.points();
    return std::any_of(points.begin(), points.end(), [&](const auto &point) {
      return point.status.kind != Status::open &&
             is_of_these(interface.contact_pair(point));
    });
  }



  template<int dim>
  bool ContactCheck<dim>::carries_force(const ContactPair<dim> &contact_pair,
                                        const unsigned int slave_facet) const
  {
    const SurfaceFacet<dim> &facet = contact_pair.slave.facets[slave_facet];
    for (const ContactPoint<dim> &point : interface.points())
      if (&interface.contact_pair(point) == &contact_pair &&
          point.status.kind != Status::open)
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int b = 0; b < facet.n_nodes(); ++b)
            if (point.is_on_slave(a) &&
                point.dofs(a) == contact_pair.slave.nodes[facet.nodes[b]].dofs)
              return true;
    return false;
  }



  template<int dim>
  std::string ContactCheck<dim>::at(const ContactPoint<dim> &point) const
  {
    return " at X = (" + brief(interface.contact_pair(point).place(point)) +
           ") mm";
  }

  template class ContactCheck<2>;
  template class ContactCheck<3>;
} // namespace Contact
