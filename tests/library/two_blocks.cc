/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A block is pressed onto another one and dragged along it with friction: a
// program with a mesh and an elasticity (small strain) of its own, and contact
// from the library. Usage: two_blocks 2|3. See include/contact/README.md.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/numerics/vector_tools.h>

#include <iostream>

#include "bodies/given_bodies.h"
#include "contact/interface/contact_kernel.h"

using namespace dealii;

const types::boundary_id base = 1, ground = 2, sole = 3, head = 4;
const types::material_id lower = 0, upper = 1;

template<int dim>
void make_mesh(Triangulation<dim> &mesh)
{
  const auto block = [](Triangulation<dim> &triangulation,
                        const double        width,
                        const double        bottom,
                        const double        top,
                        const unsigned int  n_along,
                        const unsigned int  n_across) {
    Point<dim>                from, to;
    std::vector<unsigned int> n(dim, n_along);
    for (unsigned int d = 0; d < dim; ++d)
      from[d] = -width / 2, to[d] = width / 2;
    from[dim - 1] = bottom, to[dim - 1] = top, n[dim - 1] = n_across;
    GridGenerator::subdivided_hyper_rectangle(triangulation, n, from, to);
  };
  const double       gap = 0.001; // no node is of both
  Triangulation<dim> below, above;
  block(below, 4, -2, 0, 8, 4);
  block(above, 2, gap, 1 + gap, 5, 3);
  GridGenerator::merge_triangulations(below, above, mesh, gap / 1000);

  const std::map<types::boundary_id, double> heights = {{base, -2},
                                                        {ground, 0},
                                                        {sole, gap},
                                                        {head, 1 + gap}};
  for (const auto &cell : mesh.active_cell_iterators())
    {
      cell->set_material_id(cell->center()[dim - 1] < 0 ? lower : upper);
      for (const auto &face : cell->face_iterators())
        for (const auto &[id, height] : heights)
          if (face->at_boundary() &&
              std::abs(face->center()[dim - 1] - height) < gap / 1000)
            face->set_boundary_id(id);
    }
}

// Minus the residual, and the tangent, of linear elasticity.
template<int dim>
void assemble_bodies(const DoFHandler<dim>                      &dof_handler,
                     const std::map<types::material_id, double> &moduli,
                     const AffineConstraints<double>            &constraints,
                     const Contact::GhostedVector               &u,
                     Contact::GhostedVector                     &rhs,
                     SparseMatrix<double>                       &matrix)
{
  const auto                          &fe = dof_handler.get_fe();
  FEValues<dim>                        fe_values(fe,
                          QGauss<dim>(fe.degree + 1),
                          update_gradients | update_JxW_values);
  const unsigned int                   n = fe.n_dofs_per_cell();
  FullMatrix<double>                   K(n, n);
  Vector<double>                       f(n), u_cell(n);
  std::vector<types::global_dof_index> dofs(n);
  const FEValuesExtractors::Vector     displacement(0);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      const double E = moduli.at(cell->material_id()), nu = 0.3;
      const double mu     = E / (2 * (1 + nu));
      const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
      fe_values.reinit(cell);
      cell->get_dof_indices(dofs);
      const auto &v = fe_values[displacement];
      K             = 0;
      for (const unsigned int q : fe_values.quadrature_point_indices())
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            K(i, j) += (lambda * v.divergence(i, q) * v.divergence(j, q) +
                        2 * mu * v.symmetric_gradient(i, q) *
                          v.symmetric_gradient(j, q)) *
                       fe_values.JxW(q);
      for (unsigned int i = 0; i < n; ++i)
        u_cell[i] = -u[dofs[i]];
      K.vmult(f, u_cell);
      constraints.distribute_local_to_global(K, dofs, matrix);
      constraints.distribute_local_to_global(f, dofs, rhs);
    }
}

template<int dim>
void run()
{
  Triangulation<dim> mesh;
  make_mesh(mesh);
  const FESystem<dim> fe(FE_Q<dim>(1), dim);
  DoFHandler<dim>     dof_handler(mesh);
  dof_handler.distribute_dofs(fe);

  // Prescribed displacements, and supports of an update, under which they rest.
  std::map<types::global_dof_index, double> prescribed;
  std::vector<double>                       way(dim, 0.);
  way[0] = 0.02, way[dim - 1] = -0.05;
  VectorTools::interpolate_boundary_values(dof_handler,
                                           base,
                                           Functions::ZeroFunction<dim>(dim),
                                           prescribed);
  VectorTools::interpolate_boundary_values(dof_handler,
                                           head,
                                           Functions::ConstantFunction<dim>(
                                             way),
                                           prescribed);
  AffineConstraints<double> constraints;
  for (const auto &[dof, value] : prescribed)
    constraints.add_line(dof);
  constraints.close();

  // Contact: the bodies as it sees them, and one pair of their boundaries.
  const std::map<types::material_id, double> moduli = {{lower, 70000},
                                                       {upper, 210000}};
  const MappingQ<dim>                        mapping(1);
  const Contact::GivenBodies<dim>            bodies(mapping,
                                         dof_handler,
                                         constraints,
                                         {{"Sole", {sole}},
                                                     {"Ground", {ground}}},
                                         moduli);
  Contact::Parameters::Contact               pair;
  pair.slave                = "Sole";
  pair.master               = "Ground";
  pair.friction_coefficient = 0.3;
  Contact::ContactInterface<dim> interface(bodies, bodies, {pair});

  // Displacements, and behind them the multipliers.
  const unsigned int     n = dof_handler.n_dofs();
  const unsigned int     N = n + interface.n_multipliers();
  Contact::GhostedVector start(N), solution(N), rhs(N);
  interface.pair(start);
  for (const auto &[dof, value] : prescribed)
    solution[dof] = value;
  interface.active_set.initialize(start);

  DynamicSparsityPattern               couplings(N, N);
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      constraints.add_entries_local_to_global(dofs, couplings);
    }
  interface.add_couplings(couplings);
  for (unsigned int i = 0; i < N; ++i)
    couplings.add(i, i);
  SparsityPattern pattern;
  pattern.copy_from(couplings);
  SparseMatrix<double> matrix(pattern);

  // Newton's method, which is the search of the active set as well.
  for (unsigned int step = 0; step < 30; ++step)
    {
      const unsigned int changes =
        interface.active_set.update(solution, start, /*keep=*/step > 0);
      matrix = 0;
      rhs    = 0;
      assemble_bodies(dof_handler, moduli, constraints, solution, rhs, matrix);
      Contact::ContactKernel<dim>(interface)
        .assemble(solution, start, {/*moving_geometry=*/false}, rhs, &matrix);
      for (const auto &line : constraints.get_lines())
        matrix.diag_element(line.index) = 1, rhs[line.index] = 0;
      std::cout << "step " << step << ": residual " << rhs.linfty_norm() << ", "
                << changes << " statuses change\n";
      if (step > 0 && changes == 0 && rhs.linfty_norm() < 1e-8)
        break;
      SparseDirectUMFPACK solver;
      Vector<double>      update(N);
      std::copy(rhs.begin(), rhs.end(), update.begin());
      solver.solve(matrix, update);
      for (unsigned int i = 0; i < N; ++i)
        solution[i] += update[i];
    }

  Tensor<1, dim> force; // of the master on the slave
  for (const auto &point : interface.points())
    {
      const auto traction =
        interface.active_set.traction(point,
                                      interface.state(point, solution, start));
      force += point.weight * traction.p * point.normal;
      for (unsigned int t = 0; t < dim - 1; ++t)
        force += point.weight * traction.q[t] * point.tangents[t];
    }
  std::cout.precision(10);
  std::cout << "force " << force << std::endl;
}

int main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc == 2 && std::string(argv[1]) == "3")
    run<3>();
  else
    run<2>();
}
