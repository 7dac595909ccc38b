/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Friction by Newton's method without multipliers: proves that the unsymmetric
// matrix is the derivative of the condensed forces, by differences of these;
// that linear bodies under statuses that stay need one step, and others
// converge quadratically; that the solution is the one with multipliers; and
// that UMFPACK, MUMPS and AMG in GMRES agree.

#include "condensed_model.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000;

  /// A block is pressed onto another one and pushed to the right until it
  /// slides; the interface is inclined.
  Parameters::All sliding_block(const std::string &rule,
                                const unsigned int degree,
                                const std::string &kinematics)
  {
    const double slope    = 0.3;
    const auto   inclined = [=](const Point<2> &low, const Point<2> &high) {
      const Chart straight = rectangle(low, high);
      return [=](const double s, const double t) {
        const Point<2> x = straight(s, t);
        return Point<2>(x[0], x[1] + slope * x[0]);
      };
    };
    MeshText mesh;
    mesh.block("lower", 7, 2, inclined({-0.6, -1}, {2.7, 0}));
    mesh.block("upper", 5, 2, inclined({0, 0}, {2, 1}));
    Parameters::All parameters              = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 degree,
                                                 kinematics,
                                                 youngs_modulus);
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.friction_coefficient = 0.5;
    parameters.boundary.displacement[0]     = {{"lower bottom", 0},
                                               {"upper top", 0.08}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
                                               {"upper top", -0.02}};
    return parameters;
  }



  void convergence(const std::string &rule, const unsigned int degree)
  {
    headline("convergence, " + rule + " rule, degree " +
             std::to_string(degree));
    CondensedModel linear(sliding_block(rule, degree, "small strain"),
                          "CHOLMOD",
                          /*bounds_follow=*/true);
    CondensedModel model(sliding_block(rule, degree, "large displacement"),
                         "CHOLMOD",
                         /*bounds_follow=*/true);
    check("both converge at half of the load",
          linear.solve(0.5) && model.solve(0.5));
    const StatusCount count = model.interface->active_set.count();
    check("most points slip", count.active > 2 * count.stick);

    check_small("residual of linear bodies after one step",
                residuals(linear).front(),
                1e-12);
    check("others converge quadratically",
          fall_quadratically(residuals(model)));
  }



  void same_as_with_multipliers(const std::string &rule,
                                const unsigned int degree,
                                const std::string &kinematics)
  {
    headline("the same solution, " + rule + " rule, degree " +
             std::to_string(degree) + ", " + kinematics);
    const Parameters::All parameters = sliding_block(rule, degree, kinematics);
    TwoBodies             saddle(parameters);
    CondensedModel        condensed(parameters, "CHOLMOD", true);
    bool                  converged = true;
    for (const double load_factor : {0.5, 1.})
      {
        converged = converged && saddle.solve(load_factor, false) > 0;
        converged = converged && condensed.solve(load_factor);
      }
    check("both converge to the same decisions",
          converged && saddle.interface.active_set.signature() ==
                         condensed.interface->active_set.signature());
    const auto n = saddle.n_dofs();
    check_small("displacements",
                difference(condensed.solution, saddle.solution, 0, n),
                1e-10);
    check_small("multipliers",
                difference(condensed.solution,
                           saddle.solution,
                           n,
                           saddle.solution.size()),
                1e-10);
  }



  void derivative(const std::string &rule)
  {
    headline("the matrix as a derivative, " + rule + " rule");
    CondensedModel model(sliding_block(rule, 1, "large displacement"),
                         "CHOLMOD",
                         true);
    check("converges", model.solve(0.7));
    const double error = matrix_error(model, 0.7);
    check("unsymmetric", !model.elimination->is_symmetric());
    check_small("deviation from the differences", error, 1e-7);
  }



  void solvers(const std::string &rule)
  {
    headline("solvers, " + rule + " rule");
    GhostedVector reference;
    for (const std::string name : {"CHOLMOD", "MUMPS", "AMG"})
      {
        CondensedModel model(sliding_block(rule, 2, "large displacement"),
                             name,
                             true);
        check(name + " converges", model.solve(0.6) && model.solve(1));
        if (name == "CHOLMOD")
          reference = model.solution;
        else
          check_small(name + " and UMFPACK",
                      difference(model.solution, reference, 0, model.n_dofs()),
                      1e-9);
      }
  }
} // namespace



int main()
{
  for (const std::string rule : {"nodal", "mortar"})
    {
      derivative(rule);
      for (const unsigned int degree : {1, 2})
        convergence(rule, degree);
      for (const unsigned int degree : {1, 2})
        for (const std::string kinematics :
             {"small strain", "large displacement"})
          same_as_with_multipliers(rule, degree, kinematics);
      solvers(rule);
    }
  return 0;
}
