/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/condensed_system.h"

#include <algorithm>

#include "base/constraint_entries.h"

namespace Contact
{
  template<int dim>
  CondensedSystem<dim>::CondensedSystem(
    const Discretization<dim> &discretization,
    const Elasticity<dim>     &elasticity,
    ContactElimination<dim>   &elimination,
    TimerOutput               &timer)
    : discretization(discretization)
    , elasticity(elasticity)
    , elimination(elimination)
    , timer(timer)
    , owned(discretization.dof_handler.locally_owned_dofs())
    , eliminable(elimination.slave_dofs)
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
    if (!on_any_rank(!is_coupled || !has_room_for_points()))
      return;
    TimerOutput::Scope scope(timer, "setup");
    make_room();
    couple();
  }



  // The lines of now, and couplings that have room for them.
  template<int dim>
  void CondensedSystem<dim>::eliminate(const GhostedVector &solution,
                                       const GhostedVector &u_start,
                                       const GhostedVector &moved)
  {
    const auto make_lines = [&] {
      elimination.make(solution,
                       u_start,
                       interface_dofs,
                       moved,
                       any_rank_may_add());
    };
    {
      TimerOutput::Scope scope(timer, "assembly");
      make_lines();
    }
    const bool misses_cells = on_any_rank(add_eliminable());
    const bool misses_room  = on_any_rank(make_room_for_lines());
    if (!misses_cells && !misses_room &&
        pattern_version == discretization.pattern_version())
      return;
    TimerOutput::Scope scope(timer, "setup");
    if (misses_cells)
      collect_interface();
    couple();
    make_lines();
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



  // An unknown of a cell at the interface may become one of its partners, or of
  // those of the unknowns that it hangs on.
  template<int dim>
  void CondensedSystem<dim>::couple()
  {
    Dofs of_cells;
    for (const unsigned int c : interface_cells)
      for (const auto dof : elasticity.dofs_of_cell(c))
        {
          of_cells.push_back(dof);
          visit_leaders(discretization.constraints,
                        dof,
                        [&](const auto leader, const double) {
                          of_cells.push_back(leader);
                        });
        }
    interface_dofs = all_of_interface(std::move(of_cells));
    std::sort(interface_dofs.begin(), interface_dofs.end());
    interface_dofs.erase(std::unique(interface_dofs.begin(),
                                     interface_dofs.end()),
                         interface_dofs.end());

    reset();
    tangents_are_known = false;
    is_prepared        = false;
    is_coupled         = true;
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
    GhostedVector rhs = discretization.displacements(residual);
    eliminate(solution, u_start, moved != nullptr ? *moved : solution);
    bool is_new = true;
    {
      TimerOutput::Scope scope(timer, "assembly");
      elimination.condense(rhs);
      is_new = assemble(solution, keep_tangents, rhs);
    }
    if (is_new || !is_prepared)
      {
        TimerOutput::Scope scope(timer, "factorization");
        is_prepared = false;
        prepare();
        is_prepared = true;
      }

    TimerOutput::Scope scope(timer, "solution");

    // A digit is gained: else a point might open and close for ever.
    const auto &base  = discretization.constraints;
    const auto &lines = elimination.test_constraints();
    for (const auto i : owned)
      if (base.is_constrained(i) || lines.is_constrained(i))
        rhs[i] = 0;
    rhs.update_ghosts();
    const double       size = rhs.l2_norm();
    const unsigned int n_iterations =
      solve_reduced(rhs,
                    tolerance > 0
                      ? std::min(tolerance,
                                 std::max(0.1 * size, 1e-3 * tolerance))
                      : 1e-6 * size,
                    update);

    // The unknowns that are solved for, then those that constraints determine.
    update.update_ghosts();
    elimination.distribute(update);
    return n_iterations;
  }



  template<int dim>
  GhostedVector
  CondensedSystem<dim>::linear_forces(const GhostedVector &solution,
                                      const double         load_factor)
  {
    add_missing_tangents(solution);
    const auto   &base = discretization.constraints;
    const auto    load = elasticity.loads(solution, load_factor);
    GhostedVector forces(discretization.distribution);
    for (const auto i : owned)
      if (load[i] != 0)
        base.distribute_local_to_global(i, load[i], forces);

    Vector<double> of_cell, u;
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      {
        if (interface_tangents[k].empty())
          continue;
        const Dofs &dofs = elasticity.dofs_of_cell(interface_cells[k]);
        of_cell.reinit(dofs.size());
        solution.extract(dofs, u);
        interface_tangents[k].vmult(of_cell, u);
        of_cell += interface_forces[k];
        of_cell *= -1;
        base.distribute_local_to_global(of_cell, dofs, forces);
      }
    forces.compress_add();
    return forces;
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
    else if (thermal_version != elasticity.thermal_version())
      renew_interface_forces(solution);
    add_missing_tangents(solution);
    if (is_new)
      add_interface(/*bulk_is_new=*/!tangents_serve);

    // With what the eliminated unknowns are to move by themselves: -K h.
    GhostedVector  moved_forces(discretization.distribution);
    Vector<double> none;
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      {
        const Dofs &dofs = elasticity.dofs_of_cell(interface_cells[k]);
        if (!interface_tangents[k].empty())
          add_moved_forces(interface_tangents[k],
                           dofs,
                           dofs,
                           none,
                           moved_forces);
      }
    for (const auto &term : elimination.slip_direction_terms())
      if (term.is_own())
        add_moved_forces(term.stiffness,
                         term.dofs,
                         term.dofs,
                         term.load,
                         moved_forces);
    for (const auto &term : elimination.pairing_terms())
      add_moved_forces(term, term.rows, term.columns, none, moved_forces);
    moved_forces.compress_add();
    rhs += moved_forces;
    return is_new;
  }



  // While springs hold a body in 3-D its stresses do not turn with it: they
  // would be stronger than the springs, and the matrix not definite.
  template<int dim>
  StressStiffness CondensedSystem<dim>::stress_stiffness() const
  {
    return dim == 3 && !elasticity.springs.held().empty()
             ? StressStiffness::without
             : StressStiffness::with;
  }



  // Those of the interface follow as they are asked for.
  template<int dim>
  void CondensedSystem<dim>::assemble_tangents(const GhostedVector &solution)
  {
    ++discretization.counters.tangents;
    assemble_bulk(solution, stress_stiffness());
    interface_tangents.assign(interface_cells.size(), FullMatrix<double>());
    interface_forces.assign(interface_cells.size(), Vector<double>());
    tangents_are_known = true;
    tangent_version    = elasticity.tangent_version();
    thermal_version    = elasticity.thermal_version();
  }



  // Those of linear bodies are the same in any solution.
  template<int dim>
  void CondensedSystem<dim>::add_missing_tangents(const GhostedVector &solution)
  {
    const std::vector<bool> in_use =
      needs_all_tangents() ? std::vector<bool>(interface_cells.size(), true)
                           : cells_in_use();
    std::vector<unsigned int> missing, cells;
    for (unsigned int k = 0; k < interface_cells.size(); ++k)
      if (in_use[k] && interface_tangents[k].empty())
        {
          missing.push_back(k);
          cells.push_back(interface_cells[k]);
        }
    auto next = missing.begin();
    elasticity.visit_cells(
      solution,
      /*with_tangent=*/true,
      [&](const Dofs &,
          const FullMatrix<double> &tangent,
          const Vector<double>     &forces) {
        interface_tangents[*next] = tangent;
        set_interface_forces(*next++, forces, solution);
      },
      &cells,
      stress_stiffness());
  }



  template<int dim>
  std::vector<bool> CondensedSystem<dim>::cells_in_use() const
  {
    const auto &base     = discretization.constraints;
    const Dofs  in_use   = elimination.dofs_in_contact();
    const auto  contains = [&](const types::global_dof_index dof) {
      return std::binary_search(in_use.begin(), in_use.end(), dof);
    };
    const auto is_in_use = [&](const types::global_dof_index dof) {
      if (contains(dof) ||
          elimination.constraints().get_inhomogeneity(dof) != 0)
        return true;
      const auto *entries = base.get_constraint_entries(dof);
      return entries != nullptr && std::any_of(entries->begin(),
                                               entries->end(),
                                               [&](const auto &entry) {
                                                 return contains(entry.first);
                                               });
    };
    std::vector<bool> cells;
    for (const unsigned int c : interface_cells)
      {
        const Dofs &dofs = elasticity.dofs_of_cell(c);
        cells.push_back(std::any_of(dofs.begin(), dofs.end(), is_in_use));
      }
    return cells;
  }



  template<int dim>
  void
  CondensedSystem<dim>::renew_interface_forces(const GhostedVector &solution)
  {
    unsigned int k = 0;
    elasticity.visit_cells(
      solution,
      /*with_tangent=*/false,
      [&](const Dofs &,
          const FullMatrix<double> &,
          const Vector<double> &forces) {
        if (!interface_tangents[k].empty())
          set_interface_forces(k, forces, solution);
        ++k;
      },
      &interface_cells);
    thermal_version = elasticity.thermal_version();
  }



  // The rest of the forces of a cell without its tangent.
  template<int dim>
  void CondensedSystem<dim>::set_interface_forces(const unsigned int    k,
                                                  const Vector<double> &forces,
                                                  const GhostedVector &solution)
  {
    const Dofs    &dofs = elasticity.dofs_of_cell(interface_cells[k]);
    Vector<double> u, constant(dofs.size());
    solution.extract(dofs, u);
    interface_tangents[k].vmult(constant, u);
    constant.sadd(-1, 1, forces);
    interface_forces[k] = constant;
  }



  template<int dim>
  template<class Tangent>
  void CondensedSystem<dim>::add_moved_forces(const Tangent        &tangent,
                                              const Dofs           &rows,
                                              const Dofs           &columns,
                                              const Vector<double> &load,
                                              GhostedVector &forces) const
  {
    const auto    &constraints = elimination.constraints();
    Vector<double> h(columns.size()), force(rows.size());
    for (unsigned int j = 0; j < columns.size(); ++j)
      h[j] = -constraints.get_inhomogeneity(columns[j]);
    tangent.vmult(force, h);
    if (load.size() > 0)
      force += load;
    elimination.test_constraints().distribute_local_to_global(force,
                                                              rows,
                                                              forces);
  }

  template class CondensedSystem<2>;
  template class CondensedSystem<3>;
} // namespace Contact
