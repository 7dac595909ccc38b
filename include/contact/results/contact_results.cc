/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "contact/points/corner_points.h"
#include "contact/results/contact_patches.h"

namespace Contact
{
  namespace
  {
    /// Add the force of a point. Returns its traction, which at a corner of the
    /// master depends on the mesh size.
    template<int dim>
    Traction<dim> add_force(const ContactInterface<dim> &interface,
                            const ContactPoint<dim>     &point,
                            const ContactState<dim>     &now,
                            ContactResults              &results)
    {
      const Traction<dim> traction = interface.active_set.traction(point, now);
      results.normal_force += point.weight * traction.p;
      results.tangential_force += point.weight * traction.q[0];
      return traction;
    }



    /// Corners and ends of the master that are opposite to the slave, and no
    /// further from it than an edge is long.
    void add_corners_of_master(const ContactPair<2>          &contact_pair,
                               const GhostedVector           &u,
                               std::array<ContactPatches, 2> &of_lengths)
    {
      const DeformedSurface<2> slave(contact_pair.slave, u),
        master(*contact_pair.master, u);
      auto corners = make_corner_points(master.surface);
      pair_corner_points(make_array_view(corners.begin(), corners.end()),
                         master,
                         slave,
                         {contact_pair.surfaces_of_bodies, u},
                         contact_pair.discretization,
                         u);
      for (const ContactPoint<2> &corner : corners)
        {
          const SurfaceFacet<2> &edge =
            master.surface.facets[corner.slave_facet];
          if (corner.facing &&
              distance(corner, u) <
                contact_pair.slave.reference_length(corner.master_facet))
            for (ContactPatches &patches : of_lengths)
              patches.add_corner(corner,
                                 edge.ends_surface(corner.slave_xi < 0 ? 0
                                                                       : 1));
        }
    }



    std::string name_of_slip(const PointStatus<2> &status)
    {
      return status.slip_direction > 0 ? "slips along -t" : "slips along +t";
    }

    std::string name_of_slip(const PointStatus<3> &)
    {
      return "slips";
    }



    /// A status in a message; a point that slips does so against its shear.
    template<int dim>
    std::string describe(const PointStatus<dim> &status)
    {
      if (status.kind == Status::open)
        return "open";
      if (status.kind == Status::stick)
        return "sticks";
      return status.has_direction() ? name_of_slip(status) : "slips";
    }
  } // namespace



  template<>
  ContactResults contact_results(const ContactInterface<2> &interface,
                                 const ContactPair<2>      &contact_pair,
                                 const GhostedVector       &solution,
                                 const GhostedVector       &u_start)
  {
    const Surface<2>             &slave = contact_pair.slave;
    std::array<ContactPatches, 2> undeformed_and_deformed{
      {{slave, slave.positions({})}, {slave, slave.positions(solution)}}};
    ContactResults results;
    const auto     add_sample = [&](const ContactPoint<2> &point,
                                const PatchSample     &sample) {
      for (ContactPatches &patches : undeformed_and_deformed)
        patches.add(point, sample);
    };
    const auto add_point = [&](const ContactPoint<2> &point) {
      return add_force(interface,
                       point,
                       interface.state(point, solution, u_start),
                       results);
    };
    // With the weight of the node that it stands for.
    const auto sample_of = [&](const ContactPoint<2> &point,
                               const Traction<2>     &traction,
                               const ContactPoint<2> &at) {
      const double part    = point.weight / at.weight;
      results.max_pressure = std::max(results.max_pressure, part * traction.p);
      results.max_shear =
        std::max(results.max_shear, part * std::abs(traction.q[0]));
      return PatchSample{
        true,
        point.status.kind == Status::stick,
        point.has_no_free_tangent && !point.status.has_direction(),
        part * traction.p,
        std::abs(interface.state(point, solution, u_start).slip[0])};
    };

    // A corner of the master at a node of the slave stands for that.
    std::map<unsigned int, std::pair<const ContactPoint<2> *, Traction<2>>>
      at_node;
    for (const ContactPoint<2> &corner :
         contact_pair.corners_of_master(interface.points()))
      if (const Traction<2> traction = add_point(corner);
          corner.status.kind != Status::open)
        {
          results.max_pressure = std::max(results.max_pressure, traction.p);
          if (const unsigned int node =
                node_at_foot(corner, contact_pair.slave);
              node != numbers::invalid_unsigned_int)
            at_node[contact_pair.multipliers.of_node[node]] = {&corner,
                                                               traction};
        }

    for (const ContactPoint<2> &point : interface.acting_points(contact_pair))
      if (const auto corner = at_node.find(point.multipliers[0]);
          !point.facing && corner != at_node.end())
        add_sample(point,
                   sample_of(*corner->second.first,
                             corner->second.second,
                             point));
      else if (point.facing && point.status.kind != Status::open)
        add_sample(point, sample_of(point, add_point(point), point));
      // On an axis at degree 2 a force does no work on the rest, and round-off
      // opens a point: contact goes on to it.
      else if (contact_pair.slave.degree == 1 ||
               !contact_pair.discretization.is_on_axis(
                 contact_pair.place(point)))
        add_sample(point, {false, false, false, 0, 0});
    if (contact_pair.master)
      add_corners_of_master(contact_pair, solution, undeformed_and_deformed);
    results.extent          = undeformed_and_deformed[0].width();
    results.stick_extent    = undeformed_and_deformed[0].stick_width();
    results.deformed_extent = undeformed_and_deformed[1].width();
    return results;
  }



  template<>
  ContactResults contact_results(const ContactInterface<3> &interface,
                                 const ContactPair<3>      &contact_pair,
                                 const GhostedVector       &solution,
                                 const GhostedVector       &u_start)
  {
    ContactResults results;
    Tensor<1, 3>   shear;
    const auto     add_force = [&](const ContactPoint<3> &point) {
      const ContactState<3> now = interface.state(point, solution, u_start);
      const Traction<3>     t   = interface.active_set.traction(point, now);
      results.normal_force += point.weight * t.p;
      shear += point.weight * point.along_tangents(t.q);
      return t;
    };
    for (const ContactPoint<3> &point :
         contact_pair.corners_of_master(interface.points()))
      if (point.status.kind != Status::open)
        results.max_pressure =
          std::max(results.max_pressure, add_force(point).p);
    for (const ContactPoint<3> &point : interface.acting_points(contact_pair))
      {
        if (!point.facing || point.status.kind == Status::open)
          continue;
        const Traction<3> t  = add_force(point);
        results.max_pressure = std::max(results.max_pressure, t.p);
        results.max_shear    = std::max(results.max_shear, t.q.norm());
        results.extent += point.weight;
        results.deformed_extent +=
          point.weight * contact_pair.slave.stretch_at(point.slave_facet,
                                                       point.slave_xi,
                                                       solution);
        if (point.status.kind == Status::stick)
          results.stick_extent += point.weight;
      }
    results.tangential_force = shear.norm();
    return results;
  }



  template<int dim>
  unsigned int multiplier_at(const ContactInterface<dim> &interface,
                             const ContactPair<dim>      &contact_pair,
                             const unsigned int           node)
  {
    const unsigned int k = contact_pair.multipliers.of_node[node];
    return k == numbers::invalid_unsigned_int ? k
                                              : interface.acting_multiplier(k);
  }



  template<int dim>
  double pressure_at(const ContactInterface<dim> &interface,
                     const ContactPair<dim>      &contact_pair,
                     const unsigned int           node,
                     const GhostedVector         &solution)
  {
    return contact_pair.has_point_per_multiplier()
             ? interface.pressure(contact_pair.pressure_at(node), solution)
             : solution[interface.normal_index(
                 contact_pair.multipliers.of_node[node])];
  }



  namespace
  {
    template<int dim>
    double weight_of_node(const Surface<dim> &surface, const unsigned int node)
    {
      double weight = 0;
      for (const unsigned int e : surface.facets_of_node[node])
        for (unsigned int a = 0; a < surface.facets[e].n_nodes(); ++a)
          if (surface.facets[e].nodes[a] == node)
            weight += share_of_node(surface, e, a);
      return weight;
    }
  } // namespace



  // The multipliers of a solution are the tractions, which are the same seen
  // from either side.
  template<int dim>
  std::vector<Tensor<1, 2>>
  corner_tractions(const ContactInterface<dim> &interface,
                   const ContactPair<dim>      &contact_pair,
                   const GhostedVector         &solution)
  {
    if (!contact_pair.has_corner_points())
      return {};
    const Surface<dim>       &slave = contact_pair.slave;
    std::vector<Tensor<1, 2>> tractions(slave.nodes.size());
    for (const ContactPoint<dim> &point :
         contact_pair.corners_of_master(interface.points()))
      if (point.facing && point.status.kind != Status::open)
        {
          const ContactState<dim> now =
            interface.state(point, solution, solution);
          Tensor<1, 2> force({now.lambda_n, 0.});
          if constexpr (dim == 2)
            force[1] = now.lambda_t[0];
          // The shape functions of degree 2 would pull at the far nodes.
          const SurfaceFacet<dim> &facet = slave.facets[point.master_facet];
          const auto               parts =
            facet.kind->hats(facet.kind->inside(point.master_xi));
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
            {
              const unsigned int n = facet.nodes[a];
              // None on an axis at degree 2.
              if (const double weight = weight_of_node(slave, n); weight > 0)
                tractions[n] += parts[a] * point.weight / weight * force;
            }
        }
    return tractions;
  }



  template<int dim>
  GhostedVector contact_forces(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start)
  {
    GhostedVector forces = u_start.zero();
    for (const ContactPoint<dim> &point : interface.points())
      {
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Traction<dim>     traction =
          interface.active_set.traction(point, now);
        const Tensor<1, dim> force =
          point.weight *
          (traction.p * point.normal + point.along_tangents(traction.q));
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            forces[point.dofs(a)[c]] += point.C[a] * force[c];
      }
    return forces;
  }



  template<int dim>
  std::string describe_changes(const ContactInterface<dim>         &interface,
                               const std::vector<PointStatus<dim>> &statuses,
                               const GhostedVector                 &solution,
                               const GhostedVector                 &u_start)
  {
    const unsigned int max_lines = 10;
    unsigned int       n         = 0;
    std::ostringstream text;
    for (unsigned int q = 0; q < statuses.size(); ++q)
      {
        const ContactPoint<dim> &point = interface.points()[q];
        if (point.status == statuses[q] || ++n > max_lines)
          continue;
        const ContactState<dim> now = interface.state(point, solution, u_start);
        text << "\n        point " << q << " at X = ("
             << interface.contact_pair(point).place(point)
             << ") mm: " << describe(statuses[q]) << ", now "
             << describe(point.status) << "; gap " << now.gap
             << " mm, pressure " << now.lambda_n << " MPa, shear "
             << now.lambda_t << " MPa";
      }
    if (n > max_lines)
      text << "\n        and " << n - max_lines << " more";
    return text.str();
  }



  bool is_at_corner(const ContactInterface<2> &interface,
                    const NodeDoFs<2>         &node)
  {
    const auto ends_at = [&](const Surface<2>  &surface,
                             const unsigned int e,
                             const unsigned int n) {
      const SurfaceFacet<2> &edge = surface.facets[e];
      if (edge.nodes[0] != n && edge.nodes[1] != n)
        return false;
      const unsigned int a = edge.nodes[0] == n ? 0 : 1;
      const Tensor<1, 2> along =
        surface.nodes[edge.nodes[1]].X - surface.nodes[edge.nodes[0]].X;
      return edge.corner[a] ||
             (edge.ends_surface(a) &&
              interface.discretization.free_part(node, along / along.norm())
                  .norm() > Surface<2>::sine_of_smooth_slant());
    };
    for (const auto &contact_pair : interface.pairs)
      for (const Surface<2> *surface :
           {&contact_pair->slave,
            contact_pair->master ? &*contact_pair->master : nullptr})
        for (unsigned int n = 0; surface && n < surface->nodes.size(); ++n)
          if (surface->nodes[n].dofs == node)
            {
              const auto &edges = surface->facets_of_node[n];
              const auto  points =
                contact_pair->points_among(interface.points());
              const auto touches = [&](const ContactPoint<2> &point) {
                return point.status.kind != Status::open &&
                       std::count(point.nodes.begin(),
                                  point.nodes.end(),
                                  &surface->nodes[n]) > 0;
              };
              if (std::any_of(edges.begin(),
                              edges.end(),
                              [&](const unsigned int e) {
                                return ends_at(*surface, e, n);
                              }) &&
                  std::any_of(points.begin(), points.end(), touches))
                return true;
            }
    return false;
  }

#define INSTANTIATE(dim)                                                         \
  template unsigned int multiplier_at(const ContactInterface<dim> &,             \
                                      const ContactPair<dim> &,                  \
                                      const unsigned int);                       \
  template double       pressure_at(const ContactInterface<dim> &,               \
                                    const ContactPair<dim> &,                    \
                                    const unsigned int,                          \
                                    const GhostedVector &);                      \
  template std::vector<Tensor<1, 2>> corner_tractions(                           \
    const ContactInterface<dim> &,                                               \
    const ContactPair<dim> &,                                                    \
    const GhostedVector &);                                                      \
  template GhostedVector contact_forces(const ContactInterface<dim> &,           \
                                        const GhostedVector &,                   \
                                        const GhostedVector &);                  \
  template std::string   describe_changes(const ContactInterface<dim> &,         \
                                          const std::vector<PointStatus<dim>> &, \
                                          const GhostedVector &,                 \
                                          const GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
