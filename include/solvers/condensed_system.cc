/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

#include "solvers/rigid_rotation.h"

namespace Contact
{
  template<int dim>
  CondensedSystem<dim>::CondensedSystem(
    const Discretization<dim>   &discretization,
    const Elasticity<dim>       &elasticity,
    const ContactInterface<dim> *interface,
    ContactElimination<dim>     &elimination,
    const Parameters::SolverKind solver_kind,
    TimerOutput                 &timer)
    : discretization(discretization)
    , elasticity(elasticity)
    , elimination(elimination)
    , timer(timer)
    , owned(discretization.dof_handler.locally_owned_dofs())
    , eliminable(elimination.slave_dofs)
    , couplings(discretization, interface)
    , solver_kind(solver_kind)
  {
    collect_interface();
  }



  // A hanging node next to the surface moves with a slave node: such cells see
  // the active set, too.
  template<int dim>
  void CondensedSystem<dim>::collect_interface()
  {
    interface_cells.clear();
    bulk_cells.clear();
    const auto &base    = discretization.constraints;
    const auto  sees_it = [&](const types::global_dof_index dof) {
      if (eliminable.count(dof) > 0 || discretization.is_moved(dof))
        return true;
      const auto *entries = base.get_constraint_entries(dof);
      return entries != nullptr &&
             std::any_of(entries->begin(),
                         entries->end(),
                         [&](const auto &entry) {
                           return eliminable.count(entry.first) > 0;
                         });
    };
    for (unsigned int c = 0; c < elasticity.n_cells(); ++c)
      {
        const Dofs &dofs = elasticity.dofs_of_cell(c);
        if (std::any_of(dofs.begin(), dofs.end(), sees_it))
          interface_cells.push_back(c);
        else
          bulk_cells.push_back(c);
      }
  }



  template<int dim>
  void CondensedSystem<dim>::update_pattern()
  {
    if (!on_any_rank(!has_pattern || !couplings.serve()))
      return;
    TimerOutput::Scope scope(timer, "setup");
    couplings.make();
    make_pattern();
  }



  // The lines of now, and a pattern that has room for them.
  template<int dim>
  void CondensedSystem<dim>::eliminate(const GhostedVector &solution,
                                       const GhostedVector &u_start,
                                       const GhostedVector &moved)
  {
    {
      TimerOutput::Scope scope(timer, "assembly");
      elimination.make(solution, u_start, interface_dofs, moved);
    }
    const bool misses_cells = on_any_rank(add_eliminable());
    const bool misses_partners =
      on_any_rank(couplings.add_missing(elimination));
    if (!misses_cells && !misses_partners &&
        pattern_version == discretization.pattern_version())
      return;
    TimerOutput::Scope scope(timer, "setup");
    if (misses_cells)
      collect_interface();
    make_pattern();
    elimination.make(solution, u_start, interface_dofs, moved);
  }



  // All ranks together choose whether something is made anew: their values may
  // differ by round-off.
  template<int dim>
  bool CondensedSystem<dim>::on_any_rank(const bool condition) const
  {
    return Utilities::MPI::max(static_cast<unsigned int>(condition),
                               discretization.communicator) > 0;
  }



  // The unknowns eliminated beside the slave nodes, which only the lines show.
  template<int dim>
  bool CondensedSystem<dim>::add_eliminable()
  {
    bool is_more = false;
    for (const auto dof : elimination.eliminated_dofs())
      is_more = eliminable.insert(dof).second || is_more;
    return is_more;
  }



  template<int dim>
  void CondensedSystem<dim>::make_pattern()
  {
    const MPI_Comm communicator               = discretization.communicator;
    const auto    &dof_handler                = discretization.dof_handler;
    const auto     n                          = dof_handler.n_dofs();
    std::set<types::global_dof_index> touched = couplings.all();

    // One rank has all rows, which is said by none.
    IndexSet   rows;
    const bool is_distributed =
      Utilities::MPI::n_mpi_processes(communicator) > 1;
    if (is_distributed)
      {
        rows = DoFTools::extract_locally_relevant_dofs(dof_handler);
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
    touched.merge(add_interface_couplings(pattern));
    if (is_distributed)
      couplings.add_facets(pattern);
    for (const auto i : owned)
      pattern.add(i, i);

    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator,
                                    Dofs(touched.begin(), touched.end())))
      touched.insert(of_rank.begin(), of_rank.end());
    interface_dofs.assign(touched.begin(), touched.end());

    if (is_distributed)
      SparsityTools::distribute_sparsity_pattern(pattern,
                                                 owned,
                                                 communicator,
                                                 rows);
    reset_matrix(pattern);
  }



  // An unknown of a cell at the interface may become one of its partners, or of
  // those of the unknowns that it hangs on.
  template<int dim>
  std::set<types::global_dof_index>
  CondensedSystem<dim>::add_interface_couplings(
    DynamicSparsityPattern &pattern) const
  {
    const auto                       &base = discretization.constraints;
    std::set<types::global_dof_index> all;
    for (const unsigned int c : interface_cells)
      {
        const Dofs &cell_dofs = elasticity.dofs_of_cell(c);
        std::set<types::global_dof_index> coupled(cell_dofs.begin(),
                                                  cell_dofs.end());
        for (const auto dof : cell_dofs)
          couplings.add_partners(dof, coupled);
        base.add_entries_local_to_global(Dofs(coupled.begin(), coupled.end()),
                                         pattern,
                                         /*keep_constrained_entries=*/false);
        all.insert(coupled.begin(), coupled.end());
      }
    return all;
  }



  // An empty matrix: whoever has had the old one lets go of it first.
  template<int dim>
  void CondensedSystem<dim>::reset_matrix(const DynamicSparsityPattern &pattern)
  {
    for (Solver &solver : solvers)
      {
        if (solver.solver)
          solver.solver->release();
        solver.pattern_is_new = true;
      }
    current = nullptr;
    matrix.clear();
    matrix.reinit(owned, owned, pattern, discretization.communicator);
    tangents_are_known = false;
    has_pattern        = true;
    pattern_version    = discretization.pattern_version();
  }



  template<int dim>
  unsigned int CondensedSystem<dim>::solve(const GhostedVector &solution,
                                           const GhostedVector &u_start,
                                           const GhostedVector &residual,
                                           const double         tolerance,
                                           GhostedVector       &update,
                                           const bool           keep_tangents,
                                           const GhostedVector *moved)
  {
    GhostedVector rhs    = discretization.displacements(residual);
    bool          is_new = true;
    eliminate(solution, u_start, moved != nullptr ? *moved : solution);
    {
      TimerOutput::Scope scope(timer, "assembly");
      elimination.condense(rhs);
      is_new = assemble(solution, keep_tangents, rhs);
    }
    if (is_new || current == nullptr)
      {
        TimerOutput::Scope scope(timer, "factorization");
        give_matrix_to_solver();
      }

    TimerOutput::Scope     scope(timer, "solution");
    const MPI_Comm         communicator = discretization.communicator;
    DefiniteSolver::Vector b(owned, communicator), x(owned, communicator);
    const auto            &base  = discretization.constraints;
    const auto            &lines = elimination.test_constraints();
    unsigned int           row   = 0;
    for (const auto i : owned)
      b.begin()[row++] =
        base.is_constrained(i) || lines.is_constrained(i) ? 0. : rhs[i];

    // A digit is gained: else a point might open and close for ever.
    const double       size = b.l2_norm();
    const unsigned int n_iterations =
      current->solve(b,
                     tolerance > 0
                       ? std::min(tolerance,
                                  std::max(0.1 * size, 1e-3 * tolerance))
                       : 1e-6 * size,
                     x);

    // The unknowns that are solved for, then those that constraints determine.
    std::copy_n(x.begin(), row, update.begin());
    update.update_ghosts();
    elimination.distribute(update);
    return n_iterations;
  }



  template<int dim>
  GhostedVector
  CondensedSystem<dim>::linear_forces(const GhostedVector &solution,
                                      const double         load_factor) const
  {
    const auto   &base = discretization.constraints;
    const auto    load = elasticity.loads(solution, load_factor);
    GhostedVector forces(discretization.distribution);
    for (const auto i : owned)
      if (load[i] != 0)
        base.distribute_local_to_global(i, load[i], forces);

    Vector<double> of_cell, u;
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      {
        const Dofs &dofs = elasticity.dofs_of_cell(interface_cells[k]);
        of_cell.reinit(dofs.size());
        solution.extract(dofs, u);
        interface_tangents[k].vmult(of_cell, u);
        of_cell += interface_forces[k];
        of_cell *= -1;
        base.distribute_local_to_global(of_cell, dofs, forces);
      }
    forces.sum_up();
    return forces;
  }



  // Each kind of matrix has a solver of its own, made when the first one comes.
  template<int dim>
  void CondensedSystem<dim>::give_matrix_to_solver()
  {
    current              = nullptr;
    const bool symmetric = elimination.is_symmetric();
    const bool first   = symmetric || DefiniteSolver::serves_both(solver_kind);
    Solver    &of_kind = solvers[first ? 0 : 1];
    if (!of_kind.solver)
      {
        const auto modes = solver_kind == Parameters::SolverKind::amg
                             ? rigid_modes(discretization)
                             : DefiniteSolver::Modes();
        of_kind.solver   = DefiniteSolver::create(solver_kind,
                                                symmetric,
                                                elasticity.is_hyperelastic(),
                                                modes,
                                                discretization.counters);
      }
    of_kind.solver->set_matrix(matrix,
                               symmetric,
                               of_kind.pattern_is_new,
                               elimination.eliminated_dofs());
    of_kind.pattern_is_new = false;
    current                = of_kind.solver.get();
  }



  template<int dim>
  bool CondensedSystem<dim>::assemble(const GhostedVector &solution,
                                      const bool           keep_tangents,
                                      GhostedVector       &rhs)
  {
    const bool tangents_serve = !on_any_rank(
      !tangents_are_known || !(elasticity.is_linear() || keep_tangents) ||
      tangent_version != elasticity.tangent_version());
    const auto signature = elimination.signature();
    const bool is_new =
      on_any_rank(!tangents_serve || signature != assembled_lines);
    assembled_lines = signature;
    if (!tangents_serve)
      assemble_tangents(solution);
    else
      {
        if (thermal_version != elasticity.thermal_version())
          {
            interface_forces.clear();
            elasticity.visit_cells(solution,
                                   /*with_tangent=*/false,
                                   interface_cells,
                                   [&](const Dofs &dofs,
                                       const FullMatrix<double> &,
                                       const Vector<double> &forces) {
                                     add_interface_forces(dofs,
                                                          forces,
                                                          solution);
                                   });
          }
        if (is_new)
          restore_interface_rows();
      }

    // With what the eliminated unknowns are to move by themselves: -K h.
    GhostedVector  moved_forces(discretization.distribution);
    Vector<double> none;
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      add_interface(interface_tangents[k],
                    elasticity.dofs_of_cell(interface_cells[k]),
                    none,
                    is_new,
                    moved_forces);
    for (const auto &term : elimination.turning_terms())
      if (owned.is_element(term.dofs[0]))
        add_interface(term.stiffness,
                      term.dofs,
                      term.load,
                      is_new,
                      moved_forces);
    for (const auto &term : elimination.pairing_terms())
      add_pairing(term, is_new, moved_forces);
    if (is_new)
      matrix.compress(VectorOperation::add);

    moved_forces.sum_up();
    rhs += moved_forces;
    return is_new;
  }



  // A tangent, unless @p with_matrix is false, and the forces.
  template<int dim>
  void CondensedSystem<dim>::add_interface(const FullMatrix<double> &tangent,
                                           const Dofs               &dofs,
                                           const Vector<double>     &load,
                                           const bool     with_matrix,
                                           GhostedVector &forces)
  {
    const auto &constraints = elimination.constraints();
    if (with_matrix && elimination.is_symmetric())
      constraints.distribute_local_to_global(tangent, dofs, matrix);
    else if (with_matrix)
      add_unsymmetric(tangent, dofs);

    Vector<double> h(dofs.size()), force(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      h[i] = -constraints.get_inhomogeneity(dofs[i]);
    tangent.vmult(force, h);
    if (load.size() > 0)
      force += load;
    elimination.test_constraints().distribute_local_to_global(force,
                                                              dofs,
                                                              forces);
  }



  template<int dim>
  void CondensedSystem<dim>::add_pairing(const PairingStiffness<dim> &term,
                                         const bool     with_matrix,
                                         GhostedVector &forces)
  {
    const auto &constraints = elimination.constraints();
    const auto &tested      = elimination.test_constraints();
    if (with_matrix)
      tested.distribute_local_to_global(term.stiffness,
                                        term.rows,
                                        constraints,
                                        term.columns,
                                        matrix);
    Vector<double> h(term.columns.size()), force(term.rows.size());
    for (unsigned int j = 0; j < h.size(); ++j)
      h[j] = -constraints.get_inhomogeneity(term.columns[j]);
    term.stiffness.vmult(force, h);
    tested.distribute_local_to_global(force, term.rows, forces);
  }



  // Rows by the virtual displacements, columns by the displacements; what is
  // constrained gets a diagonal as large as with the symmetric matrix.
  template<int dim>
  void CondensedSystem<dim>::add_unsymmetric(const FullMatrix<double> &tangent,
                                             const Dofs               &dofs)
  {
    const auto &tested = elimination.test_constraints();
    tested.distribute_local_to_global(tangent,
                                      dofs,
                                      elimination.constraints(),
                                      dofs,
                                      matrix);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (tested.is_constrained(dofs[i]))
        matrix.add(dofs[i], dofs[i], std::abs(tangent(i, i)));
  }

  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace Contact
