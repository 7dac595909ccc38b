/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the estimated error vanishes where the stress is uniform and in
// equilibrium with what acts on the boundary, contact included; that it is
// close to the error of a smooth displacement, and where it is not, by how
// much; and that each term of the boundary is the one computed by hand.

#include "adaptivity/error_estimator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <numeric>

#include "tests.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000;

  const MeshText::Choice none = [](unsigned int, unsigned int) {
    return false;
  };
  const MeshText::Choice some = [](unsigned int i, unsigned int j) {
    return i == j;
  };
  const MeshText::Choice all = [](unsigned int, unsigned int) { return true; };



  double sum(const Vector<float> &indicators)
  {
    return std::accumulate(indicators.begin(), indicators.end(), 0.);
  }



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



  // A strip that is stretched by a tenth and free at both its long sides; with
  // large displacement it is turned, too.
  void check_uniform_tension(const unsigned int degree,
                             const bool         large_displacement)
  {
    const std::string kinematics =
      large_displacement ? "large displacement" : "small strain";
    MeshText mesh;
    mesh.block("strip", 4, 3, rectangle({0, 0}, {2, 1}), some);
    auto parameters = make_parameters(mesh, {"strip"}, degree, kinematics);
    const std::map<std::string, double> ends{{"strip left", 0},
                                             {"strip right", 0}};
    parameters.boundary.displacement_x = parameters.boundary.displacement_y =
      ends;
    const Bodies         bodies(parameters);
    const StressRecovery recovery(bodies.discretization);

    // No stress across the strip: E22 = -nu/(1 - nu) E11, nu = 0.3.
    const double E11 = 0.1, E22 = -3. / 7 * E11;
    const auto   ratio = [=](const double strain) {
      return large_displacement ? std::sqrt(1 + 2 * strain) : 1 + strain;
    };
    const Tensor<2, 2>   R = rotation(large_displacement ? 0.5 : 0);
    const Vector<double> u = bodies.displacement([&](const Point<2> &X) {
      return Point<2>(R * Tensor<1, 2>({ratio(E11) * X[0], ratio(E22) * X[1]}));
    });

    const ErrorEstimator estimator(bodies.discretization,
                                   *bodies.elasticity,
                                   recovery);
    const double         energy = youngs_modulus * E11 * E11 * 2;
    check_small("uniform tension, degree " + std::to_string(degree) + ", " +
                  kinematics,
                sum(estimator.indicators(nullptr, u)) / energy,
                1e-25);
  }



  // Two blocks with the same nodes in contact, pressed by a twentieth.
  void check_uniform_pressure(const unsigned int degree,
                              const std::string &kinematics,
                              const std::string &rule)
  {
    MeshText mesh;
    mesh.block("lower", 3, 2, rectangle({0, -1}, {2, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {2, 1}));
    auto parameters                    = make_parameters(mesh,
                                      {"lower", "upper"},
                                      degree,
                                      kinematics,
                                      youngs_modulus);
    parameters.contact.slave           = "upper bottom";
    parameters.contact.master          = "lower top";
    parameters.contact.discretization  = rule;
    parameters.boundary.displacement_x = {{"lower left", 0}, {"upper left", 0}};
    parameters.boundary.displacement_y = {{"lower bottom", 0},
                                          {"upper top", -0.1}};
    Tests::ContactModel  model(parameters);
    const StressRecovery recovery(model.discretization);
    const std::string    name = "uniform pressure, degree " +
                             std::to_string(degree) + ", " + kinematics + ", " +
                             rule;
    check(name + ", converged", model.solve(1, rule != "mortar") > 0);

    const ErrorEstimator estimator(model.discretization,
                                   *model.elasticity,
                                   recovery);
    const auto           estimate = [&](const ContactInterface *interface) {
      return sum(estimator.indicators(interface, model.solution));
    };
    const double energy = youngs_modulus * 0.05 * 0.05 * 4;
    check_small(name, estimate(&model.interface) / energy, 1e-18);
    check("without the pressure it does not vanish",
          estimate(nullptr) / energy > 0.1);
  }



  // A smooth displacement, with the gradient grad_u.
  Tensor<1, 2> smooth(const Point<2> &X)
  {
    return 0.01 * Tensor<1, 2>({std::sin(2 * X[0]) * std::exp(X[1]),
                                std::cos(X[0] + 2 * X[1])});
  }

  Tensor<2, 2> gradient_of_smooth(const Point<2> &X)
  {
    const double s = X[0] + 2 * X[1];
    Tensor<2, 2> gradient;
    gradient[0][0] = 0.02 * std::cos(2 * X[0]) * std::exp(X[1]);
    gradient[0][1] = 0.01 * std::sin(2 * X[0]) * std::exp(X[1]);
    gradient[1][0] = -0.01 * std::sin(s);
    gradient[1][1] = -0.02 * std::sin(s);
    return gradient;
  }



  // The error of the interpolated smooth displacement in the norm of the
  // energy.
  double true_error(const Bodies &bodies, const Vector<double> &u)
  {
    const hp::QCollection<2> quadrature(QGauss<2>(5), QGaussSimplex<2>(4));
    hp::FEValues<2>          hp_fe_values(bodies.discretization.mapping,
                                 bodies.discretization.fe,
                                 quadrature,
                                 update_gradients | update_JxW_values |
                                   update_quadrature_points);

    const Material            material(youngs_modulus, 0.3);
    std::vector<Tensor<2, 2>> gradients;
    double                    square = 0;
    for (const auto &cell :
         bodies.discretization.dof_handler.active_cell_iterators())
      {
        hp_fe_values.reinit(cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();
        gradients.resize(fe_values.n_quadrature_points);
        fe_values[FEValuesExtractors::Vector(0)]
          .get_function_gradients(u, gradients);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const auto strain = symmetrize(
              gradients[q] - gradient_of_smooth(fe_values.quadrature_point(q)));
            square += strain * material.stress(strain) * fe_values.JxW(q);
          }
      }
    return std::sqrt(square);
  }



  // The estimated error over the true one, where every side is held, so that
  // the boundary adds nothing.
  double effectivity(const unsigned int      degree,
                     const MeshText::Choice &split,
                     const Chart            &chart,
                     const unsigned int      refinements)
  {
    MeshText mesh;
    mesh.block("block", 4, 4, chart, split);
    auto parameters = make_parameters(mesh, {"block"}, degree, "small strain");
    parameters.element.centre_node = "free";
    parameters.mesh.refinements    = refinements;
    for (const std::string side : {"bottom", "right", "top", "left"})
      parameters.boundary.displacement_x["block " + side] =
        parameters.boundary.displacement_y["block " + side] = 0;
    const Bodies         bodies(parameters);
    const StressRecovery recovery(bodies.discretization);

    const Vector<double> u =
      bodies.displacement([](const Point<2> &X) { return X + smooth(X); });
    const ErrorEstimator estimator(bodies.discretization,
                                   *bodies.elasticity,
                                   recovery);
    return std::sqrt(sum(estimator.indicators(nullptr, u))) /
           true_error(bodies, u);
  }



  // From 4 to 32 cells a side. The recovered stress is linear: to elements of
  // degree 1 it is of higher order than their own and hence the exact one in
  // the limit, to elements of degree 2 it is of the same.
  void print_effectivities(const std::string      &name,
                           const unsigned int      degree,
                           const MeshText::Choice &split,
                           const Chart            &chart)
  {
    std::cout << "  degree " << degree << ", " << name << ':';
    double last = 0;
    for (unsigned int refinements = 0; refinements < 4; ++refinements)
      {
        last = effectivity(degree, split, chart, refinements);
        std::cout << ' ' << two_digits(last);
      }
    std::cout << std::endl;
    if (degree == 1)
      check("within 0.95..1.05 on the finest mesh", last > 0.95 && last < 1.05);
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
    auto parameters                    = make_parameters(mesh,
                                      {"block"},
                                      degree,
                                      "small strain",
                                      youngs_modulus,
                                      0);
    parameters.mesh.refinements        = refinements;
    parameters.boundary.displacement_x = {{"block bottom", 0},
                                          {"block top", 0}};
    parameters.boundary.displacement_y = {{"block bottom", 0},
                                          {"block left", 0},
                                          {"block right", 0}};
    if (spread)
      parameters.boundary.resultant_force_y = {{"block top", -1}};
    else
      parameters.boundary.force_x = {{"block top left", 1}};
    const Bodies         bodies(parameters);
    const StressRecovery recovery(bodies.discretization);
    const ErrorEstimator estimator(bodies.discretization,
                                   *bodies.elasticity,
                                   recovery);

    const double         pressure = 3;
    const Vector<double> u        = bodies.displacement([=](const Point<2> &X) {
      return X + X[1] * Point<2>(0.002, -pressure / youngs_modulus);
    });
    const auto           indicators = estimator.indicators(nullptr, u);
    const unsigned int   n          = std::pow(2, refinements);
    const double edge = std::pow(pressure * 2 / (3 * n), 2) / youngs_modulus;

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
      parameters.boundary.displacement_x[side] =
        parameters.boundary.displacement_y[side] = 0;
    for (const std::string side : {"upper top", "upper left", "upper right"})
      parameters.boundary.displacement_x[side] =
        parameters.boundary.displacement_y[side] = 0;
    Tests::ContactModel  model(parameters);
    const StressRecovery recovery(model.discretization);

    // Without lateral strain the stresses are -E u_y,y and E/2 u_x,y.
    const Vector<double> u = model.displacement([&](const Point<2> &X) {
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
    const ErrorEstimator estimator(model.discretization,
                                   *model.elasticity,
                                   recovery);
    const auto indicators = estimator.indicators(&interface, model.solution);

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
    Tests::ContactModel model(parameters);
    for (unsigned int k = 0; k < model.interface.n_multipliers(); ++k)
      model.solution[model.interface.normal_index(k)] = 1;

    const StressRecovery recovery(model.discretization);
    const ErrorEstimator estimator(model.discretization,
                                   *model.elasticity,
                                   recovery);
    const auto           indicators =
      estimator.indicators(&model.interface, model.solution);
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
    parameters.boundary.tied_y = {{"upper bottom left", "lower top left"}};
    check_unstressed("tie", parameters, {0, 1, 1}, {0, 0.5, 1, 1});
  }
} // namespace



int main()
{
  headline("uniform stress");
  for (const unsigned int degree : {1, 2})
    for (const bool large_displacement : {false, true})
      check_uniform_tension(degree, large_displacement);
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss", "mortar"})
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        check_uniform_pressure(degree, kinematics, rule);

  headline("effectivity");
  const Chart square = rectangle({0, 0}, {1, 1});
  const Chart bent   = [](const double s, const double t) {
    return Point<2>(s + 0.3 * s * t, t + 0.2 * s - 0.2 * s * t);
  };
  for (const unsigned int degree : {1, 2})
    {
      print_effectivities("squares", degree, none, square);
      print_effectivities("quadrangles", degree, none, bent);
      print_effectivities("triangles", degree, all, square);
      print_effectivities("both", degree, some, bent);
    }

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
}
