/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_row_elimination_h
#define contact_row_elimination_h

#include <deal.II/base/types.h>

#include <boost/container/flat_map.hpp>
#include <map>
#include <set>

namespace Contact
{
  using namespace dealii;

  /**
   * Gauss-Jordan elimination of sparse linear equations
   *   sum over the unknowns of c_k u_k = constant,
   * one after the other, each with a pivot that the caller chooses. At any time
   * every eliminated unknown is known by those that are not:
   *   u_pivot = constant + sum of c_k u_k.
   *
   * If each equation has some unknowns of the next one, as along the rim of
   * the master on a slave of degree 2, each line gets coefficients of all of
   * them, which decay with the distance: below round-off they are left out.
   */
  class RowElimination
  {
  public:
    using Dof = types::global_dof_index;

    /// An equation, or the line of an eliminated unknown.
    struct Row
    {
      using Entries = boost::container::flat_map<Dof, double>;

      Entries entries;
      double  constant = 0;

      /// The coefficient of an unknown, zero if it is not there.
      double operator[](const Dof dof) const;

      /// The largest |coefficient|.
      double largest() const;

      /// Coefficients below the round-off of the largest one are left out.
      void drop_round_off();
    };

    /// @p usual are the unknowns that are mostly taken as pivots: in which
    /// lines they are is looked up, not searched. It has to live on.
    explicit RowElimination(const std::set<Dof> &usual);

    void clear();

    /// Replace what is eliminated in an equation by what it depends on.
    void reduce(Row &equation) const;

    /// Solve a reduced equation for @p pivot, and replace it in all lines.
    void eliminate(const Dof pivot, const Row &equation);

    /// The eliminated unknowns, by the unknowns that they depend on.
    const std::map<Dof, Row> &lines() const
    {
      return known;
    }

  private:
    static void   substitute(Row &in, const Dof what, const Row &by);
    std::set<Dof> take_users(const Dof dof);

    const std::set<Dof>         &usual;
    std::map<Dof, Row>           known;
    std::map<Dof, std::set<Dof>> users; // the lines with a usual unknown, or
                                        // once with it
  };
} // namespace Contact

#endif
