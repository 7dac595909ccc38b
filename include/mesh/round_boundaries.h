/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_round_boundaries_h
#define contact_round_boundaries_h

#include "mesh/mesh.h"
#include "mesh/mid_sides.h"
#include "mesh/placement.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Make the boundaries that the parameters name round, whose faces are
   * straight: arcs of circles, in 3-D parts of spheres, cylinders, cones and
   * tori. A surface belongs to the body that it bounds, and moves with it.
   * All other sides of cells go through their @p mid_sides, if there are any.
   * Throws InputError if a vertex is not on its surface, or a mid-side node is
   * too far from the middle.
   */
  void make_round(const Parameters::Mesh &parameters,
                  const Placement<2>     &placement,
                  const MidSides<2>      &mid_sides,
                  Mesh<2>                &mesh);
  void make_round(const Parameters::Mesh &parameters,
                  const Placement<3>     &placement,
                  const MidSides<3>      &mid_sides,
                  Mesh<3>                &mesh);
} // namespace Contact

#endif
