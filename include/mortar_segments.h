/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_segments_h
#define contact_mortar_segments_h

#include <utility>
#include <vector>

#include "surface_search.h"

namespace Contact
{
  using namespace dealii;

  /// The part of @p direction that supports leave to a node.
  Tensor<1, 2> free_part(const Tensor<1, 2>   &direction,
                         const Surface::Node  &node,
                         const Discretization &discretization);



  /// A quadrature point of a segment, or one of its ends, with no weight.
  struct MortarSample
  {
    double       xi;     // on the slave edge
    double       weight; // undeformed length [mm]; of rings, area [mm^2]
    unsigned int master_edge;
    double       master_xi;
  };



  /// What of a slave edge faces the master.
  struct MortarOverlap
  {
    /// A part of the edge, in its coordinate.
    struct Part
    {
      double low, high;
    };

    std::vector<MortarSample> samples;
    std::vector<Part>         parts; // from low to high, with holes between

    /// How far the place @p xi is from the nearest part; zero within one.
    double distance(const double xi) const;
  };



  /**
   * Slave and master in one configuration, and the segments they are cut into:
   * pieces of a slave edge that face one master edge. Projection is along the
   * normal field of the slave, which is continuous but at corners: the mean
   * normals of its nodes, interpolated; at a corner each edge has its own. At a
   * node with a support in one direction (a symmetry line) the normal is the
   * free direction.
   *
   * A line along the normal may meet several edges, of pieces that lie one
   * behind the other or of the far side of a body. Ahead of the slave, and
   * behind it, the first edge hides all others; the nearer one that is face to
   * face (class NormalCone) is the partner.
   */
  class MortarSegments
  {
  public:
    /// In the configuration @p u. The surfaces have to outlive the object.
    MortarSegments(const Surface        &slave,
                   const Surface        &master,
                   const Discretization &discretization,
                   const Vector<double> &u);

    /// What of a slave edge faces the master, with the points to integrate in.
    MortarOverlap overlap(const unsigned int slave_edge) const;

    /// A point of an edge, or its derivative along the edge.
    static Tensor<1, 2> at(const std::vector<Tensor<1, 2>> &values,
                           const Surface::Edge             &edge,
                           const std::array<double, 3>     &shape);

    using Normals = std::vector<Surface::PerEdgeNode<Tensor<1, 2>>>;

    std::vector<Tensor<1, 2>> slave_x, master_x; // positions of the nodes [mm]

    /// By edge and node, out of the master: of the slave those that it is
    /// projected along.
    Normals slave_normals, master_normals;

  private:
    /// A piece of a slave edge that faces one master edge.
    struct Segment
    {
      double       low, high; // slave coordinates
      unsigned int master_edge;
      double       distance; // in the middle [mm]
    };

    /// All of a slave edge that faces the master edges @p candidates.
    std::vector<Segment>
    segments(const unsigned int               slave_edge,
             const std::vector<unsigned int> &candidates) const;

    /// The master edge that the normal from a place of the slave meets, and
    /// how far away.
    std::pair<unsigned int, double>
    partner(const unsigned int               slave_edge,
            const double                     xi,
            const std::vector<unsigned int> &candidates) const;

    /// The master edges near the lines along the normals of a slave edge, up to
    /// a distance from it.
    std::vector<unsigned int> candidates(const unsigned int slave_edge,
                                         const double       reach) const;

    void add_samples(const unsigned int slave_edge,
                     const Segment     &segment,
                     MortarOverlap     &overlap) const;

    Tensor<1, 2> slave_normal(const unsigned int           slave_edge,
                              const std::array<double, 3> &shape) const;

    /// Where the line through @p x along @p n meets a master edge, which may
    /// be beyond its ends.
    double foot_on_edge(const Tensor<1, 2> &x,
                        const Tensor<1, 2> &n,
                        const unsigned int  master_edge) const;

    /// The slave coordinate from where the normal meets the point @p x.
    double slave_coordinate(const unsigned int  slave_edge,
                            const Tensor<1, 2> &x) const;

    const Surface      &slave;
    const Surface      &master;
    const SurfaceSearch search; // on the master
    double              size;   // of both surfaces together [mm]
  };
} // namespace Contact

#endif
