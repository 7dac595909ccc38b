/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_clipping_h
#define contact_face_clipping_h

#include <deal.II/base/point.h>

#include <array>
#include <boost/container/static_vector.hpp>

namespace Contact
{
  using namespace dealii;

  /// A plane that facets in 3-D are projected on, along its normal.
  class ProjectionPlane
  {
  public:
    ProjectionPlane(const Point<3> &origin, const Tensor<1, 3> &unit_normal);

    /// The place of a projected point in 2-D.
    Point<2> project(const Point<3> &x) const;

    const Tensor<1, 3> normal;

  private:
    const Point<3>              origin;
    std::array<Tensor<1, 3>, 2> axes;
  };



  /// A triangle in 2-D.
  using PlaneTriangle = std::array<Point<2>, 3>;

  /// A triangle or a quadrangle in 2-D: the corners in the order of deal.II.
  using PlaneFacet = boost::container::static_vector<Point<2>, 4>;

  /// Of two quadrangles that meet no more than eight if they are convex, and
  /// twelve if not: each side of one cuts the other at four places at most.
  using PlaneTriangles = boost::container::static_vector<PlaneTriangle, 12>;

  /// The intersection of two convex facets, cut into triangles; empty if
  /// it is no larger than round-off (I. E. Sutherland and G. W. Hodgman, Comm.
  /// ACM 17, 1974). Its area is continuous in the corners, also where sides lie
  /// on each other up to round-off, as on a symmetry plane. There
  /// Boost.Geometry 1.74, told not to round to a grid, loses up to 60 % of the
  /// area, twice in a thousand pairs (tests/face_clipping.cc has such pairs).
  PlaneTriangles intersection(const PlaneFacet &a, const PlaneFacet &b);



  /// The map of [-1, 1] x [-1, 1] to a quadrangle, and of half of that to a
  /// triangle, whose map is affine.
  class BilinearMap
  {
  public:
    BilinearMap(const PlaneFacet &facet);

    /// The coordinates of a point of the facet, which are near @p start.
    Point<2> coordinates_of(const Point<2> &x,
                            const Point<2> &start = Point<2>()) const;

    /// The absolute value of the determinant of the map.
    double jacobian(const Point<2> &xi) const;

    /// By how much the determinant varies, relative to that in the middle: zero
    /// of a parallelogram.
    double variation() const
    {
      return bend;
    }

  private:
    /// From the corners of a quadrangle.
    BilinearMap(const Point<2> &a,
                const Point<2> &b,
                const Point<2> &c,
                const Point<2> &d);

    Tensor<1, 2> middle, by_x, by_y, mixed;
    double       bend;
  };

  /// The area of a triangle, not signed.
  double area(const PlaneTriangle &triangle);
} // namespace Contact

#endif
