/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_dual_functions_h
#define contact_face_dual_functions_h

#include <deal.II/lac/full_matrix.h>

#include <bitset>
#include <boost/container/small_vector.hpp>

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A place of a facet in 3-D, the shape functions there, and the undeformed
  /// area that it stands for.
  struct FacetSample
  {
    Point<2>              slave_xi;
    FacetShape<3>::Values slave_values;
    double                weight; // [mm^2]
  };



  /// By node of a slave facet, whether it keeps its function, see
  /// FacetDualFunctions; none does where nothing faces the facet.
  using KeptFunctions = std::bitset<9>;



  /**
   * The dual functions of a slave facet in 3-D, over the part of it that
   * faces the master. With test functions M_j of its nodes,
   *   Phi_k = sum_j A_kj M_j,   A = D G^-1,   D_k = integral M_k,
   *                                           G_kj = integral M_k M_j,
   * so that integral Phi_k M_j = delta_kj D_k, and the Phi_k sum up to one as
   * the M_j do.
   *
   * Pressures need D_k > 0. The M_j are FacetKind::tests(), the shape functions
   * but of 6 nodes. Where a facet of degree 2 faces the master in part, and
   * that takes more than half of its integral from one of them, which may make
   * it negative, they are FacetKind::hats(), (bi)linear between the nodes. A
   * hanging node leaves its
   * function to its receivers, of which one may be beyond the facet; and a node
   * without a multiplier, or that the master covers much less of than of
   * others, or whose function is there nearly a multiple of another one, to the
   * nearest ones that keep theirs: the M_j still sum up to one, and have
   * positive integrals. Where a hanging node alone keeps its function, its
   * receivers have multiples of one M_j: with a pseudo-inverse of G they have
   * the same multiples of one Phi_k, which sum up to one as well.
   *
   * The gap of a node jumps where it leaves its function or gets it back. It
   * does so but once in an increment: what was at the start of it stays, unless
   * the master covers the facet clearly otherwise.
   */
  class FacetDualFunctions
  {
  public:
    using Carriers = PerFacetNode<3, std::vector<Surface<3>::Part>>;

    /// By node with a dual function. Heirs may be beyond the facet.
    using Values = boost::container::small_vector<double, 9>;

    /**
     * @p samples are of the part that faces the master, @p shares [mm^2] the
     * integrals of the test functions over the whole facet; @p carries are,
     * by node of the facet, the nodes of the surface with a multiplier that
     * its function belongs to, and their parts in it; none if it has none. @p
     * at_start are the nodes that kept theirs when the increment began.
     */
    template<typename Sample>
    FacetDualFunctions(const FacetKind<3>        &kind,
                       const std::vector<Sample> &samples,
                       const std::vector<double> &shares,
                       const Carriers            &carries,
                       const KeptFunctions       &at_start = {});

    /// The nodes of the surface that have a dual function here.
    const std::vector<unsigned int> &nodes() const
    {
      return carriers;
    }

    /// Those of the facet that keep their functions.
    const KeptFunctions &kept_functions() const
    {
      return kept;
    }

    /// Whether the M_j are the shape functions of the nodes(), all others of
    /// the facet being zero: then integral Phi_k N_j is zero but for the own
    /// one.
    bool are_dual_to_shapes() const
    {
      return dual_to_shapes;
    }

    /// The values of their dual functions at a place, in the same order.
    Values values(const FacetSample &sample) const;

    /// Those of the M_j.
    Values test_functions(const FacetSample &sample) const;

    /// The A_kj, by which sums of the M_j become those of the Phi_k.
    const FullMatrix<double> &coefficients() const
    {
      return A;
    }

    /// The D_k.
    const Vector<double> &integrals() const
    {
      return D;
    }

  private:
    /// The M_j before nodes without a multiplier left theirs, by node.
    FacetShape<3>::Values functions(const FacetSample &sample) const;

    /// The @p integrals of the functions M_a, and what two of them have in @p
    /// common, integral M_a M_b / (M_a + M_b), on a facet that is covered in
    /// part: multiples of each other have a half of their harmonic mean.
    void find_carriers(const std::vector<double> &integrals,
                       const FullMatrix<double>  &common,
                       const Carriers            &carries,
                       const KeptFunctions       &at_start);

    /// G becomes its inverse; where the M_j depend on each other, a
    /// pseudo-inverse.
    void invert(FullMatrix<double> &G) const;

    const FacetKind<3>       &kind;
    const unsigned int        n_nodes;
    bool                      partly = false, piecewise = false;
    bool                      dual_to_shapes = false;
    bool                      are_shared = true;  // or shared is the identity
    bool                      dependent  = false; // the M_j
    KeptFunctions             kept;
    std::vector<unsigned int> carriers;
    FullMatrix<double>        shared; // M_j = sum_a shared(j, a) functions[a]
    FullMatrix<double>        A;
    Vector<double>            D;
  };



  template<typename Sample>
  FacetDualFunctions::FacetDualFunctions(const FacetKind<3>        &kind,
                                         const std::vector<Sample> &samples,
                                         const std::vector<double> &shares,
                                         const Carriers            &carries,
                                         const KeptFunctions       &at_start)
    : kind(kind)
    , n_nodes(kind.n_nodes)
  {
    const auto integrals = [&]() {
      std::vector<double> sums(n_nodes, 0.);
      for (const FacetSample &sample : samples)
        {
          const auto values = functions(sample);
          for (unsigned int a = 0; a < n_nodes; ++a)
            sums[a] += sample.weight * values[a];
        }
      return sums;
    };
    std::vector<double> of_functions = integrals();
    for (unsigned int a = 0; a < n_nodes; ++a)
      partly = partly || of_functions[a] < shares[a] / 2;
    piecewise = kind.degree == 2 && partly;
    if (piecewise)
      of_functions = integrals();
    FullMatrix<double> common(n_nodes, n_nodes);
    for (const FacetSample &sample : samples)
      if (partly)
        {
          const auto values = functions(sample);
          for (unsigned int a = 0; a < n_nodes; ++a)
            for (unsigned int b = 0; b < n_nodes; ++b)
              if (const double sum = values[a] + values[b]; sum > 0)
                common(a, b) += sample.weight * values[a] * values[b] / sum;
        }
    find_carriers(of_functions, common, carries, at_start);

    const unsigned int n = carriers.size();
    if (n == 0)
      return;
    FullMatrix<double> G(n, n);
    D.reinit(n);
    for (const FacetSample &sample : samples)
      {
        const Values M = test_functions(sample);
        for (unsigned int k = 0; k < n; ++k)
          {
            const double of_k = sample.weight * M[k];
            D[k] += of_k;
            for (unsigned int j = 0; j < n; ++j)
              G(k, j) += of_k * M[j];
          }
      }
    invert(G);
    A.reinit(n, n);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        A(k, j) = D[k] * G(k, j);
  }
} // namespace Contact

#endif
