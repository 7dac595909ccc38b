/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/surface_projection.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <numeric>

#include "base/exchange.h"

namespace Contact
{
  template<typename Number>
  void SurfaceProjection<Number>::initialize(const SurfaceRows &lines,
                                             const Vector      &inverse)
  {
    const Dofs                      old_dofs    = dofs;
    const std::vector<unsigned int> old_ends    = ends;
    const std::vector<unsigned int> old_columns = columns;
    read_lines(lines);
    is_active = !ends.empty();
    if (dofs != old_dofs)
      share_dofs(inverse);
    read_flexibilities(inverse);
    if (is_active)
      factorize(!solver || ends != old_ends || columns != old_columns);
    else
      {
        solver.reset();
        matrix.clear();
      }
  }



  // The sum of others less what is eliminated is zero.
  template<typename Number>
  void SurfaceProjection<Number>::read_lines(const SurfaceRows &lines)
  {
    dofs = lines.dofs;
    dofs.insert(dofs.end(), lines.others.begin(), lines.others.end());
    sort_unique(dofs);
    ends.clear();
    columns.clear();
    factors.clear();
    const auto add = [&](const Dof dof, const double factor) {
      columns.push_back(std::lower_bound(dofs.begin(), dofs.end(), dof) -
                        dofs.begin());
      factors.push_back(factor);
    };
    for (unsigned int line = 0; line < lines.size(); ++line)
      {
        add(lines.dofs[line], -1);
        for (unsigned int k = lines.begin(line); k < lines.end(line); ++k)
          add(lines.others[k], lines.factors[k]);
        ends.push_back(columns.size());
      }
  }



  template<typename Number>
  void SurfaceProjection<Number>::share_dofs(const Vector &like)
  {
    const IndexSet owned = like.locally_owned_elements();
    IndexSet       used(owned.size());
    used.add_indices(dofs.begin(), dofs.end());
    values.initialize(used, owned, like.get_mpi_communicator());
    own.clear();
    for (unsigned int j = 0; j < dofs.size(); ++j)
      if (owned.is_element(dofs[j]))
        own.push_back(j);
    at_surfaces.resize(dofs.size());
  }



  template<typename Number>
  void SurfaceProjection<Number>::read_flexibilities(const Vector &inverse)
  {
    values.read(inverse);
    flexibilities.clear();
    for (const Dof dof : dofs)
      flexibilities.push_back(values(inverse, dof));
  }



  // By numbers: of each unknown the lines that it is in.
  template<typename Number>
  SurfaceRows SurfaceProjection<Number>::lines_of_dofs() const
  {
    SurfaceRows rows;
    rows.ends.assign(dofs.size() + 1, 0);
    for (const unsigned int column : columns)
      ++rows.ends[column + 1];
    std::partial_sum(rows.ends.begin(), rows.ends.end(), rows.ends.begin());
    std::vector<unsigned int> next(rows.ends.begin(), rows.ends.end() - 1);
    rows.ends.erase(rows.ends.begin());
    rows.others.resize(columns.size());
    rows.factors.resize(columns.size());
    unsigned int k = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      for (; k < ends[i]; ++k)
        {
          const unsigned int at = next[columns[k]]++;
          rows.others[at]       = i;
          rows.factors[at]      = factors[k];
        }
    return rows;
  }



  template<typename Number>
  SurfaceRows SurfaceProjection<Number>::compliance() const
  {
    const SurfaceRows   of_dofs = lines_of_dofs();
    SurfaceRows         result;
    std::vector<double> sums(ends.size(), 0.);
    std::vector<bool>   is_in_row(ends.size(), false);
    Dofs                of_row;
    unsigned int        k = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      {
        of_row.clear();
        for (; k < ends[i]; ++k)
          {
            const unsigned int j      = columns[k];
            const double       factor = flexibilities[j] * factors[k];
            for (unsigned int l = of_dofs.begin(j); l < of_dofs.end(j); ++l)
              {
                const Dof line = of_dofs.others[l];
                if (!is_in_row[line])
                  of_row.push_back(line);
                is_in_row[line] = true;
                sums[line] += factor * of_dofs.factors[l];
              }
          }
        std::sort(of_row.begin(), of_row.end());
        for (const Dof line : of_row)
          {
            result.add_entry(line, sums[line]);
            sums[line]      = 0;
            is_in_row[line] = false;
          }
        result.end_row(i);
      }
    return result;
  }



  template<typename Number>
  void SurfaceProjection<Number>::factorize(const bool new_pattern)
  {
    const SurfaceRows rows = compliance();
    if (new_pattern)
      {
        const IndexSet         all = complete_index_set(rows.size());
        DynamicSparsityPattern pattern(rows.size(), rows.size());
        for (unsigned int i = 0; i < rows.size(); ++i)
          pattern.add_entries(i,
                              rows.others.begin() + rows.begin(i),
                              rows.others.begin() + rows.end(i),
                              /*indices_are_sorted=*/true);
        solver = std::make_unique<Factorization>(/*may_be_indefinite=*/false,
                                                 counters);
        matrix.reinit(all, all, pattern, MPI_COMM_SELF);
        gaps.reinit(all, MPI_COMM_SELF);
        pressures.reinit(all, MPI_COMM_SELF);
      }
    for (unsigned int i = 0; i < rows.size(); ++i)
      matrix.set(i,
                 rows.end(i) - rows.begin(i),
                 rows.others.data() + rows.begin(i),
                 rows.factors.data() + rows.begin(i));
    matrix.compress(VectorOperation::insert);
    solver->make(matrix, new_pattern);
  }



  template<typename Number>
  void SurfaceProjection<Number>::make_reactions() const
  {
    double *const gap = gaps.begin();
    unsigned int  k   = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      for (gap[i] = 0; k < ends[i]; ++k)
        gap[i] += factors[k] * at_surfaces[columns[k]];

    solver->vmult(pressures, gaps);

    std::fill(at_surfaces.begin(), at_surfaces.end(), 0.);
    const double *const pressure = pressures.begin();
    k                            = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      for (; k < ends[i]; ++k)
        at_surfaces[columns[k]] += factors[k] * pressure[i];
  }



  template<typename Number>
  void SurfaceProjection<Number>::project(Vector &v) const
  {
    if (!is_active)
      return;
    values.read(v);
    for (unsigned int j = 0; j < dofs.size(); ++j)
      at_surfaces[j] = values(v, dofs[j]);
    make_reactions();
    for (const unsigned int j : own)
      v(dofs[j]) -= flexibilities[j] * at_surfaces[j];
  }



  template<typename Number>
  void SurfaceProjection<Number>::project_transposed(Vector &v) const
  {
    if (!is_active)
      return;
    values.read(v);
    for (unsigned int j = 0; j < dofs.size(); ++j)
      at_surfaces[j] = flexibilities[j] * values(v, dofs[j]);
    make_reactions();
    for (const unsigned int j : own)
      v(dofs[j]) -= at_surfaces[j];
  }

  template class SurfaceProjection<float>;
} // namespace Contact
