/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_shapes_h
#define contact_facet_shapes_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// The Lagrange functions of a facet of a surface at a place of it, and their
  /// derivatives: of an edge in 2-D, of a quadrangle in 3-D.
  template<int dim, typename Number>
  struct FacetShapes;

  /// Those of an edge, on [-1, 1], and two derivatives. Node order: first,
  /// last, middle.
  template<typename Number>
  struct FacetShapes<2, Number>
  {
    FacetShapes(const unsigned int degree, const Number &xi)
    {
      if (degree == 1)
        {
          value  = {{(1 - xi) / 2, (1 + xi) / 2, 0}};
          first  = {{-0.5, 0.5, 0}};
          second = {{0, 0, 0}};
        }
      else
        {
          value  = {{xi * (xi - 1) / 2, xi * (xi + 1) / 2, 1 - xi * xi}};
          first  = {{xi - 0.5, xi + 0.5, -2 * xi}};
          second = {{1, 1, -2}};
        }
    }

    using Values = std::array<Number, 3>;

    /// The values alone.
    static Values values(const unsigned int degree, const Number &xi)
    {
      return FacetShapes(degree, xi).value;
    }

    /// The derivative of a function along a coordinate of the facet.
    const Number &derivative(const unsigned int a, const unsigned int) const
    {
      return first[a];
    }

    /// The same along two coordinates.
    const Number &second_derivative(const unsigned int a,
                                    const unsigned int,
                                    const unsigned int) const
    {
      return second[a];
    }

    Values value, first, second;
  };

  template<typename Number>
  using EdgeShapes = FacetShapes<2, Number>;

  using EdgeShape = EdgeShapes<double>;

  /// Coordinates of the nodes of an edge: first, last, middle.
  constexpr std::array<double, 3> node_coordinates{{-1, 1, 0}};



  /// Those of a quadrangle, on [-1, 1] x [-1, 1]: products of those of edges.
  /// Node order: corners, middles of the sides, centre, as deal.II's.
  template<typename Number>
  struct FacetShapes<3, Number>
  {
    static constexpr unsigned int max_nodes = 9;

    /// The node of the edge shapes in either coordinate.
    static constexpr std::array<std::array<unsigned int, 2>, max_nodes> factors{
      {{{0, 0}},
       {{1, 0}},
       {{0, 1}},
       {{1, 1}},
       {{0, 2}},
       {{1, 2}},
       {{2, 0}},
       {{2, 1}},
       {{2, 2}}}};

    FacetShapes(const unsigned int degree, const Point<2, Number> &xi)
    {
      const EdgeShapes<Number> x(degree, xi[0]), y(degree, xi[1]);
      for (unsigned int a = 0; a < (degree == 1 ? 4 : max_nodes); ++a)
        {
          const auto [i, j] = factors[a];
          value[a]          = x.value[i] * y.value[j];
          first[0][a]       = x.first[i] * y.value[j];
          first[1][a]       = x.value[i] * y.first[j];
          second[0][a]      = x.second[i] * y.value[j];
          second[1][a]      = x.value[i] * y.second[j];
          mixed[a]          = x.first[i] * y.first[j];
        }
    }

    const Number &derivative(const unsigned int a, const unsigned int k) const
    {
      return first[k][a];
    }

    const Number &second_derivative(const unsigned int a,
                                    const unsigned int k,
                                    const unsigned int l) const
    {
      return k == l ? second[k][a] : mixed[a];
    }

    using Values = std::array<Number, max_nodes>;

    /// The values alone.
    static Values values(const unsigned int degree, const Point<2, Number> &xi)
    {
      const EdgeShapes<Number> x(degree, xi[0]), y(degree, xi[1]);
      Values                   values{};
      for (unsigned int a = 0; a < (degree == 1 ? 4 : max_nodes); ++a)
        values[a] = x.value[factors[a][0]] * y.value[factors[a][1]];
      return values;
    }

    // Those of the nodes that the degree has.
    Values                value;
    std::array<Values, 2> first, second;
    Values                mixed; // second derivative by both coordinates
  };

  template<int dim>
  using FacetShape = FacetShapes<dim, double>;

  /// A place on a facet: one coordinate in 2-D, two in 3-D.
  template<int dim>
  using FacetPoint = std::conditional_t<dim == 2, double, Point<2>>;

  /// One of its coordinates.
  inline double &coordinate(double &xi, const unsigned int)
  {
    return xi;
  }
  inline double coordinate(const double &xi, const unsigned int)
  {
    return xi;
  }
  inline double &coordinate(Point<2> &xi, const unsigned int k)
  {
    return xi[k];
  }
  inline double coordinate(const Point<2> &xi, const unsigned int k)
  {
    return xi[k];
  }

  /// The absolute value of the largest one: on the facet at most 1.
  inline double largest_coordinate(const double xi)
  {
    return std::abs(xi);
  }
  inline double largest_coordinate(const Point<2> &xi)
  {
    return std::max(std::abs(xi[0]), std::abs(xi[1]));
  }

  /// The coordinates of a node of a facet.
  template<int dim>
  FacetPoint<dim> node_place(const unsigned int a)
  {
    if constexpr (dim == 2)
      return node_coordinates[a];
    else
      {
        const auto [i, j] = FacetShapes<3, double>::factors[a];
        return Point<2>(node_coordinates[i], node_coordinates[j]);
      }
  }

  /// Whether a place is on a side of its facet, or beyond it.
  template<typename Place>
  bool is_on_side(const Place &xi, const unsigned int side)
  {
    return (side % 2 == 0 ? -1 : 1) * coordinate(xi, side / 2) >= 1;
  }

  /// Whether a node of a facet is.
  template<int dim>
  bool is_on_side(const unsigned int a, const unsigned int side)
  {
    return is_on_side(node_place<dim>(a), side);
  }

  /// Something at each node of a facet.
  template<int dim, typename T>
  using PerFacetNode = std::array<T, Utilities::pow(3, dim - 1)>;

  template<typename T>
  using PerEdgeNode = PerFacetNode<2, T>;

  /// A vector at each node of each facet.
  template<int dim>
  using FacetNormals = std::vector<PerFacetNode<dim, Tensor<1, dim>>>;



  template<typename Number>
  Number cross(const Tensor<1, 2, Number> &a, const Tensor<1, 2, Number> &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }

  /// A vector along the outward normal, as long as the measure of the facet per
  /// unit of its coordinates, from the tangents along these.
  template<typename Number>
  Tensor<1, 2, Number>
  outward_normal(const std::array<Tensor<1, 2, Number>, 1> &tangents)
  {
    return cross_product_2d(tangents[0]);
  }

  template<typename Number>
  Tensor<1, 3, Number>
  outward_normal(const std::array<Tensor<1, 3, Number>, 2> &tangents)
  {
    return cross_product_3d(tangents[0], tangents[1]);
  }

  /// The outward unit normal of a facet at a place of it, from the positions of
  /// its nodes.
  template<int dim>
  Tensor<1, dim> facet_normal(const unsigned int                   degree,
                              const PerFacetNode<dim, Point<dim>> &x,
                              const FacetPoint<dim>               &xi)
  {
    const FacetShape<dim>               shape(degree, xi);
    std::array<Tensor<1, dim>, dim - 1> tangents;
    for (unsigned int a = 0; a < Utilities::fixed_power<dim - 1>(degree + 1);
         ++a)
      for (unsigned int k = 0; k < dim - 1; ++k)
        tangents[k] += shape.derivative(a, k) * x[a];
    const Tensor<1, dim> outward = outward_normal(tangents);
    return outward / outward.norm();
  }

  /// The vectors along a facet with d_i . t_j = delta_ij.
  inline std::array<Tensor<1, 3>, 2>
  dual_basis(const std::array<Tensor<1, 3>, 2> &t)
  {
    const double g00 = t[0] * t[0], g01 = t[0] * t[1], g11 = t[1] * t[1];
    const double det = g00 * g11 - g01 * g01;
    return {{g11 / det * t[0] - g01 / det * t[1],
             g00 / det * t[1] - g01 / det * t[0]}};
  }
} // namespace Contact

#endif
