/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of ContactPair that pairs its points with the master.

#include <algorithm>

#include "contact/interface/contact_pair.h"
#include "contact/mortar/face_mortar.h"
#include "contact/mortar/mortar.h"
#include "contact/points/corner_points.h"

namespace Contact
{
  // Glued surfaces keep the pairs of the undeformed state.
  template<int dim>
  bool ContactPair<dim>::pair(const ArrayView<ContactPoint<dim>> &points,
                              const GhostedVector                &u,
                              const PairingMode                  &mode) const
  {
    if (mode.is_rest && !mortar)
      return false;
    if (!tied)
      return pair_all(points, u, mode);
    const bool changed = pair_all(points, u.zero(), {});
    for (ContactPoint<dim> &point : points)
      {
        // Supports that hold the node in all directions are a wall and no plane
        // of symmetry, across which there would be no shear.
        if (point.facing &&
            !is_free_along(point, 1, point.normal, discretization))
          {
            point.tangents_held_by_supports.clear();
            point.has_no_free_tangent =
              has_no_free_tangent(point, discretization);
          }
        if (!free_motions.empty())
          point.motions = {{-point.normal, 0}};
      }
    return changed;
  }



  template<int dim>
  bool ContactPair<dim>::pair_all(const ArrayView<ContactPoint<dim>> &points,
                                  const GhostedVector                &u,
                                  const PairingMode &mode) const
  {
    const auto part = [&](const unsigned int first, const unsigned int end) {
      return ArrayView<ContactPoint<dim>>(points.data() + first, end - first);
    };
    // Surfaces that are kept apart push each other without touching.
    PairingMode of_mortar = mode;
    if (interference->added() != 0)
      of_mortar.keeps_open_points = of_mortar.leaves_far_points = false;
    const auto             of_discretization = part(0, n_of_discretization);
    const BodyOverlap<dim> bodies(surfaces_of_bodies,
                                  u,
                                  itself ? &*itself : nullptr);
    bool                   changed = mortar
                                       ? mortar->pair(of_discretization, u, of_mortar, bodies)
                                       : project(of_discretization, u, mode);
    if (mortar)
      leave_to_other_sides(of_discretization, u);
    if (n_of_discretization < n_of_slave)
      changed =
        project(part(n_of_discretization, n_of_slave), u, mode) || changed;
    if (has_corner_points())
      changed = pair_corners(part(n_of_slave, n_points), u, mode) || changed;

    // A nodal point looks from its own place, where the corner is.
    for (unsigned int q = n_of_slave; q < n_points; ++q)
      if (const unsigned int node = node_at_foot(points[q], slave);
          node != numbers::invalid_unsigned_int)
        if (const unsigned int own =
              multipliers.of_node[node] - first_multiplier;
            own < n_of_slave && (!mortar || own >= n_of_discretization))
          points[own].facing = false;
    return changed;
  }



  // A mortar point has the normals of both bodies in one: the facets tell.
  template<int dim>
  void ContactPair<dim>::leave_to_other_sides(
    const ArrayView<ContactPoint<dim>> &points,
    const GhostedVector                &u) const
  {
    if (other_sides.empty())
      return;
    const DeformedSurface<dim> now(slave, u), master_now(*master, u);
    for (ContactPoint<dim> &point : points)
      if (point.facing)
        if (const NormalCone<dim> here = directions(point, now, u);
            !here.others.empty() &&
            !here.faces(master_now.normal(
              point.master_facet,
              master->facets[point.master_facet].kind->middle)))
          {
            point.facing = false;
            point.change = PairingChange<dim>();
          }
  }



  template<int dim>
  bool
  ContactPair<dim>::pair_corners(const ArrayView<ContactPoint<dim>> &corners,
                                 const GhostedVector                &u,
                                 const PairingMode                  &mode) const
  {
    std::vector<ContactPoint<dim>> old(corners.begin(), corners.end());
    pair_corner_points(corners,
                       {*master, u},
                       {slave, u},
                       {surfaces_of_bodies, u},
                       discretization,
                       u);
    for (ContactPoint<dim> &corner : corners)
      differentiate(corner, u, mode);
    return !std::equal(corners.begin(),
                       corners.end(),
                       old.begin(),
                       [](const auto &a, const auto &b) {
                         return a.nodes == b.nodes;
                       });
  }



  // Where another side goes on, nothing beside this one is its partner.
  template<int dim>
  NormalCone<dim> ContactPair<dim>::directions(const ContactPoint<dim> &point,
                                               const DeformedSurface<dim> &now,
                                               const GhostedVector &u) const
  {
    NormalCone<dim> directions = directions_of(point, now);
    if (other_sides.empty())
      return directions;
    const SurfaceFacet<dim> &facet = slave.facets[point.slave_facet];
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      if (facet.kind->places[a] == point.slave_xi)
        if (const auto sides = other_sides.find(facet.nodes[a]);
            sides != other_sides.end())
          {
            directions.at_end = false;
            for (const auto &[surface, node] : sides->second)
              directions.others.push_back(surface->normal_at(node, u));
          }
    return directions;
  }



  template<int dim>
  bool ContactPair<dim>::project(const ArrayView<ContactPoint<dim>> &points,
                                 const GhostedVector                &u,
                                 const PairingMode                  &mode) const
  {
    const DeformedSurface<dim> now(slave, u);
    if (obstacle)
      {
        for (ContactPoint<dim> &point : points)
          {
            pair_with_obstacle(point, *obstacle, discretization, u);
            NormalCone<dim> here = directions(point, now, u);
            if (!here.others.empty())
              {
                here.others.clear();
                point.facing = point.facing && here.faces(point.normal);
              }
          }
        discretization.counters.projections += points.size();
        return false;
      }

    const DeformedSurface<dim> master_now(*master, u);
    const BodyOverlap<dim>     bodies(surfaces_of_bodies,
                                  u,
                                  itself ? &*itself : nullptr);
    bool                       changed = false;
    for (ContactPoint<dim> &point : points)
      {
        const auto      old_nodes = point.nodes;
        NormalCone<dim> here      = directions(point, now, u);
        here.overlap              = [&](const auto &x, const auto &other) {
          return bodies.is_between(
            {x, slave, point.slave_facet, point.slave_xi},
            0,
            other);
        };
        if (itself)
          here.partners = [&](const unsigned int facet) {
            return bodies.may_face(point.slave_facet, facet);
          };
        pair_with_master(point, here, master_now, discretization, u);
        if (itself && !point.facing)
          point.keep_nodes(point.n_slave_nodes);
        differentiate(point, u, mode);
        changed = changed || point.nodes != old_nodes;

        // If several points share multipliers, one that faces nothing pulls
        // them to zero, as weakly as a spring of the stiffness c: it must not
        // be the softer one beside points in contact.
        if (!has_point_per_multiplier())
          point.augmentation_parameter =
            (point.facing ? augmentation_parameter : 1e3) * stiffness(point);
      }
    return changed;
  }



  template<int dim>
  Projection<dim> ContactPair<dim>::facing_slave(
    const DeformedSurface<dim>      &slave_now,
    const Point<dim>                &x,
    const NormalCone<dim>           &normals,
    const std::vector<unsigned int> &master_facets) const
  {
    if (!itself)
      return slave_now.closest_point(x);
    NormalCone<dim> here = normals;
    here.partners        = [&](const unsigned int slave_facet) {
      return std::any_of(master_facets.begin(),
                         master_facets.end(),
                         [&](const unsigned int m) {
                           return itself->may_face(slave_facet, m);
                         });
    };
    return slave_now.closest_facing(x, here);
  }



  template<int dim>
  void ContactPair<dim>::begin_increment() const
  {
    if (mortar)
      mortar->begin_increment();
  }



  // In 2-D the kernel finds the derivatives.
  template<>
  void ContactPair<2>::differentiate(ContactPoint<2> &,
                                     const GhostedVector &,
                                     const PairingMode &) const
  {
  }



  template<>
  void ContactPair<3>::differentiate(ContactPoint<3>     &point,
                                     const GhostedVector &u,
                                     const PairingMode   &mode) const
  {
    point.change = PairingChange<3>();
    if (!mode.with_derivatives || point.status.kind == Status::open)
      return;
    point.change = change_of_projection(point, *surface_opposite(point), u);
    if (!discretization.dof_handler.locally_owned_dofs().is_element(
          point.dofs(0)[0]))
      {
        point.change.C.reinit(0, 0);
        point.change.rotation.clear();
      }
  }

  template void ContactPair<2>::begin_increment() const;
  template void ContactPair<3>::begin_increment() const;
  template bool ContactPair<2>::pair(const ArrayView<ContactPoint<2>> &,
                                     const GhostedVector &,
                                     const PairingMode &) const;
  template bool ContactPair<3>::pair(const ArrayView<ContactPoint<3>> &,
                                     const GhostedVector &,
                                     const PairingMode &) const;
  template Projection<2>
  ContactPair<2>::facing_slave(const DeformedSurface<2> &,
                               const Point<2> &,
                               const NormalCone<2> &,
                               const std::vector<unsigned int> &) const;
  template Projection<3>
                ContactPair<3>::facing_slave(const DeformedSurface<3> &,
                               const Point<3> &,
                               const NormalCone<3> &,
                               const std::vector<unsigned int> &) const;
  template bool ContactPair<2>::project(const ArrayView<ContactPoint<2>> &,
                                        const GhostedVector &,
                                        const PairingMode &) const;
  template bool ContactPair<3>::project(const ArrayView<ContactPoint<3>> &,
                                        const GhostedVector &,
                                        const PairingMode &) const;
} // namespace Contact
