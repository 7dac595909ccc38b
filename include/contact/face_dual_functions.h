/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_dual_functions_h
#define contact_face_dual_functions_h

#include <deal.II/lac/full_matrix.h>

#include <boost/container/small_vector.hpp>

#include "contact/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A place of a facet in space, and the undeformed area that it stands for.
  struct FacetSample
  {
    Point<2> slave_xi;
    double   weight; // [mm^2]
  };



  /// The bilinear functions of the four parts of a facet of degree 2.
  FacetShape<3>::Values piecewise_bilinear(const Point<2> &xi);



  /**
   * The dual functions of a slave facet in space, over the part of it that
   * faces the master. With test functions M_j of its nodes,
   *   Phi_k = sum_j A_kj M_j,   A = D G^-1,   D_k = integral M_k,
   *                                           G_kj = integral M_k M_j,
   * so that integral Phi_k M_j = delta_kj D_k, and the Phi_k sum up to one as
   * the M_j do.
   *
   * Pressures need D_k > 0. The M_j are the shape functions, but where a facet
   * of degree 2 faces the master in part, and that takes more than half of its
   * integral from one of them, which may make it negative: there they are the
   * piecewise bilinear functions of the nine nodes. A hanging node leaves its
   * function to its heirs, of which one may be beyond the facet; and a node
   * without a multiplier, or that the master covers much less of than of
   * others, to the nearest ones that keep theirs: the M_j still sum up to one,
   * and have positive integrals.
   */
  class FacetDualFunctions
  {
  public:
    using Carriers = PerFacetNode<3, std::vector<Surface<3>::Part>>;

    /// By node with a dual function. Heirs may be beyond the facet.
    using Values = boost::container::small_vector<double, 9>;

    /**
     * @p samples are of the part that faces the master, @p shares [mm^2] the
     * integrals of the shape functions over the whole facet; @p carries are,
     * by node of the facet, the nodes of the surface with a multiplier that
     * its function belongs to, and their parts in it; none if it has none.
     */
    FacetDualFunctions(const unsigned int              degree,
                       const std::vector<FacetSample> &samples,
                       const std::vector<double>      &shares,
                       const Carriers                 &carries);

    /// The nodes of the surface that have a dual function here.
    const std::vector<unsigned int> &nodes() const
    {
      return carriers;
    }

    /// Whether the M_j are the shape functions of the nodes(), all others of
    /// the facet being zero: then integral Phi_k N_j is zero but for the own
    /// one.
    bool are_dual_to_shapes() const
    {
      return dual_to_shapes;
    }

    /// The values of their dual functions at a place, in the same order.
    Values values(const Point<2> &xi) const;

  private:
    /// The M_j before nodes without a multiplier left theirs, by node.
    FacetShape<3>::Values functions(const Point<2> &xi) const;

    /// The M_j of the carriers.
    Values test_functions(const Point<2> &xi) const;

    void find_carriers(const std::vector<double> &integrals,
                       const Carriers            &carries);

    const unsigned int        n_nodes;
    const unsigned int        degree;
    bool                      partly = false, piecewise = false;
    bool                      dual_to_shapes = false;
    std::vector<unsigned int> carriers;
    FullMatrix<double>        shared; // M_j = sum_a shared(j, a) functions[a]
    FullMatrix<double>        A;
  };
} // namespace Contact

#endif
