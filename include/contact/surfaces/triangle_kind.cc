/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/triangle_kind.h"

#include <deal.II/base/quadrature_lib.h>

namespace Contact
{
  namespace
  {
    using AreaCoordinates = std::array<double, 3>;

    AreaCoordinates area_coordinates(const Point<2> &xi)
    {
      return {{-(xi[0] + xi[1]) / 2, (1 + xi[0]) / 2, (1 + xi[1]) / 2}};
    }

    /// Their derivatives by the coordinates.
    constexpr std::array<std::array<double, 2>, 3> slopes{
      {{{-0.5, -0.5}}, {{0.5, 0}}, {{0, 0.5}}}};
  } // namespace



  TriangleKind::TriangleKind(const unsigned int of_degree)
  {
    degree            = of_degree;
    n_nodes           = degree == 1 ? 3 : 6;
    n_vertices        = 3;
    n_sides           = 3;
    polynomial_degree = degree;
    size_lines        = {{{0, 1}}, {{1, 2}}, {{2, 0}}};
    sides             = {{{0, 1}, Tensor<1, 2>({0., -1.}), 0, Point<2>(1, 0)},
                         {{1, 2}, Tensor<1, 2>({1., 1.}), 1, Point<2>(-1, 1)},
                         {{2, 0}, Tensor<1, 2>({-1., 0.}), 0, Point<2>(0, 1)}};
    vertices_of_node  = {{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}};
    reversed          = {0, 2, 1, 5, 4, 3};
    places = {{-1., -1.}, {1., -1.}, {-1., 1.}, {0., -1.}, {0., 0.}, {-1., 0.}};
    places.resize(n_nodes);
    middle = Point<2>(-1. / 3, -1. / 3);
    if (degree == 1)
      {
        parts       = {{{0, 1, 2}, Point<2>(), 1}};
        hat_factors = {1, 1, 1};
      }
    else
      {
        parts         = {{{0, 3, 5}, Point<2>(-0.5, -0.5), 0.5},
                         {{3, 1, 4}, Point<2>(0.5, -0.5), 0.5},
                         {{5, 4, 2}, Point<2>(-0.5, 0.5), 0.5},
                         {{4, 5, 3}, Point<2>(-0.5, -0.5), -0.5}};
        hat_factors   = {3, 3, 3, 1, 1, 1};
        part_of_sides = 0.2;
      }
    const QWitherdenVincentSimplex<2> quadrature(degree + 1);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        rule_places.emplace_back(2 * quadrature.point(q)[0] - 1,
                                 2 * quadrature.point(q)[1] - 1);
        rule_weights.push_back(4 * quadrature.weight(q));
      }
  }



  FacetKind<3>::Values TriangleKind::values(const Point<2> &xi) const
  {
    const auto L = area_coordinates(xi);
    Values     values{};
    for (unsigned int a = 0; a < 3; ++a)
      values[a] = degree == 1 ? L[a] : L[a] * (2 * L[a] - 1);
    for (unsigned int m = 3; m < n_nodes; ++m)
      values[m] = 4 * L[vertices_of_node[m][0]] * L[vertices_of_node[m][1]];
    return values;
  }



  void TriangleKind::first_order(const Point<2>        &xi,
                                 Values                &value,
                                 std::array<Values, 2> &first) const
  {
    const auto L = area_coordinates(xi);
    value        = values(xi);
    for (unsigned int k = 0; k < 2; ++k)
      {
        for (unsigned int a = 0; a < 3; ++a)
          first[k][a] = slopes[a][k] * (degree == 1 ? 1 : 4 * L[a] - 1);
        for (unsigned int m = 3; m < n_nodes; ++m)
          {
            const unsigned int a = vertices_of_node[m][0],
                               b = vertices_of_node[m][1];
            first[k][m] = 4 * (slopes[a][k] * L[b] + L[a] * slopes[b][k]);
          }
      }
  }



  void TriangleKind::second_order(const Point<2> &,
                                  std::array<Values, 2> &second,
                                  Values                &mixed) const
  {
    const auto by =
      [&](const unsigned int a, const unsigned int k, const unsigned int l) {
        if (a < 3)
          return degree == 1 ? 0. : 4 * slopes[a][k] * slopes[a][l];
        const auto &first = slopes[vertices_of_node[a][0]],
                   &last  = slopes[vertices_of_node[a][1]];
        return 4 * (first[k] * last[l] + first[l] * last[k]);
      };
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        second[0][a] = by(a, 0, 0);
        second[1][a] = by(a, 1, 1);
        mixed[a]     = by(a, 0, 1);
      }
  }



  // Left of a side, below one, or beyond the slanted one the closest place is
  // on it, or at one of its ends.
  Point<2> TriangleKind::inside(const Point<2> &xi, const Limits &limits) const
  {
    const double below = -limits[0], left = -limits[2], sum = limits[1] - 1;
    if (xi[0] < left)
      return {left, std::clamp(xi[1], below, sum - left)};
    if (xi[1] < below)
      return {std::clamp(xi[0], left, sum - below), below};
    if (xi[0] + xi[1] <= sum)
      return xi;
    const double x = std::clamp((xi[0] - xi[1] + sum) / 2, left, sum - below);
    return {x, sum - x};
  }



  // The four parts of degree 2 have the functions of degree 1.
  FacetKind<3>::Values TriangleKind::hats(const Point<2> &xi) const
  {
    const auto L = area_coordinates(xi);
    Values     values{};
    for (unsigned int a = 0; a < 3; ++a)
      values[a] = degree == 1 ? L[a] : std::max(0., 2 * L[a] - 1);
    for (unsigned int m = 3; m < n_nodes; ++m)
      {
        const unsigned int a = vertices_of_node[m][0],
                           b = vertices_of_node[m][1];
        values[m] = std::max(0., 2 * std::min({L[a], L[b], L[a] + L[b] - 0.5}));
      }
    return values;
  }



  // The triangle within the limits has corners P_i of its own. A surface of
  // degree 2 is x(P) = f(P, P) with an affine and symmetric f, whose values at
  // two corners are the control points (the blossom); those of the facet itself
  // are its vertices and 2 m - (a + b) / 2 of its sides.
  std::vector<Point<3>>
  TriangleKind::hull(const std::array<Point<3>, max_nodes> &x,
                     const Limits                          &limits) const
  {
    const double below = -limits[0], left = -limits[2], sum = limits[1] - 1;
    const std::array<AreaCoordinates, 3> P{
      {area_coordinates({left, below}),
       area_coordinates({sum - below, below}),
       area_coordinates({left, sum - left})}};
    std::array<std::array<Point<3>, 3>, 3> control;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        control[a][b] = x[a] + 0.5 * (x[b] - x[a]);
    for (unsigned int m = 3; m < n_nodes; ++m)
      {
        const unsigned int a = vertices_of_node[m][0],
                           b = vertices_of_node[m][1];
        const Point<3> of_side =
          x[m] + (0.5 * (x[m] - x[a]) + 0.5 * (x[m] - x[b]));
        control[a][b] = control[b][a] = of_side;
      }
    std::vector<Point<3>> points;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          Point<3> point;
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              point += P[i][a] * P[j][b] * Tensor<1, 3>(control[a][b]);
          points.push_back(point);
        }
    return points;
  }



  std::vector<Point<2>> TriangleKind::lattice(const bool with_nodes) const
  {
    std::vector<Point<2>> places;
    const auto            line = facet_kind<2>(2, degree).lattice(with_nodes);
    for (const double xi : line)
      for (const double eta : line)
        if (with_nodes ? xi + eta <= 0 : xi + eta < 0)
          places.emplace_back(xi, eta);
    return places;
  }
} // namespace Contact
