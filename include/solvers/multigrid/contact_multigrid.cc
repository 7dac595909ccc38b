/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/contact_multigrid.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    void add_spring(const double                     stiffness,
                    const SurfaceRows               &springs,
                    const unsigned int               row,
                    const AffineConstraints<double> &lines,
                    TrilinosWrappers::SparseMatrix  &matrix)
    {
      const unsigned int begin = springs.begin(row);
      FullMatrix<double> of_spring(springs.end(row) - begin);
      for (unsigned int i = 0; i < of_spring.m(); ++i)
        for (unsigned int j = 0; j < of_spring.n(); ++j)
          of_spring(i, j) =
            stiffness * springs.factors[begin + i] * springs.factors[begin + j];
      lines.distribute_local_to_global(of_spring,
                                       springs.others_of(row),
                                       matrix);
    }
  } // namespace



  template<int dim>
  ContactMultigrid<dim>::ContactMultigrid(
    const Discretization<dim>                       &discretization,
    const std::map<types::material_id, ElasticBody> &elastic_bodies,
    const ContactInterface<dim>                     *interface)
    : discretization(discretization)
    , meshes(discretization.mesh.levels.of(discretization.mesh.triangulation))
    , elastic_bodies(elastic_bodies)
  {
    for (const auto &mesh : meshes)
      levels.push_back(
        std::make_unique<MultigridLevel<dim>>(*mesh,
                                              discretization,
                                              this->elastic_bodies));
    make_levels(cells_of(interface));
    collect_coarse_cells();
  }



  // Lines of contact and supports go from mesh to mesh by the cells at surfaces
  // of contact and at supports.
  template<int dim>
  SurfaceCells<dim>
  ContactMultigrid<dim>::cells_of(const ContactInterface<dim> *interface) const
  {
    // In a concave corner a node that hangs may follow one of a cell inside.
    Dofs at_surfaces, followed_inside;
    if (interface != nullptr)
      for (const auto &pair : interface->pairs)
        for (const auto *surface :
             {&pair->slave, pair->master ? &*pair->master : nullptr})
          if (surface != nullptr)
            for (unsigned int n = 0; n < surface->nodes.size(); ++n)
              {
                const auto &node = surface->nodes[n].dofs;
                Dofs       &dofs = surface->facets_of_node[n].empty()
                                     ? followed_inside
                                     : at_surfaces;
                dofs.insert(dofs.end(), node.begin(), node.end());
              }
    sort_unique(at_surfaces);
    sort_unique(followed_inside);

    Dofs       of_cell(discretization.fe[0].n_dofs_per_cell());
    const auto has_any = [&](const auto &is_one) {
      return std::any_of(of_cell.begin(), of_cell.end(), is_one);
    };
    return {levels.back()->dof_handler, [&](const auto &cell) {
              cell->get_dof_indices(of_cell);
              const auto has_any_of = [&](const Dofs &dofs) {
                return has_any([&](const Dof dof) {
                  return std::binary_search(dofs.begin(), dofs.end(), dof);
                });
              };
              return (cell->at_boundary() && has_any_of(at_surfaces)) ||
                     (!followed_inside.empty() &&
                      has_any_of(followed_inside)) ||
                     has_any([&](const Dof dof) {
                       return discretization.is_fixed(dof);
                     });
            }};
  }



  template<int dim>
  void ContactMultigrid<dim>::make_levels(const SurfaceCells<dim> &of_finest)
  {
    Dofs fixed;
    for (const Dof dof : levels.back()->dof_handler.locally_owned_dofs())
      if (discretization.is_fixed(dof))
        fixed.push_back(dof);
    levels.back()->make_operator(fixed);
    transfers.resize(levels.size() - 1);
    for (unsigned int l = levels.size() - 1; l-- > 0;)
      {
        transfers[l] = std::make_unique<LevelTransfer<dim>>(
          *levels[l],
          *levels[l + 1],
          l + 1 < transfers.size() ? transfers[l + 1]->coarse_cells()
                                   : of_finest);
        fixed = transfers[l]->at_same_nodes(fixed);
        levels[l]->make_operator(fixed);
        transfers[l]->initialize();
      }
    coarse_supports = gathered(fixed, discretization.communicator);
    coarse_centres  = levels[0]->bound_centres();
    no_constraints.close();
    coarse_bodies =
      std::make_unique<BodyOperator<dim, double>>(levels[0]->mapping,
                                                  levels[0]->quadrature,
                                                  levels[0]->dof_handler,
                                                  no_binding,
                                                  elastic_bodies);
  }



  template<int dim>
  void ContactMultigrid<dim>::collect_coarse_cells()
  {
    Dofs of_cell(discretization.fe[0].n_dofs_per_cell());
    for (const auto &cell : levels[0]->dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(of_cell);
          coarse_cells.insert(coarse_cells.end(),
                              of_cell.begin(),
                              of_cell.end());
        }
    coarse_cells = gathered(coarse_cells, discretization.communicator);
  }



  template<int dim>
  void ContactMultigrid<dim>::linearize(const Fine &solution)
  {
    levels.back()->solution.copy_locally_owned_data_from(solution);
    for (unsigned int l = levels.size(); l-- > 0;)
      {
        if (l + 1 < levels.size())
          transfers[l]->interpolate();
        levels[l]->linearize();
      }
    Fine of_coarsest;
    coarse_bodies->initialize(of_coarsest);
    of_coarsest.copy_locally_owned_data_from(levels[0]->solution);
    coarse_bodies->linearize(of_coarsest);
    is_complete = false;
  }



  template<int dim>
  void ContactMultigrid<dim>::set_lines(
    const Dofs                       &eliminated,
    const AffineConstraints<double>  &constraints,
    const AffineConstraints<double>  &test_constraints,
    const std::vector<SurfaceSpring> &springs)
  {
    MultigridLevel<dim> &finest = *levels.back();
    const IndexSet      &owned  = finest.dof_handler.locally_owned_dofs();
    const auto lines_of = [&](const AffineConstraints<double> &of_these) {
      return SurfaceRows(eliminated, of_these, owned)
        .of_all_ranks(discretization.communicator);
    };
    const bool is_symmetric = &test_constraints == &constraints;
    finest.set_springs(springs);
    test_projection.initialize(is_symmetric ? SurfaceRows()
                                            : lines_of(test_constraints),
                               finest.inverse_diagonal());
    const bool is_new  = !is_complete;
    is_complete        = false; // if a factorization fails
    bool has_new_lines = finest.set_lines(lines_of(constraints)) || is_new;
    for (unsigned int l = transfers.size(); has_new_lines && l-- > 0;)
      has_new_lines = transfers[l]->hand_down() || is_new;
    if (has_new_lines)
      make_coarse_matrix();
    is_complete = true;
  }



  template<int dim>
  AffineConstraints<double> ContactMultigrid<dim>::coarse_constraints() const
  {
    AffineConstraints<double> all;
    const auto                add = [&](const SurfaceRows &rows) {
      for (unsigned int row = 0; row < rows.size(); ++row)
        if (!all.is_constrained(rows.dofs[row]))
          {
            all.add_line(rows.dofs[row]);
            for (unsigned int k = rows.begin(row); k < rows.end(row); ++k)
              all.add_entry(rows.dofs[row], rows.others[k], rows.factors[k]);
          }
    };
    add(coarse_lines);
    for (const Dof dof : coarse_supports) // the mesh has no hanging nodes
      all.add_line(dof);
    add(coarse_centres);
    all.close();
    return all;
  }



  // Springs come and go, mostly over the same unknowns of this mesh: room for
  // one that has gone stays.
  template<int dim>
  bool ContactMultigrid<dim>::add_couplings(const SurfaceRows &springs)
  {
    SurfaceRows missing;
    for (unsigned int row = 0; row < springs.size(); ++row)
      if (coarse_couplings.count(springs.others_of(row)) == 0)
        missing.add_row(springs, row);
    missing = missing.of_all_ranks(discretization.communicator);
    for (unsigned int row = 0; row < missing.size(); ++row)
      coarse_couplings.insert(missing.others_of(row));
    return missing.size() > 0;
  }



  // The mesh is small: every rank has the whole matrix, to which each adds its
  // cells, and factorizes it by itself. A solution then takes one sum over the
  // ranks, where a factorization in parts sends more messages than it computes.
  template<int dim>
  void ContactMultigrid<dim>::make_coarse_matrix()
  {
    const MultigridLevel<dim> &level = *levels[0];
    const unsigned int         n = level.dof_handler.get_fe().n_dofs_per_cell();
    const bool new_lines = !coarse_lines.has_pattern_of(level.all_lines());
    coarse_lines         = level.all_lines();
    const AffineConstraints<double> all = coarse_constraints();
    SurfaceRows                     springs;
    for (const auto &[stiffness, way] : level.own_springs())
      springs.add_row(numbers::invalid_dof_index, {way.begin(), way.end()});
    if (!coarse_solver || new_lines)
      coarse_couplings.clear();
    const bool new_couplings = add_couplings(springs);
    const bool new_pattern   = !coarse_solver || new_lines || new_couplings;
    Dofs       dofs(n);
    if (new_pattern)
      {
        DynamicSparsityPattern pattern(level.m(), level.m());
        for (auto cell = coarse_cells.begin(); cell != coarse_cells.end();
             cell += n)
          {
            dofs.assign(cell, cell + n);
            all.add_entries_local_to_global(dofs,
                                            pattern,
                                            /*keep_constrained_entries=*/true);
          }
        for (Dof i = 0; i < level.m(); ++i)
          pattern.add(i, i);
        for (const Dofs &coupling : coarse_couplings)
          all.add_entries_local_to_global(coupling,
                                          pattern,
                                          /*keep_constrained_entries=*/true);
        const IndexSet rows = complete_index_set(level.m());
        coarse_solver.reset();
        coarse_matrix.clear();
        coarse_matrix.reinit(rows, rows, pattern, MPI_COMM_SELF);
      }
    else
      coarse_matrix = 0;

    coarse_bodies->visit_tangents(
      [&](const auto &tangent, const auto &of_cell) {
        all.distribute_local_to_global(tangent, of_cell, coarse_matrix);
      });
    for (unsigned int k = 0; k < springs.size(); ++k)
      add_spring(level.own_springs()[k].stiffness,
                 springs,
                 k,
                 all,
                 coarse_matrix);
    coarse_matrix.compress(VectorOperation::add);
    int    *starts, *columns;
    double *values;
    coarse_matrix.trilinos_matrix().ExtractCrsDataPointers(starts,
                                                           columns,
                                                           values);
    const ArrayView<double> entries(values, coarse_matrix.n_nonzero_elements());
    Utilities::MPI::sum(ArrayView<const double>(entries),
                        discretization.communicator,
                        entries);
    if (new_pattern)
      coarse_solver =
        std::make_unique<Factorization>(/*may_be_indefinite=*/true,
                                        discretization.counters);
    coarse_solver->make(coarse_matrix, new_pattern);
  }



  template<int dim>
  void ContactMultigrid<dim>::solve_coarse() const
  {
    const MultigridLevel<dim> &level = *levels[0];
    const IndexSet            &owned = level.dof_handler.locally_owned_dofs();
    level.contact_lines().condense(level.rhs);
    std::vector<double> rhs(level.m());
    auto                own = level.rhs.begin();
    for (const auto i : owned)
      rhs[i] = *own++;
    Utilities::MPI::sum(rhs, discretization.communicator, rhs);
    DefiniteSolver::Vector b(complete_index_set(level.m()), MPI_COMM_SELF);
    DefiniteSolver::Vector x(b);
    std::copy(rhs.begin(), rhs.end(), b.begin());
    coarse_solver->vmult(x, b);
    own = level.solution.begin();
    for (const auto i : owned)
      *own++ = x[i];
    level.contact_lines().expand(level.solution);
  }



  template<int dim>
  void ContactMultigrid<dim>::cycle(const unsigned int l) const
  {
    if (l == 0)
      {
        solve_coarse();
        return;
      }
    const MultigridLevel<dim> &level = *levels[l];
    level.smooth_from_zero();
    level.vmult(level.residual, level.solution);
    level.residual.sadd(-1, 1, level.rhs);
    transfers[l - 1]->restrict_residual();
    cycle(l - 1);
    transfers[l - 1]->correct();
    level.smooth();
  }



  // With friction in the tangent, forces are given up to pressures and the
  // shears that go with them. Of these the diagonal chooses: what it knows of
  // friction is all that the levels, which are symmetric, are told.
  template<int dim>
  void ContactMultigrid<dim>::vmult(Fine &dst, const Fine &src) const
  {
    const MultigridLevel<dim> &finest = *levels.back();
    finest.rhs.copy_locally_owned_data_from(src);
    test_projection.project_transposed(finest.rhs);
    finest.contact_projection().project_transposed(finest.rhs);
    cycle(levels.size() - 1);
    finest.contact_lines().clear(finest.solution);
    dst.copy_locally_owned_data_from(finest.solution);
  }

  template class ContactMultigrid<2>;
  template class ContactMultigrid<3>;
} // namespace Contact
