/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_face_middle_h
#define contact_face_middle_h

#include <deal.II/base/point.h>

namespace Contact
{
  using namespace dealii;

  /// The middle of a face of a cell, with its manifold. deal.II has none of a
  /// round triangle, but of its lines: it is that of the six nodes.
  template<typename Face>
  auto middle_of_face(const Face &face)
  {
    const unsigned int n_of_triangle = 3;
    if (face->n_vertices() != n_of_triangle)
      return face->center(/*respect_manifold=*/true);
    auto middle = face->center();
    for (const unsigned int l : face->line_indices())
      middle += 4. / 9 *
                (face->line(l)->center(/*respect_manifold=*/true) -
                 face->line(l)->center());
    return middle;
  }
} // namespace Contact

#endif
