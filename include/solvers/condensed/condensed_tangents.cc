/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/condensed_tangents.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constraint_entries.h"

namespace Contact
{
  CondensedTangents::CondensedTangents(
    const AffineConstraints<double> &lines,
    const AffineConstraints<double> &test_lines,
    Matrix                          &matrix)
    : lines(lines)
    , test_lines(test_lines)
    , matrix(matrix)
  {
  }



  bool CondensedTangents::follows(const Dof dof) const
  {
    const auto follows_by = [dof](const AffineConstraints<double> &of) {
      return of.is_constrained(dof) && !of.get_constraint_entries(dof)->empty();
    };
    return follows_by(lines) ||
           (&test_lines != &lines && follows_by(test_lines));
  }



  bool CondensedTangents::has_followers(const Dofs &dofs) const
  {
    return std::any_of(dofs.begin(), dofs.end(), [this](const Dof dof) {
      return follows(dof);
    });
  }



  void CondensedTangents::add(const FullMatrix<double> &tangent,
                              const Dofs               &rows,
                              const Dofs               &columns)
  {
    if (has_followers(rows) || (&rows != &columns && has_followers(columns)))
      locals.push_back({&tangent, &rows, &columns});
    add_free(tangent, rows, columns);
  }



  // Constrained rows get a diagonal as large as with the symmetric matrix.
  void CondensedTangents::add_free(const FullMatrix<double> &tangent,
                                   const Dofs               &rows,
                                   const Dofs               &columns)
  {
    std::array<std::vector<unsigned int>, 2> places;
    std::array<Dofs, 2>                      dofs;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const Dofs &all = k == 0 ? rows : columns;
        for (unsigned int i = 0; i < all.size(); ++i)
          if (!follows(all[i]))
            {
              places[k].push_back(i);
              dofs[k].push_back(all[i]);
            }
      }
    if (dofs[0].empty() || dofs[1].empty())
      return;
    FullMatrix<double> part(dofs[0].size(), dofs[1].size());
    part.extract_submatrix_from(tangent, places[0], places[1]);
    if (&rows != &columns)
      {
        test_lines.distribute_local_to_global(part,
                                              dofs[0],
                                              lines,
                                              dofs[1],
                                              matrix);
        return;
      }
    if (&lines == &test_lines)
      {
        lines.distribute_local_to_global(part, dofs[0], matrix);
        return;
      }
    test_lines.distribute_local_to_global(part,
                                          dofs[0],
                                          lines,
                                          dofs[0],
                                          matrix);
    for (unsigned int i = 0; i < dofs[0].size(); ++i)
      if (test_lines.is_constrained(dofs[0][i]))
        matrix.add(dofs[0][i], dofs[0][i], std::abs(part(i, i)));
  }



  void CondensedTangents::Sum::add(const unsigned int column,
                                   const double       value)
  {
    if (!is_used[column])
      {
        is_used[column] = true;
        used.push_back(column);
      }
    values[column] += value;
  }



  CondensedTangents::Row CondensedTangents::Sum::take()
  {
    Row row;
    row.reserve(used.size());
    for (const unsigned int column : used)
      {
        row.emplace_back(column, values[column]);
        values[column]  = 0;
        is_used[column] = false;
      }
    used.clear();
    return row;
  }



  unsigned int CondensedTangents::Columns::number(const Dof dof) const
  {
    return std::lower_bound(dofs.begin(), dofs.end(), dof) - dofs.begin();
  }



  CondensedTangents::Columns CondensedTangents::find_columns() const
  {
    Columns    columns;
    Dofs      &dofs        = columns.dofs;
    const auto make_unique = [&dofs]() {
      std::sort(dofs.begin(), dofs.end());
      dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
    };
    for (const Local &local : locals)
      dofs.insert(dofs.end(), local.columns->begin(), local.columns->end());
    make_unique();
    const Dofs of_locals = dofs;
    for (const Dof dof : of_locals)
      visit_leaders(lines, dof, [&dofs](const Dof leader, const double) {
        dofs.push_back(leader);
      });
    make_unique();

    columns.leaders.resize(dofs.size());
    for (const Dof dof : of_locals)
      {
        Row &row = columns.leaders[columns.number(dof)];
        visit_leaders(lines, dof, [&](const Dof leader, const double part) {
          row.emplace_back(columns.number(leader), part);
        });
      }
    return columns;
  }



  std::map<CondensedTangents::Dof, std::vector<CondensedTangents::Part>>
  CondensedTangents::find_rows() const
  {
    std::map<Dof, std::vector<Part>> found;
    for (unsigned int l = 0; l < locals.size(); ++l)
      {
        const Dofs &rows = *locals[l].rows;
        const bool  any  = has_followers(*locals[l].columns);
        for (unsigned int i = 0; i < rows.size(); ++i)
          if (any || follows(rows[i]))
            found[rows[i]].emplace_back(l, i);
      }
    return found;
  }



  CondensedTangents::Row
  CondensedTangents::condensed_row(const Dof                row,
                                   const std::vector<Part> &parts,
                                   const Columns           &columns,
                                   Sum                     &sum) const
  {
    const bool all = follows(row);
    for (const auto &[l, i] : parts)
      for (unsigned int j = 0; j < locals[l].columns->size(); ++j)
        if (const Dof dof = (*locals[l].columns)[j]; all || follows(dof))
          sum.add(columns.number(dof), (*locals[l].tangent)(i, j));
    for (const auto &[column, value] : sum.take())
      for (const auto &[leader, part] : columns.leaders[column])
        sum.add(leader, part * value);
    return sum.take();
  }



  void CondensedTangents::finish()
  {
    const Columns columns = find_columns();
    Sum           sum(columns.dofs.size());

    // By unknown, the rows that follow it.
    std::vector<Row>   rows;
    std::map<Dof, Row> rows_of;
    for (const auto &[row, parts] : find_rows())
      {
        const unsigned int k = rows.size();
        visit_leaders(test_lines,
                      row,
                      [&](const Dof leader, const double part) {
                        rows_of[leader].emplace_back(k, part);
                      });
        rows.push_back(condensed_row(row, parts, columns, sum));
        if (follows(row))
          for (const auto &[l, i] : parts)
            if (locals[l].rows == locals[l].columns)
              matrix.add(row, row, std::abs((*locals[l].tangent)(i, i)));
      }

    Dofs                dofs;
    std::vector<double> values;
    for (const auto &[leader, of_leader] : rows_of)
      {
        for (const auto &[k, part] : of_leader)
          for (const auto &[column, value] : rows[k])
            sum.add(column, part * value);
        dofs.clear();
        values.clear();
        for (const auto &[column, value] : sum.take())
          {
            dofs.push_back(columns.dofs[column]);
            values.push_back(value);
          }
        matrix.add(leader, dofs, values);
      }
    locals.clear();
  }
} // namespace Contact
