/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The refinement of chosen cells, for each kind of element.

#ifndef contact_tests_refine_bodies_h
#define contact_tests_refine_bodies_h

#include "adaptivity/refinement.h"
#include "tests.h"

namespace Tests
{
  using Choose = std::function<bool(const Point<2> &center)>;



  inline Parameters::All with_centre(Parameters::All parameters,
                                     const bool      free)
  {
    parameters.element.centre_node = free ? "free" : "serendipity";
    return parameters;
  }



  inline std::string element_name(const unsigned int degree, const bool free)
  {
    return degree == 1 ? "degree 1" : (free ? "9 nodes" : "8 nodes");
  }



  /// Visit degree 1, and degree 2 with 8 and 9 nodes.
  inline void
  for_elements(const std::function<void(const unsigned int, const bool)> &visit)
  {
    visit(1, false);
    visit(2, false);
    visit(2, true);
  }



  /// Refine the cells whose centres are chosen.
  inline void refine(Bodies                     &bodies,
                     const Choose               &choose,
                     std::vector<GhostedVector> &solutions)
  {
    for (const auto &cell : bodies.mesh.triangulation.active_cell_iterators())
      if (choose(cell->center()))
        cell->set_refine_flag();
    refine_and_transfer(bodies.mesh, bodies.discretization, solutions);
  }
} // namespace Tests

#endif
