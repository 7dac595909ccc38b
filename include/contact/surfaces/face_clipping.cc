/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/face_clipping.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "contact/surfaces/surface.h"

namespace Contact
{
  namespace
  {
    using Polygon = boost::container::small_vector<Point<2>, 12>;



    /// Twice the area of the triangle o, a, b; positive if it is
    /// counterclockwise.
    double twice_area(const Point<2> &o, const Point<2> &a, const Point<2> &b)
    {
      return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }



    double area(const Polygon &polygon)
    {
      double area = 0;
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += 0.5 * twice_area(polygon[0], polygon[i], polygon[i + 1]);
      return area;
    }



    /// Counterclockwise round its corners, of which the last two of a
    /// quadrangle are the other way round in deal.II.
    Polygon make_polygon(const PlaneFacet &facet)
    {
      Polygon polygon(facet.begin(), facet.end());
      if (polygon.size() == 4)
        std::swap(polygon[2], polygon[3]);
      if (area(polygon) < 0)
        std::reverse(polygon.begin() + 1, polygon.end());
      return polygon;
    }



    /// What of a polygon is to the left of the line from @p a to @p b.
    Polygon clip(const Polygon &polygon, const Point<2> &a, const Point<2> &b)
    {
      Polygon left;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          const Point<2> &x = polygon[i],
                         &y = polygon[(i + 1) % polygon.size()];
          const double of_x = twice_area(a, b, x), of_y = twice_area(a, b, y);
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
  PlaneTriangles intersection(const PlaneFacet &a, const PlaneFacet &b)
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
    PlaneTriangles triangles;
    for (std::size_t i = 0; i < common.size(); ++i)
      {
        const PlaneTriangle triangle{
          {middle, common[i], common[(i + 1) % common.size()]}};
        if (area(triangle) > least)
          triangles.push_back(triangle);
      }
    return triangles;
  }



  // A triangle is half of a parallelogram.
  BilinearMap::BilinearMap(const PlaneFacet &facet)
    : BilinearMap(facet[0],
                  facet[1],
                  facet[2],
                  facet.size() == 4 ? facet[3]
                                    : facet[1] + (facet[2] - facet[0]))
  {
  }



  BilinearMap::BilinearMap(const Point<2> &a,
                           const Point<2> &b,
                           const Point<2> &c,
                           const Point<2> &d)
    : middle(0.25 * (a + (b - Point<2>()) + (c - Point<2>()) +
                     (d - Point<2>()) - Point<2>()))
    , by_x(0.25 * ((b - a) + (d - c)))
    , by_y(0.25 * ((c - a) + (d - b)))
    , mixed(0.25 * ((d - c) - (b - a)))
    , bend((std::abs(cross(by_x, mixed)) + std::abs(cross(mixed, by_y))) /
           std::abs(cross(by_x, by_y)))
  {
  }



  // Newton's method from the middle. After a step the rest of the equation is
  // the product of its components by the mixed term: nothing of a
  // parallelogram.
  Point<2> BilinearMap::coordinates_of(const Point<2> &x,
                                       const Point<2> &start) const
  {
    const double       round_off = 1e-17;
    const Tensor<1, 2> from      = x - Point<2>(middle);
    Point<2>           xi        = start;
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        const Tensor<1, 2> r =
          from - xi[0] * by_x - xi[1] * by_y - xi[0] * xi[1] * mixed;
        const Tensor<1, 2> a = by_x + xi[1] * mixed, b = by_y + xi[0] * mixed;
        const double       det = cross(a, b);
        Tensor<1, 2>       step;
        step[0] = cross(r, b) / det;
        step[1] = cross(a, r) / det;
        xi += step;
        if (bend * std::abs(step[0] * step[1]) < round_off)
          break;
      }
    return xi;
  }



  double BilinearMap::jacobian(const Point<2> &xi) const
  {
    return std::abs(cross(by_x + xi[1] * mixed, by_y + xi[0] * mixed));
  }
} // namespace Contact
