/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Debian's deal.II is compiled for processors without vector units of several
// numbers, and hides its vectors for them. Where the compiler is told of a
// processor that has such units, they are let in here, by the name of their
// width: the library's own templates have the width 1 and stay what they are.
#include <deal.II/base/config.h>
#if defined(__AVX512F__)
#  undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512
#elif defined(__AVX__)
#  undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 256
#endif

#ifdef __AVX__
// The two files of templates have the same include guard in deal.II 9.4.
#  define FE_EVAL_FACTORY_DEGREE_MAX 2 // of the elements here
// clang-format off
#  include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#  undef dealii_matrix_free_evaluation_template_factory_templates_h
#  include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
#  include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#  include <deal.II/matrix_free/mapping_info.templates.h>
#  include <deal.II/matrix_free/matrix_free.templates.h>
#  include <deal.II/matrix_free/shape_info.templates.h>
// clang-format on
#endif

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "solvers/multigrid/body_operator.h"

namespace Contact
{
  /// As many numbers as a register has.
  template<typename Number>
  using Wide =
    VectorizedArray<Number,
                    std::max<std::size_t>(1,
                                          DEAL_II_VECTORIZATION_WIDTH_IN_BITS /
                                            (8 * sizeof(Number)))>;

  template<int dim, typename Number>
  class BodyOperator<dim, Number>::Cells
  {
  public:
    using Numbers  = Wide<Number>;
    using Gradient = Tensor<2, dim, Numbers>;
    using Stress   = SymmetricTensor<2, dim, Numbers>;
    using Data     = MatrixFree<dim, Number, Numbers>;

    Cells(const Mapping<dim>                           &mapping,
          const Quadrature<dim>                        &quadrature,
          const DoFHandler<dim>                        &dof_handler,
          const AffineConstraints<Number>              &constraints,
          const std::map<types::material_id, Material> &materials)
      : dof_handler(dof_handler)
      , constraints(constraints)
      , quadrature(quadrature)
      , degree(dof_handler.get_fe().degree)
      , is_tensor_product(dof_handler.get_fe().reference_cell().is_hyper_cube())
    {
      typename Data::AdditionalData data;
      data.tasks_parallel_scheme = Data::AdditionalData::none;
      data.mapping_update_flags  = update_gradients | update_JxW_values;
      matrix_free.reinit(mapping, dof_handler, constraints, quadrature, data);

      lambda.resize(matrix_free.n_cell_batches());
      two_mu.resize(matrix_free.n_cell_batches());
      for_all_cells(
        [&](const unsigned int batch, const unsigned int v, const auto &cell) {
          const Material &material = materials.at(cell->material_id());
          lambda[batch][v]         = material.lambda;
          two_mu[batch][v]         = 2 * material.mu;
        });
    }

    void linearize(const Vector                       &u,
                   const std::set<types::material_id> &small_strain)
    {
      FEEvaluation<dim, -1, 0, dim, Number, Numbers> values(matrix_free);
      const unsigned int                             n = values.n_q_points;
      gradients.resize(matrix_free.n_cell_batches() * n);
      u.update_ghost_values();
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          values.reinit(batch);
          values.read_dof_values_plain(u);
          values.evaluate(EvaluationFlags::gradients);
          for (unsigned int q = 0; q < n; ++q)
            gradients[batch * n + q] = values.get_gradient(q);
        }
      u.zero_out_ghost_values();
      for_all_cells(
        [&](const unsigned int batch, const unsigned int v, const auto &cell) {
          if (small_strain.count(cell->material_id()) > 0)
            for (unsigned int q = 0; q < n; ++q)
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  gradients[batch * n + q][i][j][v] = 0;
        });
    }

    void vmult(Vector &dst, const Vector &src) const
    {
      if (!is_tensor_product)
        loop(&Cells::template multiply<-1, false>, dst, src);
      else if (degree == 1)
        loop(&Cells::template multiply<1, false>, dst, src);
      else
        loop(&Cells::template multiply<2, false>, dst, src);
    }

    void forces(Vector &dst, const Vector &u) const
    {
      AssertThrow(gradients.empty(), ExcInternalError());
      if (!is_tensor_product)
        loop(&Cells::template multiply<-1, true>, dst, u);
      else if (degree == 1)
        loop(&Cells::template multiply<1, true>, dst, u);
      else
        loop(&Cells::template multiply<2, true>, dst, u);
    }

    // With f the row of F of the direction i, in small strain the unit vector:
    // mu (|f|^2 |grad N|^2 + (f . grad N)^2) + lambda (f . grad N)^2, and what
    // the stress adds, grad N . S grad N.
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

      const auto            &map = matrix_free.get_mapping_info().cell_data[0];
      AlignedVector<Numbers> local(fe.n_dofs_per_cell());
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          const unsigned int place = map.data_index_offsets[batch];
          const bool         is_affine =
            matrix_free.get_mapping_info().get_cell_type(batch) <=
            internal::MatrixFreeFunctions::affine;
          local.fill(Numbers());
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const unsigned int at      = place + (is_affine ? 0 : q);
              const auto        &inverse = map.jacobians[0][at];
              const Numbers      weight =
                map.JxW_values[at] *
                Number(is_affine ? quadrature.weight(q) : 1.);
              const Numbers mu  = Number(0.5) * weight * two_mu[batch];
              const Numbers sum = mu + weight * lambda[batch];
              Gradient      F   = unit_symmetric_tensor<dim, Numbers>();
              Stress        S;
              if (!gradients.empty())
                {
                  const Gradient &gradient =
                    gradients[batch * quadrature.size() + q];
                  F += gradient;
                  S = stress_at(batch, gradient) * weight;
                }
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  Tensor<1, dim, Numbers> g;
                  for (unsigned int i = 0; i < dim; ++i)
                    for (unsigned int j = 0; j < dim; ++j)
                      g[i] += inverse[i][j] * Number(unit[q][a][j]);
                  const Numbers by_mu     = mu * (g * g);
                  const Numbers by_stress = g * (S * g);
                  for (unsigned int i = 0; i < dim; ++i)
                    {
                      const Numbers along = F[i] * g;
                      local[unknowns[a][i]] +=
                        by_mu * (F[i] * F[i]) + sum * along * along + by_stress;
                    }
                }
            }
          for (unsigned int v = 0;
               v < matrix_free.n_active_entries_per_cell_batch(batch);
               ++v)
            {
              matrix_free.get_cell_iterator(batch, v)->get_dof_indices(dofs);
              for (unsigned int i = 0; i < dofs.size(); ++i)
                if (!constraints.is_constrained(dofs[i]))
                  result(dofs[i]) += local[i][v];
                else
                  for (const auto &[dof, factor] :
                       *constraints.get_constraint_entries(dofs[i]))
                    result(dof) += factor * factor * local[i][v];
            }
        }
      result.compress(VectorOperation::add);
      return result;
    }

    const DoFHandler<dim>           &dof_handler;
    const AffineConstraints<Number> &constraints;
    const Quadrature<dim>            quadrature;
    const unsigned int               degree;
    const bool                       is_tensor_product;
    Data                             matrix_free;

  private:
    template<class Visitor>
    void for_all_cells(const Visitor &visit) const
    {
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        for (unsigned int v = 0;
             v < matrix_free.n_active_entries_per_cell_batch(batch);
             ++v)
          visit(batch, v, matrix_free.get_cell_iterator(batch, v));
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
            u.read_dof_values(src);
          u.evaluate(EvaluationFlags::gradients);
          if (gradients.empty())
            for (unsigned int q = 0; q < u.n_q_points; ++q)
              u.submit_symmetric_gradient(stress(batch,
                                                 u.get_symmetric_gradient(q)),
                                          q);
          else
            for (unsigned int q = 0; q < u.n_q_points; ++q)
              u.submit_gradient(
                change_of_stress(batch,
                                 gradients[batch * u.n_q_points + q],
                                 u.get_gradient(q)),
                q);
          u.integrate_scatter(EvaluationFlags::gradients, dst);
        }
    }

    Stress stress(const unsigned int batch, const Stress &strain) const
    {
      Stress        result     = two_mu[batch] * strain;
      const Numbers dilatation = lambda[batch] * trace(strain);
      for (unsigned int d = 0; d < dim; ++d)
        result[d][d] += dilatation;
      return result;
    }

    /// That of St. Venant and Kirchhoff.
    Stress stress_at(const unsigned int batch, const Gradient &gradient) const
    {
      return stress(batch,
                    symmetrize(gradient +
                               Number(0.5) * transpose(gradient) * gradient));
    }

    Gradient change_of_stress(const unsigned int batch,
                              const Gradient    &gradient,
                              const Gradient    &change) const
    {
      Gradient F = gradient;
      for (unsigned int d = 0; d < dim; ++d)
        F[d][d] += Number(1);
      return F * Gradient(stress(batch, symmetrize(transpose(F) * change))) +
             change * Gradient(stress_at(batch, gradient));
    }

    /// By batch of cells.
    AlignedVector<Numbers> lambda, two_mu;

    /// Of the displacement by point, if there are large ones.
    AlignedVector<Gradient> gradients;
  };



  template<int dim, typename Number>
  BodyOperator<dim, Number>::BodyOperator(
    const Mapping<dim>                           &mapping,
    const Quadrature<dim>                        &quadrature,
    const DoFHandler<dim>                        &dof_handler,
    const AffineConstraints<Number>              &constraints,
    const std::map<types::material_id, Material> &materials)
    : cells(std::make_unique<Cells>(mapping,
                                    quadrature,
                                    dof_handler,
                                    constraints,
                                    materials))
    , partitioner(cells->matrix_free.get_vector_partitioner())
  {
  }

  template<int dim, typename Number>
  BodyOperator<dim, Number>::~BodyOperator() = default;

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::linearize(
    const Vector                       &u,
    const std::set<types::material_id> &small_strain)
  {
    cells->linearize(u, small_strain);
  }

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::vmult(Vector &dst, const Vector &src) const
  {
    cells->vmult(dst, src);
  }

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::forces(Vector &dst, const Vector &u) const
  {
    cells->forces(dst, u);
  }

  template<int dim, typename Number>
  typename BodyOperator<dim, Number>::Vector
  BodyOperator<dim, Number>::diagonal() const
  {
    return cells->diagonal();
  }

  template<int dim, typename Number>
  std::size_t BodyOperator<dim, Number>::memory() const
  {
    return cells->matrix_free.memory_consumption();
  }


  template class BodyOperator<2, double>;
  template class BodyOperator<3, double>;
  template class BodyOperator<2, float>;
  template class BodyOperator<3, float>;
} // namespace Contact
