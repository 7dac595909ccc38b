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
    // Newton's method for the closest point from @p xi, with the coordinate
    // @p fixed as it is: of half the squared distance. Where its Hessian is not
    // positive definite, Gauss-Newton takes over; so it does at first, which
    // from the middle is the projection on the tangents there. Iterates stay
    // near the facet. Where it is far from the origin, the round-off of places
    // may be more than the tolerance: then the last steps do not become
    // shorter.
    template<int dim>
    FacetPoint<dim>
    minimize(const unsigned int     degree,
             const Point<dim>      &x,
             const FacetNodes<dim> &nodes,
             FacetPoint<dim>        xi,
             const unsigned int     fixed = numbers::invalid_unsigned_int)
    {
      using Hessian = SymmetricTensor<2, dim - 1>;

      const double small = 1e-8;
      double       last  = std::numeric_limits<double>::max();
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const FacetShape<dim>               shape(degree, xi);
          Tensor<1, dim>                      r = x;
          std::array<Tensor<1, dim>, dim - 1> t;
          std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> second;
          for (unsigned int a = 0;
               a < Utilities::fixed_power<dim - 1>(degree + 1);
               ++a)
            {
              r -= shape.value[a] * nodes[a];
              for (unsigned int k = 0; k < dim - 1; ++k)
                {
                  t[k] += shape.derivative(a, k) * nodes[a];
                  for (unsigned int l = 0; l <= k; ++l)
                    second[k][l] += shape.second_derivative(a, k, l) * nodes[a];
                }
            }
          Hessian            gauss, full;
          Tensor<1, dim - 1> slope;
          for (unsigned int k = 0; k < dim - 1; ++k)
            {
              slope[k] = k == fixed ? 0. : r * t[k];
              for (unsigned int l = 0; l <= k; ++l)
                {
                  const bool is_free = k != fixed && l != fixed;
                  gauss[k][l]        = is_free ? t[k] * t[l] : double(k == l);
                  full[k][l] = gauss[k][l] - (is_free ? r * second[k][l] : 0.);
                }
            }
          const bool is_convex =
            full[0][0] > 0 && determinant(full) > 1e-3 * determinant(gauss);
          const Tensor<1, dim - 1> step =
            invert(iteration > 0 && is_convex ? full : gauss) * slope;
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
  } // namespace



  // Outside, the closest point is on one of the sides.
  template<int dim>
  FacetProjection<dim>
  project_on_facet(const unsigned int                                    degree,
                   const Point<dim>                                     &x,
                   const FacetNodes<dim>                                &nodes,
                   const std::array<std::pair<double, double>, dim - 1> &box)
  {
    const auto inside = [&](FacetPoint<dim> xi) {
      for (unsigned int k = 0; k < dim - 1; ++k)
        coordinate(xi, k) =
          std::clamp(coordinate(xi, k), box[k].first, box[k].second);
      return xi;
    };
    const FacetPoint<dim> whole =
      minimize<dim>(degree, x, nodes, FacetPoint<dim>());
    FacetProjection<dim> found{whole, whole};
    if (inside(whole) == whole)
      return found;

    double smallest = std::numeric_limits<double>::max();
    for (unsigned int s = 0; s < 2 * (dim - 1); ++s)
      {
        const unsigned int k  = s / 2;
        FacetPoint<dim>    xi = inside(whole);
        coordinate(xi, k)     = s % 2 == 0 ? box[k].first : box[k].second;
        xi                    = inside(minimize<dim>(degree, x, nodes, xi, k));
        const auto values     = FacetShape<dim>::values(degree, xi);
        Point<dim> place;
        for (unsigned int a = 0;
             a < Utilities::fixed_power<dim - 1>(degree + 1);
             ++a)
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

  template FacetProjection<2>
  project_on_facet(const unsigned int,
                   const Point<2> &,
                   const FacetNodes<2> &,
                   const std::array<std::pair<double, double>, 1> &);
  template FacetProjection<3>
  project_on_facet(const unsigned int,
                   const Point<3> &,
                   const FacetNodes<3> &,
                   const std::array<std::pair<double, double>, 2> &);
} // namespace Contact
