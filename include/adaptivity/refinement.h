/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_refinement_h
#define contact_refinement_h

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// Throw InputError if the mesh cannot be refined cell by cell: deal.II can
  /// not do so with triangles.
  template<int dim>
  void check_adaptive(const Mesh<dim> &mesh);

  /**
   * Flag the cells with the largest indicators, which together have the share
   * @p fraction of their sum (Doerfler's marking), and those whose indicators
   * differ from the smallest of these by less than a thousandth: cells that
   * symmetry makes alike differ by what Newton's tolerance leaves (5e-5 with
   * friction), and by other amounts on another number of processes. An estimate
   * is not as exact as a thousandth.
   */
  template<int dim>
  void flag_cells(Mesh<dim>           &mesh,
                  const Vector<float> &indicators,
                  const double         fraction);

  /**
   * Flag the cells at the boundaries @p slave that face a flagged cell at the
   * boundaries @p master and would be coarser than what becomes of that: for
   * the nodal discretization, where the nodes of a finer master dent between
   * those of the slave, and no pairing stays.
   */
  template<int dim>
  void flag_slave_like_master(Mesh<dim>                          &mesh,
                              const std::set<types::boundary_id> &slave,
                              const std::set<types::boundary_id> &master);

  /**
   * The fraction theta that leads to an accuracy by the fewest unknowns of all
   * levels together, if the indicators are shares of the error by the accepted
   * one. Refined, a cell has 2^-2p of its share left. With a part s of the
   * cells the unknowns grow by g = 1 + 3 s and the error by r = 1 - theta (1 -
   * 2^-2p): it takes n = log R / log (1/r) levels, R twice the sum of the
   * indicators, and g + g^2 + ... + g^n = g (g^n - 1)/(g - 1) times the
   * unknowns. At least 0.8, by trial: with few cells at a time the error falls
   * by less than that. On one rank.
   */
  double cheapest_fraction(const Vector<float> &indicators,
                           const unsigned int   degree);

  /// Flag the cells with the largest indicators, by the fraction of the
  /// parameters, and the slaves of nodal contact pairs that would become
  /// coarser than their masters.
  template<int dim>
  void flag_by_indicators(const ContactModel<dim> &model,
                          const Parameters::All   &parameters,
                          const Vector<float>     &indicators);

  /**
   * Of contact pairs that do not touch, flag the cells at either surface where
   * these are closer than the facets of the slave are long: no estimate of an
   * error knows that finer ones, which follow a round side, will touch there.
   */
  template<int dim>
  void flag_close_surfaces(const ContactModel<dim> &model,
                           const Parameters::All   &parameters,
                           const GhostedVector     &solution);

  /// Flag all cells. Collective.
  template<int dim>
  void flag_all_cells(Mesh<dim> &mesh);

  /**
   * Refine the flagged cells, number the unknowns anew, and interpolate the
   * displacements at the beginning of all @p solutions, which lose what was
   * behind. Collective.
   */
  template<int dim>
  void refine_and_transfer(Mesh<dim>                  &mesh,
                           Discretization<dim>        &discretization,
                           std::vector<GhostedVector> &solutions);
} // namespace Contact

#endif
