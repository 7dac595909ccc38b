/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_corner_sides_h
#define contact_corner_sides_h

#include "contact/points/slave_corners.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Points of the nodal discretization for all sides of a corner of the slave.
   *
   * A nodal point has one normal, that of the closest place of the master. In a
   * concave corner that another body's edge is pressed into, or at an edge in a
   * concave corner of the master, two faces of the master are in contact with
   * one node of the slave, in three dimensions up to three: with one point the
   * body would give way to the second face, and which of them is the second one
   * would be a matter of the way there. (The mortar discretization has its own:
   * MortarDiscretization::parted_nodes(), in the plane.)
   *
   * So a node at a corner has one more point for each side of the slave that
   * meets there, which looks along the normal of its side and sees the faces of
   * the master that are more opposite to it than to the other sides. They face
   * nothing but where the node sees at least two faces that make a corner. Then
   * the node's own point is the one of the side that is left: no side has two,
   * and which has which stays as the bodies slide. A point of a side is a
   * ContactPoint as any other; its multiplier belongs to no node.
   */
  template<int dim>
  class CornerSides
  {
  public:
    /// Find the corners of @p slave among the nodes that have @p points, and
    /// append the points of their sides, with multipliers of their own.
    void add_points(const Surface<dim>             &slave,
                    MultiplierSpace                &multipliers,
                    std::vector<ContactPoint<dim>> &points);

    /// Pair the points of a contact pair, whose own points have been paired
    /// already; @p search is on the master, @p normals are those of the slave,
    /// by Surface::facet_normals().
    void pair(const ArrayView<ContactPoint<dim>> &points,
              const Surface<dim>                 &slave,
              const Surface<dim>                 &master,
              const SurfaceSearch<dim>           &search,
              const FacetNormals<dim>            &normals,
              const Discretization<dim>          &discretization,
              const GhostedVector                &u,
              const bool                          keeps_facets) const;

    bool is_empty() const
    {
      return nodes.empty();
    }

    /// Of the points of a node, whose own is the one given, those that say what
    /// a point at this place says that looks along @p normal: all of them, if
    /// there is no corner.
    std::vector<unsigned int>
    same_as(const ArrayView<ContactPoint<dim>> &points,
            const unsigned int                  own,
            const Tensor<1, dim>               &normal) const;

    struct Node : public SlaveCorner
    {
      unsigned int first; // point, of the first side

      std::vector<std::vector<bool>> is_concave; // by two sides
    };

    std::vector<Node> nodes;
  };
} // namespace Contact

#endif
