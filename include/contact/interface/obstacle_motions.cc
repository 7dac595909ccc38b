/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/obstacle_motions.h"

#include <algorithm>
#include <utility>

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
  void ObstacleMotions<dim>::add(ContactPair<dim>          &contact_pair,
                                 const Parameters::Contact &parameters)
  {
    contact_pair.first_motion = free.size();
    const auto add            = [&](const std::string &name,
                         const std::string &history,
                         const std::string &entry) {
      auto motion          = std::make_unique<FreeMotion>();
      motion->name         = name;
      motion->contact_pair = interface.pairs.size();
      motion->force_at =
        parse_history(history, parameters.section() + "/" + entry);
      free.push_back(motion.get());
      contact_pair.free_motions.push_back(std::move(motion));
    };
    for (const auto &[name, history] : parameters.obstacle_force)
      add(name, history, "Obstacle force");
    if (!parameters.obstacle_moment.empty())
      {
        add("angle", parameters.obstacle_moment, "Obstacle moment");
        free.back()->rotates = true;
        double &lever        = free.back()->lever;
        lever                = 0;
        for (const SurfaceNode<dim> &node : contact_pair.slave.nodes)
          lever =
            std::max(lever, node.X.distance(contact_pair.obstacle->centre()));
      }
    if (!parameters.preload.empty())
      {
        add("shortening", parameters.preload, "Preload");
        free.back()->end = parameters.preload_end;
      }
  }



  template<int dim>
  bool ObstacleMotions<dim>::move(const double         from,
                                  const double         to,
                                  const GhostedVector &start)
  {
    for (FreeMotion *motion : free)
      {
        const bool stayed = motion->stays;
        motion->force     = motion->force_at(Point<1>(to));
        motion->stays     = from >= motion->end;
        equations_changed = equations_changed || motion->stays != stayed;
      }
    const auto at_start = values(start);
    bool       moves    = equations_changed;
    for (const auto &contact_pair : interface.pairs)
      {
        if (contact_pair->obstacle &&
            contact_pair->obstacle->move(from,
                                         to,
                                         part(at_start, *contact_pair)))
          {
            ++interface.discretization.counters.obstacle_moves;
            moves = true;
          }
        if (auto &interference = *contact_pair->interference; interference.at)
          {
            ++interface.discretization.counters.interferences;
            interference.now = interference.at(Point<1>(to));
          }
      }
    moving = moves && from != to;
    return moves;
  }



  template<int dim>
  void ObstacleMotions<dim>::place(const GhostedVector &solution,
                                   const bool           keeps_place)
  {
    if (free.empty() ||
        solution.size() <= interface.discretization.dof_handler.n_dofs())
      return;
    const auto now = values(solution);
    for (const auto &contact_pair : interface.pairs)
      if (contact_pair->obstacle)
        contact_pair->obstacle->place(part(now, *contact_pair), keeps_place);
  }



  template<int dim>
  bool ObstacleMotions<dim>::place_for_pairing(const GhostedVector &solution)
  {
    place(solution, /*keeps_place=*/false);
    return std::exchange(equations_changed, false);
  }



  template<int dim>
  types::global_dof_index
  ObstacleMotions<dim>::index(const unsigned int motion) const
  {
    return interface.discretization.dof_handler.n_dofs() +
           interface.n_multipliers() - free.size() + motion;
  }



  template<int dim>
  double ObstacleMotions<dim>::value(const ContactPoint<dim> &point,
                                     const unsigned int       number,
                                     const GhostedVector     &solution) const
  {
    return solution.size() > interface.discretization.dof_handler.n_dofs()
             ? solution[index(interface.contact_pair(point).first_motion +
                              number)]
             : point.motions[number].paired;
  }



  template<int dim>
  std::vector<double>
  ObstacleMotions<dim>::values(const GhostedVector &solution) const
  {
    std::vector<double> values(free.size());
    if (solution.size() > interface.discretization.dof_handler.n_dofs())
      for (unsigned int k = 0; k < values.size(); ++k)
        values[k] = solution[index(k)];
    return values;
  }



  template<int dim>
  std::vector<double>
  ObstacleMotions<dim>::forces(const GhostedVector &solution,
                               const GhostedVector &u_start,
                               const bool           of_multipliers) const
  {
    std::vector<double> forces(free.size());
    for (const ContactPoint<dim> &point : interface.points())
      if (!point.motions.empty())
        {
          const ContactState<dim> now =
            interface.state(point, solution, u_start);
          Traction<dim> t = interface.active_set.traction(point, now);
          if (of_multipliers)
            {
              t.p = now.lambda_n;
              t.q = now.lambda_t;
            }
          double w = 0;
          for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
            w += point.weight * point.C[a];
          for (unsigned int k = 0; k < point.motions.size(); ++k)
            forces[interface.contact_pair(point).first_motion + k] +=
              w * (t.p * point.normal + point.along_tangents(t.q)) *
              point.motions[k].way;
        }
    return forces;
  }



  template<int dim>
  void ObstacleMotions<dim>::check_rotations() const
  {
    const unsigned int degrees = dim == 2 ? 90 : 20;
    for (const auto &contact_pair : interface.pairs)
      if (contact_pair->obstacle &&
          contact_pair->obstacle->motion().rotation.norm() >
            numbers::PI / 180 * degrees)
        throw NotConverged("an obstacle turns by more than " +
                           std::to_string(degrees) +
                           " degrees within the increment");
  }



  template<int dim>
  double ObstacleMotions<dim>::spring(const FreeMotion &motion) const
  {
    const ContactPair<dim> &of       = *interface.pairs[motion.contact_pair];
    double                  stiffest = 0;
    for (const ContactPoint<dim> &point : of.points_among(interface.points()))
      stiffest =
        std::max(stiffest, of.stiffness(point) * std::abs(point.weight));
    return 1e-10 * stiffest * motion.lever * motion.lever;
  }



  template<int dim>
  void ObstacleMotions<dim>::check(const FreeMotion &motion,
                                   const double      way,
                                   const double      missing) const
  {
    if (spring(motion) * std::abs(way) > 0.1 * missing * motion.lever)
      throw NotConverged(
        "nothing resists the motion '" + motion.name +
        "' of the obstacle of '" +
        interface.pairs[motion.contact_pair]->section() +
        "' under its force or moment: the obstacle touches too "
        "little, or the body gives way; give this motion, or a "
        "force that presses");
  }

  template class ObstacleMotions<2>;
  template class ObstacleMotions<3>;
} // namespace Contact
