/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/mortar_geometry.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace Contact
{
  namespace
  {
    /// Newton's method for a root of a smooth function; edges are short against
    /// their curvature, so that few steps suffice.
    template<typename Function>
    double find_root(const Function &value_and_slope)
    {
      double xi = 0;
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          const auto [value, slope] = value_and_slope(xi);
          if (slope == 0)
            break;
          const double step = -value / slope;
          xi                = std::max(-3., std::min(3., xi + step));
          if (std::abs(step) < 1e-14)
            break;
        }
      return xi;
    }



    /// A root with the derivatives that those of the function's value there
    /// give it: one more step of Newton's method.
    template<typename Number>
    Number follow_root(const double xi, const Number &value, const double slope)
    {
      if (slope == 0)
        return xi;
      return xi - value / slope;
    }



    /// The outward normal at a node of an edge by that edge alone.
    template<typename Number>
    Tensor<1, 2, Number> own_normal(const Surface<2> &surface,
                                    const std::vector<Tensor<1, 2, Number>> &x,
                                    const unsigned int edge,
                                    const unsigned int a)
    {
      const EdgeShape            shape(surface.degree, node_coordinates[a]);
      const Tensor<1, 2, Number> along =
        MortarGeometry<Number>::at(x, surface.facets[edge], shape.first);
      const Number         size = length(along);
      Tensor<1, 2, Number> outward;
      outward[0] = along[1] / size;
      outward[1] = -along[0] / size;
      return outward;
    }



    /// The same by both edges that meet there, but at a corner.
    template<typename Number>
    Tensor<1, 2, Number> mean_normal(const Surface<2> &surface,
                                     const std::vector<Tensor<1, 2, Number>> &x,
                                     const unsigned int                       e,
                                     const unsigned int                       a)
    {
      const SurfaceFacet<2> &edge   = surface.facets[e];
      Tensor<1, 2, Number>   normal = own_normal(surface, x, e, a);
      const unsigned int     other =
        a < 2 ? edge.neighbors[a] : numbers::invalid_unsigned_int;
      if (other == numbers::invalid_unsigned_int || edge.is_feature[a])
        return normal;
      normal += own_normal(surface, x, other, 1 - a);
      const Number size = length(normal);
      normal /= size;
      return normal;
    }



    /**
     * Whether the curve that a surface stands for ends along @p direction, or
     * against it, at the node @p a of the edge @p e. The direction there is
     * extrapolated from two pieces, halves of an edge of degree 2 or two
     * edges, in the middle of which it is that of the piece; on a circle this
     * is exact.
     */
    bool ends_along(const Surface<2>   &surface,
                    const unsigned int  e,
                    const unsigned int  a,
                    const Tensor<1, 2> &direction)
    {
      const auto &edge  = surface.facets[e];
      const auto  place = [&](const unsigned int node) {
        return Tensor<1, 2>(surface.nodes[node].X);
      };
      const unsigned int next = edge.neighbors[1 - a];
      Tensor<1, 2> first      = place(edge.nodes[1 - a]) - place(edge.nodes[a]);
      Tensor<1, 2> second     = first;
      if (surface.degree == 2)
        {
          first  = place(edge.nodes[2]) - place(edge.nodes[a]);
          second = place(edge.nodes[1 - a]) - place(edge.nodes[2]);
        }
      else if (next != numbers::invalid_unsigned_int && !edge.corner[1 - a])
        second =
          place(surface.facets[next].nodes[1 - a]) - place(edge.nodes[1 - a]);

      const Tensor<1, 2> along = first * direction > 0 ? direction : -direction;
      const auto angle = [](const Tensor<1, 2> &u, const Tensor<1, 2> &v) {
        return std::atan2(cross(u, v), u * v);
      };
      const double bend   = angle(first, second);
      const double length = first.norm() / (first.norm() + second.norm());
      // With its mirror image the curve has no corner there.
      return std::abs(angle(along, first) - bend * length) <=
             numbers::PI / 180 * Surface<2>::feature_angle / 2;
    }



    template<typename Number>
    void drop_derivatives(Tensor<1, 2, Number> &x)
    {
      x = Tensor<1, 2, Number>(value_of(x));
    }
  } // namespace



  template<typename Number>
  MortarGeometry<Number>::MortarGeometry(
    const Surface<2>           &slave,
    const Surface<2>           &master,
    const DiscretizedBodies<2> &discretization,
    const GhostedVector        &u)
    : slave(slave)
    , master(master)
    , slave_normals(slave.facets.size())
    , master_normals(master.facets.size())
    , discretization(discretization)
  {
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      slave_x.emplace_back(slave.position(i, u));
    for (unsigned int i = 0; i < master.nodes.size(); ++i)
      master_x.emplace_back(master.position(i, u));
    find_symmetry_lines();
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      find_slave_normals(e);
    for (unsigned int e = 0; e < master.facets.size(); ++e)
      find_master_normals(e);
  }



  // A face of either surface ends there, and supports hold both nodes across
  // the line alike. An end that supports hold on one side only, as that of a
  // body which is dragged, is no symmetry line, nor the wall of a guide that an
  // interface meets at a slant: with its mirror image it would have a corner.
  template<typename Number>
  void MortarGeometry<Number>::find_symmetry_lines()
  {
    const double round_off = 1e-8;
    using End              = std::pair<unsigned int, unsigned int>;
    const auto ends_of     = [](const Surface<2> &surface) {
      std::vector<End> ends;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        {
          for (const unsigned int a : {0, 1})
            if (surface.facets[e].ends_side[a])
              ends.emplace_back(e, a);
        }
      return ends;
    };
    const std::vector<End> master_ends = ends_of(master);
    for (const auto &[e, a] : ends_of(slave))
      {
        const unsigned int node       = slave.facets[e].nodes[a];
        const auto        &dofs       = slave.nodes[node].dofs;
        auto               directions = discretization.held_normals(dofs);
        for (const unsigned int c : {0, 1})
          directions.push_back(Point<2>::unit_vector(c));
        for (const Tensor<1, 2> &across : directions)
          {
            const Tensor<1, 2> along = cross_product_2d(across);
            if (discretization.free_part(dofs, across).norm() > round_off ||
                discretization.free_part(dofs, along).norm() < 0.5 ||
                !ends_along(slave, e, a, across))
              continue;
            for (const auto &[e_m, a_m] : master_ends)
              {
                const unsigned int m = master.facets[e_m].nodes[a_m];
                if (discretization.are_held_alike(dofs,
                                                  master.nodes[m].dofs,
                                                  across) &&
                    std::abs(across * value_of(slave_x[node] - master_x[m])) <
                      1e-6 * slave.reference_length(e))
                  symmetry_lines[{e, a}] = along;
              }
          }
      }
  }



  template<typename Number>
  Tensor<1, 2, Number>
  MortarGeometry<Number>::symmetric(const Tensor<1, 2, Number> &normal,
                                    const unsigned int          edge,
                                    const unsigned int          a) const
  {
    const auto           line = symmetry_lines.find({edge, a});
    Tensor<1, 2, Number> unit = normal;
    if (line != symmetry_lines.end())
      unit = (normal * line->second) * Tensor<1, 2, Number>(line->second);
    unit /= length(unit);
    return unit;
  }



  template<typename Number>
  void MortarGeometry<Number>::find_slave_normals(const unsigned int edge)
  {
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      {
        const Tensor<1, 2, Number> normal =
          Number(-1) * mean_normal(slave, slave_x, edge, a);
        slave_normals[edge][a] = symmetric(normal, edge, a);
      }
  }



  template<typename Number>
  void MortarGeometry<Number>::find_master_normals(const unsigned int edge)
  {
    for (unsigned int a = 0; a < master.n_nodes_per_edge(); ++a)
      master_normals[edge][a] = mean_normal(master, master_x, edge, a);
  }



  template<typename Number>
  std::set<unsigned int>
  MortarGeometry<Number>::edges_around(const Surface<2>             &surface,
                                       const std::set<unsigned int> &nodes)
  {
    std::set<unsigned int> edges;
    for (const unsigned int node : nodes)
      for (const unsigned int e : surface.facets_of_node[node])
        for (const unsigned int near : {e,
                                        surface.facets[e].neighbors[0],
                                        surface.facets[e].neighbors[1]})
          if (near != numbers::invalid_unsigned_int)
            edges.insert(near);
    return edges;
  }



  template<typename Number>
  void
  MortarGeometry<Number>::follow(const std::set<unsigned int> &slave_nodes,
                                 const std::set<unsigned int> &master_nodes)
  {
    for (const unsigned int i : followed_slave_nodes)
      drop_derivatives(slave_x[i]);
    for (const unsigned int i : followed_master_nodes)
      drop_derivatives(master_x[i]);
    for (const unsigned int e : followed_slave_edges)
      for (auto &normal : slave_normals[e])
        drop_derivatives(normal);
    for (const unsigned int e : followed_master_edges)
      for (auto &normal : master_normals[e])
        drop_derivatives(normal);

    followed_slave_nodes  = slave_nodes;
    followed_master_nodes = master_nodes;
    followed_slave_edges  = edges_around(slave, slave_nodes);
    followed_master_edges = edges_around(master, master_nodes);

    const unsigned int n = 2 * (slave_nodes.size() + master_nodes.size());
    unsigned int       k = 0;
    const auto         number_unknowns = [&](Tensor<1, 2, Number> &x) {
      for (unsigned int c = 0; c < 2; ++c)
        if constexpr (std::is_same_v<Number, WithDerivatives>)
          x[c] = WithDerivatives(n, k++, x[c].val());
    };
    for (const unsigned int i : slave_nodes)
      number_unknowns(slave_x[i]);
    for (const unsigned int i : master_nodes)
      number_unknowns(master_x[i]);
    for (const unsigned int e : followed_slave_edges)
      find_slave_normals(e);
    for (const unsigned int e : followed_master_edges)
      find_master_normals(e);
  }



  template<typename Number>
  Number MortarGeometry<Number>::projection_on_edge(
    const Tensor<1, 2, Number> &x,
    const Tensor<1, 2, Number> &n,
    const unsigned int          master_facet) const
  {
    const auto                 &edge = master.facets[master_facet];
    const Tensor<1, 2>          x_0 = value_of(x), n_0 = value_of(n);
    std::array<Tensor<1, 2>, 3> nodes;
    for (unsigned int a = 0; a < 3; ++a)
      nodes[a] = value_of(master_x[edge.nodes[a]]);
    const auto along = [&](const std::array<double, 3> &shape) {
      return shape[0] * nodes[0] + shape[1] * nodes[1] + shape[2] * nodes[2];
    };
    const double xi = find_root([&](const double xi) {
      const EdgeShape shape(master.degree, xi);
      return std::make_pair(cross(along(shape.value) - x_0, n_0),
                            cross(along(shape.first), n_0));
    });
    if constexpr (std::is_same_v<Number, double>)
      return xi;

    const EdgeShape            shape(master.degree, xi);
    const Tensor<1, 2, Number> r = at(master_x, edge, shape.value) - x;
    return follow_root(xi, cross(r, n), cross(along(shape.first), n_0));
  }



  template<typename Number>
  Number
  MortarGeometry<Number>::slave_coordinate(const unsigned int slave_facet,
                                           const Tensor<1, 2, Number> &x) const
  {
    const auto                 &edge = slave.facets[slave_facet];
    const Tensor<1, 2>          x_0  = value_of(x);
    std::array<Tensor<1, 2>, 3> nodes, normals;
    for (unsigned int a = 0; a < 3; ++a)
      nodes[a] = value_of(slave_x[edge.nodes[a]]);
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      normals[a] = value_of(slave_normals[slave_facet][a]);
    const auto sum = [](const std::array<Tensor<1, 2>, 3> &values,
                        const std::array<double, 3>       &shape) {
      return shape[0] * values[0] + shape[1] * values[1] + shape[2] * values[2];
    };
    const auto slope = [&](const EdgeShape &shape) {
      return cross(sum(nodes, shape.first), sum(normals, shape.value)) +
             cross(sum(nodes, shape.value) - x_0, sum(normals, shape.first));
    };
    const double xi = find_root([&](const double xi) {
      const EdgeShape shape(slave.degree, xi);
      return std::make_pair(cross(sum(nodes, shape.value) - x_0,
                                  sum(normals, shape.value)),
                            slope(shape));
    });
    if constexpr (std::is_same_v<Number, double>)
      return xi;

    const EdgeShape            shape(slave.degree, xi);
    const Tensor<1, 2, Number> r = at(slave_x, edge, shape.value) - x;
    return follow_root(xi,
                       cross(r, slave_normal(slave_facet, shape.value)),
                       slope(shape));
  }



  template class MortarGeometry<double>;
  template class MortarGeometry<WithDerivatives>;
} // namespace Contact
