/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/contact_multigrid.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Contact
{
  /// A mesh with its stiffness, the lines of contact and the smoother.
  template<int dim>
  class ContactMultigrid<dim>::Level : public Subscriptor
  {
  public:
    Level(const Triangulation<dim>                     &mesh,
          const Discretization<dim>                    &finest,
          const std::map<types::material_id, Material> &materials)
      : dof_handler(mesh)
      , mapping(finest.mapping[0])
      , materials(materials)
    {
      dof_handler.distribute_dofs(finest.fe[0]);
    }

    /// Supports are those that @p is_fixed tells.
    void make_operator(const std::vector<bool> &is_fixed)
    {
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      for (Dof i = 0; i < is_fixed.size(); ++i)
        if (is_fixed[i] && !constraints.is_constrained(i))
          constraints.add_line(i);
      constraints.close();
      stiffness = std::make_unique<BodyOperator<dim, Number>>(mapping,
                                                              dof_handler,
                                                              constraints,
                                                              materials);
      of_bodies = stiffness->diagonal();
      for (Vector *vector : {&rhs, &solution, &residual, &work})
        stiffness->initialize(*vector);
    }

    /// In the displacement @p solution.
    void linearize(const std::set<types::material_id> &small_strain)
    {
      stiffness->linearize(solution, small_strain);
      of_bodies = stiffness->diagonal();
    }

    /// C^T K C, the identity in what is eliminated or constrained.
    void vmult(Vector &dst, const Vector &src) const
    {
      work = src;
      lines.expand(work);
      stiffness->vmult(dst, work);
      lines.condense(dst);
    }

    void set_lines(const SurfaceLines<Number> &new_lines)
    {
      lines            = new_lines;
      auto    diagonal = std::make_shared<DiagonalMatrix<Vector>>();
      Vector &inverse  = diagonal->get_vector();
      inverse          = of_bodies;
      lines.add_to_diagonal(inverse);
      for (auto &value : inverse)
        value = value > 0 ? 1 / value : 1;

      typename Smoother::AdditionalData data;
      data.degree              = 4;
      data.smoothing_range     = 16;
      data.eig_cg_n_iterations = 12;
      data.preconditioner      = diagonal;
      smoother.initialize(*this, data);
    }

    types::global_dof_index m() const
    {
      return dof_handler.n_dofs();
    }

    Number el(const Dof, const Dof) const
    {
      AssertThrow(false, ExcNotImplemented());
      return 0;
    }

    using Smoother =
      PreconditionChebyshev<Level, Vector, DiagonalMatrix<Vector>>;

    DoFHandler<dim>                               dof_handler;
    const Mapping<dim>                           &mapping;
    const std::map<types::material_id, Material> &materials;
    AffineConstraints<Number>                     constraints;
    std::unique_ptr<BodyOperator<dim, Number>>    stiffness;
    Vector                                        of_bodies;
    SurfaceLines<Number>                          lines;
    AffineConstraints<double>                     line_constraints;
    Dofs                                          eliminated;
    Smoother                                      smoother;
    mutable Vector                                rhs, solution, residual, work;
  };



  /// The interpolation from a level to the next finer one.
  template<int dim>
  class ContactMultigrid<dim>::Between
  {
  public:
    Between(Level &coarse, Level &fine)
      : coarse(coarse)
      , fine(fine)
    {
      collect_rows();
    }

    /// After both levels have their constraints.
    void initialize()
    {
      transfer.reinit_geometric_transfer(fine.dof_handler,
                                         coarse.dof_handler,
                                         fine.constraints,
                                         coarse.constraints);
    }

    /// The fine unknown at the same node as each coarse one.
    Dofs same;

    /// Give the coarse level the lines of the fine one.
    void hand_down() const
    {
      auto &lines = coarse.line_constraints;
      lines.clear();
      coarse.eliminated.clear();
      for (const Dof dof : fine.eliminated)
        {
          const auto found = rows.find(dof);
          AssertThrow(found != rows.end(), ExcInternalError());
          const auto &row = found->second;
          if (row.size() != 1 || row[0].second != 1 ||
              coarse.constraints.is_constrained(row[0].first))
            continue;
          const Dof             here = row[0].first;
          std::map<Dof, double> sum;
          if (const auto *entries =
                fine.line_constraints.get_constraint_entries(dof))
            for (const auto &[other, factor] : *entries)
              {
                const auto by = rows.find(other);
                AssertThrow(by != rows.end(), ExcInternalError());
                for (const auto &[c, weight] : by->second)
                  {
                    if (!coarse.constraints.is_constrained(c))
                      sum[c] += factor * weight;
                    else
                      for (const auto &[c2, weight2] :
                           *coarse.constraints.get_constraint_entries(c))
                        sum[c2] += factor * weight * weight2;
                  }
              }
          lines.add_line(here);
          for (const auto &[other, factor] : sum)
            if (factor != 0 && other != here)
              lines.add_entry(here, other, factor);
          coarse.eliminated.push_back(here);
        }
      lines.close();
      std::sort(coarse.eliminated.begin(), coarse.eliminated.end());
      coarse.set_lines(
        SurfaceLines<Number>(coarse.eliminated, coarse.line_constraints));
    }

    /// The displacement of the fine level on the coarse one.
    void interpolate() const
    {
      transfer.interpolate(coarse.solution, fine.solution);
    }

    /// What is eliminated does not count on either side.
    void prolongate_and_add(Vector &dst, Vector &src) const
    {
      coarse.lines.expand(src);
      transfer.prolongate_and_add(dst, src);
      fine.lines.set(dst, 0);
    }

    void restrict_and_add(Vector &dst, Vector &src) const
    {
      fine.lines.set(src, 0);
      transfer.restrict_and_add(dst, src);
      coarse.lines.condense(dst);
    }

  private:
    // Of the unknowns of cells at the boundary: all that lines may have.
    void collect_rows()
    {
      const auto        &fe = coarse.dof_handler.get_fe();
      const unsigned int n  = fe.n_dofs_per_cell();
      Dofs               of_coarse(n), of_fine(n);
      same.assign(coarse.dof_handler.n_dofs(), numbers::invalid_dof_index);
      for (const auto &cell : coarse.dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(of_coarse);
          const auto raw =
            fine.dof_handler.get_triangulation().create_cell_iterator(
              cell->id());
          const typename DoFHandler<dim>::cell_iterator same_cell(
            &fine.dof_handler.get_triangulation(),
            raw->level(),
            raw->index(),
            &fine.dof_handler);
          const bool at_boundary = cell->at_boundary();
          const auto add = [&](const auto &fine_cell, const auto &weight) {
            fine_cell->get_dof_indices(of_fine);
            for (unsigned int i = 0; i < n; ++i)
              {
                std::vector<std::pair<Dof, double>> row;
                for (unsigned int j = 0; j < n; ++j)
                  if (const double w = weight(i, j); std::abs(w) > 1e-12)
                    row.emplace_back(of_coarse[j], w);
                if (row.size() == 1 && std::abs(row[0].second - 1) < 1e-12)
                  {
                    row[0].second      = 1;
                    same[row[0].first] = of_fine[i];
                  }
                if (at_boundary)
                  rows.emplace(of_fine[i], std::move(row));
              }
          };
          if (same_cell->is_active())
            add(same_cell, [](const unsigned int i, const unsigned int j) {
              return i == j ? 1. : 0.;
            });
          else
            for (unsigned int c = 0; c < same_cell->n_children(); ++c)
              {
                const auto &matrix = fe.get_prolongation_matrix(c);
                add(same_cell->child(c),
                    [&](const unsigned int i, const unsigned int j) {
                      return matrix(i, j);
                    });
              }
        }
    }

    Level                          &coarse, &fine;
    MGTwoLevelTransfer<dim, Vector> transfer;

    /// Of fine unknowns, by coarse ones.
    std::map<Dof, std::vector<std::pair<Dof, double>>> rows;
  };



  template<int dim>
  ContactMultigrid<dim>::ContactMultigrid(
    const Discretization<dim> &discretization,
    const Elasticity<dim>     &elasticity)
    : discretization(discretization)
    , meshes(
        MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(
          static_cast<const Triangulation<dim> &>(
            discretization.mesh.triangulation)))
  {
    for (const auto &body : discretization.mesh.bodies)
      {
        materials.emplace(body.second, elasticity.material(body.second));
        if (elasticity.is_small_strain(body.second))
          small_strain.insert(body.second);
      }
    for (const auto &mesh : meshes)
      levels.push_back(
        std::make_unique<Level>(*mesh, discretization, materials));
    for (unsigned int l = 0; l + 1 < levels.size(); ++l)
      between.push_back(std::make_unique<Between>(*levels[l], *levels[l + 1]));

    std::vector<bool> is_fixed(levels.back()->m());
    for (Dof i = 0; i < is_fixed.size(); ++i)
      is_fixed[i] = discretization.is_fixed(i);
    for (unsigned int l = levels.size(); l-- > 0;)
      {
        if (l + 1 < levels.size())
          {
            std::vector<bool> coarser;
            for (const Dof i : between[l]->same)
              coarser.push_back(is_fixed[i]);
            is_fixed = coarser;
          }
        levels[l]->make_operator(is_fixed);
      }
    for (const auto &transfer : between)
      transfer->initialize();
  }

  template<int dim>
  ContactMultigrid<dim>::~ContactMultigrid() = default;



  template<int dim>
  void ContactMultigrid<dim>::linearize(const Fine &solution)
  {
    levels.back()->solution.copy_locally_owned_data_from(solution);
    for (unsigned int l = levels.size(); l-- > 0;)
      {
        if (l + 1 < levels.size())
          between[l]->interpolate();
        levels[l]->linearize(small_strain);
      }
    coarse_displacement.reinit(levels[0]->m());
    std::copy(levels[0]->solution.begin(),
              levels[0]->solution.end(),
              coarse_displacement.begin());
  }



  template<int dim>
  void
  ContactMultigrid<dim>::set_lines(const Dofs                      &eliminated,
                                   const AffineConstraints<double> &constraints)
  {
    Level &finest = *levels.back();
    finest.line_constraints.copy_from(constraints);
    finest.eliminated = eliminated;
    finest.set_lines(SurfaceLines<Number>(eliminated, constraints));
    for (unsigned int l = levels.size() - 1; l-- > 0;)
      between[l]->hand_down();
    factorize_coarse();
  }



  template<int dim>
  void ContactMultigrid<dim>::factorize_coarse()
  {
    Level                    &level = *levels[0];
    const FiniteElement<dim> &fe    = level.dof_handler.get_fe();
    AffineConstraints<double> all;
    all.copy_from(level.line_constraints);
    for (Dof i = 0; i < level.m(); ++i)
      if (level.constraints.is_constrained(i))
        all.add_line(i);
    all.close();

    DynamicSparsityPattern pattern(level.m(), level.m());
    DoFTools::make_sparsity_pattern(level.dof_handler, pattern, all, true);
    coarse_solver.reset();
    coarse_matrix.clear();
    coarse_matrix.reinit(pattern);

    FEValues<dim>                    values(level.mapping,
                         fe,
                         QGauss<dim>(fe.degree + 1),
                         update_gradients | update_JxW_values);
    const unsigned int               n = fe.n_dofs_per_cell();
    FullMatrix<double>               tangent(n, n);
    const FEValuesExtractors::Vector displacement(0);
    std::vector<Tensor<2, dim>>      gradients(values.n_quadrature_points);
    Dofs                             dofs(n);
    for (const auto &cell : level.dof_handler.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        const Material &material = materials.at(cell->material_id());
        tangent                  = 0;
        const bool is_large      = coarse_displacement.size() > 0 &&
                              small_strain.count(cell->material_id()) == 0;
        if (is_large)
          values[displacement].get_function_gradients(coarse_displacement,
                                                      gradients);
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          {
            Tensor<2, dim>          F = unit_symmetric_tensor<dim>();
            SymmetricTensor<2, dim> S;
            if (is_large)
              {
                F += gradients[q];
                S = material.template stress<dim>(
                  0.5 * symmetrize(transpose(F) * F) -
                  0.5 * unit_symmetric_tensor<dim>());
              }
            for (unsigned int i = 0; i < n; ++i)
              {
                const unsigned int a = fe.system_to_component_index(i).first;
                const auto         g = values.shape_grad(i, q);
                const SymmetricTensor<2, dim> strain =
                  symmetrize(outer_product(F[a], g));
                const SymmetricTensor<2, dim> stress =
                  material.template stress<dim>(strain) * values.JxW(q);
                const Tensor<2, dim> P   = F * Tensor<2, dim>(stress);
                const Tensor<1, dim> S_g = S * g * values.JxW(q);
                for (unsigned int j = 0; j < n; ++j)
                  {
                    const unsigned int b =
                      fe.system_to_component_index(j).first;
                    const auto h = values.shape_grad(j, q);
                    tangent(i, j) += P[b] * h + (a == b ? S_g * h : 0.);
                  }
              }
          }
        all.distribute_local_to_global(tangent, dofs, coarse_matrix);
      }
    coarse_matrix.compress(VectorOperation::add);
    coarse_solver = DefiniteSolver::create(Parameters::SolverKind::cholmod,
                                           true,
                                           true,
                                           {},
                                           discretization.counters);
    coarse_solver->set_matrix(coarse_matrix, true, true, {});
  }



  template<int dim>
  void ContactMultigrid<dim>::cycle(const unsigned int l) const
  {
    const Level &level = *levels[l];
    if (l == 0)
      {
        DefiniteSolver::Vector b(complete_index_set(level.m())), x(b);
        std::copy(level.rhs.begin(), level.rhs.end(), b.begin());
        coarse_solver->solve(b, 0, x);
        std::copy(x.begin(), x.end(), level.solution.begin());
        return;
      }
    level.smoother.vmult(level.solution, level.rhs);
    level.vmult(level.residual, level.solution);
    level.residual.sadd(-1, 1, level.rhs);
    const Level &coarser = *levels[l - 1];
    coarser.rhs          = 0;
    between[l - 1]->restrict_and_add(coarser.rhs, level.residual);
    cycle(l - 1);
    between[l - 1]->prolongate_and_add(level.solution, coarser.solution);
    level.smoother.step(level.solution, level.rhs);
  }



  template<int dim>
  void ContactMultigrid<dim>::vmult(Fine &dst, const Fine &src) const
  {
    const Level &finest = *levels.back();
    finest.rhs.copy_locally_owned_data_from(src);
    cycle(levels.size() - 1);
    dst.copy_locally_owned_data_from(finest.solution);
  }



  template<int dim>
  std::size_t ContactMultigrid<dim>::memory() const
  {
    std::size_t sum = 0;
    for (const auto &level : levels)
      sum +=
        level->stiffness->memory() + level->dof_handler.memory_consumption();
    return sum;
  }

  template class ContactMultigrid<2>;
  template class ContactMultigrid<3>;
} // namespace Contact
