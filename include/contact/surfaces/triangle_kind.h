/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_triangle_kind_h
#define contact_triangle_kind_h

#include "contact/surfaces/facet_kind.h"

namespace Contact
{
  using namespace dealii;

  /// Triangles of 3 and 6 nodes. With the area coordinates L of a place, the
  /// functions of degree 2 are L_a (2 L_a - 1) and 4 L_a L_b.
  class TriangleKind : public FacetKind<3>
  {
  public:
    explicit TriangleKind(const unsigned int degree);

    void     first_order(const Point<2>        &xi,
                         Values                &value,
                         std::array<Values, 2> &first) const override;
    void     second_order(const Point<2>        &xi,
                          std::array<Values, 2> &second,
                          Values                &mixed) const override;
    Values   values(const Point<2> &xi) const override;
    Point<2> inside(const Point<2> &xi, const Limits &limits) const override;
    Values   hats(const Point<2> &xi) const override;
    std::vector<Point<3>> hull(const std::array<Point<3>, max_nodes> &x,
                               const Limits &limits) const override;
    std::vector<Point<2>> lattice(const bool with_nodes) const override;
  };
} // namespace Contact

#endif
