/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_dual_functions.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  // Functions that vanish on what faces the master have no part in it. A node
  // leaves its function to others where its gap would be extrapolated to where
  // no master is, on a strip the slope of the gap: where the master covers much
  // less of it than of another one, or where the two are nearly multiples of
  // each other on what is covered, as where a corner of the master is in the
  // middle of the facet. What is much less is between a half and a quarter, as
  // of a rim and of a corner of the master that are on the node; where it was
  // at the start of the increment is what it stays on, as far as a margin.
  void FacetDualFunctions::find_carriers(const std::vector<double> &integrals,
                                         const FullMatrix<double>  &common,
                                         const Carriers            &carries,
                                         const KeptFunctions       &at_start)
  {
    const double        much_less = 0.4, margin = 0.08, round_off = 1e-12;
    const double        of_neighbors = 1. / 3; // on a whole facet of degree 1
    std::vector<double> covered(n_nodes, 1.);  // but for a common factor
    double              sum = 0, most = 0;
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        sum += integrals[a];
        if (partly)
          covered[a] = integrals[a] * kind.hat_factors[a];
        if (!carries[a].empty())
          most = std::max(most, covered[a]);
      }
    std::vector<unsigned int> by_size, others, with_carriers;
    for (unsigned int a = 0; a < n_nodes; ++a)
      if (integrals[a] > round_off * sum)
        by_size.push_back(a);
    std::stable_sort(by_size.begin(),
                     by_size.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return covered[a] > covered[b];
                     });
    // 0 for multiples of each other, 1 for functions side by side.
    const auto difference = [&](const unsigned int a, const unsigned int b) {
      return 1 - common(a, b) * (1 / integrals[a] + 1 / integrals[b]);
    };
    for (const unsigned int a : by_size)
      {
        const double least = at_start.none()
                               ? much_less
                               : much_less + (at_start[a] ? -margin : margin);
        const bool   leaves =
          carries[a].empty() || covered[a] < least * most ||
          std::any_of(with_carriers.begin(),
                      with_carriers.end(),
                      [&](const unsigned int b) {
                        return difference(a, b) < least * of_neighbors;
                      });
        (leaves ? others : with_carriers).push_back(a);
        kept[a] = !leaves;
      }
    std::sort(with_carriers.begin(), with_carriers.end());
    for (const unsigned int a : with_carriers)
      for (const auto &carrier : carries[a])
        if (std::count(carriers.begin(), carriers.end(), carrier.first) == 0)
          carriers.push_back(carrier.first);

    dual_to_shapes =
      !piecewise && kind.part_of_sides == 0 && others.empty() &&
      std::all_of(carries.begin(),
                  carries.begin() + n_nodes,
                  [](const auto &of_node) {
                    return of_node.size() == 1 && of_node[0].second == 1;
                  });
    are_shared = !dual_to_shapes || carriers.size() < n_nodes;
    if (!are_shared)
      return;
    // They are combinations of the functions that are kept.
    dependent = carriers.size() > with_carriers.size();
    shared.reinit(carriers.size(), n_nodes);
    const auto hand_over =
      [&](const unsigned int from, const unsigned int to, const double part) {
        for (const auto &[carrier, share] : carries[to])
          shared(std::find(carriers.begin(), carriers.end(), carrier) -
                   carriers.begin(),
                 from) += share * part;
      };
    for (const unsigned int a : with_carriers)
      hand_over(a, a, 1);
    for (const unsigned int a : others)
      {
        double                    nearest = std::numeric_limits<double>::max();
        std::vector<unsigned int> receivers;
        for (const unsigned int b : with_carriers)
          {
            const double distance = kind.places[a].distance(kind.places[b]);
            if (distance < nearest)
              receivers.clear();
            nearest = std::min(nearest, distance);
            if (distance == nearest)
              receivers.push_back(b);
          }
        for (const unsigned int b : receivers)
          hand_over(a, b, 1. / receivers.size());
      }
  }



  // D = G 1, for the M_j sum up to one: the vector of the roots of D is an
  // eigenvector of H = D^-1/2 G D^-1/2, and its pseudo-inverse keeps it. So
  // with D^-1/2 H^+ D^-1/2 for G^-1 the Phi_k sum up to one, and their
  // integrals are D, as with the inverse.
  void FacetDualFunctions::invert(FullMatrix<double> &G) const
  {
    if (!dependent)
      {
        G.gauss_jordan();
        return;
      }
    const double             round_off = 1e-12;
    const unsigned int       n         = G.m();
    LAPACKFullMatrix<double> H(n);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int j = 0; j < n; ++j)
        H(k, j) = G(k, j) / std::sqrt(D[k] * D[j]);
    H.compute_inverse_svd(round_off);
    Vector<double> unit(n), column(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        unit    = 0;
        unit[j] = 1;
        H.vmult(column, unit);
        for (unsigned int k = 0; k < n; ++k)
          G(k, j) = column[k] / std::sqrt(D[k] * D[j]);
      }
  }



  FacetShape<3>::Values
  FacetDualFunctions::functions(const FacetSample &sample) const
  {
    return piecewise ? kind.hats(sample.slave_xi)
                     : kind.tests(sample.slave_values);
  }



  FacetDualFunctions::Values
  FacetDualFunctions::test_functions(const FacetSample &sample) const
  {
    Values M(are_shared ? carriers.size() : n_nodes, 0.);
    if (!are_shared)
      {
        for (unsigned int a = 0; a < n_nodes; ++a)
          M[a] = sample.slave_values[a];
        return M;
      }
    const auto all = functions(sample);
    for (unsigned int j = 0; j < carriers.size(); ++j)
      for (unsigned int a = 0; a < n_nodes; ++a)
        M[j] += shared(j, a) * all[a];
    return M;
  }



  FacetDualFunctions::Values
  FacetDualFunctions::values(const FacetSample &sample) const
  {
    const Values M = test_functions(sample);
    Values       phi(carriers.size(), 0.);
    for (unsigned int k = 0; k < phi.size(); ++k)
      for (unsigned int j = 0; j < phi.size(); ++j)
        phi[k] += A(k, j) * M[j];
    return phi;
  }
} // namespace Contact
