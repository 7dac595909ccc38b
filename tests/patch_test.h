/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A uniform pressure through the interface of two blocks.

#ifndef contact_tests_patch_test_h
#define contact_tests_patch_test_h

#include "tests.h"

namespace Tests
{
  inline const double patch_modulus = 1000, shortening = 0.01;

  // The blocks that are pressed.
  struct PatchCase
  {
    unsigned int degree;
    double       poisson;
    std::string  rule;
    unsigned int n_points = 0;
    unsigned int n_lower = 3, n_upper = 3; // edges of the surfaces
    bool         lower_is_slave = false;
    Chart        lower          = rectangle({0, -1}, {2, 0});
    Chart        upper          = rectangle({0, 0}, {2, 1});
  };



  // Both blocks together are 2 high, held on their left sides, and their right
  // sides are free.
  inline Parameters::All make_case(const PatchCase &c)
  {
    MeshText mesh;
    mesh.block("lower", c.n_lower, 2, c.lower);
    mesh.block("upper", c.n_upper, 2, c.upper);
    Parameters::All parameters = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 c.degree,
                                                 "small strain",
                                                 patch_modulus,
                                                 c.poisson);
    parameters.contact.slave   = "upper bottom";
    parameters.contact.master  = "lower top";
    if (c.lower_is_slave)
      std::swap(parameters.contact.slave, parameters.contact.master);
    parameters.contact.discretization   = c.rule;
    parameters.contact.n_gauss_points   = c.n_points;
    parameters.boundary.displacement[0] = {{"lower left", 0},
                                           {"upper left", 0}};
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", -shortening}};
    return parameters;
  }



  inline double exact_pressure(const double poisson)
  {
    return patch_modulus / (1 - poisson * poisson) * shortening / 2;
  }



  // The largest deviation from the uniform stress, relative to it, and whether
  // all points ended in contact.
  struct Result
  {
    bool   converged, all_in_contact;
    double deviation, deviation_of_pressure;
  };



  /// The largest deviation from a uniform stress along @p axis.
  inline double deviation_of_stress(const TwoBodies   &model,
                                    const double       poisson,
                                    const unsigned int axis = 1)
  {
    const double          pressure = exact_pressure(poisson);
    SymmetricTensor<2, 3> exact;
    exact[axis][axis] = -pressure;
    exact[2][2]       = -poisson * pressure;
    double deviation  = 0;
    for (const auto &cell : model.elasticity->stresses(model.solution))
      for (const auto &stress : cell)
        deviation = std::max(deviation, (stress - exact).norm() / pressure);
    return deviation;
  }



  inline Result press(const Parameters::All &parameters,
                      const double           poisson,
                      const unsigned int     axis = 1)
  {
    TwoBodies model(parameters);
    Result    result{};
    result.converged      = model.solve(1, false) > 0;
    result.deviation      = deviation_of_stress(model, poisson, axis);
    result.all_in_contact = true;
    const double pressure = exact_pressure(poisson);
    for (const ContactPoint<2> &point : points_that_act(model.interface))
      {
        result.all_in_contact =
          result.all_in_contact && point.status.kind == Status::slip;
        result.deviation_of_pressure = std::max(
          result.deviation_of_pressure,
          std::abs(
            model.interface.state(point, model.solution, model.start).p_trial -
            pressure) /
            pressure);
      }
    return result;
  }
} // namespace Tests

#endif
