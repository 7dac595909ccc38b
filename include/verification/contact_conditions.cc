/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactCheck on pressures and gaps, shears and slips.

#include <cmath>

#include "verification/contact_check.h"
#include "verification/worst_condition.h"

namespace Contact
{
  namespace
  {
    const std::string wrong_set =
      "Do not use this increment: the active set is not that of this state; "
      "try smaller increments, or 'Solution/Geometry = Newton'.";
  } // namespace



  // The sums over the points of w psi_k (p - lambda)/c, of either direction.
  template<int dim>
  typename ContactCheck<dim>::WeakConditions
  ContactCheck<dim>::weak_conditions(const unsigned int direction,
                                     const Slack       &slack) const
  {
    const bool         tangential = direction > 0;
    const unsigned int n          = interface.n_normal_multipliers();
    WeakConditions     weak{std::vector<double>(n),
                        std::vector<double>(n),
                        std::vector<double>(n),
                        std::vector<unsigned int>(n)};
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<dim> &point        = interface.points()[k];
        const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
        if (tangential &&
            (contact_pair.tied || contact_pair.law.is_frictionless()))
          continue;
        const double difference =
          tangential
            ? tractions[k].q[direction - 1] - states[k].lambda_t[direction - 1]
            : tractions[k].p - states[k].lambda_n;
        for (unsigned int m = 0; m < point.n_multipliers; ++m)
          {
            const unsigned int l     = point.multipliers[m];
            const double       share = point.weight * point.psi[m];
            weak.defect[l] += share * difference / point.augmentation_parameter;
            if (tangential && point.status.kind == Status::slip)
              weak.allowed[l] += std::abs(share) * slack.shear;
            weak.stiffness[l] = contact_pair.stiffness(point);
            weak.point[l]     = k;
          }
      }
    return weak;
  }



  template<int dim>
  void ContactCheck<dim>::add_normal_condition(const unsigned int k,
                                               const Slack       &slack,
                                               Worst             &worst) const
  {
    const ContactPoint<dim> &point        = interface.points()[k];
    const ContactState<dim> &now          = states[k];
    const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
    const double             p            = pressure(k);
    if (point.status.kind != Status::open)
      worst.add(-point.weight * p, 0, [&]() {
        return "the pressure in contact is " + brief(p) + " MPa" + at(point);
      });
    else if (contact_pair.has_point_per_multiplier())
      worst.add(-point.weight * contact_pair.stiffness(point) * now.gap,
                slack.force,
                [&]() {
                  return "where it is open, the gap is " + brief(now.gap) +
                         " mm" + at(point);
                });
  }



  // The conditions in the normal direction: weak ones by multiplier, signs by
  // point.
  template<int dim>
  void ContactCheck<dim>::check_normal(const Slack       &slack,
                                       ContactInvariants &found) const
  {
    Worst worst;
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<dim> &point        = interface.points()[k];
        const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
        if (contact_pair.tied || !point.facing)
          continue;
        add_normal_condition(k, slack, worst);
        const double penetration = -states[k].gap;
        if (penetration > found.penetration)
          {
            found.penetration = penetration;
            found.relative_penetration =
              penetration / contact_pair.edge_length(point);
          }
      }
    const WeakConditions weak = weak_conditions(0, slack);
    for (unsigned int l = 0; l < weak.defect.size(); ++l)
      worst.add(weak.stiffness[l] * std::abs(weak.defect[l]),
                slack.force,
                [&]() {
                  return "the condition p = max(0, lambda - c g) fails by the "
                         "force " +
                         brief(weak.stiffness[l] * weak.defect[l]) + " N" +
                         discretization.per_thickness() +
                         at(interface.points()[weak.point[l]]);
                });

    check_penalty(found);
    found.augmentation_parameter = worst.value / slack.reference;
    if (worst.is_violated())
      found.check("complementarity",
                  worst.value / slack.reference,
                  (worst.value - worst.excess) / slack.reference,
                  worst.sentence,
                  wrong_set);
  }



  // With c far below the stiffness of the bodies, what is penalty instead of
  // multiplier is no pressure: see the header.
  template<int dim>
  void ContactCheck<dim>::check_penalty(ContactInvariants &found) const
  {
    double       largest_pressure = 0, largest_penalty = 0;
    unsigned int worst = 0;
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<dim> &point        = interface.points()[k];
        const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
        if (point.status.kind == Status::open || contact_pair.tied ||
            contact_pair.has_point_per_multiplier())
          continue;
        largest_pressure = std::max(largest_pressure, tractions[k].p);
        if (const double penalty = tractions[k].p - states[k].lambda_n;
            penalty > largest_penalty)
          {
            largest_penalty = penalty;
            worst           = k;
          }
      }
    if (largest_pressure > 0)
      found.check(
        "penetration",
        largest_penalty / largest_pressure,
        0.5,
        "of the largest pressure " + brief(largest_pressure) + " MPa, " +
          brief(largest_penalty) + " MPa come from a penetration of " +
          brief(-states[worst].gap) + " mm" + at(interface.points()[worst]),
        "An edge of the slave faces the master with a part of its points "
        "only: take the other surface as the slave, or another discretization.");
  }



  template<int dim>
  void ContactCheck<dim>::add_tangential_condition(const unsigned int k,
                                                   const Slack       &slack,
                                                   Worst             &cone,
                                                   Worst &slip) const
  {
    const ContactPoint<dim> &point        = interface.points()[k];
    const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
    const double             q            = tractions[k].q.norm();
    const double             bound        = contact_pair.law.bound(pressure(k));
    cone.add(q - bound, slack.shear + slack.relative * largest_bound, [&]() {
      return "the shear is " + brief(q) + " MPa under a bound of " +
             brief(bound) + " MPa" + at(point);
    });
    if (point.status.kind != Status::slip || q == 0 ||
        !contact_pair.has_point_per_multiplier())
      return;
    const double s = states[k].slip.norm();
    const double per_traction =
      contact_pair.stiffness(point) / point.augmentation_parameter;
    slip.add(point.weight * contact_pair.stiffness(point) *
               std::copysign(s, states[k].slip * tractions[k].q),
             slack.force + point.weight * per_traction * slack.shear,
             [&]() {
               return "the slip is " + brief(s) + " mm along the shear of " +
                      brief(q) + " MPa" + at(point);
             });
  }



  template<int dim>
  void ContactCheck<dim>::check_slip(const WeakConditions &weak,
                                     const Slack          &slack,
                                     Worst                &slip) const
  {
    for (unsigned int l = 0; l < weak.defect.size(); ++l)
      {
        const ContactPoint<dim> &point = interface.points()[weak.point[l]];
        slip.add(weak.stiffness[l] * std::abs(weak.defect[l]),
                 slack.force + weak.stiffness[l] * weak.allowed[l] /
                                 point.augmentation_parameter,
                 [&]() {
                   return "the slip law q = projection of lambda - c s fails "
                          "by the force " +
                          brief(weak.stiffness[l] * weak.defect[l]) + " N" +
                          discretization.per_thickness() + at(point);
                 });
      }
  }



  // The same in the tangential direction.
  template<int dim>
  void ContactCheck<dim>::check_tangential(const Slack       &slack,
                                           ContactInvariants &found) const
  {
    if (!interface.has_friction())
      return;
    Worst cone, slip;
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<dim> &point        = interface.points()[k];
        const ContactPair<dim>  &contact_pair = interface.contact_pair(point);
        if (!contact_pair.tied && !contact_pair.law.is_frictionless() &&
            point.status.kind != Status::open)
          add_tangential_condition(k, slack, cone, slip);
      }
    for (unsigned int direction = 1; direction < dim; ++direction)
      check_slip(weak_conditions(direction, slack), slack, slip);

    found.cone = largest_bound > 0 ? cone.value / largest_bound : cone.value;
    found.slip = slip.value / slack.reference;
    if (cone.is_violated())
      found.check(
        "friction cone",
        found.cone,
        found.cone * (1 - cone.excess / cone.value),
        cone.sentence,
        "Lower 'Solution/Friction tolerance', or set 'Solution/Friction = "
        "Newton'.");
    if (slip.is_violated())
      found.check("slip",
                  slip.value / slack.reference,
                  (slip.value - slip.excess) / slack.reference,
                  slip.sentence,
                  wrong_set);
  }

  template class ContactCheck<2>;
  template class ContactCheck<3>;
} // namespace Contact
