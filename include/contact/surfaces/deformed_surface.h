/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_deformed_surface_h
#define contact_deformed_surface_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <optional>

#include "contact/surfaces/facet_projection.h"
#include "contact/surfaces/normal_cone.h"

namespace Contact
{
  using namespace dealii;

  /// The point of a surface that is closest to a point in 3-D.
  template<int dim>
  struct Projection
  {
    unsigned int    facet = numbers::invalid_unsigned_int;
    FacetPoint<dim> xi{};

    /// The point lies beyond the end of a face.
    bool beyond_end = false;

    /// The projection of the normal lies outside the facet; xi is on its
    /// boundary.
    bool clipped = false;

    /// Other facets that meet this one and are as close, and where: see
    /// DeformedSurface::find_twins().
    std::vector<std::pair<unsigned int, FacetPoint<dim>>> twins;
  };



  /**
   * A surface where its nodes are in one state: their positions, the normals,
   * and closest-point queries. The facets are kept in a tree of the boxes of
   * their control points, and visited by the distance of these until no box can
   * hold a closer point. Tree and normals are made when they are first asked
   * for.
   */
  template<int dim>
  class DeformedSurface
  {
  public:
    /// In the configuration @p u; of an empty vector the undeformed one. Faces
    /// go on beyond their ends by @p overhang.
    DeformedSurface(const Surface<dim>  &surface,
                    const GhostedVector &u,
                    const double         overhang = DeformedSurface::overhang)
      : DeformedSurface(surface, surface.positions(u), overhang)
    {
    }

    /// With its nodes at @p positions.
    DeformedSurface(const Surface<dim>            &surface,
                    const std::vector<Point<dim>> &positions,
                    const double                   overhang);

    const Surface<dim> &surface;

    /// Of the nodes [mm].
    const std::vector<Point<dim>> positions;

    /// A place of a facet.
    Point<dim> position(const unsigned int     facet,
                        const FacetPoint<dim> &xi) const;

    /// The outward unit normal there.
    Tensor<1, dim> normal(const unsigned int     facet,
                          const FacetPoint<dim> &xi) const
    {
      return facet_normal<dim>(*surface.facets[facet].kind,
                               facet_positions(facet),
                               xi);
    }

    /// The outward unit normals at the nodes: the mean of those of the facets
    /// that meet there.
    std::vector<Tensor<1, dim>> normals() const;

    /// The same by facet: at corners the normal of the facets on its side
    /// alone.
    const FacetNormals<dim> &facet_normals() const;

    Projection<dim> closest_point(const Point<dim> &x) const
    {
      return choose(x, [](const Projection<dim> &) { return true; });
    }

    /// The same without its twins.
    Projection<dim> closest_alone(const Point<dim> &x) const
    {
      return closest(x, [](const Projection<dim> &) { return true; });
    }

    /// The closest of the points that face a place which looks in these
    /// directions; off the end if there is none.
    Projection<dim> closest_facing(const Point<dim>      &x,
                                   const NormalCone<dim> &directions) const;

    /// By facet of another surface, whether a point of it may be as close to
    /// this one as @p distance [mm]: false where the boxes that the facets are
    /// in are further apart.
    std::vector<bool> may_be_close(const DeformedSurface<dim> &other,
                                   const double                distance) const;

    /// The facets that may have a point in a box, in ascending order.
    std::vector<unsigned int> facets_in(const BoundingBox<dim> &box) const;

    /// The control points of a facet with its overhang, as of a surface of
    /// Bezier: it lies within their convex hull, however it bends.
    std::vector<Point<dim>> hull(const unsigned int facet) const;

    /// The closest point of one facet, which goes on at ends of faces by the
    /// overhang.
    Projection<dim> project(const Point<dim>  &x,
                            const unsigned int facet) const;

    /// Whether the surface ends at the side of a facet that a projection is on.
    bool is_at_end(const Projection<dim> &projection) const;

    /// Whether a point is behind the facet of its projection, and behind the
    /// twins: at a convex edge it is behind all facets that meet there. In
    /// front by up to @p slack [mm] is behind.
    bool is_behind(const Point<dim>      &x,
                   const Projection<dim> &projection,
                   const double           slack) const;

    /// Squared distance of a point to its projection [mm^2].
    double distance_square(const Point<dim>      &x,
                           const Projection<dim> &projection) const
    {
      return x.distance_square(position(projection.facet, projection.xi));
    }

    /**
     * The distance beyond the end of a face, in facet coordinates, at which a
     * point still counts as facing the last facet, extrapolated, and no further
     * than the same part of a facet of the slave. Points on a symmetry line or
     * over an edge of the other body sit exactly on the end, where the tilt of
     * the facet under load moves the projection of the normal to either side.
     */
    static constexpr double overhang = 0.1;

  private:
    using Box    = BoundingBox<dim>;
    using Tree   = RTree<std::pair<Box, unsigned int>>;
    using Accept = std::function<bool(const Projection<dim> &)>;

    /// Whether a facet may have places that are accepted.
    using MayAccept = std::function<bool(const unsigned int facet)>;

    static bool all_facets(const unsigned int)
    {
      return true;
    }

    /// The closest point of those accepted; off the end if there is none.
    Projection<dim> choose(const Point<dim> &x,
                           const Accept     &accept,
                           const MayAccept  &may_accept = all_facets) const;

    Projection<dim> closest(const Point<dim> &x,
                            const Accept     &accept,
                            const MayAccept  &may_accept = all_facets) const;

    /// By facet.
    const std::vector<DirectionRange<dim>> &normal_ranges() const;

    /**
     * Whether a surface that goes on smoothly beyond the side of a facet where
     * the projection is clipped comes no closer there. Where it does and looks
     * another way there, the side is no projection: the point may be far off to
     * it, where its distance along the normal says nothing.
     */
    bool is_closest_around(const Point<dim>      &x,
                           const Projection<dim> &candidate) const;

    /**
     * In 2-D, beyond both faces that meet in a convex corner a point
     * touches neither as long as it is outside of one: the further one is what
     * it may come to touch. @p best is what is closest.
     */
    Projection<dim> choose_at_corner(const Point<dim>      &x,
                                     const Projection<dim> &best,
                                     const Accept          &accept) const;

    /**
     * Find the facets beside a projection that are as close: which of them was
     * found first must not matter. In 2-D the other edge at the end that
     * xi is nearer to, wherever its closest point is, so that both sides of a
     * hollow count alike; in 3-D those with the same closest point.
     */
    void find_twins(const Point<dim> &x,
                    const Accept     &accept,
                    Projection<dim>  &found) const;

    /// The extent of a facet, with the overhang at an end of a face.
    typename FacetKind<dim>::Limits limits(const unsigned int facet) const;

    FacetNodes<dim> facet_positions(const unsigned int facet) const;

    const Tree &tree() const;

    const double                                            beyond_ends;
    mutable std::optional<Tree>                             boxes;
    mutable std::optional<FacetNormals<dim>>                of_facets;
    mutable std::optional<std::vector<DirectionRange<dim>>> ranges;
  };
} // namespace Contact

#endif
