/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_mortar_h
#define contact_face_mortar_h

#include <deal.II/base/array_view.h>

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
              const bool                        with_derivatives = false) const;

  private:
    /// The integrals that belong to a slave node.
    struct NodeIntegrals
    {
      double                               weight = 0; // D_k [mm^2]
      Tensor<1, 3>                         master_normal;
      double                               master_bend = 0;
      std::map<unsigned int, double>       slave;  // of the coefficients
      std::map<unsigned int, double>       master; // of the coefficients
      std::map<unsigned int, Tensor<1, 3>> gradients;
      std::vector<Tensor<1, 3>>            distances;

      /// If it is asked for; and of which normals of the master, by facet and
      /// its node, master_normal is the sum.
      std::optional<FaceMortarChange>                         change;
      std::map<std::pair<unsigned int, unsigned int>, double> normals;
    };

    /// The integrals of a slave facet's dual functions over what it shares with
    /// one master facet, by dual function and node of the master.
    struct Segment
    {
      unsigned int                                   master_facet;
      PerFacetNode<3, PerFacetNode<3, double>>       values;
      PerFacetNode<3, PerFacetNode<3, Tensor<1, 3>>> gradients;

      /// By dual function, none if it is not asked for.
      std::vector<std::unique_ptr<FaceMortarChange::OfFacets>> changes;
    };

    void         integrate(const unsigned int             slave_facet,
                           const std::vector<FaceSample> &points,
                           const FaceConfiguration       &now,
                           std::vector<NodeIntegrals>    &of_nodes) const;
    static void  keep_own(PerFacetNode<3, double> &of_slave,
                          const unsigned int       own);
    void         add_master(const FaceSample                 &point,
                            const FacetDualFunctions::Values &phi,
                            const FacetShape<3>              &shape,
                            const FaceConfiguration          &now,
                            Segment                          &segment) const;
    void         add_normals(const FaceSample                   &point,
                             const FacetDualFunctions::Values   &phi,
                             const FacetShape<3>                &shape,
                             const FaceConfiguration            &now,
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

    /// Whether a multiplier of one of these nodes acts on a facet.
    bool carries_any(const unsigned int       slave_facet,
                     const std::vector<bool> &nodes) const;

    const Surface<3>            &slave;
    const Surface<3>            &master;
    const Discretization<3>     &discretization;
    const std::set<unsigned int> excluded;

    /// By facet and node, see FacetDualFunctions.
    std::vector<FacetDualFunctions::Carriers> carries;

    const SymmetryPlanes planes;

    /// Who pairs which points does not change what is found.
    mutable std::optional<PointShares> point_shares;

    /// By how much the undeformed surfaces turn around each node [rad].
    std::vector<double> slave_bends, master_bends;
  };
} // namespace Contact

#endif
