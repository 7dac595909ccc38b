/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/refined_system.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <map>

namespace Contact
{
  RefinedSystem::RefinedSystem(const ContactModel<2>      &model,
                               const IncrementState<2>    &state,
                               const ContactLinearization &linearization)
    : model(model)
    , state(state)
    , contact(model.discretization->counters)
    , relaxes(model.n_unknowns(), true)
    , cells_at(GridTools::vertex_to_cell_map(model.mesh->triangulation))
  {
    assemble(linearization);

    for (const auto &line : model.discretization->constraints.get_lines())
      relaxes[line.index] = false;
    std::fill(relaxes.begin() + model.n_displacements(), relaxes.end(), false);
    if (!model.interface)
      return;

    find_couplings();
    Unknowns at_contact;
    for (const ContactPoint<2> &point : model.interface->points())
      for (const SurfaceNode<2> *node : point.nodes)
        at_contact.insert(node->dofs.begin(), node->dofs.end());
    remove_fixed(at_contact);
    for (const auto dof : at_contact)
      relaxes[dof] = false;
    add_multipliers(at_contact);
    if (!at_contact.empty())
      factorize(at_contact, contact);
  }



  void RefinedSystem::assemble(const ContactLinearization &linearization)
  {
    const auto             n = model.n_unknowns();
    DynamicSparsityPattern couplings(n, n);
    model.elasticity->add_couplings(couplings);
    if (model.interface)
      model.interface->add_couplings(couplings);
    for (unsigned int i = 0; i < n; ++i)
      couplings.add(i, i);
    pattern.copy_from(couplings);
    matrix.reinit(pattern);

    rhs = model.zero();
    model.elasticity->assemble(state.solution, state.load_factor, rhs, &matrix);
    if (model.interface)
      ContactKernel<2>(*model.interface)
        .assemble(state.solution, state.start, linearization, rhs, &matrix);
    for (const auto &line : model.discretization->constraints.get_lines())
      matrix.diag_element(line.index) = 1;
  }



  void RefinedSystem::find_couplings()
  {
    std::map<NodeDoFs<2>, unsigned int> vertex_at;
    const auto &dofs = model.discretization->vertex_dofs;
    for (unsigned int v = 0; v < dofs.size(); ++v)
      vertex_at[dofs[v]] = v;
    for (const ContactPoint<2> &point : model.interface->points())
      {
        vertices_of_points.emplace_back();
        for (const SurfaceNode<2> *node : point.nodes)
          if (const auto found = vertex_at.find(node->dofs);
              found != vertex_at.end())
            vertices_of_points.back().push_back(found->second);
      }
  }



  void RefinedSystem::remove_fixed(Unknowns &unknowns) const
  {
    for (const auto &line : model.discretization->constraints.get_lines())
      unknowns.erase(line.index);
  }



  // Those of the points whose own node is among the unknowns.
  void RefinedSystem::add_multipliers(Unknowns &unknowns) const
  {
    const ContactInterface<2> &interface = *model.interface;
    const Unknowns             nodes     = unknowns;
    for (const ContactPoint<2> &point : interface.points())
      {
        if (point.n_nodes == 0)
          continue;
        const NodeDoFs<2> &own = point.dofs(point.own_node());
        if (nodes.count(own[0]) == 0 && nodes.count(own[1]) == 0)
          continue;
        for (unsigned int k = 0; k < point.n_multipliers; ++k)
          {
            unknowns.insert(interface.normal_index(point.multipliers[k]));
            if (interface.has_friction(point))
              unknowns.insert(interface.tangential_index(point.multipliers[k]));
          }
      }
  }



  void RefinedSystem::factorize(const Unknowns &unknowns, Block &block) const
  {
    block.unknowns.assign(unknowns.begin(), unknowns.end());
    const unsigned int        n = block.unknowns.size();
    std::vector<unsigned int> number(matrix.m(), numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < n; ++i)
      number[block.unknowns[i]] = i;
    const auto for_entries = [&](const auto &visit) {
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto row = block.unknowns[i];
          for (auto entry = matrix.begin(row); entry != matrix.end(row);
               ++entry)
            if (number[entry->column()] != numbers::invalid_unsigned_int)
              visit(i, number[entry->column()], entry->value());
        }
    };

    std::vector<unsigned int> lengths(n, 0);
    for_entries([&](const unsigned int i, const unsigned int, const double) {
      ++lengths[i];
    });
    SparsityPattern local_pattern(n, n, lengths);
    for_entries([&](const unsigned int i, const unsigned int j, const double) {
      local_pattern.add(i, j);
    });
    local_pattern.compress();
    SparseMatrix<double> local(local_pattern);
    for_entries([&](const unsigned int i,
                    const unsigned int j,
                    const double       value) { local.set(i, j, value); });
    block.solver.initialize(local_pattern);
    block.solver.factorize(local);
  }



  // Sweeps may lead away if the tangent is not definite, as of small cells at a
  // corner that are strained beyond what the material bears: then fewer count.
  GhostedVector RefinedSystem::relax(GhostedVector     &rhs,
                                     const unsigned int n_sweeps) const
  {
    GhostedVector x(rhs.size());
    const auto    missing = [&](const types::global_dof_index row) {
      double sum = rhs[row];
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        sum -= entry->value() * x[entry->column()];
      return sum;
    };
    const auto relax_node = [&](const types::global_dof_index row) {
      if (relaxes[row])
        x[row] += missing(row) / matrix.diag_element(row);
    };
    for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      {
        for (unsigned int row = 0; row < rhs.size(); ++row)
          relax_node(row);
        if (!contact.unknowns.empty())
          {
            Vector<double> block(contact.unknowns.size());
            for (unsigned int i = 0; i < block.size(); ++i)
              block[i] = missing(contact.unknowns[i]);
            contact.solver.solve(block);
            x.add(contact.unknowns, block);
          }
        for (unsigned int row = rhs.size(); row-- > 0;)
          relax_node(row);
      }
    GhostedVector left = rhs, product(rhs.size());
    matrix.vmult<Vector<double>, Vector<double>>(product, x);
    left -= product;
    if (n_sweeps > 0 && !(left.l2_norm() < rhs.l2_norm()))
      return relax(rhs, n_sweeps - 1);
    rhs = left;
    return x;
  }



  // Layers of cells are added, also on the other side of the contact; the
  // unknowns that the last one shares with cells outside keep their values.
  RefinedSystem::Unknowns RefinedSystem::unknowns_around(
    const std::vector<unsigned int> &vertices) const
  {
    // By trial: with three the estimate at the bore of
    // nested_cylinders_quadratic is three times the change on the next mesh,
    // with six it is that change.
    const unsigned int n_layers = 6;

    using Cells = std::set<Triangulation<2>::active_cell_iterator>;
    Cells                  inside, with_neighbors;
    std::set<unsigned int> reached(vertices.begin(), vertices.end());
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      {
        inside = with_neighbors;
        for (const unsigned int vertex : reached)
          with_neighbors.insert(cells_at[vertex].begin(),
                                cells_at[vertex].end());
        for (const auto &cell : with_neighbors)
          for (const unsigned int v : cell->vertex_indices())
            reached.insert(cell->vertex_index(v));
        for (const auto &coupled : vertices_of_points)
          if (std::any_of(coupled.begin(), coupled.end(), [&](const auto v) {
                return reached.count(v) > 0;
              }))
            reached.insert(coupled.begin(), coupled.end());
      }

    Unknowns                             unknowns, outside;
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : with_neighbors)
      {
        const DoFHandler<2>::active_cell_iterator with_dofs(
          &model.mesh->triangulation,
          cell->level(),
          cell->index(),
          &model.discretization->dof_handler);
        dofs.resize(with_dofs->get_fe().dofs_per_cell);
        with_dofs->get_dof_indices(dofs);
        (inside.count(cell) > 0 ? unknowns : outside)
          .insert(dofs.begin(), dofs.end());
      }
    for (const auto dof : outside)
      unknowns.erase(dof);
    remove_fixed(unknowns);
    return unknowns;
  }



  const RefinedSystem::Block &
  RefinedSystem::block_around(const std::vector<unsigned int> &vertices)
  {
    const auto [found, is_new] =
      around.try_emplace(vertices, model.discretization->counters);
    if (is_new)
      {
        Unknowns unknowns = unknowns_around(vertices);
        if (model.interface)
          add_multipliers(unknowns);
        if (!unknowns.empty())
          factorize(unknowns, found->second);
      }
    return found->second;
  }



  void
  RefinedSystem::solve_dual_around(const std::vector<unsigned int> &vertices,
                                   const GhostedVector             &functional,
                                   GhostedVector                   &dual)
  {
    const Block &block = block_around(vertices);
    if (block.unknowns.empty())
      return;

    GhostedVector missing = functional;
    GhostedVector product(dual.size());
    matrix.Tvmult<Vector<double>, Vector<double>>(product, dual);
    missing -= product;
    Vector<double> local(block.unknowns.size());
    for (unsigned int i = 0; i < local.size(); ++i)
      local[i] = missing[block.unknowns[i]];
    block.solver.solve_transposed(local);
    dual.add(block.unknowns, local);
  }
} // namespace Contact
