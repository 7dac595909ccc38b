/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_elasticity_h
#define contact_elasticity_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <memory>
#include <vector>

#include "discretization.h"
#include "kinematics.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The bodies: residual and consistent tangent of
   *   integral S(u) : delta E dX - dead load . delta u = 0.
   *
   * The gradients of the shape functions are with respect to the reference
   * configuration and never change: they are computed once. Where the centre
   * of a quadrangle is bound, they are those of the eight free nodes, so that
   * the centre costs nothing in assembly.
   */
  class Elasticity
  {
  public:
    virtual ~Elasticity() = default;

    /// The kinematics named in the parameters.
    static std::unique_ptr<Elasticity>
    create(const Discretization     &discretization,
           const Parameters::Solids &parameters);

    /// Add the couplings of the bodies.
    void add_couplings(DynamicSparsityPattern &pattern) const;

    /// What is done with a cell: its unknowns, its tangent (empty if there was
    /// none asked for) and its internal forces.
    using CellVisitor =
      std::function<void(const std::vector<types::global_dof_index> &dofs,
                         const FullMatrix<double>                   &tangent,
                         const Vector<double>                       &forces)>;

    /// Visit all cells of this rank, or only those with the numbers @p chosen.
    void visit_cells(const Vector<double> &u,
                     const bool            with_tangent,
                     const CellVisitor    &visitor) const;
    void visit_cells(const Vector<double>            &u,
                     const bool                       with_tangent,
                     const std::vector<unsigned int> &chosen,
                     const CellVisitor               &visitor) const;

    /// How many cells this rank has, and the unknowns of one of them.
    unsigned int n_cells() const;
    const std::vector<types::global_dof_index> &
    dofs_of_cell(const unsigned int number) const;

    /**
     * Add minus the residual (dead forces under @p load_factor minus internal
     * forces) to @p rhs and, unless @p matrix is null, the tangent to it;
     * constraints eliminated. Of several ranks each adds its own part.
     */
    void assemble(const Vector<double> &u,
                  const double          load_factor,
                  Vector<double>       &rhs,
                  SparseMatrix<double> *matrix) const;

    /**
     * The forces on all nodes, unconstrained: internal minus load. Where a
     * node is supported or in contact, the force that acts there.
     */
    Vector<double> forces(const Vector<double> &u,
                          const double          load_factor) const;

    /// Cauchy stress [MPa] in all quadrature points, by active cell; nothing
    /// for the cells that this rank does not know.
    virtual std::vector<std::vector<SymmetricTensor<2, 3>>>
    stresses(const Vector<double> &u) const = 0;

    /// The tangent does not depend on the displacement.
    virtual bool is_linear() const = 0;

    /// Young's modulus [MPa] of a body.
    double young(const types::material_id body) const;

    /// The material of a body.
    const Material &material(const types::material_id body) const;

  protected:
    Elasticity(const Discretization     &discretization,
               const Parameters::Solids &parameters);

    /// What of a cell stays the same during a run.
    struct Cell
    {
      unsigned int                         active_index;
      const Material                      *material;
      std::vector<types::global_dof_index> dofs;      // (x, y) node by node
      std::vector<double>                  JxW;       // by point
      std::vector<Tensor<1, 2>>            gradients; // by point, then node

      unsigned int n_nodes() const
      {
        return dofs.size() / 2;
      }
    };

    /// Internal forces and, if @p tangent is not null, tangent of a cell.
    virtual void cell_forces(const Cell           &cell,
                             const Vector<double> &u,
                             FullMatrix<double>   *tangent,
                             Vector<double>       &forces) const = 0;

    const Discretization                  &discretization;
    std::map<types::material_id, Material> materials;
    std::map<types::material_id, double>   young_moduli;

    /// First the cells of this rank, then the neighbors' cells beside them.
    std::vector<Cell> cells;
    unsigned int      n_own_cells = 0;

  private:
    void visit_cell(const Cell           &cell,
                    const Vector<double> &u,
                    const bool            with_tangent,
                    FullMatrix<double>   &tangent,
                    Vector<double>       &forces,
                    const CellVisitor    &visitor) const;
    void tabulate();
  };
} // namespace Contact

#endif
