/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/profile_rows.h"

#include <deal.II/base/mpi.h>

#include <map>

namespace Contact
{
  namespace
  {
    /// Values between the corners of a facet are the mean of those there.
    template<int dim, typename T>
    void fill_middles(const SurfaceFacet<dim> &facet, std::vector<T> &values)
    {
      for (unsigned int a = facet.kind->n_vertices; a < facet.n_nodes(); ++a)
        {
          const auto &vertices = facet.kind->vertices_of_node[a];
          T           sum{};
          for (const unsigned int v : vertices)
            sum += values[facet.nodes[v]];
          values[facet.nodes[a]] = 1. / vertices.size() * sum;
        }
    }



    std::vector<double> arc_lengths(const Surface<2>            &surface,
                                    const std::vector<Point<2>> &x)
    {
      return surface.arc_length(x);
    }

    /// Surfaces in 3-D have none.
    std::vector<double> arc_lengths(const Surface<3> &,
                                    const std::vector<Point<3>> &x)
    {
      return std::vector<double>(x.size());
    }



    /// The recovered stress at the nodes of a surface, with several ranks from
    /// those that know the vertices.
    template<int dim>
    std::vector<SymmetricTensor<2, 3>>
    node_stresses(const Surface<dim>                       &surface,
                  const Discretization<dim>                &discretization,
                  const std::vector<SymmetricTensor<2, 3>> &vertex_stresses)
    {
      std::map<types::global_dof_index, unsigned int> vertex_of_dof;
      for (unsigned int v = 0; v < discretization.vertex_dofs.size(); ++v)
        vertex_of_dof.emplace(discretization.vertex_dofs[v][0], v);

      // The components by node, and how many ranks know them.
      const unsigned int  n = SymmetricTensor<2, 3>::n_independent_components;
      std::vector<double> sums((n + 1) * surface.nodes.size());
      const auto &owned = discretization.dof_handler.locally_owned_dofs();
      for (unsigned int node = 0; node < surface.nodes.size(); ++node)
        {
          const auto dof    = surface.nodes[node].dofs[0];
          const auto vertex = vertex_of_dof.find(dof);
          if (vertex == vertex_of_dof.end() || !owned.is_element(dof))
            continue;
          for (unsigned int i = 0; i < n; ++i)
            sums[(n + 1) * node + i] =
              vertex_stresses[vertex->second].access_raw_entry(i);
          sums[(n + 1) * node + n] = 1;
        }
      Utilities::MPI::sum(sums, discretization.communicator, sums);

      std::vector<SymmetricTensor<2, 3>> stresses(surface.nodes.size());
      for (unsigned int node = 0; node < stresses.size(); ++node)
        for (unsigned int i = 0; i < n; ++i)
          stresses[node].access_raw_entry(i) = sums[(n + 1) * node + i];

      // The recovered stress is linear along an edge.
      if (surface.degree == 2)
        for (const SurfaceFacet<dim> &facet : surface.facets)
          fill_middles(facet, stresses);
      return stresses;
    }
  } // namespace



  template<int dim>
  std::vector<ProfileRow<dim>>
  make_rows(const Surface<dim>                       &surface,
            const Discretization<dim>                &discretization,
            const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
            const GhostedVector                      &u)
  {
    const auto stresses =
      node_stresses(surface, discretization, vertex_stresses);
    const DeformedSurface<dim> now(surface, u);
    const auto                 normals    = now.normals();
    const auto                &deformed   = now.positions;
    const auto                 reference  = surface.positions({});
    const auto                 arc_length = arc_lengths(surface, reference);
    const auto deformed_arc_length        = arc_lengths(surface, deformed);

    std::vector<ProfileRow<dim>> rows(surface.nodes.size());
    for (unsigned int n = 0; n < rows.size(); ++n)
      {
        rows[n].arc_length          = arc_length[n];
        rows[n].deformed_arc_length = deformed_arc_length[n];
        rows[n].X                   = reference[n];
        rows[n].u                   = deformed[n] - reference[n];
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            rows[n].extrapolated_pressure -=
              normals[n][i] * stresses[n][i][j] * normals[n][j];
      }
    return rows;
  }

  template std::vector<ProfileRow<2>>
  make_rows(const Surface<2>                         &surface,
            const Discretization<2>                  &discretization,
            const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
            const GhostedVector                      &u);
  template std::vector<ProfileRow<3>>
  make_rows(const Surface<3>                         &surface,
            const Discretization<3>                  &discretization,
            const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
            const GhostedVector                      &u);
} // namespace Contact
