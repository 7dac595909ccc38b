/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Discretization on where supports are at a load factor.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "solid/discretization.h"

namespace Contact
{
  template<int dim>
  SupportMotion<dim>
  Discretization<dim>::motion_of_supports(const double load_factor) const
  {
    SupportMotion<dim> motion{{}, load_factor, formulas};
    for (unsigned int c = 0; c < dim; ++c)
      motion.factors[c] =
        factor(std::string("Displacement ") + "xyz"[c], load_factor);
    motion.factors[dim] = factor("Displacement normal", load_factor);
    return motion;
  }



  // A hanging unknown follows others, with their round-off.
  template<int dim>
  void Discretization<dim>::for_supported(
    const GhostedVector                         &u,
    const SupportMotion<dim>                    &motion,
    const std::function<void(const types::global_dof_index dof,
                             const double                  way)> &visit) const
  {
    const double few = 16 * std::numeric_limits<double>::epsilon();
    for (const auto &[dof, displacement] : prescribed)
      if (u.holds(dof))
        {
          const double value = displacement.at(motion);
          const double way   = value - u[dof];
          visit(dof, std::abs(way) > few * std::abs(value) ? way : 0.);
        }
    for (const auto &line : normal_supports.lines())
      if (u.holds(line.pivot))
        visit(line.pivot, line.motion(u, motion));
  }



  template<int dim>
  void Discretization<dim>::constrain_update(const GhostedVector &u,
                                             const double         load_factor)
  {
    std::map<types::global_dof_index, double> updates;
    bool                                      vanish = true;
    const auto motion    = motion_of_supports(load_factor);
    largest_displacement = normal_supports.largest(motion);
    for (const auto &of_dof : prescribed)
      largest_displacement =
        std::max(largest_displacement, std::abs(of_dof.second.at(motion)));
    for_supported(u,
                  motion,
                  [&](const types::global_dof_index dof, const double way) {
                    updates[dof] = way;
                    vanish       = vanish && way == 0;
                  });
    bool is_fixed = true;
    if (!rigid.empty())
      {
        present_load_factor = load_factor;
        update_rigid_leaders(u, load_factor);
        counters.rigid_updates += rigid.size();
        followers_of_rigid = rigid_lines(u, load_factor);
        for (const auto &line : followers_of_rigid)
          vanish = vanish && line.inhomogeneity == 0;
        for (const RigidBoundary<dim> &boundary : rigid)
          {
            const auto targets = this->targets(boundary, load_factor);
            for (unsigned int k = 0; k < 6; ++k)
              largest_displacement =
                std::max(largest_displacement,
                         std::abs(targets.value[k]) *
                           (k < 3 ? 1. : boundary.extent()));
            is_fixed = is_fixed && !boundary.is_large;
          }
      }
    vanish =
      Utilities::MPI::min(static_cast<unsigned int>(vanish), communicator) > 0;

    if (!(vanish && updates_vanish && is_fixed))
      make_constraints(updates);
    updates_vanish = vanish;
  }



  template<int dim>
  void Discretization<dim>::prescribe(GhostedVector &u,
                                      const double   load_factor)
  {
    constrain_update(u, load_factor);
    if (updates_vanish)
      return;
    GhostedVector move(distribution);
    this->distribute(constraints, move);
    std::transform(move.begin(),
                   move.end(),
                   u.begin(),
                   u.begin(),
                   std::plus<>());

    // To the last digit.
    const auto motion = motion_of_supports(load_factor);
    for (const auto &[dof, displacement] : prescribed)
      if (u.holds(dof))
        u[dof] = displacement.at(motion);
    for (const auto &line : normal_supports.lines())
      if (u.holds(line.pivot))
        u[line.pivot] += line.motion(u, motion);
    for (const auto &line : rigid_lines(u, load_factor))
      u[line.dof] += line.inhomogeneity;
    constrain_update(u, load_factor);
  }



  template<int dim>
  GhostedVector
  Discretization<dim>::support_motion(const GhostedVector &u,
                                      const double         load_factor) const
  {
    GhostedVector motion(distribution);
    for_supported(u,
                  motion_of_supports(load_factor),
                  [&](const types::global_dof_index dof, const double way) {
                    motion[dof] = way;
                  });
    for (const auto &line : rigid_lines(u, load_factor))
      motion[line.dof] = line.inhomogeneity;
    return motion;
  }



  template<int dim>
  double
  Discretization<dim>::distance_from_supports(const GhostedVector &u,
                                              const double load_factor) const
  {
    return support_motion(u, load_factor).linfty_norm();
  }



  template<int dim>
  bool Discretization<dim>::is_fixed(const types::global_dof_index dof) const
  {
    // All that is prescribed is constrained, which is faster to see.
    return constraints.is_constrained(dof) && prescribed.count(dof) > 0;
  }



  template<int dim>
  bool Discretization<dim>::is_moved(const types::global_dof_index dof) const
  {
    if (!constraints.is_constrained(dof))
      return false;
    if (is_rigid(dof))
      return true;
    if (const auto *line = normal_supports.line(dof))
      return line->prescribed.is_moved();
    const auto value = prescribed.find(dof);
    return value != prescribed.end() && value->second.is_moved();
  }



  template<int dim>
  Tensor<1, dim>
  Discretization<dim>::free_part(const NodeDoFs<dim>  &node,
                                 const Tensor<1, dim> &vector) const
  {
    Tensor<1, dim> free = DiscretizedBodies<dim>::free_part(node, vector);
    normal_supports.make_free(node, free);
    return free;
  }



  template<int dim>
  bool
  Discretization<dim>::are_held_alike(const NodeDoFs<dim>  &a,
                                      const NodeDoFs<dim>  &b,
                                      const Tensor<1, dim> &direction) const
  {
    return DiscretizedBodies<dim>::are_held_alike(a, b, direction) ||
           normal_supports.hold_alike(a, b, direction);
  }



  template<int dim>
  bool Discretization<dim>::is_tied(const types::global_dof_index dof) const
  {
    return ties.count(dof) > 0 || leaders.count(dof) > 0 || is_rigid(dof);
  }

  template class Discretization<2>;
  template class Discretization<3>;
} // namespace Contact
