/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of the theory of line contact that is asked for: Hertz' pressure
// belongs to the given force or to the one that was found; Cattaneo and
// Mindlin's shear acts where the force that was found acts, and that of half
// planes of different materials on the softer one away from the axis; be the
// upper body slave or master. Nothing is solved.

#include "closed_forms/exact_solution.h"
#include "closed_forms/line_contact.h"

using namespace Tests;

namespace
{
  // Two blocks, the upper one bulging towards the lower one and closest to it
  // at x = 2/3; either of them is the slave.
  Parameters::All bulge(const bool   upper_is_slave,
                        const double young_upper,
                        const double friction)
  {
    const auto upper = [](const double s, const double t) {
      return Point<2>(2 * s, t + 0.1 * std::pow(2 * s - 2. / 3, 2));
    };
    MeshText mesh;
    mesh.block("lower", 6, 2, rectangle({0, -1}, {2, 0}));
    mesh.block("upper", 6, 2, upper);
    auto parameters =
      make_parameters(mesh, {"lower", "upper"}, 1, "small strain");
    parameters.solids.youngs_modulus["upper"] = young_upper;
    parameters.contact.slave  = upper_is_slave ? "upper bottom" : "lower top";
    parameters.contact.master = upper_is_slave ? "lower top" : "upper bottom";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = friction;
    parameters.solution.increments          = Parameters::Increments(1);
    return parameters;
  }

  const ClosedForm with_friction{"Hertz with friction", {5, 100}};



  // Proves that a given force is taken, and where there is none, the one that
  // was found: four times the force is twice the width and the pressure; and
  // that nothing is said of shear unless that is asked for.
  void check_hertz_force()
  {
    const auto             parameters = bulge(true, 1000, 0);
    const TwoBodies        model(parameters);
    const HertzLineContact hertz{5, 100, 1000, 0.3, 1000, 0.3};
    ContactResults         results;
    results.normal_force = 400;
    const auto compare   = [&](const std::string         &name,
                             const std::vector<double> &numbers,
                             const double               factor) {
      const auto exact =
        exact_solution({"Hertz", numbers}, parameters, model, results);
      check_small(
        name,
        std::abs(exact.values.at("half_width") / hertz.half_width() - factor) +
          std::abs(exact.values.at("max_pressure") / hertz.max_pressure() -
                   factor) +
          std::abs(exact.pressure(Point<2>(2. / 3, 0)) / hertz.max_pressure() -
                   factor),
        1e-12);
      check("no friction",
            !exact.shear && !exact.displacement && !exact.stress &&
              exact.values.size() == 2);
    };
    compare("given force", {5, 100}, 1);
    compare("found force", {5}, 2);

    const auto      frictional = bulge(true, 1000, 0.5);
    const TwoBodies sliding(frictional);
    check("no theory of friction",
          !exact_solution({"Hertz", {5}}, frictional, sliding, results).shear);
  }



  // The shear of the exact solution as it acts along x on the upper body.
  double shear_on_upper_body(const ExactSolution &exact,
                             const TwoBodies     &model,
                             const bool           upper_is_slave,
                             const double         x)
  {
    const auto  &points  = model.interface.points();
    const double along_x = std::min_element(points.begin(),
                                            points.end(),
                                            [&](const auto &a, const auto &b) {
                                              return std::abs(a.X(0)[0] - x) <
                                                     std::abs(b.X(0)[0] - x);
                                            })
                             ->tangents[0][0];
    return (upper_is_slave ? 1 : -1) * (along_x > 0 ? 1 : -1) *
           exact.shear(Point<2>(x, 0));
  }



  // Proves that Cattaneo and Mindlin's shear acts where the force that is found
  // acts: if the points hold the upper body with a traction along x, so does
  // the theory, with the same force; be the upper one slave or master.
  void check_cattaneo_mindlin(const bool upper_is_slave, const double sign)
  {
    const double friction   = 0.5;
    auto         parameters = bulge(upper_is_slave, 1000, friction);
    TwoBodies    model(parameters);
    auto        &interface = model.interface;
    interface.pair(model.solution);
    change_points(interface, [&](ContactPoint<2> &point) {
      point.status = {Status::stick, 0};
      for (unsigned int k = 0; k < point.n_multipliers; ++k)
        model.solution[interface.tangential_index(point.multipliers[k])] =
          (upper_is_slave ? sign : -sign) * (point.tangents[0][0] > 0 ? 1 : -1);
    });
    const auto results = contact_results(interface,
                                         *interface.pairs[0],
                                         model.solution,
                                         model.start);
    const auto exact =
      exact_solution(with_friction, parameters, model, results);
    const std::string name = std::string(upper_is_slave ? "upper" : "lower") +
                             " slave, " +
                             (sign > 0 ? "to the right" : "to the left");
    const CattaneoMindlin mindlin{{5, 100, 1000, 0.3, 1000, 0.3},
                                  friction,
                                  std::abs(results.tangential_force)};
    double                error = 0;
    for (const double x : {-0.5, -0.1, 0., 0.2, 0.6})
      error = std::max(
        error,
        std::abs(shear_on_upper_body(exact, model, upper_is_slave, 2. / 3 + x) -
                 sign * mindlin.shear(x)));
    check_small(name, error, 1e-11);
    check("zone of stick and largest shear",
          std::abs(exact.values.at("max_shear") - mindlin.max_shear()) <
              1e-11 &&
            std::abs(exact.values.at("stick_half_width") -
                     mindlin.stick_half_width()) < 1e-12 &&
            mindlin.shear(0) > 0.1);
  }



  // Proves that between different bodies the shear on the softer one points
  // away from the axis, be it above or below, slave or master.
  void check_half_planes(const bool upper_is_slave, const double young_upper)
  {
    const auto parameters = bulge(upper_is_slave, young_upper, 0.1);
    TwoBodies  model(parameters);
    model.interface.pair(model.solution);
    const auto   exact = exact_solution(with_friction, parameters, model);
    const double right =
      shear_on_upper_body(exact, model, upper_is_slave, 2. / 3 + 0.5);
    const double left =
      shear_on_upper_body(exact, model, upper_is_slave, 2. / 3 - 0.5);
    std::cout << "  " << (upper_is_slave ? "upper" : "lower")
              << " slave, the upper one is "
              << (young_upper > 1000 ? "harder" : "softer") << ": it is pulled "
              << (right > 0 && left < 0   ? "outwards"
                  : right < 0 && left > 0 ? "inwards"
                                          : "to one side")
              << std::endl;
    check_small("odd", std::abs(right + left) / std::abs(right), 1e-6);
  }
} // namespace



int main()
{
  headline("force of Hertz");
  check_hertz_force();

  headline("Cattaneo and Mindlin");
  for (const bool upper_is_slave : {true, false})
    for (const double sign : {1, -1})
      check_cattaneo_mindlin(upper_is_slave, sign);

  headline("half planes");
  check_half_planes(true, 500);
  check_half_planes(false, 500);
  check_half_planes(false, 2000);
  return 0;
}
