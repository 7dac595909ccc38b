/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_formula_h
#define contact_formula_h

#include <deal.II/base/point.h>

#include <functional>
#include <string>

namespace Contact
{
  using namespace dealii;

  /**
   * A formula of the user's, as a function of its variables, whose names are
   * separated by commas: what deal.II's FunctionParser understands, with pi.
   * Throws std::runtime_error with the reason if it cannot be read, and the
   * function an InputError that names the @p entry where its value is no number
   * or infinite, as of sqrt(-1) or 1/0.
   */
  template<int n_variables>
  std::function<double(const Point<n_variables> &)>
  parse_formula(const std::string &formula,
                const std::string &variables,
                const std::string &entry);

  /// The same of the place, and of the load factor as the last variable.
  template<int dim>
  std::function<double(const Point<dim> &, const double)>
  parse_formula_in_time(const std::string &formula,
                        const std::string &variables,
                        const std::string &entry);

  /**
   * A function of the load factor t: a formula in t, or a table <code>table(t0
   * f0, t1 f1, ...)</code> with growing t, linear in between and constant
   * before the first and after the last pair. Throws as parse_formula() does.
   */
  std::function<double(const Point<1> &)>
  parse_history(const std::string &history, const std::string &entry);

  /// A length above zero [mm], or with "%" a share of a @p whole; of an empty
  /// text zero. Throws std::runtime_error if it cannot be read.
  double parse_length(const std::string &length, const double whole);

  /// Whether a history is meant to be a table.
  bool is_table(const std::string &history);
} // namespace Contact

#endif
