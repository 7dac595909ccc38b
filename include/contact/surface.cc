/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surface.h"

#include <deal.II/base/mpi.h>

#include <map>
#include <numeric>
#include <utility>

#include "base/errors.h"

namespace Contact
{
  namespace
  {
    /// An edge with its own nodes, as the ranks exchange it.
    struct LooseEdge
    {
      std::array<Surface::Node, 3> nodes;
      types::material_id           body;
      unsigned int                 part;
      Point<2>                     middle;

      template<class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        for (Surface::Node &node : nodes)
          archive &node.dofs[0] & node.dofs[1] & node.X;
        archive &body &part &middle;
      }
    };



    /// Of each cell of the coarse mesh, which every rank has, the connected
    /// part of the mesh that it belongs to: a cell number that all of it share.
    std::vector<unsigned int> connected_parts(const Triangulation<2> &mesh)
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



    /// A face of a cell at the boundary, its part left open.
    LooseEdge make_loose_edge(const Discretization<2> &discretization,
                              const DoFHandler<2>::active_cell_iterator &cell,
                              const unsigned int                         f)
    {
      const auto                           face  = cell->face(f);
      const unsigned int                   index = cell->active_fe_index();
      const auto                          &fe    = cell->get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face(f));
      face->get_dof_indices(dofs, index);

      // The unknowns of a face come in the order of its own vertices.
      LooseEdge edge;
      edge.body   = cell->material_id();
      edge.middle = face->center(/*respect_manifold=*/true);
      for (unsigned int a = 0; a < 2; ++a)
        edge.nodes[a].X = face->vertex(a);
      // The elements number the corners, then the mid-sides as the faces.
      if (discretization.degree == 2)
        edge.nodes[2].X =
          discretization.mapping[index].transform_unit_to_real_cell(
            cell,
            fe.base_element(0).unit_support_point(cell->n_vertices() + f));
      for (unsigned int k = 0; k < dofs.size(); ++k)
        {
          const auto [c, a]     = fe.face_system_to_component_index(k, f);
          edge.nodes[a].dofs[c] = dofs[k];
        }

      const Tensor<1, 2> along  = edge.nodes[1].X - edge.nodes[0].X;
      const Tensor<1, 2> inward = cell->center() - face->center();
      if (along[0] * inward[1] - along[1] * inward[0] < 0)
        std::swap(edge.nodes[0], edge.nodes[1]);
      return edge;
    }



    /// The angle from a to b, positive to the left [rad].
    double angle(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return std::atan2(a[0] * b[1] - a[1] * b[0], a * b);
    }
  } // namespace



  Surface::Surface(const Discretization<2>            &discretization,
                   const std::set<types::boundary_id> &boundary_ids,
                   const std::string                  &name)
    : degree(discretization.degree)
    , discretization(discretization)
  {
    collect_edges(boundary_ids);
    if (edges.empty())
      throw InputError("the surface '" + name + "' has no edge",
                       "Contact",
                       "name a boundary group of the mesh that has lines");
    chain_edges();
    renumber_nodes();
    link_edges();
    find_corners();
    measure_turns();
  }



  // Every rank collects the edges of its own cells; put together, all have the
  // whole surface.
  void Surface::collect_edges(const std::set<types::boundary_id> &boundary_ids)
  {
    const auto parts = connected_parts(discretization.mesh.triangulation);
    std::vector<LooseEdge> own;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          const auto face = cell->face(f);
          if (!cell->is_locally_owned() || !face->at_boundary() ||
              boundary_ids.count(face->boundary_id()) == 0)
            continue;

          own.push_back(make_loose_edge(discretization, cell, f));
          own.back().part =
            parts[coarse_cell<Triangulation<2>::cell_iterator>(cell)];
        }

    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(discretization.communicator, own))
      for (const LooseEdge &loose : of_rank)
        {
          const unsigned int none = numbers::invalid_unsigned_int;
          Edge               edge{{{0, 0, 0}},
                    loose.body,
                    false,
                    false,
                    none,
                    none,
                    loose.part,
                    loose.middle};
          for (unsigned int a = 0; a < n_nodes_per_edge(); ++a)
            {
              const Node &node = loose.nodes[a];
              const auto  found =
                node_of_dof.emplace(node.dofs[0], nodes.size());
              if (found.second)
                nodes.push_back(node);
              edge.nodes[a] = found.first->second;
            }
          edges.push_back(edge);
        }
  }



  void Surface::chain_edges()
  {
    std::map<unsigned int, unsigned int> begins_at, ends_at;
    for (unsigned int e = 0; e < edges.size(); ++e)
      {
        begins_at[edges[e].nodes[0]] = e;
        ends_at[edges[e].nodes[1]]   = e;
      }
    for (Edge &edge : edges)
      {
        edge.begins_surface = ends_at.count(edge.nodes[0]) == 0;
        edge.ends_surface   = begins_at.count(edge.nodes[1]) == 0;
      }

    // Follow every open chain from its beginning, then what is left: loops.
    std::vector<Edge> chained;
    std::vector<bool> taken(edges.size(), false);
    const auto        follow = [&](unsigned int e) {
      while (!taken[e])
        {
          taken[e] = true;
          chained.push_back(edges[e]);
          if (!edges[e].ends_surface)
            e = begins_at[edges[e].nodes[1]];
        }
    };
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (edges[e].begins_surface)
        follow(e);
    for (unsigned int e = 0; e < edges.size(); ++e)
      follow(e);
    edges = chained;
  }



  void Surface::renumber_nodes()
  {
    std::vector<unsigned int> new_number(nodes.size(),
                                         numbers::invalid_unsigned_int);
    std::vector<Node>         ordered;
    for (Edge &edge : edges)
      {
        // Along the edge: first, (middle,) last.
        std::vector<unsigned int> along{0, 1};
        if (degree == 2)
          along = {0, 2, 1};
        for (const unsigned int a : along)
          {
            unsigned int &node = edge.nodes[a];
            if (new_number[node] == numbers::invalid_unsigned_int)
              {
                new_number[node] = ordered.size();
                ordered.push_back(nodes[node]);
              }
            node = new_number[node];
          }
      }
    nodes = ordered;
  }



  void Surface::link_edges()
  {
    std::map<unsigned int, unsigned int> begins_at;
    edges_of_node.resize(nodes.size());
    for (unsigned int e = 0; e < edges.size(); ++e)
      {
        begins_at[edges[e].nodes[0]] = e;
        for (unsigned int a = 0; a < n_nodes_per_edge(); ++a)
          edges_of_node[edges[e].nodes[a]].push_back(e);
      }
    for (unsigned int e = 0; e < edges.size(); ++e)
      if (!edges[e].ends_surface)
        {
          edges[e].next                 = begins_at.at(edges[e].nodes[1]);
          edges[edges[e].next].previous = e;
        }
  }



  Tensor<1, 2> Surface::reference_tangent(const Edge  &edge,
                                          const double xi) const
  {
    const EdgeShape shape(degree, xi);
    Tensor<1, 2>    tangent;
    for (unsigned int a = 0; a < n_nodes_per_edge(); ++a)
      tangent += shape.first[a] * nodes[edge.nodes[a]].X;
    return tangent;
  }



  // With the body on the left, the surface turns to the left where it is
  // convex.
  void Surface::find_corners()
  {
    for (Edge &edge : edges)
      {
        edge.begins_face = edge.begins_face || edge.begins_surface;
        edge.ends_face   = edge.ends_face || edge.ends_surface;
        if (edge.previous == numbers::invalid_unsigned_int)
          continue;
        Edge        &before = edges[edge.previous];
        const double turn =
          angle(reference_tangent(before, 1), reference_tangent(edge, -1));
        if (std::abs(turn) <= numbers::PI / 180 * feature_angle)
          continue;
        before.corner[1] = edge.corner[0] = true;
        if (turn > 0)
          before.ends_face = edge.begins_face = true;
      }
  }



  // On an arc the angle between the chords of its halves is half of what it
  // turns by, and each chord is a quarter of that off the tangent at its end.
  double Surface::turn_of_curves(const unsigned int e) const
  {
    if (edges[e].previous == numbers::invalid_unsigned_int)
      return 0;
    const auto half = [this](const Edge &edge, const unsigned int a) {
      const Point<2> end = nodes[edge.nodes[a]].X;
      return a == 0 ? edge.middle - end : end - edge.middle;
    };
    const Edge &before = edges[edges[e].previous];
    return angle(half(before, 1), half(edges[e], 0)) -
           0.5 * (angle(half(before, 0), half(before, 1)) +
                  angle(half(edges[e], 0), half(edges[e], 1)));
  }



  void Surface::measure_turns()
  {
    turns.assign(nodes.size(), 0.);
    const auto chord = [this](const Edge &edge) {
      return nodes[edge.nodes[1]].X - nodes[edge.nodes[0]].X;
    };
    for (const Edge &edge : edges)
      {
        if (edge.previous != numbers::invalid_unsigned_int)
          turns[edge.nodes[0]] =
            std::abs(angle(chord(edges[edge.previous]), chord(edge)));
        if (degree == 2)
          turns[edge.nodes[2]] = std::abs(
            angle(reference_tangent(edge, -1), reference_tangent(edge, 1)));
      }

    // The body ends there, or it goes on with a side that is in no group.
    for (const Edge &edge : edges)
      for (unsigned int a = 0; a < 2; ++a)
        if (a == 0 ? edge.begins_surface : edge.ends_surface)
          turns[edge.nodes[a]] = numbers::PI / 2;
  }



  Point<2> Surface::position(const unsigned int    node,
                             const Vector<double> &u) const
  {
    const auto &[dofs, X] = nodes[node];
    return X + Point<2>(u[dofs[0]], u[dofs[1]]);
  }



  Tensor<1, 2> Surface::normal(const Edge           &edge,
                               const unsigned int    a,
                               const Vector<double> &u) const
  {
    const EdgeShape shape(degree, node_coordinates[a]);
    Tensor<1, 2>    along;
    for (unsigned int b = 0; b < n_nodes_per_edge(); ++b)
      along += shape.first[b] * position(edge.nodes[b], u);

    // The body lies to the left of the edge.
    const Tensor<1, 2> outward = cross_product_2d(along);
    return outward / outward.norm();
  }



  std::vector<Tensor<1, 2>> Surface::normals(const Vector<double> &u) const
  {
    std::vector<Tensor<1, 2>> normals(nodes.size());
    for (const Edge &edge : edges)
      for (unsigned int a = 0; a < n_nodes_per_edge(); ++a)
        normals[edge.nodes[a]] += normal(edge, a, u);
    for (Tensor<1, 2> &normal : normals)
      normal /= normal.norm();
    return normals;
  }



  std::vector<Surface::PerEdgeNode<Tensor<1, 2>>>
  Surface::edge_normals(const Vector<double> &u) const
  {
    const auto                             mean = normals(u);
    std::vector<PerEdgeNode<Tensor<1, 2>>> normals(edges.size());
    for (unsigned int e = 0; e < edges.size(); ++e)
      for (unsigned int a = 0; a < n_nodes_per_edge(); ++a)
        normals[e][a] = a < 2 && edges[e].corner[a] ? normal(edges[e], a, u)
                                                    : mean[edges[e].nodes[a]];
    return normals;
  }



  double Surface::reference_length(const unsigned int edge) const
  {
    const auto &ends = edges[edge].nodes;
    return nodes[ends[0]].X.distance(nodes[ends[1]].X);
  }



  std::vector<double> Surface::arc_length(const std::vector<Point<2>> &x) const
  {
    std::vector<double> s(nodes.size(), 0.);
    for (unsigned int i = 1; i < s.size(); ++i)
      s[i] = s[i - 1] + x[i].distance(x[i - 1]);
    return s;
  }



  double Surface::largest_bend() const
  {
    const auto is_straight = [this](const Edge &edge) {
      const Point<2> &a = nodes[edge.nodes[0]].X, &b = nodes[edge.nodes[1]].X;
      return edge.middle.distance(a + 0.5 * (b - a)) <= 1e-6 * a.distance(b);
    };
    const auto chord = [this](const Edge &edge) {
      return nodes[edge.nodes[1]].X - nodes[edge.nodes[0]].X;
    };
    double largest = 0;
    for (const Edge &edge : edges)
      if (edge.previous != numbers::invalid_unsigned_int)
        {
          const double bend =
            180 / numbers::PI *
            std::abs(angle(chord(edges[edge.previous]), chord(edge)));
          if (!edge.corner[0] && is_straight(edge))
            largest = std::max(largest, bend);
        }
    return largest;
  }
} // namespace Contact
