/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/surface.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <boost/serialization/utility.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "base/dimension.h"
#include "base/errors.h"

namespace Contact
{
  namespace
  {
    /// A facet with its own nodes, as the ranks exchange it.
    template<int dim>
    struct LooseFacet
    {
      PerFacetNode<dim, SurfaceNode<dim>> nodes;
      types::material_id                  body;
      unsigned int                        part;
      Point<dim>                          middle;
      unsigned int                        level;
      FacetName<dim>                      name;

      /// The first unknowns of the nodes that a hanging one follows, and by how
      /// much.
      PerFacetNode<dim, std::vector<std::pair<types::global_dof_index, double>>>
        parents;

      template<class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        for (SurfaceNode<dim> &node : nodes)
          {
            for (auto &dof : node.dofs)
              archive &dof;
            archive &node.X;
          }
        archive &body &part &middle &level;
        for (auto &dof : name)
          archive &dof;
        for (auto &of_node : parents)
          archive &of_node;
      }
    };



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



    /// The cell of the coarse mesh that a cell is a part of.
    template<typename Cell>
    unsigned int coarse_cell(Cell cell)
    {
      while (cell->level() > 0)
        cell = cell->parent();
      return cell->index();
    }



    /// The coordinates of a facet go round the outward normal.
    void orient(LooseFacet<2> &edge, const Tensor<1, 2> &inward)
    {
      const Tensor<1, 2> along = edge.nodes[1].X - edge.nodes[0].X;
      if (along[0] * inward[1] - along[1] * inward[0] < 0)
        std::swap(edge.nodes[0], edge.nodes[1]);
    }



    // Exchanged coordinates exchange two corners, and the middles of the sides.
    void orient(LooseFacet<3> &facet, const Tensor<1, 3> &inward)
    {
      auto              &nodes = facet.nodes;
      const Tensor<1, 3> outward =
        cross_product_3d(nodes[3].X - nodes[0].X, nodes[2].X - nodes[1].X);
      if (outward * inward < 0)
        return;
      std::swap(nodes[1], nodes[2]);
      std::swap(nodes[4], nodes[6]);
      std::swap(nodes[5], nodes[7]);
    }



    /// Let the hanging nodes of a facet follow others. A node in the middle of
    /// a larger side of degree 2 is the node that the larger facet has there.
    template<int dim>
    void find_leaders(const AffineConstraints<double> &hanging,
                      LooseFacet<dim>                 &facet)
    {
      for (unsigned int a = 0; a < facet.nodes.size(); ++a)
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
    make_loose_facet(const Discretization<dim> &discretization,
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
      facet.body  = cell->material_id();
      facet.level = cell->level();
      // Round sides do not make a flat face round.
      facet.middle = face->center(
        /*respect_manifold=*/face->manifold_id() != numbers::flat_manifold_id);
      facet.name = facet_name(discretization, face);
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
      orient(facet, cell->center() - face->center());
      return facet;
    }
  } // namespace



  template<int dim>
  Surface<dim>::Surface(const Discretization<dim>          &discretization,
                        const std::set<types::boundary_id> &boundary_ids,
                        const std::string                  &name,
                        const SurfaceCut                    cut)
    : degree(discretization.degree)
    , discretization(discretization)
  {
    collect_facets(boundary_ids);
    if (facets.empty())
      throw InputError("the surface '" + name + "' has no " +
                         Dimension<dim>::facet,
                       "Contact",
                       std::string("name a boundary group of the mesh that ") +
                         "has " + Dimension<dim>::boundary + "s");
    arrange();
    if (cut == SurfaceCut::into_sides)
      cut_into_sides();
    find_parted();
  }



  // Every rank collects the facets of its own cells; put together, all have the
  // whole surface.
  template<int dim>
  void
  Surface<dim>::collect_facets(const std::set<types::boundary_id> &boundary_ids)
  {
    const auto parts = connected_parts(discretization.mesh.triangulation);
    AffineConstraints<double> hanging;
    if (dim == 3 && discretization.mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(discretization.dof_handler,
                                              hanging);
    hanging.close();
    std::vector<LooseFacet<dim>> own;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          const auto face = cell->face(f);
          if (!cell->is_locally_owned() || !face->at_boundary() ||
              boundary_ids.count(face->boundary_id()) == 0)
            continue;

          own.push_back(make_loose_facet<dim>(discretization, cell, f));
          find_leaders(hanging, own.back());
          own.back().part =
            parts[coarse_cell<typename Triangulation<dim>::cell_iterator>(
              cell)];
        }

    std::map<types::global_dof_index, unsigned int> node_of_dof;
    const auto                                      all_facets =
      Utilities::MPI::all_gather(discretization.communicator, own);
    for (const auto &of_rank : all_facets)
      for (const LooseFacet<dim> &loose : of_rank)
        {
          SurfaceFacet<dim> facet;
          facet.body   = loose.body;
          facet.part   = loose.part;
          facet.middle = loose.middle;
          facet.level  = loose.level;
          facet.name   = loose.name;
          for (unsigned int a = 0; a < n_nodes_per_facet(); ++a)
            {
              const SurfaceNode<dim> &node = loose.nodes[a];
              const auto              found =
                node_of_dof.emplace(node.dofs[0], nodes.size());
              if (found.second)
                nodes.push_back(node);
              facet.nodes[a] = found.first->second;
            }
          facets.push_back(facet);
        }

    parents.resize(nodes.size());
    for (const auto &of_rank : all_facets)
      for (const LooseFacet<dim> &loose : of_rank)
        for (unsigned int a = 0; a < n_nodes_per_facet(); ++a)
          if (auto &of_node = parents[node_of_dof.at(loose.nodes[a].dofs[0])];
              of_node.empty())
            for (const auto &[dof, part] : loose.parents[a])
              of_node.emplace_back(node_of_dof.at(dof), part);
  }



  template<int dim>
  std::vector<typename Surface<dim>::Part>
  Surface<dim>::followed_by(const unsigned int node) const
  {
    return parents[node].empty() ? std::vector<Part>{{node, 1.}}
                                 : parents[node];
  }



  template<int dim>
  std::vector<typename Surface<dim>::Part>
  Surface<dim>::receivers(const unsigned int node) const
  {
    if (parents[node].empty())
      return {{node, 1.}};
    std::vector<Part> receivers;
    for (const auto &[parent, part] : parents[node])
      if (part > 0)
        receivers.emplace_back(parent, 0.5);
    return receivers;
  }



  template<int dim>
  Point<dim> Surface<dim>::position(const unsigned int   node,
                                    const GhostedVector &u) const
  {
    Point<dim> x = nodes[node].X;
    if (u.size() > 0)
      for (unsigned int c = 0; c < dim; ++c)
        x[c] += u[nodes[node].dofs[c]];
    return x;
  }



  template<int dim>
  std::vector<Point<dim>> Surface<dim>::positions(const GhostedVector &u) const
  {
    std::vector<Point<dim>> positions;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      positions.push_back(position(i, u));
    return positions;
  }



  template<int dim>
  Tensor<1, dim> Surface<dim>::normal_at(const unsigned int   node,
                                         const GhostedVector &u) const
  {
    Tensor<1, dim> sum;
    for (const unsigned int e : facets_of_node[node])
      {
        PerFacetNode<dim, Point<dim>> x;
        for (unsigned int a = 0; a < n_nodes_per_facet(); ++a)
          x[a] = position(facets[e].nodes[a], u);
        sum +=
          facet_normal<dim>(degree, x, node_place<dim>(number_in(e, node)));
      }
    return sum / sum.norm();
  }



  template<int dim>
  void Surface<dim>::collect_facets_of_nodes()
  {
    facets_of_node.assign(nodes.size(), {});
    for (unsigned int e = 0; e < facets.size(); ++e)
      for (unsigned int a = 0; a < n_nodes_per_facet(); ++a)
        facets_of_node[facets[e].nodes[a]].push_back(e);
  }



  template<int dim>
  void Surface<dim>::cut_into_sides()
  {
    copy_nodes_of_sides();
    cut_links();
    collect_facets_of_nodes();
  }



  // The first side of a node keeps its number. A hanging node follows the nodes
  // of its own side: those on the facets around it, or on facets beside these.
  template<int dim>
  void Surface<dim>::copy_nodes_of_sides()
  {
    const unsigned int n_nodes = nodes.size();
    // By surface node, the mesh node and the facets of the side.
    std::vector<unsigned int>              original(n_nodes);
    std::vector<std::vector<unsigned int>> side_of(n_nodes);
    std::iota(original.begin(), original.end(), 0);
    auto new_facets = facets;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        std::set<unsigned int> done;
        for (const unsigned int e : facets_of_node[i])
          {
            if (done.count(e) > 0)
              continue;
            const auto         side = same_side(e, number_in(e, i));
            const unsigned int copy = done.empty() ? i : nodes.size();
            if (copy != i)
              {
                nodes.push_back(nodes[i]);
                original.push_back(i);
                side_of.emplace_back();
              }
            side_of[copy] = side;
            done.insert(side.begin(), side.end());
            for (const unsigned int facet : side)
              new_facets[facet].nodes[number_in(facet, i)] = copy;
          }
      }

    std::vector<std::vector<unsigned int>> copies(n_nodes);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      copies[original[i]].push_back(i);
    parents.resize(nodes.size());
    for (unsigned int i = nodes.size(); i-- > 0;)
      {
        parents[i] = parents[original[i]];
        std::set<unsigned int> near(side_of[i].begin(), side_of[i].end());
        for (const unsigned int e : side_of[i])
          for (const unsigned int a : {0, 1, 2, 3})
            if (a < GeometryInfo<dim - 1>::vertices_per_cell)
              for (const unsigned int other : same_side(e, a))
                near.insert(other);
        for (Part &parent : parents[i])
          for (const unsigned int copy : copies[parent.first])
            if (std::any_of(side_of[copy].begin(),
                            side_of[copy].end(),
                            [&](const auto e) { return near.count(e) > 0; }))
              {
                parent.first = copy;
                break;
              }
      }
    facets = std::move(new_facets);
  }



  // From facet to facet across the sides at the node that are no corners. A
  // facet that has two smaller ones as neighbors across a side knows one.
  template<int dim>
  std::vector<unsigned int>
  Surface<dim>::smooth_around(const unsigned int facet,
                              const unsigned int a) const
  {
    const unsigned int        node = facets[facet].nodes[a];
    std::vector<unsigned int> around{facet};
    const auto leads_to = [&](const unsigned int from, const unsigned int to) {
      for (unsigned int s = 0; s < SurfaceFacet<dim>::n_sides; ++s)
        if (facets[from].neighbors[s] == to && !facets[from].corner[s] &&
            is_on_side<dim>(number_in(from, node), s))
          return true;
      return false;
    };
    for (unsigned int k = 0; k < around.size(); ++k)
      for (const unsigned int next : facets_of_node[node])
        if ((leads_to(around[k], next) || leads_to(next, around[k])) &&
            std::find(around.begin(), around.end(), next) == around.end())
          around.push_back(next);
    std::sort(around.begin(), around.end());
    return around;
  }



  template<int dim>
  void Surface<dim>::find_parted()
  {
    parted.resize(facets.size());
    for (unsigned int e = 0; e < facets.size(); ++e)
      for (unsigned int a = 0; a < n_nodes_per_facet(); ++a)
        {
          auto around = smooth_around(e, a);
          if (around.size() != facets_of_node[facets[e].nodes[a]].size())
            parted[e][a] = std::move(around);
        }
  }



  template class Surface<2>;
  template class Surface<3>;
} // namespace Contact
