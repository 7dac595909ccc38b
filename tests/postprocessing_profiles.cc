/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the profiles of slave and master hold what is known of two
// blocks: a uniform pressure from the multipliers, from the stresses of both
// bodies and from the nodal forces; multipliers that are linear along the slave
// on the nodes of the master; the axis of the Hertz contact; and normals and
// arc lengths of the turned surface.

#include "closed_forms/exact_solution.h"
#include "postprocessing.h"
#include "solid/stress_recovery.h"

using namespace Tests;

namespace
{
  double deviation(const Rows &rows,
                   double ProfileRow<2>::*const column,
                   const double                 value)
  {
    double largest = 0;
    for (const ProfileRow<2> &row : rows)
      largest = std::max(largest, std::abs(row.*column - value));
    return largest;
  }



  // Proves that under a uniform pressure all curves agree: multiplier, pressure
  // from the volume stresses of both bodies, and the nodal forces, which add up
  // to pressure times width; and that both profiles run alike, over the width
  // of the blocks before and after.
  void check_uniform_pressure(const unsigned int degree,
                              const std::string &rule)
  {
    headline("uniform pressure, degree " + std::to_string(degree) + ", " +
             rule);
    Parameters::All parameters          = two_blocks(degree, rule);
    parameters.boundary.displacement[0] = {{"lower left", 0},
                                           {"upper left", 0}};
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", -0.02}};
    TwoBodies model(parameters);
    check("converged", model.solve(1, false) > 0);
    const StressRecovery<2> recovery(model.discretization);

    // Both blocks together are 2 high.
    const double   p     = 1000 / (1 - 0.3 * 0.3) * 0.01;
    const double   width = 2 * (1 + 0.3 / (1 - 0.3) * 0.01);
    const Stresses stresses =
      recovery.vertex_stresses(*model.elasticity, model.solution);
    for (const Rows &rows : profiles(model, stresses))
      {
        using Row = ProfileRow<2>;
        check_small("pressure", deviation(rows, &Row::pressure, p), 1e-9);
        check_small("extrapolated pressure",
                    deviation(rows, &Row::extrapolated_pressure, p),
                    1e-9);
        check_small("gap", deviation(rows, &Row::gap, 0), 1e-12);

        double force = -2 * p;
        for (const ProfileRow<2> &row : rows)
          force += row.nodal_force;
        check_small("nodal forces", std::abs(force), 1e-9);
        check("slips without friction", rows[1].status == 1);
        check("from x = 0 to 2", rows[0].X[0] == 0 && rows.back().X[0] == 2);
        check_small("widths",
                    std::abs(rows.back().arc_length - 2) +
                      std::abs(rows.back().deformed_arc_length - width),
                    1e-12);
      }
  }



  // Proves the interpolation: of multipliers that are linear along the slave
  // the master nodes have the same values, and nothing where no slave is. A
  // node excluded from contact has the status -1.
  void check_master_nodes(const unsigned int degree)
  {
    headline("master nodes, degree " + std::to_string(degree));
    Parameters::All parameters         = two_blocks(degree, "nodal", true);
    parameters.contact.excluded_points = {"upper bottom right"};
    PlacedModel model(parameters, stay);

    const auto &interface = model.interface;
    for (unsigned int n = 0; n < interface.pairs[0]->slave.nodes.size(); ++n)
      {
        const unsigned int k = interface.pairs[0]->multipliers.of_node[n];
        if (k != numbers::invalid_unsigned_int)
          model.solution[interface.normal_index(k)] =
            2 - interface.pairs[0]->slave.nodes[n].X[0];
      }

    const auto [slave, master] =
      profiles(model, Stresses(model.mesh.triangulation.n_vertices()));
    double error             = 0;
    bool   beyond_is_nothing = true;
    for (const ProfileRow<2> &row : master)
      if (row.X[0] >= 0 && row.X[0] <= 2)
        error = std::max(error, std::abs(row.pressure + row.X[0] - 2));
      else
        beyond_is_nothing =
          beyond_is_nothing && row.status == -1 && row.pressure == 0;
    check_small("interpolated pressure", error, 1e-12);
    check("nothing beyond the slave", beyond_is_nothing);
    check("excluded node", slave[0].status == 0 && slave.back().status == -1);
  }



  // Proves that the axis of the Hertz contact is where the slave is nearest to
  // the master, for both of them.
  void check_hertz_axis(const unsigned int degree)
  {
    headline("Hertz axis, degree " + std::to_string(degree));
    const auto        parameters = two_blocks(degree, "nodal", true, 0.1);
    const PlacedModel model(parameters, stay);
    const Stresses    stresses(model.mesh.triangulation.n_vertices());
    const auto exact = exact_solution({"Hertz", {5, 100}}, parameters, model);
    for (const Rows &rows : profiles(model, stresses))
      for (const ProfileRow<2> &row : rows)
        if (const double p = exact.pressure(row.X); p > 0)
          std::cout << "  x " << row.X[0] << ", p/p0 "
                    << p / exact.values.at("max_pressure") << std::endl;
  }



  // Proves that normals and arc lengths are those of the deformed surface: the
  // stress turned along with the bodies presses the same at every node.
  void check_rotation(const unsigned int degree)
  {
    headline("rotation, degree " + std::to_string(degree));
    const Tensor<2, 2> R = rotation(0.5);
    const PlacedModel  model(two_blocks(degree, "Gauss"), [&](const auto &X) {
      return Point<2>(1.5 * (R * X));
    });

    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = i; j < 2; ++j)
        stress[i][j] = 3 * R[i][0] * R[j][0] - 7 * R[i][1] * R[j][1];
    for (const Rows &rows :
         profiles(model,
                  Stresses(model.mesh.triangulation.n_vertices(), stress)))
      {
        check_small("extrapolated pressure",
                    deviation(rows, &ProfileRow<2>::extrapolated_pressure, 7),
                    1e-12);
        check_small("deformed arc length",
                    std::abs(rows.back().deformed_arc_length - 3),
                    1e-12);
      }
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      for (const std::string rule : {"nodal", "Gauss"})
        check_uniform_pressure(degree, rule);
      check_master_nodes(degree);
      check_hertz_axis(degree);
      check_rotation(degree);
    }
  return 0;
}
