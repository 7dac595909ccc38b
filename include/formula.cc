/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "formula.h"

#include <deal.II/base/function_parser.h>

#include <memory>
#include <stdexcept>

namespace Contact
{
  namespace
  {
    /// A comma outside of parentheses makes two formulas, of which the parser
    /// would take the last one: so of a decimal comma.
    bool is_list(const std::string &formula)
    {
      int depth = 0;
      for (const char c : formula)
        {
          depth += (c == '(') - (c == ')');
          if (c == ',' && depth == 0)
            return true;
        }
      return false;
    }
  } // namespace



  template<int n_variables>
  std::function<double(const Point<n_variables> &)>
  parse_formula(const std::string &formula, const std::string &variables)
  {
    if (is_list(formula))
      throw std::runtime_error("'" + formula + "' is no formula in " +
                               variables);
    const auto parser = std::make_shared<FunctionParser<n_variables>>(1);
    try
      {
        parser->initialize(variables, formula, {{"pi", numbers::PI}});
        parser->value(Point<n_variables>()); // here it is read
      }
    catch (const dealii::ExceptionBase &)
      {
        throw std::runtime_error("'" + formula + "' is no formula in " +
                                 variables);
      }
    return [parser](const Point<n_variables> &p) { return parser->value(p); };
  }



  template std::function<double(const Point<1> &)>
  parse_formula<1>(const std::string &, const std::string &);
  template std::function<double(const Point<2> &)>
  parse_formula<2>(const std::string &, const std::string &);
} // namespace Contact
