/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_corner_points_h
#define contact_corner_points_h

#include "contact/points/contact_points.h"
#include "contact/surfaces/body_overlap.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Points of the reversed direction, at the convex corners and the ends of a
   * master; in 3-D at its vertices, where ends of faces meet that do not
   * continue each other.
   *
   * The discretizations look from the nodes of the slave, or in the mean along
   * its edges: a corner of the master between two slave nodes they do not see,
   * or only when it is deep inside. So each such corner has a contact point of
   * its own, which is a nodal one with the roles exchanged: its place is the
   * vertex of the master, its projection is on the slave, and its normal is
   * that of the slave edge, out of the slave. What a ContactPoint says, in
   * particular the signs of gap, pressure and shear, holds as it stands, with
   * the other body first: p and q are the same seen from either side. The
   * kernel, friction, the search of the active set and both linear systems need
   * not know. (Vertex to segment, as in G. Zavarise and L. De Lorenzis, Int. J.
   * Numer. Meth. Engng. 79, 2009, 379-416, but at corners only: at all nodes of
   * both sides it would be over-constrained.)
   *
   * Its multiplier is one more, with its own unknown: the vertex would be
   * weighted so as a slave node. It is a force, singular at a sharp corner as
   * the theory of elasticity has it, not a pressure that a mesh resolves.
   *
   * A corner is what Surface::feature_angle says, of the curves that the edges
   * stand for (the vertices of an arc are none, however few they are). Where
   * the surface ends, the body may have a corner there, too, as a block on a
   * longer one has, or may go on flat: either way the vertex may not get inside
   * of the slave. A slave node that slides off the end of the master loses its
   * partner while the edge beside it is still supported, and where the slave
   * has a single node opposite, one pressure cannot balance a moment: the point
   * at the end sees both.
   *
   * The points are there from the start, and what follows from others is
   * inactive: the condition of a corner that lies on a flat edge whose nodes
   * are in contact as well follows from theirs, to round-off. It is met up to
   * @ref corner_slack, so that such a point stays open.
   */
  template<int dim>
  std::vector<ContactPoint<dim>> make_corner_points(const Surface<dim> &master);

  /// The depth, by the length of the slave edge, that a corner may have: above
  /// all round-off of the pairing, below all depths that matter.
  constexpr double corner_slack = 1e-8;

  /// The distance of a corner that is paired from the slave [mm].
  template<int dim>
  double distance(const ContactPoint<dim> &corner, const GhostedVector &u);

  /**
   * Pair corner points with the slave in the configuration @p u.
   *
   * They face nothing at the end of a face of the slave, where corners of both
   * bodies stand on each other and a slave node sees the master.
   */
  template<int dim>
  void pair_corner_points(const ArrayView<ContactPoint<dim>> &corners,
                          const DeformedSurface<dim>         &master,
                          const DeformedSurface<dim>         &slave,
                          const BodyOverlap<dim>             &bodies,
                          const DiscretizedBodies<dim>       &discretization,
                          const GhostedVector                &u);

  /**
   * The slave node that the projection of a corner is at, closer than a
   * hundredth of half an edge, or invalid. There a nodal point of that node and
   * the corner would say the same twice. The corner is the one to keep: as the
   * bodies slide, it carries on, while a node beside it lifts off.
   */
  template<int dim>
  unsigned int node_at_foot(const ContactPoint<dim> &corner,
                            const Surface<dim>      &slave);
} // namespace Contact

#endif
