/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_mortar_h
#define contact_face_mortar_h

#include <deal.II/base/array_view.h>

#include <map>

#include "contact/contact_points.h"
#include "contact/face_clipping.h"
#include "contact/mortar.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The mortar discretization in space: what MortarDiscretization<2> is in the
   * plane, a contact point for each slave node whose gap is weighted by a dual
   * function.
   *
   * Slave and master facets are projected on a plane, the one through the
   * middle of the slave facet across its normal, and clipped (M. A. Puso and T.
   * A. Laursen, Comput. Methods Appl. Mech. Engrg. 193, 2004); facets of degree
   * 2 in four parts, bilinear between their nodes. The common polygons are cut
   * into triangles with Gauss points. Integrals are over the undeformed slave.
   *
   * The dual functions of a facet are Phi_k = sum_j A_kj N_j with A = D M^-1, D
   * and M the integrals of N_k and of N_k N_j over what faces the master. So
   * they are biorthogonal also where a facet faces the master in part (A. Popp,
   * M. Gitterle, M. W. Gee and W. A. Wall, Int. J. Numer. Meth. Engng. 83,
   * 2010), and of degree 2, with the 9 nodes of a facet, all D_k are positive.
   *
   * Normal, the lower limit of the gap, and the shift of the feet that balances
   * the moments are as in the plane. Points are paired before each Newton step:
   * there are no derivatives.
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
              const Vector<double>             &u,
              const bool                        with_derivatives = false) const;

  private:
    /// A Gauss point of a segment.
    struct GaussPoint
    {
      Point<2>     slave_xi, master_xi;
      unsigned int master_facet;
      double       weight;   // of the undeformed slave [mm^2]
      Tensor<1, 3> distance; // slave less master [mm]
    };

    /// The integrals that belong to a slave node.
    struct NodeIntegrals
    {
      double                               weight = 0; // D_k [mm^2]
      Tensor<1, 3>                         master_normal;
      double                               master_bend = 0;
      std::map<unsigned int, double>       master; // of the coefficients
      std::map<unsigned int, Tensor<1, 3>> gradients;
      std::vector<Tensor<1, 3>>            distances;
    };

    /// The integrals of a slave facet's dual functions over what it shares with
    /// one master facet, by the nodes of both.
    struct Segment
    {
      unsigned int                                   master_facet;
      PerFacetNode<3, PerFacetNode<3, double>>       values;
      PerFacetNode<3, PerFacetNode<3, Tensor<1, 3>>> gradients;
    };

    /// The bodies where they are.
    struct Configuration;

    std::vector<GaussPoint> gauss_points(const unsigned int   slave_facet,
                                         const Configuration &now) const;
    void                    add_segment(const unsigned int       slave_facet,
                                        const unsigned int       master_facet,
                                        const Configuration     &now,
                                        std::vector<GaussPoint> &points) const;
    void                    integrate(const unsigned int             slave_facet,
                                      const std::vector<GaussPoint> &points,
                                      const Configuration           &now,
                                      std::vector<NodeIntegrals>    &of_nodes) const;
    void                    add_master(const GaussPoint                    &point,
                                       const std::vector<double>           &phi,
                                       const Configuration                 &now,
                                       const PerFacetNode<3, unsigned int> &slave_nodes,
                                       Segment                             &segment,
                                       std::vector<NodeIntegrals>          &of_nodes) const;
    void                    fill_in(const NodeIntegrals  &integrals,
                                    const unsigned int    node,
                                    const Configuration  &now,
                                    const Vector<double> &u,
                                    ContactPoint<3>      &point) const;

    void find_void_slip(const Configuration &now,
                        const unsigned int   node,
                        const NodeIntegrals &integrals,
                        ContactPoint<3>     &point) const;

    unsigned int slave_node(const ContactPoint<3> &point) const;

    const Surface<3>            &slave;
    const Surface<3>            &master;
    const Discretization<3>     &discretization;
    const std::set<unsigned int> excluded;

    /// By how much the undeformed surfaces turn around each node [rad].
    std::vector<double> slave_bends, master_bends;
  };
} // namespace Contact

#endif
