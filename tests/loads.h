/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The body that is loaded, on meshes of quadrangles, triangles and both.

#ifndef contact_tests_loads_h
#define contact_tests_loads_h

#include "tests.h"

namespace Tests
{
  /// The quadrangles that are cut into two triangles.
  using Split = MeshText::Choice;

  inline const Split none = {};
  inline const Split all  = [](unsigned int, unsigned int) { return true; };
  inline const Split some = [](const unsigned int i, const unsigned int j) {
    return (i + j) % 2 == 1;
  };



  /// A parallelogram that is turned, or a ring sector about (1, -2).
  inline Parameters::All
  body(const unsigned int degree, const bool round, const Split &split)
  {
    const Point<2> center(1, -2);
    const auto     straight = [](const double s, const double t) {
      return Point<2>(1 + 3 * s + 0.5 * t, 2 + s + 2 * t);
    };
    const auto ring = [=](const double s, const double t) {
      const double r = 2 + t, angle = 2.2 - 1.7 * s;
      return center + r * Point<2>(std::cos(angle), std::sin(angle));
    };
    MeshText mesh;
    mesh.block("body", 5, 2, round ? Chart(ring) : Chart(straight), split);
    auto parameters = make_parameters(mesh, {"body"}, degree, "small strain");
    if (round)
      parameters.mesh.arcs = {{"body bottom", {center[0], center[1], 2}},
                              {"body top", {center[0], center[1], 3}}};
    return parameters;
  }
} // namespace Tests

#endif
