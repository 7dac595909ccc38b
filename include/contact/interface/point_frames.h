/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_frames_h
#define contact_point_frames_h

#include <map>
#include <memory>
#include <vector>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The points of one node: of the sides of a slave that meet there, and of
   * several contact pairs. Each of them is an equation for the displacement of
   * the node relative to what it faces, and no system may have an equation that
   * follows from others. So the points of a node share its directions, on one
   * body each time:
   *
   * 1. Glue holds the node in all directions. Other points of the node face
   *    nothing.
   * 2. Of points of a convex corner that face two facets with a convex edge
   *    between them, each behind the plane of the other, the one with the
   *    smaller gap faces nothing: a node is outside of a convex body where it
   *    is outside of one of its sides, as at a corner of a block that stands
   *    on another one and juts out over its edge.
   * 3. Points that face one smooth surface are *joined*: their normals are
   *    closer than half of Surface::feature_angle, as on curves that are drawn,
   *    however the groups of slave and master are cut. The first one has the
   *    mean of their equations, with their weights,
   *      C = sum_i w_i C_i / sum_i w_i,   w = sum_i w_i,
   *    as the dual function of the node over all of its facets has, and one
   *    pressure; the others face nothing. In results each of them has the
   *    pressure of the first one and its own part of the weight.
   * 4. Points that stick tell the slip of a node once each, as where a side of
   *    a tray holds a block that its floor holds, too, or a body stands on one
   *    body and beside another one. Such equations follow from each other, or
   *    contradict each other a little, and shear surfaces until they agree. So
   *    where points of a node face one body, or have other normals, and are
   *    closer to what they face than a tenth of an edge as the increment
   *    begins, springs of the stiffness c take the place of sticking
   *    (ContactPoint::is_in_an_edge), as on edges that supports hold. Their
   *    slip q/c vanishes with the size of the mesh. This depends on no status,
   *    and on no order of the points.
   */
  template<int dim>
  class PointFrames
  {
  public:
    using Pairs = std::vector<std::unique_ptr<const ContactPair<dim>>>;

    PointFrames() = default;

    /// The nodes with several of these @p points, which belong to @p pairs.
    PointFrames(const std::vector<ContactPoint<dim>> &points,
                const Pairs                          &pairs);

    /// Tell the contact pairs at which nodes their slaves go on with other
    /// sides, or other slaves do.
    void find_other_sides(const std::vector<ContactPoint<dim>>  &points,
                          const std::vector<ContactPair<dim> *> &to) const;

    /// The points that are joined, and the first of those each is joined to.
    using Joined = std::map<unsigned int, unsigned int>;

    /// Give all points their own pairings back, before they are paired. Returns
    /// the points that were joined.
    Joined part(std::vector<ContactPoint<dim>> &points) const;

    /// Take out what glue says and what convex edges hide of the points, which
    /// have been paired in the configuration @p u, and join the others.
    Joined join(std::vector<ContactPoint<dim>> &points,
                const GhostedVector            &u) const;

    /// Find the points of edges among those that touch what they face.
    void find_edges(std::vector<ContactPoint<dim>> &points,
                    const std::vector<bool>        &touches) const;

    /// The normal multiplier that is the pressure for which a point has the
    /// multiplier @p k: that, or the one of the point that it is joined to.
    unsigned int acting_multiplier(const std::vector<ContactPoint<dim>> &points,
                                   const unsigned int k) const;

    /// A point as it acts: with pairing, status and multipliers of the one it
    /// is joined to, and its own part of the weight.
    ContactPoint<dim> as_it_acts(const std::vector<ContactPoint<dim>> &points,
                                 const unsigned int                    q) const;

  private:
    void leave_hidden(std::vector<ContactPoint<dim>> &points,
                      const GhostedVector            &u) const;
    bool see_one_surface(const ContactPoint<dim> &a,
                         const ContactPoint<dim> &b) const;
    bool are_on_one_body(const ContactPoint<dim> &a,
                         const ContactPoint<dim> &b) const;
    bool have_common_facets(const ContactPoint<dim> &a,
                            const ContactPoint<dim> &b) const;
    void join_to_first(const std::vector<unsigned int> &joined,
                       std::vector<ContactPoint<dim>>  &points) const;

    const Pairs                                      *pairs = nullptr;
    std::vector<std::vector<unsigned int>>            points_at_nodes;
    std::map<unsigned int, std::vector<unsigned int>> others_at_node;
    std::map<unsigned int, unsigned int>              point_of_multiplier;
  };
} // namespace Contact

#endif
