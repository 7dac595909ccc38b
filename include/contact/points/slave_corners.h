/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_slave_corners_h
#define contact_slave_corners_h

#include <deal.II/base/array_view.h>

#include "contact/points/contact_points.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A corner of the slave: a node at which several of its sides meet, in the
   * plane two, at a vertex of a body in space three.
   *
   * The weight of a nodal point is the integral of the node's shape function
   * over the surface, with which a force becomes a pressure. At a corner, the
   * sides that do not look at the master have no part in it: where a block
   * stands on flat ground and its group has the sole and the sides, the
   * pressure at the edge of the sole is the force by the share of the sole
   * alone.
   */
  struct SlaveCorner
  {
    /// A side of a corner: its facets at the node, the number of the node in
    /// the first one, and the part of the node's weight.
    struct Side
    {
      std::vector<unsigned int> facets;
      unsigned int              a      = 0;
      double                    weight = 0;

      unsigned int facet() const
      {
        return facets[0];
      }
    };

    unsigned int      node; // of the slave
    unsigned int      own;  // its point
    std::vector<Side> sides;

    /// The normal of a side, of those by Surface::facet_normals().
    template<int dim>
    const Tensor<1, dim> &normal_of(const Side              &side,
                                    const FacetNormals<dim> &normals) const
    {
      return normals[side.facet()][side.a];
    }

    /**
     * The weight of the sides that look at a master with the @p normal: all of
     * that of the side most opposite to it, and of a side that is less so by an
     * angle a the part 1 - a / Surface::feature_angle, none from there on. On a
     * face of the master that lies along a side this is that side alone, for
     * sides part by more than that angle; where the corner points at the master
     * it is all of them; and as a body tips over it changes without a jump.
     */
    template<int dim>
    double weight_towards(const Tensor<1, dim>    &normal,
                          const FacetNormals<dim> &normals) const;

    /// The part of one side in that.
    template<int dim>
    double part_of(const Side              &side,
                   const Tensor<1, dim>    &normal,
                   const FacetNormals<dim> &normals) const;
  };

  /// The corners of @p slave among the nodes that have nodal @p points.
  template<int dim>
  std::vector<SlaveCorner>
  find_corners(const Surface<dim>                   &slave,
               const MultiplierSpace                &multipliers,
               const std::vector<ContactPoint<dim>> &points);

  /// Give the nodal points at corners, which have been paired, their weights.
  template<int dim>
  void weigh(const std::vector<SlaveCorner>     &corners,
             const FacetNormals<dim>            &normals,
             const ArrayView<ContactPoint<dim>> &points);
} // namespace Contact

#endif
