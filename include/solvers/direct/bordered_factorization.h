/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_bordered_factorization_h
#define contact_bordered_factorization_h

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cholmod.h>
#include <vector>

#include "base/counters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The factorization of a large symmetric matrix with a small border that is
   * not,
   *   | A  B^T |
   *   | B  C   |,
   * where contact is the border: the displacements at its points, and all
   * multipliers. Inside, A is the stiffness of bodies that are held along the
   * border, and so positive definite whatever else holds them or not, but for
   * bodies that buckle. CHOLMOD takes it, with its analysis kept, and LAPACK
   * what contact makes of the Schur complement C - B A^-1 B^T.
   *
   * CHOLMOD does not stop in front of the border. It is given A and B, and
   * instead of C a diagonal D so large that it gets through. The last block of
   * its factor, L L^T = D - B A^-1 B^T, has the Schur complement.
   *
   * As long as the inside stays, as in small strain, only the border is
   * factorized anew; and loads at the border have a response there without
   * any work on the inside.
   */
  class BorderedFactorization
  {
  public:
    /// Operations are counted by @p counters.
    explicit BorderedFactorization(Counters &counters);
    ~BorderedFactorization();

    BorderedFactorization(const BorderedFactorization &)            = delete;
    BorderedFactorization &operator=(const BorderedFactorization &) = delete;

    /// Whether it is faster than UMFPACK for so many unknowns, and so many at
    /// the border.
    static bool is_worthwhile(const std::size_t n_unknowns,
                              const std::size_t n_border);

    /// Announce the pattern by compressed rows with sorted columns, and which
    /// unknowns are the border. What does not change in it is not analysed
    /// anew.
    void initialize(const std::vector<int>  &row_starts,
                    const std::vector<int>  &columns,
                    const std::vector<bool> &is_border);

    /// Factorize the matrix with these values. Returns false if it is not
    /// definite inside. Throws NotConverged if the Schur complement is
    /// singular.
    bool factorize(const std::vector<double> &values);

    /// Of the matrix that was factorized last, with these values, see
    /// is_definite_under_constraints(); constraints are of the border alone.
    bool
    is_definite_under_constraints(const std::vector<double> &values,
                                  const std::vector<bool> &is_constraint) const;

    /// Replace the right-hand side @p b by the solution with the matrix, or
    /// with the transposed one.
    void solve(Vector<double> &b, const bool transposed) const;

    /// Replace right-hand sides that are zero inside by the solutions at the
    /// border, and leave zeros inside.
    void solve_at_border(std::vector<Vector<double>> &b) const;

  private:
    /// An entry of the matrix among unknowns of the border, numbered there.
    struct Entry
    {
      unsigned int row, column, source;
    };

    std::vector<int> order(const std::vector<int> &row_starts,
                           const std::vector<int> &columns) const;
    void             analyze(const std::vector<int> &row_starts,
                             const std::vector<int> &columns);
    bool             factorize_inside(const std::vector<double> &values);
    void             find_schur_complement();

    Counters              &counters;
    mutable cholmod_common common;
    cholmod_factor        *factor     = nullptr;
    bool                   is_current = false; // that of the present inside

    // The seam are the unknowns of the border that are coupled with the inside.
    // What CHOLMOD gets: its unknowns, those inside and the seam; the place of
    // an unknown among them, or -1; and the compressed lower triangle, with the
    // places of its values in the matrix, or -1 for D.
    std::vector<bool>   is_border;
    std::vector<int>    known, place;
    std::vector<int>    starts, rows, sources;
    std::vector<double> lower, diagonal;

    // What it makes of it: its unknowns in the order of elimination, and where
    // the seam is.
    std::vector<int> eliminated, seam_positions;

    // The border, first the seam, in the order of elimination; the entries of
    // each row of the seam in the matrix, and of those among the border.
    std::vector<int>                 border;
    std::vector<std::pair<int, int>> seam_rows;
    std::vector<Entry>               entries;

    LAPACKFullMatrix<double> last_block;       // L
    LAPACKFullMatrix<double> schur_complement; // L L^T - D
    LAPACKFullMatrix<double> dense;            // C + L L^T - D, factorized
  };
} // namespace Contact

#endif
