/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_search_h
#define contact_face_search_h

#include "contact/surfaces/surface_search.h"

namespace Contact
{
  using namespace dealii;

  /// The directions in which a place of a surface in space looks: the outward
  /// normal there, and at a corner those of all facets.
  template<>
  struct NormalCone<3>
  {
    std::vector<Tensor<1, 3>> normals;

    /// See NormalCone<2>.
    bool                      at_end = false;
    double                    reach  = std::numeric_limits<double>::max();
    std::vector<Tensor<1, 3>> others;

    /// Whether a facet of this outward normal is face to face.
    bool faces(const Tensor<1, 3> &normal) const;

    /// Whether it is at least not back to back.
    bool is_beside(const Tensor<1, 3> &normal) const;
  };



  /// The point of a surface in space that is closest to a point.
  template<>
  struct Projection<3>
  {
    unsigned int facet = numbers::invalid_unsigned_int;
    Point<2>     xi;

    /// The point lies beyond the end of a face.
    bool off_the_end = false;

    /// The projection of the normal lies outside the facet; xi is on its
    /// boundary.
    bool clipped = false;

    /// The other facets that have the same closest point, and where.
    std::vector<std::pair<unsigned int, Point<2>>> twins;
  };



  /// Closest-point queries on a deformed surface in space, as those of
  /// SurfaceSearch<2>: a tree of the bounding boxes of the quadrangles.
  template<>
  class SurfaceSearch<3>
  {
  public:
    SurfaceSearch(const Surface<3> &surface, const GhostedVector &u);

    Projection<3> closest_point(const Point<3> &x) const;

    /// The same without its twins.
    Projection<3> closest_alone(const Point<3> &x) const;

    /// The place of a projection.
    Point<3> position(const Projection<3> &projection) const;

    /// The closest of the points that face a place which looks in these
    /// directions; off the end if there is none.
    Projection<3> closest_facing(const Point<3>      &x,
                                 const NormalCone<3> &directions) const;

    /// The facets that may have a point in a box.
    std::vector<unsigned int> facets_in(const BoundingBox<3> &box) const;

    /// By facet of another surface, whether a point of it may be as close to
    /// this one as @p distance [mm]: false where the boxes that the facets are
    /// in are further apart.
    std::vector<bool> may_be_close(const SurfaceSearch<3> &other,
                                   const double            distance) const;

    /// The outward unit normal of a facet.
    Tensor<1, 3> normal(const unsigned int facet, const Point<2> &xi) const;

    /// The closest point of one facet, which at sides goes on by @p extension
    /// in its coordinates, at ends of faces by the overhang.
    Projection<3> project(const Point<3>    &x,
                          const unsigned int facet,
                          const double       extension = 0) const;

    /// Squared distance of a point to its projection [mm^2].
    double distance_square(const Point<3>      &x,
                           const Projection<3> &projection) const;

    /// See SurfaceSearch<2>.
    static constexpr double overhang = 0.1;

  private:
    using Box    = BoundingBox<3>;
    using Accept = std::function<bool(const Projection<3> &)>;
    using Nodes  = PerFacetNode<3, Point<3>>;

    /// The closest point of those accepted; off the end if there is none.
    Projection<3> choose(const Point<3> &x, const Accept &accept) const;
    Projection<3> closest(const Point<3> &x, const Accept &accept) const;

    /// Whether a surface that goes on smoothly beyond the side of a facet where
    /// the projection is clipped comes no closer there.
    bool is_closest_around(const Point<3>      &x,
                           const Projection<3> &candidate) const;

    void find_twins(const Point<3> &x,
                    const Accept   &accept,
                    Projection<3>  &found) const;

    /// The interval of a coordinate of a facet, with the overhang at an end of
    /// a face.
    std::pair<double, double> range(const unsigned int facet,
                                    const unsigned int k,
                                    const double       extension) const;

    /// Newton's method for the closest point, along both coordinates or one.
    Point<2> minimize(const Point<3>            &x,
                      const Nodes               &nodes,
                      Point<2>                   xi,
                      const std::array<bool, 2> &is_free) const;

    /// A box that a facet is in, with its overhang, however it bends.
    Box hull(const unsigned int facet, const Nodes &nodes) const;

    Nodes facet_positions(const unsigned int facet) const;

    const Surface<3>                   &surface;
    std::vector<Point<3>>               positions;
    std::vector<Box>                    hulls;
    RTree<std::pair<Box, unsigned int>> tree;
  };
} // namespace Contact

#endif
