/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_parts_h
#define contact_facet_parts_h

#include <vector>

#include "contact/surfaces/face_clipping.h"
#include "contact/surfaces/facet_shapes.h"

namespace Contact
{
  using namespace dealii;

  /// The parts of a facet that are projected as quadrangles: one, or at degree
  /// 2 four. Their corners are nodes of the facet.
  struct FacetPart
  {
    std::array<unsigned int, 4> corners;
    Point<2>                    middle; // in the coordinates of the facet
    double                      scale;  // of the coordinates of the part
  };



  /// The parts of a facet of this degree.
  inline const std::vector<FacetPart> &parts_of_facet(const unsigned int degree)
  {
    static const std::vector<FacetPart> one{{{{0, 1, 2, 3}}, Point<2>(), 1}};
    static const std::vector<FacetPart> four{
      {{{0, 6, 4, 8}}, Point<2>(-0.5, -0.5), 0.5},
      {{{6, 1, 8, 5}}, Point<2>(0.5, -0.5), 0.5},
      {{{4, 8, 2, 7}}, Point<2>(-0.5, 0.5), 0.5},
      {{{8, 5, 7, 3}}, Point<2>(0.5, 0.5), 0.5}};
    return degree == 1 ? one : four;
  }



  /// A part of a facet in the plane that masters are projected on.
  struct ProjectedPart
  {
    ProjectedPart(const PlaneQuadrangle &quadrangle, const FacetPart &part)
      : quadrangle(quadrangle)
      , lower(quadrangle[0])
      , upper(quadrangle[0])
      , map(quadrangle)
      , part(part)
    {
      for (const Point<2> &corner : quadrangle)
        for (unsigned int i = 0; i < 2; ++i)
          {
            lower[i] = std::min(lower[i], corner[i]);
            upper[i] = std::max(upper[i], corner[i]);
          }
    }

    /// Whether the boxes around the quadrangles have something in common.
    bool is_near(const ProjectedPart &other) const
    {
      return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] &&
             lower[1] <= other.upper[1] && other.lower[1] <= upper[1];
    }

    bool is_in_box(const Point<2> &x) const
    {
      return lower[0] <= x[0] && x[0] <= upper[0] && lower[1] <= x[1] &&
             x[1] <= upper[1];
    }

    /// In the coordinates of the facet.
    Point<2> in_facet(const Point<2> &xi) const
    {
      return part.middle + part.scale * xi;
    }

    const PlaneQuadrangle quadrangle;
    Point<2>              lower, upper;
    const BilinearMap     map;
    const FacetPart      &part;
  };
} // namespace Contact

#endif
