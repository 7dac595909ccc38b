/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exchange.h"
#include "contact/interface/contact_interface.h"

namespace Contact
{
  namespace
  {
    /// The pressure under which a point closes [MPa]: of an open one that of
    /// the round-off of its gap. Where others hold its node already, the gap is
    /// nothing else, and would choose a status.
    template<int dim>
    double smallest_pressure(const ContactPoint<dim> &point)
    {
      return point.status.kind == Status::open
               ? point.augmentation_parameter * point.gap_round_off()
               : 0;
    }



    /// The direction of a shear traction that is not zero.
    template<int dim>
    typename PointStatus<dim>::Direction
    direction_of(const Tensor<1, dim - 1> &q)
    {
      if constexpr (dim == 2)
        return q[0] > 0 ? 1 : -1;
      else
        return q / q.norm();
    }
  } // namespace



  template<int dim>
  void ActiveSet<dim>::initialize(const GhostedVector &u)
  {
    for (const auto &contact_pair : interface.pairs)
      for (ContactPoint<dim> &point : contact_pair->points_of_slave(points))
        if (point.facing && interface.state(point, u, u).gap <=
                              0.01 * contact_pair->edge_length(point))
          point.status.kind = can_stick(point) ? Status::stick : Status::slip;
  }



  template<int dim>
  void ActiveSet<dim>::activate_nearest(const GhostedVector &u)
  {
    std::vector<const ContactPair<dim> *> all;
    for (const auto &contact_pair : interface.pairs)
      all.push_back(&*contact_pair);
    if (count().active == 0)
      activate_nearest(all, u);
  }



  template<int dim>
  void ActiveSet<dim>::activate_nearest(
    const std::vector<const ContactPair<dim> *> &of,
    const GhostedVector                         &u)
  {
    double smallest = std::numeric_limits<double>::max();
    for (const ContactPair<dim> *const contact_pair : of)
      for (const ContactPoint<dim> &point : contact_pair->points_among(points))
        if (point.facing)
          smallest = std::min(smallest, interface.state(point, u, u).gap);
    bool       is_active = false;
    const auto close     = [&](const ArrayView<ContactPoint<dim>> &points) {
      for (ContactPoint<dim> &point : points)
        if (point.facing &&
            interface.state(point, u, u).gap - smallest <=
              0.01 * interface.contact_pair(point).edge_length(point))
          {
            point.status.kind = can_stick(point) ? Status::stick : Status::slip;
            is_active         = true;
          }
    };
    for (const ContactPair<dim> *const contact_pair : of)
      close(contact_pair->points_of_slave(points));
    if (!is_active)
      for (const ContactPair<dim> *const contact_pair : of)
        close(contact_pair->corners_of_master(points));
  }



  template<int dim>
  void ActiveSet<dim>::activate_free_obstacles(const GhostedVector &u)
  {
    for (const auto &contact_pair : interface.pairs)
      {
        const auto own = contact_pair->points_among(points);
        if (!contact_pair->free_motions.empty() &&
            std::all_of(own.begin(), own.end(), [](const auto &point) {
              return point.status.kind == Status::open;
            }))
          activate_nearest({contact_pair.get()}, u);
      }
  }



  // A point that supports move along the surface slips, in whatever other
  // directions it could stick.
  template<int dim>
  bool ActiveSet<dim>::can_stick(const ContactPoint<dim> &point) const
  {
    return interface.has_friction(point) && !point.has_no_free_tangent &&
           slip_of_supports(point) == Tensor<1, dim - 1>();
  }



  template<int dim>
  Tensor<1, dim - 1>
  ActiveSet<dim>::slip_of_supports(const ContactPoint<dim> &point) const
  {
    if (!interface.has_friction(point) || interface.contact_pair(point).tied ||
        support_motion.size() == 0)
      return {};
    return prescribed_slip(point, interface.discretization, support_motion);
  }



  // Points that stuck and that supports move now begin to slip.
  template<int dim>
  void ActiveSet<dim>::set_support_motion(const GhostedVector &motion)
  {
    support_motion = motion;
    for (ContactPoint<dim> &point : points)
      if (point.status.kind == Status::stick &&
          !interface.contact_pair(point).tied && !can_stick(point))
        point.status = {Status::slip, prescribed_direction(point, {})};
  }



  // The shear says how the slip turns in a direction that supports leave free.
  // If they leave none and rest, the last slip goes on.
  template<int dim>
  typename PointStatus<dim>::Direction
  ActiveSet<dim>::prescribed_direction(const ContactPoint<dim>  &point,
                                       const Tensor<1, dim - 1> &q_trial) const
  {
    if (!interface.has_friction(point) || interface.contact_pair(point).tied ||
        support_motion.size() == 0)
      return {};
    if (!point.has_no_free_tangent && q_trial.norm() > 0)
      return direction_of<dim>(q_trial);
    const Tensor<1, dim - 1> slip = slip_of_supports(point);
    return slip.norm() > 0 ? direction_of<dim>(-slip)
                           : point.status.slip_direction;
  }



  // Slip turns round by way of sticking: where all points of a body slip, none
  // would hold it, whichever way they do.
  template<int dim>
  PointStatus<dim>
  ActiveSet<dim>::updated_status(const ContactPoint<dim>  &point,
                                 const PointStatus<dim>   &before,
                                 const double              p_trial,
                                 const Tensor<1, dim - 1> &q_trial) const
  {
    if (!point.facing || (!interface.contact_pair(point).tied &&
                          p_trial <= smallest_pressure(point)))
      return {Status::open, {}};
    if (!can_stick(point))
      return {Status::slip, prescribed_direction(point, q_trial)};

    // The shear of a point that slips is its bound but for round-off, also
    // where nothing moves in the next increment: it goes on.
    const double at_bound =
      before.kind == Status::slip && before.has_direction()
        ? 1 - std::sqrt(std::numeric_limits<double>::epsilon())
        : 1.;
    if (q_trial.norm() <=
          at_bound * interface.bounds.law(point).bound(p_trial) ||
        q_trial * before.direction() < 0)
      return {Status::stick, {}};
    return {Status::slip, direction_of<dim>(q_trial)};
  }



  template<int dim>
  Traction<dim>
  ActiveSet<dim>::traction(const ContactPoint<dim>  &point,
                           const PointStatus<dim>   &status,
                           const double              p_trial,
                           const Tensor<1, dim - 1> &q_trial) const
  {
    Traction<dim> traction;
    if (status.kind == Status::open)
      return traction;

    traction.p     = p_trial;
    traction.dp_dp = 1;
    if (status.kind == Status::stick)
      {
        traction.q     = q_trial;
        traction.dq_dq = unit_symmetric_tensor<dim - 1>();
      }
    else
      {
        const FrictionLaw        law = interface.bounds.law(point);
        const Tensor<1, dim - 1> d   = status.direction();
        traction.q                   = d * law.bound(p_trial);
        traction.dq_dp               = d * law.bound_derivative(p_trial);
        // The direction turns with the trial value: in 3-D alone.
        if (const double size = q_trial.norm();
            size > 0 && status.has_direction())
          traction.dq_dq =
            law.bound(p_trial) / size *
            (Tensor<2, dim - 1>(unit_symmetric_tensor<dim - 1>()) -
             outer_product(d, d));
      }
    return traction;
  }



  // From step to step a point knows its last status: slip turns round by way
  // of sticking. Under bounds that are frozen the problem is convex, and slip
  // turns round at once.
  template<int dim>
  PointStatus<dim> ActiveSet<dim>::status_in(const ContactPoint<dim> &point,
                                             const GhostedVector     &solution,
                                             const GhostedVector &u_start) const
  {
    const ContactState<dim> now = interface.state(point, solution, u_start);
    const bool              is_pressed =
      multipliers_are_forces && point.status.kind != Status::open &&
      interface.contact_pair(point).has_point_per_multiplier() &&
      now.lambda_n > point.augmentation_parameter * point.gap_round_off();
    return updated_status(point,
                          interface.bounds.follow ? point.status
                                                  : PointStatus<dim>(),
                          is_pressed ? now.lambda_n : now.p_trial,
                          now.q_trial);
  }



  template<int dim>
  unsigned int ActiveSet<dim>::update(const GhostedVector &solution,
                                      const GhostedVector &u_start,
                                      const bool           keep)
  {
    std::vector<PointStatus<dim>> of_rank;
    for (const auto q : interface.own_points())
      of_rank.push_back(status_in(points[q], solution, u_start));
    const std::vector<PointStatus<dim>> updated =
      gathered(of_rank, interface.discretization.communicator);

    unsigned int n_changes = 0;
    for (unsigned int q = 0; q < points.size(); ++q)
      n_changes += !(updated[q] == points[q].status);
    if (keep)
      set_statuses(updated);
    return n_changes;
  }



  template<int dim>
  void ActiveSet<dim>::update_first(const GhostedVector &solution,
                                    const GhostedVector &u_start)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        ContactPoint<dim>     &point  = points[q];
        const PointStatus<dim> before = point.status;
        point.status                  = status_in(point, solution, u_start);
        if (point.status == before)
          continue;
        if (!interface.bounds.follow && point.status.kind == Status::open)
          interface.bounds.reset(q);
        return;
      }
  }



  template<int dim>
  void ActiveSet<dim>::release_parted(const GhostedVector &solution)
  {
    for (ContactPoint<dim> &point : points)
      if (!interface.contact_pair(point).tied &&
          interface.state(point, solution, solution).p_trial <= 0)
        point.status = PointStatus<dim>();
  }



  template<int dim>
  std::vector<PointStatus<dim>> ActiveSet<dim>::statuses() const
  {
    std::vector<PointStatus<dim>> all;
    for (const ContactPoint<dim> &point : points)
      all.push_back(point.status);
    return all;
  }



  template<int dim>
  void ActiveSet<dim>::set_statuses(const std::vector<PointStatus<dim>> &all)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].status = all[q];
  }



  template<int dim>
  std::vector<signed char> ActiveSet<dim>::signature() const
  {
    std::vector<signed char> signature;
    for (const ContactPoint<dim> &point : points)
      signature.push_back(point.status.code());
    return signature;
  }



  template<int dim>
  StatusCount ActiveSet<dim>::count() const
  {
    StatusCount count;
    for (const ContactPoint<dim> &point : points)
      {
        count.active += point.status.kind != Status::open;
        count.stick += point.status.kind == Status::stick;
      }
    return count;
  }

  template class ActiveSet<2>;
  template class ActiveSet<3>;
} // namespace Contact
