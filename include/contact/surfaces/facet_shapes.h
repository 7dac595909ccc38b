/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_shapes_h
#define contact_facet_shapes_h

#include "contact/surfaces/facet_kind.h"

namespace Contact
{
  using namespace dealii;

  /// The Lagrange functions of a facet of a surface at a place of it, and their
  /// derivatives: of an edge in 2-D, of a quadrangle or a triangle in 3-D.
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

    FacetShapes(const FacetKind<2> &kind, const Number &xi)
      : FacetShapes(kind.degree, xi)
    {
    }

    using Values = std::array<Number, 3>;

    /// The values alone.
    static Values values(const FacetKind<2> &kind, const Number &xi)
    {
      return FacetShapes(kind, xi).value;
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



  /// The functions of a facet in 3-D and their first derivatives: those of
  /// FacetShape that integrals need.
  struct FacetBasis
  {
    using Values = FacetKind<3>::Values;

    FacetBasis(const FacetKind<3> &kind, const Point<2> &xi)
    {
      kind.first_order(xi, value, first);
    }

    const double &derivative(const unsigned int a, const unsigned int k) const
    {
      return first[k][a];
    }

    // Those of the nodes that the facet has.
    Values                value;
    std::array<Values, 2> first;
  };



  /// The same with the second derivatives.
  template<>
  struct FacetShapes<3, double> : public FacetBasis
  {
    FacetShapes(const FacetKind<3> &kind, const Point<2> &xi)
      : FacetBasis(kind, xi)
    {
      kind.second_order(xi, second, mixed);
    }

    /// The values alone.
    static Values values(const FacetKind<3> &kind, const Point<2> &xi)
    {
      return kind.values(xi);
    }

    const double &second_derivative(const unsigned int a,
                                    const unsigned int k,
                                    const unsigned int l) const
    {
      return k == l ? second[k][a] : mixed[a];
    }

    std::array<Values, 2> second;
    Values                mixed; // second derivative by both coordinates
  };

  template<int dim>
  using FacetShape = FacetShapes<dim, double>;

  /// Something at each node of a facet.
  template<int dim, typename T>
  using PerFacetNode = std::array<T, FacetKind<dim>::max_nodes>;

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
  Tensor<1, dim> facet_normal(const FacetKind<dim>                &kind,
                              const PerFacetNode<dim, Point<dim>> &x,
                              const FacetPoint<dim>               &xi)
  {
    const FacetShape<dim>               shape(kind, xi);
    std::array<Tensor<1, dim>, dim - 1> tangents;
    for (unsigned int a = 0; a < kind.n_nodes; ++a)
      for (unsigned int k = 0; k < dim - 1; ++k)
        tangents[k] += shape.derivative(a, k) * x[a];
    const Tensor<1, dim> outward = outward_normal(tangents);
    return outward / outward.norm();
  }

  /// Directions that are within an angle @p range [rad] of a unit vector.
  template<int dim>
  struct DirectionRange
  {
    Tensor<1, dim> mean;
    double         range = 0;
  };

  /// The normals of a facet and its overhang, four times as far from their mean
  /// as those at its nodes: those of faces that are bent by more than a right
  /// angle from end to end may be anywhere.
  template<int dim>
  DirectionRange<dim> normal_range(const FacetKind<dim>                &kind,
                                   const PerFacetNode<dim, Point<dim>> &x)
  {
    std::vector<Tensor<1, dim>> at_nodes;
    DirectionRange<dim>         found;
    for (unsigned int a = 0; a < kind.n_nodes; ++a)
      found.mean +=
        at_nodes.emplace_back(facet_normal<dim>(kind, x, kind.places[a]));
    found.mean /= found.mean.norm();
    for (const Tensor<1, dim> &n : at_nodes)
      found.range =
        std::max(found.range,
                 4 * std::acos(std::clamp(n * found.mean, -1., 1.)));
    return found;
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
