/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_patch_recovery_h
#define contact_patch_recovery_h

#include <map>
#include <utility>
#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Fields of a richer space from displacement fields of degree p: around each
   * vertex of each body the polynomial of degree p + 1 that fits the values at
   * the nodes of the cells there best (least squares); in a cell those of its
   * vertices, blended by the vertex shape functions. At the boundary of a body
   * the patch has one more layer of cells. Where the solution is smooth the
   * result is better than the field by an order; near a singularity it is as
   * bad.
   *
   * For fields that are zero nowhere by themselves: whoever has supports puts
   * them in afterwards. On one rank.
   */
  class PatchRecovery
  {
  public:
    /// Fit the @p fields of a discretization, which may have more behind the
    /// displacements.
    PatchRecovery(const Discretization<2>          &discretization,
                  const std::vector<GhostedVector> &fields);

    /// Their values at the nodes of the @p refined mesh, whose cells are the
    /// children of those of the first.
    std::vector<GhostedVector> values(const Discretization<2> &refined) const;

  private:
    /// A polynomial for each component of each field, in (X - center)/size.
    struct Patch
    {
      Point<2>                         center;
      double                           size = 1; // [mm]
      std::vector<std::vector<double>> coefficients;
    };

    using Cells = std::set<DoFHandler<2>::active_cell_iterator>;

    /// A vertex of a body.
    using Key = std::pair<types::material_id, unsigned int>;

    std::map<Key, Cells> find_patches() const;
    Patch                fit(const Point<2>                   &center,
                             const Cells                      &cells,
                             const std::vector<Point<2>>      &X,
                             const std::vector<GhostedVector> &fields) const;
    void                 add_values(const Point<2>             &X,
                                    const Patch                &patch,
                                    const double                factor,
                                    const NodeDoFs<2>          &node,
                                    std::vector<GhostedVector> &values) const;
    std::vector<double>  monomials(const Point<2> &X, const Patch &patch) const;

    const Discretization<2> &discretization;
    const unsigned int       n_fields;
    std::map<Key, Patch>     patches;
  };
} // namespace Contact

#endif
