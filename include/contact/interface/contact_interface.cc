/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/contact_interface.h"

#include <algorithm>
#include <limits>

#include "contact/surfaces/surface_checks.h"

namespace Contact
{
  namespace
  {
    /// Tell contact pairs the surfaces of others on the same bodies, and the
    /// boundaries of these.
    template<int dim>
    void find_bodies(const std::vector<ContactPair<dim> *> &of_pairs)
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
                std::none_of(there.begin(),
                             there.end(),
                             [&](const auto *other) {
                               return overlap(*surface, *other);
                             }))
              there.push_back(surface);
      std::map<unsigned int, std::shared_ptr<const Surface<dim>>> boundaries;
      for (ContactPair<dim> *const contact_pair : of_pairs)
        if (contact_pair->master)
          {
            const std::array<unsigned int, 2> parts{
              {part(contact_pair->slave), part(*contact_pair->master)}};
            for (const unsigned int k : {0, 1})
              {
                contact_pair->surfaces_of_bodies[k] = of_part[parts[k]];
                if (contact_pair->tied || parts[0] == parts[1])
                  continue;
                auto &boundary = boundaries[parts[k]];
                if (!boundary)
                  boundary = std::make_shared<const Surface<dim>>(
                    contact_pair->discretization,
                    parts[k]);
                contact_pair->boundaries[k] = boundary;
              }
          }
    }
  } // namespace



  template<int dim>
  ContactInterface<dim>::ContactInterface(
    const DiscretizedBodies<dim>           &discretization,
    const BodyStiffness                    &elasticity,
    const std::vector<Parameters::Contact> &parameters)
    : discretization(discretization)
    , motions(*this)
    , bounds(*this, all_points)
    , active_set(*this, all_points)
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
        motions.add(*contact_pair, of_pair);
        made.push_back(contact_pair.get());
        pairs.push_back(std::move(contact_pair));
      }
    frames = PointFrames<dim>(all_points, pairs);
    frames.find_other_sides(all_points, made);
    find_bodies(made);
  }



  template<int dim>
  std::vector<ContactPoint<dim>>
  ContactInterface<dim>::paired_anew(const GhostedVector &u) const
  {
    std::vector<ContactPoint<dim>> points = all_points;
    frames.part(points);
    for (const auto &contact_pair : pairs)
      if (!contact_pair->tied)
        contact_pair->pair(contact_pair->points_among(points), u, {});
    frames.join(points, u);
    return points;
  }



  template<int dim>
  std::vector<ContactPoint<dim>> ContactInterface<dim>::acting_points(
    const ContactPair<dim> &contact_pair) const
  {
    std::vector<ContactPoint<dim>> points;
    const auto n = contact_pair.points_of_slave(all_points).size();
    for (unsigned int q = 0; q < n; ++q)
      points.push_back(
        frames.as_it_acts(all_points, contact_pair.first_point + q));
    return points;
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
    paired_undeformed  = u.all_zero();
    bool       changed = motions.place_for_pairing(u);
    const auto joined  = frames.part(all_points);
    for (const auto &contact_pair : pairs)
      changed =
        contact_pair->pair(contact_pair->points_among(all_points), u, mode) ||
        changed;
    changed = frames.join(all_points, u) != joined || changed;
    return changed;
  }



  // The normals are those of the last pairing: before obstacles turn.
  template<int dim>
  void ContactInterface<dim>::begin_increment(const double         from,
                                              const GhostedVector &solution)
  {
    find_edges(solution);
    set_shear_at_start(solution, solution);
    for (ContactPoint<dim> &point : all_points)
      {
        const auto &interference    = *contact_pair(point).interference;
        point.interference_at_start = Tensor<1, dim>();
        if (interference.at)
          point.interference_at_start =
            interference.at(Point<1>(from)) * point.normal;
      }
  }



  // Springs have the stiffness E/h, whatever the parameters say of c.
  template<int dim>
  void ContactInterface<dim>::find_edges(const GhostedVector &u_start)
  {
    const double      near = 0.1; // of an edge of the slave
    std::vector<bool> touches;
    for (const ContactPoint<dim> &point : all_points)
      touches.push_back(point.facing && !contact_pair(point).tied &&
                        state(point, u_start, u_start).gap <=
                          near * contact_pair(point).edge_length(point));
    frames.find_edges(all_points, touches);
    for (ContactPoint<dim> &point : all_points)
      if (const ContactPair<dim> &of = contact_pair(point);
          of.has_point_per_multiplier())
        {
          const bool has_springs =
            point.is_in_an_edge || !point.dirichlet_edges.empty();
          point.augmentation_parameter =
            (has_springs ? 1 : of.augmentation_parameter) * of.stiffness(point);
        }
  }



  template<int dim>
  std::vector<signed char> ContactInterface<dim>::signature() const
  {
    std::vector<signed char> all = active_set.signature();
    for (const ContactPoint<dim> &point : all_points)
      all.push_back(point.is_in_an_edge);
    return all;
  }



  template<int dim>
  void ContactInterface<dim>::set_shear_at_start(const GhostedVector &solution,
                                                 const GhostedVector &u_start)
  {
    for (ContactPoint<dim> &point : all_points)
      {
        point.shear_at_start = Tensor<1, dim - 1>();
        const auto now       = state(point, solution, u_start);
        // The slip has lambda/c along the springs.
        point.shear_at_start =
          point.augmentation_parameter * point.stick_compliance() * now.slip;
        if (point.elastic_slip > 0)
          {
            const double shear   = now.lambda_t.norm();
            point.share_at_start = Tensor<1, dim - 1>();
            if (shear > 0)
              point.share_at_start =
                now.lambda_t /
                std::max(shear, contact_pair(point).law.bound(now.lambda_n));
            if (&u_start != &solution)
              point.share_at_start += now.slip / point.elastic_slip;
          }
      }
  }



  template<int dim>
  void
  ContactInterface<dim>::pair_and_begin_increment(const double         from,
                                                  const GhostedVector &start)
  {
    if (!has_pair([](const auto &of) { return bool(of.interference->at); }))
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
              for (const ContactPoint<dim> &point :
                   contact_pair->points_among(all_points))
                if (point.facing)
                  interference.at_start =
                    std::max(interference.at_start,
                             -state(point, start, start).gap);
            }
          interference.initial_clearance = (1 - to) * interference.at_start;
          for (ContactPoint<dim> &point :
               contact_pair->points_among(all_points))
            point.interference_at_start -=
              (1 - from) * interference.at_start * point.normal;
        }
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
    for (unsigned int k = 0; k < motions.free.size(); ++k)
      change =
        std::max(change,
                 motions.free[k]->lever *
                   std::abs(u[motions.index(k)] - from[motions.index(k)]));
    return change;
  }



  template<int dim>
  typename ContactInterface<dim>::ElasticShear
  ContactInterface<dim>::elastic_shear(const ContactPoint<dim> &point,
                                       const ContactState<dim> &now) const
  {
    const double bound   = bounds.law(point).bound(now.p_trial);
    const double of_unit = point.augmentation_parameter * point.elastic_slip;
    return {bound,
            bound / point.elastic_slip,
            bound > of_unit ? of_unit / bound : 1.,
            point.share_at_start - now.slip / point.elastic_slip};
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
          (motions.value(point, k, solution) - at.paired) * at.way;
        dr -= way;
        for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
          r -= point.C[a] * way;
      }
    state.gap = point.normal * r;
    if (const double overlap = contact_pair(point).interference->added())
      for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
        state.gap -= overlap * point.C[a];
    state.slip =
      point.without(point.tangents_held_by_supports, point.tangential_part(dr));
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
    state.p_trial = state.lambda_n - point.augmentation_parameter * state.gap;
    // Under a pressure that is not known yet points stick.
    const FrictionLaw law =
      point.elastic_slip > 0 ? bounds.law(point) : FrictionLaw();
    state.is_elastic = point.elastic_slip > 0 && state.lambda_n > 0 &&
                       law.tresca_limit < std::numeric_limits<double>::max();
    if (state.is_elastic)
      {
        const ElasticShear elastic = elastic_shear(point, state);
        state.q_trial              = (1 - elastic.kappa) * state.lambda_t +
                        elastic.kappa * elastic.bound * elastic.zeta;
        return state;
      }
    if (const Tensor<2, dim - 1> compliance = point.stick_compliance();
        compliance.norm() > 0)
      state.slip += compliance * (state.lambda_t - point.shear_at_start) /
                    point.augmentation_parameter;
    state.q_trial = state.lambda_t - point.augmentation_parameter * state.slip;
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
    for (unsigned int k = 0; k < motions.free.size(); ++k)
      square += std::pow(rhs[motions.index(k)] / motions.free[k]->lever, 2);
    return std::sqrt(square);
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
      if (!motions.free[first + k]->stays)
        unknowns.push_back(motions.index(first + k));
    std::vector<types::global_dof_index> own(unknowns.begin(),
                                             unknowns.begin() +
                                               dim * point.n_nodes);
    std::sort(own.begin(), own.end());
    const std::size_t n = unknowns.size();
    for (const auto dof : point.change.dofs)
      if (!std::binary_search(own.begin(), own.end(), dof))
        unknowns.push_back(dof);
    // A node may be on both sides of a surface in contact with itself.
    if (contact_pair(point).itself)
      {
        std::sort(unknowns.begin() + n, unknowns.end());
        unknowns.erase(std::unique(unknowns.begin() + n, unknowns.end()),
                       unknowns.end());
      }
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
