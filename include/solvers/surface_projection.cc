/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/surface_projection.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace Contact
{
  template<typename Number>
  void SurfaceProjection<Number>::initialize(
    const Dofs                      &eliminated,
    const AffineConstraints<double> &constraints,
    const Vector                    &inverse)
  {
    const IndexSet owned = inverse.locally_owned_elements();
    std::map<Dof, unsigned int> numbers;
    const auto                  number = [&](const Dof dof) {
      const auto [at, is_new] = numbers.emplace(dof, used.size());
      if (is_new)
        used.push_back(dof);
      return at->second;
    };
    for (auto *list : {&ends, &columns})
      list->clear();
    used.clear();
    factors.clear();
    own.clear();
    for (const Dof dof : eliminated)
      {
        columns.push_back(number(dof));
        factors.push_back(-1);
        if (const auto *entries = constraints.get_constraint_entries(dof))
          for (const auto &[other, factor] : *entries)
            {
              columns.push_back(number(other));
              factors.push_back(factor);
            }
        ends.push_back(columns.size());
      }
    IndexSet all(owned.size());
    for (const auto &entry : numbers)
      all.add_index(entry.first);
    values.initialize(all, owned, inverse.get_mpi_communicator());
    for (unsigned int j = 0; j < used.size(); ++j)
      if (owned.is_element(used[j]))
        own.emplace_back(j, used[j]);
    at_surfaces.resize(used.size());
    values.read(inverse);
    flexibilities.clear();
    for (const Dof dof : used)
      flexibilities.push_back(values(inverse, dof));

    solver.reset();
    const unsigned int n = ends.size();
    if (n == 0)
      return;
    std::vector<std::vector<std::pair<unsigned int, double>>> by_column(
      used.size());
    unsigned int k = 0;
    for (unsigned int i = 0; i < n; ++i)
      for (; k < ends[i]; ++k)
        by_column[columns[k]].emplace_back(i, factors[k]);
    DynamicSparsityPattern pattern(n, n);
    for (const auto &column : by_column)
      for (const auto &a : column)
        for (const auto &b : column)
          pattern.add(a.first, b.first);
    const IndexSet lines = complete_index_set(n);
    matrix.clear();
    matrix.reinit(lines, lines, pattern, MPI_COMM_SELF);
    for (unsigned int j = 0; j < used.size(); ++j)
      for (const auto &a : by_column[j])
        for (const auto &b : by_column[j])
          matrix.add(a.first, b.first, a.second * flexibilities[j] * b.second);
    matrix.compress(VectorOperation::add);
    solver = DefiniteSolver::create(Parameters::SolverKind::cholmod,
                                    /*symmetric=*/true,
                                    /*may_be_indefinite=*/false,
                                    {},
                                    counters);
    solver->set_matrix(matrix, true, true, {});
    violations.reinit(lines, MPI_COMM_SELF);
    multipliers.reinit(lines, MPI_COMM_SELF);
  }



  // B^T S^-1 B of the values at the surfaces.
  template<typename Number>
  void SurfaceProjection<Number>::solve() const
  {
    const unsigned int n = ends.size();
    double *const      b = violations.begin();
    unsigned int       k = 0;
    for (unsigned int i = 0; i < n; ++i)
      for (b[i] = 0; k < ends[i]; ++k)
        b[i] += factors[k] * at_surfaces[columns[k]];
    solver->solve(violations, 0, multipliers);
    const double *const x = multipliers.begin();
    std::fill(at_surfaces.begin(), at_surfaces.end(), 0.);
    k = 0;
    for (unsigned int i = 0; i < n; ++i)
      for (; k < ends[i]; ++k)
        at_surfaces[columns[k]] += factors[k] * x[i];
  }



  template<typename Number>
  void SurfaceProjection<Number>::project(Vector &v) const
  {
    if (!solver)
      return;
    values.read(v);
    for (unsigned int j = 0; j < used.size(); ++j)
      at_surfaces[j] = values(v, used[j]);
    solve();
    for (const auto &[j, dof] : own)
      v(dof) -= flexibilities[j] * at_surfaces[j];
  }



  template<typename Number>
  void SurfaceProjection<Number>::project_transposed(Vector &v) const
  {
    if (!solver)
      return;
    values.read(v);
    for (unsigned int j = 0; j < used.size(); ++j)
      at_surfaces[j] = flexibilities[j] * values(v, used[j]);
    solve();
    for (const auto &[j, dof] : own)
      v(dof) -= at_surfaces[j];
  }

  template class SurfaceProjection<float>;
} // namespace Contact
