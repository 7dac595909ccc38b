/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of a symmetric system with an unsymmetric border that CHOLMOD with
// LAPACK solves it as UMFPACK does, transposed, and at the border alone, where
// nothing but the border holds a body, too; that a change of the border takes
// no factorization of the inside, and no new analysis; and that what is
// indefinite inside is left to UMFPACK.

#include "solvers/direct/bordered_factorization.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <array>
#include <map>

#include "solvers/direct/linear_solver.h"
#include "tests.h"

using namespace Tests;

namespace
{
  constexpr unsigned int n_x = 9, n_y = 7; // nodes of a body, with two unknowns
  constexpr unsigned int n_body        = 2 * n_x * n_y;
  constexpr unsigned int n_multipliers = 5;
  constexpr unsigned int n             = 2 * n_body + n_multipliers;

  unsigned int
  unknown(const unsigned int body, const unsigned int x, const unsigned int y)
  {
    return body * n_body + 2 * (y * n_x + x);
  }

  // Two nets of springs. The second floats. Their border is the row y = 0, all
  // of which or all but its ends, and the multipliers.
  struct System
  {
    explicit System(const bool with_ends)
      : border(n)
    {
      for (unsigned int body = 0; body < 2; ++body)
        for (unsigned int x = 0; x < n_x; ++x)
          for (unsigned int c = 0; c < 2; ++c)
            border[unknown(body, x, 0) + c] =
              with_ends || (x > 0 && x < n_x - 1);
      for (unsigned int i = n - n_multipliers; i < n; ++i)
        border[i] = true;

      DynamicSparsityPattern couplings(n, n);
      visit_springs([&](const unsigned int i, const unsigned int j, double) {
        const std::array<unsigned int, 4> of_spring{{i, i + 1, j, j + 1}};
        for (const unsigned int row : of_spring)
          for (const unsigned int column : of_spring)
            couplings.add(row, column);
      });
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (i == j || (border[i] && border[j]))
            couplings.add(i, j);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
    }

    template<typename Visit>
    static void visit_springs(const Visit &visit)
    {
      for (unsigned int body = 0; body < 2; ++body)
        for (unsigned int y = 0; y < n_y; ++y)
          for (unsigned int x = 0; x < n_x; ++x)
            {
              const double k = 1 + 0.1 * x + 0.3 * y;
              if (x + 1 < n_x)
                visit(unknown(body, x, y), unknown(body, x + 1, y), k);
              if (y + 1 < n_y)
                visit(unknown(body, x, y), unknown(body, x, y + 1), k);
            }
    }

    void assemble(const int seed, const double load = 0)
    {
      matrix = 0;
      visit_springs(
        [&](const unsigned int i, const unsigned int j, const double k) {
          // [2 1; 1 3] between the nodes.
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int b = 0; b < 2; ++b)
              {
                const double value = k * (a != b ? 1 : a == 0 ? 2 : 3);
                matrix.add(i + a, i + b, value);
                matrix.add(j + a, j + b, value);
                matrix.add(i + a, j + b, -value);
                matrix.add(j + a, i + b, -value);
              }
        });
      for (unsigned int x = 0; x < n_x; ++x)
        for (unsigned int c = 0; c < 2; ++c)
          matrix.add(unknown(0, x, n_y - 1) + c,
                     unknown(0, x, n_y - 1) + c,
                     10.);
      matrix.add(unknown(1, 4, 4), unknown(1, 4, 4), -load);
      Random random;
      for (int k = 0; k < seed; ++k)
        random(0, 1);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          if (border[i] && border[j])
            matrix.add(i, j, random(-1, 1));
    }

    std::vector<bool>    border;
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
  };



  // The compressed rows of a matrix, with sorted columns.
  struct Rows
  {
    explicit Rows(const SparseMatrix<double> &matrix)
    {
      starts.push_back(0);
      for (unsigned int i = 0; i < matrix.m(); ++i)
        {
          std::map<int, double> row;
          for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
            row[entry->column()] = entry->value();
          for (const auto &[column, value] : row)
            {
              columns.push_back(column);
              values.push_back(value);
            }
          starts.push_back(columns.size());
        }
    }

    std::vector<int>    starts, columns;
    std::vector<double> values;
  };



  double difference(const Vector<double> &a, const Vector<double> &b)
  {
    Vector<double> d(a);
    d -= b;
    return d.linfty_norm() / b.linfty_norm();
  }



  void compare(const System                &system,
               const BorderedFactorization &bordered,
               const DirectSolver          &umfpack)
  {
    Random         random;
    Vector<double> b(n), load(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        b[i]    = random(-1, 1);
        load[i] = system.border[i] ? b[i] : 0;
      }
    for (const bool transposed : {false, true})
      {
        Vector<double> x(b), reference(b);
        bordered.solve(x, transposed);
        transposed ? umfpack.solve_transposed(reference)
                   : umfpack.solve(reference);
        check_small(transposed ? "transposed" : "solution",
                    difference(x, reference),
                    1e-10);
      }

    std::vector<Vector<double>> several{load, load};
    several[1] *= -2;
    bordered.solve_at_border(several);
    umfpack.solve(load);
    bool zero_inside = true;
    for (unsigned int i = 0; i < n; ++i)
      if (!system.border[i])
        {
          zero_inside = zero_inside && several[0][i] == 0;
          load[i]     = 0;
        }
    several[1] *= -0.5;
    check_small("at the border",
                std::max(difference(several[0], load),
                         difference(several[1], load)),
                1e-10);
    check("zero inside", zero_inside);
  }
} // namespace



int main()
{
  Counters              counters, of_umfpack;
  BorderedFactorization bordered(counters);
  DirectSolver          umfpack(of_umfpack);
  for (const bool with_ends : {false, true})
    {
      headline(with_ends ? "a larger border" : "a border");
      System system(with_ends);
      umfpack.initialize(system.pattern);
      for (const int seed : {0, 1})
        {
          system.assemble(seed);
          const Rows rows(system.matrix);
          bordered.initialize(rows.starts, rows.columns, system.border);
          check("definite inside", bordered.factorize(rows.values));
          umfpack.factorize(system.matrix);
          compare(system, bordered, umfpack);
        }
      std::cout << "  analyses " << counters.symbolic_factorizations
                << ", factorizations " << counters.numeric_factorizations
                << std::endl;
    }

  headline("indefinite inside");
  System system(true);
  system.assemble(0, /*load=*/100);
  check("is noticed", !bordered.factorize(Rows(system.matrix).values));
  system.assemble(0);
  check("and the next is not", bordered.factorize(Rows(system.matrix).values));
  umfpack.factorize(system.matrix);
  compare(system, bordered, umfpack);
  return 0;
}
