/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_mortar_h
#define contact_face_mortar_h

#include <deal.II/base/array_view.h>

#include <boost/container/flat_map.hpp>
#include <map>
#include <optional>

#include "contact/contact_points.h"
#include "contact/face_changes.h"
#include "contact/face_segments.h"
#include "contact/mortar.h"
#include "contact/point_exchange.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The mortar discretization in space: what MortarDiscretization<2> is in the
   * plane, a contact point for each slave node whose gap is weighted by a dual
   * function.
   *
   * Integrals are over the segments, see FaceSegments, of FacetDualFunctions.
   * So the dual functions are biorthogonal also where a facet faces the master
   * in part (A. Popp, M. Gitterle, M. W. Gee and W. A. Wall, Int. J. Numer.
   * Meth. Engng. 83, 2010), and of degree 2, with the 9 nodes of a facet, all
   * D_k are positive.
   *
   * Normal, the lower limit of the gap, and the shift of the feet that balances
   * the moments are as in the plane. Derivatives are of first order in the
   * distance of the surfaces, which is zero where they matter: those of points
   * in contact.
   */
  template<>
  class MortarDiscretization<3>
  {
  public:
    MortarDiscretization(const Surface<3>             &slave,
                         const Surface<3>             &master,
                         const Discretization<3>      &discretization,
                         const std::set<unsigned int> &excluded);

    /// See MortarDiscretization<2>.
    std::vector<ContactPoint<3>>
    make_points(MultiplierSpace &multipliers) const;

    bool pair(const ArrayView<ContactPoint<3>> &points,
              const GhostedVector              &u,
              const PairingMode                &mode = {}) const;

  private:
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
      ByNode<double>   slave;  // of the coefficients
      ByNode<OfMaster> master; // of the coefficients

      /// Of the surfaces from each other, by facet.
      std::vector<const std::vector<Tensor<1, 3>> *> distances;

      /// If it is asked for; and of which normals of the master, by facet and
      /// its node, master_normal is the sum.
      std::optional<FaceMortarChange>                         change;
      std::map<std::pair<unsigned int, unsigned int>, double> normals;
    };

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

    /// The numbers of the points that have to be paired; all others get their
    /// last pairing.
    std::vector<unsigned int>
    keep_pairings(const ArrayView<ContactPoint<3>> &points,
                  const GhostedVector              &u,
                  const PairingMode                &mode) const;

    /// By slave node, whether facets that its integrals are over may touch the
    /// master.
    std::vector<bool> may_touch(const GhostedVector &u) const;

    /// The points of these numbers.
    void pair_anew(const ArrayView<ContactPoint<3>> &points,
                   const std::vector<unsigned int>  &numbers,
                   const GhostedVector              &u,
                   const bool                        with_derivatives) const;

    void integrate(const unsigned int             slave_facet,
                   const std::vector<FaceSample> &points,
                   const FaceConfiguration       &now,
                   std::vector<Tensor<1, 3>>     &distances,
                   std::vector<NodeIntegrals>    &of_nodes) const;

    /// The segments of a slave facet; what its dual functions belong to are @p
    /// carriers.
    std::vector<Segment>
    make_segments(const FacetDualFunctions           &dual,
                  const std::vector<FaceSample>      &points,
                  const FaceConfiguration            &now,
                  const std::vector<NodeIntegrals *> &carriers) const;

    void         add_slave(const unsigned int                  slave_facet,
                           const FacetDualFunctions           &dual,
                           const std::vector<FaceSample>      &points,
                           const std::vector<NodeIntegrals *> &carriers) const;
    void         add_master(const FacetDualFunctions           &dual,
                            const std::vector<Segment>         &segments,
                            const std::vector<NodeIntegrals *> &carriers) const;
    void         add_normals(const FacetDualFunctions           &dual,
                             const std::vector<Segment>         &segments,
                             const FaceConfiguration            &now,
                             const std::vector<NodeIntegrals *> &carriers) const;
    void         add_changes(const unsigned int                  slave_facet,
                             const FacetDualFunctions           &dual,
                             const std::vector<Segment>         &segments,
                             const std::vector<NodeIntegrals *> &carriers) const;
    void         fill_in(const NodeIntegrals     &integrals,
                         const unsigned int       node,
                         const FaceConfiguration &now,
                         const GhostedVector     &u,
                         ContactPoint<3>         &point) const;
    Tensor<1, 3> normal(const NodeIntegrals     &integrals,
                        const unsigned int       node,
                        const FaceConfiguration &now) const;
    /// The change of what normal() gives.
    NormalChange change_of_normal(const NodeIntegrals     &integrals,
                                  const unsigned int       node,
                                  const FaceConfiguration &now) const;
    void         differentiate(const NodeIntegrals     &integrals,
                               const unsigned int       node,
                               const FaceConfiguration &now,
                               ContactPoint<3>         &point) const;
    void         add_nodes(const NodeIntegrals &integrals,
                           const unsigned int   node,
                           ContactPoint<3>     &point) const;
    Point<3>     bulge(const NodeIntegrals &integrals) const;
    /// The feet of a point move along the master by the tau that leaves no
    /// offset r between slave and master along the tangents: tau = way r.
    Tensor<2, 3> way_of_feet(const NodeIntegrals     &integrals,
                             const FaceConfiguration &now,
                             const ContactPoint<3>   &point) const;
    Tensor<1, 3> move_feet(const NodeIntegrals     &integrals,
                           const FaceConfiguration &now,
                           ContactPoint<3>         &point) const;

    void find_carriers();

    unsigned int slave_node(const ContactPoint<3> &point) const;

    /// The displacements of the nodes of both surfaces.
    std::vector<double> motion(const GhostedVector &u) const;

    /// Whether a multiplier of one of these nodes acts on a facet.
    bool carries_any(const unsigned int       slave_facet,
                     const std::vector<bool> &nodes) const;

    const Surface<3>            &slave;
    const Surface<3>            &master;
    const Discretization<3>     &discretization;
    const std::set<unsigned int> excluded;

    /// By facet and node, see FacetDualFunctions.
    std::vector<FacetDualFunctions::Carriers> carries;

    /// By facet, see Surface::shares_of_nodes().
    std::vector<std::vector<double>> shares;

    const SymmetryPlanes planes;

    /// Who pairs which points does not change what is found.
    mutable std::optional<PointShares> point_shares;

    /// The last pairing of each point, without its derivatives, and whether it
    /// is that of the last motion. Surfaces that are where they were then have
    /// the same one, as at the start of Newton's method, and glued ones always.
    struct Last
    {
      std::vector<double>          motion;
      std::vector<double>          weights;
      std::vector<PointPairing<3>> pairings;
      std::vector<bool>            is_present;
    };
    mutable Last last;

    /// By how much the undeformed surfaces turn around each node [rad].
    std::vector<double> slave_bends, master_bends;
  };
} // namespace Contact

#endif
