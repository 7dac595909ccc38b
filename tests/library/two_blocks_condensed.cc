/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The blocks of two_blocks.cc with the multipliers eliminated: contact is lines
// of AffineConstraints, as in step-42, and the displacements alone are solved
// for. Usage: two_blocks_condensed 2|3. See include/contact/README.md.

#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/sparse_direct.h>

#include <iostream>
#include <numeric>

#include "bodies/given_bodies.h"
#include "contact/interface/contact_kernel.h"
#include "own_blocks.h"
#include "solvers/condensed/contact_elimination.h"

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

  const unsigned int                   n = blocks.dof_handler.n_dofs();
  std::vector<types::global_dof_index> all(n);
  std::iota(all.begin(), all.end(), 0);
  Contact::GhostedVector start(n + interface.n_multipliers()), solution = start;
  interface.pair(start);
  for (const auto &[dof, value] : blocks.prescribed)
    solution[dof] = value;
  interface.active_set.initialize(start);
  Contact::ContactElimination<dim> elimination(bodies, &interface);

  for (unsigned int step = 0; step < 30; ++step)
    {
      // Multipliers are what the bodies lack for balance.
      Contact::GhostedVector residual(solution.size());
      blocks.assemble(solution,
                      [&](const auto &, const auto &f, const auto &dofs) {
                        for (unsigned int i = 0; i < dofs.size(); ++i)
                          residual[dofs[i]] += f[i];
                      });
      if (step > 0)
        elimination.recover_multipliers(residual, start, solution);
      const unsigned int changes =
        interface.active_set.update(solution, start, /*keep=*/step > 0);
      elimination.make(solution,
                       start,
                       all,
                       solution,
                       /*any_rank_may_add=*/true);
      Contact::ContactKernel<dim>(interface).assemble(
        solution,
        start,
        {/*moving_geometry=*/false},
        residual,
        nullptr);
      elimination.condense(residual);

      // Rows by the virtual displacements; columns by the displacements, whose
      // constants close gaps and slips: -K h.
      const auto            &rows    = elimination.test_constraints();
      const auto            &columns = elimination.constraints();
      DynamicSparsityPattern couplings(n, n);
      const auto             couple = [&](const auto &dofs) {
        rows.add_entries_local_to_global(dofs, columns, dofs, couplings);
      };
      std::vector<types::global_dof_index> dofs(blocks.fe.n_dofs_per_cell());
      for (const auto &cell : blocks.dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          couple(dofs);
        }
      for (const auto &term : elimination.slip_direction_terms())
        couple(term.dofs);
      for (const auto dof : all)
        couplings.add(dof, dof);
      SparsityPattern pattern;
      pattern.copy_from(couplings);
      SparseMatrix<double> matrix(pattern);
      Vector<double>       rhs(residual.begin(), residual.begin() + n);
      const auto add = [&](const auto &K, const auto &load, const auto &dofs) {
        Vector<double> h(dofs.size()), force(dofs.size());
        for (unsigned int i = 0; i < dofs.size(); ++i)
          h[i] = -columns.get_inhomogeneity(dofs[i]);
        K.vmult(force, h);
        force += load;
        rows.distribute_local_to_global(K, dofs, columns, dofs, matrix);
        rows.distribute_local_to_global(force, dofs, rhs);
      };
      const Vector<double> none(blocks.fe.n_dofs_per_cell());
      blocks.assemble(solution,
                      [&](const auto &K, const auto &, const auto &dofs) {
                        add(K, none, dofs);
                      });
      for (const auto &term : elimination.slip_direction_terms())
        add(term.stiffness, term.load, term.dofs);
      for (const auto dof : all)
        if (rows.is_constrained(dof))
          matrix.diag_element(dof) = 1, rhs[dof] = 0;
      std::cout << "step " << step << ": residual " << rhs.linfty_norm() << ", "
                << changes << " statuses change\n";
      if (step > 0 && changes == 0 && rhs.linfty_norm() < 1e-8)
        break;
      SparseDirectUMFPACK solver;
      Vector<double>      update(n);
      solver.initialize(matrix);
      solver.vmult(update, rhs);
      columns.distribute(update);
      for (unsigned int i = 0; i < n; ++i)
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
