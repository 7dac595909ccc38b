/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/multigrid_level.h"

#include <deal.II/dofs/dof_tools.h>

#include "solid/followers.h"

namespace Contact
{
  template<int dim>
  MultigridLevel<dim>::MultigridLevel(
    const Triangulation<dim>                        &mesh,
    const Discretization<dim>                       &finest,
    const std::map<types::material_id, ElasticBody> &elastic_bodies)
    : dof_handler(&mesh == &finest.mesh.triangulation ? finest.dof_handler
                                                      : own_dof_handler)
    , mapping(finest.mapping[0])
    , quadrature(finest.quadrature[0])
    , finest(finest)
    , communicator(finest.communicator)
    , elastic_bodies(elastic_bodies)
  {
    if (&dof_handler == &own_dof_handler)
      {
        own_dof_handler.reinit(mesh);
        own_dof_handler.distribute_dofs(finest.fe[0]);
      }
  }



  // Those of cells that are this rank's or next to it.
  template<int dim>
  typename MultigridLevel<dim>::Dofs
  MultigridLevel<dim>::on_ghosts(const Dofs &own) const
  {
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    Vector marks(dof_handler.locally_owned_dofs(), relevant, communicator);
    for (const Dof dof : own)
      marks(dof) = 1;
    marks.update_ghost_values();
    Dofs all;
    for (const Dof dof : relevant)
      if (marks(dof) != 0)
        all.push_back(dof);
    return all;
  }



  template<int dim>
  void MultigridLevel<dim>::make_operator(const Dofs &fixed)
  {
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    constraints.reinit(relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    for (const Dof dof : on_ghosts(fixed))
      if (!constraints.is_constrained(dof))
        constraints.add_line(dof);
    bind_centres(finest, dof_handler, constraints);
    constraints.close();
    centres = std::make_unique<CentreBinding<dim, Number>>(finest,
                                                           dof_handler,
                                                           constraints);
    bodies  = std::make_unique<BodyOperator<dim, Number>>(mapping,
                                                         quadrature,
                                                         dof_handler,
                                                         *centres,
                                                         elastic_bodies);
    for (Vector *vector : {&rhs, &solution, &residual})
      bodies->initialize(*vector);
    make_smoother();
  }



  template<int dim>
  SurfaceRows MultigridLevel<dim>::bound_centres() const
  {
    AffineConstraints<double> bound;
    bind_centres(finest, dof_handler, bound);
    bound.close();
    Dofs centres;
    for (const auto &line : bound.get_lines())
      centres.push_back(line.index);
    return SurfaceRows(centres, bound, dof_handler.locally_owned_dofs())
      .of_all_ranks(communicator);
  }



  template<int dim>
  void MultigridLevel<dim>::linearize()
  {
    bodies->linearize(solution);
    make_smoother();
  }



  // Smooth what the next coarser mesh does not see: the upper part of the
  // spectrum of the matrix by its diagonal, from a sixteenth of the largest
  // eigenvalue on, which a few conjugate gradients estimate: that of the bodies
  // alone, since contact makes none larger.
  template<int dim>
  void MultigridLevel<dim>::make_smoother()
  {
    diagonal = bodies->diagonal();
    inverse  = std::make_shared<DiagonalMatrix<Vector>>();
    springs.initialize({}, dof_handler.locally_owned_dofs(), communicator);
    invert_diagonal();
    projection.disable();
    has_lines = false;

    typename decltype(smoother)::AdditionalData data;
    data.degree              = 4;
    data.smoothing_range     = 16;
    data.eig_cg_n_iterations = 12;
    data.preconditioner      = inverse;
    smoother.initialize(*this, data);
    largest_eigenvalue =
      smoother.estimate_eigenvalues(rhs).max_eigenvalue_estimate;
  }



  // With E the diagonal matrix of the row sums, which is not smaller than the
  // springs W, and lambda the largest eigenvalue of K by D,
  //   K + W <= lambda D + E = lambda (D + E / lambda):
  // by this diagonal no eigenvalue is larger than those of the bodies alone,
  // which the smoother is made for.
  template<int dim>
  void MultigridLevel<dim>::invert_diagonal()
  {
    Vector &inverted = inverse->get_vector();
    inverted         = diagonal;
    springs.add_row_sums(1 / largest_eigenvalue, inverted);
    for (auto &value : inverted)
      value = value > 0 ? 1 / value : 1;
  }



  template<int dim>
  void MultigridLevel<dim>::set_springs(
    const std::vector<SurfaceSpring> &new_springs)
  {
    const bool had_any = springs.are_any();
    springs.initialize(new_springs,
                       dof_handler.locally_owned_dofs(),
                       communicator);
    if (!had_any && !springs.are_any())
      return;
    invert_diagonal();
    has_lines = false; // the projection is of another diagonal
  }



  template<int dim>
  bool MultigridLevel<dim>::set_lines(SurfaceRows new_lines)
  {
    if (has_lines && new_lines == lines_of_all)
      return false;
    has_lines    = false; // if a factorization fails
    lines_of_all = std::move(new_lines);
    lines        = SurfaceLines<Number>(own_lines(),
                                 dof_handler.locally_owned_dofs(),
                                 communicator);
    projection.initialize(lines_of_all, inverse->get_vector());
    has_lines = true;
    return true;
  }



  template<int dim>
  void MultigridLevel<dim>::vmult(Vector &dst, const Vector &src) const
  {
    bodies->vmult(dst, src);
    springs.add_forces(dst, src);
    projection.project_transposed(dst);
  }



  template<int dim>
  typename MultigridLevel<dim>::Number MultigridLevel<dim>::el(const Dof,
                                                               const Dof) const
  {
    AssertThrow(false, ExcNotImplemented());
    return 0;
  }

  template class MultigridLevel<2>;
  template class MultigridLevel<3>;
} // namespace Contact
