/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_changes.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The projection across a unit vector.
    Tensor<2, 3> across(const Tensor<1, 3> &n)
    {
      return Tensor<2, 3>(unit_symmetric_tensor<3>()) - outer_product(n, n);
    }
  } // namespace



  void add_change(const Tensor<2, 3> &factor,
                  const NormalChange &of,
                  NormalChange       &sum)
  {
    for (const auto &[node, change] : of)
      sum[node] += factor * change;
  }



  NormalChange change_of_normal(const Surface<3>            &surface,
                                const unsigned int           facet,
                                const unsigned int           a,
                                const Tensor<1, 3>          &normal,
                                const std::vector<Point<3>> &x)
  {
    const unsigned int node = surface.facets[facet].nodes[a];
    Tensor<1, 3>       sum;
    NormalChange       of_sum;
    for (const unsigned int e : surface.smooth_around(facet, a))
      {
        const auto         &nodes = surface.facets[e].nodes;
        const FacetKind<3> &kind  = *surface.facets[e].kind;
        const FacetBasis shape(kind, kind.places[surface.number_in(e, node)]);
        std::array<Tensor<1, 3>, 2> t;
        for (unsigned int b = 0; b < kind.n_nodes; ++b)
          for (unsigned int i = 0; i < 2; ++i)
            t[i] += shape.first[i][b] * x[nodes[b]];
        const auto         d       = dual_basis(t);
        const Tensor<1, 3> outward = outward_normal(t);
        const Tensor<1, 3> N       = outward / outward.norm();
        sum += N;
        for (unsigned int b = 0; b < kind.n_nodes; ++b)
          of_sum[surface.nodes[nodes[b]].dofs] -=
            outer_product(shape.first[0][b] * d[0] + shape.first[1][b] * d[1],
                          N);
      }

    // On a plane of symmetry the mean loses its part across that.
    const Tensor<1, 3> mean   = sum / sum.norm();
    const double       along  = mean * normal;
    const Tensor<1, 3> lost   = mean - along * normal;
    const double       little = 1e-8;
    Tensor<2, 3>       factor = across(normal) / (sum.norm() * along);
    if (lost.norm() > little)
      factor = factor * across(lost / lost.norm());
    NormalChange change;
    add_change(factor, of_sum, change);
    return change;
  }



  void keep_symmetric(const ContactPoint<3> &point, PairingChange<3> &change)
  {
    for (const Tensor<1, 3> &across : point.tangents_held_by_supports)
      {
        const Tensor<1, 2> direction = point.tangential_part(across);
        for (Tensor<1, 2> &rotation : change.rotation)
          rotation -= (rotation * direction) * direction;
      }
  }



  PairingChange<3> change_of_projection(const ContactPoint<3> &point,
                                        const Surface<3>      &master,
                                        const GhostedVector   &u)
  {
    PairingChange<3> change;
    const double     round_off = 1e-10;
    if (!point.facing || point.projection_is_clipped || point.n_slave_nodes > 1)
      return change;
    const SurfaceFacet<3> &facet = master.facets[point.master_facet];
    if (facet.kind->outwardness(point.master_xi) > 1 - round_off)
      return change;
    const auto                 &nodes = facet.nodes;
    const unsigned int          n     = facet.n_nodes();
    const FacetShape<3>         shape(*facet.kind, point.master_xi);
    std::array<Tensor<1, 3>, 2> t;
    Tensor<2, 2>                bend; // n . x,ab
    for (unsigned int b = 0; b < n; ++b)
      {
        const Tensor<1, 3> x(master.position(nodes[b], u));
        const double       along = point.normal * x;
        for (unsigned int i = 0; i < 2; ++i)
          {
            t[i] += shape.first[i][b] * x;
            bend[i][i] += shape.second[i][b] * along;
          }
        bend[0][1] += shape.mixed[b] * along;
      }
    bend[1][0]           = bend[0][1];
    const auto         d = dual_basis(t);
    const Tensor<2, 3> curve =
      -1. *
      (bend[0][0] * outer_product(d[0], d[0]) +
       bend[0][1] * (outer_product(d[0], d[1]) + outer_product(d[1], d[0])) +
       bend[1][1] * outer_product(d[1], d[1]));

    // The nodes: by what the place slides with them, and the normal turns.
    std::vector<Tensor<1, 3>> slides;
    const auto                add_node = [&](const NodeDoFs<3>  &dofs,
                              const double        part,
                              const Tensor<2, 3> &turns) {
      for (unsigned int j = 0; j < 3; ++j)
        {
          const Tensor<1, 3> unit = Point<3>::unit_vector(j);
          change.dofs.push_back(dofs[j]);
          change.rotation.push_back(
            point.tangential_part((turns + part * curve) * unit));
          slides.push_back(part * unit);
        }
    };
    for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
      add_node(point.dofs(a), point.C[a], Tensor<2, 3>());
    std::map<NodeDoFs<3>, Tensor<1, 3>> gradients;
    for (unsigned int b = 0; b < n; ++b)
      {
        const Tensor<1, 3> gradient =
          shape.first[0][b] * d[0] + shape.first[1][b] * d[1];
        add_node(master.nodes[nodes[b]].dofs,
                 -shape.value[b],
                 -outer_product(gradient, point.normal));
        for (const auto &[parent, part] : master.followed_by(nodes[b]))
          gradients[master.nodes[parent].dofs] += part * gradient;
      }

    change.C.reinit(point.n_nodes, change.dofs.size());
    change.slide.resize(point.n_nodes);
    for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
      {
        change.slide[a] = -gradients[point.dofs(a)];
        for (unsigned int j = 0; j < slides.size(); ++j)
          change.C(a, j) = change.slide[a] * slides[j];
      }
    keep_symmetric(point, change);
    return change;
  }



  void
  FaceMortarChange::OfFacets::add(const double                 phi,
                                  const FacetShape<3>::Values &slave_values,
                                  const FacetShape<3>::Values &master_values,
                                  const Gradients             &gradients)
  {
    for (unsigned int m = 0; m < n_master_nodes; ++m)
      {
        const Tensor<1, 3> gradient = phi * gradients[m];
        for (unsigned int b = 0; b < n_slave_nodes; ++b)
          slave[m][b] += slave_values[b] * gradient;
        for (unsigned int b = 0; b < n_master_nodes; ++b)
          master[m][b] -= master_values[b] * gradient;
      }
  }



  void FaceMortarChange::add(const SurfaceFacet<3> &slave_facet,
                             const SurfaceFacet<3> &master_facet,
                             const Surface<3>      &slave,
                             const Surface<3>      &master,
                             const OfFacets        &of_facets)
  {
    for (unsigned int m = 0; m < master_facet.n_nodes(); ++m)
      {
        auto &of_node = integrals[master_facet.nodes[m]];
        for (unsigned int b = 0; b < slave_facet.n_nodes(); ++b)
          of_node[slave.nodes[slave_facet.nodes[b]].dofs] +=
            of_facets.slave[m][b];
        for (unsigned int b = 0; b < master_facet.n_nodes(); ++b)
          of_node[master.nodes[master_facet.nodes[b]].dofs] +=
            of_facets.master[m][b];
      }
  }
} // namespace Contact
