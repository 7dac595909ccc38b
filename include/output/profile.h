/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_profile_h
#define contact_profile_h

#include <string>
#include <vector>

#include "contact/interface/contact_interface.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// The state of contact at one node of a surface: a row of the profile, from
  /// which all curves over the contact zone are plotted.
  template<int dim>
  struct ProfileRow
  {
    // From the first row of the surface along its nodes [mm].
    double arc_length          = 0;
    double deformed_arc_length = 0;

    Point<dim>     X; // reference position [mm]
    Tensor<1, dim> u; // displacement [mm]

    double pressure    = 0; // multiplier, positive in compression [MPa]
    double shear       = 0; // multiplier; on the slave along t [MPa]
    double nodal_force = 0; // normal force [N per mm of thickness]
    double gap         = 0; // [mm], negative: penetration
    double slip        = 0; // of this increment [mm]; in 3-D, like shear,
                            // the magnitude

    /// In 3-D shear and slip as vectors.
    Tensor<1, dim> shear_vector, slip_vector;

    /// 0 open, 1 slip, 2 stick; -1: nothing can touch here, because the node
    /// carries no contact point or faces nothing.
    int status = -1;

    /// -n.sigma.n from the recovered stress of the surface's own body and its
    /// deformed outward normal n [MPa].
    double extrapolated_pressure = 0;

    /// The pressure by deformed area [MPa].
    double true_pressure = 0;
  };



  /// The rows of both surfaces of a contact pair.
  template<int dim>
  struct PairProfile
  {
    std::string                  name; // of the contact pair
    const Surface<dim>          *slave;
    std::vector<ProfileRow<dim>> slave_rows, master_rows;
  };



  /**
   * The profile of the slave surface of a contact pair, one row per node in the
   * order of Surface::nodes. Here the multipliers live: pressure and shear are
   * their values, the nodal force is sum over the points of w psi_k p for the
   * multiplier k of the node. Gap and slip are those of the node itself; with
   * the Gauss-point discretization, whose points lie elsewhere, the node is
   * paired on its own, and its status is the strongest one (stick, slip, open)
   * among the points that its multiplier acts on.
   *
   * @p vertex_stresses are by vertex of the triangulation, @p u_start is the
   * solution at the start of the increment.
   */
  template<int dim>
  std::vector<ProfileRow<dim>>
  slave_profile(const ContactInterface<dim>              &interface,
                const ContactPair<dim>                   &contact_pair,
                const Discretization<dim>                &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start);

  /**
   * The profile of the master surface of a contact pair, empty on an obstacle.
   * A master node has no contact values of its own: it gets those of the place
   * of the deformed slave surface that is closest, interpolated between the
   * rows of @p slave there; the status is that of the nearest slave node. Where
   * the slave does not reach, all of them are zero and the status is -1. The
   * nodal force is the sum over the points of what they put on the node, w p
   * times the node's share.
   *
   * In 2-D the rows begin at the last node of the master, and so do the
   * arc lengths: two surfaces that face each other run in opposite directions,
   * because each has its body to the left, and the profiles shall run alike.
   */
  template<int dim>
  std::vector<ProfileRow<dim>>
  master_profile(const ContactInterface<dim>              &interface,
                 const ContactPair<dim>                   &contact_pair,
                 const Discretization<dim>                &discretization,
                 const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                 const GhostedVector                      &solution,
                 const std::vector<ProfileRow<dim>>       &slave);

  /// The profiles of all contact pairs, of their masters only with @p
  /// with_masters.
  template<int dim>
  std::vector<PairProfile<dim>>
  pair_profiles(const ContactInterface<dim>              &interface,
                const Discretization<dim>                &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start,
                const bool                                with_masters);
} // namespace Contact

#endif
