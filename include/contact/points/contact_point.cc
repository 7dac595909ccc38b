/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/contact_point.h"

#include <algorithm>
#include <limits>

namespace Contact
{
  template<int dim>
  void PointPairing<dim>::add_node(const SurfaceNode<dim> &node,
                                   const double            c,
                                   const double            c1,
                                   const double            c2)
  {
    ++n_nodes;
    nodes.push_back(&node);
    C.push_back(c);
    if constexpr (dim == 2)
      {
        C1.push_back(c1);
        C2.push_back(c2);
      }
  }



  template<int dim>
  double PointPairing<dim>::gap_round_off() const
  {
    double largest = 0;
    for (const SurfaceNode<dim> *node : nodes)
      largest = std::max(largest, node->X.norm());
    return 1e3 * std::numeric_limits<double>::epsilon() * largest;
  }



  template<int dim>
  void PointPairing<dim>::keep_nodes(const unsigned int n)
  {
    n_nodes = n;
    nodes.resize(n);
    for (auto *values : {&C, &C1, &C2})
      values->resize(std::min<std::size_t>(n, values->size()));
  }



  template<int dim>
  void PointPairing<dim>::remove_node(const unsigned int n)
  {
    --n_nodes;
    nodes.erase(nodes.begin() + n);
    for (auto *values : {&C, &C1, &C2})
      if (n < values->size())
        values->erase(values->begin() + n);
  }



  template<int dim>
  std::vector<Tensor<1, dim>> ContactPoint<dim>::directions_of_slip() const
  {
    std::vector<Tensor<1, dim>> directions = this->tangents_held_by_supports;
    const Tensor<2, dim - 1>    compliance = stick_compliance();
    for (unsigned int t = 0; t < dim - 1; ++t)
      add_orthonormal(this->along_tangents(compliance[t]), directions);
    const unsigned int n_others = directions.size();
    for (unsigned int i = 0; i < dim; ++i)
      add_orthonormal(Tensor<1, dim>(Point<dim>::unit_vector(i)), directions);
    directions.erase(directions.begin(), directions.begin() + n_others);
    return directions;
  }



  template<int dim>
  Tensor<2, dim - 1> ContactPoint<dim>::stick_compliance() const
  {
    if (!is_in_an_edge)
      return this->rim_compliance;
    Tensor<2, dim - 1> all = unit_symmetric_tensor<dim - 1>();
    for (const Tensor<1, dim> &across : this->tangents_held_by_supports)
      {
        const Tensor<1, dim - 1> held = this->tangential_part(across);
        all -= outer_product(held, held);
      }
    return all;
  }



  template struct PointPairing<2>;
  template struct PointPairing<3>;
  template struct ContactPoint<2>;
  template struct ContactPoint<3>;
} // namespace Contact
