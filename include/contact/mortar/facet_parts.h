/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_parts_h
#define contact_facet_parts_h

#include <vector>

#include "contact/surfaces/face_clipping.h"
#include "contact/surfaces/facet_kind.h"

namespace Contact
{
  using namespace dealii;

  /// A part of a facet in the plane that masters are projected on.
  struct ProjectedPart
  {
    ProjectedPart(const PlaneFacet &outline, const FacetPart &part)
      : outline(outline)
      , lower(outline[0])
      , upper(outline[0])
      , map(outline)
      , part(part)
    {
      for (const Point<2> &corner : outline)
        for (unsigned int i = 0; i < 2; ++i)
          {
            lower[i] = std::min(lower[i], corner[i]);
            upper[i] = std::max(upper[i], corner[i]);
          }
    }

    /// Whether the boxes around the outlines have something in common.
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

    const PlaneFacet  outline;
    Point<2>          lower, upper;
    const BilinearMap map;
    const FacetPart  &part;
  };
} // namespace Contact

#endif
