/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/quadrangle_kind.h"

#include <deal.II/base/quadrature_lib.h>

#include "contact/surfaces/facet_shapes.h"

namespace Contact
{
  QuadrangleKind::QuadrangleKind(const unsigned int of_degree)
  {
    degree            = of_degree;
    n_nodes           = degree == 1 ? 4 : 9;
    n_vertices        = 4;
    n_sides           = 4;
    polynomial_degree = 2 * degree;
    size_lines        = {{{0, 3}}, {{1, 2}}};
    size_divisor      = std::sqrt(2.);
    sides             = {{{0, 2}, Tensor<1, 2>({-1., 0.}), 0, Point<2>(0, 1)},
                         {{1, 3}, Tensor<1, 2>({1., 0.}), 0, Point<2>(0, 1)},
                         {{0, 1}, Tensor<1, 2>({0., -1.}), 0, Point<2>(1, 0)},
                         {{2, 3}, Tensor<1, 2>({0., 1.}), 0, Point<2>(1, 0)}};
    vertices_of_node =
      {{0}, {1}, {2}, {3}, {0, 2}, {1, 3}, {0, 1}, {2, 3}, {0, 1, 2, 3}};
    reversed = {0, 2, 1, 3, 6, 7, 4, 5, 8};
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const auto [i, j] = factors[a];
        places.emplace_back(node_coordinates[i], node_coordinates[j]);
        hat_factors.push_back((i < 2 ? 2. : 1.) * (j < 2 ? 2. : 1.));
      }
    if (degree == 1)
      parts = {{{0, 1, 2, 3}, Point<2>(), 1}};
    else
      parts = {{{0, 6, 4, 8}, Point<2>(-0.5, -0.5), 0.5},
               {{6, 1, 8, 5}, Point<2>(0.5, -0.5), 0.5},
               {{4, 8, 2, 7}, Point<2>(-0.5, 0.5), 0.5},
               {{8, 5, 7, 3}, Point<2>(0.5, 0.5), 0.5}};
    const QGauss<2> quadrature(degree + 1);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        rule_places.emplace_back(2 * quadrature.point(q)[0] - 1,
                                 2 * quadrature.point(q)[1] - 1);
        rule_weights.push_back(4 * quadrature.weight(q));
      }
  }



  void QuadrangleKind::first_order(const Point<2>        &xi,
                                   Values                &value,
                                   std::array<Values, 2> &first) const
  {
    const EdgeShape x(degree, xi[0]), y(degree, xi[1]);
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const auto [i, j] = factors[a];
        value[a]          = x.value[i] * y.value[j];
        first[0][a]       = x.first[i] * y.value[j];
        first[1][a]       = x.value[i] * y.first[j];
      }
  }



  void QuadrangleKind::second_order(const Point<2>        &xi,
                                    std::array<Values, 2> &second,
                                    Values                &mixed) const
  {
    const EdgeShape x(degree, xi[0]), y(degree, xi[1]);
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const auto [i, j] = factors[a];
        second[0][a]      = x.second[i] * y.value[j];
        second[1][a]      = x.value[i] * y.second[j];
        mixed[a]          = x.first[i] * y.first[j];
      }
  }



  FacetKind<3>::Values QuadrangleKind::values(const Point<2> &xi) const
  {
    const EdgeShape x(degree, xi[0]), y(degree, xi[1]);
    Values          values{};
    for (unsigned int a = 0; a < n_nodes; ++a)
      values[a] = x.value[factors[a][0]] * y.value[factors[a][1]];
    return values;
  }



  Point<2> QuadrangleKind::inside(const Point<2> &xi,
                                  const Limits   &limits) const
  {
    return {std::clamp(xi[0], -limits[0], limits[1]),
            std::clamp(xi[1], -limits[2], limits[3])};
  }



  FacetKind<3>::Values QuadrangleKind::hats(const Point<2> &xi) const
  {
    Values values{};
    for (unsigned int a = 0; a < n_nodes; ++a)
      values[a] =
        hat(degree, factors[a][0], xi[0]) * hat(degree, factors[a][1], xi[1]);
    return values;
  }



  std::vector<Point<3>>
  QuadrangleKind::hull(const std::array<Point<3>, max_nodes> &x,
                       const Limits                          &limits) const
  {
    auto points = x;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int line = 0; line <= degree; ++line)
        extend(degree,
               lines[k][line],
               -limits[2 * k],
               limits[2 * k + 1],
               points);
    return {points.begin(), points.begin() + n_nodes};
  }



  std::vector<Point<2>> QuadrangleKind::lattice(const bool with_nodes) const
  {
    std::vector<Point<2>> places;
    const auto            line = facet_kind<2>(2, degree).lattice(with_nodes);
    for (const double xi : line)
      for (const double eta : line)
        places.emplace_back(xi, eta);
    return places;
  }
} // namespace Contact
