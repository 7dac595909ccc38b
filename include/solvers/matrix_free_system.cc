/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/matrix_free_system.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <sstream>

namespace Contact
{
  template<int dim>
  MatrixFreeSystem<dim>::MatrixFreeSystem(
    const Discretization<dim>   &discretization,
    const Elasticity<dim>       &elasticity,
    const ContactInterface<dim> *interface,
    ContactElimination<dim>     &elimination,
    TimerOutput                 &timer)
    : CondensedSystem<dim>(discretization,
                           elasticity,
                           interface,
                           elimination,
                           timer)
  {
  }



  template<int dim>
  void MatrixFreeSystem<dim>::reset()
  {
    if (bodies)
      return;
    std::map<types::material_id, Material> materials;
    for (const auto &body : discretization.mesh.bodies)
      materials.emplace(body.second, elasticity.material(body.second));
    bodies =
      std::make_unique<BodyOperator<dim, double>>(discretization.mapping[0],
                                                  discretization.dof_handler,
                                                  discretization.constraints,
                                                  materials);
    bodies->initialize(work);
    multigrid =
      std::make_unique<ContactMultigrid<dim>>(discretization, elasticity);
  }



  template<int dim>
  void MatrixFreeSystem<dim>::assemble_bulk(const GhostedVector &,
                                            const StressStiffness)
  {
  }



  template<int dim>
  void MatrixFreeSystem<dim>::add_interface(const bool)
  {
    lines      = SurfaceLines<double>(elimination.eliminated_dofs(),
                                 elimination.constraints());
    test_lines = SurfaceLines<double>(elimination.eliminated_dofs(),
                                      elimination.test_constraints());
  }



  template<int dim>
  void MatrixFreeSystem<dim>::prepare()
  {
    multigrid->set_lines(elimination.eliminated_dofs(),
                         elimination.constraints());
  }



  template<int dim>
  void MatrixFreeSystem<dim>::vmult(Vector &dst, const Vector &src) const
  {
    work = src;
    lines.expand(work);
    bodies->vmult(dst, work);
    test_lines.condense(dst);
  }



  template<int dim>
  unsigned int MatrixFreeSystem<dim>::solve_reduced(const GhostedVector &rhs,
                                                    const double   tolerance,
                                                    GhostedVector &x)
  {
    ++discretization.counters.linear_solves;
    Vector             b(work), of_rank(work);
    const unsigned int n = owned.n_elements();
    std::copy_n(rhs.begin(), n, b.begin());
    of_rank = 0;
    SolverControl control(max_iterations, tolerance);
    try
      {
        if (elimination.is_symmetric())
          SolverCG<Vector>(control).solve(*this, of_rank, b, *multigrid);
        else
          SolverGMRES<Vector>(control,
                              typename SolverGMRES<Vector>::AdditionalData(
                                /*max_n_tmp_vectors=*/52,
                                /*right_preconditioning=*/true))
            .solve(*this, of_rank, b, *multigrid);
      }
    catch (const SolverControl::NoConvergence &)
      {
        std::ostringstream residual;
        residual << control.last_value();
        throw NotConverged("geometric multigrid stalls at the residual " +
                           residual.str() + " N/mm (rings: N) after " +
                           std::to_string(max_iterations) +
                           " iterations; set Solution/Linear solver = AMG");
      }
    std::copy_n(of_rank.begin(), n, x.begin());
    return control.last_step();
  }

  template class MatrixFreeSystem<2>;
  template class MatrixFreeSystem<3>;
} // namespace Contact
