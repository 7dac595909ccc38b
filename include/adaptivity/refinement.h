/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_refinement_h
#define contact_refinement_h

#include "contact/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// Throw InputError if the mesh can not be refined cell by cell: deal.II can
  /// not do so with triangles.
  void check_adaptive(const Mesh &mesh);

  /// Flag the cells with the largest indicators, which together have the share
  /// @p fraction of their sum (Doerfler's marking).
  void flag_cells(Mesh                &mesh,
                  const Vector<float> &indicators,
                  const double         fraction);

  /**
   * Flag the cells at the boundaries @p slave that face a flagged cell at the
   * boundaries @p master and would be coarser than what becomes of that: for
   * the nodal discretization, where the nodes of a finer master dent between
   * those of the slave, and no pairing stays.
   */
  void flag_slave_like_master(Mesh                               &mesh,
                              const std::set<types::boundary_id> &slave,
                              const std::set<types::boundary_id> &master);

  /// Flag the cells with the largest indicators, by the fraction of the
  /// parameters, and the slaves of nodal contact pairs that would become
  /// coarser than their masters.
  void flag_by_indicators(const ContactModel    &model,
                          const Parameters::All &parameters,
                          const Vector<float>   &indicators);

  /// Flag all cells.
  void flag_all_cells(Mesh &mesh);

  /**
   * Refine the flagged cells, number the unknowns anew, and interpolate the
   * displacements at the beginning of all @p solutions, which lose what was
   * behind. Every rank holds them in full, before and after.
   */
  void refine_and_transfer(Mesh                        &mesh,
                           Discretization              &discretization,
                           std::vector<Vector<double>> &solutions);
} // namespace Contact

#endif
