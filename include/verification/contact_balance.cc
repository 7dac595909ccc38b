/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactCheck on forces and moments.

#include <map>

#include "base/dimension.h"
#include "verification/contact_check.h"
#include "verification/worst_condition.h"

namespace Contact
{
  namespace
  {
    /// The moment that forces across a gap may lose, of glue or where surfaces
    /// have an interference, of that of the forces. Polygons of degree 1 on
    /// round surfaces that fit lose about 2e-3. What is kept apart in parts of
    /// the first increment may lose more until that ends.
    constexpr double largest_loss_over_gap = 0.01;



    template<int dim>
    bool acts_over_gap(const ContactPair<dim> &contact_pair)
    {
      return contact_pair.tied ||
             (contact_pair.interference->at &&
              contact_pair.interference->initial_clearance == 0);
    }
  } // namespace



  template<int dim>
  Point<dim> ContactCheck<dim>::position(const SurfaceNode<dim> &node) const
  {
    Point<dim> x = node.X;
    if (parameters.geometry != Parameters::GeometryLoop::undeformed)
      for (unsigned int i = 0; i < dim; ++i)
        x[i] += solution[node.dofs[i]];
    return x;
  }



  template<int dim>
  typename ContactCheck<dim>::Resultant
  ContactCheck<dim>::resultant(const ContactPair<dim> &contact_pair) const
  {
    // The middle of the slave and its size.
    Point<dim> low = position(contact_pair.slave.nodes[0]), high = low;
    for (unsigned int n = 1; n < contact_pair.slave.nodes.size(); ++n)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const Point<dim> x = position(contact_pair.slave.nodes[n]);
          low[i]             = std::min(low[i], x[i]);
          high[i]            = std::max(high[i], x[i]);
        }
    const Point<dim> middle = low + 0.5 * (high - low);

    // A node may belong to several points, and see other contact pairs as well.
    std::map<types::global_dof_index,
             std::pair<Tensor<1, dim>, const SurfaceNode<dim> *>>
      forces;
    for (unsigned int k = contact_pair.first_point;
         k < contact_pair.first_point + contact_pair.n_points;
         ++k)
      {
        const ContactPoint<dim> &point = interface.points()[k];
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            auto &[force, node] = forces[point.dofs(a)[0]];
            force += point.weight * point.C[a] *
                     (tractions[k].p * point.normal +
                      point.along_tangents(tractions[k].q));
            node = point.nodes[a];
          }
      }

    Resultant all;
    all.size = low.distance(high);
    for (const auto &[dof, of_node] : forces)
      {
        const auto &[f, node] = of_node;
        all.force += f;
        all.moment += moment_of(position(*node) - middle, f);
        all.magnitude += f.norm();
      }
    return all;
  }



  template<int dim>
  double ContactCheck<dim>::moment_of_discretization(
    const ContactPair<dim> &contact_pair) const
  {
    const bool undeformed =
      parameters.geometry == Parameters::GeometryLoop::undeformed;
    const double foot_moves = std::sqrt(2.) * moved;
    double       moment     = 0;
    for (unsigned int k = contact_pair.first_point;
         k < contact_pair.first_point + contact_pair.n_points;
         ++k)
      {
        const ContactPoint<dim> &point = interface.points()[k];
        Tensor<1, dim>           r;
        double                   sum_of_C = 0;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            sum_of_C += std::abs(point.C[a]);
            for (unsigned int i = 0; i < dim; ++i)
              r[i] +=
                point.C[a] * (point.X(a)[i] +
                              (undeformed ? 0. : solution[point.dofs(a)[i]]));
          }
        const double offset = point.projection_is_clipped || point.joined ||
                                  acts_over_gap(contact_pair)
                                ? point.tangential_part(r).norm()
                                : foot_moves * sum_of_C;
        moment +=
          point.weight * (tractions[k].q.norm() * std::abs(r * point.normal) +
                          std::abs(tractions[k].p) * offset);
      }
    return moment;
  }



  template<int dim>
  void ContactCheck<dim>::check_balance(const ContactPair<dim> &contact_pair,
                                        const Slack            &slack,
                                        ContactInvariants      &found) const
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
    // The forces on a ring have none in 2-D.
    if (discretization.axisymmetric)
      return;
    const double whole = all.magnitude * all.size;
    const double loss  = moment_of_discretization(contact_pair) / whole;
    // Forces that are no more than Newton's tolerance have any moment.
    const double of_gap   = largest_loss_over_gap + slack.force / all.magnitude;
    const bool   is_apart = acts_over_gap(contact_pair) && loss > of_gap;
    const double of_moments = all.moment.norm() / whole;
    found.moment_imbalance  = larger(found.moment_imbalance, of_moments);
    found.check(
      "balance of moments",
      of_moments,
      slack.relative + (is_apart ? of_gap : loss),
      "the forces of contact on both bodies have the moment " +
        brief(all.moment.norm()) + " " + Dimension<dim>::moment_unit,
      is_apart
        ? "The surfaces are apart where they are glued or have an "
          "interference, and the moment of the shear over the gap is lost: "
          "let them meet in the mesh."
        : "Slave points and their projections are apart along the surface: "
          "lower 'Solution/Geometry tolerance'.");
  }

  template class ContactCheck<2>;
  template class ContactCheck<3>;
} // namespace Contact
