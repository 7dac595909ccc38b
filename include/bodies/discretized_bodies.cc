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

  template<int dim>
  std::vector<NodeDoFs<dim>>
  nodes_on(const DoFHandler<dim>              &dof_handler,
           const std::set<types::boundary_id> &boundary)
  {
    std::vector<NodeDoFs<dim>>           nodes, of_face;
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && boundary.count(face->boundary_id()) > 0)
            {
              const auto &fe = cell->get_fe();
              dofs.resize(fe.n_dofs_per_face());
              face->get_dof_indices(dofs, cell->active_fe_index());
              of_face.resize(dofs.size() / dim);
              for (unsigned int i = 0; i < dofs.size(); ++i)
                {
                  const auto [c, a] = fe.face_system_to_component_index(i);
                  of_face[a][c]     = dofs[i];
                }
              nodes.insert(nodes.end(), of_face.begin(), of_face.end());
            }
    return nodes;
  }



  template class DiscretizedBodies<2>;
  template class DiscretizedBodies<3>;
  template std::vector<NodeDoFs<2>>
  nodes_on<2>(const DoFHandler<2> &, const std::set<types::boundary_id> &);
  template std::vector<NodeDoFs<3>>
  nodes_on<3>(const DoFHandler<3> &, const std::set<types::boundary_id> &);
} // namespace Contact
