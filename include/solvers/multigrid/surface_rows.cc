/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/surface_rows.h"

#include <algorithm>
#include <numeric>

#include "base/exchange.h"

namespace Contact
{
  SurfaceRows::SurfaceRows(const Dofs                      &eliminated,
                           const AffineConstraints<double> &constraints,
                           const IndexSet                  &owned)
  {
    for (const Dof dof : eliminated)
      if (owned.is_element(dof))
        {
          if (const auto *entries = constraints.get_constraint_entries(dof))
            for (const auto &[other, factor] : *entries)
              add_entry(other, factor);
          end_row(dof);
        }
  }



  void SurfaceRows::add_row(const Dof dof, const Sum &sum)
  {
    for (const auto &[other, factor] : sum)
      add_entry(other, factor);
    end_row(dof);
  }



  void SurfaceRows::add_row(const SurfaceRows &from, const unsigned int row)
  {
    for (unsigned int k = from.begin(row); k < from.end(row); ++k)
      add_entry(from.others[k], from.factors[k]);
    end_row(from.dofs[row]);
  }



  void SurfaceRows::append(const SurfaceRows &rows)
  {
    const unsigned int n = others.size();
    dofs.insert(dofs.end(), rows.dofs.begin(), rows.dofs.end());
    others.insert(others.end(), rows.others.begin(), rows.others.end());
    factors.insert(factors.end(), rows.factors.begin(), rows.factors.end());
    for (const unsigned int end : rows.ends)
      ends.push_back(n + end);
  }



  void SurfaceRows::reserve(const SurfaceRows &rows)
  {
    dofs.reserve(rows.dofs.size());
    ends.reserve(rows.ends.size());
    others.reserve(rows.others.size());
    factors.reserve(rows.factors.size());
  }



  void SurfaceRows::sort()
  {
    const auto is_wrong = [](const Dof a, const Dof b) { return a >= b; };
    if (std::adjacent_find(dofs.begin(), dofs.end(), is_wrong) == dofs.end())
      return;
    std::vector<unsigned int> order(size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return dofs[a] != dofs[b]
                                ? dofs[a] < dofs[b]
                                : end(a) - begin(a) < end(b) - begin(b);
                     });
    SurfaceRows sorted;
    sorted.reserve(*this);
    for (const unsigned int row : order)
      if (sorted.dofs.empty() || sorted.dofs.back() != dofs[row])
        sorted.add_row(*this, row);
    *this = std::move(sorted);
  }



  unsigned int SurfaceRows::find(const Dof dof) const
  {
    const auto at = std::lower_bound(dofs.begin(), dofs.end(), dof);
    return at != dofs.end() && *at == dof ? at - dofs.begin()
                                          : numbers::invalid_unsigned_int;
  }



  SurfaceRows SurfaceRows::owned_by(const IndexSet &owned) const
  {
    SurfaceRows result;
    for (unsigned int row = 0; row < size(); ++row)
      if (owned.is_element(dofs[row]))
        result.add_row(*this, row);
    return result;
  }



  SurfaceRows SurfaceRows::of_all_ranks(const MPI_Comm communicator) const
  {
    std::vector<unsigned int> sizes(size());
    for (unsigned int row = 0; row < size(); ++row)
      sizes[row] = end(row) - begin(row);
    SurfaceRows all;
    all.dofs    = gathered(dofs, communicator);
    all.ends    = gathered(sizes, communicator);
    all.others  = gathered(others, communicator);
    all.factors = gathered(factors, communicator);
    std::partial_sum(all.ends.begin(), all.ends.end(), all.ends.begin());
    return all;
  }
} // namespace Contact
