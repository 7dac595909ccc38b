/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The yardstick of a scene without contact: linear elasticity as one writes it
// with deal.II, after step-8, and nothing else. The block of yardstick.py in
// plane strain: boundary 1 held, traction -1 MPa on boundary 2. Prints the
// unknowns and the displacement in y of the vertex (1, 1).
//   plain_elasticity MESH REFINEMENTS DEGREE UMFPACK|CHOLMOD|AMG
// The last two are the solvers of the contact program itself, so that all that
// is compared is what is around them.

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <fstream>
#include <iomanip>
#include <iostream>

#include "solvers/direct/definite_solver.h"

using namespace dealii;
using Contact::DefiniteSolver;



template<class Matrix, class Vector>
void assemble(const DoFHandler<2>             &dof_handler,
              const AffineConstraints<double> &constraints,
              Matrix                          &matrix,
              Vector                          &rhs)
{
  const double E = 210000, nu = 0.3;
  const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double mu     = E / (2 * (1 + nu));

  const auto                          &fe = dof_handler.get_fe();
  const MappingQ<2>                    mapping(fe.degree);
  const QGauss<2>                      quadrature(fe.degree + 1);
  const QGauss<1>                      face_quadrature(fe.degree + 1);
  FEValues<2>                          values(mapping,
                     fe,
                     quadrature,
                     update_gradients | update_JxW_values);
  FEFaceValues<2>                      face_values(mapping,
                              fe,
                              face_quadrature,
                              update_values | update_JxW_values);
  const unsigned int                   n = fe.n_dofs_per_cell();
  FullMatrix<double>                   cell_matrix(n, n);
  dealii::Vector<double>               cell_rhs(n);
  std::vector<types::global_dof_index> dofs(n);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      values.reinit(cell);
      cell_matrix = 0;
      cell_rhs    = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int  c  = fe.system_to_component_index(i).first;
            const Tensor<1, 2> &Ni = values.shape_grad(i, q);
            for (unsigned int j = 0; j < n; ++j)
              {
                const unsigned int  d  = fe.system_to_component_index(j).first;
                const Tensor<1, 2> &Nj = values.shape_grad(j, q);
                cell_matrix(i, j) +=
                  values.JxW(q) * (lambda * Ni[c] * Nj[d] + mu * Ni[d] * Nj[c] +
                                   (c == d ? mu * (Ni * Nj) : 0.));
              }
          }
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == 2)
          {
            face_values.reinit(cell, face);
            for (unsigned int q = 0; q < face_quadrature.size(); ++q)
              for (unsigned int i = 0; i < n; ++i)
                if (fe.system_to_component_index(i).first == 1)
                  cell_rhs(i) -=
                    face_values.shape_value(i, q) * face_values.JxW(q);
          }
      cell->get_dof_indices(dofs);
      constraints.distribute_local_to_global(cell_matrix,
                                             cell_rhs,
                                             dofs,
                                             matrix,
                                             rhs);
    }
}



int main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  AssertThrow(argc == 5, ExcMessage("MESH REFINEMENTS DEGREE SOLVER"));
  const unsigned int degree = std::stoi(argv[3]);
  const std::string  solver = argv[4];

  Triangulation<2> triangulation;
  GridIn<2>        grid_in(triangulation);
  std::ifstream    file(argv[1]);
  grid_in.read_msh(file);
  triangulation.refine_global(std::stoi(argv[2]));

  const FESystem<2> fe(FE_Q<2>(degree), 2);
  DoFHandler<2>     dof_handler(triangulation);
  dof_handler.distribute_dofs(fe);
  const auto n = dof_handler.n_dofs();

  AffineConstraints<double> constraints;
  VectorTools::interpolate_boundary_values(dof_handler,
                                           1,
                                           Functions::ZeroFunction<2>(2),
                                           constraints);
  constraints.close();
  DynamicSparsityPattern dsp(n);
  DoFTools::make_sparsity_pattern(dof_handler, dsp, constraints, false);

  Vector<double> u(n), rhs(n);
  if (solver == "UMFPACK")
    {
      SparsityPattern      pattern;
      SparseMatrix<double> matrix;
      pattern.copy_from(dsp);
      matrix.reinit(pattern);
      assemble(dof_handler, constraints, matrix, rhs);
      SparseDirectUMFPACK direct;
      direct.initialize(matrix);
      direct.vmult(u, rhs);
    }
  else
    {
      const IndexSet         all = complete_index_set(n);
      DefiniteSolver::Matrix matrix;
      matrix.reinit(all, all, dsp, MPI_COMM_WORLD);
      assemble(dof_handler, constraints, matrix, rhs);
      matrix.compress(VectorOperation::add);

      std::vector<Point<2>> points(n);
      DoFTools::map_dofs_to_support_points(MappingQ<2>(1), dof_handler, points);
      const IndexSet in_x =
        DoFTools::extract_dofs(dof_handler,
                               fe.component_mask(
                                 FEValuesExtractors::Scalar(0)));
      DefiniteSolver::CoarseSpace space;
      auto                       &modes = space.modes;
      modes.assign(3, std::vector<double>(n));
      for (unsigned int i = 0; i < n; ++i)
        {
          const bool x                    = in_x.is_element(i);
          (x ? modes[0][i] : modes[1][i]) = 1;
          modes[2][i] = x ? 0.5 - points[i][1] : points[i][0] - 0.5;
        }
      DefiniteSolver::Vector b(all, MPI_COMM_WORLD), x(all, MPI_COMM_WORLD);
      std::copy(rhs.begin(), rhs.end(), b.begin());
      Contact::Counters counters;
      const auto        definite = DefiniteSolver::create(
        Contact::Parameters::Choice<Contact::Parameters::SolverKind>(solver),
        /*may_be_indefinite=*/false,
        space,
        counters);
      definite->set_matrix(matrix,
                           matrix,
                           /*new_pattern=*/true,
                           {});
      // The load is 1 N/mm; the contact program solves to the same.
      definite->solve(b, 1e-9, x);
      std::copy(x.begin(), x.end(), u.begin());
    }
  constraints.distribute(u);

  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex(v).distance(Point<2>(1, 1)) < 1e-10)
        {
          std::cout << n << ' ' << std::setprecision(12)
                    << u[cell->vertex_dof_index(v, 1)] << std::endl;
          return 0;
        }
  return 1;
}
