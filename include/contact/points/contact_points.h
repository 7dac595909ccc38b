/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_points_h
#define contact_contact_points_h

#include "contact/obstacles/obstacle.h"
#include "contact/points/contact_point.h"
#include "contact/points/friction_law.h"
#include "contact/surfaces/deformed_surface.h"

namespace Contact
{
  using namespace dealii;

  /// Slave surface nodes -> multipliers, which not every node has to carry.
  struct MultiplierSpace
  {
    /// Multiplier of each slave node, or numbers::invalid_unsigned_int.
    std::vector<unsigned int> of_node;
    unsigned int              n_multipliers = 0;
  };



  /**
   * The nodal discretization: one point per slave node, mid-sides included,
   * weighted by the integral of its shape function (of rings, times the
   * circumference where that has its centroid, which is exact on straight
   * edges); the constraint is collocated. Without the nodes in @p excluded. On
   * an axis at degree 2 the integral vanishes: what holds the node there is a
   * force, with a weight for its units only.
   */
  template<int dim>
  std::vector<ContactPoint<dim>>
  make_nodal_points(const Surface<dim>           &slave,
                    const std::set<unsigned int> &excluded,
                    MultiplierSpace              &multipliers);

  /// The share of a facet in the weight of a nodal point at its node @p a.
  double share_of_node(const Surface<2>  &slave,
                       const unsigned int facet,
                       const unsigned int a);
  double share_of_node(const Surface<3>  &slave,
                       const unsigned int facet,
                       const unsigned int a);

  /**
   * The Gauss-point discretization: @p n_points quadrature points per slave
   * edge, multipliers at the nodes, interpolated along the edge; the constraint
   * is the weak one.
   */
  std::vector<ContactPoint<2>> make_gauss_points(const Surface<2>  &slave,
                                                 const unsigned int n_points,
                                                 MultiplierSpace &multipliers);

  /**
   * The orthonormal directions, in the frame of the tangents, in which supports
   * leave a point free to slip: none in 2-D where the tangential row lies
   * in the span of the normal one once the unknowns that a support fixes are
   * out; in 3-D one across a component of the displacement that supports
   * prescribe of all its nodes, none across two.
   */
  std::vector<Tensor<1, 1>>
  free_slips(const ContactPoint<2>      &point,
             const DiscretizedBodies<2> &discretization);
  std::vector<Tensor<1, 2>>
  free_slips(const ContactPoint<3>      &point,
             const DiscretizedBodies<3> &discretization);

  /// Whether supports leave no direction of slip.
  template<int dim>
  bool has_no_free_tangent(const ContactPoint<dim>      &point,
                           const DiscretizedBodies<dim> &discretization)
  {
    return free_slips(point, discretization).empty();
  }

  /**
   * The slip [mm] of a point, by tangent, in the directions that supports do
   * not leave free, while its gap stays: it follows from their @p motion, and
   * from that of an obstacle. Zero where all are free.
   */
  Tensor<1, 1> prescribed_slip(const ContactPoint<2>      &point,
                               const DiscretizedBodies<2> &discretization,
                               const GhostedVector        &motion);
  Tensor<1, 2> prescribed_slip(const ContactPoint<3>      &point,
                               const DiscretizedBodies<3> &discretization,
                               const GhostedVector        &motion);

  /// Whether supports leave one of the first @p n_nodes nodes of a point free
  /// to move along @p normal, other than by round-off of its coefficient.
  template<int dim>
  bool is_free_along(const ContactPoint<dim>      &point,
                     const unsigned int            n_nodes,
                     const Tensor<1, dim>         &normal,
                     const DiscretizedBodies<dim> &discretization);

  /**
   * A point whose nodes are held on both sides has no unknown for its pressure
   * to act on: it does not face the master. The pressure is missed only if the
   * supports press the bodies into each other.
   */
  template<int dim>
  void skip_where_held(ContactPoint<dim>            &point,
                       const DiscretizedBodies<dim> &discretization,
                       const GhostedVector          &u);

  /**
   * Across a plane of symmetry of both bodies a point does not slip, and its
   * normal is along the plane: the facets around it are those of one side only,
   * and their mean with their images is. The plane is one that supports hold
   * the slave node across, and a node of the master alike that is in the same
   * place within @p tolerance [mm]. Not of a surface that lies in 2-D;
   * one that meets it at a slant has its own normal, too, with an edge between
   * it and its image, and no slip up the slant.
   * The tangents, and the springs of the rim.
   */
  void make_symmetric(ContactPoint<3>            &point,
                      const DiscretizedBodies<3> &discretization,
                      const GhostedVector        &u,
                      const double                tolerance);

  /// Mark where what supports hold of the slave ends. A node there that sticks
  /// gives no way. Where the master has fewer in such a row it could not
  /// follow, and shears would alternate between their bounds.
  void mark_dirichlet_edges(const Surface<3>             &slave,
                            const MultiplierSpace        &multipliers,
                            const DiscretizedBodies<3>   &discretization,
                            std::vector<ContactPoint<3>> &points);

  inline void mark_dirichlet_edges(const Surface<2> &,
                                   const MultiplierSpace &,
                                   const DiscretizedBodies<2> &,
                                   std::vector<ContactPoint<2>> &)
  {
  }

  /// The current position of the place on the slave.
  template<int dim>
  Point<dim> slave_position(const ContactPoint<dim> &point,
                            const GhostedVector     &u);

  /// Make the tangents perpendicular to the normal: in 2-D n turned by 90
  /// degrees, in 3-D those that there are, turned with the normal.
  void set_tangents(ContactPoint<2> &point);
  void set_tangents(ContactPoint<3> &point);

  /// The directions in which a point of the slave looks for the master.
  template<int dim>
  NormalCone<dim> directions_of(const ContactPoint<dim>    &point,
                                const DeformedSurface<dim> &slave);

  /// The manner in which points are paired.
  struct PairingMode
  {
    /// Compute the derivatives of the pairing, which the tangent needs.
    bool with_derivatives = false;

    /// In 3-D open points of the mortar discretization may keep an earlier
    /// pairing where the surfaces around them do not touch each other and their
    /// gap is still positive: that they stay open is all that is asked of them.
    bool keeps_open_points = false;

    /// The same on a mesh whose first pairing this is, under a solution of a
    /// coarser one: those that are further from the master than the size of a
    /// facet face nothing.
    bool leaves_far_points = false;

    /// The surfaces are where they were: pair those that have kept theirs, and
    /// leave all others as they are.
    bool is_rest = false;
  };



  /// Pair a point that looks in these directions with the closest point of the
  /// master in the configuration @p u.
  template<int dim>
  void pair_with_master(ContactPoint<dim>            &point,
                        const NormalCone<dim>        &directions,
                        const DeformedSurface<dim>   &master,
                        const DiscretizedBodies<dim> &discretization,
                        const GhostedVector          &u);

  /// The master side of a point at its projection: nodes and coefficients, with
  /// their derivatives in 2-D, normal and tangents. In 3-D a point of several
  /// nodes has the nodes that these face in the @p directions, with the
  /// coefficients of both.
  void face_master(ContactPoint<2>            &point,
                   const Projection<2>        &projection,
                   const NormalCone<2>        &directions,
                   const DeformedSurface<2>   &master,
                   const DiscretizedBodies<2> &discretization,
                   const GhostedVector        &u);
  void face_master(ContactPoint<3>            &point,
                   const Projection<3>        &projection,
                   const NormalCone<3>        &directions,
                   const DeformedSurface<3>   &master,
                   const DiscretizedBodies<3> &discretization,
                   const GhostedVector        &u);

  /// The same on a rigid obstacle.
  template<int dim>
  void pair_with_obstacle(ContactPoint<dim>            &point,
                          const Obstacle<dim>          &obstacle,
                          const DiscretizedBodies<dim> &discretization,
                          const GhostedVector          &u);
} // namespace Contact

#endif
