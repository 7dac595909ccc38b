/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/surface_projection.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

#include "base/exchange.h"

namespace Contact
{
  template<typename Number>
  void SurfaceProjection<Number>::initialize(const SurfaceRows &lines,
                                             const Vector      &inverse)
  {
    read_lines(lines);
    share_values(inverse);
    solver.reset();
    matrix.clear();
    if (!ends.empty())
      factorize();
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
  void SurfaceProjection<Number>::share_values(const Vector &inverse)
  {
    const IndexSet owned = inverse.locally_owned_elements();
    IndexSet       used(owned.size());
    used.add_indices(dofs.begin(), dofs.end());
    values.initialize(used, owned, inverse.get_mpi_communicator());
    own.clear();
    for (unsigned int j = 0; j < dofs.size(); ++j)
      if (owned.is_element(dofs[j]))
        own.push_back(j);
    values.read(inverse);
    flexibilities.clear();
    for (const Dof dof : dofs)
      flexibilities.push_back(values(inverse, dof));
    at_surfaces.resize(dofs.size());
  }



  template<typename Number>
  void SurfaceProjection<Number>::factorize()
  {
    std::vector<std::vector<std::pair<unsigned int, double>>> by_dof(
      dofs.size());
    unsigned int k = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      for (; k < ends[i]; ++k)
        by_dof[columns[k]].emplace_back(i, factors[k]);

    DynamicSparsityPattern pattern(ends.size(), ends.size());
    for (const auto &of_dof : by_dof)
      for (const auto &row : of_dof)
        for (const auto &column : of_dof)
          pattern.add(row.first, column.first);
    const IndexSet all = complete_index_set(ends.size());
    matrix.reinit(all, all, pattern, MPI_COMM_SELF);
    for (unsigned int j = 0; j < dofs.size(); ++j)
      for (const auto &[row, factor] : by_dof[j])
        for (const auto &[column, other] : by_dof[j])
          matrix.add(row, column, flexibilities[j] * factor * other);
    matrix.compress(VectorOperation::add);

    solver = DefiniteSolver::create(Parameters::SolverKind::cholmod,
                                    /*symmetric=*/true,
                                    /*may_be_indefinite=*/false,
                                    {},
                                    counters);
    solver->set_matrix(matrix, true, true, {});
    gaps.reinit(all, MPI_COMM_SELF);
    pressures.reinit(all, MPI_COMM_SELF);
  }



  template<typename Number>
  void SurfaceProjection<Number>::make_reactions() const
  {
    double *const gap = gaps.begin();
    unsigned int  k   = 0;
    for (unsigned int i = 0; i < ends.size(); ++i)
      for (gap[i] = 0; k < ends[i]; ++k)
        gap[i] += factors[k] * at_surfaces[columns[k]];

    solver->solve(gaps, /*tolerance=*/0, pressures);

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
    if (!solver)
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
    if (!solver)
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
