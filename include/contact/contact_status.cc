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
    for (ContactPoint &point : points)
      if (point.facing && !point.is_master_corner &&
          state(point, u, u).gap <= 0.01 * zone(point).edge_length(point))
        point.decision.status = can_stick(point) ? Status::stick : Status::slip;
  }



  void ContactInterface::close_nearest(const Vector<double> &u)
  {
    if (count().active > 0)
      return;
    double smallest = std::numeric_limits<double>::max();
    for (const ContactPoint &point : points)
      if (point.facing)
        smallest = std::min(smallest, state(point, u, u).gap);
    const auto close = [&](const bool corners) {
      for (ContactPoint &point : points)
        if (point.facing && point.is_master_corner == corners &&
            state(point, u, u).gap - smallest <=
              0.01 * zone(point).edge_length(point))
          point.decision.status =
            can_stick(point) ? Status::stick : Status::slip;
    };
    close(false);
    if (count().active == 0)
      close(true);
  }



  bool ContactInterface::can_stick(const ContactPoint &point) const
  {
    return has_friction(point) && !point.tangential_row_is_void;
  }



  double ContactInterface::update_bounds(const Vector<double> &solution,
                                         const Vector<double> &u_start)
  {
    double change = 0, largest = 0;
    for (ContactPoint &point : points)
      {
        if (zone(point).tied)
          continue;
        const FrictionLaw &law = zone(point).law;
        const double       bound =
          point.decision.status == Status::open
                  ? law.bound(0)
                  : law.bound(state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.tresca_bound));
        largest = std::max(largest, bound);
        point.tresca_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  void ContactInterface::raise_unknown_bounds()
  {
    for (ContactPoint &point : points)
      if (zone(point).law.coulomb_coefficient > 0 && point.tresca_bound == 0)
        point.tresca_bound = std::numeric_limits<double>::max();
  }



  Vector<double> ContactInterface::bounds() const
  {
    Vector<double> bounds(points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      bounds[q] = points[q].tresca_bound;
    return bounds;
  }



  void ContactInterface::set_bounds(const Vector<double> &bounds)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].tresca_bound = bounds[q];
  }



  // Slip turns round by way of sticking: where all points of a body slip, none
  // would hold it, whichever way they do.
  Decision ContactInterface::decide(const ContactPoint &point,
                                    const Decision     &before,
                                    const double        p_trial,
                                    const double        q_trial,
                                    const bool          moving_bound) const
  {
    if (!point.facing || (!zone(point).tied && p_trial <= 0))
      return {Status::open, 0};
    if (!can_stick(point))
      return {Status::slip, 0};

    const double bound =
      moving_bound ? zone(point).law.bound(p_trial) : point.tresca_bound;
    const int direction = q_trial > 0 ? 1 : -1;
    if (std::abs(q_trial) <= bound || direction * before.slip_direction < 0)
      return {Status::stick, 0};
    return {Status::slip, direction};
  }



  Traction ContactInterface::traction(const ContactPoint &point,
                                      const Decision     &decision,
                                      const double        p_trial,
                                      const double        q_trial,
                                      const bool          moving_bound) const
  {
    Traction traction;
    if (decision.status == Status::open)
      return traction;

    traction.p     = p_trial;
    traction.dp_dp = 1;
    if (decision.status == Status::stick)
      {
        traction.q     = q_trial;
        traction.dq_dq = 1;
      }
    else if (moving_bound)
      {
        traction.q = decision.slip_direction * zone(point).law.bound(p_trial);
        traction.dq_dp =
          decision.slip_direction * zone(point).law.bound_derivative(p_trial);
      }
    else
      traction.q = decision.slip_direction * point.tresca_bound;
    return traction;
  }



  // From step to step a point knows its last decision: slip turns round by way
  // of sticking. Under bounds that are frozen the problem is convex, and slip
  // turns round at once.
  Decision ContactInterface::decision_in(const ContactPoint   &point,
                                         const Vector<double> &solution,
                                         const Vector<double> &u_start,
                                         const bool moving_bound) const
  {
    const ContactState now = state(point, solution, u_start);
    return decide(point,
                  moving_bound ? point.decision : Decision(),
                  now.p_trial,
                  now.q_trial,
                  moving_bound);
  }



  unsigned int ContactInterface::decide_all(const Vector<double> &solution,
                                            const Vector<double> &u_start,
                                            const bool            moving_bound,
                                            const bool            keep)
  {
    unsigned int n_changes = 0;
    for (ContactPoint &point : points)
      {
        const Decision decision =
          decision_in(point, solution, u_start, moving_bound);
        if (decision == point.decision)
          continue;
        ++n_changes;
        if (keep)
          point.decision = decision;
      }
    return n_changes;
  }



  void ContactInterface::decide_one(const Vector<double> &solution,
                                    const Vector<double> &u_start,
                                    const bool            moving_bound)
  {
    for (ContactPoint &point : points)
      {
        const Decision decision =
          decision_in(point, solution, u_start, moving_bound);
        if (decision == point.decision)
          continue;
        point.decision = decision;
        if (!moving_bound && decision.status == Status::open)
          drop_bound(&point - points.data());
        return;
      }
  }



  void ContactInterface::drop_bound(const unsigned int point)
  {
    points[point].tresca_bound = zone(points[point]).law.bound(0);
  }



  void ContactInterface::drop_bounds_of_open_points()
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].decision.status == Status::open)
        drop_bound(q);
  }



  void ContactInterface::open_parted(const Vector<double> &solution)
  {
    for (ContactPoint &point : points)
      if (!zone(point).tied && state(point, solution, solution).p_trial <= 0)
        point.decision = Decision();
  }



  std::vector<Decision> ContactInterface::decisions() const
  {
    std::vector<Decision> all;
    for (const ContactPoint &point : points)
      all.push_back(point.decision);
    return all;
  }



  void ContactInterface::set_decisions(const std::vector<Decision> &all)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].decision = all[q];
  }



  std::vector<signed char> ContactInterface::signature() const
  {
    std::vector<signed char> signature;
    for (const ContactPoint &point : points)
      signature.push_back(point.decision.code());
    return signature;
  }



  StatusCount ContactInterface::count() const
  {
    StatusCount count;
    for (const ContactPoint &point : points)
      {
        count.active += point.decision.status != Status::open;
        count.stick += point.decision.status == Status::stick;
      }
    return count;
  }
} // namespace Contact
