/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_lemke_h
#define contact_lemke_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * The linear complementarity problem
   *   w = r + M z,  w >= 0,  z >= 0,  w z = 0 in each component,
   * by Lemke's method (C. E. Lemke, Management Science 11, 1965; R. W. Cottle,
   * J.-S. Pang and R. E. Stone, The Linear Complementarity Problem, 1992,
   * chapter 4.4): with w = r + M z + d z_0 and a z_0 so large that z = 0 is a
   * solution, z_0 is taken back along the one path that leads from there. Equal
   * ratios are told apart lexicographically, so that no basis comes back.
   *
   * If M is copositive and no z >= 0 with z.Mz = 0, Mz >= 0 has r.z < 0, the
   * path ends at a solution, whether M is symmetric or definite or neither.
   * Otherwise it may end on a ray.
   */
  class Lemke
  {
  public:
    Lemke(const FullMatrix<double> &M, const Vector<double> &r);

    /// Returns whether a solution was found.
    bool solve();

    /// Of the solution.
    const Vector<double> &z() const
    {
      return values_of_z;
    }

    const Vector<double> &w() const
    {
      return values_of_w;
    }

  private:
    /// Variables are numbered: w, then z, then z_0.
    unsigned int complement(const unsigned int variable) const;

    /// The row whose variable is the first to vanish as the variable of this
    /// column grows, or the number of rows if there is none.
    unsigned int leaving_row(const unsigned int column) const;

    /// Whether, at equal ratios, row @p i is left before row @p j.
    bool is_first(const unsigned int i,
                  const unsigned int j,
                  const unsigned int c) const;

    /// The value of a row's variable: zero if it is no more than round-off.
    double positive_part(const unsigned int row) const
    {
      return constant[row] > zero ? constant[row] : 0.;
    }

    void exchange(const unsigned int row, const unsigned int column);
    void collect();

    const unsigned int        n;
    FullMatrix<double>        table; // basic = constant + table * others
    Vector<double>            constant;
    const double              zero;   // what is left of zeros by round-off
    std::vector<unsigned int> basic;  // the variable of each row
    std::vector<unsigned int> others; // the variable of each column
    Vector<double>            values_of_z, values_of_w;
  };
} // namespace Contact

#endif
