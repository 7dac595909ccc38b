/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/contact_interface.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>

#include "base/dimension.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "contact/surfaces/surface_checks.h"

namespace Contact
{
  template<int dim>
  ContactInterface<dim>::ContactInterface(
    const Discretization<dim>              &discretization,
    const Elasticity<dim>                  &elasticity,
    const std::vector<Parameters::Contact> &parameters)
    : discretization(discretization)
  {
    std::vector<ContactPair<dim> *> made;
    for (const Parameters::Contact &of_pair : parameters)
      {
        auto contact_pair = std::make_unique<ContactPair<dim>>(discretization,
                                                               elasticity,
                                                               of_pair);
        const unsigned int first = tangential_number.size();
        for (ContactPoint<dim> &point :
             contact_pair->make_points(first, all_points.size()))
          {
            point.contact_pair = pairs.size();
            all_points.push_back(std::move(point));
          }
        for (unsigned int k = 0; k < contact_pair->multipliers.n_multipliers;
             ++k)
          tangential_number.push_back(contact_pair->law.is_frictionless()
                                        ? numbers::invalid_unsigned_int
                                        : n_tangential++);
        make_free_motions(*contact_pair, of_pair);
        made.push_back(contact_pair.get());
        pairs.push_back(std::move(contact_pair));
      }
    own = Utilities::MPI::create_evenly_distributed_partitioning(
      discretization.communicator,
      all_points.size());
    frames = PointFrames<dim>(all_points, pairs);
    frames.find_other_sides(all_points, made);
    find_bodies(made);
  }



  template<int dim>
  void ContactInterface<dim>::find_bodies(
    const std::vector<ContactPair<dim> *> &of_pairs) const
  {
    const auto part = [](const Surface<dim> &surface) {
      return surface.facets[0].part;
    };
    std::map<unsigned int, std::vector<const Surface<dim> *>> of_part;
    for (const ContactPair<dim> *const contact_pair : of_pairs)
      if (contact_pair->master)
        for (const Surface<dim> *surface :
             {&contact_pair->slave, &*contact_pair->master})
          if (auto &there = of_part[part(*surface)];
              std::none_of(there.begin(), there.end(), [&](const auto *other) {
                return overlap(*surface, *other);
              }))
            there.push_back(surface);
    for (ContactPair<dim> *const contact_pair : of_pairs)
      if (contact_pair->master)
        contact_pair->surfaces_of_bodies = {
          {of_part[part(contact_pair->slave)],
           of_part[part(*contact_pair->master)]}};
  }



  // Two pairs of the same surfaces would share their force as they like, also
  // with slave and master swapped.
  template<int dim>
  void ContactInterface<dim>::check_pairs(
    const std::vector<Parameters::Contact> &parameters) const
  {
    const auto same_master = [&](const unsigned int i, const unsigned int j) {
      if (!pairs[i]->master || !pairs[j]->master)
        return !pairs[i]->master && !pairs[j]->master &&
               parameters[i].obstacle == parameters[j].obstacle;
      return overlap(*pairs[i]->master, *pairs[j]->master);
    };
    for (unsigned int j = 0; j < pairs.size(); ++j)
      for (unsigned int i = 0; i < j; ++i)
        {
          const std::string parts = Dimension<dim>::boundary + std::string("s");
          const bool both_have_masters = pairs[i]->master && pairs[j]->master;
          const bool is_same =
            overlap(pairs[i]->slave, pairs[j]->slave) && same_master(i, j);
          const bool is_swapped = both_have_masters &&
                                  overlap(pairs[i]->slave, *pairs[j]->master) &&
                                  overlap(*pairs[i]->master, pairs[j]->slave);
          if (is_same || is_swapped)
            throw InputError("two contact pairs have the same " + parts +
                               " as slave and master" +
                               (is_swapped ? ", swapped" : "") +
                               ": how they share the force is not determined",
                             "'" + parameters[i].section() + "' and '" +
                               parameters[j].section() + "'",
                             "remove one of them, or take the common " + parts +
                               " out of one");
        }
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (pairs[i]->obstacle && !pairs[i]->tied) // glue has no sides
        check_side(*pairs[i], parameters[i]);
  }



  // An obstacle whose normal points the other way would pull the slave.
  template<int dim>
  void
  ContactInterface<dim>::check_side(const ContactPair<dim>    &contact_pair,
                                    const Parameters::Contact &parameters) const
  {
    const Surface<dim> &slave   = contact_pair.slave;
    const auto          normals = DeformedSurface<dim>(slave, {}).normals();
    double              depth   = 0;
    Point<dim>          deepest;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      {
        const Point<dim> X       = slave.nodes[i].X;
        const auto       closest = contact_pair.obstacle->closest_point(X);
        if (normals[i] * closest.normal < 0)
          return;
        if ((closest.x - X) * closest.normal > depth)
          {
            depth   = (closest.x - X) * closest.normal;
            deepest = X;
          }
      }
    const double digits = 1e-6; // of a mesh file, by the length of an edge
    if (depth > digits * slave.reference_length(0))
      throw InputError("the slave '" + parameters.slave +
                         "' is inside of its obstacle, " + brief(depth) +
                         " mm deep at (" + brief(deepest) +
                         ") mm, and no node of it faces the obstacle",
                       parameters.section() + "/Obstacle",
                       "turn the obstacle's normal round: of a plane its last "
                       "numbers, of a circle the sign of the radius, of a "
                       "profile the order of its points; or correct the slave");
  }



  template<int dim>
  ArrayView<const ContactPoint<dim>>
  ContactInterface<dim>::points_of(const ContactPair<dim> &contact_pair) const
  {
    return {all_points.data() + contact_pair.first_point,
            contact_pair.n_points};
  }



  template<int dim>
  std::vector<ContactPoint<dim>>
  ContactInterface<dim>::paired_anew(const GhostedVector &u) const
  {
    std::vector<ContactPoint<dim>> points = all_points;
    frames.part(points);
    for (const auto &contact_pair : pairs)
      if (!contact_pair->tied)
        contact_pair->pair({points.data() + contact_pair->first_point,
                            contact_pair->n_points},
                           u,
                           {});
    frames.join(points, u);
    return points;
  }



  template<int dim>
  std::vector<ContactPoint<dim>> ContactInterface<dim>::acting_points(
    const ContactPair<dim> &contact_pair) const
  {
    std::vector<ContactPoint<dim>> points;
    for (unsigned int q = 0; q < points_of_slave(contact_pair).size(); ++q)
      points.push_back(
        frames.as_it_acts(all_points, contact_pair.first_point + q));
    return points;
  }



  template<int dim>
  unsigned int
  ContactInterface<dim>::acting_multiplier(const unsigned int k) const
  {
    return frames.acting_multiplier(all_points, k);
  }



  template<int dim>
  bool ContactInterface<dim>::is_tied() const
  {
    return std::all_of(pairs.begin(),
                       pairs.end(),
                       [](const auto &contact_pair) {
                         return contact_pair->tied;
                       });
  }



  template<int dim>
  bool ContactInterface<dim>::has_friction() const
  {
    return std::any_of(pairs.begin(),
                       pairs.end(),
                       [](const auto &contact_pair) {
                         return !contact_pair->tied &&
                                !contact_pair->law.is_frictionless();
                       });
  }



  template<int dim>
  bool ContactInterface<dim>::has_coulomb_friction() const
  {
    return std::any_of(pairs.begin(),
                       pairs.end(),
                       [](const auto &contact_pair) {
                         return !contact_pair->tied &&
                                contact_pair->law.coulomb_coefficient > 0;
                       });
  }



  template<int dim>
  unsigned int ContactInterface<dim>::n_multipliers() const
  {
    return n_normal_multipliers() + (dim - 1) * n_tangential +
           all_motions.size();
  }



  template<int dim>
  unsigned int ContactInterface<dim>::n_normal_multipliers() const
  {
    return tangential_number.size();
  }



  template<int dim>
  types::global_dof_index
  ContactInterface<dim>::normal_index(const unsigned int k) const
  {
    return discretization.dof_handler.n_dofs() + k;
  }



  template<int dim>
  types::global_dof_index
  ContactInterface<dim>::tangential_index(const unsigned int k,
                                          const unsigned int tangent) const
  {
    return normal_index(n_normal_multipliers() +
                        (dim - 1) * tangential_number[k] + tangent);
  }



  template<int dim>
  double ContactInterface<dim>::pressure(
    const std::vector<std::pair<unsigned int, double>> &multipliers,
    const GhostedVector                                &solution) const
  {
    double sum = 0;
    for (const auto &[k, factor] : multipliers)
      sum += factor * solution[normal_index(acting_multiplier(k))];
    // A continued pressure may not pull.
    return multipliers.size() > 1 ? std::max(0., sum) : sum;
  }



  template<int dim>
  bool ContactInterface<dim>::pair(const GhostedVector &u,
                                   const PairingMode   &mode)
  {
    paired_undeformed = u.all_zero();
    bool changed      = equations_changed;
    equations_changed = false;
    place_obstacles(u, /*keeps_place=*/false);
    const auto joined = frames.part(all_points);
    for (const auto &contact_pair : pairs)
      changed =
        contact_pair->pair({all_points.data() + contact_pair->first_point,
                            contact_pair->n_points},
                           u,
                           mode) ||
        changed;
    changed = frames.join(all_points, u) != joined || changed;
    find_held_slips();
    return changed;
  }



  template<int dim>
  double ContactInterface<dim>::largest_turn() const
  {
    double largest = 0;
    for (const auto &contact_pair : pairs)
      if (contact_pair->obstacle)
        largest =
          std::max(largest, contact_pair->obstacle->motion().turn.norm());
    return largest;
  }



  template<int dim>
  double ContactInterface<dim>::largest_change(const GhostedVector &u,
                                               const GhostedVector &from) const
  {
    double     change = 0;
    const auto look   = [&](const Surface<dim> &surface) {
      for (const SurfaceNode<dim> &node : surface.nodes)
        for (const auto dof : node.dofs)
          change = std::max(change, std::abs(u[dof] - from[dof]));
    };
    for (const auto &contact_pair : pairs)
      {
        look(contact_pair->slave);
        if (contact_pair->master)
          look(*contact_pair->master);
      }
    for (unsigned int k = 0; k < all_motions.size(); ++k)
      change = std::max(change,
                        all_motions[k]->lever *
                          std::abs(u[motion_index(k)] - from[motion_index(k)]));
    return change;
  }



  template<int dim>
  ContactState<dim>
  ContactInterface<dim>::state(const ContactPoint<dim> &point,
                               const GhostedVector     &solution,
                               const GhostedVector     &u_start) const
  {
    const bool     tied = contact_pair(point).tied;
    Tensor<1, dim> r,
      dr = point.interference_at_start - point.projection_motion;
    if (!tied)
      r -= point.projection;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const double u = solution[point.dofs(a)[i]];
          r[i] += point.C[a] * (tied ? u : point.X(a)[i] + u);
          dr[i] += point.C[a] * (u - u_start[point.dofs(a)[i]]);
        }

    ContactState<dim> state{};
    for (unsigned int k = 0; k < point.motions.size(); ++k)
      {
        const MotionAt<dim> &at = point.motions[k];
        const Tensor<1, dim> way =
          (motion(point, k, solution) - at.paired) * at.way;
        dr -= way;
        for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
          r -= point.C[a] * way;
      }
    state.gap = point.normal * r;
    if (const double overlap = contact_pair(point).interference->added())
      for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
        state.gap -= overlap * point.C[a];
    state.slip = point.without(point.tangents_held_by_points,
                               point.without(point.tangents_held_by_supports,
                                             point.tangential_part(dr)));
    // Without multipliers in the vector the question is for the gap alone.
    if (solution.size() > discretization.dof_handler.n_dofs())
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        {
          state.lambda_n +=
            point.psi[k] * solution[normal_index(point.multipliers[k])];
          if (has_friction(point))
            for (unsigned int t = 0; t < dim - 1; ++t)
              state.lambda_t[t] +=
                point.psi[k] *
                solution[tangential_index(point.multipliers[k], t)];
        }
    if (point.stick_compliance.norm() > 0)
      state.slip += point.stick_compliance *
                    (state.lambda_t - point.shear_at_start) /
                    point.augmentation_parameter;
    state.p_trial = state.lambda_n - point.augmentation_parameter * state.gap;
    state.q_trial =
      point.without(point.tangents_held_by_points,
                    state.lambda_t - point.augmentation_parameter * state.slip);
    return state;
  }



  template<int dim>
  double ContactInterface<dim>::constraint_norm(const GhostedVector &rhs) const
  {
    // Every multiplier has a point of its own surroundings: the last one wins.
    std::vector<double> stiffness(n_normal_multipliers(), 0.);
    for (const ContactPoint<dim> &point : all_points)
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        stiffness[point.multipliers[k]] = contact_pair(point).stiffness(point);

    double square = 0;
    for (unsigned int k = 0; k < stiffness.size(); ++k)
      {
        square += std::pow(stiffness[k] * rhs[normal_index(k)], 2);
        if (tangential_number[k] != numbers::invalid_unsigned_int)
          for (unsigned int t = 0; t < dim - 1; ++t)
            square += std::pow(stiffness[k] * rhs[tangential_index(k, t)], 2);
      }
    for (unsigned int k = 0; k < all_motions.size(); ++k)
      square += std::pow(rhs[motion_index(k)] / all_motions[k]->lever, 2);
    return std::sqrt(square);
  }



  template<int dim>
  void ContactInterface<dim>::clear_changes()
  {
    for (ContactPoint<dim> &point : all_points)
      point.change = PairingChange<dim>();
  }



  template<int dim>
  std::vector<types::global_dof_index>
  ContactInterface<dim>::unknowns_of(const ContactPoint<dim> &point) const
  {
    std::vector<types::global_dof_index> unknowns;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (const auto dof : point.dofs(a))
        unknowns.push_back(dof);
    for (unsigned int k = 0; k < point.n_multipliers; ++k)
      unknowns.push_back(normal_index(point.multipliers[k]));
    if (has_friction(point))
      for (unsigned int t = 0; t < dim - 1; ++t)
        for (unsigned int k = 0; k < point.n_multipliers; ++k)
          unknowns.push_back(tangential_index(point.multipliers[k], t));
    const unsigned int first = contact_pair(point).first_motion;
    for (unsigned int k = 0; k < point.motions.size(); ++k)
      if (!all_motions[first + k]->stays)
        unknowns.push_back(motion_index(first + k));
    std::vector<types::global_dof_index> own(unknowns.begin(),
                                             unknowns.begin() +
                                               dim * point.n_nodes);
    std::sort(own.begin(), own.end());
    for (const auto dof : point.change.dofs)
      if (!std::binary_search(own.begin(), own.end(), dof))
        unknowns.push_back(dof);
    return unknowns;
  }



  template<int dim>
  void
  ContactInterface<dim>::add_couplings(DynamicSparsityPattern &pattern) const
  {
    for (const ContactPoint<dim> &point : all_points)
      discretization.constraints.add_entries_local_to_global(
        unknowns_of(point),
        pattern,
        /*keep_constrained_entries=*/false);
  }

  template class ContactInterface<2>;
  template class ContactInterface<3>;
} // namespace Contact
