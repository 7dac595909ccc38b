/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that each term of the boundary in the estimated error is the one
// computed by hand: on free edges under pressure and shear, on edges of slave
// and master whose multipliers are not the stress of the bodies, on a master
// that is wider than the slave, and beside a tie.

#include "adaptivity/error_estimator.h"
#include "error_indicators.h"

using namespace Tests;

namespace
{
  // The sum of the indicators of the cells which own an edge of a boundary, by
  // the smaller x of the edge.
  std::map<double, double> along_boundary(const Bodies        &bodies,
                                          const std::string   &name,
                                          const Vector<float> &indicators)
  {
    const auto              &ids = bodies.mesh.boundary(name, "test");
    std::map<double, double> values;
    for (const auto &cell : bodies.mesh.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
          values[std::min(face->vertex(0)[0], face->vertex(1)[0])] +=
            indicators[cell->active_cell_index()];
    return values;
  }



  // A force by length f on edges of the length h: f^2 h^2 / E for each.
  void check_edges(const std::string              &name,
                   const std::map<double, double> &computed,
                   const std::vector<double>      &exact)
  {
    double       error = 0;
    unsigned int i     = 0;
    for (const auto &[x, value] : computed)
      error = std::max(error, std::abs(value - exact.at(i++)));
    check_small(name,
                error / *std::max_element(exact.begin(), exact.end()),
                1e-6);
  }



  // A block under uniform pressure and shear. Its bottom is held, its sides in
  // y and its top in x, where the shear acts: the pressure remains on the top,
  // but not in the cell at the nodal force, nor in those it is refined to. The
  // top is left out if a resultant force acts there.
  void check_free_edges(const unsigned int degree,
                        const unsigned int refinements,
                        const bool         spread)
  {
    MeshText mesh;
    mesh.block("block", 3, 2, rectangle({0, 0}, {2, 1}));
    auto parameters                     = make_parameters(mesh,
                                      {"block"},
                                      degree,
                                      "small strain",
                                      youngs_modulus,
                                      0);
    parameters.mesh.refinements         = refinements;
    parameters.boundary.displacement[0] = {{"block bottom", 0},
                                           {"block top", 0}};
    parameters.boundary.displacement[1] = {{"block bottom", 0},
                                           {"block left", 0},
                                           {"block right", 0}};
    if (spread)
      parameters.boundary.resultant_force[1] = {{"block top", -1}};
    else
      parameters.boundary.force[0] = {{"block top left", 1}};
    const Bodies            bodies(parameters);
    const StressRecovery<2> recovery(bodies.discretization);
    const ErrorEstimator estimator(bodies.discretization, *bodies.elasticity);

    const double        pressure = 3;
    const GhostedVector u        = bodies.displacement([=](const Point<2> &X) {
      return X + X[1] * Point<2>(0.002, -pressure / youngs_modulus);
    });
    const auto          indicators =
      estimator.indicators(recovery.vertex_stresses(*bodies.elasticity, u),
                           nullptr,
                           u);
    const unsigned int n = std::pow(2, refinements);
    const double edge    = std::pow(pressure * 2 / (3 * n), 2) / youngs_modulus;

    const std::string name =
      "degree " + std::to_string(degree) + (refinements > 0 ? ", refined" : "");
    if (spread)
      {
        check_small(name + ", spread force",
                    sum(indicators) / (2 * n * edge),
                    1e-18);
        return;
      }
    std::vector<double> exact(3 * n, edge);
    std::fill_n(exact.begin(), n, 0.);
    check_edges(name + ", top of the block",
                along_boundary(bodies, "block top", indicators),
                exact);
    check_small(name + ", all cells",
                std::abs(sum(indicators) / (2 * n * edge) - 1),
                1e-6);
  }



  // Two blocks with other nodes each.
  MeshText two_blocks(const double lower_left, const double lower_right)
  {
    MeshText mesh;
    mesh.block("lower", 4, 2, rectangle({lower_left, -1}, {lower_right, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {2, 1}));
    return mesh;
  }



  // Two blocks of different stiffness under the same uniform pressure P and
  // shear T, and multipliers P + a x and T + b. Their difference to the stress
  // is a x and b: on an edge of the length h from x = x1 to x2
  //   h/E (a^2 (x2^3 - x1^3)/3 + b^2 h).
  void check_contact_edges(const unsigned int degree, const std::string &rule)
  {
    const std::map<std::string, double> moduli{{"lower", 500}, {"upper", 1000}};
    const double                        P = 2, T = 1, a = 0.7, b = 0.4;

    auto parameters                         = make_parameters(two_blocks(0, 2),
                                      {"lower", "upper"},
                                      degree,
                                      "small strain",
                                      youngs_modulus,
                                      0);
    parameters.solids.youngs_modulus        = moduli;
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.friction_coefficient = 1;
    for (const std::string side : {"lower bottom", "lower left", "lower right"})
      parameters.boundary.displacement[0][side] =
        parameters.boundary.displacement[1][side] = 0;
    for (const std::string side : {"upper top", "upper left", "upper right"})
      parameters.boundary.displacement[0][side] =
        parameters.boundary.displacement[1][side] = 0;
    Tests::TwoBodies        model(parameters);
    const StressRecovery<2> recovery(model.discretization);

    // Without lateral strain the stresses are -E u_y,y and E/2 u_x,y.
    const GhostedVector u = model.displacement([&](const Point<2> &X) {
      const double E = moduli.at(X[1] > 0 ? "upper" : "lower");
      return X + X[1] * Point<2>(2 * T / E, -P / E);
    });
    std::copy(u.begin(), u.end(), model.solution.begin());
    const auto &interface = model.interface;
    for (unsigned int i = 0; i < interface.pairs[0]->slave.nodes.size(); ++i)
      {
        const unsigned int k = interface.pairs[0]->multipliers.of_node[i];
        model.solution[interface.normal_index(k)] =
          P + a * interface.pairs[0]->slave.nodes[i].X[0];
        model.solution[interface.tangential_index(k)] = T + b;
      }

    const auto by_hand = [&](const std::string &body, const unsigned int n) {
      const double        h = 2. / n, E = moduli.at(body);
      std::vector<double> values;
      for (unsigned int i = 0; i < n; ++i)
        values.push_back(
          h / E *
          (a * a * (std::pow((i + 1) * h, 3) - std::pow(i * h, 3)) / 3 +
           b * b * h));
      return values;
    };
    const auto slave = by_hand("upper", 3), master = by_hand("lower", 4);
    const ErrorEstimator estimator(model.discretization, *model.elasticity);
    const auto           indicators =
      estimator.indicators(recovery.vertex_stresses(*model.elasticity,
                                                    model.solution),
                           &interface,
                           model.solution);

    const std::string name = "degree " + std::to_string(degree) + ", " + rule;
    check_edges(name + ", slave",
                along_boundary(model, "upper bottom", indicators),
                slave);
    check_edges(name + ", master",
                along_boundary(model, "lower top", indicators),
                master);
    const double total = std::accumulate(slave.begin(), slave.end(), 0.) +
                         std::accumulate(master.begin(), master.end(), 0.);
    check_small(name + ", all cells",
                std::abs(sum(indicators) / total - 1),
                1e-6);
  }



  // Bodies without stress, and the pressure 1 on the slave: what the edges of
  // slave and master have to do with it, by the number of their h^2/E.
  void check_unstressed(const std::string         &name,
                        Parameters::All            parameters,
                        const std::vector<double> &slave,
                        const std::vector<double> &master)
  {
    parameters.contact.slave          = "upper bottom";
    parameters.contact.master         = "lower top";
    parameters.contact.discretization = "nodal";
    Tests::TwoBodies model(parameters);
    for (unsigned int k = 0; k < model.interface.n_multipliers(); ++k)
      model.solution[model.interface.normal_index(k)] = 1;

    const StressRecovery<2> recovery(model.discretization);
    const ErrorEstimator    estimator(model.discretization, *model.elasticity);
    const auto              indicators =
      estimator.indicators(recovery.vertex_stresses(*model.elasticity,
                                                    model.solution),
                           &model.interface,
                           model.solution);
    const auto check_side = [&](const std::string  &side,
                                std::vector<double> values) {
      const auto  &X = model.surface(side).nodes;
      const double h = X[0].X.distance(X[1].X);
      for (double &value : values)
        value *= h * h / youngs_modulus;
      check_edges(name + ", " + side,
                  along_boundary(model, side, indicators),
                  values);
    };
    check_side("upper bottom", slave);
    check_side("lower top", master);
  }



  // A master that is wider than the slave: no pressure where nothing faces it.
  void check_wide_master()
  {
    check_unstressed("wide master",
                     make_parameters(two_blocks(-1, 3),
                                     {"lower", "upper"},
                                     1,
                                     "small strain",
                                     youngs_modulus),
                     {1, 1, 1},
                     {0, 1, 1, 0});
  }



  // A tie in place of the contact of the corners: the edges there are left out,
  // and of the second edge of the master the point that faces such an edge.
  void check_tie()
  {
    auto parameters                    = make_parameters(two_blocks(0, 2),
                                      {"lower", "upper"},
                                      1,
                                      "small strain",
                                      youngs_modulus);
    parameters.contact.excluded_points = {"upper bottom left"};
    parameters.boundary.tied[1] = {{"upper bottom left", "lower top left"}};
    check_unstressed("tie", parameters, {0, 1, 1}, {0, 0.5, 1, 1});
  }
} // namespace



int main()
{
  headline("boundaries by hand");
  for (const unsigned int degree : {1, 2})
    for (const unsigned int refinements : {0, 2})
      for (const bool spread : {false, true})
        check_free_edges(degree, refinements, spread);
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss"})
      check_contact_edges(degree, rule);
  check_wide_master();
  check_tie();
  return 0;
}
