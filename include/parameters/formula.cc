/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/formula.h"

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <boost/io/ios_state.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "base/errors.h"

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



    /// The parser's message on a formula, without deal.II's preamble.
    std::string reason(const dealii::ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      const std::string text = Utilities::trim(info.str()), said = "said: ";
      const auto        position = text.find(said);
      return position == std::string::npos
               ? text
               : text.substr(position + said.size());
    }

    template<int dim>
    std::shared_ptr<FunctionParser<dim>> parser_of(const std::string &formula,
                                                   const std::string &variables,
                                                   const bool         in_time)
    {
      const auto fail = [&](const std::string &reason) {
        throw std::runtime_error("'" + formula + "' is no formula in " +
                                 variables + ": " + reason);
      };
      if (Utilities::trim(formula).empty())
        fail("it is empty");
      if (is_list(formula))
        fail("there is a comma outside of parentheses");
      const auto parser = std::make_shared<FunctionParser<dim>>(1);
      try
        {
          // deal.II prints what it also throws.
          std::ostringstream               printed;
          const boost::io::ios_rdbuf_saver saver(std::cerr, printed.rdbuf());
          parser->initialize(variables,
                             formula,
                             {{"pi", numbers::PI}},
                             in_time);
          parser->value(Point<dim>()); // here it is read
        }
      catch (const dealii::ExceptionBase &exception)
        {
          fail(reason(exception));
        }
      return parser;
    }



    /// The value of a formula, which has to be a finite number.
    template<typename... Place>
    double checked(const double       value,
                   const std::string &formula,
                   const std::string &variables,
                   const std::string &entry,
                   const Place &...place)
    {
      if (!std::isfinite(value))
        {
          std::ostringstream at;
          ((at << place << ' '), ...);
          throw InputError("'" + formula + "' is " +
                             (std::isnan(value) ? "not a number" : "infinite") +
                             " at " + variables + " = " +
                             Utilities::trim(at.str()),
                           "entry '" + entry + "'",
                           "write a formula that has a finite value there");
        }
      return value;
    }
  } // namespace



  template<int n_variables>
  std::function<double(const Point<n_variables> &)>
  parse_formula(const std::string &formula,
                const std::string &variables,
                const std::string &entry)
  {
    const auto parser =
      parser_of<n_variables>(formula, variables, /*in_time=*/false);
    return [parser, formula, variables, entry](const Point<n_variables> &p) {
      return checked(parser->value(p), formula, variables, entry, p);
    };
  }



  template<int dim>
  std::function<double(const Point<dim> &, const double)>
  parse_formula_in_time(const std::string &formula,
                        const std::string &variables,
                        const std::string &entry)
  {
    const auto parser = parser_of<dim>(formula, variables, /*in_time=*/true);
    return
      [parser, formula, variables, entry](const Point<dim> &p, const double t) {
        parser->set_time(t);
        return checked(parser->value(p), formula, variables, entry, p, t);
      };
  }



  double parse_length(const std::string &length, const double whole)
  {
    if (length.empty())
      return 0;
    std::istringstream text(length);
    double             value = 0;
    text >> value >> std::ws;
    const bool is_share = text.peek() == '%';
    text.ignore(is_share) >> std::ws;
    if (!(value > 0) || !std::isfinite(value) || !text.eof())
      throw std::runtime_error("'" + length + "' is no length above 0");
    return is_share ? value / 100 * whole : value;
  }



  bool is_table(const std::string &history)
  {
    const std::string text = Utilities::trim(history);
    return text.compare(0, 5, "table") == 0;
  }



  std::function<double(const Point<1> &)>
  parse_history(const std::string &history, const std::string &entry)
  {
    if (!is_table(history))
      return parse_formula<1>(history, "t", entry);

    const std::string text = Utilities::trim(history);
    const auto        fail = [&](const std::string &reason) {
      throw std::runtime_error("'" + text + "' is no table: " + reason);
    };

    const std::string in_brackets = Utilities::trim(text.substr(5));
    if (in_brackets.size() < 2 || in_brackets.front() != '(' ||
        in_brackets.back() != ')')
      fail("its pairs are not in parentheses");

    std::vector<double> times, values;
    std::istringstream  pairs(in_brackets.substr(1, in_brackets.size() - 2) +
                             ',');
    std::string         pair;
    while (std::getline(pairs, pair, ','))
      {
        pair = Utilities::trim(pair);
        std::istringstream words(pair);
        double             t, value;
        std::string        rest;
        if (!(words >> t >> value) || words >> rest)
          fail("'" + pair + "' is not two numbers");
        if (!times.empty() && !(t > times.back()))
          fail("t does not grow at '" + pair + "'");
        times.push_back(t);
        values.push_back(value);
      }

    return [times, values](const Point<1> &p) {
      const auto next = std::upper_bound(times.begin(), times.end(), p[0]);
      if (next == times.begin())
        return values.front();
      if (next == times.end())
        return values.back();
      const auto   i = next - times.begin();
      const double s = (p[0] - times[i - 1]) / (times[i] - times[i - 1]);
      return (1 - s) * values[i - 1] + s * values[i];
    };
  }



  template std::function<double(const Point<1> &)>
  parse_formula<1>(const std::string &,
                   const std::string &,
                   const std::string &);
  template std::function<double(const Point<3> &)>
  parse_formula<3>(const std::string &,
                   const std::string &,
                   const std::string &);
  template std::function<double(const Point<2> &)>
  parse_formula<2>(const std::string &,
                   const std::string &,
                   const std::string &);
  template std::function<double(const Point<2> &, const double)>
  parse_formula_in_time<2>(const std::string &,
                           const std::string &,
                           const std::string &);
  template std::function<double(const Point<3> &, const double)>
  parse_formula_in_time<3>(const std::string &,
                           const std::string &,
                           const std::string &);
} // namespace Contact
