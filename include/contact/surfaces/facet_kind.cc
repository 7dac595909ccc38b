/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/facet_kind.h"

#include "contact/surfaces/quadrangle_kind.h"
#include "contact/surfaces/triangle_kind.h"

namespace Contact
{
  template<int dim>
  void FacetSide<dim>::move_to(const double value, FacetPoint<dim> &xi) const
  {
    unsigned int last = 0;
    double       rest = value - constant;
    for (unsigned int k = 0; k < dim - 1; ++k)
      if (slope[k] != 0)
        last = k;
    for (unsigned int k = 0; k < last; ++k)
      rest -= slope[k] * coordinate(xi, k);
    coordinate(xi, last) = rest / slope[last];
  }



  FacetKind<2>::FacetKind(const unsigned int of_degree)
  {
    degree     = of_degree;
    n_nodes    = degree + 1;
    n_vertices = n_sides = 2;
    places.assign(node_coordinates.begin(), node_coordinates.begin() + n_nodes);
    vertices_of_node = {{0}, {1}, {0, 1}};
    size_lines       = {{{0, 1}}};
    middle           = 0;
    sides            = {{{0}, Tensor<1, 1>({-1.}), 0, {}},
                        {{1}, Tensor<1, 1>({1.}), 0, {}}};
  }



  FacetKind<2>::Values FacetKind<2>::hats(const double xi) const
  {
    Values values{};
    for (unsigned int a = 0; a < n_nodes; ++a)
      values[a] = hat(degree, a, xi);
    return values;
  }



  std::vector<Point<2>>
  FacetKind<2>::hull(const std::array<Point<2>, max_nodes> &x,
                     const Limits                          &limits) const
  {
    auto points = x;
    extend(degree, {{0, 1, 2}}, -limits[0], limits[1], points);
    return {points.begin(), points.begin() + n_nodes};
  }



  std::vector<double> FacetKind<2>::lattice(const bool with_nodes) const
  {
    if (with_nodes)
      return {-1., -0.5, 0., 0.5, 1.};
    return {-0.5, 0., 0.5};
  }



  FacetKind<3>::Values FacetKind<3>::tests(Values values) const
  {
    for (unsigned int s = 0; s < n_sides && part_of_sides > 0; ++s)
      {
        double      &of_side = values[middle_of_side(s)];
        const double part    = part_of_sides * of_side;
        for (const unsigned int end : sides[s].ends)
          {
            values[end] += part;
            of_side -= part;
          }
      }
    return values;
  }



  template<>
  const FacetKind<2> &facet_kind(const unsigned int, const unsigned int degree)
  {
    static const std::array<FacetKind<2>, 2> kinds{
      {FacetKind<2>(1), FacetKind<2>(2)}};
    return kinds[degree - 1];
  }

  template<>
  const FacetKind<3> &facet_kind(const unsigned int n_vertices,
                                 const unsigned int degree)
  {
    static const std::array<QuadrangleKind, 2> quadrangles{
      {QuadrangleKind(1), QuadrangleKind(2)}};
    static const std::array<TriangleKind, 2> triangles{
      {TriangleKind(1), TriangleKind(2)}};
    if (n_vertices == 3)
      return triangles[degree - 1];
    return quadrangles[degree - 1];
  }

  template struct FacetSide<2>;
  template struct FacetSide<3>;
} // namespace Contact
