/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_changes_h
#define contact_face_changes_h

#include <map>

#include "contact/mortar/face_segments.h"
#include "contact/points/contact_points.h"

namespace Contact
{
  using namespace dealii;

  /// By node of either surface, the derivatives of something by its place.
  template<typename T>
  using ByPlace = std::map<NodeDoFs<3>, T>;

  using NormalChange = ByPlace<Tensor<2, 3>>; // [1/mm]

  /// Add @p factor times what @p of has.
  void add_change(const Tensor<2, 3> &factor,
                  const NormalChange &of,
                  NormalChange       &sum);

  /**
   * The change of Surface::facet_normals() at a node of a facet, where the
   * nodes are at @p x. With the dual basis d_a of a facet's tangents the normal
   * N turns by d_N = -sum_a d_a (N . d_u,a), and so does the mean of several
   * facets. Where planes of symmetry hold @p normal, along them.
   */
  NormalChange change_of_normal(const Surface<3>            &surface,
                                const unsigned int           facet,
                                const unsigned int           a,
                                const Tensor<1, 3>          &normal,
                                const std::vector<Point<3>> &x);

  /// A normal turns along planes of symmetry.
  void keep_symmetric(const ContactPoint<3> &point, PairingChange<3> &change);

  /**
   * The change of the pairing of a point in contact with the closest place of a
   * master facet: that slides by d_y = d_u_slave - d_u_master, and the normal
   * turns with the facet and its curvature,
   *   d_n = -sum_a d_a (n . (d_u_master,a + sum_b x,ab d_b . d_y)).
   * None at the edges of the facet, and none of a point of several nodes, each
   * of which slides by itself.
   */
  PairingChange<3> change_of_projection(const ContactPoint<3> &point,
                                        const Surface<3>      &master,
                                        const GhostedVector   &u);

  /**
   * The change of the integrals of a slave node's dual function Phi over the
   * master with the nodes around: a place of the slave slides over the master
   * by d_y = d_u_slave - d_u_master, where the surfaces touch each other, and
   *   d integral Phi N_m = integral Phi grad N_m . d_y.
   * The segments, what of a facet is covered, and Phi stay.
   */
  class FaceMortarChange
  {
  public:
    using Gradients = PerFacetNode<3, Tensor<1, 3>>;

    /// Of one pair of facets: by node of the master, the derivatives by the
    /// places of the nodes of both.
    struct OfFacets
    {
      OfFacets(const unsigned int n_slave_nodes,
               const unsigned int n_master_nodes)
        : n_slave_nodes(n_slave_nodes)
        , n_master_nodes(n_master_nodes)
      {
      }

      /// A place of integration, @p phi times its weight.
      void add(const double                 phi,
               const FacetShape<3>::Values &slave_values,
               const FacetShape<3>::Values &master_values,
               const Gradients             &gradients);

      const unsigned int n_slave_nodes, n_master_nodes; // of a facet

      PerFacetNode<3, PerFacetNode<3, Tensor<1, 3>>> slave{}, master{};
    };

    void add(const SurfaceFacet<3> &slave_facet,
             const SurfaceFacet<3> &master_facet,
             const Surface<3>      &slave,
             const Surface<3>      &master,
             const OfFacets        &of_facets);

    /// By node of the master, of its integral [mm].
    std::map<unsigned int, ByPlace<Tensor<1, 3>>> integrals;
  };
} // namespace Contact

#endif
