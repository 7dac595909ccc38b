/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactInterface on the status of the points and on the bounds of
// the shear.

#include <algorithm>
#include <limits>

#include "contact/contact_interface.h"

namespace Contact
{
  void ContactInterface::initialize_status(const Vector<double> &u)
  {
    for (ContactPoint &point : all_points)
      if (point.facing && !point.is_master_corner &&
          state(point, u, u).gap <=
            0.01 * contact_pair(point).edge_length(point))
        point.status.kind = can_stick(point) ? Status::stick : Status::slip;
    release_in_corners();
  }



  void ContactInterface::release_in_corners()
  {
    for (const auto &[q, others] : in_corner)
      if (is_held_in_corner(q, [this](const unsigned int point) {
            return all_points[point].status;
          }))
        all_points[q].status = {Status::slip, 0};
  }



  void ContactInterface::activate_nearest(const Vector<double> &u)
  {
    if (count().active > 0)
      return;
    double smallest = std::numeric_limits<double>::max();
    for (const ContactPoint &point : all_points)
      if (point.facing)
        smallest = std::min(smallest, state(point, u, u).gap);
    const auto close = [&](const bool corners) {
      for (ContactPoint &point : all_points)
        if (point.facing && point.is_master_corner == corners &&
            state(point, u, u).gap - smallest <=
              0.01 * contact_pair(point).edge_length(point))
          point.status.kind = can_stick(point) ? Status::stick : Status::slip;
    };
    close(false);
    if (count().active == 0)
      close(true);
    release_in_corners();
  }



  bool ContactInterface::can_stick(const ContactPoint &point) const
  {
    return has_friction(point) && !point.tangential_row_is_void;
  }



  // Where the supports rest, the last slip goes on.
  int ContactInterface::prescribed_direction(const ContactPoint &point) const
  {
    if (!has_friction(point) || contact_pair(point).tied ||
        support_motion.size() == 0)
      return 0;
    const double slip = prescribed_slip(point, discretization, support_motion);
    return slip == 0 ? point.status.slip_direction : slip > 0 ? -1 : 1;
  }



  double ContactInterface::update_bounds(const Vector<double> &solution,
                                         const Vector<double> &u_start)
  {
    double change = 0, largest = 0;
    for (ContactPoint &point : all_points)
      {
        if (contact_pair(point).tied)
          continue;
        const FrictionLaw &law = contact_pair(point).law;
        const double       bound =
          point.status.kind == Status::open
                  ? law.bound(0)
                  : law.bound(state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.friction_bound));
        largest = std::max(largest, bound);
        point.friction_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  void ContactInterface::raise_unknown_bounds()
  {
    for (ContactPoint &point : all_points)
      if (contact_pair(point).law.coulomb_coefficient > 0 &&
          point.friction_bound == 0)
        point.friction_bound = std::numeric_limits<double>::max();
  }



  Vector<double> ContactInterface::bounds() const
  {
    Vector<double> bounds(all_points.size());
    for (unsigned int q = 0; q < all_points.size(); ++q)
      bounds[q] = all_points[q].friction_bound;
    return bounds;
  }



  void ContactInterface::set_bounds(const Vector<double> &bounds)
  {
    for (unsigned int q = 0; q < all_points.size(); ++q)
      all_points[q].friction_bound = bounds[q];
  }



  // Slip turns round by way of sticking: where all points of a body slip, none
  // would hold it, whichever way they do.
  PointStatus ContactInterface::updated_status(const ContactPoint &point,
                                               const PointStatus  &before,
                                               const double        p_trial,
                                               const double        q_trial,
                                               const bool moving_bound) const
  {
    if (!point.facing || (!contact_pair(point).tied && p_trial <= 0))
      return {Status::open, 0};
    if (!can_stick(point))
      return {Status::slip, prescribed_direction(point)};

    const double bound = moving_bound ? contact_pair(point).law.bound(p_trial)
                                      : point.friction_bound;
    const int    direction = q_trial > 0 ? 1 : -1;
    if (std::abs(q_trial) <= bound || direction * before.slip_direction < 0)
      return {Status::stick, 0};
    return {Status::slip, direction};
  }



  Traction ContactInterface::traction(const ContactPoint &point,
                                      const PointStatus  &status,
                                      const double        p_trial,
                                      const double        q_trial,
                                      const bool          moving_bound) const
  {
    Traction traction;
    if (status.kind == Status::open)
      return traction;

    traction.p     = p_trial;
    traction.dp_dp = 1;
    if (status.kind == Status::stick)
      {
        traction.q     = q_trial;
        traction.dq_dq = 1;
      }
    else if (moving_bound)
      {
        traction.q =
          status.slip_direction * contact_pair(point).law.bound(p_trial);
        traction.dq_dp = status.slip_direction *
                         contact_pair(point).law.bound_derivative(p_trial);
      }
    else
      traction.q = status.slip_direction * point.friction_bound;
    return traction;
  }



  // From step to step a point knows its last status: slip turns round by way
  // of sticking. Under bounds that are frozen the problem is convex, and slip
  // turns round at once.
  PointStatus ContactInterface::status_in(const ContactPoint   &point,
                                          const Vector<double> &solution,
                                          const Vector<double> &u_start,
                                          const bool moving_bound) const
  {
    const ContactState now = state(point, solution, u_start);
    return updated_status(point,
                          moving_bound ? point.status : PointStatus(),
                          now.p_trial,
                          now.q_trial,
                          moving_bound);
  }



  unsigned int ContactInterface::update_statuses(const Vector<double> &solution,
                                                 const Vector<double> &u_start,
                                                 const bool moving_bound,
                                                 const bool keep)
  {
    std::vector<PointStatus> updated;
    for (const ContactPoint &point : all_points)
      updated.push_back(status_in(point, solution, u_start, moving_bound));
    for (const auto &[q, others] : in_corner)
      if (is_held_in_corner(q, [&](const unsigned int point) {
            return updated[point];
          }))
        updated[q] = {Status::slip, 0};

    unsigned int n_changes = 0;
    for (unsigned int q = 0; q < all_points.size(); ++q)
      n_changes += !(updated[q] == all_points[q].status);
    if (keep)
      set_statuses(updated);
    return n_changes;
  }



  void ContactInterface::update_first_status(const Vector<double> &solution,
                                             const Vector<double> &u_start,
                                             const bool            moving_bound)
  {
    for (unsigned int q = 0; q < all_points.size(); ++q)
      {
        ContactPoint     &point  = all_points[q];
        const PointStatus before = point.status;
        point.status = status_in(point, solution, u_start, moving_bound);
        release_in_corners();
        if (point.status == before)
          continue;
        if (!moving_bound && point.status.kind == Status::open)
          reset_bound(q);
        return;
      }
  }



  void ContactInterface::set_bound(const unsigned int point, const double bound)
  {
    all_points[point].friction_bound = bound;
  }



  void ContactInterface::reset_bound(const unsigned int point)
  {
    all_points[point].friction_bound =
      contact_pair(all_points[point]).law.bound(0);
  }



  void ContactInterface::reset_bounds_of_open_points()
  {
    for (unsigned int q = 0; q < all_points.size(); ++q)
      if (all_points[q].status.kind == Status::open)
        reset_bound(q);
  }



  void ContactInterface::release_parted(const Vector<double> &solution)
  {
    for (ContactPoint &point : all_points)
      if (!contact_pair(point).tied &&
          state(point, solution, solution).p_trial <= 0)
        point.status = PointStatus();
  }



  std::vector<PointStatus> ContactInterface::statuses() const
  {
    std::vector<PointStatus> all;
    for (const ContactPoint &point : all_points)
      all.push_back(point.status);
    return all;
  }



  void ContactInterface::set_statuses(const std::vector<PointStatus> &all)
  {
    for (unsigned int q = 0; q < all_points.size(); ++q)
      all_points[q].status = all[q];
  }



  std::vector<signed char> ContactInterface::signature() const
  {
    std::vector<signed char> signature;
    for (const ContactPoint &point : all_points)
      signature.push_back(point.status.code());
    return signature;
  }



  StatusCount ContactInterface::count() const
  {
    StatusCount count;
    for (const ContactPoint &point : all_points)
      {
        count.active += point.status.kind != Status::open;
        count.stick += point.status.kind == Status::stick;
      }
    return count;
  }
} // namespace Contact
