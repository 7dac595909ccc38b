/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/followers.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/tria.h>

#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  namespace
  {
    /// Add nodes in a row as leaders with the same factor.
    void add_leaders(const unsigned int first,
                     const unsigned int n,
                     const double       factor,
                     BoundNode         &bound)
    {
      for (unsigned int node = first; node < first + n; ++node)
        bound.leaders.emplace_back(node, factor);
    }



    // FE_Q(2) numbers the corners, the mid-sides, in 3-D the centres of faces,
    // and the centre. Leaders are in this order.
    template<int dim>
    std::vector<BoundNode> make_bound_nodes()
    {
      const unsigned int n_corners = GeometryInfo<dim>::vertices_per_cell,
                         n_sides   = GeometryInfo<dim>::lines_per_cell;
      std::vector<BoundNode> bound;
      if constexpr (dim == 3)
        for (const unsigned int f : GeometryInfo<3>::face_indices())
          {
            BoundNode centre{n_corners + n_sides + f, {}};
            for (unsigned int v = 0; v < 4; ++v)
              add_leaders(GeometryInfo<3>::face_to_cell_vertices(f, v),
                          1,
                          -0.25,
                          centre);
            for (unsigned int l = 0; l < 4; ++l)
              add_leaders(n_corners + GeometryInfo<3>::face_to_cell_lines(f, l),
                          1,
                          0.5,
                          centre);
            bound.push_back(centre);
          }
      BoundNode centre{static_cast<unsigned int>(n_corners + n_sides +
                                                 bound.size()),
                       {}};
      add_leaders(0, n_corners, -0.25, centre);
      add_leaders(n_corners, n_sides, dim == 2 ? 0.5 : 0.25, centre);
      bound.push_back(centre);
      return bound;
    }



    // The centre of a cell follows a free centre of a face by half, as in the
    // transfinite interpolation of the six faces: so a layer of cells has the
    // displacements of the 8-node element in 2-D.
    void free_centre_of_face(const unsigned int      face,
                             std::vector<BoundNode> &bound)
    {
      auto &of_cell = bound.back().leaders;
      for (const auto &[node, factor] : bound[face].leaders)
        of_cell[node].second -= factor / 2;
      of_cell.emplace_back(bound[face].node, 0.5);
      bound.erase(bound.begin() + face);
    }
  } // namespace



  template<int dim>
  const std::vector<BoundNode> &bound_nodes_of_element()
  {
    static const std::vector<BoundNode> nodes = make_bound_nodes<dim>();
    return nodes;
  }



  template<int dim>
  std::vector<BoundNode>
  bound_nodes(const Discretization<dim> &discretization,
              const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    if (!discretization.serendipity || !cell->reference_cell().is_hyper_cube())
      return {};
    std::vector<BoundNode> bound = bound_nodes_of_element<dim>();
    if (dim == 3 && cell->at_boundary())
      for (unsigned int f = 6; f-- > 0;)
        if (cell->face(f)->at_boundary() &&
            discretization.free_centres.count(cell->face(f)->boundary_id()) > 0)
          free_centre_of_face(f, bound);
    return bound;
  }



  template<int dim, typename Number>
  void bind_centres(const Discretization<dim> &discretization,
                    const DoFHandler<dim>     &dof_handler,
                    AffineConstraints<Number> &constraints,
                    const std::vector<bool>   &left_out)
  {
    if (!discretization.serendipity)
      return;
    std::vector<types::global_dof_index>                    dofs;
    std::vector<std::pair<types::global_dof_index, Number>> leaders;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() &&
          (left_out.empty() || !left_out[cell->active_cell_index()]))
        {
          const std::vector<BoundNode> bound =
            bound_nodes(discretization, cell);
          dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          for (unsigned int c = 0; c < dim; ++c)
            {
              const auto dof = [&](const unsigned int node) {
                return dofs[cell->get_fe().component_to_system_index(c, node)];
              };
              for (const BoundNode &follower : bound)
                {
                  // Of a face in common with a cell before: it is bound.
                  const auto index = dof(follower.node);
                  if (constraints.is_constrained(index))
                    continue;
                  leaders.clear();
                  for (const auto &[node, factor] : follower.leaders)
                    leaders.emplace_back(dof(node), factor);
                  constraints.add_line(index);
                  constraints.add_entries(index, leaders);
                }
            }
        }
  }



  template<int dim>
  AffineConstraints<double>
  make_followers(const Discretization<dim> &discretization)
  {
    AffineConstraints<double> constraints;
    if (discretization.mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                              constraints);
    for (const auto &[dof, leader] : discretization.tied())
      {
        constraints.add_line(dof);
        constraints.add_entry(dof, leader, 1.);
      }
    bind_centres(discretization, discretization.dof_handler, constraints);
    constraints.close();
    return constraints;
  }



  template<int dim>
  void hand_over_from_followers(const Discretization<dim> &discretization,
                                GhostedVector             &forces)
  {
    const auto &constraints = discretization.followers();
    if (Utilities::MPI::max(constraints.n_constraints(),
                            discretization.communicator) == 0)
      return;
    GhostedVector handed_over(discretization.distribution);
    for (const auto &line : constraints.get_lines())
      if (discretization.dof_handler.locally_owned_dofs().is_element(
            line.index))
        {
          handed_over[line.index] -= forces[line.index];
          for (const auto &[other, coefficient] : line.entries)
            handed_over[other] += coefficient * forces[line.index];
        }
    handed_over.compress_add();
    forces += handed_over;
  }



#define INSTANTIATE(dim)                                                       \
  template const std::vector<BoundNode> &bound_nodes_of_element<dim>();        \
  template std::vector<BoundNode>        bound_nodes(                          \
           const Discretization<dim> &,                                        \
           const DoFHandler<dim>::active_cell_iterator &);                     \
  template void                      bind_centres(const Discretization<dim> &, \
                                                  const DoFHandler<dim> &,     \
                                                  AffineConstraints<double> &, \
                                                  const std::vector<bool> &);  \
  template void                      bind_centres(const Discretization<dim> &, \
                                                  const DoFHandler<dim> &,     \
                                                  AffineConstraints<float> &,  \
                                                  const std::vector<bool> &);  \
  template AffineConstraints<double> make_followers(                           \
    const Discretization<dim> &);                                              \
  template void hand_over_from_followers(const Discretization<dim> &,          \
                                         GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
