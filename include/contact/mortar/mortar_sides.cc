/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Which side of a corner of the slave faces which face of the master.

#include <algorithm>
#include <cmath>

#include "contact/mortar/mortar_geometry.h"
#include "contact/surfaces/surface_search.h"

namespace Contact
{
  // Without a corner, or where this side is the one most opposite to the
  // master, there is nothing to differentiate.
  template<typename Number>
  Number MortarGeometry<Number>::part_of_side(const unsigned int slave_facet,
                                              const unsigned int master_facet,
                                              const Number &master_xi) const
  {
    const SurfaceFacet<2> &edge = slave.facets[slave_facet];
    Number                 part = 1;
    for (unsigned int a = 0; a < 2; ++a)
      {
        const unsigned int other = a == 0 ? edge.previous : edge.next;
        if (!edge.parts_sides[a] || other == numbers::invalid_unsigned_int)
          continue;
        const EdgeShapes<Number>   shape(master.degree, master_xi);
        const Tensor<1, 2, Number> along =
          at(master_x, master.facets[master_facet], shape.first);
        const auto angle_to = [&](const Tensor<1, 2, Number> &normal) {
          using std::atan2;
          const Number angle =
            atan2(Number(normal * along), Number(cross(normal, along)));
          return Number(value_of(angle) < 0 ? -angle : angle);
        };
        const double degree = numbers::PI / 180;
        const Number own    = angle_to(slave_normals[slave_facet][a]);
        const Number beside =
          1 - (own - angle_to(slave_normals[other][1 - a])) /
                (degree * Surface<2>::feature_angle);
        const Number alone = (degree * NormalCone<2>::largest_angle - own) /
                             (degree * Surface<2>::feature_angle);
        const Number of_corner =
          value_of(beside) > value_of(alone) ? beside : alone;
        if (value_of(of_corner) < value_of(part))
          part = of_corner;
        const Number turn = turn_between(a == 0 ? other : slave_facet,
                                         a == 0 ? slave_facet : other);
        if (value_of(turn) > 0 &&
            has_closer_face(slave_facet, a, master_facet, value_of(own)))
          {
            const Number of_side =
              1 - (own - angle_to(slave_normals[other][1 - a])) / (turn / 2);
            if (value_of(of_side) < value_of(part))
              part = of_side;
          }
      }
    return value_of(part) > 0 ? part : Number(0);
  }



  template<typename Number>
  Number MortarGeometry<Number>::turn_between(const unsigned int before,
                                              const unsigned int after) const
  {
    using std::atan2;
    const Tensor<1, 2, Number> &n = slave_normals[before][1],
                               &m = slave_normals[after][0];
    return atan2(Number(cross(n, m)), Number(n * m));
  }



  template<typename Number>
  bool MortarGeometry<Number>::has_closer_face(const unsigned int slave_facet,
                                               const unsigned int a,
                                               const unsigned int master_facet,
                                               const double       angle) const
  {
    const Tensor<1, 2> normal = value_of(slave_normals[slave_facet][a]);
    const auto        &faces  = faces_beyond[master_facet];
    return std::any_of(faces.begin(), faces.end(), [&](const auto &end) {
      return end.first != numbers::invalid_unsigned_int &&
             normal * value_of(master_normals[end.first][end.second]) >
               std::cos(angle);
    });
  }



  // From each concave corner along the faces on both sides of it.
  template<typename Number>
  void MortarGeometry<Number>::find_faces_beyond()
  {
    faces_beyond.assign(master.facets.size(),
                        {{{numbers::invalid_unsigned_int, 0},
                          {numbers::invalid_unsigned_int, 1}}});
    for (unsigned int e = 0; e < master.facets.size(); ++e)
      {
        const unsigned int before = master.facets[e].previous;
        if (before == numbers::invalid_unsigned_int ||
            !master.facets[e].parts_sides[0] ||
            value_of(cross(master_normals[before][1], master_normals[e][0])) >
              0)
          continue;
        unsigned int i = e;
        do
          {
            faces_beyond[i][0] = {before, 1};
            if (master.facets[i].parts_sides[1])
              break;
            i = master.facets[i].next;
          }
        while (i != numbers::invalid_unsigned_int && i != e);
        i = before;
        do
          {
            faces_beyond[i][1] = {e, 0};
            if (master.facets[i].parts_sides[0])
              break;
            i = master.facets[i].previous;
          }
        while (i != numbers::invalid_unsigned_int && i != before);
      }
  }

  template double MortarGeometry<double>::part_of_side(const unsigned int,
                                                       const unsigned int,
                                                       const double &) const;
  template WithDerivatives
  MortarGeometry<WithDerivatives>::part_of_side(const unsigned int,
                                                const unsigned int,
                                                const WithDerivatives &) const;
  template void MortarGeometry<double>::find_faces_beyond();
  template void MortarGeometry<WithDerivatives>::find_faces_beyond();
} // namespace Contact
