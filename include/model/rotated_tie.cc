/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "model/rotated_tie.h"

#include <map>

namespace Contact
{
  namespace
  {
    /// The rotation that turns one unit vector into another, about the axis
    /// across both.
    Tensor<2, 2> rotation(const Tensor<1, 2> &from, const Tensor<1, 2> &to)
    {
      const double cosine = from * to;
      const double sine   = from[0] * to[1] - from[1] * to[0];
      return Tensor<2, 2>({{cosine, -sine}, {sine, cosine}});
    }

    // R = c I + [a x] + a a^T / (1 + c), with a = from x to and c = from . to.
    // Half a turn has no axis of its own.
    Tensor<2, 3> rotation(const Tensor<1, 3> &from, const Tensor<1, 3> &to)
    {
      const double       cosine = from * to;
      const Tensor<1, 3> a      = cross_product_3d(from, to);
      Tensor<2, 3>       R      = cosine * unit_symmetric_tensor<3>();
      if (1 + cosine < 1e-8)
        {
          Tensor<1, 3> axis;
          for (unsigned int i = 0; i < 3 && axis.norm() < 0.5; ++i)
            axis =
              cross_product_3d(from, Tensor<1, 3>(Point<3>::unit_vector(i)));
          axis /= axis.norm();
          return 2 * outer_product(axis, axis) + R;
        }
      R[0][1] -= a[2], R[1][0] += a[2];
      R[0][2] += a[1], R[2][0] -= a[1];
      R[1][2] -= a[0], R[2][1] += a[0];
      return R + outer_product(a, a) / (1 + cosine);
    }
  } // namespace



  template<int dim>
  RotatedTie<dim>::RotatedTie(const ContactModel<dim> &model,
                              GhostedVector           &solution)
    : interface(model.interface.get())
    , solution(solution)
  {
    if (interface == nullptr)
      return;
    std::vector<ContactPoint<dim>> points;
    for (const auto &contact_pair : interface->pairs)
      if (contact_pair->tied && contact_pair->has_point_per_multiplier() &&
          contact_pair->free_motions.empty() &&
          !model.elasticity->is_small_strain(
            contact_pair->slave.facets[0].body))
        {
          if (points.empty())
            points = interface->points();
          rotate(*contact_pair, points);
        }
    if (points.empty())
      return;
    drawn = interface->points();
    interface->set_points(points);
  }



  template<int dim>
  RotatedTie<dim>::~RotatedTie()
  {
    if (drawn.empty())
      return;
    interface->set_points(drawn);
    for (const auto &[index, value] : multipliers)
      solution[index] = value;
  }



  template<int dim>
  void RotatedTie<dim>::rotate(const ContactPair<dim>         &contact_pair,
                               std::vector<ContactPoint<dim>> &points)
  {
    const auto drawn_normals =
      DeformedSurface<dim>(contact_pair.slave, {}).normals();
    const auto normals =
      DeformedSurface<dim>(contact_pair.slave, solution).normals();
    std::map<NodeDoFs<dim>, unsigned int> nodes;
    for (unsigned int n = 0; n < contact_pair.slave.nodes.size(); ++n)
      nodes[contact_pair.slave.nodes[n].dofs] = n;

    for (unsigned int k = 0; k < contact_pair.n_points; ++k)
      {
        ContactPoint<dim>   &point = points[contact_pair.first_point + k];
        const unsigned int   node  = nodes.at(point.dofs(0));
        const Tensor<2, dim> R = rotation(drawn_normals[node], normals[node]);
        const auto           index = [&](const unsigned int t) {
          return interface->tangential_index(point.multipliers[0], t);
        };
        const auto of_normal = interface->normal_index(point.multipliers[0]);
        Tensor<1, dim - 1> shear;
        for (unsigned int t = 0; t < dim - 1; ++t)
          shear[t] = solution[index(t)];
        const Tensor<1, dim> traction =
          solution[of_normal] * point.normal + point.along_tangents(shear);

        point.normal = R * point.normal;
        for (Tensor<1, dim> &tangent : point.tangents)
          tangent = R * tangent;
        const auto set = [&](const auto i, const double value) {
          multipliers.emplace_back(i, solution[i]);
          solution[i] = value;
        };
        set(of_normal, traction * point.normal);
        for (unsigned int t = 0; t < dim - 1; ++t)
          set(index(t), traction * point.tangents[t]);
      }
  }

  template class RotatedTie<2>;
  template class RotatedTie<3>;
} // namespace Contact
