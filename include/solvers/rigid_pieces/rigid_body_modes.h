/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rigid_body_modes_h
#define contact_rigid_body_modes_h

#include <map>
#include <string>
#include <vector>

#include "contact/interface/contact_interface.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// A rigid motion of a piece of a body that nothing resists.
  struct RigidBodyMode
  {
    unsigned int piece; // see MeshPieces
    std::string  name;  // as in "displacement in x with rotation"
    unsigned int n;     // how many motions that are: if all are free three, in
                        // 3-D six
  };



  /// A rigid motion about a centre, at a place @p arm away from it:
  /// displacements along the axes, then rotations by one [1], in 3-D about
  /// the axes.
  inline Tensor<1, 2> rigid_motion(const unsigned int  motion,
                                   const Tensor<1, 2> &arm)
  {
    return motion < 2 ? Tensor<1, 2>(Point<2>::unit_vector(motion))
                      : Tensor<1, 2>({-arm[1], arm[0]});
  }

  inline Tensor<1, 3> rigid_motion(const unsigned int  motion,
                                   const Tensor<1, 3> &arm)
  {
    return motion < 3
             ? Tensor<1, 3>(Point<3>::unit_vector(motion))
             : cross_product_3d(Tensor<1, 3>(Point<3>::unit_vector(motion - 3)),
                                arm);
  }



  /// The points in contact that resist motions along their tangents, besides
  /// those of glue: none; those that stick; all of them; or no others, and then
  /// those of glue are the only ones that resist any motion.
  enum class Tangents
  {
    free,
    by_status,
    stuck,
    glued
  };



  /// The rotations of bodies, by their number.
  template<int dim>
  using Rotations = std::map<types::material_id, Tensor<2, dim>>;



  /**
   * The pieces of the bodies that something could move without resistance, and
   * their motions: supports hold them, ties, the nodes that they have in common
   * with other pieces, and, unless @p interface is null, the points in contact
   * along their normals and, as @p tangents says, along their tangents.
   *
   * Each piece has three rigid motions, in 3-D six. A resisted direction is a
   * row over those of all pieces: the displacement there, or the difference of
   * the displacements of the two pieces that touch, are tied or share a node,
   * so that two pieces that hold but each other are both free. What is free is
   * the null space of the sum of the rows' squares. Bodies that have turned far
   * are where their @p rotations bring them. Collective.
   */
  template<int dim>
  std::vector<RigidBodyMode>
  rigid_body_modes(const Discretization<dim>   &discretization,
                   const ContactInterface<dim> *interface,
                   const Tangents               tangents  = Tangents::by_status,
                   const Rotations<dim>        &rotations = {});

  /**
   * Check that every piece of a body is held, or can come to be: by supports,
   * or by contact if it has a surface that may touch another body. Throws
   * InputError with the name of the body, the place of the piece if the body
   * has several, and a motion that is free. Collective.
   */
  template<int dim>
  void check_supports(const Discretization<dim>   &discretization,
                      const ContactInterface<dim> *interface);
} // namespace Contact

#endif
