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
   * Throws std::runtime_error with the reason if it can not be read.
   */
  template<int n_variables>
  std::function<double(const Point<n_variables> &)>
  parse_formula(const std::string &formula, const std::string &variables);
} // namespace Contact

#endif
