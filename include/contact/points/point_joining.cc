/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/point_joining.h"

#include <algorithm>
#include <array>

#include "contact/points/contact_points.h"

namespace Contact
{
  namespace
  {
    /// The mean of the equations of the joined points, with their weights.
    template<int dim>
    void join_rows(const std::vector<unsigned int> &joined,
                   std::vector<ContactPoint<dim>>  &points)
    {
      ContactPoint<dim> &first  = points[joined[0]];
      double             weight = 0;
      for (const unsigned int q : joined)
        weight += points[q].weight;

      // By slave and master: the node with the multiplier first, then the
      // others in the order of the points.
      using Node = const SurfaceNode<dim> *;
      std::array<std::vector<std::pair<Node, double>>, 2> rows;
      Tensor<1, dim>                                      normal;
      Point<dim>                                          projection;
      for (const unsigned int q : joined)
        {
          const ContactPoint<dim> &point = points[q];
          const double             part  = point.weight / weight;
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            {
              auto      &row = rows[a < point.n_slave_nodes ? 0 : 1];
              const auto found =
                std::find_if(row.begin(), row.end(), [&](const auto &entry) {
                  return entry.first->dofs == point.dofs(a);
                });
              if (found == row.end())
                row.emplace_back(point.nodes[a], part * point.C[a]);
              else
                found->second += part * point.C[a];
            }
          normal += part * point.normal;
          projection += part * Tensor<1, dim>(point.projection);
        }

      first.keep_nodes(0);
      for (const auto &[node, c] : rows[0])
        first.add_node(*node, c);
      first.n_slave_nodes = first.n_nodes;
      for (const auto &[node, c] : rows[1])
        first.add_node(*node, c);
      first.weight     = weight;
      first.normal     = normal / normal.norm();
      first.projection = projection;
      set_tangents(first);
    }



    // Of C = sum w_i C_i / sum w_i, and of all other means alike. A process may
    // have the changes of some of the points: their sum over the processes is
    // that of all.
    template<int dim>
    void join_changes(const std::vector<unsigned int> &joined,
                      std::vector<ContactPoint<dim>>  &points)
    {
      ContactPoint<dim> &first = points[joined[0]];
      if (std::all_of(joined.begin(), joined.end(), [&](const auto q) {
            return points[q].change.dofs.empty();
          }))
        return;

      double weight = 0;
      for (const unsigned int q : joined)
        weight += points[q].weight;
      ContactPoint<dim> mean = first;
      join_rows(joined, points); // the order of the nodes
      std::swap(mean, first);

      PairingChange<dim> sum;
      for (const unsigned int q : joined)
        for (const auto dof : points[q].change.dofs)
          if (std::find(sum.dofs.begin(), sum.dofs.end(), dof) ==
              sum.dofs.end())
            sum.dofs.push_back(dof);
      const unsigned int n = sum.dofs.size();
      sum.C.reinit(mean.n_nodes, n);
      sum.rotation.resize(n);
      if constexpr (dim == 2)
        {
          sum.weight.resize(n);
          sum.projection.resize(n);
        }
      else
        sum.slide.resize(mean.n_nodes);
      for (const unsigned int q : joined)
        {
          const ContactPoint<dim>  &point  = points[q];
          const PairingChange<dim> &change = point.change;
          const double              part   = point.weight / weight;
          const double              offset =
            (point.projection - mean.projection) * mean.normal;
          std::vector<unsigned int> node(point.n_nodes);
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            {
              const unsigned int begin = a < point.n_slave_nodes
                                           ? 0
                                           : mean.n_slave_nodes,
                                 end   = a < point.n_slave_nodes
                                           ? mean.n_slave_nodes
                                           : mean.n_nodes;
              for (unsigned int b = begin; b < end; ++b)
                if (mean.dofs(b) == point.dofs(a))
                  node[a] = b;
            }
          std::vector<unsigned int> column(change.dofs.size());
          for (unsigned int j = 0; j < column.size(); ++j)
            column[j] =
              std::find(sum.dofs.begin(), sum.dofs.end(), change.dofs[j]) -
              sum.dofs.begin();
          for (unsigned int a = 0; a < change.slide.size(); ++a)
            sum.slide[node[a]] += part * change.slide[a];
          if (change.C.n() == 0)
            continue;
          for (unsigned int j = 0; j < column.size(); ++j)
            {
              const unsigned int k = column[j];
              for (unsigned int a = 0; a < point.n_nodes; ++a)
                sum.C(node[a], k) += part * change.C(a, j);
              for (unsigned int t = 0; t < dim - 1; ++t)
                sum.rotation[k] += part * change.rotation[j][t] *
                                   mean.tangential_part(point.tangents[t]);
              if (change.weight.empty())
                continue;
              sum.weight[k] += part * change.weight[j];
              sum.projection[k] +=
                part * (change.projection[j] + offset * change.weight[j]);
              for (unsigned int a = 0; a < point.n_nodes; ++a)
                sum.C(node[a], k) += part * point.C[a] * change.weight[j];
              for (unsigned int a = 0; a < mean.n_nodes; ++a)
                sum.C(a, k) -= part * mean.C[a] * change.weight[j];
            }
        }
      first.change = std::move(sum);
    }
  } // namespace



  template<int dim>
  void join_equations(const std::vector<unsigned int> &joined,
                      std::vector<ContactPoint<dim>>  &points)
  {
    join_changes(joined, points);
    join_rows(joined, points);
  }

  template void join_equations(const std::vector<unsigned int> &,
                               std::vector<ContactPoint<2>> &);
  template void join_equations(const std::vector<unsigned int> &,
                               std::vector<ContactPoint<3>> &);
} // namespace Contact
