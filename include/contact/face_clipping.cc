/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_clipping.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  namespace
  {
    using Polygon = std::vector<Point<2>>;



    /// Twice the area of the triangle o, a, b; positive if it is
    /// counterclockwise.
    double cross(const Point<2> &o, const Point<2> &a, const Point<2> &b)
    {
      return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }



    /// Counterclockwise round its corners.
    Polygon make_polygon(const PlaneQuadrangle &q)
    {
      if (cross(q[0], q[1], q[3]) + cross(q[0], q[3], q[2]) >= 0)
        return {q[0], q[1], q[3], q[2]};
      return {q[0], q[2], q[3], q[1]};
    }



    double area(const Polygon &polygon)
    {
      double area = 0;
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += 0.5 * cross(polygon[0], polygon[i], polygon[i + 1]);
      return area;
    }



    /// What of a polygon is to the left of the line from @p a to @p b.
    Polygon clip(const Polygon &polygon, const Point<2> &a, const Point<2> &b)
    {
      Polygon left;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          const Point<2> &x = polygon[i],
                         &y = polygon[(i + 1) % polygon.size()];
          const double of_x = cross(a, b, x), of_y = cross(a, b, y);
          if (of_x >= 0)
            left.push_back(x);
          if ((of_x > 0 && of_y < 0) || (of_x < 0 && of_y > 0))
            left.push_back(x + of_x / (of_x - of_y) * (y - x));
        }
      return left;
    }
  } // namespace



  ProjectionPlane::ProjectionPlane(const Point<3>     &origin,
                                   const Tensor<1, 3> &unit_normal)
    : normal(unit_normal)
    , origin(origin)
  {
    unsigned int axis = 0;
    for (unsigned int i = 1; i < 3; ++i)
      if (std::abs(normal[i]) < std::abs(normal[axis]))
        axis = i;
    const Tensor<1, 3> e = Point<3>::unit_vector(axis);
    axes[0]              = e - (e * normal) * normal;
    axes[0] /= axes[0].norm();
    axes[1] = cross_product_3d(normal, axes[0]);
  }



  Point<2> ProjectionPlane::project(const Point<3> &x) const
  {
    const Tensor<1, 3> r = x - origin;
    return Point<2>(r * axes[0], r * axes[1]);
  }



  double area(const PlaneTriangle &triangle)
  {
    const Tensor<1, 2> a = triangle[1] - triangle[0];
    const Tensor<1, 2> b = triangle[2] - triangle[0];
    return 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);
  }



  // A convex polygon is the triangles between a point inside and its sides.
  std::vector<PlaneTriangle> intersection(const PlaneQuadrangle &a,
                                          const PlaneQuadrangle &b)
  {
    const Polygon subject = make_polygon(a), window = make_polygon(b);
    const double  least  = 1e-12 * std::min(area(subject), area(window));
    Polygon       common = subject;
    for (std::size_t i = 0; i < window.size(); ++i)
      common = clip(common, window[i], window[(i + 1) % window.size()]);
    if (common.size() < 3 || area(common) <= least)
      return {};

    Point<2> middle;
    for (const Point<2> &x : common)
      middle += (x - Point<2>()) / double(common.size());
    std::vector<PlaneTriangle> triangles;
    for (std::size_t i = 0; i < common.size(); ++i)
      {
        const PlaneTriangle triangle{
          {middle, common[i], common[(i + 1) % common.size()]}};
        if (area(triangle) > least)
          triangles.push_back(triangle);
      }
    return triangles;
  }



  // Newton's method from the middle; of a parallelogram one step.
  Point<2> coordinates_in(const PlaneQuadrangle &q, const Point<2> &x)
  {
    const Tensor<1, 2> middle =
      0.25 * (q[0] + (q[1] - Point<2>()) + (q[2] - Point<2>()) +
              (q[3] - Point<2>()) - Point<2>());
    const Tensor<1, 2> by_x  = 0.25 * ((q[1] - q[0]) + (q[3] - q[2]));
    const Tensor<1, 2> by_y  = 0.25 * ((q[2] - q[0]) + (q[3] - q[1]));
    const Tensor<1, 2> mixed = 0.25 * ((q[3] - q[2]) - (q[1] - q[0]));
    Point<2>           xi;
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        const Tensor<1, 2> r = x - Point<2>(middle) - xi[0] * by_x -
                               xi[1] * by_y - xi[0] * xi[1] * mixed;
        const Tensor<1, 2> a = by_x + xi[1] * mixed, b = by_y + xi[0] * mixed;
        const double       det = a[0] * b[1] - a[1] * b[0];
        Tensor<1, 2>       step;
        step[0] = (r[0] * b[1] - r[1] * b[0]) / det;
        step[1] = (a[0] * r[1] - a[1] * r[0]) / det;
        xi += step;
        if (step.norm() < 1e-14)
          break;
      }
    return xi;
  }
} // namespace Contact
