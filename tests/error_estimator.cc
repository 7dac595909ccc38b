/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the estimated error vanishes where the stress is uniform and in
// equilibrium with what acts on the boundary, contact included; and that it is
// close to the error of a smooth displacement, and where it is not, by how
// much.

#include "adaptivity/error_estimator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include "error_indicators.h"

using namespace Tests;

namespace
{
  const MeshText::Choice none = [](unsigned int, unsigned int) {
    return false;
  };
  const MeshText::Choice some = [](unsigned int i, unsigned int j) {
    return i == j;
  };
  const MeshText::Choice all = [](unsigned int, unsigned int) { return true; };



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
    parameters.boundary.displacement[0] = parameters.boundary.displacement[1] =
      ends;
    const Bodies            bodies(parameters);
    const StressRecovery<2> recovery(bodies.discretization);

    // No stress across the strip: E22 = -nu/(1 - nu) E11, nu = 0.3.
    const double E11 = 0.1, E22 = -3. / 7 * E11;
    const auto   ratio = [=](const double strain) {
      return large_displacement ? std::sqrt(1 + 2 * strain) : 1 + strain;
    };
    const Tensor<2, 2>  R = rotation(large_displacement ? 0.5 : 0);
    const GhostedVector u = bodies.displacement([&](const Point<2> &X) {
      return Point<2>(R * Tensor<1, 2>({ratio(E11) * X[0], ratio(E22) * X[1]}));
    });

    const ErrorEstimator estimator(bodies.discretization, *bodies.elasticity);
    const double         energy = youngs_modulus * E11 * E11 * 2;
    check_small(
      "uniform tension, degree " + std::to_string(degree) + ", " + kinematics,
      sum(estimator.indicators(recovery.vertex_stresses(*bodies.elasticity, u),
                               nullptr,
                               u)) /
        energy,
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
    auto parameters                     = make_parameters(mesh,
                                      {"lower", "upper"},
                                      degree,
                                      kinematics,
                                      youngs_modulus);
    parameters.contact.slave            = "upper bottom";
    parameters.contact.master           = "lower top";
    parameters.contact.discretization   = rule;
    parameters.boundary.displacement[0] = {{"lower left", 0},
                                           {"upper left", 0}};
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", -0.1}};
    Tests::TwoBodies        model(parameters);
    const StressRecovery<2> recovery(model.discretization);
    const std::string       name = "uniform pressure, degree " +
                             std::to_string(degree) + ", " + kinematics + ", " +
                             rule;
    check(name + ", converged", model.solve(1, rule != "mortar") > 0);

    const ErrorEstimator estimator(model.discretization, *model.elasticity);
    const auto           estimate = [&](const ContactInterface<2> *interface) {
      return sum(estimator.indicators(
        recovery.vertex_stresses(*model.elasticity, model.solution),
        interface,
        model.solution));
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
  double true_error(const Bodies &bodies, const GhostedVector &u)
  {
    hp::QCollection<2> quadrature;
    for (unsigned int e = 0; e < bodies.discretization.fe.size(); ++e)
      if (bodies.discretization.fe[e].reference_cell().is_hyper_cube())
        quadrature.push_back(QGauss<2>(5));
      else
        quadrature.push_back(QGaussSimplex<2>(4));
    hp::FEValues<2> hp_fe_values(bodies.discretization.mapping,
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
          .get_function_gradients<Vector<double>>(u, gradients);
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
      parameters.boundary.displacement[0]["block " + side] =
        parameters.boundary.displacement[1]["block " + side] = 0;
    const Bodies            bodies(parameters);
    const StressRecovery<2> recovery(bodies.discretization);

    const GhostedVector u =
      bodies.displacement([](const Point<2> &X) { return X + smooth(X); });
    const ErrorEstimator estimator(bodies.discretization, *bodies.elasticity);
    return std::sqrt(sum(estimator.indicators(
             recovery.vertex_stresses(*bodies.elasticity, u),
             nullptr,
             u))) /
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
  return 0;
}
