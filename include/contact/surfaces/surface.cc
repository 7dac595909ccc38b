/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/surface.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/dimension.h"
#include "base/errors.h"
#include "contact/surfaces/deformed_surface.h"
#include "contact/surfaces/loose_facets.h"

namespace Contact
{
  template<int dim>
  Surface<dim>::Surface(const DiscretizedBodies<dim>       &discretization,
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
      {
        find_hollow_sides();
        cut_into_sides();
      }
    find_parted();
  }



  template<int dim>
  Surface<dim>::Surface(const DiscretizedBodies<dim> &discretization,
                        const unsigned int            part)
    : degree(discretization.degree)
    , discretization(discretization)
  {
    const auto ids =
      discretization.dof_handler.get_triangulation().get_boundary_ids();
    collect_facets({ids.begin(), ids.end()}, part);
    arrange();
    find_parted();
  }



  // Every rank collects the facets of its own cells; put together, all have the
  // whole surface.
  template<int dim>
  void
  Surface<dim>::collect_facets(const std::set<types::boundary_id> &boundary_ids,
                               const std::optional<unsigned int>   part)
  {
    std::map<types::global_dof_index, unsigned int> node_of_dof;
    const auto all_facets = Utilities::MPI::all_gather(
      discretization.communicator,
      loose_facets(discretization, boundary_ids, part));
    for (const auto &of_rank : all_facets)
      for (const LooseFacet<dim> &loose : of_rank)
        {
          SurfaceFacet<dim> facet;
          facet.kind        = &facet_kind<dim>(loose.n_vertices, degree);
          facet.body        = loose.body;
          facet.piece       = loose.piece;
          facet.part        = loose.part;
          facet.middle      = loose.middle;
          facet.level       = loose.level;
          facet.coarse_cell = loose.coarse_cell;
          facet.name        = loose.name;
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
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
        for (unsigned int a = 0, n = loose.n_nodes(degree); a < n; ++a)
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
        const FacetKind<dim>         &kind = *facets[e].kind;
        PerFacetNode<dim, Point<dim>> x;
        for (unsigned int a = 0; a < kind.n_nodes; ++a)
          x[a] = position(facets[e].nodes[a], u);
        sum += facet_normal<dim>(kind, x, kind.places[number_in(e, node)]);
      }
    return sum / sum.norm();
  }



  template<int dim>
  double Surface<dim>::stretch_at(const unsigned int     facet,
                                  const FacetPoint<dim> &xi,
                                  const GhostedVector   &u) const
  {
    const FacetShape<dim> shape(*facets[facet].kind, xi);
    return jacobian(facets[facet],
                    shape,
                    [&](const unsigned int n) { return position(n, u); }) /
           reference_jacobian(facets[facet], shape);
  }



  // Just inside of the facets: on the axis a ring has no circumference.
  template<int dim>
  std::vector<double> Surface<dim>::stretches(const GhostedVector &u) const
  {
    const double        inside = 1 - 1e-6;
    std::vector<double> mean(nodes.size());
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (const unsigned int e : facets_of_node[n])
        {
          FacetPoint<dim> xi = facets[e].kind->places[number_in(e, n)];
          xi *= inside;
          mean[n] += stretch_at(e, xi, u) / facets_of_node[n].size();
        }
    return mean;
  }



  template<int dim>
  void Surface<dim>::collect_facets_of_nodes()
  {
    facets_of_node.assign(nodes.size(), {});
    for (unsigned int e = 0; e < facets.size(); ++e)
      for (unsigned int a = 0; a < facets[e].n_nodes(); ++a)
        facets_of_node[facets[e].nodes[a]].push_back(e);
  }



  template<int dim>
  void Surface<dim>::cut_into_sides()
  {
    copy_nodes_of_sides();
    cut_links();
    collect_facets_of_nodes();
  }



  // What a slave does not face tells whether its own corner or that of the
  // other body is there: in a hollow it is the other one.
  template<int dim>
  void Surface<dim>::find_hollow_sides()
  {
    const double flat = 1e-3; // but for the digits of a mesh file
    std::map<unsigned int, std::vector<unsigned int>> of_parts;
    for (unsigned int e = 0; e < facets.size(); ++e)
      of_parts[facets[e].part].push_back(e);
    for (const auto &[part, of_part] : of_parts)
      {
        const Surface<dim>                     whole(discretization, part);
        const DeformedSurface<dim>             drawn(whole, {});
        std::map<FacetName<dim>, unsigned int> number;
        for (unsigned int e = 0; e < whole.facets.size(); ++e)
          number[whole.facets[e].name] = e;
        for (const unsigned int e : of_part)
          for (unsigned int s = 0; s < facets[e].n_sides(); ++s)
            {
              const unsigned int       own  = number.at(facets[e].name);
              const SurfaceFacet<dim> &here = whole.facets[own];
              if (here.ends_surface(s))
                continue;
              unsigned int a = 0;
              while (!here.kind->has_on_side(a, s))
                ++a;
              const Tensor<1, dim> way =
                whole.facets[here.neighbors[s]].middle -
                drawn.position(own, here.kind->places[a]);
              facets[e].is_hollow[s] =
                drawn.normal(own, here.kind->places[a]) * way >
                flat * way.norm();
            }
      }
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
          for (unsigned int a = 0; a < facets[e].kind->n_vertices; ++a)
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
      for (unsigned int s = 0; s < facets[from].n_sides(); ++s)
        if (facets[from].neighbors[s] == to && !facets[from].corner[s] &&
            facets[from].kind->has_on_side(number_in(from, node), s))
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
      for (unsigned int a = 0; a < facets[e].n_nodes(); ++a)
        {
          auto around = smooth_around(e, a);
          if (around.size() != facets_of_node[facets[e].nodes[a]].size())
            parted[e][a] = std::move(around);
        }
  }



  template<int dim>
  double Surface<dim>::reference_length(const unsigned int facet) const
  {
    const auto           &of_facet = facets[facet].nodes;
    const FacetKind<dim> &kind     = *facets[facet].kind;
    double                shortest = std::numeric_limits<double>::max();
    for (const auto &[a, b] : kind.size_lines)
      shortest =
        std::min(shortest, nodes[of_facet[a]].X.distance(nodes[of_facet[b]].X));
    return shortest / kind.size_divisor;
  }

  template class Surface<2>;
  template class Surface<3>;
} // namespace Contact
