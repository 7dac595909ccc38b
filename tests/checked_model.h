/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A block that is pressed down and dragged along, and a model with the check of
// its invariants.

#ifndef contact_tests_checked_model_h
#define contact_tests_checked_model_h

#include "tests.h"
#include "verification/invariants.h"

namespace Tests
{
  /// A contact discretization, an element, the strains, and friction.
  struct CheckedCase
  {
    std::string  rule;
    unsigned int degree;
    std::string  kinematics;
    double       friction;
  };



  /// The headline of a case.
  inline std::string named(const CheckedCase &c)
  {
    return c.rule + ", degree " + std::to_string(c.degree) + ", " +
           c.kinematics + (c.friction > 0 ? ", friction" : "");
  }



  /// A block with a convex lower side on a flat block: pressed down and dragged
  /// along, then lifted again and dragged back.
  inline Parameters::All make_case(const CheckedCase &c)
  {
    MeshText mesh;
    mesh.block("lower", 7, 2, rectangle({-1.5, -1}, {1.5, 0}));
    mesh.block("upper", 9, 2, [](const double s, const double t) {
      const double x = 2 * s - 1;
      return Point<2>(x, 0.04 * x * x * (1 - t) + t);
    });
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, c.degree, c.kinematics);
    parameters.contact.slave                    = "upper bottom";
    parameters.contact.master                   = "lower top";
    parameters.contact.discretization           = c.rule;
    parameters.contact.friction_coefficient     = c.friction;
    parameters.boundary.displacement[0]         = {{"lower bottom", 0},
                                                   {"upper top", 0.01}};
    parameters.boundary.displacement[1]         = {{"lower bottom", 0},
                                                   {"upper top", -0.04}};
    parameters.boundary.pressure["upper right"] = "2";
    parameters.boundary.histories["Displacement y"] =
      "if(t < 0.5, 2*t, 1.5 - t)";
    parameters.boundary.histories["Displacement x"] = "sin(5*t)";
    parameters.solution.geometry                    = "Newton";
    parameters.solution.friction                    = "Newton";
    return parameters;
  }



  /// A state, solved for, and its check. The residual is below 1e-12 of the
  /// largest force.
  struct Checked : public TwoBodies
  {
    explicit Checked(const Parameters::All &parameters)
      : TwoBodies(parameters)
      , parameters(parameters)
      , invariants(discretization, *elasticity, &interface, parameters.solution)
    {
    }

    /// One increment, paired in each step; the tangent of the mortar
    /// discretization keeps the pairing. Until round-off is left.
    bool solve(const double load)
    {
      load_factor = load;
      return TwoBodies::solve(load,
                              parameters.contact.discretization !=
                                Parameters::ContactDiscretization::mortar,
                              /*pairs_anew=*/true,
                              force) > 0;
    }

    Invariants check()
    {
      return invariants.check(solution, load_factor, tolerance, force);
    }

    /// The invariants that are violated.
    std::string alarms()
    {
      std::string names;
      for (const Finding &finding : check().findings)
        names += (names.empty() ? "" : ", ") +
                 finding.text.substr(0, finding.text.find(':'));
      return names.empty() ? "none" : names;
    }

    /// The first point of a status.
    const ContactPoint<2> *find(const Status status) const
    {
      for (const ContactPoint<2> &point : interface.points())
        if (point.status.kind == status && point.facing &&
            (status != Status::slip || point.status.slip_direction != 0))
          return &point;
      return nullptr;
    }

    /// Change the first point of a status.
    void change(const Status                                  status,
                const std::function<void(ContactPoint<2> &)> &change_point)
    {
      auto points = interface.points();
      change_point(points[find(status) - interface.points().data()]);
      interface.set_points(points);
    }

    double &lambda_n(const ContactPoint<2> &point)
    {
      return solution[interface.normal_index(point.multipliers[0])];
    }

    double &lambda_t(const ContactPoint<2> &point)
    {
      return solution[interface.tangential_index(point.multipliers[0])];
    }

    static constexpr double tolerance = 1e-8;
    static constexpr double force     = 10; // [N/mm], about that of the contact

    const Parameters::All parameters;
    InvariantCheck<2>     invariants;
    double                load_factor = 0;
  };
} // namespace Tests

#endif
