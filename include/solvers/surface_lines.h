/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_lines_h
#define contact_surface_lines_h

#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * The eliminated unknowns of the surfaces of contact, C in C^T K C: each is a
   * sum over unknowns that are not eliminated. Vectors hold the latter; in the
   * place of the former they have zero.
   */
  template<typename Number>
  class SurfaceLines
  {
  public:
    using Dof  = types::global_dof_index;
    using Dofs = std::vector<Dof>;

    SurfaceLines() = default;

    /// Those of @p eliminated in closed @p constraints, whatever their
    /// inhomogeneities.
    SurfaceLines(const Dofs                      &eliminated,
                 const AffineConstraints<double> &constraints)
      : eliminated(eliminated)
    {
      for (const auto dof : eliminated)
        {
          if (const auto *entries = constraints.get_constraint_entries(dof))
            for (const auto &[other, factor] : *entries)
              {
                others.push_back(other);
                factors.push_back(factor);
              }
          ends.push_back(others.size());
        }
    }

    /// Set the eliminated unknowns: C v.
    template<class Vector>
    void expand(Vector &v) const
    {
      unsigned int k = 0;
      for (unsigned int i = 0; i < eliminated.size(); ++i)
        {
          Number sum = 0;
          for (; k < ends[i]; ++k)
            sum += factors[k] * v(others[k]);
          v(eliminated[i]) = sum;
        }
    }

    /// The transpose: what acts on eliminated unknowns goes to the others, and
    /// leaves zero.
    template<class Vector>
    void condense(Vector &v) const
    {
      unsigned int k = 0;
      for (unsigned int i = 0; i < eliminated.size(); ++i)
        {
          const Number value = v(eliminated[i]);
          for (; k < ends[i]; ++k)
            v(others[k]) += factors[k] * value;
          v(eliminated[i]) = 0;
        }
    }

    /// Set eliminated unknowns to @p value.
    template<class Vector>
    void set(Vector &v, const Number value) const
    {
      for (const auto dof : eliminated)
        v(dof) = value;
    }

    /// The part of the diagonal of C^T K C that it has of the diagonal of K.
    template<class Vector>
    void add_to_diagonal(Vector &diagonal) const
    {
      unsigned int k = 0;
      for (unsigned int i = 0; i < eliminated.size(); ++i)
        {
          const Number value = diagonal(eliminated[i]);
          for (; k < ends[i]; ++k)
            diagonal(others[k]) += factors[k] * factors[k] * value;
          diagonal(eliminated[i]) = 1;
        }
    }

  private:
    Dofs                      eliminated;
    std::vector<unsigned int> ends; // of each in the following
    Dofs                      others;
    std::vector<Number>       factors;
  };
} // namespace Contact

#endif
