/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/loose_facets.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/face_middle.h"

namespace Contact
{
  namespace
  {
    /// Of each cell of the coarse mesh, which every rank has, the connected
    /// part of the mesh that it belongs to: a cell number that all of it share.
    template<int dim>
    std::vector<unsigned int> connected_parts(const Triangulation<dim> &mesh)
    {
      std::vector<unsigned int> root(mesh.n_cells(0));
      std::iota(root.begin(), root.end(), 0);
      const auto find = [&](unsigned int c) {
        while (root[c] != c)
          c = root[c] = root[root[c]];
        return c;
      };

      std::map<unsigned int, unsigned int> cell_of_vertex;
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          {
            const unsigned int own = cell->index();
            const auto         other =
              cell_of_vertex.emplace(cell->vertex_index(v), own).first->second;
            root[find(own)] = find(other);
          }
      for (unsigned int c = 0; c < root.size(); ++c)
        root[c] = find(c);
      return root;
    }



    /// The coordinates of a facet go round the outward normal.
    void
    orient(LooseFacet<2> &edge, const unsigned int, const Tensor<1, 2> &inward)
    {
      const Tensor<1, 2> along = edge.nodes[1].X - edge.nodes[0].X;
      if (along[0] * inward[1] - along[1] * inward[0] < 0)
        std::swap(edge.nodes[0], edge.nodes[1]);
    }



    void orient(LooseFacet<3>      &facet,
                const unsigned int  degree,
                const Tensor<1, 3> &inward)
    {
      const FacetKind<3>       &kind = facet_kind<3>(facet.n_vertices, degree);
      const auto                from = facet.nodes;
      PerFacetNode<3, Point<3>> X;
      for (unsigned int a = 0; a < kind.n_nodes; ++a)
        X[a] = from[a].X;
      if (facet_normal<3>(kind, X, kind.middle) * inward >= 0)
        for (unsigned int a = 0; a < kind.n_nodes; ++a)
          facet.nodes[a] = from[kind.reversed[a]];
    }



    /// Let the hanging nodes of a facet follow others. A node in the middle of
    /// a larger side of degree 2 is the node that the larger facet has there.
    template<int dim>
    void find_leaders(const AffineConstraints<double> &hanging,
                      const unsigned int               degree,
                      LooseFacet<dim>                 &facet)
    {
      for (unsigned int a = 0, n = facet.n_nodes(degree); a < n; ++a)
        {
          auto       &dofs    = facet.nodes[a].dofs;
          const auto *entries = hanging.get_constraint_entries(dofs[0]);
          if (entries == nullptr)
            continue;
          if (entries->size() > 1)
            facet.parents[a] = *entries;
          else
            for (auto &dof : dofs)
              dof = hanging.get_constraint_entries(dof)->front().first;
        }
    }



    /// A face of a cell at the boundary, its part left open. The unknowns of a
    /// face come in the order of its own vertices, then the middles of its
    /// sides, and its centre.
    template<int dim>
    LooseFacet<dim>
    make_loose_facet(const DiscretizedBodies<dim> &discretization,
                     const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const unsigned int                                    f)
    {
      const auto                           face  = cell->face(f);
      const unsigned int                   index = cell->active_fe_index();
      const auto                          &fe    = cell->get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face(f));
      std::vector<types::global_dof_index> of_cell(fe.n_dofs_per_cell());
      face->get_dof_indices(dofs, index);
      cell->get_dof_indices(of_cell);

      LooseFacet<dim> facet;
      facet.body        = cell->material_id();
      facet.piece       = discretization.piece(cell);
      facet.level       = cell->level();
      facet.coarse_cell = cell->id().get_coarse_cell_id();
      facet.n_vertices  = face->n_vertices();
      // Round sides do not make a flat face round.
      facet.middle = face->manifold_id() == numbers::flat_manifold_id
                       ? face->center()
                       : middle_of_face(face);
      facet.name   = facet_name(discretization, face);
      for (unsigned int k = 0; k < dofs.size(); ++k)
        {
          const auto [c, a]      = fe.face_system_to_component_index(k, f);
          facet.nodes[a].dofs[c] = dofs[k];
          if (c > 0)
            continue;
          const unsigned int in_cell =
            std::find(of_cell.begin(), of_cell.end(), dofs[k]) -
            of_cell.begin();
          facet.nodes[a].X =
            a < face->n_vertices()
              ? face->vertex(a)
              : discretization.mapping[index].transform_unit_to_real_cell(
                  cell,
                  fe.base_element(0).unit_support_point(
                    fe.system_to_component_index(in_cell).second));
        }
      orient(facet, discretization.degree, cell->center() - face->center());
      return facet;
    }
  } // namespace



  template<int dim>
  std::vector<LooseFacet<dim>>
  loose_facets(const DiscretizedBodies<dim>       &discretization,
               const std::set<types::boundary_id> &boundary_ids,
               const std::optional<unsigned int>   part)
  {
    const auto parts =
      connected_parts(discretization.dof_handler.get_triangulation());
    AffineConstraints<double> hanging;
    if (dim == 3 &&
        discretization.dof_handler.get_triangulation().has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                              hanging);
    hanging.close();
    std::vector<LooseFacet<dim>> own;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned() || !cell->at_boundary())
          continue;
        const unsigned int of_cell = parts[cell->id().get_coarse_cell_id()];
        if (part && of_cell != *part)
          continue;
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) &&
              boundary_ids.count(cell->face(f)->boundary_id()) > 0)
            {
              own.push_back(make_loose_facet<dim>(discretization, cell, f));
              find_leaders(hanging, discretization.degree, own.back());
              own.back().part = of_cell;
            }
      }
    return own;
  }

  template std::vector<LooseFacet<2>>
  loose_facets(const DiscretizedBodies<2> &,
               const std::set<types::boundary_id> &,
               const std::optional<unsigned int>);
  template std::vector<LooseFacet<3>>
  loose_facets(const DiscretizedBodies<3> &,
               const std::set<types::boundary_id> &,
               const std::optional<unsigned int>);
} // namespace Contact
