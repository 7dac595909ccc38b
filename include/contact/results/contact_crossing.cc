/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_crossing.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "contact/results/body_boundary.h"

namespace Contact
{
  namespace
  {
    /// The side that is closest to a place: of a body its facet, of an obstacle
    /// the radius of curvature [mm].
    template<int dim>
    struct ClosestSide
    {
      Tensor<1, dim>  normal;
      Projection<dim> closest;
      double          depth  = 0; // [mm]
      double          radius = 0;

      bool is_opposite(const ClosestSide &other) const
      {
        return normal * other.normal < 0;
      }
    };

    template<int dim>
    using Passage = std::pair<ClosestSide<dim>, ClosestSide<dim>>;



    /// The closest sides of a place just before and just after the time, from 0
    /// to 1, at which it is inside and they become opposite ones, or where it
    /// is half of the radius deep; nothing if the closest side turns
    /// continuously, or is the same. Between two samples of the path the time
    /// is found by bisection.
    template<int dim>
    std::optional<Passage<dim>>
    find_jump(const std::function<ClosestSide<dim>(const double)> &seen_at)
    {
      const unsigned int n = 32, n_bisections = 5;
      auto               last = seen_at(0);
      if (!last.is_opposite(seen_at(1)))
        return {};
      for (unsigned int k = 1; k <= n; ++k)
        {
          const auto next = seen_at(1. * k / n);
          if (next.radius > 0 && next.depth > next.radius / 2)
            return Passage<dim>{last, next};
          Passage<dim> ends{last, next};
          double       from = (k - 1.) / n, to = 1. * k / n;
          for (unsigned int bisection = 0;
               bisection < n_bisections && ends.first.is_opposite(ends.second);
               ++bisection)
            {
              const double middle     = (from + to) / 2;
              const auto   at         = seen_at(middle);
              const bool   is_before  = ends.first.is_opposite(at);
              (is_before ? to : from) = middle;
              (is_before ? ends.second : ends.first) = at;
            }
          if (ends.first.is_opposite(ends.second) && ends.second.depth > 0)
            return ends;
          last = next;
        }
      return {};
    }



    /// Both surfaces of a contact pair on straight paths from one state to
    /// another.
    template<int dim>
    class Paths
    {
    public:
      Paths(const Surface<dim>  &surface,
            const Surface<dim>  &faced,
            const GhostedVector &from,
            const GhostedVector &to)
        : surface(surface)
        , faced(faced)
        , own{{surface.positions(from), surface.positions(to)}}
        , other{{faced.positions(from), faced.positions(to)}}
        , other_box(other[0])
      {
        other_box.merge_with(BoundingBox<dim>(other[1]));
      }

      Point<dim> place(const unsigned int node, const double time) const
      {
        return between(own[0][node], own[1][node], time);
      }

      /// Whether the path of a node may meet that of the other surface.
      bool may_cross(const unsigned int node) const
      {
        const BoundingBox<dim> path(
          std::vector<Point<dim>>{own[0][node], own[1][node]});
        for (unsigned int i = 0; i < dim; ++i)
          if (path.upper_bound(i) < other_box.lower_bound(i) ||
              path.lower_bound(i) > other_box.upper_bound(i))
            return false;
        return true;
      }

      /// The other surface at a time, made once.
      const DeformedSurface<dim> &at(const double time)
      {
        const auto known = made.find(time);
        if (known != made.end())
          return *known->second;
        std::vector<Point<dim>> positions;
        for (unsigned int i = 0; i < other[0].size(); ++i)
          positions.push_back(between(other[0][i], other[1][i], time));
        return *(made[time] =
                   std::make_unique<DeformedSurface<dim>>(faced,
                                                          positions,
                                                          /*overhang=*/0.));
      }

      /// The closest side of a node at a time.
      ClosestSide<dim> seen_at(const unsigned int node, const double time)
      {
        const auto &now     = at(time);
        const auto  x       = place(node, time);
        const auto  closest = now.closest_point(x);
        return {now.normal(closest.facet, closest.xi),
                closest,
                depth_behind(now, closest, x)};
      }

      const Surface<dim> &surface, &faced;

    private:
      static Point<dim>
      between(const Point<dim> &from, const Point<dim> &to, const double time)
      {
        return from + time * (to - from);
      }

      const std::array<std::vector<Point<dim>>, 2>            own, other;
      BoundingBox<dim>                                        other_box;
      std::map<double, std::unique_ptr<DeformedSurface<dim>>> made;
    };



    /// Whether two facets have a vertex in common.
    template<int dim>
    bool meet(const SurfaceFacet<dim> &one, const SurfaceFacet<dim> &other)
    {
      return std::find_first_of(one.name.begin(),
                                one.name.end(),
                                other.name.begin(),
                                other.name.end()) != one.name.end();
    }



    /// Nodes of a surface that go through the other body. Each process looks
    /// at its share of them.
    template<int dim>
    void look(Paths<dim>            paths,
              const bool            of_master,
              const MPI_Comm        communicator,
              ContactCrossing<dim> &deepest)
    {
      const Surface<dim> &surface = paths.surface;
      for (const unsigned int i :
           Utilities::MPI::create_evenly_distributed_partitioning(
             communicator,
             surface.nodes.size()))
        {
          if (!paths.may_cross(i))
            continue;
          const auto jump = find_jump<dim>(
            [&](const double time) { return paths.seen_at(i, time); });
          if (!jump || meet(paths.faced.facets[jump->first.closest.facet],
                            paths.faced.facets[jump->second.closest.facet]))
            continue;
          const auto        &now   = paths.at(1);
          const unsigned int facet = jump->first.closest.facet;
          const auto        &xi    = jump->first.closest.xi;
          const double depth = (now.position(facet, xi) - paths.place(i, 1)) *
                               now.normal(facet, xi);
          if (depth > std::max(deepest.depth, surface.unresolved_length(0)))
            deepest = {of_master, surface.nodes[i].X, depth};
        }
    }



    template<int dim>
    void look_at_bodies(const ContactPair<dim> &contact_pair,
                        const GhostedVector    &from,
                        const GhostedVector    &to,
                        ContactCrossing<dim>   &deepest)
    {
      const MPI_Comm communicator = contact_pair.discretization.communicator;
      const Surface<dim> &slave   = contact_pair.slave,
                         &master  = *contact_pair.master;
      look<dim>({slave, master, from, to}, false, communicator, deepest);
      look<dim>({master, slave, from, to}, true, communicator, deepest);
      deepest = deepest_of_all(communicator, deepest);
    }



    /// Nodes of the slave that go through an obstacle, which stands still where
    /// it is carried to: the path is that against its material.
    template<int dim>
    void look_at_obstacle(const ContactPair<dim> &contact_pair,
                          const GhostedVector    &from,
                          const GhostedVector    &to,
                          ContactCrossing<dim>   &deepest)
    {
      const Obstacle<dim> &obstacle = *contact_pair.obstacle;
      const Surface<dim>  &slave    = contact_pair.slave;
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        {
          const Point<dim> start = obstacle.carried(slave.position(i, from));
          const Point<dim> end   = slave.position(i, to);
          const auto       jump  = find_jump<dim>([&](const double time) {
            const Point<dim> x       = start + time * (end - start);
            const auto       closest = obstacle.closest_point(x);
            return ClosestSide<dim>{closest.normal,
                                    {},
                                    closest.normal * (closest.x - x),
                                    closest.radius};
          });
          if (!jump)
            continue;
          const auto   in    = obstacle.closest_point(start);
          const double depth = in.normal * (in.x - end);
          if (depth > std::max(deepest.depth, slave.unresolved_length(0)))
            deepest = {false, slave.nodes[i].X, depth};
        }
    }
  } // namespace



  template<int dim>
  ContactCrossing<dim> find_crossing(const ContactPair<dim> &contact_pair,
                                     const GhostedVector    &from,
                                     const GhostedVector    &to)
  {
    ContactCrossing<dim> deepest;
    if (contact_pair.master)
      look_at_bodies(contact_pair, from, to, deepest);
    else
      look_at_obstacle(contact_pair, from, to, deepest);
    return deepest;
  }



  template<int dim>
  void check_obstacles(
    const std::vector<std::unique_ptr<const ContactPair<dim>>> &pairs,
    const GhostedVector                                        &from,
    const GhostedVector                                        &to)
  {
    for (const auto &contact_pair : pairs)
      if (contact_pair->obstacle && !contact_pair->tied)
        if (const auto crossing = find_crossing(*contact_pair, from, to);
            crossing.depth > 0)
          throw NotConverged(
            "an obstacle goes through its slave at X = (" + brief(crossing.X) +
            ") mm within the increment: the node is " + brief(crossing.depth) +
            " mm behind the side that it was in front of");
  }

#define INSTANTIATE(dim)                                                          \
  template ContactCrossing<dim> find_crossing(const ContactPair<dim> &,           \
                                              const GhostedVector &,              \
                                              const GhostedVector &);             \
  template void                 check_obstacles(                                  \
                    const std::vector<std::unique_ptr<const ContactPair<dim>>> &, \
                    const GhostedVector &,                                        \
                    const GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
