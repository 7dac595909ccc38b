/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_centres_h
#define contact_cell_centres_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe.h>

#include <utility>
#include <vector>

#include "solid/followers.h"

namespace Contact
{
  using namespace dealii;

  /// The bound centres of serendipity elements, in batches of cells of
  /// MatrixFree. Factors @p is_bound are 1 of cells that bind them
  /// (CentreBinding), else 0.
  template<int dim, typename Numbers>
  class CellCentres
  {
  public:
    /// @p numbers_in_cell are those of the unknowns of FEEvaluation.
    void make(const FiniteElement<dim>        &fe,
              const std::vector<unsigned int> &numbers_in_cell)
    {
      this->numbers_in_cell = numbers_in_cell;
      const auto numbers    = Utilities::invert_permutation(numbers_in_cell);
      for (unsigned int c = 0; c < dim; ++c)
        for (const BoundNode &node : bound_nodes_of_element<dim>())
          {
            const auto number = [&](const unsigned int k) {
              return numbers[fe.component_to_system_index(c, k)];
            };
            centres.push_back({number(node.node), {}});
            for (const auto &[leader, factor] : node.leaders)
              centres.back().leaders.emplace_back(number(leader), factor);
          }
    }

    /// Set their displacements.
    void bind(const Numbers &is_bound, Numbers *u) const
    {
      for (const Centre &centre : centres)
        {
          Numbers sum = -u[centre.dof];
          for (const auto &[leader, factor] : centre.leaders)
            sum += factor * u[leader];
          u[centre.dof] += is_bound * sum;
        }
    }

    /// Hand their forces over to those that they follow.
    void hand_over(const Numbers &is_bound, Numbers *forces) const
    {
      for (const Centre &centre : centres)
        {
          const Numbers force = is_bound * forces[centre.dof];
          for (const auto &[leader, factor] : centre.leaders)
            forces[leader] += factor * force;
          forces[centre.dof] -= force;
        }
    }

    /// The same of the diagonal of a tangent, by unknown of the cell, without
    /// the couplings between them.
    void hand_over_diagonal(const Numbers          &is_bound,
                            AlignedVector<Numbers> &diagonal) const
    {
      for (const Centre &centre : centres)
        {
          Numbers      &of_centre = diagonal[numbers_in_cell[centre.dof]];
          const Numbers stiffness = is_bound * of_centre;
          for (const auto &[leader, factor] : centre.leaders)
            diagonal[numbers_in_cell[leader]] += (factor * factor) * stiffness;
          of_centre -= stiffness;
        }
    }

  private:
    using Number = typename Numbers::value_type;

    /// An unknown, and those that it follows, in the numbers of FEEvaluation.
    struct Centre
    {
      unsigned int                                 dof;
      std::vector<std::pair<unsigned int, Number>> leaders;
    };

    std::vector<unsigned int> numbers_in_cell;
    std::vector<Centre>       centres;
  };
} // namespace Contact

#endif
