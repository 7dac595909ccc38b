/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactInterface on motions of the masters, given and free.

#include "base/errors.h"
#include "contact/interface/contact_interface.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    /// The values of the free motions of a contact pair.
    template<int dim>
    std::vector<double> part(const std::vector<double> &of_all,
                             const ContactPair<dim>    &contact_pair)
    {
      const auto first = of_all.begin() + contact_pair.first_motion;
      return {first, first + contact_pair.free_motions.size()};
    }
  } // namespace



  template<int dim>
  void ContactInterface<dim>::make_free_motions(
    ContactPair<dim>          &contact_pair,
    const Parameters::Contact &parameters)
  {
    contact_pair.first_motion = all_motions.size();
    const auto add            = [&](const std::string &name,
                         const std::string &history,
                         const std::string &entry) {
      auto motion          = std::make_unique<FreeMotion>();
      motion->name         = name;
      motion->contact_pair = pairs.size();
      motion->force_at =
        parse_history(history, parameters.section() + "/" + entry);
      all_motions.push_back(motion.get());
      contact_pair.free_motions.push_back(std::move(motion));
    };
    for (const auto &[name, history] : parameters.obstacle_force)
      add(name, history, "Obstacle force");
    if (!parameters.obstacle_moment.empty())
      {
        add("angle", parameters.obstacle_moment, "Obstacle moment");
        all_motions.back()->turns = true;
        double &lever             = all_motions.back()->lever;
        lever                     = 0;
        for (const SurfaceNode<dim> &node : contact_pair.slave.nodes)
          lever =
            std::max(lever, node.X.distance(contact_pair.obstacle->centre()));
      }
    if (!parameters.preload.empty())
      {
        add("shortening", parameters.preload, "Preload");
        all_motions.back()->end = parameters.preload_end;
      }
  }



  template<int dim>
  bool ContactInterface<dim>::move_obstacles(const double         from,
                                             const double         to,
                                             const GhostedVector &start)
  {
    for (FreeMotion *motion : all_motions)
      {
        const bool stayed = motion->stays;
        motion->force     = motion->force_at(Point<1>(to));
        motion->stays     = from >= motion->end;
        equations_changed = equations_changed || motion->stays != stayed;
      }
    const auto at_start = motions(start);
    bool       moves    = equations_changed;
    for (const auto &contact_pair : pairs)
      {
        if (contact_pair->obstacle &&
            contact_pair->obstacle->move(from,
                                         to,
                                         part(at_start, *contact_pair)))
          {
            ++discretization.counters.obstacle_moves;
            moves = true;
          }
        if (auto &interference = *contact_pair->interference; interference.at)
          {
            ++discretization.counters.interferences;
            interference.now = interference.at(Point<1>(to));
          }
      }
    obstacles_are_moving = moves && from != to;
    return moves;
  }



  // The normals are those of the last pairing: before obstacles turn.
  template<int dim>
  void ContactInterface<dim>::begin_increment(const double         from,
                                              const GhostedVector &solution)
  {
    for (ContactPoint<dim> &point : all_points)
      {
        const auto &interference    = *contact_pair(point).interference;
        point.shear_at_start        = state(point, solution, solution).lambda_t;
        point.interference_at_start = Tensor<1, dim>();
        if (interference.at)
          point.interference_at_start =
            interference.at(Point<1>(from)) * point.normal;
      }
  }



  template<int dim>
  void
  ContactInterface<dim>::pair_and_begin_increment(const double         from,
                                                  const GhostedVector &start)
  {
    if (std::none_of(pairs.begin(), pairs.end(), [](const auto &contact_pair) {
          return bool(contact_pair->interference->at);
        }))
      return;
    pair(start);
    begin_increment(from, start);
  }



  template<int dim>
  void
  ContactInterface<dim>::ramp_initial_penetration(const double         from,
                                                  const double         to,
                                                  const GhostedVector &start)
  {
    for (const auto &contact_pair : pairs)
      if (!contact_pair->tied)
        {
          auto &interference = *contact_pair->interference;
          if (from == 0 && to < 1)
            {
              interference.at_start = interference.initial_clearance = 0;
              for (const ContactPoint<dim> &point : points_of(*contact_pair))
                if (point.facing)
                  interference.at_start =
                    std::max(interference.at_start,
                             -state(point, start, start).gap);
            }
          interference.initial_clearance = (1 - to) * interference.at_start;
          for (unsigned int k = 0; k < contact_pair->n_points; ++k)
            {
              auto &point = all_points[contact_pair->first_point + k];
              point.interference_at_start -=
                (1 - from) * interference.at_start * point.normal;
            }
        }
  }



  template<int dim>
  void ContactInterface<dim>::place_obstacles(const GhostedVector &solution,
                                              const bool           keeps_place)
  {
    if (all_motions.empty() ||
        solution.size() <= discretization.dof_handler.n_dofs())
      return;
    const auto now = motions(solution);
    for (const auto &contact_pair : pairs)
      if (contact_pair->obstacle)
        contact_pair->obstacle->place(part(now, *contact_pair), keeps_place);
  }



  template<int dim>
  std::vector<double>
  ContactInterface<dim>::motions(const GhostedVector &solution) const
  {
    std::vector<double> values(all_motions.size());
    if (solution.size() > discretization.dof_handler.n_dofs())
      for (unsigned int k = 0; k < values.size(); ++k)
        values[k] = solution[motion_index(k)];
    return values;
  }



  template<int dim>
  std::vector<double>
  ContactInterface<dim>::motion_forces(const GhostedVector &solution,
                                       const GhostedVector &u_start,
                                       const bool of_multipliers) const
  {
    std::vector<double> forces(all_motions.size());
    for (const ContactPoint<dim> &point : all_points)
      if (!point.motions.empty())
        {
          const ContactState<dim> now = state(point, solution, u_start);
          Traction<dim>           t   = traction(point, now);
          if (of_multipliers)
            {
              t.p = now.lambda_n;
              t.q = now.lambda_t;
            }
          double w = 0;
          for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
            w += point.weight * point.C[a];
          for (unsigned int k = 0; k < point.motions.size(); ++k)
            forces[contact_pair(point).first_motion + k] +=
              w * (t.p * point.normal + point.along_tangents(t.q)) *
              point.motions[k].way;
        }
    return forces;
  }



  template<int dim>
  void ContactInterface<dim>::begin_to_touch(const GhostedVector &u)
  {
    for (const auto &contact_pair : pairs)
      if (!contact_pair->free_motions.empty() && !touches(*contact_pair))
        activate_nearest({contact_pair.get()}, u);
  }



  template<int dim>
  bool
  ContactInterface<dim>::touches(const ContactPair<dim> &contact_pair) const
  {
    const auto points = points_of(contact_pair);
    return std::any_of(points.begin(), points.end(), [](const auto &point) {
      return point.status.kind != Status::open;
    });
  }



  template<int dim>
  double ContactInterface<dim>::motion_spring(const FreeMotion &motion) const
  {
    const ContactPair<dim> &of       = *pairs[motion.contact_pair];
    double                  stiffest = 0;
    for (const ContactPoint<dim> &point : points_of(of))
      stiffest =
        std::max(stiffest, of.stiffness(point) * std::abs(point.weight));
    return 1e-10 * stiffest * motion.lever * motion.lever;
  }



  template<int dim>
  void ContactInterface<dim>::check_motion(const FreeMotion &motion,
                                           const double      way,
                                           const double      missing) const
  {
    if (motion_spring(motion) * std::abs(way) > 0.1 * missing * motion.lever)
      throw NotConverged(
        "nothing resists the motion '" + motion.name +
        "' of the obstacle of '" + pairs[motion.contact_pair]->section() +
        "' under its force or moment: the obstacle touches too "
        "little, or the body gives way; give this motion, or a "
        "force that presses");
  }

  template class ContactInterface<2>;
  template class ContactInterface<3>;
} // namespace Contact
