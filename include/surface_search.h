/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_search_h
#define contact_surface_search_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include "surface.h"

namespace Contact
{
  using namespace dealii;

  /// The point of a surface that is closest to a point in space.
  struct Projection
  {
    unsigned int edge;
    double       xi;

    /// The point lies before the first or behind the last edge of the chain.
    bool off_the_end;

    /// The foot of the normal lies outside the edge; xi is its nearer end.
    bool clipped;
  };



  /**
   * Closest-point queries on a deformed surface. The edges are kept in a tree
   * of their bounding boxes, and visited by the distance of their boxes until
   * no box can hold a closer point.
   */
  class SurfaceSearch
  {
  public:
    SurfaceSearch(const Surface &surface, const Vector<double> &u);

    Projection closest_point(const Point<2> &x) const;

    /// The closest point of one edge.
    Projection project(const Point<2> &x, const unsigned int edge) const;

    /// Squared distance of a point to its projection [mm^2].
    double distance_square(const Point<2>   &x,
                           const Projection &projection) const;

    /**
     * How far beyond the end of the surface, in edge coordinates, a point still
     * counts as facing the last edge, extrapolated. Points on a symmetry line
     * sit exactly on the end, where the tilt of the edge under load moves the
     * foot of the normal to either side.
     */
    static constexpr double overhang = 0.1;

  private:
    using Box = BoundingBox<2>;

    /// The coordinates of an edge, with the overhang at an end of the surface.
    std::pair<double, double> coordinate_range(const unsigned int edge) const;

    std::array<Point<2>, 3> edge_positions(const unsigned int edge) const;

    const Surface                      &surface;
    std::vector<Point<2>>               positions;
    RTree<std::pair<Box, unsigned int>> tree;
  };
} // namespace Contact

#endif
