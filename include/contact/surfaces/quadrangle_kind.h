/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_quadrangle_kind_h
#define contact_quadrangle_kind_h

#include "contact/surfaces/facet_kind.h"

namespace Contact
{
  using namespace dealii;

  /// The function of a node of an edge that is linear between the nodes.
  inline double
  hat(const unsigned int degree, const unsigned int node, const double xi)
  {
    return std::max(0.,
                    1 - std::abs(xi - node_coordinates[node]) /
                          (degree == 1 ? 2 : 1));
  }

  /**
   * Let the control points of a line of nodes, its first, last and middle one,
   * be those of the line from @p begin to @p end in its coordinate: at degree 2
   * the middle one of the control points of a line of three nodes a, m, b is 2
   * m - (a + b) / 2. With an overhang the line goes on to where its own control
   * points are.
   */
  template<int dim, std::size_t n>
  void extend(const unsigned int                 degree,
              const std::array<unsigned int, 3> &line,
              const double                       begin,
              const double                       end,
              std::array<Point<dim>, n>         &points)
  {
    const auto [first, last, middle] = line;
    const Point<dim>     a = points[first], b = points[last];
    const Tensor<1, dim> slope = 0.5 * (b - a);
    if (degree == 1)
      {
        points[first] = a + (begin + 1) * slope;
        points[last]  = b + (end - 1) * slope;
        return;
      }
    const Point<dim>     m    = points[middle];
    const Tensor<1, dim> bend = 0.5 * ((a - m) + (b - m));
    points[first]             = m + begin * slope + begin * begin * bend;
    points[last]              = m + end * slope + end * end * bend;
    points[middle] = m + 0.5 * (begin + end) * slope + begin * end * bend;
  }



  /// Quadrangles of 4 and 9 nodes: products of the functions of edges.
  class QuadrangleKind : public FacetKind<3>
  {
  public:
    explicit QuadrangleKind(const unsigned int degree);

    void     first_order(const Point<2>        &xi,
                         Values                &value,
                         std::array<Values, 2> &first) const override;
    void     second_order(const Point<2>        &xi,
                          std::array<Values, 2> &second,
                          Values                &mixed) const override;
    Values   values(const Point<2> &xi) const override;
    Point<2> inside(const Point<2> &xi, const Limits &limits) const override;
    Values   hats(const Point<2> &xi) const override;
    std::vector<Point<3>> hull(const std::array<Point<3>, max_nodes> &x,
                               const Limits &limits) const override;
    std::vector<Point<2>> lattice(const bool with_nodes) const override;

  private:
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

    /// Lines of nodes along either coordinate: the first, the last and the
    /// middle one. The third line is there at degree 2 alone.
    static constexpr std::array<std::array<std::array<unsigned int, 3>, 3>, 2>
      lines{{{{{{0, 1, 6}}, {{2, 3, 7}}, {{4, 5, 8}}}},
             {{{{0, 2, 4}}, {{1, 3, 5}}, {{6, 7, 8}}}}}};
  };
} // namespace Contact

#endif
