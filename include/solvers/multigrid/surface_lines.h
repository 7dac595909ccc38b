/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_lines_h
#define contact_surface_lines_h

#include "base/exchange.h"
#include "solvers/multigrid/surface_rows.h"
#include "solvers/multigrid/surface_values.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The eliminated unknowns of the surfaces of contact, C in C^T K C: each is a
   * sum over unknowns that are not eliminated. Vectors hold the latter; in the
   * place of the former they have zero. Each rank has the lines whose
   * eliminated unknown is its own. Functions are collective.
   */
  template<typename Number>
  class SurfaceLines
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    SurfaceLines() = default;

    /// Of @p rows, those whose eliminated unknown is of this rank, for vectors
    /// whose unknowns @p owned are.
    SurfaceLines(const SurfaceRows &rows,
                 const IndexSet    &owned,
                 const MPI_Comm     communicator)
      : own(rows.dofs)
      , ends(rows.ends)
      , others(rows.others)
      , factors(rows.factors.begin(), rows.factors.end())
    {
      Dofs read = others;
      sort_unique(read); // a set takes long otherwise
      IndexSet used(owned.size());
      used.add_indices(read.begin(), read.end());
      values.initialize(used, owned, communicator);
    }

    /// Set the eliminated unknowns: C v.
    void expand(Vector &v) const
    {
      values.read(v);
      unsigned int k = 0;
      for (unsigned int i = 0; i < own.size(); ++i)
        {
          Number sum = 0;
          for (; k < ends[i]; ++k)
            sum += factors[k] * values(v, others[k]);
          v(own[i]) = sum;
        }
    }

    /// The transpose: what acts on eliminated unknowns goes to the others, and
    /// leaves zero.
    void condense(Vector &v) const
    {
      values.clear();
      unsigned int k = 0;
      for (unsigned int i = 0; i < own.size(); ++i)
        {
          const Number value = v(own[i]);
          for (; k < ends[i]; ++k)
            values.add(v, others[k], factors[k] * value);
        }
      values.add_to(v);
      clear(v);
    }

    /// Set eliminated unknowns to zero.
    void clear(Vector &v) const
    {
      for (const auto dof : own)
        v(dof) = 0;
    }

  private:
    Dofs                      own;  // of the eliminated
    std::vector<unsigned int> ends; // of each in the following
    Dofs                      others;
    std::vector<Number>       factors;
    SurfaceValues<Number>     values;
  };
} // namespace Contact

#endif
