/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/surfaces/normal_cone.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// Whether a direction is between the normals of the two edges of a convex
    /// corner.
    bool is_between(const std::vector<Tensor<1, 2>> &normals,
                    const Tensor<1, 2>              &direction)
    {
      const Tensor<1, 2> &first = normals.front(), &last = normals.back();
      return cross(first, direction) > 0 && cross(direction, last) > 0 &&
             cross(first, last) > 0;
    }

    bool is_between(const std::vector<Tensor<1, 3>> &, const Tensor<1, 3> &)
    {
      return false;
    }
  } // namespace



  template<int dim>
  double NormalCone<dim>::largest_cosine(const Tensor<1, dim> &normal) const
  {
    double largest = -1;
    for (const Tensor<1, dim> &n : normals)
      largest = std::max(largest, -(normal * n));
    return largest;
  }



  template<int dim>
  bool NormalCone<dim>::faces(const Tensor<1, dim> &normal) const
  {
    const double largest = largest_cosine(normal);
    const double angle   = std::acos(std::clamp(largest, -1., 1.));
    // Sides that face it alike do so together.
    const double alike = numbers::PI / 360 * Surface<dim>::feature_angle;
    return std::none_of(others.begin(),
                        others.end(),
                        [&](const auto &n) {
                          return std::acos(std::clamp(-(normal * n), -1., 1.)) <
                                 angle - alike;
                        }) &&
           (largest >= smallest_cosine() || is_between(normals, -normal));
  }



  // Between the normals of a corner in 2-D anything may be.
  template<int dim>
  bool
  NormalCone<dim>::may_face(const DirectionRange<dim> &normals_of_facet) const
  {
    const double angle =
      largest_angle * numbers::PI / 180 + normals_of_facet.range;
    return (dim == 2 && normals.size() > 1) || angle >= numbers::PI ||
           largest_cosine(normals_of_facet.mean) >= std::cos(angle);
  }



  template<int dim>
  bool NormalCone<dim>::is_beside(const Tensor<1, dim> &normal) const
  {
    return largest_cosine(normal) > -smallest_cosine();
  }

  template struct NormalCone<2>;
  template struct NormalCone<3>;
} // namespace Contact
