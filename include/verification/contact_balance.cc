/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactCheck on forces and moments.

#include <map>

#include "verification/contact_check.h"
#include "verification/worst_condition.h"

namespace Contact
{
  Point<2> ContactCheck::position(const Surface     &surface,
                                  const unsigned int node) const
  {
    return parameters.geometry == Parameters::GeometryLoop::undeformed
             ? surface.nodes[node].X
             : surface.position(node, solution);
  }



  ContactCheck::Resultant
  ContactCheck::resultant(const ContactPair &contact_pair) const
  {
    // The middle of the slave and its size.
    Point<2> low = position(contact_pair.slave, 0), high = low;
    for (unsigned int n = 1; n < contact_pair.slave.nodes.size(); ++n)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Point<2> x = position(contact_pair.slave, n);
          low[i]           = std::min(low[i], x[i]);
          high[i]          = std::max(high[i], x[i]);
        }
    const Point<2> middle = low + 0.5 * (high - low);

    // A node may see other contact pairs as well.
    std::map<types::global_dof_index, Tensor<1, 2>> forces;
    for (unsigned int k = contact_pair.first_point;
         k < contact_pair.first_point + contact_pair.n_points;
         ++k)
      {
        const ContactPoint &point = interface.points()[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          forces[point.dofs[a][0]] +=
            point.weight * point.C[a] *
            (tractions[k].p * point.normal + tractions[k].q * point.tangent);
      }

    Resultant all;
    all.size = low.distance(high);
    for (const Surface *surface : {&contact_pair.slave, &*contact_pair.master})
      for (unsigned int n = 0; n < surface->nodes.size(); ++n)
        {
          const Tensor<1, 2> f   = forces[surface->nodes[n].dofs[0]];
          const Tensor<1, 2> arm = position(*surface, n) - middle;
          all.force += f;
          all.moment += arm[0] * f[1] - arm[1] * f[0];
          all.magnitude += f.norm();
        }
    return all;
  }



  double
  ContactCheck::moment_of_discretization(const ContactPair &contact_pair) const
  {
    const bool undeformed =
      parameters.geometry == Parameters::GeometryLoop::undeformed;
    const double foot_moves = std::sqrt(2.) * moved;
    double       moment     = 0;
    for (unsigned int k = contact_pair.first_point;
         k < contact_pair.first_point + contact_pair.n_points;
         ++k)
      {
        const ContactPoint &point = interface.points()[k];
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
        const double offset = point.projection_is_clipped || contact_pair.tied
                                ? std::abs(r * point.tangent)
                                : foot_moves * sum_of_C;
        moment +=
          point.weight * (std::abs(tractions[k].q * (r * point.normal)) +
                          std::abs(tractions[k].p) * offset);
      }
    return moment;
  }



  void ContactCheck::check_balance(const ContactPair &contact_pair,
                                   const Slack       &slack,
                                   ContactInvariants &found) const
  {
    const Resultant all = resultant(contact_pair);
    if (all.magnitude == 0)
      return;
    const std::string unit      = " N" + discretization.per_thickness();
    const double      of_forces = all.force.norm() / all.magnitude;
    found.force_imbalance       = larger(found.force_imbalance, of_forces);
    found.check("balance of forces",
                of_forces,
                slack.relative,
                "the forces of contact on both bodies add up to " +
                  brief(all.force.norm()) + unit + " of " +
                  brief(all.magnitude) + unit,
                "The coefficients of a point do not add up to zero: an error "
                "of the program.");
    // The forces on a ring have none in the plane.
    if (discretization.axisymmetric)
      return;
    const double whole      = all.magnitude * all.size;
    const double of_moments = std::abs(all.moment) / whole;
    found.moment_imbalance  = larger(found.moment_imbalance, of_moments);
    found.check(
      "balance of moments",
      of_moments,
      slack.relative + moment_of_discretization(contact_pair) / whole,
      "the forces of contact on both bodies have the moment " +
        brief(all.moment) + " N",
      "Slave points and their projections are apart along the surface: "
      "lower 'Solution/Geometry tolerance'.");
  }
} // namespace Contact
