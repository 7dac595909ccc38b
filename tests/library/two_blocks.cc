/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A block is pressed onto another one and dragged along it with friction: a
// program with a mesh and an elasticity of its own (own_blocks.h), and contact
// from the library; displacements and multipliers are solved for together.
// Usage: two_blocks 2|3. See include/contact/README.md.

#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/sparse_direct.h>

#include <iostream>

#include "bodies/given_bodies.h"
#include "contact/interface/contact_kernel.h"
#include "own_blocks.h"

template<int dim>
void run()
{
  // The bodies as contact sees them, and one pair of their boundaries.
  const OwnBlocks<dim>            blocks;
  const MappingQ<dim>             mapping(1);
  const Contact::GivenBodies<dim> bodies(mapping,
                                         blocks.dof_handler,
                                         blocks.constraints,
                                         {{"Sole", {sole}},
                                          {"Ground", {ground}}},
                                         blocks.moduli);
  Contact::Parameters::Contact    pair;
  pair.slave                  = "Sole";
  pair.master                 = "Ground";
  pair.friction_coefficient   = 0.3;
  pair.augmentation_parameter = 1; // of stiffness by size, as in 3-D
  Contact::ContactInterface<dim> interface(bodies, bodies, {pair});

  // Displacements, and behind them the multipliers.
  const unsigned int     n = blocks.dof_handler.n_dofs();
  const unsigned int     N = n + interface.n_multipliers();
  Contact::GhostedVector start(N), solution(N), rhs(N);
  interface.pair(start);
  for (const auto &[dof, value] : blocks.prescribed)
    solution[dof] = value;
  interface.active_set.initialize(start);

  const AffineConstraints<double> &constraints = blocks.constraints;
  DynamicSparsityPattern           couplings(N, N);
  DoFTools::make_sparsity_pattern(blocks.dof_handler, couplings, constraints);
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
      blocks.assemble(solution,
                      [&](const auto &K, const auto &f, const auto &dofs) {
                        constraints.distribute_local_to_global(K, dofs, matrix);
                        constraints.distribute_local_to_global(f, dofs, rhs);
                      });
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
