/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/slave_corners.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  namespace
  {
    /// The number of a node in a facet.
    template<int dim>
    unsigned int number_in(const Surface<dim> &surface,
                           const unsigned int  facet,
                           const unsigned int  node)
    {
      const auto &nodes = surface.facets[facet].nodes;
      return std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    }
  } // namespace



  template<int dim>
  double SlaveCorner::part_of(const Side              &side,
                              const Tensor<1, dim>    &normal,
                              const FacetNormals<dim> &normals) const
  {
    const auto angle_to = [&](const Side &side) {
      return std::acos(
        std::clamp(-(normal * normal_of(side, normals)), -1., 1.));
    };
    double least = numbers::PI;
    for (const Side &other : sides)
      least = std::min(least, angle_to(other));
    const double corner = numbers::PI / 180 * Surface<dim>::feature_angle;
    return std::max(0., 1 - (angle_to(side) - least) / corner);
  }



  template<int dim>
  double SlaveCorner::weight_towards(const Tensor<1, dim>    &normal,
                                     const FacetNormals<dim> &normals) const
  {
    double weight = 0;
    for (const Side &side : sides)
      weight += part_of(side, normal, normals) * side.weight;
    return weight;
  }



  // The weight of a point has parts of nodes that hang: all sides alike.
  template<int dim>
  std::vector<SlaveCorner>
  find_corners(const Surface<dim>                   &slave,
               const MultiplierSpace                &multipliers,
               const std::vector<ContactPoint<dim>> &points)
  {
    std::vector<SlaveCorner> corners;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      {
        const auto sides = slave.sides_of_node(i);
        if (sides.size() < 2 ||
            multipliers.of_node[i] == numbers::invalid_unsigned_int)
          continue;
        SlaveCorner corner{i, multipliers.of_node[i], {}};
        double      sum = 0;
        for (const auto &facets : sides)
          {
            typename SlaveCorner::Side side{facets,
                                            number_in(slave, facets[0], i)};
            for (const unsigned int e : facets)
              side.weight += share_of_node(slave, e, number_in(slave, e, i));
            sum += side.weight;
            corner.sides.push_back(side);
          }
        for (auto &side : corner.sides)
          side.weight *= points[corner.own].weight / sum;
        corners.push_back(corner);
      }
    return corners;
  }



  template<int dim>
  void weigh(const std::vector<SlaveCorner>     &corners,
             const FacetNormals<dim>            &normals,
             const ArrayView<ContactPoint<dim>> &points)
  {
    for (const SlaveCorner &corner : corners)
      {
        ContactPoint<dim> &own = points[corner.own];
        own.weight             = corner.weight_towards(own.normal, normals);
      }
  }

  template double SlaveCorner::part_of(const Side &,
                                       const Tensor<1, 2> &,
                                       const FacetNormals<2> &) const;
  template double SlaveCorner::part_of(const Side &,
                                       const Tensor<1, 3> &,
                                       const FacetNormals<3> &) const;
  template double SlaveCorner::weight_towards(const Tensor<1, 2> &,
                                              const FacetNormals<2> &) const;
  template double SlaveCorner::weight_towards(const Tensor<1, 3> &,
                                              const FacetNormals<3> &) const;
  template std::vector<SlaveCorner>
  find_corners(const Surface<2> &,
               const MultiplierSpace &,
               const std::vector<ContactPoint<2>> &);
  template std::vector<SlaveCorner>
                find_corners(const Surface<3> &,
                             const MultiplierSpace &,
                             const std::vector<ContactPoint<3>> &);
  template void weigh(const std::vector<SlaveCorner> &,
                      const FacetNormals<2> &,
                      const ArrayView<ContactPoint<2>> &);
  template void weigh(const std::vector<SlaveCorner> &,
                      const FacetNormals<3> &,
                      const ArrayView<ContactPoint<3>> &);
} // namespace Contact
