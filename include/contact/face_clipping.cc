/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_clipping.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

namespace Contact
{
  namespace
  {
    namespace bg  = boost::geometry;
    using Vertex  = bg::model::d2::point_xy<double>;
    using Polygon = bg::model::polygon<Vertex>;



    /// Round its corners.
    Polygon make_polygon(const PlaneQuadrangle &corners)
    {
      Polygon polygon;
      for (const unsigned int a : {0, 1, 3, 2, 0})
        bg::append(polygon.outer(), Vertex(corners[a][0], corners[a][1]));
      bg::correct(polygon);
      return polygon;
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



  // A convex polygon is the triangles between its centroid and its sides.
  std::vector<PlaneTriangle> intersection(const PlaneQuadrangle &a,
                                          const PlaneQuadrangle &b)
  {
    const Polygon        first = make_polygon(a), second = make_polygon(b);
    std::vector<Polygon> common;
    bg::intersection(first, second, common);
    const double least =
      1e-12 * std::min(std::abs(bg::area(first)), std::abs(bg::area(second)));

    std::vector<PlaneTriangle> triangles;
    for (const Polygon &polygon : common)
      {
        if (std::abs(bg::area(polygon)) <= least)
          continue;
        Vertex centre(0, 0);
        bg::centroid(polygon, centre);
        const auto &ring = polygon.outer();
        for (std::size_t i = 0; i + 1 < ring.size(); ++i)
          {
            const PlaneTriangle triangle{
              {Point<2>(centre.x(), centre.y()),
               Point<2>(ring[i].x(), ring[i].y()),
               Point<2>(ring[i + 1].x(), ring[i + 1].y())}};
            if (area(triangle) > least)
              triangles.push_back(triangle);
          }
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
