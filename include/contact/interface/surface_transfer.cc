/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/surface_transfer.h"

#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The place of the nodes, see SurfaceState.
    std::vector<double> places(const Surface<2> &slave)
    {
      auto                      places = slave.arc_length(slave.positions({}));
      const double              length = places.back();
      std::vector<unsigned int> side(places.size());
      unsigned int              n_sides = 0;
      for (unsigned int e = 0; e < slave.facets.size(); ++e)
        {
          n_sides += e > 0 && slave.facets[e].neighbors[0] != e - 1;
          for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
            side[slave.facets[e].nodes[a]] = n_sides;
        }
      for (unsigned int i = 0; i < places.size(); ++i)
        places[i] = side[i] + places[i] / length;
      return places;
    }



    /**
     * The place between a point @p last in contact and an @p open one beside it
     * at which the contact ends. Between smooth bodies p^2 falls to zero there
     * with a finite slope, as in Hertz' solution: the parabola of p^2 through
     * three points is extrapolated. They are two apart, so that with elements
     * of degree 2 they are of one kind, and not the very last ones, which the
     * end within their support disturbs. Without as many points: the middle.
     */
    double end_of_contact(const SurfaceState<2> &state,
                          const unsigned int     last,
                          const unsigned int     open)
    {
      const int             inward = last < open ? -2 : 2;
      const int             n      = state.place.size();
      std::array<double, 3> s{}, f{};
      double                end = 0.5 * (state.place[last] + state.place[open]);
      for (int k = 0; k < 3; ++k)
        {
          const int i = static_cast<int>(last) + (k + 1) * inward;
          if (i < 0 || i >= n || !(state.pressure[i] > 0))
            return end;
          s[k] = state.place[i];
          f[k] = std::pow(state.pressure[i], 2);
        }

      // Newton's form of the parabola, and Newton's method for its root.
      const double d01  = (f[1] - f[0]) / (s[1] - s[0]);
      const double d12  = (f[2] - f[1]) / (s[2] - s[1]);
      const double d012 = (d12 - d01) / (s[2] - s[0]);
      for (unsigned int iteration = 0; iteration < 10; ++iteration)
        end -= (f[0] + (end - s[0]) * (d01 + d012 * (end - s[1]))) /
               (d01 + d012 * (2 * end - s[0] - s[1]));

      const auto [low, high] =
        std::minmax({state.place[last], state.place[open]});
      return end >= low && end <= high ? end : (end < low ? low : high);
    }



    SurfaceState<2> save_pair(const ContactInterface<2> &interface,
                              const ContactPair<2>      &contact_pair,
                              const GhostedVector       &solution)
    {
      const auto      all_places = places(contact_pair.slave);
      SurfaceState<2> state;
      for (unsigned int i = 0; i < contact_pair.slave.nodes.size(); ++i)
        {
          const unsigned int k = contact_pair.multipliers.of_node[i];
          if (k == numbers::invalid_unsigned_int)
            continue;
          const unsigned int acting = interface.acting_multiplier(k);
          state.place.push_back(all_places[i]);
          state.pressure.push_back(solution[interface.normal_index(acting)]);
          state.shear.push_back(
            contact_pair.law.is_frictionless()
              ? 0.
              : solution[interface.tangential_index(acting)]);
          state.bound.push_back(interface.points()[acting].friction_bound);
          state.statuses.push_back(interface.points()[acting].status);
        }
      for (const ContactPoint<2> &point :
           contact_pair.corners_of_master(interface.points()))
        {
          const unsigned int k = point.multipliers[0];
          state.corners.push_back(
            {point.weight * solution[interface.normal_index(k)],
             contact_pair.law.is_frictionless()
               ? 0.
               : point.weight * solution[interface.tangential_index(k)],
             point.friction_bound,
             point.status});
        }
      return state;
    }



    // Values are interpolated; a status is that of the nearer point, but that
    // the end of the contact is looked for between the points.
    void restore_nodes(const SurfaceState<2>        &state,
                       const ContactPair<2>         &contact_pair,
                       const ContactInterface<2>    &interface,
                       std::vector<ContactPoint<2>> &points,
                       GhostedVector                &solution)
    {
      const auto all_places = places(contact_pair.slave);
      for (unsigned int i = 0; i < contact_pair.slave.nodes.size(); ++i)
        {
          const unsigned int k = contact_pair.multipliers.of_node[i];
          if (k == numbers::invalid_unsigned_int)
            continue;
          const auto above = std::lower_bound(state.place.begin(),
                                              state.place.end(),
                                              all_places[i]);
          const auto n     = state.place.size();
          const auto b =
            std::min<std::size_t>(above - state.place.begin(), n - 1);
          const auto   a = b == 0 ? b : b - 1;
          const double x =
            a == b ? 0.
                   : std::min(1.,
                              std::max(0.,
                                       (all_places[i] - state.place[a]) /
                                         (state.place[b] - state.place[a])));
          const auto between = [&](const std::vector<double> &values) {
            return (1 - x) * values[a] + x * values[b];
          };

          solution[interface.normal_index(k)] = between(state.pressure);
          if (!contact_pair.law.is_frictionless())
            solution[interface.tangential_index(k)] = between(state.shear);
          points[k].friction_bound = between(state.bound);
          points[k].status         = state.statuses[x < 0.5 ? a : b];
          const bool a_is_open     = state.statuses[a].kind == Status::open;
          const bool b_is_open     = state.statuses[b].kind == Status::open;
          if (a_is_open != b_is_open)
            {
              const double end = b_is_open ? end_of_contact(state, a, b)
                                           : end_of_contact(state, b, a);
              points[k].status = state.statuses[all_places[i] < end ? a : b];
            }
          if (!points[k].facing)
            points[k].status = PointStatus<2>();
          else if (points[k].status.kind == Status::stick &&
                   !interface.active_set.can_stick(points[k]))
            points[k].status = {Status::slip, 0};
        }
    }



    // They come in the order of the chain. Where a finer slave has got a node
    // close to a corner, that does not face it any more.
    void restore_corners(const SurfaceState<2>        &state,
                         const ContactPair<2>         &contact_pair,
                         const ContactInterface<2>    &interface,
                         std::vector<ContactPoint<2>> &points,
                         GhostedVector                &solution)
    {
      auto corner = state.corners.begin();
      for (ContactPoint<2> &point : contact_pair.corners_of_master(points))
        {
          if (corner == state.corners.end())
            break;
          point.status = point.facing ? corner->status : PointStatus<2>();
          point.friction_bound = corner->bound;
          if (point.status.kind == Status::stick &&
              !interface.active_set.can_stick(point))
            point.status = {Status::slip, 0};
          const unsigned int k                = point.multipliers[0];
          solution[interface.normal_index(k)] = corner->force / point.weight;
          if (!contact_pair.law.is_frictionless())
            solution[interface.tangential_index(k)] =
              corner->shear / point.weight;
          ++corner;
        }
    }



    void restore_pair(const SurfaceState<2>        &state,
                      const ContactPair<2>         &contact_pair,
                      const ContactInterface<2>    &interface,
                      std::vector<ContactPoint<2>> &points,
                      GhostedVector                &solution)
    {
      restore_nodes(state, contact_pair, interface, points, solution);
      restore_corners(state, contact_pair, interface, points, solution);
    }



    SurfaceState<3>::OfPoint save_point(const ContactInterface<3> &interface,
                                        const ContactPair<3>      &contact_pair,
                                        const unsigned int         k,
                                        const double               weight,
                                        const GhostedVector       &solution)
    {
      const ContactPoint<3> &point = interface.points()[k];
      Tensor<1, 2>           shear;
      for (unsigned int t = 0; t < 2 && !contact_pair.law.is_frictionless();
           ++t)
        shear[t] = weight * solution[interface.tangential_index(k, t)];
      return {weight * solution[interface.normal_index(k)],
              point.along_tangents(shear),
              point.friction_bound,
              point.status,
              point.along_tangents(point.status.direction())};
    }



    // Shears and directions of slip are those along other tangents.
    void restore_point(const SurfaceState<3>::OfPoint &state,
                       const ContactInterface<3>      &interface,
                       const ContactPair<3>           &contact_pair,
                       const unsigned int              k,
                       const double                    weight,
                       ContactPoint<3>                &point,
                       GhostedVector                  &solution)
    {
      solution[interface.normal_index(k)] = state.pressure / weight;
      point.friction_bound                = state.bound;
      point.status             = point.facing ? state.status : PointStatus<3>();
      const Tensor<1, 2> shear = point.tangential_part(state.shear) / weight;
      for (unsigned int t = 0; t < 2 && !contact_pair.law.is_frictionless();
           ++t)
        solution[interface.tangential_index(k, t)] = shear[t];
      if (point.status.has_direction())
        {
          const Tensor<1, 2> along =
            point.tangential_part(state.slip_direction);
          if (along.norm() > 0)
            point.status.slip_direction = along / along.norm();
          else
            point.status = {Status::stick, {}};
        }
    }



    SurfaceState<3> save_pair(const ContactInterface<3> &interface,
                              const ContactPair<3>      &contact_pair,
                              const GhostedVector       &solution)
    {
      SurfaceState<3> state;
      for (unsigned int i = 0; i < contact_pair.slave.nodes.size(); ++i)
        if (const unsigned int k = contact_pair.multipliers.of_node[i];
            k != numbers::invalid_unsigned_int)
          {
            state.places.push_back(contact_pair.slave.nodes[i].X);
            state.points.push_back(save_point(interface,
                                              contact_pair,
                                              interface.acting_multiplier(k),
                                              1,
                                              solution));
          }
      for (const ContactPoint<3> &corner :
           contact_pair.corners_of_master(interface.points()))
        {
          state.corner_places.push_back(corner.X(0));
          state.corners.push_back(save_point(interface,
                                             contact_pair,
                                             corner.multipliers[0],
                                             corner.weight,
                                             solution));
        }
      return state;
    }



    // A node gets the state of the nearest one of the coarser mesh.
    void restore_pair(const SurfaceState<3>        &state,
                      const ContactPair<3>         &contact_pair,
                      const ContactInterface<3>    &interface,
                      std::vector<ContactPoint<3>> &points,
                      GhostedVector                &solution)
    {
      const auto nearest = [](const Point<3> &X, const auto &tree) {
        return *tree.qbegin(boost::geometry::index::nearest(X, 1));
      };
      const auto nodes = pack_rtree_of_indices(state.places);
      for (unsigned int i = 0; i < contact_pair.slave.nodes.size(); ++i)
        if (const unsigned int k = contact_pair.multipliers.of_node[i];
            k != numbers::invalid_unsigned_int)
          restore_point(
            state.points[nearest(contact_pair.slave.nodes[i].X, nodes)],
            interface,
            contact_pair,
            k,
            1,
            points[k],
            solution);
      const auto corners = pack_rtree_of_indices(state.corner_places);
      if (!state.corners.empty())
        for (ContactPoint<3> &corner : contact_pair.corners_of_master(points))
          restore_point(state.corners[nearest(corner.X(0), corners)],
                        interface,
                        contact_pair,
                        corner.multipliers[0],
                        corner.weight,
                        corner,
                        solution);
    }
  } // namespace



  template<int dim>
  std::vector<SurfaceState<dim>>
  save_surfaces(const ContactInterface<dim> &interface,
                const GhostedVector         &solution)
  {
    std::vector<SurfaceState<dim>> states;
    for (const auto &contact_pair : interface.pairs)
      states.push_back(save_pair(interface, *contact_pair, solution));
    return states;
  }



  template<int dim>
  void restore_surfaces(const std::vector<SurfaceState<dim>> &states,
                        ContactInterface<dim>                &interface,
                        GhostedVector                        &solution)
  {
    std::vector<ContactPoint<dim>> points = interface.points();
    for (unsigned int z = 0; z < states.size(); ++z)
      {
        const ContactPair<dim> &contact_pair = *interface.pairs[z];
        restore_pair(states[z], contact_pair, interface, points, solution);
      }
    interface.set_points(points);
  }

  template std::vector<SurfaceState<2>>
  save_surfaces(const ContactInterface<2> &interface,
                const GhostedVector       &solution);

  template std::vector<SurfaceState<3>>
  save_surfaces(const ContactInterface<3> &interface,
                const GhostedVector       &solution);

  template void restore_surfaces(const std::vector<SurfaceState<2>> &states,
                                 ContactInterface<2>                &interface,
                                 GhostedVector                      &solution);
  template void restore_surfaces(const std::vector<SurfaceState<3>> &states,
                                 ContactInterface<3>                &interface,
                                 GhostedVector                      &solution);
} // namespace Contact
