/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_kind_h
#define contact_facet_kind_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace Contact
{
  using namespace dealii;

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

  /// Coordinates of the nodes of an edge: first, last, middle.
  constexpr std::array<double, 3> node_coordinates{{-1, 1, 0}};



  /// A side of a facet: an end of an edge, a line of a face.
  template<int dim>
  struct FacetSide
  {
    /// The vertices at its ends.
    std::vector<unsigned int> ends;

    /// slope . xi + constant is one on the side, less within the facet and more
    /// beyond the side.
    Tensor<1, dim - 1> slope;
    double             constant;

    /// A direction along it; of the end of an edge there is none.
    Tensor<1, dim - 1> along;

    /// The constant comes last: of what move_to() has moved to one it is that,
    /// without round-off.
    double at(const FacetPoint<dim> &xi) const
    {
      double sum = 0;
      for (unsigned int k = 0; k < dim - 1; ++k)
        sum += slope[k] * coordinate(xi, k);
      return sum + constant;
    }

    /// Move a place, by its last coordinate that changes it, to where at() is
    /// @p value.
    void move_to(const double value, FacetPoint<dim> &xi) const;
  };



  /**
   * A kind of facets, with all that depends on their shape: edges in 2-D,
   * quadrangles and triangles in 3-D, of degree 1 or 2. Coordinates of edges
   * are in [-1, 1], of quadrangles in [-1, 1] x [-1, 1], and of triangles in
   * the half of that where their sum is not positive. Nodes are vertices in the
   * order of deal.II, middles of the sides, and the middle of a quadrangle.
   */
  template<int dim>
  class FacetShapeTable
  {
  public:
    static constexpr unsigned int max_nodes    = dim == 2 ? 3 : 9;
    static constexpr unsigned int max_vertices = dim == 2 ? 2 : 4;
    static constexpr unsigned int max_sides    = dim == 2 ? 2 : 4;

    using Values = std::array<double, max_nodes>;

    /// By side, the value of FacetSide::at() up to which the facet goes: one,
    /// or more with an overhang.
    using Limits = std::array<double, max_sides>;

    static Limits without_overhang()
    {
      Limits limits;
      limits.fill(1);
      return limits;
    }

    unsigned int degree, n_nodes, n_vertices, n_sides;

    std::vector<FacetSide<dim>> sides;

    /// The coordinates of the nodes, and of the middle.
    std::vector<FacetPoint<dim>> places;
    FacetPoint<dim>              middle;

    /// By node, the vertices that it is in the middle of; of a vertex itself.
    std::vector<std::vector<unsigned int>> vertices_of_node;

    /// The pairs of vertices whose shortest distance by size_divisor is the
    /// size of a facet.
    std::vector<std::array<unsigned int, 2>> size_lines;
    double                                   size_divisor = 1;

    /// The node in the middle of a side, at degree 2.
    unsigned int middle_of_side(const unsigned int side) const
    {
      return n_vertices + side;
    }

    /// Whether a place is on a side of its facet, or beyond it.
    bool is_on_side(const FacetPoint<dim> &xi, const unsigned int side) const
    {
      return sides[side].at(xi) >= 1;
    }

    /// Whether a node is.
    bool has_on_side(const unsigned int node, const unsigned int side) const
    {
      return is_on_side(places[node], side);
    }

    /// The largest value of all sides: on the facet at most one.
    double outwardness(const FacetPoint<dim> &xi) const
    {
      double largest = sides[0].at(xi);
      for (const FacetSide<dim> &side : sides)
        largest = std::max(largest, side.at(xi));
      return largest;
    }
  };



  template<int dim>
  class FacetKind;



  /// Edges.
  template<>
  class FacetKind<2> : public FacetShapeTable<2>
  {
  public:
    explicit FacetKind(const unsigned int degree);

    /// The closest place within the limits.
    double inside(const double  xi,
                  const Limits &limits = without_overhang()) const
    {
      return std::clamp(xi, -limits[0], limits[1]);
    }

    /// Functions of the nodes that are linear between them.
    Values hats(const double xi) const;

    /// The control points of a facet with nodes at @p x within the limits.
    std::vector<Point<2>> hull(const std::array<Point<2>, max_nodes> &x,
                               const Limits &limits) const;

    /// Places at quarters of the facet, with those of the nodes or between
    /// them only.
    std::vector<double> lattice(const bool with_nodes) const;
  };



  /// The parts of a facet in 3-D that are projected with straight sides: one,
  /// or at degree 2 four. Each is of the same shape, with nodes of the facet as
  /// its corners.
  struct FacetPart
  {
    std::vector<unsigned int> corners;
    Point<2>                  middle; // of its coordinates, in the facet's
    double                    scale;  // of the coordinates of the part
  };



  /// Faces: their functions, and tables that edges do not need.
  template<>
  class FacetKind<3> : public FacetShapeTable<3>
  {
  public:
    virtual ~FacetKind() = default;

    /// A product of two shape functions of two facets whose parts are affine is
    /// of twice this degree.
    unsigned int polynomial_degree;

    /// By node, the one in its place of the facet looked at from behind.
    std::vector<unsigned int> reversed;

    std::vector<FacetPart> parts;

    /// By node, the integral of hats() of the node in the middle of its facet
    /// or side by the own one.
    std::vector<double> hat_factors;

    /// Places and weights of integrals over the coordinates, exact for shape
    /// functions on affine facets and their products with one another.
    std::vector<Point<2>> rule_places;
    std::vector<double>   rule_weights;

    /**
     * Test functions with positive integrals, by which pressures are weighted:
     * those of the vertices get this part of the function of each side they are
     * on, which leaves it to them (B. I. Wohlmuth, A. Popp, M. W. Gee and W. A.
     * Wall, Comput. Mech. 49, 2012). Zero: they are the shape functions.
     */
    double part_of_sides = 0;

    Values tests(Values values) const;

    /// The shape functions with their first derivatives, and the second ones:
    /// by each coordinate, and by both.
    virtual void   first_order(const Point<2>        &xi,
                               Values                &value,
                               std::array<Values, 2> &first) const = 0;
    virtual void   second_order(const Point<2>        &xi,
                                std::array<Values, 2> &second,
                                Values                &mixed) const               = 0;
    virtual Values values(const Point<2> &xi) const                = 0;

    virtual Point<2>
                                  inside(const Point<2> &xi,
                                         const Limits   &limits = without_overhang()) const = 0;
    virtual Values                hats(const Point<2> &xi) const       = 0;
    virtual std::vector<Point<3>> hull(const std::array<Point<3>, max_nodes> &x,
                                       const Limits &limits) const     = 0;
    virtual std::vector<Point<2>> lattice(const bool with_nodes) const = 0;

    /// The functions of the nodes with which the parts are projected.
    Values projected_values(const Point<2> &xi) const
    {
      return degree == 1 ? values(xi) : hats(xi);
    }
  };



  /// The kind of facets with so many vertices.
  template<int dim>
  const FacetKind<dim> &facet_kind(const unsigned int n_vertices,
                                   const unsigned int degree);
  template<>
  const FacetKind<2> &facet_kind(const unsigned int n_vertices,
                                 const unsigned int degree);
  template<>
  const FacetKind<3> &facet_kind(const unsigned int n_vertices,
                                 const unsigned int degree);
} // namespace Contact

#endif
