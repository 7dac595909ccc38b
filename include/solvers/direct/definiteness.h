/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_definiteness_h
#define contact_definiteness_h

#include <utility>
#include <vector>

namespace Contact
{
  /// Whether x . A x > 0 for all x but zero: A has @p n compressed rows. Asked
  /// of CHOLMOD; false as well if memory does not suffice.
  bool has_definite_symmetric_part(const int           n,
                                   const int *const    starts,
                                   const int *const    columns,
                                   const double *const values);

  /// The columns and values of each row of a square matrix; those of one place
  /// add up.
  using SparseRows = std::vector<std::vector<std::pair<unsigned int, double>>>;

  /**
   * Whether x . A x > 0 for all x but zero with B x = 0, where
   *   | A  C |
   *   | B  D |
   * is @p matrix; @p is_constraint says of each of its rows whether that is one
   * of B. Rows of B that are zero constrain nothing.
   *
   * It is so exactly if the symmetric part of A + gamma B^T B is positive
   * definite for one gamma, and then for all that are larger (P. Finsler,
   * Comment. Math. Helv. 9, 1937). Here rows of B are of length one and gamma
   * is a thousand times the largest diagonal entry of A: constraints yield by a
   * thousandth of what the stiffest element does, and thirteen digits are left
   * to tell soft bodies from unstable ones.
   */
  bool is_definite_under_constraints(const SparseRows        &matrix,
                                     const std::vector<bool> &is_constraint);
} // namespace Contact

#endif
