/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_h
#define contact_surface_h

#include <array>
#include <set>
#include <string>
#include <vector>

#include "discretization.h"

namespace Contact
{
  using namespace dealii;

  /// The Lagrange functions of an edge, on [-1, 1], and two derivatives. Node
  /// order: first, last, middle.
  struct EdgeShape
  {
    EdgeShape(const unsigned int degree, const double xi);

    std::array<double, 3> value, first, second;
  };



  /// A boundary of the bodies as a chain of straight or parabolic edges.
  class Surface
  {
  public:
    struct Node
    {
      NodeDoFs dofs;
      Point<2> X; // reference position [mm]
    };

    /// The body lies to the left of the edge.
    struct Edge
    {
      std::array<unsigned int, 3> nodes; // first, last, middle
      types::material_id          body;
      bool                        begins_surface, ends_surface;
      unsigned int                previous, next; // along the chain, or invalid
    };

    /// Throws InputError if there is no edge.
    Surface(const Discretization               &discretization,
            const std::set<types::boundary_id> &boundary_ids,
            const std::string                  &name);

    const unsigned int degree;
    std::vector<Node>  nodes; // along the chain, mid-sides in their place
    std::vector<Edge>  edges; // along the chain

    /// The largest angle by which one edge turns against the one before it
    /// [degrees], of those that look like a curve: 30 degrees is a corner.
    double largest_bend() const;

    unsigned int n_nodes_per_edge() const
    {
      return degree + 1;
    }

    /// Current position of a node.
    Point<2> position(const unsigned int node, const Vector<double> &u) const;

    /// The outward unit normals at the nodes of the deformed surface: the mean
    /// of those of the edges that meet there.
    std::vector<Tensor<1, 2>> normals(const Vector<double> &u) const;

    /// The distance of the ends of an edge, undeformed [mm].
    double reference_length(const unsigned int edge) const;

    /// The measure of integrals per unit of an edge's coordinate, undeformed:
    /// its length [mm]; of rings the area [mm^2].
    double reference_jacobian(const Edge &edge, const EdgeShape &shape) const;

    /// Arc length of all nodes from the first one [mm], from the positions
    /// @p x of the nodes.
    std::vector<double> arc_length(const std::vector<Point<2>> &x) const;

  private:
    void collect_edges(const std::set<types::boundary_id> &boundary_ids);
    void chain_edges();
    void renumber_nodes();
    void link_edges();

    const Discretization &discretization;
  };
} // namespace Contact

#endif
