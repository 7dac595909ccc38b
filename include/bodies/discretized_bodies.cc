/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "bodies/discretized_bodies.h"

#include <cmath>

namespace Contact
{
  template<int dim>
  DiscretizedBodies<dim>::DiscretizedBodies(
    const DoFHandler<dim>            &dof_handler,
    const AffineConstraints<double>  &constraints,
    const hp::MappingCollection<dim> &mapping,
    const unsigned int                degree,
    const bool                        axisymmetric,
    const MPI_Comm                    communicator)
    : communicator(communicator)
    , degree(degree)
    , axisymmetric(axisymmetric)
    , mapping(mapping)
    , dof_handler(dof_handler)
    , constraints(constraints)
  {
  }



  template<int dim>
  void DiscretizedBodies<dim>::collect_vertex_dofs()
  {
    NodeDoFs<dim> none;
    none.fill(numbers::invalid_dof_index);
    vertex_dofs.assign(dof_handler.get_triangulation().n_vertices(), none);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            vertex_dofs[cell->vertex_index(v)][c] =
              cell->vertex_dof_index(v, c, cell->active_fe_index());
  }



  template<int dim>
  Tensor<1, dim>
  DiscretizedBodies<dim>::free_part(const NodeDoFs<dim>  &node,
                                    const Tensor<1, dim> &vector) const
  {
    Tensor<1, dim> free = vector;
    for (unsigned int c = 0; c < dim; ++c)
      if (is_fixed(node[c]))
        free[c] = 0;
    return free;
  }



  template<int dim>
  bool
  DiscretizedBodies<dim>::are_held_alike(const NodeDoFs<dim>  &a,
                                         const NodeDoFs<dim>  &b,
                                         const Tensor<1, dim> &direction) const
  {
    const double round_off = 1e-8;
    for (unsigned int c = 0; c < dim; ++c)
      if (std::abs(direction[c]) > round_off && !are_fixed_alike(a[c], b[c]))
        return false;
    return true;
  }



  template<int dim>
  void
  DiscretizedBodies<dim>::distribute(const AffineConstraints<double> &lines,
                                     GhostedVector                   &u) const
  {
    for (const auto &line : lines.get_lines())
      if (distribution->in_local_range(line.index))
        {
          double value = line.inhomogeneity;
          for (const auto &[dof, coefficient] : line.entries)
            value += coefficient * u[dof];
          u[line.index] = value;
        }
    u.update_ghosts();
  }

  template class DiscretizedBodies<2>;
  template class DiscretizedBodies<3>;
} // namespace Contact
