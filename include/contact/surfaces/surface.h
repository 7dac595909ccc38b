/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_h
#define contact_surface_h

#include <deal.II/base/utilities.h>

#include <optional>
#include <set>
#include <string>

#include "bodies/discretized_bodies.h"
#include "contact/surfaces/facet_shapes.h"
#include "parameters/parameters_scene.h"

namespace Contact
{
  using namespace dealii;

  /// A node of a surface.
  template<int dim>
  struct SurfaceNode
  {
    NodeDoFs<dim> dofs;
    Point<dim>    X; // reference position [mm]
  };



  /// A facet is known by the first unknowns of its vertices, in ascending
  /// order; that of a triangle has an invalid one.
  template<int dim>
  using FacetName =
    std::array<types::global_dof_index, FacetKind<dim>::max_vertices>;

  /// The name of a face of a cell at the boundary.
  template<int dim, typename Face>
  FacetName<dim> facet_name(const DiscretizedBodies<dim> &discretization,
                            const Face                   &face)
  {
    FacetName<dim> name;
    name.fill(numbers::invalid_dof_index);
    for (unsigned int v = 0; v < face->n_vertices(); ++v)
      name[v] = discretization.vertex_dofs[face->vertex_index(v)][0];
    std::sort(name.begin(), name.end());
    return name;
  }



  /**
   * A facet: in 2-D an edge, with the body to its left, in 3-D a
   * quadrangle or a triangle, whose coordinates are a right-handed system with
   * the outward normal. Its sides, of an edge its ends, are in the order of
   * deal.II.
   */
  template<int dim>
  struct SurfaceFacet
  {
    /// Something of each side.
    template<typename T>
    using PerSide = std::array<T, FacetKind<dim>::max_sides>;

    SurfaceFacet()
    {
      nodes.fill(0);
      neighbors.fill(numbers::invalid_unsigned_int);
      ends_side.fill(true);
    }

    const FacetKind<dim> *kind = nullptr;

    unsigned int n_nodes() const
    {
      return kind->n_nodes;
    }

    unsigned int n_sides() const
    {
      return kind->n_sides;
    }

    /// In the order of the shape functions.
    PerFacetNode<dim, unsigned int> nodes;
    types::material_id              body  = 0;
    unsigned int                    piece = 0; // of its body, see MeshPieces

    /// The connected part of the mesh it belongs to, which may be of several
    /// bodies, or a part of one.
    unsigned int part = 0;

    /// The middle of the curve or the surface that the facet stands for,
    /// undeformed [mm].
    Point<dim> middle;

    /// The level of refinement of its cell; 0: a facet of the coarse mesh.
    unsigned int level = 0;

    /// The cell of the coarse mesh that its cell is a part of.
    unsigned int coarse_cell = 0;

    /// The same of all surfaces that have it.
    FacetName<dim> name;

    /// The facets across the sides, invalid where the surface ends.
    PerSide<unsigned int> neighbors;

    bool ends_surface(const unsigned int side) const
    {
      return neighbors[side] == numbers::invalid_unsigned_int;
    }

    /// The node at the first, or the other, end of a side of a face.
    unsigned int end_of_side(const unsigned int side,
                             const unsigned int end) const
    {
      return nodes[kind->sides[side].ends[end]];
    }

    /// Where a corner is between the two.
    PerSide<bool> corner{};

    /// A face ends where the surface ends, and at convex corners: beyond them
    /// nothing faces it.
    PerSide<bool> ends_side;

    /// Of a slave, whether the body goes on in front of it, in whatever group.
    PerSide<bool> is_hollow{};

    /// In 2-D, feature nodes: corners, and kinks from half of
    /// Surface::feature_angle on that stand alone. Those of a curve that the
    /// mesh has drawn as a polygon do not.
    PerSide<bool> is_feature{};
  };

  /// The manner in which a surface is read: as it is, or cut into smooth sides.
  enum class SurfaceCut
  {
    none,
    into_sides
  };



  /**
   * A boundary of the bodies: in 2-D a chain of straight or parabolic
   * edges, in 3-D quadrangles and triangles of degree 1 or 2.
   *
   * A slave is cut into smooth sides at its feature nodes and corners. A mesh
   * node there is a surface node on each of its sides: it has the same unknowns
   * on all of them, but a normal, a dual function, a weight and a multiplier on
   * each. Facets of different sides are no neighbors, and a side ends where it
   * is cut.
   */
  template<int dim>
  class Surface
  {
  public:
    /**
     * Two facets that meet, undeformed, at an angle of more than this [degrees]
     * make a corner: each has a normal of its own there. Less is a curve that
     * the mesh has drawn as a polygon, with one normal at each node. Contact
     * codes and mesh generators draw the line between 20 and 40 degrees; here
     * it is between the regular polygons of 10 and 11 sides, so that no regular
     * one is on it, and an arc of 90 degrees in three edges is a curve.
     */
    static constexpr double feature_angle = 35;

    /// The sine of the largest angle between a normal and a plane of symmetry
    /// at which the surface has no corner with its mirror image.
    static double sine_of_smooth_slant()
    {
      return std::sin(numbers::PI / 360 * feature_angle);
    }

    /// Throws InputError if there is no facet.
    Surface(const DiscretizedBodies<dim>       &discretization,
            const std::set<types::boundary_id> &boundary_ids,
            const std::string                  &name,
            const SurfaceCut                    cut = SurfaceCut::none);

    /// The whole boundary of a connected part of the mesh.
    Surface(const DiscretizedBodies<dim> &discretization,
            const unsigned int            part);

    /// Those of the discretization.
    Counters &counters() const
    {
      return discretization.counters;
    }

    const unsigned int             degree;
    std::vector<SurfaceNode<dim>>  nodes;  // in 2-D along the chain
    std::vector<SurfaceFacet<dim>> facets; // likewise

    /// The facets that meet at each node.
    std::vector<std::vector<unsigned int>> facets_of_node;

    /// A node and its part in another one.
    using Part = std::pair<unsigned int, double>;

    /// The nodes that a hanging node follows, those of the side of a larger
    /// facet that it is on; none of a node that does not hang. In 3-D.
    std::vector<std::vector<Part>> parents;

    /// The same, or the node itself.
    std::vector<Part> followed_by(const unsigned int node) const;

    /// The nodes that a node hands over to what is its own, as a multiplier:
    /// itself, or of a hanging node the nearest two that it follows, by halves.
    /// Unlike the parts of the parents at degree 2 these are positive.
    std::vector<Part> receivers(const unsigned int node) const;

    /// The largest angle by which one edge turns against the one before it
    /// [degrees], of those that are no corners. In 2-D.
    double largest_bend() const;

    /// By how much the curves turn that two edges stand for, where an edge
    /// begins, to the left [rad]: on an arc of any number of edges not at all.
    /// In 2-D.
    double turn_of_curves(const unsigned int edge) const;

    /// By how much the undeformed surface turns at each node, from the middle
    /// of the edge before it to the middle of the edge behind it [rad]; at an
    /// end by a right angle. In 2-D.
    std::vector<double> turning_angles;

    /// The nodes of an edge in 2-D.
    unsigned int n_nodes_per_edge() const
    {
      return degree + 1;
    }

    /// Current position of a node; of an empty vector the undeformed one.
    Point<dim> position(const unsigned int node, const GhostedVector &u) const;

    std::vector<Point<dim>> positions(const GhostedVector &u) const;

    /// The outward unit normal at a node: the mean of those of the facets that
    /// meet there.
    Tensor<1, dim> normal_at(const unsigned int   node,
                             const GhostedVector &u) const;

    /// The number of a node among those of a facet around it.
    unsigned int number_in(const unsigned int facet,
                           const unsigned int node) const
    {
      const auto &of_facet = facets[facet].nodes;
      return std::find(of_facet.begin(), of_facet.end(), node) -
             of_facet.begin();
    }

    /// The facets around a node of a facet that no corner parts from it.
    std::vector<unsigned int> smooth_around(const unsigned int facet,
                                            const unsigned int a) const;

    /// By facet and node smooth_around(), where that is not all facets around
    /// the node; else nothing.
    std::vector<PerFacetNode<dim, std::vector<unsigned int>>> parted;

    /// The undeformed place of a facet [mm].
    Point<dim> reference_place(const unsigned int     facet,
                               const FacetPoint<dim> &xi) const
    {
      const auto values = FacetShape<dim>::values(*facets[facet].kind, xi);
      Point<dim> X;
      for (unsigned int a = 0; a < facets[facet].n_nodes(); ++a)
        X += values[a] * nodes[facets[facet].nodes[a]].X;
      return X;
    }

    /// The size of a facet, undeformed [mm]: the distance of the ends of an
    /// edge, the shortest side of a triangle, the shorter one of the diagonals
    /// of a quadrangle by the root of two.
    double reference_length(const unsigned int facet) const;

    /// The length that the digits of a mesh file do not resolve there [mm].
    double unresolved_length(const unsigned int facet) const
    {
      return 1e-9 * reference_length(facet);
    }

    /// The measure of integrals per unit of a facet's coordinates, undeformed:
    /// length [mm] or area; of rings the area [mm^2].
    template<typename Number>
    Number reference_jacobian(const SurfaceFacet<dim>        &facet,
                              const FacetShapes<dim, Number> &shape) const;

    /// The deformed by the undeformed area, in 2-D length, of rings both with
    /// their circumferences: at a place of a facet, and at all nodes as the
    /// mean over their facets [-].
    double              stretch_at(const unsigned int     facet,
                                   const FacetPoint<dim> &xi,
                                   const GhostedVector   &u) const;
    std::vector<double> stretches(const GhostedVector &u) const;

    /// The integrals of the test functions of a facet, see FacetKind::tests(),
    /// undeformed [mm^2]. In 3-D.
    std::vector<double> shares_of_nodes(const unsigned int facet) const;

    /// Arc length of all nodes from the first one [mm], from the positions
    /// @p x of the nodes. In 2-D.
    std::vector<double> arc_length(const std::vector<Point<2>> &x) const;

  private:
    void collect_facets(const std::set<types::boundary_id> &boundary_ids,
                        const std::optional<unsigned int>   part = {});

    /// The order of the facets, how they hang together, and the corners: what
    /// differs between the plane (surface_chain.cc) and space
    /// (surface_sides.cc).
    void arrange();

    /// The measure with other positions of the nodes, by their numbers.
    template<typename Number, typename Positions>
    Number jacobian(const SurfaceFacet<dim>        &facet,
                    const FacetShapes<dim, Number> &shape,
                    const Positions                &position) const;

    void collect_facets_of_nodes();
    void find_parted();

    /// Cut the surface into its smooth sides: the nodes, and what is different
    /// in 2-D and in 3-D, the links of the facets.
    void cut_into_sides();
    void copy_nodes_of_sides();
    void cut_links();
    void find_hollow_sides();

    /// The facets around a node of a facet that are on the same side.
    std::vector<unsigned int> same_side(const unsigned int facet,
                                        const unsigned int a) const;

    const DiscretizedBodies<dim> &discretization;
  };



  template<>
  void Surface<2>::arrange();
  template<>
  void Surface<3>::arrange();
  template<>
  std::vector<unsigned int> Surface<2>::same_side(const unsigned int edge,
                                                  const unsigned int a) const;
  template<>
  std::vector<unsigned int> Surface<3>::same_side(const unsigned int facet,
                                                  const unsigned int a) const;
  template<>
  void Surface<2>::cut_links();
  template<>
  void Surface<3>::cut_links();



  template<int dim>
  template<typename Number>
  Number
  Surface<dim>::reference_jacobian(const SurfaceFacet<dim>        &facet,
                                   const FacetShapes<dim, Number> &shape) const
  {
    return jacobian(facet, shape, [this](const unsigned int n) {
      return nodes[n].X;
    });
  }



  template<int dim>
  template<typename Number, typename Positions>
  Number Surface<dim>::jacobian(const SurfaceFacet<dim>        &facet,
                                const FacetShapes<dim, Number> &shape,
                                const Positions                &position) const
  {
    Tensor<1, dim, Number>                      x;
    std::array<Tensor<1, dim, Number>, dim - 1> tangents;
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      {
        const Tensor<1, dim> x_a(position(facet.nodes[a]));
        x += shape.value[a] * x_a;
        for (unsigned int k = 0; k < dim - 1; ++k)
          tangents[k] += shape.derivative(a, k) * x_a;
      }
    const Tensor<1, dim, Number> normal = outward_normal(tangents);
    using std::sqrt;
    return sqrt(normal * normal) * discretization.circumference_at(x[0]);
  }
} // namespace Contact

#endif
