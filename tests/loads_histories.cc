/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that every load and every prescribed displacement follows its own
// history, and the load factor if it has none: against the full loads, one by
// one, and the values of the histories.

#include "loads.h"

using namespace Tests;

namespace
{
  // A body with one of each load, or of that with the name @p only.
  Parameters::All loaded_body(const std::string &only = "")
  {
    auto       parameters = body(2, false, some);
    auto      &boundary   = parameters.boundary;
    const auto wanted     = [&](const std::string &entry) {
      return only.empty() || only == entry;
    };
    if (wanted("Force x"))
      boundary.force[0] = {{"body top left", 3}};
    if (wanted("Force y"))
      boundary.force[1] = {{"body top left", 5}, {"body top right", -1}};
    if (wanted("Resultant force x"))
      boundary.resultant_force[0] = {{"body left", -4}};
    if (wanted("Resultant force y"))
      boundary.resultant_force[1] = {{"body top", -9}};
    if (wanted("Pressure"))
      boundary.pressure = {{"body top", "2 + x"}, {"body right", "y"}};
    if (wanted("Traction x"))
      boundary.traction[0] = {{"body left", "y"}};
    if (wanted("Traction y"))
      boundary.traction[1] = {{"body right", "1 - x"}};
    if (wanted("Body force x"))
      boundary.body_force[0] = {{"body", "0.5*y"}};
    if (wanted("Body force y"))
      boundary.body_force[1] = {{"body", "-2"}};
    boundary.displacement[0] = {{"body bottom", 0.5}};
    boundary.displacement[1] = {{"body bottom", 0}, {"body top right", -0.25}};
    return parameters;
  }



  // The values of the histories below, and the load factor for all others.
  double history(const std::string &entry, const double t)
  {
    if (entry == "Force y" || entry == "Displacement y")
      return std::min(1., 2 * t);
    if (entry == "Pressure" || entry == "Body force y")
      return t * t;
    if (entry == "Resultant force y" || entry == "Traction x")
      return 1;
    if (entry == "Displacement x")
      return std::max(0., 2 * t - 1);
    return t;
  }

  const std::map<std::string, std::string> histories = {
    {"Force y", "min(1, 2*t)"},
    {"Pressure", "t^2"},
    {"Resultant force y", "1"},
    {"Traction x", "1"},
    {"Body force y", "t^2"},
    {"Displacement x", "max(0, 2*t - 1)"},
    {"Displacement y", "min(1, 2*t)"}};



  // Proves that every load follows its own history, and the load factor if it
  // has none; the whole load is that of the full values and knows none.
  void check_histories_of_loads()
  {
    headline("histories of loads");
    auto         parameters = loaded_body();
    const Bodies plain(parameters);
    parameters.boundary.histories = histories;
    const Bodies bodies(parameters);

    std::map<std::string, GhostedVector> loads;
    double                               whole = 0, worst = 0;
    for (const std::string entry : {"Force x",
                                    "Force y",
                                    "Resultant force x",
                                    "Resultant force y",
                                    "Pressure",
                                    "Traction x",
                                    "Traction y",
                                    "Body force x",
                                    "Body force y"})
      {
        loads[entry] = Bodies(loaded_body(entry)).elasticity->dead_loads.at(1);
        whole += loads[entry].l1_norm();
      }
    for (const double t : {0., 0.25, 0.5, 0.75, 1.})
      {
        GhostedVector with(bodies.n_dofs()), without(bodies.n_dofs());
        double        magnitude = 0;
        for (const auto &[entry, load] : loads)
          {
            with.add(history(entry, t), load);
            without.add(t, load);
            magnitude += std::abs(history(entry, t)) * load.l1_norm();
          }
        worst = std::max(
          {worst,
           std::abs(bodies.elasticity->dead_loads.magnitude(t) - magnitude),
           std::abs(plain.elasticity->dead_loads.magnitude(t) - t * whole)});
        with -= bodies.elasticity->dead_loads.at(t);
        without -= plain.elasticity->dead_loads.at(t);
        check_small("t = " + two_digits(t) + ", with histories",
                    with.linfty_norm(),
                    1e-13);
        check_small("t = " + two_digits(t) + ", without",
                    without.linfty_norm(),
                    1e-13);
      }
    check_small("magnitudes of the loads", worst, 1e-12);
  }



  // Proves that a support brings its unknowns from where they are to the
  // displacement that its own history asks for, and that there is nothing to do
  // when they are there.
  void check_histories_of_supports()
  {
    headline("histories of supports");
    auto   parameters = loaded_body();
    Bodies plain(parameters);
    parameters.boundary.histories = histories;
    Bodies bodies(parameters);

    const auto bottom         = bodies.surface("body bottom");
    const auto check_supports = [&](Bodies            &some_bodies,
                                    const double       t,
                                    const double       factor_x,
                                    const double       factor_y,
                                    const std::string &name) {
      auto         &discretization = some_bodies.discretization;
      GhostedVector u(some_bodies.n_dofs());
      for (unsigned int i = 0; i < u.size(); ++i)
        u[i] = 1e-3 * i;
      discretization.constrain_update(u, t);

      const auto corner =
        discretization
          .vertex_dofs[some_bodies.mesh.point("body top right", "test")][1];
      const auto &constraints = discretization.constraints;
      double      error       = std::abs(constraints.get_inhomogeneity(corner) -
                              (-0.25 * factor_y - u[corner]));
      for (const auto &node : bottom.nodes)
        error += std::abs(constraints.get_inhomogeneity(node.dofs[0]) -
                          (0.5 * factor_x - u[node.dofs[0]])) +
                 std::abs(constraints.get_inhomogeneity(node.dofs[1]) +
                          u[node.dofs[1]]);
      check_small(name + ", t = " + two_digits(t), error, 1e-13);

      const bool moves = discretization.update_is_prescribed();
      u[corner]        = -0.25 * factor_y;
      for (const auto &node : bottom.nodes)
        {
          u[node.dofs[0]] = 0.5 * factor_x;
          u[node.dofs[1]] = 0;
        }
      discretization.constrain_update(u, t);
      check("then they are there",
            moves && !discretization.update_is_prescribed());
    };
    for (const double t : {0., 0.25, 0.75, 1.})
      {
        check_supports(bodies,
                       t,
                       history("Displacement x", t),
                       history("Displacement y", t),
                       "with histories");
        check_supports(plain, t, t, t, "without");
      }
  }
} // namespace



int main()
{
  check_histories_of_loads();
  check_histories_of_supports();
  return 0;
}
