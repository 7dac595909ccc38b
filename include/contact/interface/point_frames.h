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
   * 4. Points of a node hold each other where their rows are the same: on
   *    meshes that match, on a master that supports hold, on an obstacle.
   *    Normals come before tangents: along the normals of such others in
   *    contact a point does not slip, and has no shear. One that sticks holds
   *    the node in all directions: another one is not in contact unless it is
   *    moved into the other body. Where rows differ, each point has its own
   *    slip.
   * 5. Where the bodies that two points face touch each other there as well,
   *    the slip of one follows from the other two: normals come before tangents
   *    as in 4, and if all three stick the later point has no shear.
   * tangents_held_by_points() follows the active set.
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

    /// The points of nodes that have several.
    const std::map<unsigned int, std::vector<unsigned int>> &others() const
    {
      return others_at_node;
    }

    /// Whether another point of the node of a point, with the same row, sticks.
    template<typename StatusOf>
    bool sticks_at_node(const std::vector<ContactPoint<dim>> &points,
                        const unsigned int                    q,
                        const StatusOf                       &status_of) const;

    /// The directions along the tangents of the point @p q in which others in
    /// contact hold its node. Orthonormal. @p status_of gives the status of a
    /// point by its number.
    template<typename StatusOf>
    std::vector<Tensor<1, dim>>
    tangents_held_by_points(const std::vector<ContactPoint<dim>> &points,
                            const unsigned int                    q,
                            const StatusOf &status_of) const;

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
    bool have_one_row(const ContactPoint<dim> &a,
                      const ContactPoint<dim> &b) const;
    bool are_on_one_body(const ContactPoint<dim> &a,
                         const ContactPoint<dim> &b) const;
    /// The status in which a node that the point @p a faces touches the body
    /// that @p b faces: then three bodies meet there.
    template<typename StatusOf>
    Status third_of_ring(const std::vector<ContactPoint<dim>> &points,
                         const unsigned int                    a,
                         const unsigned int                    b,
                         const StatusOf                       &status_of) const;
    bool   gives_tangents_up(const ContactPoint<dim> &point) const;
    bool   have_common_facets(const ContactPoint<dim> &a,
                              const ContactPoint<dim> &b) const;
    void   join_to_first(const std::vector<unsigned int> &joined,
                         std::vector<ContactPoint<dim>>  &points) const;

    const Pairs                                       *pairs = nullptr;
    std::map<NodeDoFs<dim>, std::vector<unsigned int>> at_node; // of all
    std::vector<std::vector<unsigned int>>             at_nodes;
    std::map<unsigned int, std::vector<unsigned int>>  others_at_node;
    std::map<unsigned int, unsigned int>               point_of_multiplier;
  };



  template<int dim>
  template<typename StatusOf>
  bool
  PointFrames<dim>::sticks_at_node(const std::vector<ContactPoint<dim>> &points,
                                   const unsigned int                    q,
                                   const StatusOf &status_of) const
  {
    const auto of_node = others_at_node.find(q);
    return of_node != others_at_node.end() &&
           std::any_of(of_node->second.begin(),
                       of_node->second.end(),
                       [&](const unsigned int other) {
                         return status_of(other).kind == Status::stick &&
                                have_one_row(points[q], points[other]);
                       });
  }



  template<int dim>
  template<typename StatusOf>
  std::vector<Tensor<1, dim>> PointFrames<dim>::tangents_held_by_points(
    const std::vector<ContactPoint<dim>> &points,
    const unsigned int                    q,
    const StatusOf                       &status_of) const
  {
    std::vector<Tensor<1, dim>> held;
    const auto                  of_node = others_at_node.find(q);
    if (of_node == others_at_node.end())
      return held;
    const ContactPoint<dim> &of      = points[q];
    const auto               hold_in = [&](const Tensor<1, dim> &direction) {
      add_orthonormal(of.along_tangents(of.tangential_part(direction)), held);
    };
    for (const unsigned int other : of_node->second)
      if (status_of(other).kind != Status::open)
        {
          const Status ring =
            std::max(third_of_ring(points, q, other, status_of),
                     third_of_ring(points, other, q, status_of));
          if (ring != Status::open ||
              (gives_tangents_up(of) && have_one_row(of, points[other])))
            hold_in(points[other].normal);
          if (ring == Status::stick && other < q &&
              status_of(other).kind == Status::stick)
            for (const Tensor<1, dim> &tangent : points[other].tangents)
              hold_in(tangent);
        }
    return held;
  }



  template<int dim>
  template<typename StatusOf>
  Status
  PointFrames<dim>::third_of_ring(const std::vector<ContactPoint<dim>> &points,
                                  const unsigned int                    a,
                                  const unsigned int                    b,
                                  const StatusOf &status_of) const
  {
    Status                   third = Status::open;
    const ContactPoint<dim> &of_a  = points[a];
    if (!are_on_one_body(of_a, points[b]))
      for (unsigned int k = of_a.n_slave_nodes; k < of_a.n_nodes; ++k)
        if (const auto there = at_node.find(of_a.dofs(k));
            there != at_node.end())
          for (const unsigned int q : there->second)
            if (are_on_one_body(points[q], points[b]))
              third = std::max(third, status_of(q).kind);
    return third;
  }
} // namespace Contact

#endif
