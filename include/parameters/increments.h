/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_increments_h
#define contact_increments_h

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <string>
#include <vector>

namespace Contact::Parameters
{
  using namespace dealii;

  /// The load increments: a number of equal ones, or the load factors t [-]
  /// where they end, ascending to 1.
  class Increments
  {
  public:
    explicit Increments(const unsigned int n)
      : n(n)
    {
    }

    /// From an entry: a whole number alone is that of them, else numbers
    /// separated by ',' are where they end.
    explicit Increments(const std::string &text)
    {
      for (const std::string &end : Utilities::split_string_list(text, ','))
        ends.push_back(Utilities::string_to_double(end));
      n = ends.size();
      if (n == 1 && ends[0] >= 1 && ends[0] == std::floor(ends[0]))
        {
          n = static_cast<unsigned int>(ends[0]);
          ends.clear();
        }
    }

    /// In order, above 0, and the last one at 1.
    bool are_ascending() const
    {
      double last = 0;
      for (const double end : ends)
        {
          if (!(end > last))
            return false;
          last = end;
        }
      return ends.empty() || last == 1;
    }

    unsigned int size() const
    {
      return n;
    }

    /// The load factor behind @p k increments, of which the last one need not
    /// be whole.
    double at(const double k) const
    {
      if (ends.empty())
        return k / n;
      const auto   whole = static_cast<unsigned int>(k);
      const double from  = whole == 0 ? 0. : ends[whole - 1];
      return whole == n ? 1. : from + (k - whole) * (ends[whole] - from);
    }

    /// Each cut in two.
    Increments doubled() const
    {
      Increments finer(2 * n);
      for (unsigned int k = 1; k <= 2 * n && !ends.empty(); ++k)
        finer.ends.push_back(at(0.5 * k));
      return finer;
    }

    /// As the entry has it.
    std::string text() const
    {
      if (ends.empty())
        return std::to_string(n);
      std::string list;
      for (const double end : ends)
        list += (list.empty() ? "" : ", ") +
                Patterns::Tools::Convert<double>::to_string(end);
      return list;
    }

  private:
    unsigned int        n = 1;
    std::vector<double> ends; // of equal ones none
  };
} // namespace Contact::Parameters



namespace dealii::Patterns::Tools
{
  /// For ParameterHandler::add_parameter().
  template<>
  struct Convert<Contact::Parameters::Increments>
  {
    using Increments = Contact::Parameters::Increments;

    static std::unique_ptr<PatternBase> to_pattern()
    {
      return std::make_unique<List>(Double(0), 1);
    }

    static std::string
    to_string(const Increments &increments,
              const PatternBase & = *Convert<Increments>::to_pattern())
    {
      return increments.text();
    }

    static Increments
    to_value(const std::string &text,
             const PatternBase & = *Convert<Increments>::to_pattern())
    {
      return Increments(text);
    }
  };
} // namespace dealii::Patterns::Tools

#endif
