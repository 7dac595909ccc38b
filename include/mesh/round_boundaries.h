/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_round_boundaries_h
#define contact_round_boundaries_h

#include "mesh/mesh.h"
#include "mesh/placement.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Make the boundaries that the parameters name round, whose faces are
   * straight: arcs of circles, in space parts of spheres, cylinders, cones and
   * tori. A surface belongs to the body that it bounds, and moves with it.
   * Throws InputError if a vertex is not on its surface.
   */
  void make_round(const Parameters::Mesh &parameters,
                  const Placement<2>     &placement,
                  Mesh<2>                &mesh);
  void make_round(const Parameters::Mesh &parameters,
                  const Placement<3>     &placement,
                  Mesh<3>                &mesh);
} // namespace Contact

#endif
