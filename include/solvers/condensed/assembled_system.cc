/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/assembled_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <list>

#include "solvers/condensed/condensed_tangents.h"
#include "solvers/rigid_pieces/rigid_rotation.h"

namespace Contact
{
  template<int dim>
  AssembledSystem<dim>::AssembledSystem(
    const Discretization<dim>   &discretization,
    const Elasticity<dim>       &elasticity,
    const ContactInterface<dim> *interface,
    ContactElimination<dim>     &elimination,
    const Parameters::SolverKind solver_kind,
    TimerOutput                 &timer)
    : CondensedSystem<dim>(discretization, elasticity, elimination, timer)
    , couplings(discretization, interface)
    , solver_kind(solver_kind)
  {
  }



  template<int dim>
  bool AssembledSystem<dim>::has_room_for_points() const
  {
    return couplings.serve();
  }



  template<int dim>
  void AssembledSystem<dim>::make_room()
  {
    couplings.make();
  }



  template<int dim>
  bool AssembledSystem<dim>::make_room_for_lines()
  {
    return couplings.add_missing(elimination);
  }



  template<int dim>
  bool AssembledSystem<dim>::needs_all_tangents() const
  {
    return true;
  }



  // The matrix has room for what is added by the rank whose cells are beside.
  template<int dim>
  bool AssembledSystem<dim>::any_rank_may_add() const
  {
    return false;
  }



  // Cells of other ranks have shares in the rows of this one.
  template<int dim>
  typename AssembledSystem<dim>::Dofs
  AssembledSystem<dim>::all_of_interface(Dofs &&of_cells) const
  {
    Dofs all = couplings.all();
    for (const Dofs &of_rank :
         Utilities::MPI::all_gather(discretization.communicator, of_cells))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
  }



  template<int dim>
  void AssembledSystem<dim>::reset()
  {
    const MPI_Comm communicator = discretization.communicator;
    const auto    &dof_handler  = discretization.dof_handler;
    const auto     n            = dof_handler.n_dofs();

    // One rank has all rows, which is said by none.
    IndexSet   rows;
    const bool is_distributed =
      Utilities::MPI::n_mpi_processes(communicator) > 1;
    if (is_distributed)
      {
        rows = DoFTools::extract_locally_relevant_dofs(dof_handler);
        const auto touched = couplings.all();
        rows.add_indices(touched.begin(), touched.end());
        for (const auto &[dof, leader] : discretization.tied())
          rows.add_index(leader);
        for (const RigidBoundary<dim> &rigid :
             discretization.rigid_boundaries())
          for (const auto leader : rigid.leaders())
            rows.add_index(leader);
        rows.compress();
      }

    DynamicSparsityPattern pattern(n, n, rows);
    elasticity.add_couplings(pattern);
    add_interface_couplings(pattern);
    couplings.add_points(pattern);
    if (is_distributed)
      couplings.add_facets(pattern);
    for (const auto i : owned)
      pattern.add(i, i);

    if (is_distributed)
      SparsityTools::distribute_sparsity_pattern(pattern,
                                                 owned,
                                                 communicator,
                                                 rows);
    reset_matrix(pattern);
  }



  template<int dim>
  void AssembledSystem<dim>::add_interface_couplings(
    DynamicSparsityPattern &pattern) const
  {
    for (const unsigned int c : interface_cells)
      {
        const Dofs &cell_dofs = elasticity.dofs_of_cell(c);
        std::set<types::global_dof_index> coupled(cell_dofs.begin(),
                                                  cell_dofs.end());
        for (const auto dof : cell_dofs)
          couplings.add_partners(dof, coupled);
        discretization.constraints.add_entries_local_to_global(
          Dofs(coupled.begin(), coupled.end()),
          pattern,
          /*keep_constrained_entries=*/false);
      }
  }



  // An empty matrix: whoever has had the old one lets go of it first.
  template<int dim>
  void AssembledSystem<dim>::reset_matrix(const DynamicSparsityPattern &pattern)
  {
    if (solver)
      solver->release();
    pattern_is_new = true;
    is_set         = false;
    tresca_matrix.clear();
    matrix.clear();
    matrix.reinit(owned, owned, pattern, discretization.communicator);
  }



  template<int dim>
  void AssembledSystem<dim>::prepare()
  {
    is_set = false;
    if (!solver)
      solver = DefiniteSolver::create(solver_kind,
                                      elasticity.has_large_strains(),
                                      coarse_space(),
                                      discretization.counters);
    solver->set_matrix(matrix,
                       elimination.is_symmetric() ? matrix : tresca_matrix,
                       pattern_is_new,
                       elimination.eliminated_dofs());
    pattern_is_new = false;
    is_set         = true;
  }



  template<int dim>
  DefiniteSolver::CoarseSpace AssembledSystem<dim>::coarse_space()
  {
    DefiniteSolver::CoarseSpace space;
    if (solver_kind != Parameters::SolverKind::amg)
      return space;
    space.modes = rigid_modes(discretization);
    if (discretization.degree == 2)
      {
        transfer = std::make_unique<DegreeTransfer<dim>>(discretization);
        for (auto &mode : space.modes)
          mode = transfer->restricted(mode);
        space.interpolation = [this] {
          return transfer->interpolation(elimination.constraints());
        };
      }
    return space;
  }



  template<int dim>
  unsigned int AssembledSystem<dim>::solve_reduced(const GhostedVector &rhs,
                                                   const double   tolerance,
                                                   GhostedVector &x)
  {
    const MPI_Comm         communicator = discretization.communicator;
    const unsigned int     n            = owned.n_elements();
    DefiniteSolver::Vector b(owned, communicator), of_rank(owned, communicator);
    std::copy_n(rhs.begin(), n, b.begin());
    const unsigned int n_iterations = solver->solve(b, tolerance, of_rank);
    std::copy_n(of_rank.begin(), n, x.begin());
    return n_iterations;
  }



  template<int dim>
  void AssembledSystem<dim>::add_interface(const bool bulk_is_new)
  {
    if (bulk_is_new)
      keep_interface_rows();
    else
      restore_interface_rows();
    if (!elimination.is_symmetric())
      {
        if (tresca_matrix.m() == 0)
          tresca_matrix.reinit(matrix);
        tresca_matrix.copy_from(matrix);
        add_interface(elimination.constraints(), {}, tresca_matrix);
      }
    add_interface(elimination.test_constraints(),
                  elimination.pairing_terms(),
                  matrix);
  }



  template<int dim>
  void AssembledSystem<dim>::add_interface(
    const AffineConstraints<double>          &test_constraints,
    const std::vector<PairingStiffness<dim>> &pairing_terms,
    DefiniteSolver::Matrix                   &matrix) const
  {
    CondensedTangents sum(elimination.constraints(), test_constraints, matrix);
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      {
        const Dofs &dofs = elasticity.dofs_of_cell(interface_cells[k]);
        sum.add(interface_tangents[k], dofs, dofs);
      }
    for (const auto &term : elimination.slip_direction_terms())
      if (term.is_own())
        sum.add(term.stiffness, term.dofs, term.dofs);
    const auto of_pairing =
      PairingStiffness<dim>::at_owners(pairing_terms, discretization);
    std::list<FullMatrix<double>> matrices; // until finish()
    for (const auto &term : of_pairing)
      sum.add(matrices.emplace_back(term.matrix()), term.rows, term.columns);
    sum.finish();
    matrix.compress(VectorOperation::add);
  }

  template class AssembledSystem<2>;
  template class AssembledSystem<3>;
} // namespace Contact
