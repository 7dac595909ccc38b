/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/bordered_factorization.h"

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "solvers/direct/definiteness.h"

namespace Contact
{
  namespace
  {
    /// A view of compressed columns of a symmetric matrix.
    cholmod_sparse symmetric_view(const std::vector<int> &starts,
                                  const std::vector<int> &rows,
                                  double                 *values)
    {
      cholmod_sparse view{};
      view.nrow   = starts.size() - 1;
      view.ncol   = starts.size() - 1;
      view.nzmax  = rows.size();
      view.p      = const_cast<int *>(starts.data());
      view.i      = const_cast<int *>(rows.data());
      view.x      = values;
      view.stype  = -1; // the lower triangle
      view.itype  = CHOLMOD_INT;
      view.xtype  = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
      view.dtype  = CHOLMOD_DOUBLE;
      view.sorted = 0;
      view.packed = 1;
      return view;
    }



    void check(const cholmod_common &common)
    {
      if (common.status < CHOLMOD_OK)
        throw NotConverged("CHOLMOD failed with status " +
                           std::to_string(common.status) +
                           (common.status == CHOLMOD_OUT_OF_MEMORY
                              ? ", it lacks memory: fewer levels"
                              : ""));
    }
  } // namespace



  BorderedFactorization::BorderedFactorization(Counters &counters)
    : counters(counters)
  {
    cholmod_start(&common);
    common.supernodal                 = CHOLMOD_SUPERNODAL;
    common.print                      = 0;
    common.quick_return_if_not_posdef = 1;
    common.nmethods                   = 1;
    common.method[0].ordering         = CHOLMOD_GIVEN;
  }



  BorderedFactorization::~BorderedFactorization()
  {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }



  // SSNP154 with linear elements (modeling A, complete runs) takes 1.7 times
  // the CPU time by UMFPACK with 20000 unknowns, and 2.6 times with 81000. Up
  // to the first limit that is half a second, and nothing changes. The second:
  // LAPACK takes 5/3 n^3 operations for n unknowns at the border, UMFPACK a
  // hundred times the power 3/2 of all, at a quarter of the speed: then both
  // are equal.
  bool BorderedFactorization::is_worthwhile(const std::size_t n_unknowns,
                                            const std::size_t n_border)
  {
    const std::size_t large = 30000, dense = 36;
    return n_unknowns > large && n_border * n_border < dense * n_unknowns;
  }



  void BorderedFactorization::initialize(const std::vector<int>  &row_starts,
                                         const std::vector<int>  &columns,
                                         const std::vector<bool> &border_or_not)
  {
    const bool new_border = is_border != border_or_not;
    is_border             = border_or_not;
    const int n           = is_border.size();

    std::vector<bool> is_known(n);
    for (int i = 0; i < n; ++i)
      if (!is_border[i])
        {
          is_known[i] = true;
          for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
            is_known[columns[k]] = true;
        }
    known.clear();
    place.assign(n, -1);
    for (int i = 0; i < n; ++i)
      if (is_known[i])
        {
          place[i] = known.size();
          known.push_back(i);
        }

    const std::vector<int> old_starts = starts, old_rows = rows;
    starts.assign(1, 0);
    rows.clear();
    sources.clear();
    for (const int i : known)
      {
        for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
          {
            const int j = columns[k];
            if (place[j] < place[i] || (is_border[i] && is_border[j] && i != j))
              continue;
            rows.push_back(place[j]);
            sources.push_back(is_border[i] && is_border[j] ? -1 : k);
          }
        starts.push_back(rows.size());
      }
    if (factor == nullptr || new_border || starts != old_starts ||
        rows != old_rows)
      analyze(row_starts, columns);

    // The border, and what is in it.
    border.clear();
    seam_positions.clear();
    seam_rows.clear();
    for (unsigned int position = 0; position < eliminated.size(); ++position)
      {
        const int i = eliminated[position];
        if (!is_border[i])
          continue;
        seam_positions.push_back(position);
        seam_rows.emplace_back(row_starts[i], row_starts[i + 1]);
        border.push_back(i);
      }
    for (int i = 0; i < n; ++i)
      if (is_border[i] && place[i] < 0)
        border.push_back(i);

    std::vector<int> number(n, -1);
    for (unsigned int b = 0; b < border.size(); ++b)
      number[border[b]] = b;
    entries.clear();
    for (unsigned int b = 0; b < border.size(); ++b)
      for (int k = row_starts[border[b]]; k < row_starts[border[b] + 1]; ++k)
        if (number[columns[k]] >= 0)
          entries.push_back({b,
                             static_cast<unsigned int>(number[columns[k]]),
                             static_cast<unsigned int>(k)});
  }



  // Unknowns of a node have the same row in the pattern, and are ordered as
  // one: that takes a third of the time. Nested dissection makes factors of
  // less operations, but takes longer than several factorizations save by that.
  std::vector<int>
  BorderedFactorization::order(const std::vector<int> &row_starts,
                               const std::vector<int> &columns) const
  {
    const auto same_row = [&](const int i, const int j) {
      return std::equal(columns.begin() + row_starts[i],
                        columns.begin() + row_starts[i + 1],
                        columns.begin() + row_starts[j],
                        columns.begin() + row_starts[j + 1]);
    };
    std::vector<int> node_of(place.size(), -1), first_of; // unknowns, places
    for (unsigned int p = 0; p < known.size(); ++p)
      if (!is_border[known[p]])
        {
          if (first_of.empty() || !same_row(known[p], known[first_of.back()]))
            first_of.push_back(p);
          node_of[known[p]] = first_of.size() - 1;
        }

    const int        n_nodes = first_of.size();
    std::vector<int> node_starts(1, 0), neighbors, last_seen_by(n_nodes, -1);
    for (int node = 0; node < n_nodes; ++node)
      {
        const int i = known[first_of[node]];
        for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
          {
            const int neighbor = node_of[columns[k]];
            if (neighbor > node && last_seen_by[neighbor] != node)
              {
                last_seen_by[neighbor] = node;
                neighbors.push_back(neighbor);
              }
          }
        node_starts.push_back(neighbors.size());
      }

    std::vector<int> nodes(n_nodes), places;
    cholmod_sparse   graph = symmetric_view(node_starts, neighbors, nullptr);
    cholmod_amd(&graph, nullptr, 0, nodes.data(), &common);
    check(common);

    first_of.push_back(known.size());
    for (const int node : nodes)
      for (int p = first_of[node]; p < first_of[node + 1]; ++p)
        if (!is_border[known[p]])
          places.push_back(p);
    for (unsigned int p = 0; p < known.size(); ++p)
      if (is_border[known[p]])
        places.push_back(p);
    return places;
  }



  void BorderedFactorization::analyze(const std::vector<int> &row_starts,
                                      const std::vector<int> &columns)
  {
    ++counters.symbolic_factorizations;
    std::vector<int> given = order(row_starts, columns);
    lower.assign(rows.size(), 0.);
    cholmod_sparse view = symmetric_view(starts, rows, lower.data());
    cholmod_free_factor(&factor, &common);
    factor     = cholmod_analyze_p(&view, given.data(), nullptr, 0, &common);
    is_current = false;
    check(common);

    const int *places = static_cast<const int *>(factor->Perm);
    eliminated.resize(known.size());
    for (unsigned int position = 0; position < known.size(); ++position)
      eliminated[position] = known[places[position]];
  }



  bool BorderedFactorization::factorize(const std::vector<double> &values)
  {
    if (!factorize_inside(values))
      return false;

    const unsigned int n = border.size(), n_seam = seam_positions.size();
    dense.reinit(n, n);
    for (const Entry &entry : entries)
      dense(entry.row, entry.column) = values[entry.source];
    for (unsigned int j = 0; j < n_seam; ++j)
      for (unsigned int i = 0; i < n_seam; ++i)
        dense(i, j) += schur_complement(i, j);
    try
      {
        dense.compute_lu_factorization();
      }
    catch (const LACExceptions::ExcSingular &)
      {
        throw NotConverged(
          "the matrix is singular: a body, or an obstacle under its force, "
          "can move without resistance, or supports and contact hold a node "
          "twice");
      }
    return true;
  }



  // The inside is definite, and takes the least energy there is for what moves
  // at the border: that of the Schur complement.
  bool BorderedFactorization::is_definite_under_constraints(
    const std::vector<double> &values,
    const std::vector<bool>   &is_constraint) const
  {
    SparseRows        rows(border.size());
    std::vector<bool> is_row_of_constraint;
    for (const int unknown : border)
      is_row_of_constraint.push_back(is_constraint[unknown]);
    for (const Entry &entry : entries)
      rows[entry.row].emplace_back(entry.column, values[entry.source]);
    for (unsigned int i = 0; i < seam_positions.size(); ++i)
      for (unsigned int j = 0; j < seam_positions.size(); ++j)
        rows[i].emplace_back(j, schur_complement(i, j));
    return Contact::is_definite_under_constraints(rows, is_row_of_constraint);
  }



  // Twice the sums of the absolute values of a row: with one of them the matrix
  // of the seam would dominate C by its diagonal if C were that of the bodies,
  // and B A^-1 B^T is less than that.
  bool
  BorderedFactorization::factorize_inside(const std::vector<double> &values)
  {
    bool is_new = !is_current;
    for (unsigned int k = 0; k < rows.size(); ++k)
      if (sources[k] >= 0 && lower[k] != values[sources[k]])
        {
          lower[k] = values[sources[k]];
          is_new   = true;
        }
    if (!is_new)
      return true;

    diagonal.clear();
    for (const auto &[begin, end] : seam_rows)
      {
        double sum = 0;
        for (int k = begin; k < end; ++k)
          sum += std::abs(values[k]);
        diagonal.push_back(2 * sum);
      }
    for (unsigned int s = 0; s < diagonal.size(); ++s)
      lower[starts[place[border[s]]]] = diagonal[s];

    ++counters.numeric_factorizations;
    cholmod_sparse view = symmetric_view(starts, rows, lower.data());
    cholmod_factorize(&view, factor, &common);
    check(common);
    is_current = common.status == CHOLMOD_OK;
    if (is_current)
      find_schur_complement();
    return is_current;
  }



  // In the factor all below a column of the seam is of the seam.
  void BorderedFactorization::find_schur_complement()
  {
    const unsigned int n_seam = seam_positions.size();
    std::vector<int>   seam_number(eliminated.size(), -1);
    for (unsigned int s = 0; s < n_seam; ++s)
      seam_number[seam_positions[s]] = s;

    const auto *columns = static_cast<const int *>(factor->super);
    const auto *rows_of = static_cast<const int *>(factor->pi);
    const auto *values  = static_cast<const int *>(factor->px);
    const auto *all     = static_cast<const int *>(factor->s);
    const auto *x       = static_cast<const double *>(factor->x);
    last_block.reinit(n_seam, n_seam);
    for (unsigned int block = 0; block < factor->nsuper; ++block)
      {
        const int n_rows = rows_of[block + 1] - rows_of[block];
        for (int c = 0; c < columns[block + 1] - columns[block]; ++c)
          {
            const int column = seam_number[columns[block] + c];
            if (column < 0)
              continue;
            for (int r = c; r < n_rows; ++r)
              {
                const int row = seam_number[all[rows_of[block] + r]];
                Assert(row >= 0, ExcInternalError());
                last_block(row, column) = x[values[block] + c * n_rows + r];
              }
          }
      }
    schur_complement.reinit(n_seam, n_seam);
    last_block.mTmult(schur_complement, last_block);
    for (unsigned int s = 0; s < n_seam; ++s)
      schur_complement(s, s) -= diagonal[s];
  }



  // L_AA y = b_A; with what that leaves of the border's right-hand side the
  // border; and back. CHOLMOD eliminates the seam as well, which L undoes.
  void BorderedFactorization::solve(Vector<double> &b,
                                    const bool      transposed) const
  {
    const unsigned int n_known = eliminated.size(),
                       n_seam  = seam_positions.size();
    cholmod_dense *x =
      cholmod_allocate_dense(n_known, 1, n_known, CHOLMOD_REAL, &common);
    double *values = static_cast<double *>(x->x);
    for (unsigned int position = 0; position < n_known; ++position)
      values[position] = b[eliminated[position]];
    cholmod_dense *y = cholmod_solve(CHOLMOD_L, factor, x, &common);
    cholmod_free_dense(&x, &common);
    check(common);
    values = static_cast<double *>(y->x);

    Vector<double> at_seam(n_seam), loads(n_seam), at_border(border.size());
    for (unsigned int s = 0; s < n_seam; ++s)
      at_seam[s] = values[seam_positions[s]];
    last_block.vmult(loads, at_seam);
    for (unsigned int i = 0; i < border.size(); ++i)
      at_border[i] = i < n_seam ? loads[i] : b[border[i]];
    dense.solve(at_border, transposed);

    for (unsigned int s = 0; s < n_seam; ++s)
      loads[s] = at_border[s];
    last_block.Tvmult(at_seam, loads);
    for (unsigned int s = 0; s < n_seam; ++s)
      values[seam_positions[s]] = at_seam[s];
    x = cholmod_solve(CHOLMOD_Lt, factor, y, &common);
    cholmod_free_dense(&y, &common);
    check(common);
    values = static_cast<double *>(x->x);
    for (unsigned int position = 0; position < n_known; ++position)
      b[eliminated[position]] = values[position];
    for (unsigned int i = 0; i < border.size(); ++i)
      b[border[i]] = at_border[i];
    cholmod_free_dense(&x, &common);
  }



  void
  BorderedFactorization::solve_at_border(std::vector<Vector<double>> &b) const
  {
    LAPACKFullMatrix<double> at_border(border.size(), b.size());
    for (unsigned int j = 0; j < b.size(); ++j)
      for (unsigned int i = 0; i < border.size(); ++i)
        at_border(i, j) = b[j][border[i]];
    dense.solve(at_border);
    for (unsigned int j = 0; j < b.size(); ++j)
      for (unsigned int i = 0; i < border.size(); ++i)
        b[j][border[i]] = at_border(i, j);
  }
} // namespace Contact
