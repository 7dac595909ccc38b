/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_multigrid_h
#define contact_contact_multigrid_h

#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include "solid/elasticity.h"
#include "solvers/body_operator.h"
#include "solvers/definite_solver.h"
#include "solvers/surface_lines.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Geometric multigrid for C^T K C: K the stiffness of the bodies, C the
   * elimination of the active points. All levels know the contact: the line of
   * an eliminated node on a coarser mesh is that of the same node on the finer
   * one, with the values of the other nodes interpolated. So what a coarse mesh
   * corrects does not part the bodies, and a body that only contact holds is
   * held on all levels.
   *
   * Levels are the meshes that global coarsening makes, in single precision;
   * Chebyshev polynomials in the Jacobi-scaled matrix smooth, CHOLMOD solves on
   * the coarsest one.
   */
  template<int dim>
  class ContactMultigrid
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Number = float;
    using Vector = LinearAlgebra::distributed::Vector<Number>;
    using Fine   = LinearAlgebra::distributed::Vector<double>;

    ContactMultigrid(const Discretization<dim> &discretization,
                     const Elasticity<dim>     &elasticity);
    ~ContactMultigrid();

    /// Linearise bodies of large displacement in @p solution. The lines have to
    /// be set anew.
    void linearize(const Fine &solution);

    /// Take over the elimination of the active points: of @p eliminated in the
    /// closed @p constraints.
    void set_lines(const Dofs                      &eliminated,
                   const AffineConstraints<double> &constraints);

    /// One V-cycle.
    void vmult(Fine &dst, const Fine &src) const;

    std::size_t memory() const;

  private:
    class Level;
    class Between;

    void factorize_coarse();
    void cycle(const unsigned int l) const;

    const Discretization<dim>                             &discretization;
    std::vector<std::shared_ptr<const Triangulation<dim>>> meshes;
    std::map<types::material_id, Material>                 materials;
    std::set<types::material_id>                           small_strain;
    std::vector<std::unique_ptr<Level>>                    levels;
    std::vector<std::unique_ptr<Between>> between; // l: levels l and l + 1
    std::unique_ptr<DefiniteSolver>       coarse_solver;
    TrilinosWrappers::SparseMatrix        coarse_matrix;
    dealii::Vector<double>                coarse_displacement; // of large ones
  };
} // namespace Contact

#endif
