/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A block with a convex bottom, pressed onto another one.

#ifndef contact_tests_condensed_h
#define contact_tests_condensed_h

#include "tests.h"

namespace Tests
{
  inline const double youngs_modulus = 1000;

  /// A block with a convex bottom, pressed onto one with other nodes.
  struct CondensedCase
  {
    std::string  rule;
    unsigned int degree;
    std::string  kinematics = "small strain";
    double       coulomb = 0, tresca = 0; // [-], [MPa]
    Chart        lower         = rectangle({-0.2, -1}, {2.3, 0});
    double       rise          = 0.04; // of the convex bottom at its ends
    bool         symmetry      = false;
    bool         lower_is_free = false; // on the line of symmetry
  };



  /// From x = -1 to 1 about @p center, or only the half to the right.
  inline Chart convex(const double center, const double rise, const bool half)
  {
    return [=](const double s, const double t) {
      const double x = half ? s : 2 * s - 1;
      return Point<2>(center + x, rise * x * x * (1 - t) + t);
    };
  }



  inline Parameters::All make_case(const CondensedCase &c)
  {
    MeshText mesh;
    mesh.block("lower", 9, 2, c.lower);
    mesh.block("upper", 7, 2, convex(c.symmetry ? 0 : 1, c.rise, c.symmetry));
    Parameters::All parameters                = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 c.degree,
                                                 c.kinematics,
                                                 youngs_modulus);
    parameters.solids.youngs_modulus["lower"] = 2 * youngs_modulus;
    parameters.contact.slave                  = "upper bottom";
    parameters.contact.master                 = "lower top";
    parameters.contact.discretization         = c.rule;
    parameters.contact.friction_coefficient   = c.coulomb;
    parameters.contact.tresca_limit           = c.tresca;
    parameters.boundary.displacement[0]       = {{"lower bottom", 0}};
    parameters.boundary.displacement[1]       = {{"lower bottom", 0},
                                                 {"upper top", -0.03}};
    if (c.symmetry)
      parameters.boundary.displacement[0] = {
        {c.lower_is_free ? "lower bottom" : "lower left", 0},
        {"upper left", 0}};
    else
      parameters.boundary.displacement[0]["upper top"] = 0.003;
    return parameters;
  }

} // namespace Tests

#endif
