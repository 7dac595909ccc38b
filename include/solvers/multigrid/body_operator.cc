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

#include "solvers/multigrid/body_cells.h"
#include "solvers/multigrid/body_operator.h"

namespace Contact
{
  template<int dim, typename Number>
  BodyOperator<dim, Number>::BodyOperator(
    const Mapping<dim>                              &mapping,
    const Quadrature<dim>                           &quadrature,
    const DoFHandler<dim>                           &dof_handler,
    const CentreBinding<dim, Number>                &centres,
    const std::map<types::material_id, ElasticBody> &bodies)
    : cells(std::make_unique<Cells>(mapping,
                                    quadrature,
                                    dof_handler,
                                    centres,
                                    bodies))
    , partitioner(cells->matrix_free.get_vector_partitioner())
  {
  }

  template<int dim, typename Number>
  BodyOperator<dim, Number>::~BodyOperator() = default;

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::linearize(const Vector &u)
  {
    cells->linearize(u);
  }

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::vmult(Vector &dst, const Vector &src) const
  {
    cells->template apply<false>(dst, src);
  }

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::forces(Vector &dst, const Vector &u) const
  {
    AssertThrow(cells->is_linear(), ExcInternalError());
    cells->template apply<true>(dst, u);
  }

  template<int dim, typename Number>
  typename BodyOperator<dim, Number>::Vector
  BodyOperator<dim, Number>::diagonal() const
  {
    return cells->diagonal();
  }

  template<int dim, typename Number>
  void BodyOperator<dim, Number>::visit_tangents(
    const std::function<void(const FullMatrix<double> &tangent,
                             const std::vector<types::global_dof_index> &dofs)>
      &visitor) const
  {
    cells->visit_tangents(visitor);
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
