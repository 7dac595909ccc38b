/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_integrals_h
#define contact_face_integrals_h

#include <boost/container/flat_map.hpp>
#include <map>
#include <optional>

#include "contact/mortar/face_changes.h"
#include "contact/mortar/face_segments.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The integrals of the mortar discretization in 3-D, over the segments of
   * slave facets with the dual functions of their nodes, see FacetDualFunctions
   * and FaceSegments. MortarDiscretization makes contact points of them.
   */
  class FaceIntegrals
  {
  public:
    /// Of a node of the master: the integrals of a dual function times its
    /// shape function, and times the gradient of that.
    struct OfMaster
    {
      double       value = 0;
      Tensor<1, 3> gradient;
    };

    template<typename T>
    using ByNode = boost::container::flat_map<unsigned int, T>;

    /// The integrals that belong to a slave node.
    struct NodeIntegrals
    {
      double           weight = 0; // D_k [mm^2]
      Tensor<1, 3>     master_normal;
      double           master_bend = 0;
      ByNode<double>   slave;         // of the coefficients
      ByNode<OfMaster> master;        // of the coefficients
      ByNode<double>   master_facets; // its part over each [mm^2]

      /// Of the surfaces from each other, by facet.
      std::vector<const std::vector<Tensor<1, 3>> *> distances;

      /// If it is asked for; and of which normals of the master, by facet and
      /// its node, master_normal is the sum.
      std::optional<FaceMortarChange>                         change;
      std::map<std::pair<unsigned int, unsigned int>, double> normals;
    };

    /// Nodes in @p excluded have no multiplier. @p master_bends are, by node,
    /// how much the undeformed surface turns around it [rad].
    FaceIntegrals(const Surface<3>             &slave,
                  const Surface<3>             &master,
                  const std::set<unsigned int> &excluded,
                  const std::vector<double>    &master_bends);

    /// Add the integrals over a slave facet, whose samples are @p points;
    /// @p distances get those of the surfaces there. Returns the nodes that
    /// keep their functions, none where nothing faces the facet; @p at_start
    /// are those at the start of the increment.
    KeptFunctions add(const unsigned int             slave_facet,
                      const std::vector<FaceSample> &points,
                      const FaceConfiguration       &now,
                      const KeptFunctions           &at_start,
                      std::vector<Tensor<1, 3>>     &distances,
                      std::vector<NodeIntegrals>    &of_nodes) const;

    /// The nodes whose dual functions may be on a slave facet.
    std::set<unsigned int> carriers_of(const unsigned int slave_facet) const;

    /// By node of a facet, see Surface::shares_of_nodes().
    const std::vector<double> &shares_of(const unsigned int slave_facet) const
    {
      return shares[slave_facet];
    }

  private:
    /// The integrals of a slave facet's test functions over what it shares with
    /// one master facet.
    struct Segment
    {
      /// By test function: the values of the master's n nodes, and behind them
      /// the components of their gradients, n at a time.
      using Row = std::array<double, 4 * 9>;

      unsigned int     master_facet;
      std::vector<Row> rows;

      /// By dual function, none if it is not asked for.
      std::vector<std::unique_ptr<FaceMortarChange::OfFacets>> changes;
    };

    /// The segments of a slave facet; what its dual functions belong to are @p
    /// carriers.
    std::vector<Segment>
    make_segments(const unsigned int                  slave_facet,
                  const FacetDualFunctions           &dual,
                  const std::vector<FaceSample>      &points,
                  const FaceConfiguration            &now,
                  const std::vector<NodeIntegrals *> &carriers) const;

    void add_slave(const unsigned int                  slave_facet,
                   const FacetDualFunctions           &dual,
                   const std::vector<FaceSample>      &points,
                   const std::vector<NodeIntegrals *> &carriers) const;
    void add_master(const FacetDualFunctions           &dual,
                    const std::vector<Segment>         &segments,
                    const std::vector<NodeIntegrals *> &carriers) const;
    void add_normals(const FacetDualFunctions           &dual,
                     const std::vector<Segment>         &segments,
                     const FaceConfiguration            &now,
                     const std::vector<NodeIntegrals *> &carriers) const;
    void add_changes(const unsigned int                  slave_facet,
                     const FacetDualFunctions           &dual,
                     const std::vector<Segment>         &segments,
                     const std::vector<NodeIntegrals *> &carriers) const;

    void find_carriers(const std::set<unsigned int> &excluded);

    const Surface<3>          &slave;
    const Surface<3>          &master;
    const std::vector<double> &master_bends;

    /// By facet and node, see FacetDualFunctions.
    std::vector<FacetDualFunctions::Carriers> carries;

    std::vector<std::vector<double>> shares; // by facet
  };
} // namespace Contact

#endif
