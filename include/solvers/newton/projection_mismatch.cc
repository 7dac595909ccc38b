/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/projection_mismatch.h"

#include <deal.II/base/bounding_box.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The largest extent of a surface [mm].
    template<int dim>
    double size(const Surface<dim> &surface, const GhostedVector &solution)
    {
      const auto corners =
        BoundingBox<dim>(surface.positions(solution)).get_boundary_points();
      return corners.first.distance(corners.second);
    }



    /// From the projection point of a point on the master to its place on the
    /// slave [mm].
    template<int dim>
    Tensor<1, dim> separation(const ContactInterface<dim> &interface,
                              const ContactPoint<dim>     &point,
                              const GhostedVector         &solution)
    {
      Tensor<1, dim> r        = -point.projection;
      double         of_slave = 0;
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        {
          of_slave += a < point.n_slave_nodes ? point.C[a] : 0.;
          for (unsigned int i = 0; i < dim; ++i)
            r[i] += point.C[a] * (point.X(a)[i] + solution[point.dofs(a)[i]]);
        }
      for (unsigned int k = 0; k < point.motions.size(); ++k)
        r -= of_slave *
             (interface.motions.value(point, k, solution) -
              point.motions[k].paired) *
             point.motions[k].way;
      return r;
    }



    /// A point under the pairing of the state and under its closest one.
    template<int dim>
    struct TwoPairings
    {
      const ContactInterface<dim> &interface;
      const GhostedVector         &solution, &u_start;
      const ContactPoint<dim>     &paired, &closest;

      double gap() const
      {
        if (!closest.facing)
          return 0;
        const double gap = interface.state(closest, solution, u_start).gap;
        if (!paired.facing)
          return std::max(0., -gap);
        const double change =
          gap - interface.state(paired, solution, u_start).gap;
        return paired.status.kind == Status::open ? std::min(-gap, -change)
                                                  : std::abs(change);
      }

      double force() const
      {
        if (!paired.facing)
          return 0;
        const auto state    = interface.state(paired, solution, u_start);
        const auto traction = interface.active_set.traction(paired, state);
        return paired.weight * std::hypot(traction.p, traction.q.norm());
      }

      double shift() const
      {
        Tensor<1, dim> d = separation(interface, paired, solution);
        if (closest.facing)
          d -= separation(interface, closest, solution);
        return paired.tangential_part(d).norm();
      }
    };
  } // namespace



  template<int dim>
  ProjectionMismatch mismatch(const ContactInterface<dim> &interface,
                              const GhostedVector         &solution,
                              const GhostedVector         &u_start)
  {
    const std::vector<ContactPoint<dim>> closest =
      interface.paired_anew(solution);
    ProjectionMismatch found;
    for (const auto &contact_pair : interface.pairs)
      {
        if (contact_pair->tied)
          continue;
        const unsigned int first = contact_pair->first_point,
                           n     = contact_pair->n_points;
        double forces = 0, couples = 0, unheld = 0;
        for (unsigned int k = first; k < first + n; ++k)
          {
            const TwoPairings<dim> point{interface,
                                         solution,
                                         u_start,
                                         interface.points()[k],
                                         closest[k]};
            found.gap          = std::max(found.gap, point.gap());
            const double force = point.force();
            forces += force;
            if (force == 0)
              continue;
            couples += force * point.shift();
            if (!closest[k].facing)
              unheld += force;
          }
        if (forces == 0)
          continue;
        const double part =
          couples / forces / size(contact_pair->slave, solution);
        if (part > found.offset)
          {
            found.offset = part;
            found.unheld = unheld / forces;
          }
        found.shift = std::max(found.shift, couples / forces);
      }
    return found;
  }

  template ProjectionMismatch mismatch(const ContactInterface<2> &,
                                       const GhostedVector &,
                                       const GhostedVector &);
  template ProjectionMismatch mismatch(const ContactInterface<3> &,
                                       const GhostedVector &,
                                       const GhostedVector &);
} // namespace Contact
