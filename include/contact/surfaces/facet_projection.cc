/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/facet_projection.h"

#include <deal.II/base/symmetric_tensor.h>

#include <limits>

namespace Contact
{
  namespace
  {
    /// Derivatives of half the squared distance of a point to a place of a
    /// facet, with the sign that slope has a step towards the closest place.
    template<int dim>
    struct DistanceSlopes
    {
      DistanceSlopes(const FacetKind<dim>  &kind,
                     const Point<dim>      &x,
                     const FacetNodes<dim> &nodes,
                     const FacetPoint<dim> &xi)
      {
        const FacetShape<dim>               shape(kind, xi);
        Tensor<1, dim>                      r = x;
        std::array<Tensor<1, dim>, dim - 1> t;
        std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> second;
        for (unsigned int a = 0; a < kind.n_nodes; ++a)
          {
            r -= shape.value[a] * nodes[a];
            for (unsigned int k = 0; k < dim - 1; ++k)
              {
                t[k] += shape.derivative(a, k) * nodes[a];
                for (unsigned int l = 0; l <= k; ++l)
                  second[k][l] += shape.second_derivative(a, k, l) * nodes[a];
              }
          }
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            slope[k] = r * t[k];
            for (unsigned int l = 0; l <= k; ++l)
              {
                gauss[k][l] = t[k] * t[l];
                full[k][l]  = gauss[k][l] - r * second[k][l];
              }
          }
      }

      Tensor<1, dim - 1>          slope;
      SymmetricTensor<2, dim - 1> gauss, full;
    };



    // Newton's method for the closest point. Where the Hessian is not positive
    // definite, Gauss-Newton takes over; so it does at first, which from the
    // middle is the projection on the tangents there. Iterates stay near the
    // facet. Where it is far from the origin, the round-off of places may be
    // more than the tolerance: then the last steps do not become shorter.
    template<int dim, typename Step>
    FacetPoint<dim> minimize(const FacetKind<dim>  &kind,
                             const Point<dim>      &x,
                             const FacetNodes<dim> &nodes,
                             FacetPoint<dim>        xi,
                             const Step            &find_step)
    {
      const double small = 1e-8;
      double       last  = std::numeric_limits<double>::max();
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const Tensor<1, dim - 1> step =
            find_step(DistanceSlopes<dim>(kind, x, nodes, xi), iteration == 0);
          for (unsigned int k = 0; k < dim - 1; ++k)
            coordinate(xi, k) =
              std::max(-2., std::min(2., coordinate(xi, k) + step[k]));
          const double length = step.norm();
          if (length < 1e-14 || (length < small && length >= last))
            break;
          last = length;
        }
      return xi;
    }



    /// The closest place of the facet as it goes on.
    template<int dim>
    FacetPoint<dim> closest_of_all(const FacetKind<dim>  &kind,
                                   const Point<dim>      &x,
                                   const FacetNodes<dim> &nodes)
    {
      return minimize<dim>(
        kind,
        x,
        nodes,
        kind.middle,
        [](const DistanceSlopes<dim> &at, const bool is_first) {
          const bool is_convex =
            at.full[0][0] > 0 &&
            determinant(at.full) > 1e-3 * determinant(at.gauss);
          return Tensor<1, dim - 1>(
            invert(!is_first && is_convex ? at.full : at.gauss) * at.slope);
        });
    }



    /// The closest place from @p xi along a direction.
    FacetPoint<3> closest_along(const FacetKind<3>  &kind,
                                const Point<3>      &x,
                                const FacetNodes<3> &nodes,
                                const FacetPoint<3> &xi,
                                const Tensor<1, 2>  &direction)
    {
      return minimize<3>(
        kind,
        x,
        nodes,
        xi,
        [&](const DistanceSlopes<3> &at, const bool is_first) {
          const double full    = direction * (at.full * direction),
                       gauss   = direction * (at.gauss * direction);
          const bool is_convex = full > 1e-3 * gauss;
          return Tensor<1, 2>(1 / (!is_first && is_convex ? full : gauss) *
                              (at.slope * direction) * direction);
        });
    }

    /// The end of an edge is a place alone.
    FacetPoint<2> closest_along(const FacetKind<2> &,
                                const Point<2> &,
                                const FacetNodes<2> &,
                                const FacetPoint<2> &xi,
                                const Tensor<1, 1> &)
    {
      return xi;
    }
  } // namespace



  // Outside, the closest point is on one of the sides.
  template<int dim>
  FacetProjection<dim>
  project_on_facet(const FacetKind<dim>                  &kind,
                   const Point<dim>                      &x,
                   const FacetNodes<dim>                 &nodes,
                   const typename FacetKind<dim>::Limits &limits)
  {
    const FacetPoint<dim> whole = closest_of_all(kind, x, nodes);
    FacetProjection<dim>  found{whole, whole};
    const FacetPoint<dim> start = kind.inside(whole, limits);
    if (start == whole)
      return found;

    double smallest = std::numeric_limits<double>::max();
    for (unsigned int s = 0; s < kind.n_sides; ++s)
      {
        const FacetSide<dim> &side = kind.sides[s];
        FacetPoint<dim>       xi   = start;
        side.move_to(limits[s], xi);
        xi = kind.inside(closest_along(kind, x, nodes, xi, side.along), limits);
        side.move_to(limits[s], xi);
        const auto values = FacetShape<dim>::values(kind, xi);
        Point<dim> place;
        for (unsigned int a = 0; a < kind.n_nodes; ++a)
          place += values[a] * nodes[a];
        const double distance = x.distance_square(place);
        if (distance < smallest)
          {
            smallest = distance;
            found.xi = xi;
          }
      }
    return found;
  }

  template FacetProjection<2> project_on_facet(const FacetKind<2> &,
                                               const Point<2> &,
                                               const FacetNodes<2> &,
                                               const FacetKind<2>::Limits &);
  template FacetProjection<3> project_on_facet(const FacetKind<3> &,
                                               const Point<3> &,
                                               const FacetNodes<3> &,
                                               const FacetKind<3>::Limits &);
} // namespace Contact
