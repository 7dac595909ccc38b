/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_h
#define contact_surface_h

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// The Lagrange functions of an edge, on [-1, 1], and two derivatives. Node
  /// order: first, last, middle.
  template<typename Number>
  struct EdgeShapes
  {
    EdgeShapes(const unsigned int degree, const Number &xi)
    {
      if (degree == 1)
        {
          value  = {{(1 - xi) / 2, (1 + xi) / 2, 0}};
          first  = {{-0.5, 0.5, 0}};
          second = {{0, 0, 0}};
        }
      else
        {
          value  = {{xi * (xi - 1) / 2, xi * (xi + 1) / 2, 1 - xi * xi}};
          first  = {{xi - 0.5, xi + 0.5, -2 * xi}};
          second = {{1, 1, -2}};
        }
    }

    std::array<Number, 3> value, first, second;
  };

  using EdgeShape = EdgeShapes<double>;

  /// Coordinates of the nodes of an edge: first, last, middle.
  constexpr std::array<double, 3> node_coordinates{{-1, 1, 0}};



  /// A boundary of the bodies as a chain of straight or parabolic edges.
  class Surface
  {
  public:
    struct Node
    {
      NodeDoFs<2> dofs;
      Point<2>    X; // reference position [mm]
    };

    /// The body lies to the left of the edge.
    struct Edge
    {
      std::array<unsigned int, 3> nodes; // first, last, middle
      types::material_id          body;
      bool                        begins_surface, ends_surface;
      unsigned int                previous, next; // along the chain, or invalid

      /// The connected part of the mesh it belongs to, which may be of several
      /// bodies, or a part of one.
      unsigned int part = 0;

      /// The middle of the curve that the edge stands for, undeformed [mm].
      Point<2> middle;

      /// Corners at the first and the last node.
      std::array<bool, 2> corner{{false, false}};

      /// A face ends where the surface ends, and at convex corners: beyond
      /// them nothing faces it.
      bool begins_face = false, ends_face = false;
    };

    /**
     * Two edges that meet, undeformed, at an angle of more than this [degrees]
     * make a corner: each has a normal of its own there. Less is a curve that
     * the mesh has drawn as a polygon, with one normal at each node. Contact
     * codes and mesh generators draw the line between 20 and 40 degrees; here
     * it is between the regular polygons of 10 and 11 sides, so that no regular
     * one is on it, and an arc of 90 degrees in three edges is a curve.
     */
    static constexpr double feature_angle = 35;

    /// Throws InputError if there is no edge.
    Surface(const Discretization<2>            &discretization,
            const std::set<types::boundary_id> &boundary_ids,
            const std::string                  &name);

    /// Those of the discretization.
    Counters &counters() const
    {
      return discretization.counters;
    }

    const unsigned int degree;
    std::vector<Node>  nodes; // along the chain, mid-sides in their place
    std::vector<Edge>  edges; // along the chain

    /// The edges that meet at each node.
    std::vector<std::vector<unsigned int>> edges_of_node;

    /// The largest angle by which one edge turns against the one before it
    /// [degrees], of those that are no corners.
    double largest_bend() const;

    /// By how much the curves turn that two edges stand for, where an edge
    /// begins, to the left [rad]: on an arc of any number of edges not at all.
    double turn_of_curves(const unsigned int edge) const;

    /// By how much the undeformed surface turns at each node, from the middle
    /// of the edge before it to the middle of the edge behind it [rad]; at an
    /// end by a right angle.
    std::vector<double> turns;

    unsigned int n_nodes_per_edge() const
    {
      return degree + 1;
    }

    /// Current position of a node.
    Point<2> position(const unsigned int node, const Vector<double> &u) const;

    /// The outward unit normals at the nodes of the deformed surface: the mean
    /// of those of the edges that meet there.
    std::vector<Tensor<1, 2>> normals(const Vector<double> &u) const;

    /// Something at each node of an edge: first, last, middle.
    template<typename T>
    using PerEdgeNode = std::array<T, 3>;

    /// The same by edge: at corners the normal of the edge alone.
    std::vector<PerEdgeNode<Tensor<1, 2>>>
    edge_normals(const Vector<double> &u) const;

    /// The distance of the ends of an edge, undeformed [mm].
    double reference_length(const unsigned int edge) const;

    /// The measure of integrals per unit of an edge's coordinate, undeformed:
    /// its length [mm]; of rings the area [mm^2].
    template<typename Number>
    Number reference_jacobian(const Edge               &edge,
                              const EdgeShapes<Number> &shape) const
    {
      Tensor<1, 2, Number> X, tangent;
      for (unsigned int a = 0; a <= degree; ++a)
        {
          X += shape.value[a] * Tensor<1, 2>(nodes[edge.nodes[a]].X);
          tangent += shape.first[a] * Tensor<1, 2>(nodes[edge.nodes[a]].X);
        }
      using std::sqrt;
      return sqrt(tangent * tangent) * discretization.circumference_at(X[0]);
    }

    /// Arc length of all nodes from the first one [mm], from the positions
    /// @p x of the nodes.
    std::vector<double> arc_length(const std::vector<Point<2>> &x) const;

  private:
    void collect_edges(const std::set<types::boundary_id> &boundary_ids);
    void chain_edges();
    void renumber_nodes();
    void link_edges();
    void find_corners();
    void measure_turns();

    /// The direction of an edge at its coordinate xi, undeformed.
    Tensor<1, 2> reference_tangent(const Edge &edge, const double xi) const;

    /// The outward unit normal at a node of an edge by that edge alone.
    Tensor<1, 2> normal(const Edge           &edge,
                        const unsigned int    a,
                        const Vector<double> &u) const;

    const Discretization<2> &discretization;
  };
} // namespace Contact

#endif
