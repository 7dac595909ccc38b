/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The derivatives of the pairing of a mortar point in 3-D.

#include <algorithm>

#include "contact/mortar/face_mortar.h"

namespace Contact
{
  NormalChange
  MortarDiscretization<3>::change_of_normal(const NodeIntegrals     &integrals,
                                            const unsigned int       node,
                                            const FaceConfiguration &now) const
  {
    const auto across = [](const Tensor<1, 3> &v) {
      return (Tensor<2, 3>(unit_symmetric_tensor<3>()) -
              outer_product(v, v) / v.norm_square()) /
             v.norm();
    };
    NormalChange of_slave, of_master, change;
    Tensor<1, 3> slave_normal;
    const auto   one = Tensor<2, 3>(unit_symmetric_tensor<3>());
    for (const unsigned int e : slave.facets_of_node[node])
      {
        const auto        &nodes = slave.facets[e].nodes;
        const unsigned int a =
          std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
        slave_normal += now.slave_normals[e][a];
        add_change(one,
                   Contact::change_of_normal(slave,
                                             e,
                                             a,
                                             now.slave_normals[e][a],
                                             now.slave_x),
                   of_slave);
      }
    const double flat = 1e-8, bend = slave_bends[node];
    if (bend <= flat)
      {
        add_change(-across(slave_normal), of_slave, change);
        return change;
      }
    std::map<unsigned int, Tensor<1, 3>> normals;
    for (const auto &[place, integral] : integrals.normals)
      {
        const auto &[e, b]                 = place;
        normals[master.facets[e].nodes[b]] = now.master_normals[e][b];
        add_change(integral * one,
                   Contact::change_of_normal(master,
                                             e,
                                             b,
                                             now.master_normals[e][b],
                                             now.master_x),
                   of_master);
      }
    for (const auto &[m, places] : integrals.change->integrals)
      for (const auto &[dofs, derivative] : places)
        of_master[dofs] += outer_product(normals.at(m), derivative);

    const double of_bend =
      std::max(0., integrals.master_bend / integrals.weight);
    const Tensor<1, 3> sum =
      -of_bend * of_bend * slave_normal / slave_normal.norm() +
      bend * bend * integrals.master_normal / integrals.master_normal.norm();
    const Tensor<2, 3> outer = across(sum);
    add_change(-of_bend * of_bend * outer * across(slave_normal),
               of_slave,
               change);
    add_change(bend * bend * outer * across(integrals.master_normal),
               of_master,
               change);
    return change;
  }



  // Nodes that hang are still in the places, not among those of the point.
  void MortarDiscretization<3>::differentiate(const NodeIntegrals &integrals,
                                              const unsigned int   node,
                                              const FaceConfiguration &now,
                                              ContactPoint<3> &point) const
  {
    const NormalChange    turns = change_of_normal(integrals, node, now);
    ByPlace<unsigned int> columns;
    const auto            add_place = [&](const NodeDoFs<3> &dofs) {
      if (columns.try_emplace(dofs, point.change.dofs.size()).second)
        point.change.dofs.insert(point.change.dofs.end(),
                                 dofs.begin(),
                                 dofs.end());
    };
    for (const auto &place : turns)
      add_place(place.first);
    for (const auto &of_node : integrals.change->integrals)
      for (const auto &place : of_node.second)
        add_place(place.first);

    PairingChange<3> &change = point.change;
    change.C.reinit(point.n_nodes, change.dofs.size());
    change.rotation.resize(change.dofs.size());
    change.slide.resize(point.n_nodes);
    for (const auto &[dofs, turn] : turns)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int t = 0; t < 2; ++t)
          for (unsigned int j = 0; j < 3; ++j)
            change.rotation[columns.at(dofs) + j][t] +=
              point.tangents[t][i] * turn[i][j];

    // By column, the change of the offset along the tangents, which the
    // projection points follow.
    std::vector<Tensor<1, 3>> offset(change.dofs.size());
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      if (const auto column = columns.find(point.dofs(a));
          column != columns.end())
        for (unsigned int j = 0; j < 3; ++j)
          offset[column->second + j][j] += point.C[a];
    for (const auto &[m, places] : integrals.change->integrals)
      for (const auto &[dofs, derivative] : places)
        for (unsigned int j = 0; j < 3; ++j)
          offset[columns.at(dofs) + j] -=
            derivative[j] / integrals.weight * now.master_x[m];
    const Tensor<2, 3> way = way_of_projections(integrals, now, point);

    std::map<NodeDoFs<3>, unsigned int> rows;
    for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
      rows[point.dofs(a)] = a;
    for (const auto &[m, places] : integrals.change->integrals)
      for (const auto &[n, part] : master.followed_by(m))
        {
          const unsigned int a      = rows.at(master.nodes[n].dofs);
          const double       factor = part / integrals.weight;
          change.slide[a] -= factor * integrals.master.at(m).gradient;
          for (const auto &[dofs, derivative] : places)
            for (unsigned int j = 0; j < 3; ++j)
              change.C(a, columns.at(dofs) + j) -= factor * derivative[j];
          for (unsigned int j = 0; j < offset.size(); ++j)
            change.C(a, j) -=
              factor * (integrals.master.at(m).gradient * (way * offset[j]));
        }
    keep_symmetric(point, change);
  }
} // namespace Contact
