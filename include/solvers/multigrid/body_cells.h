/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_cells_h
#define contact_body_cells_h

#include <algorithm>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "solvers/multigrid/body_operator.h"
#include "solvers/multigrid/cell_centres.h"
#include "solvers/multigrid/cell_modes.h"

namespace Contact
{
  /// As many numbers as a register has.
  template<typename Number>
  using Wide =
    VectorizedArray<Number,
                    std::max<std::size_t>(1,
                                          DEAL_II_VECTORIZATION_WIDTH_IN_BITS /
                                            (8 * sizeof(Number)))>;

  /// The cells of a BodyOperator, for its source file alone, which lets wide
  /// vectors of numbers in.
  template<int dim, typename Number>
  class BodyOperator<dim, Number>::Cells
  {
  public:
    using Numbers    = Wide<Number>;
    using Gradient   = Tensor<2, dim, Numbers>;
    using Stress     = SymmetricTensor<2, dim, Numbers>;
    using Data       = MatrixFree<dim, Number, Numbers>;
    using Amplitudes = typename CellModes<dim, Numbers>::Amplitudes;

    Cells(const Mapping<dim>                              &mapping,
          const Quadrature<dim>                           &quadrature,
          const DoFHandler<dim>                           &dof_handler,
          const CentreBinding<dim, Number>                &binding,
          const std::map<types::material_id, ElasticBody> &bodies)
      : dof_handler(dof_handler)
      , constraints(binding.constraints())
      , quadrature(quadrature)
      , degree(dof_handler.get_fe().degree)
      , is_tensor_product(dof_handler.get_fe().reference_cell().is_hyper_cube())
      , bodies(bodies)
    {
      typename Data::AdditionalData data;
      data.tasks_parallel_scheme = Data::AdditionalData::none;
      data.mapping_update_flags  = update_gradients | update_JxW_values;
      matrix_free.reinit(mapping, dof_handler, constraints, quadrature, data);

      lambda.resize(matrix_free.n_cell_batches());
      two_mu.resize(matrix_free.n_cell_batches());
      const bool has_incompatible_modes =
        std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
          return body.second.has_incompatible_modes;
        });
      modes.reinit(matrix_free.n_cell_batches(),
                   quadrature.size(),
                   has_incompatible_modes
                     ? dim * dim
                     : n_dilatation_modes(dof_handler.get_fe()));
      cell_numbers = matrix_free.get_shape_info().lexicographic_numbering;
      if (binding.has_any())
        centres.make(dof_handler.get_fe(), cell_numbers);
      is_bound.resize(matrix_free.n_cell_batches());
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        visit_cells(batch, [&](const unsigned int v, const auto &cell) {
          is_bound[batch][v] = binding.is_in_cell(cell->active_cell_index());
          const ElasticBody &body = bodies.at(cell->material_id());
          lambda[batch][v]        = body.material.lambda;
          two_mu[batch][v]        = 2 * body.material.mu;
          set_modes(batch, v, body);
        });
    }

    void linearize(const Vector &u)
    {
      FEEvaluation<dim, -1, 0, dim, Number, Numbers> values(matrix_free);
      const unsigned int                             n = values.n_q_points;
      gradients.resize(matrix_free.n_cell_batches() * n);
      amplitudes.resize(matrix_free.n_cell_batches());
      u.update_ghost_values();
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          values.reinit(batch);
          values.read_dof_values_plain(u);
          values.evaluate(EvaluationFlags::gradients);
          Numbers is_large = Number(1);
          visit_cells(batch, [&](const unsigned int v, const auto &cell) {
            is_large[v] = !bodies.at(cell->material_id()).is_small_strain;
          });
          for (unsigned int q = 0; q < n; ++q)
            gradients[batch * n + q] = is_large * values.get_gradient(q);
          amplitudes[batch] =
            modes.amplitudes(batch, values, [&](const unsigned int q) {
              return strain(gradients[batch * n + q]);
            });
        }
      u.zero_out_ghost_values();
    }

    /// As vmult() and forces() of the operator.
    template<bool has_all_values>
    void apply(Vector &dst, const Vector &src) const
    {
      if (!is_tensor_product)
        loop(&Cells::template multiply<-1, has_all_values>, dst, src);
      else if (degree == 1)
        loop(&Cells::template multiply<1, has_all_values>, dst, src);
      else
        loop(&Cells::template multiply<2, has_all_values>, dst, src);
    }

    template<class Visitor>
    void visit_tangents(const Visitor &visitor) const
    {
      FEEvaluation<dim, -1, 0, dim, Number, Numbers> u(matrix_free);
      const unsigned int                             n = u.dofs_per_cell;
      std::vector<types::global_dof_index>           dofs(n);
      std::vector<FullMatrix<double>>                tangents(Numbers::size(),
                                               FullMatrix<double>(n));
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          u.reinit(batch);
          for (unsigned int j = 0; j < n; ++j)
            {
              for (unsigned int i = 0; i < n; ++i)
                u.begin_dof_values()[i] = Number(i == j);
              u.evaluate(EvaluationFlags::gradients);
              set_stresses(batch, u);
              u.integrate(EvaluationFlags::gradients);
              for (unsigned int i = 0; i < n; ++i)
                for (unsigned int v = 0; v < Numbers::size(); ++v)
                  tangents[v](cell_numbers[i], cell_numbers[j]) =
                    u.begin_dof_values()[i][v];
            }
          visit_cells(batch, [&](const unsigned int v, const auto &cell) {
            cell->get_dof_indices(dofs);
            visitor(tangents[v], dofs);
          });
        }
    }

    // With f the row of F of the direction i, in small strain the unit vector:
    // mu (|f|^2 |grad N|^2 + (f . grad N)^2) + lambda (f . grad N)^2, and what
    // the stress adds, grad N . S grad N. A mode sigma adds s times the square
    // of the integral of f . sigma grad N.
    Vector diagonal() const
    {
      Vector result;
      matrix_free.initialize_dof_vector(result);
      const FiniteElement<dim> &fe      = dof_handler.get_fe();
      const unsigned int        n_nodes = fe.n_dofs_per_cell() / dim;

      // Unit gradients of the nodes, and the place of their unknowns.
      std::vector<std::array<unsigned int, dim>> unknowns(n_nodes);
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          const auto [component, index] = fe.system_to_component_index(i);
          unknowns[index][component]    = i;
        }
      std::vector<std::vector<Tensor<1, dim>>> unit(quadrature.size());
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        for (unsigned int a = 0; a < n_nodes; ++a)
          unit[q].push_back(
            fe.shape_grad_component(unknowns[a][0], quadrature.point(q), 0));

      AlignedVector<Numbers>               local(fe.n_dofs_per_cell());
      AlignedVector<Amplitudes>            of_modes;
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          local.fill(Numbers());
          of_modes.resize_fast(0);
          of_modes.resize(fe.n_dofs_per_cell(), Amplitudes());
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto [map, weight] = geometry(batch, q);
              const Numbers mu         = Number(0.5) * weight * two_mu[batch];
              const Numbers sum        = mu + weight * lambda[batch];
              Gradient      F          = unit_symmetric_tensor<dim, Numbers>();
              Stress        S;
              if (!gradients.empty())
                {
                  const Gradient &gradient =
                    gradients[batch * quadrature.size() + q];
                  F += gradient;
                  S = stress_at(batch, q, gradient) * weight;
                }
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  Tensor<1, dim, Numbers> g;
                  for (unsigned int i = 0; i < dim; ++i)
                    for (unsigned int j = 0; j < dim; ++j)
                      g[i] += map[i][j] * Number(unit[q][a][j]);
                  const Numbers by_mu     = mu * (g * g);
                  const Numbers by_stress = g * (S * g);
                  for (unsigned int i = 0; i < dim; ++i)
                    {
                      const Numbers along = F[i] * g;
                      local[unknowns[a][i]] +=
                        by_mu * (F[i] * F[i]) + sum * along * along + by_stress;
                      for (unsigned int m = 0; m < modes.size(batch); ++m)
                        of_modes[unknowns[a][i]][m] +=
                          weight * (F[i] * (modes.stress(batch, q, m) * g));
                    }
                }
            }
          for (unsigned int i = 0; i < local.size(); ++i)
            local[i] += modes.product(batch, of_modes[i], of_modes[i]);
          centres.hand_over_diagonal(is_bound[batch], local);
          visit_cells(batch, [&](const unsigned int v, const auto &cell) {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (!constraints.is_constrained(dofs[i]))
                result(dofs[i]) += local[i][v];
              else
                for (const auto &[dof, factor] :
                     *constraints.get_constraint_entries(dofs[i]))
                  result(dof) += factor * factor * local[i][v];
          });
        }
      result.compress(VectorOperation::add);
      return result;
    }

    bool is_linear() const
    {
      return gradients.empty();
    }

    const DoFHandler<dim>           &dof_handler;
    const AffineConstraints<Number> &constraints;
    const Quadrature<dim>            quadrature;
    const unsigned int               degree;
    const bool                       is_tensor_product;
    Data                             matrix_free;

  private:
    /// The cells of a batch.
    template<class Visitor>
    void visit_cells(const unsigned int batch, const Visitor &visit) const
    {
      for (unsigned int v = 0;
           v < matrix_free.n_active_entries_per_cell_batch(batch);
           ++v)
        visit(v, matrix_free.get_cell_iterator(batch, v));
    }

    /// J^-T and JxW in a point. Affine cells have them once, and without its
    /// weight.
    std::pair<Gradient, Numbers> geometry(const unsigned int batch,
                                          const unsigned int q) const
    {
      const auto        &map   = matrix_free.get_mapping_info().cell_data[0];
      const unsigned int place = map.data_index_offsets[batch];
      if (matrix_free.get_mapping_info().get_cell_type(batch) <=
          internal::MatrixFreeFunctions::affine)
        return {map.jacobians[0][place],
                map.JxW_values[place] * Number(quadrature.weight(q))};
      return {map.jacobians[0][place + q], map.JxW_values[place + q]};
    }

    template<typename Multiply>
    void loop(const Multiply multiply, Vector &dst, const Vector &src) const
    {
      matrix_free.cell_loop(multiply, this, dst, src, /*zero_dst_vector=*/true);
    }

    /// Values of constrained unknowns are those of @p src, or follow from the
    /// others. A @p degree of -1 is any, without sum factorization.
    template<int degree, bool has_all_values>
    void multiply(const Data &,
                  Vector                                      &dst,
                  const Vector                                &src,
                  const std::pair<unsigned int, unsigned int> &batches) const
    {
      FEEvaluation<dim, degree, degree + 1, dim, Number, Numbers> u(
        matrix_free);
      for (unsigned int batch = batches.first; batch < batches.second; ++batch)
        {
          u.reinit(batch);
          if constexpr (has_all_values)
            u.read_dof_values_plain(src);
          else
            {
              u.read_dof_values(src);
              centres.bind(is_bound[batch], u.begin_dof_values());
            }
          u.evaluate(EvaluationFlags::gradients);
          set_stresses(batch, u);
          u.integrate(EvaluationFlags::gradients);
          centres.hand_over(is_bound[batch], u.begin_dof_values());
          u.distribute_local_to_global(dst);
        }
    }

    /// The modes of a cell that assumes strains.
    void set_modes(const unsigned int batch,
                   const unsigned int v,
                   const ElasticBody &body)
    {
      if (!body.is_projected && !body.has_incompatible_modes)
        return;
      CellTable<dim> cell;
      cell.material = &body.material;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto [map, weight] = geometry(batch, q);
          cell.JxW.push_back(weight[v]);
          cell.gradient_maps.emplace_back();
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              cell.gradient_maps.back()[i][j] = map[i][j][v];
        }
      if (body.is_projected)
        {
          cell.modes =
            dilatation_modes(dof_handler.get_fe(), quadrature, cell.JxW);
          if (!cell.modes.empty())
            lambda[batch][v] = 0;
        }
      else
        cell.stress_modes = stress_modes(quadrature, cell);
      modes.set(batch, v, cell);
    }

    /// The stress of a strain and of the modes.
    Stress stress(const unsigned int batch,
                  const unsigned int q,
                  const Stress      &strain,
                  const Amplitudes  &amplitudes) const
    {
      Stress        result     = two_mu[batch] * strain;
      const Numbers dilatation = lambda[batch] * trace(strain);
      for (unsigned int d = 0; d < dim; ++d)
        result[d][d] += dilatation;
      modes.add_stress(batch, q, amplitudes, result);
      return result;
    }

    /// Of Green and Lagrange.
    static Stress strain(const Gradient &gradient)
    {
      return symmetrize(gradient +
                        Number(0.5) * transpose(gradient) * gradient);
    }

    /// That of St. Venant and Kirchhoff.
    Stress stress_at(const unsigned int batch,
                     const unsigned int q,
                     const Gradient    &gradient) const
    {
      return stress(batch, q, strain(gradient), amplitudes[batch]);
    }

    /// The stresses of the strains, or changes of the first Piola-Kirchhoff
    /// stress, take the place of the gradients.
    template<class Evaluation>
    void set_stresses(const unsigned int batch, Evaluation &u) const
    {
      if (gradients.empty())
        {
          const Amplitudes of_modes =
            modes.amplitudes(batch, u, [&](const unsigned int q) {
              return u.get_symmetric_gradient(q);
            });
          for (unsigned int q = 0; q < u.n_q_points; ++q)
            u.submit_symmetric_gradient(
              stress(batch, q, u.get_symmetric_gradient(q), of_modes),
              q);
          return;
        }
      const Gradient *before = &gradients[batch * u.n_q_points];
      const auto      F      = [&](const unsigned int q) {
        Gradient result = before[q];
        for (unsigned int d = 0; d < dim; ++d)
          result[d][d] += Number(1);
        return result;
      };
      const auto change_of_strain = [&](const unsigned int q) {
        return symmetrize(transpose(F(q)) * u.get_gradient(q));
      };
      const Amplitudes of_modes = modes.amplitudes(batch, u, change_of_strain);
      for (unsigned int q = 0; q < u.n_q_points; ++q)
        u.submit_gradient(
          F(q) * Gradient(stress(batch, q, change_of_strain(q), of_modes)) +
            u.get_gradient(q) * Gradient(stress_at(batch, q, before[q])),
          q);
    }

    const std::map<types::material_id, ElasticBody> bodies;

    /// The unknowns of a cell by their numbers in FEEvaluation.
    std::vector<unsigned int> cell_numbers;
    CellCentres<dim, Numbers> centres;

    /// By batch of cells.
    AlignedVector<Numbers>  is_bound, lambda, two_mu; // 1 or 0; [MPa]
    CellModes<dim, Numbers> modes;

    /// Of the displacement by point, if there are large ones, and the
    /// amplitudes of the modes.
    AlignedVector<Gradient>   gradients;
    AlignedVector<Amplitudes> amplitudes;
  };
} // namespace Contact

#endif
