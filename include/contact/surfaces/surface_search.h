/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_search_h
#define contact_surface_search_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <functional>
#include <limits>

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  struct NormalCone;

  template<int dim>
  struct Projection;

  template<int dim>
  class SurfaceSearch;



  /**
   * The directions in which a place of a surface looks: the outward normal
   * there, and at a convex corner all those between the normals of the two
   * edges.
   */
  template<>
  struct NormalCone<2>
  {
    Tensor<1, 2> first, last; // of the edge before and the edge behind

    /// At an end of the surface, where the body has a side that is in no group:
    /// a face beside it counts if none is opposite.
    bool at_end = false;

    /// The normals of other sides that meet there: a face that is more opposite
    /// to one of them is theirs.
    std::vector<Tensor<1, 2>> others{};

    /// The distance beyond the end of a face up to which it looks [mm].
    double reach = std::numeric_limits<double>::max();

    /**
     * Faces whose normals are further from opposite than this do not face each
     * other [degrees]: the side of a body beside a place that looks past it,
     * which tilts as the body bulges, is no partner, while the flanks of a
     * wedge of 30 degrees still are to what its tip stands on. (Other codes
     * have limits from 40 degrees on; a length that is projected grows by
     * 1/cos, here 3.9.)
     */
    static constexpr double largest_angle = 75;

    static double smallest_cosine()
    {
      return std::cos(largest_angle * numbers::PI / 180);
    }

    /// Whether a facet of this outward normal is face to face.
    bool faces(const Tensor<1, 2> &normal) const;

    /// Whether it is at least not back to back.
    bool is_beside(const Tensor<1, 2> &normal) const;
  };



  /// The point of a surface that is closest to a point in space.
  template<>
  struct Projection<2>
  {
    unsigned int facet = numbers::invalid_unsigned_int;
    double       xi    = 0;

    /// The point lies beyond the end of a face.
    bool off_the_end = false;

    /// The projection of the normal lies outside the edge; xi is its nearer
    /// end.
    bool clipped = false;

    /// Another edge that is as close and meets this one, or invalid.
    unsigned int twin = numbers::invalid_unsigned_int;
  };



  /**
   * Closest-point queries on a deformed surface. The edges are kept in a tree
   * of their bounding boxes, and visited by the distance of their boxes until
   * no box can hold a closer point.
   */
  template<>
  class SurfaceSearch<2>
  {
  public:
    SurfaceSearch(const Surface<2> &surface, const GhostedVector &u);

    Projection<2> closest_point(const Point<2> &x) const;

    /// The closest of the points that face a place which looks in these
    /// directions; off the end if there is none.
    Projection<2> closest_facing(const Point<2>      &x,
                                 const NormalCone<2> &directions) const;

    /// The place of a projection.
    Point<2> position(const Projection<2> &projection) const;

    /// By facet of another surface, whether a point of it may be as close to
    /// this one as @p distance [mm]: false where the boxes that the facets are
    /// in are further apart.
    std::vector<bool> may_be_close(const SurfaceSearch<2> &other,
                                   const double            distance) const;

    /// The edges that may have a point in a box.
    std::vector<unsigned int> edges_in(const BoundingBox<2> &box) const;

    /// Three points whose triangle holds an edge with its overhang.
    std::array<Point<2>, 3> hull(const unsigned int edge) const;

    /// The outward unit normal of an edge.
    Tensor<1, 2> normal(const unsigned int edge, const double xi) const;

    /// The closest point of one edge, which at vertices goes on by @p extension
    /// in its coordinate, at ends of faces by the overhang.
    Projection<2> project(const Point<2>    &x,
                          const unsigned int edge,
                          const double       extension = 0) const;

    /// Squared distance of a point to its projection [mm^2].
    double distance_square(const Point<2>      &x,
                           const Projection<2> &projection) const;

    /**
     * The distance beyond the end of a face, in edge coordinates, at which a
     * point still counts as facing the last edge, extrapolated, and no further
     * than the same part of an edge of the slave. Points on a symmetry line or
     * over an edge of the other body sit exactly on the end, where the tilt of
     * the edge under load moves the projection of the normal to either side.
     */
    static constexpr double overhang = 0.1;

  private:
    using Box = BoundingBox<2>;

    using Accept = std::function<bool(const Projection<2> &)>;

    /// The closest point of those accepted; off the end if there is none.
    Projection<2> choose(const Point<2> &x, const Accept &accept) const;

    Projection<2> closest(const Point<2> &x, const Accept &accept) const;

    /**
     * Whether a surface that goes on smoothly at the end of an edge comes no
     * closer beyond it. Where it does and looks another way there, the end of
     * the edge is no projection: the point may be far off to the side, where
     * its distance along the normal says nothing.
     */
    bool is_closest_around(const Point<2>      &x,
                           const Projection<2> &candidate) const;

    /**
     * Beyond both faces that meet in a convex corner a point touches neither as
     * long as it is outside of one: the further one is what it may come to
     * touch. @p best is what is closest.
     */
    Projection<2> choose_at_corner(const Point<2>      &x,
                                   const Projection<2> &best,
                                   const Accept        &accept) const;

    /// The other edge at the end that xi is nearer to, if it is as close: which
    /// of the two was found first must not matter.
    unsigned int find_twin(const Point<2>      &x,
                           const Projection<2> &found,
                           const Accept        &accept) const;

    /// The edge at the end of another one that xi is nearer to, or invalid.
    unsigned int neighbor(const Projection<2> &projection) const;

    /// The coordinates of an edge, with the overhang at an end of a face.
    std::pair<double, double> coordinate_range(const unsigned int edge) const;

    std::array<Point<2>, 3> edge_positions(const unsigned int edge) const;

    const Surface<2>                   &surface;
    std::vector<Point<2>>               positions;
    RTree<std::pair<Box, unsigned int>> tree;
  };
} // namespace Contact

#endif
