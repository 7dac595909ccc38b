/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/row_elimination.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  double RowElimination::Row::operator[](const Dof dof) const
  {
    const auto found = entries.find(dof);
    return found == entries.end() ? 0. : found->second;
  }



  double RowElimination::Row::largest() const
  {
    double largest = 0;
    for (const auto &entry : entries)
      largest = std::max(largest, std::abs(entry.second));
    return largest;
  }



  void RowElimination::Row::drop_round_off()
  {
    const double smallest = std::numeric_limits<double>::epsilon() * largest();
    const auto   rest =
      std::remove_if(entries.begin(), entries.end(), [&](const auto &entry) {
        return std::abs(entry.second) < smallest;
      });
    entries.erase(rest, entries.end());
  }



  RowElimination::RowElimination(const std::set<Dof> &usual)
    : usual(usual)
  {
  }



  void RowElimination::clear()
  {
    known.clear();
    users.clear();
  }



  // The line of what is replaced is by unknowns that are not eliminated: once
  // is enough.
  void RowElimination::substitute(Row &in, const Dof what, const Row &by)
  {
    const auto   entry = in.entries.find(what);
    const double c     = entry->second;
    in.entries.erase(entry);
    in.constant += c * by.constant;

    Row::Entries sum;
    sum.reserve(in.entries.size() + by.entries.size());
    auto next = in.entries.begin();
    for (const auto &[other, coefficient] : by.entries)
      {
        for (; next != in.entries.end() && next->first < other; ++next)
          sum.insert(sum.end(), *next);
        double value = c * coefficient;
        if (next != in.entries.end() && next->first == other)
          value += (next++)->second;
        sum.emplace_hint(sum.end(), other, value);
      }
    for (; next != in.entries.end(); ++next)
      sum.insert(sum.end(), *next);
    in.entries = std::move(sum);
  }



  void RowElimination::reduce(Row &equation) const
  {
    // In an equation the constant is on the other side.
    equation.constant  = -equation.constant;
    const auto entries = equation.entries;
    for (const auto &entry : entries)
      if (const auto line = known.find(entry.first); line != known.end())
        substitute(equation, entry.first, line->second);
    equation.constant = -equation.constant;
  }



  std::set<RowElimination::Dof> RowElimination::take_users(const Dof dof)
  {
    std::set<Dof> of_dof;
    if (usual.count(dof) == 0)
      {
        for (const auto &[pivot, line] : known)
          if (line.entries.count(dof) > 0)
            of_dof.insert(pivot);
      }
    else if (const auto found = users.find(dof); found != users.end())
      {
        of_dof = std::move(found->second);
        users.erase(found);
      }
    return of_dof;
  }



  void RowElimination::eliminate(const Dof pivot, const Row &equation)
  {
    const double scale = equation[pivot];
    Row          line;
    line.constant = equation.constant / scale;
    line.entries  = equation.entries;
    line.entries.erase(pivot);
    for (auto &entry : line.entries)
      entry.second = -(entry.second / scale);

    std::set<Dof> changed = take_users(pivot);
    line.drop_round_off();
    for (const auto user : changed)
      {
        Row &of_user = known.at(user);
        if (of_user.entries.count(pivot) == 0)
          continue;
        substitute(of_user, pivot, line);
        of_user.drop_round_off();
      }
    changed.insert(pivot);
    for (const auto &entry : line.entries)
      if (usual.count(entry.first) > 0)
        users[entry.first].insert(changed.begin(), changed.end());
    known[pivot] = std::move(line);
  }
} // namespace Contact
