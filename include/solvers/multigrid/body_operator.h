/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_operator_h
#define contact_body_operator_h

#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "solid/cell_tables.h"
#include "solvers/multigrid/centre_binding.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The tangent of elastic bodies as a matrix-free operator, from deal.II's
   * MatrixFree: in hypercubes by sum factorization. Hanging nodes,
   * supports and bound centres are eliminated. Bodies of St. Venant and
   * Kirchhoff's material keep the gradients of the displacement in the
   * quadrature points, where with F = 1 + grad u and the stress S the tangent
   * is dP = F dS + grad(du) S,   dS = D dE,   dE = sym(F^T grad(du)). The
   * strain E has the stress D E = lambda tr(E) 1 + 2 mu E, and that of what
   * cells assume as a whole (CellModes).
   */
  template<int dim, typename Number>
  class BodyOperator
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Bodies are those of the material ids. Constraints are taken as
    /// homogeneous; all references have to live on.
    BodyOperator(const Mapping<dim>                              &mapping,
                 const Quadrature<dim>                           &quadrature,
                 const DoFHandler<dim>                           &dof_handler,
                 const CentreBinding<dim, Number>                &centres,
                 const std::map<types::material_id, ElasticBody> &bodies);

    ~BodyOperator();

    /// Linearise the bodies of large displacement in @p u, all of whose values
    /// are set.
    void linearize(const Vector &u);

    /// dst = K src: zero in constrained unknowns.
    void vmult(Vector &dst, const Vector &src) const;

    /// dst = K u, of @p u all of whose values are set, those of hanging nodes
    /// and supports, too: the internal forces of bodies in small strain. What
    /// hanging nodes get is handed over.
    void forces(Vector &dst, const Vector &u) const;

    /// The diagonal of K; zero in constrained unknowns. What hanging nodes hand
    /// over is without the couplings between them, which a smoother does not
    /// need.
    Vector diagonal() const;

    /// Visit the cells of this rank: their tangent and unknowns, of which none
    /// is eliminated.
    void visit_tangents(
      const std::function<
        void(const FullMatrix<double>                   &tangent,
             const std::vector<types::global_dof_index> &dofs)> &visitor) const;

    void initialize(Vector &vector) const
    {
      vector.reinit(partitioner);
    }

    std::size_t memory() const;

  private:
    /// deal.II's MatrixFree of the widest vectors of numbers that the compiler
    /// is allowed to use: known to the source file alone.
    class Cells;

    std::unique_ptr<Cells>                             cells;
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;
  };
} // namespace Contact

#endif
