/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_mortar_h
#define contact_face_mortar_h

#include <deal.II/base/array_view.h>

#include <optional>

#include "contact/mortar/face_integrals.h"
#include "contact/mortar/mortar.h"
#include "contact/points/contact_points.h"
#include "contact/points/point_exchange.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The mortar discretization in 3-D: what MortarDiscretization<2> is in
   * 2-D, a contact point for each slave node whose gap is weighted by a dual
   * function.
   *
   * Integrals are over the segments, see FaceSegments, of FacetDualFunctions.
   * So the dual functions are biorthogonal also where a facet faces the master
   * in part (A. Popp, M. Gitterle, M. W. Gee and W. A. Wall, Int. J. Numer.
   * Meth. Engng. 83, 2010), and of degree 2, with the 9 nodes of a facet, all
   * D_k are positive.
   *
   * Normal, the lower limit of the gap, and the shift of the projection points
   * that balances the moments are as in 2-D. Derivatives are of first
   * order in the distance of the surfaces, which is zero where they matter:
   * those of points in contact.
   */
  template<>
  class MortarDiscretization<3>
  {
  public:
    MortarDiscretization(const Surface<3>             &slave,
                         const Surface<3>             &master,
                         const DiscretizedBodies<3>   &discretization,
                         const std::set<unsigned int> &excluded);

    /// See MortarDiscretization<2>.
    std::vector<ContactPoint<3>> make_points(MultiplierSpace &multipliers) const
    {
      return make_nodal_points(slave, excluded, multipliers);
    }

    bool pair(const ArrayView<ContactPoint<3>> &points,
              const GhostedVector              &u,
              const PairingMode                &mode,
              const BodyOverlap<3>             &bodies) const;

    /// An increment begins where the surfaces were paired last: the functions
    /// that nodes have kept there, see FacetDualFunctions.
    void begin_increment() const
    {
      kept_at_start = kept;
    }

  private:
    using NodeIntegrals = FaceIntegrals::NodeIntegrals;
    using OfMaster      = FaceIntegrals::OfMaster;

    /// The numbers of the points that have to be paired; all others get their
    /// last pairing.
    std::vector<unsigned int>
    keep_pairings(const ArrayView<ContactPoint<3>> &points,
                  const GhostedVector              &u,
                  const PairingMode                &mode) const;

    /// By slave node, whether facets that its integrals are over may be as
    /// close to the master as @p distance [mm].
    std::vector<bool> may_touch(const GhostedVector &u,
                                const double         distance) const;

    /// The points of @p numbers face nothing for now. Returns those that do, as
    /// they are close to the master.
    std::vector<unsigned int>
    leave_far_points(const ArrayView<ContactPoint<3>> &points,
                     const std::vector<unsigned int>  &numbers,
                     const GhostedVector              &u) const;

    /// The points of these numbers.
    void pair_anew(const ArrayView<ContactPoint<3>> &points,
                   const std::vector<unsigned int>  &numbers,
                   const GhostedVector              &u,
                   const bool                        with_derivatives,
                   const BodyOverlap<3>             &bodies) const;

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
    /// The projection points of a point move along the master by the tau that
    /// leaves no offset r between slave and master along the tangents: tau =
    /// way r.
    Tensor<2, 3> way_of_projections(const NodeIntegrals     &integrals,
                                    const FaceConfiguration &now,
                                    const ContactPoint<3>   &point) const;
    Tensor<1, 3> move_projections(const NodeIntegrals     &integrals,
                                  const FaceConfiguration &now,
                                  ContactPoint<3>         &point) const;

    unsigned int slave_node(const ContactPoint<3> &point) const;

    /// The displacements of the nodes of both surfaces.
    std::vector<double> motion(const GhostedVector &u) const;

    const Surface<3>            &slave;
    const Surface<3>            &master;
    const DiscretizedBodies<3>  &discretization;
    const std::set<unsigned int> excluded;

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
    const std::vector<double> slave_bends, master_bends;

    /// By facet, in its last pairing and at the start of the increment.
    mutable std::vector<KeptFunctions> kept, kept_at_start;

    const FaceIntegrals face_integrals;
  };
} // namespace Contact

#endif
