/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Debian's deal.II is compiled for processors without vector units of several
// numbers, and hides its vectors for them. Here they are let in, by the name of
// their width: the library's own templates have the width 1 and stay what they
// are. The compiler has to be told of a processor that has such units.
#include <deal.II/base/config.h>
#undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#if defined(__AVX512F__)
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512
#elif defined(__AVX__)
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 256
#else
#  define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 0
#endif

// The two files of templates have the same include guard in deal.II 9.4.
#define FE_EVAL_FACTORY_DEGREE_MAX 2 // of the elements here
// clang-format off
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#undef dealii_matrix_free_evaluation_template_factory_templates_h
#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
// clang-format on

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>

#include <algorithm>

#include "solvers/body_operator.h"

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
    Cells(const Mapping<dim>                           &mapping,
          const DoFHandler<dim>                        &dof_handler,
          const AffineConstraints<Number>              &constraints,
          const std::map<types::material_id, Material> &materials)
      : dof_handler(dof_handler)
      , constraints(constraints)
      , degree(dof_handler.get_fe().degree)
    {
      typename MatrixFree<dim, Number, Wide<Number>>::AdditionalData data;
      data.tasks_parallel_scheme = MatrixFree<dim, Number, Wide<Number>>::
        AdditionalData::TasksParallelScheme::none;
      data.mapping_update_flags = update_gradients | update_JxW_values;
      matrix_free.reinit(mapping,
                         dof_handler,
                         constraints,
                         QGauss<1>(degree + 1),
                         data);

      lambda.resize(matrix_free.n_cell_batches());
      two_mu.resize(matrix_free.n_cell_batches());
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        for (unsigned int v = 0;
             v < matrix_free.n_active_entries_per_cell_batch(batch);
             ++v)
          {
            const Material &material = materials.at(
              matrix_free.get_cell_iterator(batch, v)->material_id());
            lambda[batch][v] = material.lambda;
            two_mu[batch][v] = 2 * material.mu;
          }
    }

    void vmult(Vector &dst, const Vector &src) const
    {
      if (degree == 1)
        matrix_free.cell_loop(&Cells::template multiply_cells<1>,
                              this,
                              dst,
                              src,
                              /*zero_dst_vector=*/true);
      else
        matrix_free.cell_loop(&Cells::template multiply_cells<2>,
                              this,
                              dst,
                              src,
                              /*zero_dst_vector=*/true);
    }



    template<int degree>
    void
    multiply_cells(const MatrixFree<dim, Number, Wide<Number>> &,
                   Vector                                      &dst,
                   const Vector                                &src,
                   const std::pair<unsigned int, unsigned int> &cells) const
    {
      FEEvaluation<dim, degree, degree + 1, dim, Number, Wide<Number>> u(
        matrix_free);
      for (unsigned int cell = cells.first; cell < cells.second; ++cell)
        {
          u.reinit(cell);
          u.gather_evaluate(src, EvaluationFlags::gradients);
          for (unsigned int q = 0; q < u.n_q_points; ++q)
            {
              const auto strain     = u.get_symmetric_gradient(q);
              auto       stress     = two_mu[cell] * strain;
              const auto dilatation = lambda[cell] * trace(strain);
              for (unsigned int d = 0; d < dim; ++d)
                stress[d][d] += dilatation;
              u.submit_symmetric_gradient(stress, q);
            }
          u.integrate_scatter(EvaluationFlags::gradients, dst);
        }
    }



    // mu (|grad N|^2 + (d_i N)^2) + lambda (d_i N)^2 in the direction i.
    Vector diagonal() const
    {
      Vector result;
      matrix_free.initialize_dof_vector(result);
      const FiniteElement<dim> &fe = dof_handler.get_fe();
      const QGauss<dim>         quadrature(degree + 1);
      const unsigned int        n_nodes = fe.n_dofs_per_cell() / dim;

      // Unit gradients of the nodes, and the place of their unknowns.
      std::vector<std::array<unsigned int, dim>> unknowns(n_nodes);
      std::vector<unsigned int>                  node(dim, 0);
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

      const auto &map = matrix_free.get_mapping_info().cell_data[0];
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      dealii::Vector<Number>               local(fe.n_dofs_per_cell());
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          const unsigned int place = map.data_index_offsets[batch];
          const bool         is_affine =
            matrix_free.get_mapping_info().get_cell_type(batch) <=
            internal::MatrixFreeFunctions::affine;
          for (unsigned int v = 0;
               v < matrix_free.n_active_entries_per_cell_batch(batch);
               ++v)
            {
              matrix_free.get_cell_iterator(batch, v)->get_dof_indices(dofs);
              local = 0;
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  const unsigned int at      = place + (is_affine ? 0 : q);
                  const auto        &inverse = map.jacobians[0][at];
                  const Number       weight  = map.JxW_values[at][v] *
                                        (is_affine ? quadrature.weight(q) : 1.);
                  const Number mu  = 0.5 * weight * two_mu[batch][v];
                  const Number sum = mu + weight * lambda[batch][v];
                  for (unsigned int a = 0; a < n_nodes; ++a)
                    {
                      std::array<Number, dim> squares;
                      Number                  all = 0;
                      for (unsigned int i = 0; i < dim; ++i)
                        {
                          Number derivative = 0;
                          for (unsigned int j = 0; j < dim; ++j)
                            derivative += inverse[i][j][v] * unit[q][a][j];
                          squares[i] = derivative * derivative;
                          all += squares[i];
                        }
                      for (unsigned int i = 0; i < dim; ++i)
                        local[unknowns[a][i]] += mu * all + sum * squares[i];
                    }
                }
              for (unsigned int i = 0; i < dofs.size(); ++i)
                if (!constraints.is_constrained(dofs[i]))
                  result(dofs[i]) += local[i];
                else
                  for (const auto &[dof, factor] :
                       *constraints.get_constraint_entries(dofs[i]))
                    result(dof) += factor * factor * local[i];
            }
        }
      result.compress(VectorOperation::add);
      return result;
    }

    const DoFHandler<dim>                &dof_handler;
    const AffineConstraints<Number>      &constraints;
    const unsigned int                    degree;
    MatrixFree<dim, Number, Wide<Number>> matrix_free;

  private:
    /// By batch of cells.
    AlignedVector<Wide<Number>> lambda, two_mu;
  };



  template<int dim, typename Number>
  BodyOperator<dim, Number>::BodyOperator(
    const Mapping<dim>                           &mapping,
    const DoFHandler<dim>                        &dof_handler,
    const AffineConstraints<Number>              &constraints,
    const std::map<types::material_id, Material> &materials)
    : cells(
        std::make_unique<Cells>(mapping, dof_handler, constraints, materials))
    , partitioner(cells->matrix_free.get_vector_partitioner())
  {
  }

  template<int dim, typename Number>
  BodyOperator<dim, Number>::~BodyOperator() = default;

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::vmult(Vector &dst, const Vector &src) const
  {
    cells->vmult(dst, src);
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
