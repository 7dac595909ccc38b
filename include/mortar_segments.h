/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_segments_h
#define contact_mortar_segments_h

#include <vector>

#include "surface_search.h"

namespace Contact
{
  using namespace dealii;

  /// A quadrature point of a segment.
  struct MortarSample
  {
    double       xi;     // on the slave edge
    double       weight; // undeformed length [mm]; of rings, area [mm^2]
    unsigned int master_edge;
    double       master_xi;
  };



  /// The part of a slave edge that faces the master.
  struct MortarOverlap
  {
    std::vector<MortarSample> samples;
    double                    low = 1, high = -1; // slave coordinates
  };



  /**
   * Slave and master in one configuration, and the segments they are cut into:
   * pieces of a slave edge that face one master edge. Projection is along the
   * continuous normal field of the slave: the mean normals of its nodes,
   * interpolated; at a node with a support in one direction (a symmetry line)
   * the normal is the free direction.
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

    std::vector<Tensor<1, 2>> slave_x, master_x; // positions of the nodes [mm]

    /// At the slave nodes, towards the slave as the normal of the master is.
    std::vector<Tensor<1, 2>> normals;

  private:
    /// The master edge that the normal of a slave node meets.
    unsigned int facing_edge(const unsigned int slave_node) const;

    void add_segment(const unsigned int slave_edge,
                     const unsigned int master_edge,
                     MortarOverlap     &overlap) const;

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
  };
} // namespace Contact

#endif
