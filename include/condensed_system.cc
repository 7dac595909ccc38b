/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "condensed_system.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>
#include <algorithm>

namespace Contact
{
  CondensedSystem::CondensedSystem(const Discretization   &discretization,
                                   const Elasticity       &elasticity,
                                   const ContactInterface *interface,
                                   const std::string      &solver_name,
                                   TimerOutput            &timer)
    : discretization(discretization)
    , elasticity(elasticity)
    , interface(interface)
    , timer(timer)
    , owned(discretization.dof_handler.locally_owned_dofs())
    , solver(DefiniteSolver::create(solver_name, rigid_modes()))
  {
    if (interface != nullptr)
      for (unsigned int e = 0; e < interface->master.edges.size(); ++e)
        for (unsigned int a = 0; a < interface->master.n_nodes_per_edge(); ++a)
          {
            const auto node = interface->master.edges[e].nodes[a];
            for (const auto dof : interface->master.nodes[node].dofs)
              edges_at_master.emplace(dof, e);
          }
    collect_interface();
  }



  // The rigid motions about the middle of each body. As a whole they are three
  // for all bodies together: aggregates do not reach from body to body except
  // where these touch.
  DefiniteSolver::Modes CondensedSystem::rigid_modes() const
  {
    DefiniteSolver::Modes modes(3, std::vector<double>(owned.n_elements()));

    // Of the coarse cells, which every rank has.
    std::map<types::material_id, BoundingBox<2>> boxes;
    for (const auto &cell :
         discretization.mesh.triangulation.cell_iterators_on_level(0))
      boxes.emplace(cell->material_id(), cell->bounding_box())
        .first->second.merge_with(cell->bounding_box());

    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto    &fe     = cell->get_fe();
        const Point<2> centre = boxes.at(cell->material_id()).center();
        const auto &mapping   = discretization.mapping[cell->active_fe_index()];
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const auto in_x = dofs[fe.component_to_system_index(0, a)];
            const auto in_y = dofs[fe.component_to_system_index(1, a)];
            if (!owned.is_element(in_x))
              continue;
            const Tensor<1, 2> arm =
              mapping.transform_unit_to_real_cell(
                cell,
                fe.base_element(0).unit_support_point(a)) -
              centre;
            const auto row_x = owned.index_within_set(in_x);
            const auto row_y = owned.index_within_set(in_y);
            modes[0][row_x]  = 1;
            modes[1][row_y]  = 1;
            modes[2][row_x]  = -arm[1];
            modes[2][row_y]  = arm[0];
          }
      }
    return modes;
  }



  // A hanging node next to the surface moves with a slave node: such cells see
  // the active set, too.
  void CondensedSystem::collect_interface()
  {
    if (interface != nullptr)
      for (const ContactPoint &point : interface->points)
        slave_dofs.insert(point.dofs[0].begin(), point.dofs[0].end());

    const auto &base    = discretization.constraints;
    const auto  sees_it = [&](const types::global_dof_index dof) {
      if (slave_dofs.count(dof) > 0 || discretization.is_moved(dof))
        return true;
      const auto *entries = base.get_constraint_entries(dof);
      return entries != nullptr &&
             std::any_of(entries->begin(),
                         entries->end(),
                         [&](const auto &entry) {
                           return slave_dofs.count(entry.first) > 0;
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



  void CondensedSystem::update_pattern()
  {
    if (change != Change::pattern && pattern_serves())
      return;
    TimerOutput::Scope scope(timer, "setup");
    make_pattern();
  }



  bool CondensedSystem::pattern_serves() const
  {
    if (interface == nullptr)
      return true;
    for (unsigned int q = 0; q < interface->points.size(); ++q)
      {
        const ContactPoint &point = interface->points[q];
        for (unsigned int a = 1; a < point.n_nodes; ++a)
          if (!std::binary_search(provided[q].begin(),
                                  provided[q].end(),
                                  point.dofs[a][0]))
            return false;
      }
    return true;
  }



  // The nodes of the point, and on the master those of one more edge to either
  // side: the bodies may slide a little before a new pattern is due.
  CondensedSystem::Dofs
  CondensedSystem::reachable_master_dofs(const ContactPoint &point) const
  {
    const Surface                    &master = interface->master;
    std::set<types::global_dof_index> dofs;
    for (unsigned int a = 1; a < point.n_nodes; ++a)
      dofs.insert(point.dofs[a].begin(), point.dofs[a].end());

    const auto  neighbors = dofs;
    const auto &edges     = edges_at_master;
    for (const auto dof : neighbors)
      {
        const auto range = edges.equal_range(dof);
        for (auto edge = range.first; edge != range.second; ++edge)
          for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
            {
              const auto &node =
                master.nodes[master.edges[edge->second].nodes[a]];
              dofs.insert(node.dofs.begin(), node.dofs.end());
            }
      }
    return Dofs(dofs.begin(), dofs.end());
  }



  void CondensedSystem::make_pattern()
  {
    const auto &dof_handler = discretization.dof_handler;
    const auto  n           = dof_handler.n_dofs();

    // What each slave unknown may be coupled with.
    std::map<types::global_dof_index, Dofs> partners;
    std::set<types::global_dof_index>       all;
    provided.clear();
    if (interface != nullptr)
      for (const ContactPoint &point : interface->points)
        {
          provided.push_back(reachable_master_dofs(point));
          for (const auto dof : point.dofs[0])
            partners[dof] = provided.back();
          all.insert(point.dofs[0].begin(), point.dofs[0].end());
          all.insert(provided.back().begin(), provided.back().end());
        }

    IndexSet rows;
    DoFTools::extract_locally_relevant_dofs(dof_handler, rows);
    const IndexSet relevant = rows;
    rows.add_indices(all.begin(), all.end());
    rows.compress();

    DynamicSparsityPattern pattern(n, n, rows);
    elasticity.add_couplings(pattern);

    const auto                       &base = discretization.constraints;
    std::set<types::global_dof_index> touched;
    for (const unsigned int c : interface_cells)
      {
        const Dofs &cell_dofs = elasticity.dofs_of_cell(c);
        std::set<types::global_dof_index> coupled(cell_dofs.begin(),
                                                  cell_dofs.end());
        const auto add_partners = [&](const types::global_dof_index dof) {
          const auto found = partners.find(dof);
          if (found != partners.end())
            coupled.insert(found->second.begin(), found->second.end());
        };
        for (const auto dof : cell_dofs)
          {
            add_partners(dof);
            if (const auto *entries = base.get_constraint_entries(dof))
              for (const auto &entry : *entries)
                {
                  coupled.insert(entry.first);
                  add_partners(entry.first);
                }
          }
        base.add_entries_local_to_global(Dofs(coupled.begin(), coupled.end()),
                                         pattern,
                                         /*keep_constrained_entries=*/false);
        touched.insert(coupled.begin(), coupled.end());
      }
    for (const auto i : owned)
      pattern.add(i, i);

    const MPI_Comm communicator = discretization.communicator;
    touched.insert(all.begin(), all.end());
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator,
                                    Dofs(touched.begin(), touched.end())))
      touched.insert(of_rank.begin(), of_rank.end());
    interface_dofs.assign(touched.begin(), touched.end());

    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      SparsityTools::distribute_sparsity_pattern(pattern,
                                                 owned,
                                                 communicator,
                                                 rows);
    matrix.clear();
    matrix.reinit(owned, owned, pattern, communicator);
    bulk_is_assembled = false;
    change            = Change::pattern;
  }



  // The forces of the bodies on the slave nodes are
  //   sum over the points of w C_k (p n + q t) = f_k.
  // Most points see no slave node but their own; the others are solved for
  // together.
  std::vector<Tensor<1, 2>>
  CondensedSystem::tractions(const Vector<double> &residual) const
  {
    const auto                                     &points = interface->points;
    std::map<types::global_dof_index, unsigned int> point_of_dof;
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].decision.status != Status::open)
        point_of_dof[points[q].dofs[0][0]] = q;

    std::vector<Tensor<1, 2>> tractions(points.size());
    std::set<unsigned int>    coupled;
    for (const auto &[dof, q] : point_of_dof)
      {
        for (unsigned int i = 0; i < 2; ++i)
          tractions[q][i] = -residual[points[q].dofs[0][i]] /
                            (points[q].weight * points[q].C[0]);
        for (unsigned int a = 1; a < points[q].n_slave_nodes; ++a)
          if (const auto other = point_of_dof.find(points[q].dofs[a][0]);
              other != point_of_dof.end())
            coupled.insert({q, other->second});
      }
    if (coupled.empty())
      return tractions;

    const std::vector<unsigned int> set(coupled.begin(), coupled.end());
    FullMatrix<double>              shares(set.size(), set.size());
    for (unsigned int k = 0; k < set.size(); ++k)
      for (unsigned int l = 0; l < set.size(); ++l)
        for (unsigned int a = 0; a < points[set[l]].n_slave_nodes; ++a)
          if (points[set[l]].dofs[a] == points[set[k]].dofs[0])
            shares(k, l) += points[set[l]].weight * points[set[l]].C[a];
    shares.gauss_jordan();
    for (unsigned int k = 0; k < set.size(); ++k)
      {
        tractions[set[k]] = Tensor<1, 2>();
        for (unsigned int l = 0; l < set.size(); ++l)
          for (unsigned int i = 0; i < 2; ++i)
            tractions[set[k]][i] -=
              shares(k, l) * residual[points[set[l]].dofs[0][i]];
      }
    return tractions;
  }



  void CondensedSystem::recover_pressures(const Vector<double> &residual,
                                          Vector<double>       &solution) const
  {
    const auto tractions = this->tractions(residual);
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        // Where a support takes a part of the force, the component that is
        // free tells the whole.
        const ContactPoint &point = interface->points[k];
        double              free  = 0;
        for (unsigned int i = 0; i < 2; ++i)
          if (!discretization.is_fixed(point.dofs[0][i]))
            free += point.normal[i] * point.normal[i];
        solution[interface->normal_index(point.multipliers[0])] =
          tractions[k] * point.normal / free;
      }
  }



  void CondensedSystem::recover_shears(const Vector<double> &residual,
                                       Vector<double>       &solution) const
  {
    if (interface->law.is_frictionless())
      return;
    const auto tractions = this->tractions(residual);
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint &point = interface->points[k];
        double &q = solution[interface->tangential_index(point.multipliers[0])];
        if (point.decision.status == Status::stick)
          q = tractions[k] * point.tangent;
        else if (point.decision.slip_direction != 0)
          q = point.decision.slip_direction * point.tresca_bound;
        else
          q = 0;
      }
  }



  unsigned int CondensedSystem::solve(const Vector<double> &solution,
                                      const Vector<double> &u_start,
                                      const Vector<double> &residual,
                                      const double          tolerance,
                                      Vector<double>       &update)
  {
    Vector<double> rhs(owned.size());
    std::copy_n(residual.begin(), rhs.size(), rhs.begin());
    bool is_new = true;
    {
      TimerOutput::Scope scope(timer, "assembly");
      make_lines(solution, u_start);
      condense(rhs);
      is_new = assemble(solution, rhs);
    }
    if (is_new)
      {
        TimerOutput::Scope scope(timer, "factorization");
        solver->set_matrix(matrix, change);
        change = Change::rows;
      }

    TimerOutput::Scope     scope(timer, "solution");
    const MPI_Comm         communicator = discretization.communicator;
    DefiniteSolver::Vector b(owned, communicator), x(owned, communicator);
    const auto            &base = discretization.constraints;
    unsigned int           row  = 0;
    for (const auto i : owned)
      b.begin()[row++] =
        base.is_constrained(i) || lines.is_constrained(i) ? 0. : rhs[i];
    const unsigned int n_iterations = solver->solve(b, tolerance, x);

    // Everybody gets everything.
    row = 0;
    rhs = 0;
    for (const auto i : owned)
      rhs[i] = x.begin()[row++];
    Utilities::MPI::sum(rhs, communicator, rhs);
    for (const auto &line : lines.get_lines())
      {
        double value = line.inhomogeneity;
        for (const auto &[dof, coefficient] : line.entries)
          value += coefficient * rhs[dof];
        rhs[line.index] = value;
      }
    base.distribute(rhs);
    std::copy_n(rhs.begin(), rhs.size(), update.begin());
    return n_iterations;
  }



  void CondensedSystem::add_base_line(const types::global_dof_index dof)
  {
    const auto &base = discretization.constraints;
    if (!base.is_constrained(dof) || lines.is_constrained(dof))
      return;
    lines.add_line(dof);
    if (const auto *entries = base.get_constraint_entries(dof))
      lines.add_entries(dof, *entries);
    lines.set_inhomogeneity(dof, base.get_inhomogeneity(dof));
  }



  void CondensedSystem::make_lines(const Vector<double> &solution,
                                   const Vector<double> &u_start)
  {
    lines.clear();
    eliminated.clear();
    contact_lines.clear();
    users_of_slave_dofs.clear();
    if (interface == nullptr)
      return;

    for (const auto dof : interface_dofs)
      add_base_line(dof);
    for (const ContactPoint &point : interface->points)
      {
        if (point.decision.status == Status::open)
          continue;
        const ContactState now = interface->state(point, solution, u_start);
        if (point.decision.status == Status::stick)
          add_stick_lines(point, now.gap, now.slip);
        else
          add_normal_line(point, now.gap);
      }

    for (const auto &[dof, line] : contact_lines)
      {
        eliminated.push_back(dof);
        lines.add_line(dof);
        lines.set_inhomogeneity(dof, line.constant);
        for (const auto &[other, coefficient] : line.entries)
          lines.add_entry(dof, other, coefficient);
      }
    lines.close();
  }



  void CondensedSystem::add_normal_line(const ContactPoint &point,
                                        const double        gap)
  {
    const auto fixed = [&](const unsigned int i) {
      return discretization.is_fixed(point.dofs[0][i]);
    };
    const unsigned int i =
      fixed(0) ||
          (!fixed(1) && std::abs(point.normal[1]) >= std::abs(point.normal[0]))
        ? 1
        : 0;
    const double scale = point.C[0] * point.normal[i];
    const auto   dof   = point.dofs[0][i];

    Line line;
    line.constant = -gap / scale;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int j = 0; j < 2; ++j)
        if (point.dofs[a][j] != dof && point.normal[j] != 0)
          line.entries[point.dofs[a][j]] -=
            point.C[a] * point.normal[j] / scale;
    eliminate(dof, line);
  }



  void CondensedSystem::add_stick_lines(const ContactPoint &point,
                                        const double        gap,
                                        const double        slip)
  {
    for (unsigned int i = 0; i < 2; ++i)
      {
        Line line;
        line.constant =
          -(gap * point.normal[i] + slip * point.tangent[i]) / point.C[0];
        for (unsigned int a = 1; a < point.n_nodes; ++a)
          line.entries[point.dofs[a][i]] -= point.C[a] / point.C[0];
        eliminate(point.dofs[0][i], line);
      }
  }



  // Where the mortar rule faces the master in part, points see the nodes of
  // each other: Gauss' elimination, of few lines.
  void CondensedSystem::eliminate(const types::global_dof_index dof, Line line)
  {
    const auto substitute =
      [](Line &in, const types::global_dof_index what, const Line &by) {
        const double c = in.entries.at(what);
        in.entries.erase(what);
        in.constant += c * by.constant;
        for (const auto &[other, coefficient] : by.entries)
          in.entries[other] += c * coefficient;
      };

    const auto entries = line.entries;
    for (const auto &entry : entries)
      if (const auto known = contact_lines.find(entry.first);
          known != contact_lines.end())
        substitute(line, entry.first, known->second);

    if (const auto own = line.entries.find(dof); own != line.entries.end())
      {
        const double factor = 1 / (1 - own->second);
        line.entries.erase(own);
        line.constant *= factor;
        for (auto &entry : line.entries)
          entry.second *= factor;
      }

    const auto users = users_of_slave_dofs.equal_range(dof);
    for (auto user = users.first; user != users.second; ++user)
      substitute(contact_lines.at(user->second), dof, line);
    for (const auto &entry : line.entries)
      if (slave_dofs.count(entry.first) > 0)
        {
          users_of_slave_dofs.emplace(entry.first, dof);
          for (auto user = users.first; user != users.second; ++user)
            users_of_slave_dofs.emplace(entry.first, user->second);
        }
    contact_lines[dof] = line;
  }



  // The transpose of the elimination: the force on an eliminated unknown goes
  // to those that move it.
  void CondensedSystem::condense(Vector<double> &rhs) const
  {
    for (const auto line : eliminated)
      {
        for (const auto &[dof, coefficient] :
             *lines.get_constraint_entries(line))
          rhs[dof] += coefficient * rhs[line];
        rhs[line] = 0;
      }
  }



  // The lines as numbers, to see whether they are others than before.
  std::vector<double> CondensedSystem::signature_of_lines() const
  {
    std::vector<double> signature;
    for (const auto line : eliminated)
      {
        signature.push_back(line);
        for (const auto &[dof, coefficient] :
             *lines.get_constraint_entries(line))
          {
            signature.push_back(dof);
            signature.push_back(coefficient);
          }
      }
    return signature;
  }



  bool CondensedSystem::assemble(const Vector<double> &solution,
                                 Vector<double>       &rhs)
  {
    const bool bulk_serves = bulk_is_assembled && elasticity.is_linear();
    const auto signature   = signature_of_lines();
    const bool is_new      = !bulk_serves || signature != assembled_lines;
    assembled_lines        = signature;
    if (!bulk_serves)
      assemble_bulk(solution);
    else if (is_new)
      restore_interface_rows();

    // With what the eliminated unknowns are to move by themselves: -K h.
    Vector<double> moved_forces(rhs.size()), h, force;
    const auto    &constraints =
      interface == nullptr ? discretization.constraints : lines;
    elasticity.visit_cells(
      solution,
      true,
      interface_cells,
      [&](const Dofs               &dofs,
          const FullMatrix<double> &tangent,
          const Vector<double> &) {
        if (is_new)
          constraints.distribute_local_to_global(tangent, dofs, matrix);

        h.reinit(dofs.size());
        force.reinit(dofs.size());
        for (unsigned int i = 0; i < dofs.size(); ++i)
          h[i] = -constraints.get_inhomogeneity(dofs[i]);
        tangent.vmult(force, h);
        constraints.distribute_local_to_global(force, dofs, moved_forces);
      });
    if (is_new)
      matrix.compress(VectorOperation::add);

    Utilities::MPI::sum(moved_forces,
                        discretization.communicator,
                        moved_forces);
    rhs += moved_forces;
    return is_new;
  }



  // All cells that do not see the active set.
  void CondensedSystem::assemble_bulk(const Vector<double> &solution)
  {
    const auto &base = discretization.constraints;
    matrix           = 0;
    elasticity.visit_cells(solution,
                           true,
                           bulk_cells,
                           [&](const Dofs               &dofs,
                               const FullMatrix<double> &tangent,
                               const Vector<double> &) {
                             base.distribute_local_to_global(tangent,
                                                             dofs,
                                                             matrix);
                           });
    matrix.compress(VectorOperation::add);

    // Bound centres are in no cell.
    if (discretization.bound_centre)
      {
        const std::set<types::global_dof_index> of_interface(
          interface_dofs.begin(),
          interface_dofs.end());
        for (const auto i : owned)
          if (base.is_constrained(i) && of_interface.count(i) == 0 &&
              matrix.diag_element(i) == 0)
            matrix.set(i, i, elasticity.young(0));
        matrix.compress(VectorOperation::insert);
      }

    kept_rows.clear();
    for_interface_rows([&](const int n, double *values) {
      kept_rows.emplace_back(values, values + n);
    });
    bulk_is_assembled = true;
    if (change == Change::rows)
      change = Change::values;
  }



  void CondensedSystem::restore_interface_rows()
  {
    auto kept = kept_rows.begin();
    for_interface_rows([&](const int, double *values) {
      std::copy(kept->begin(), kept->end(), values);
      ++kept;
    });
  }



  void CondensedSystem::for_interface_rows(
    const std::function<void(const int n, double *values)> &visit)
  {
    for (const auto dof : interface_dofs)
      if (owned.is_element(dof))
        {
          int     n       = 0;
          double *values  = nullptr;
          int    *columns = nullptr;
          matrix.trilinos_matrix().ExtractMyRowView(owned.index_within_set(dof),
                                                    n,
                                                    values,
                                                    columns);
          visit(n, values);
        }
  }
} // namespace Contact
