/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_nested_transfer_h
#define contact_nested_transfer_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

namespace Contact
{
  using namespace dealii;

  /**
   * Interpolation between the displacements on a mesh and on the one refined
   * once: by cells, as deal.II does; on triangles and tetrahedra, where that of
   * deal.II 9.4 confuses the components, by a matrix, on one rank.
   */
  template<int dim, typename Number>
  class NestedTransfer
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Constraints are taken as homogeneous. Collective.
    void initialize(const DoFHandler<dim>           &fine,
                    const DoFHandler<dim>           &coarse,
                    const AffineConstraints<Number> &of_fine,
                    const AffineConstraints<Number> &of_coarse);

    /// The values of @p fine at the nodes of @p coarse.
    void interpolate(Vector &coarse, const Vector &fine) const;

    void prolongate_and_add(Vector &fine, const Vector &coarse) const;
    void restrict_and_add(Vector &coarse, const Vector &fine) const;

  private:
    void make_matrix(const DoFHandler<dim>           &fine,
                     const DoFHandler<dim>           &coarse,
                     const AffineConstraints<Number> &of_fine,
                     const AffineConstraints<Number> &of_coarse);

    MGTwoLevelTransfer<dim, Vector> by_cells;

    SparsityPattern      pattern; // empty unless there is a matrix
    SparseMatrix<Number> matrix;
    std::vector<types::global_dof_index> at_node; // fine ones, by coarse ones
  };
} // namespace Contact

#endif
