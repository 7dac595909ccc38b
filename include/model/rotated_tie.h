/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rotated_tie_h
#define contact_rotated_tie_h

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Glued points stick along the normals and tangents of the undeformed
   * surfaces, for a condition in all directions may be written along any.
   * Results want those of now: while an object of this class lives, they are
   * turned with the normals of the slave, and the multipliers in @p solution
   * are the components of the same tractions along them. Then all is as before,
   * to the last bit. In small strain nothing turns, and
   * a preload is along the drawn normals. Not of the Gauss-point
   * discretization, whose multipliers belong to no normal.
   */
  template<int dim>
  class RotatedTie
  {
  public:
    RotatedTie(const ContactModel<dim> &model, GhostedVector &solution);

    RotatedTie(const RotatedTie &)            = delete;
    RotatedTie &operator=(const RotatedTie &) = delete;

    ~RotatedTie();

  private:
    void rotate(const ContactPair<dim>         &contact_pair,
                std::vector<ContactPoint<dim>> &points);

    ContactInterface<dim> *const   interface;
    GhostedVector                 &solution;
    std::vector<ContactPoint<dim>> drawn; // empty: nothing turns

    /// The multipliers that are others now.
    std::vector<std::pair<types::global_dof_index, double>> multipliers;
  };
} // namespace Contact

#endif
