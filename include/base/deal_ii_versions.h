/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_deal_ii_versions_h
#define contact_deal_ii_versions_h

#include <deal.II/base/config.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/solution_transfer.h>
#if !DEAL_II_VERSION_GTE(9, 7, 0)
#  include <deal.II/distributed/solution_transfer.h>
#endif

#include <vector>

namespace Contact
{
  using namespace dealii;

  // The calls that differ between the versions of deal.II from 9.4 on. Since
  // 9.7 there is one SolutionTransfer for all meshes, the former one of
  // distributed meshes.

  /// Carries solutions over to a refined mesh of which a rank has a part.
  template<int dim, class VectorType>
  using DistributedTransfer =
#if DEAL_II_VERSION_GTE(9, 7, 0)
    SolutionTransfer<dim, VectorType>;
#else
    parallel::distributed::SolutionTransfer<dim, VectorType>;
#endif

  /// Interpolate the vectors that @p transfer was prepared with, @p old, on a
  /// mesh of which every rank has all cells.
  template<class Transfer>
  void interpolate(Transfer                          &transfer,
                   const std::vector<Vector<double>> &old,
                   std::vector<Vector<double>>       &refined)
  {
#if DEAL_II_VERSION_GTE(9, 7, 0)
    (void)old; // it knows them
    transfer.interpolate(refined);
#else
    transfer.interpolate(old, refined);
#endif
  }
} // namespace Contact

#endif
