/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_h
#define contact_surface_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

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
    };

    /// Throws InputError if there is no edge.
    Surface(const Discretization               &discretization,
            const std::set<types::boundary_id> &boundary_ids,
            const std::string                  &name);

    const unsigned int degree;
    std::vector<Node>  nodes; // along the chain, mid-sides in their place
    std::vector<Edge>  edges; // along the chain

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

    const Discretization &discretization;
  };



  /// The point of a surface that is closest to a point in space.
  struct Projection
  {
    unsigned int edge;
    double       xi;

    /// The point lies before the first or behind the last edge of the chain.
    bool off_the_end;

    /// The foot of the normal lies outside the edge; xi is its nearer end.
    bool clipped;
  };



  /**
   * Closest-point queries on a deformed surface. The edges are kept in a tree
   * of their bounding boxes, and visited by the distance of their boxes until
   * no box can hold a closer point.
   */
  class SurfaceSearch
  {
  public:
    SurfaceSearch(const Surface &surface, const Vector<double> &u);

    Projection closest_point(const Point<2> &x) const;

    /// The closest point of one edge.
    Projection project(const Point<2> &x, const unsigned int edge) const;

    /// Squared distance of a point to its projection [mm^2].
    double distance_square(const Point<2>   &x,
                           const Projection &projection) const;

    /**
     * How far beyond the end of the surface, in edge coordinates, a point still
     * counts as facing the last edge, extrapolated. Points on a symmetry line
     * sit exactly on the end, where the tilt of the edge under load moves the
     * foot of the normal to either side.
     */
    static constexpr double overhang = 0.1;

  private:
    using Box = BoundingBox<2>;

    /// The coordinates of an edge, with the overhang at an end of the surface.
    std::pair<double, double> coordinate_range(const unsigned int edge) const;

    std::array<Point<2>, 3> edge_positions(const unsigned int edge) const;

    const Surface                      &surface;
    std::vector<Point<2>>               positions;
    std::vector<Box>                    boxes;
    RTree<std::pair<Box, unsigned int>> tree;
  };
} // namespace Contact

#endif
