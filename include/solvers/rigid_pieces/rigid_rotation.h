/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rigid_rotation_h
#define contact_rigid_rotation_h

#include <vector>

#include "contact/interface/contact_interface.h"
#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The rigid motions of the bodies, each about the middle of its box, by the
   * unknowns that this rank owns, see rigid_motion(). As a
   * whole they are three, in 3-D six, for all bodies together: the aggregates
   * of a multigrid do not reach from body to body except where these touch.
   */
  template<int dim>
  std::vector<std::vector<double>>
  rigid_modes(const Discretization<dim> &discretization);

  /**
   * The rigid rotation of each piece (MeshPieces) in the linear theory, in
   * 3-D its magnitude: the omega [rad] of the motion a + omega x (X - c),
   * c the centre of mass, that is closest to the displacement @p u in the mean
   * of the squares over the piece, by the corners of its cells. Collective.
   */
  template<int dim>
  std::vector<double> rigid_rotations(const Discretization<dim> &discretization,
                                      const GhostedVector       &u);



  /**
   * A piece that can turn in itself: nothing but contact holds it, without
   * friction and on circles about one centre C, and the loads on it do no work
   * as it turns about C. What it touches pushes along normals that go through
   * C: the rotation is not resisted, and nothing excites it either, the piece
   * stays as it is. Not so on a mesh: the corners of polygons resist, and in
   * small strain, where turning lengthens, contact drives the piece round until
   * it has parted.
   */
  struct SpinningPiece
  {
    unsigned int  piece;
    GhostedVector rotation; // e_z x (X - C) at its nodes, zero elsewhere [mm]
    double        radius;   // of a circle that it touches on [mm]
  };

  /// All such pieces of bodies in 2-D; those in 3-D that can turn about an axis
  /// or a point are not found. Collective.
  template<int dim>
  std::vector<SpinningPiece>
  turning_pieces(const Discretization<dim>   &discretization,
                 const Elasticity<dim>       &elasticity,
                 const ContactInterface<dim> &interface);

  /// Take the rigid rotations of these pieces out of @p u. Collective.
  template<int dim>
  void remove_rotations(const Discretization<dim>        &discretization,
                        const std::vector<SpinningPiece> &pieces,
                        GhostedVector                    &u);



  /**
   * Check that no piece that supports and glue leave free turns further than
   * small strain can mean. There a rotation by omega lengthens a body by
   * sqrt(1 + omega^2) - 1, about omega^2/2, which is no strain in this theory
   * but moves its surface all the same. Beyond the larger one of
   *   - a tenth of the largest strain of the piece, sqrt(s : D^-1 : s / E):
   *     what is left out is no small part of what is computed,
   *   - 1e-3, the strain at which metals yield (omega = 2.6 degrees): below
   *     it, an unstrained body that moves aside is where it should be to a
   *     thousandth of its size,
   * the result means nothing: throws NotConverged with the name of the piece
   * and the angle. Does nothing with large displacements. Collective.
   */
  template<int dim>
  void check_rotations(const Discretization<dim>   &discretization,
                       const Elasticity<dim>       &elasticity,
                       const ContactInterface<dim> *interface,
                       const GhostedVector         &u);
} // namespace Contact

#endif
