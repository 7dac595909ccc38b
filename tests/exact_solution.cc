/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the errors against an exact solution are relative, integrals over
// both bodies, and of the orders that approximation theory knows; and that of
// concentric cylinders each body is compared with its own theory. The fields
// are interpolated, so that nothing has to be solved. The theory of line
// contact: exact_solution_hertz.cc.

#include "closed_forms/exact_solution.h"

#include "closed_forms/concentric_cylinders.h"

using namespace Tests;

namespace
{
  constexpr double pi = numbers::PI;

  // The quarter of a ring in a ring. With @p swapped the inner one is the
  // slave. Some cells are cut into triangles, the meshes do not match.
  Parameters::All
  rings(const unsigned int degree, const unsigned int n, const bool swapped)
  {
    const auto ring = [](const double r1, const double r2) {
      return [=](const double s, const double t) {
        const double r = r1 + t * (r2 - r1), angle = pi / 2 * (1 - s);
        return Point<2>(r * std::cos(angle), r * std::sin(angle));
      };
    };
    const auto some = [](const unsigned int i, const unsigned int j) {
      return (i + j) % 3 == 0;
    };
    MeshText mesh;
    mesh.block("inner", 2 * n, n, ring(20, 50), some);
    mesh.block("outer", 3 * n, n, ring(50, 100), some);
    auto parameters =
      make_parameters(mesh, {"inner", "outer"}, degree, "small strain");
    parameters.solids.youngs_modulus  = {{"inner", 1000}, {"outer", 2000}};
    parameters.solids.poisson         = {{"inner", 0.3}, {"outer", 0.25}};
    parameters.mesh.arcs              = {{"inner bottom", {0, 0, 20}},
                                         {"inner top", {0, 0, 50}},
                                         {"outer bottom", {0, 0, 50}},
                                         {"outer top", {0, 0, 100}}};
    parameters.contact.slave          = swapped ? "inner top" : "outer bottom";
    parameters.contact.master         = swapped ? "outer bottom" : "inner top";
    parameters.contact.discretization = "nodal";
    return parameters;
  }

  const ClosedForm cylinders{"concentric cylinders", {20, 50, 100, 100, 20}};



  // The solution that has the exact values at all nodes, times a factor.
  void
  interpolate(const ExactSolution &exact, const double factor, TwoBodies &model)
  {
    const auto X = model.support_points();
    const auto c = model.components();
    for (const auto &cell :
         model.discretization.dof_handler.active_cell_iterators())
      {
        std::vector<types::global_dof_index> dofs(
          cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (const auto i : dofs)
          model.solution[i] =
            factor * exact.displacement(X[i], cell->material_id())[c[i]];
      }
    const auto &interface = model.interface;
    for (unsigned int n = 0; n < interface.pairs[0]->slave.nodes.size(); ++n)
      model.solution[interface.normal_index(
        interface.pairs[0]->multipliers.of_node[n])] =
        factor * exact.pressure(interface.pairs[0]->slave.nodes[n].X);
  }



  std::map<std::string, double> errors(const ExactSolution &exact,
                                       const TwoBodies     &model)
  {
    const auto    &pair = *model.interface.pairs[0];
    SlaveTractions slave{pair.slave.degree, {}, {}, {}};
    for (unsigned int n = 0; n < pair.slave.nodes.size(); ++n)
      {
        const unsigned int k = pair.multipliers.of_node[n];
        slave.X.push_back(pair.slave.nodes[n].X);
        slave.pressure.push_back(
          model.solution[model.interface.normal_index(k)]);
        if (exact.shear)
          slave.shear.push_back(
            model.solution[model.interface.tangential_index(k)]);
      }
    return solution_errors(exact, model, slave);
  }



  // Proves that the interpolated solution approaches the exact one by the
  // orders that approximation theory knows: degree + 1 for displacement and
  // pressure, degree in the energy.
  void check_orders(const unsigned int degree)
  {
    std::array<std::map<std::string, double>, 2> found;
    for (const unsigned int i : {0, 1})
      {
        const auto parameters = rings(degree, 4 * (i + 1), false);
        TwoBodies  model(parameters);
        const auto exact = exact_solution(cylinders, parameters, model);
        interpolate(exact, 1, model);
        found[i] = errors(exact, model);
      }
    for (const auto &[name, error] : found[0])
      {
        const double order = degree + (name == "energy" ? 0 : 1);
        check_small("degree " + std::to_string(degree) + ", order of " + name +
                      " against " + two_digits(order),
                    std::abs(std::log2(error / found[1].at(name)) - order),
                    0.2);
        check("a small error", error < 0.2);
      }
  }



  // Two blocks, the lower one 4 x 1, the upper one 2 x 1.
  Parameters::All blocks(const unsigned int degree)
  {
    const auto some = [](const unsigned int i, const unsigned int j) {
      return i == j;
    };
    MeshText mesh;
    mesh.block("lower", 4, 2, rectangle({-1, -1}, {3, 0}), some);
    mesh.block("upper", 3, 2, rectangle({0, 0}, {2, 1}), some);
    auto parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.solids.youngs_modulus        = {{"lower", 1000}, {"upper", 300}};
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = 0.3;
    return parameters;
  }



  // Proves that the errors are relative and no squares: a fraction of the
  // solution is off by the rest. The solution is one that the elements have,
  // with shear along the slave.
  void check_fields_of_the_space(const unsigned int degree)
  {
    TwoBodies model(blocks(degree));

    Tensor<2, 2> gradient;
    gradient[0][0] = 0.01;
    gradient[0][1] = 0.02;
    gradient[1][0] = -0.005;
    gradient[1][1] = -0.03;

    ExactSolution exact;
    exact.displacement = [&](const Point<2> &X, const types::material_id body) {
      return (1. + body) * (gradient * X) + Tensor<1, 2>({0.1, -0.2});
    };
    exact.stress = [&](const Point<2> &, const types::material_id body) {
      return model.elasticity->material(body).stress((1. + body) *
                                                     symmetrize(gradient));
    };
    exact.pressure = [](const Point<2> &X) { return 1 + X[0]; };
    exact.shear    = [](const Point<2> &X) { return 1 - X[0]; };

    for (const double factor : {1., 0.75, 0., -1.})
      {
        interpolate(exact, factor, model);
        const auto &interface = model.interface;
        for (unsigned int n = 0; n < interface.pairs[0]->slave.nodes.size();
             ++n)
          model.solution[interface.tangential_index(
            interface.pairs[0]->multipliers.of_node[n])] =
            factor * exact.shear(interface.pairs[0]->slave.nodes[n].X);
        for (const auto &[name, error] : errors(exact, model))
          check_small("degree " + std::to_string(degree) + ", " + name + ", " +
                        two_digits(factor) + " of the solution",
                      std::abs(error - (1 - factor)),
                      1e-12);
      }
  }



  // Proves that they are integrals over both bodies, weighted by the materials:
  // the displacement x^2/2 along x, against 1, and the strain 1.
  void check_integrals()
  {
    TwoBodies     model(blocks(2));
    ExactSolution field, exact;
    field.pressure     = [](const Point<2> &) { return 0.; };
    field.displacement = [](const Point<2> &X, const types::material_id) {
      return Tensor<1, 2>({X[0] * X[0] / 2, 0});
    };
    interpolate(field, 1, model);
    exact.displacement = [](const Point<2> &, const types::material_id) {
      return Tensor<1, 2>({1, 0});
    };
    exact.stress = [&](const Point<2> &, const types::material_id body) {
      SymmetricTensor<2, 2> strain;
      strain[0][0] = 1;
      return model.elasticity->material(body).stress(strain);
    };
    const auto found = errors(exact, model);
    check_small("displacement",
                std::abs(found.at("displacement") - std::sqrt(7.8 / 6)),
                1e-12);
    check_small("energy",
                std::abs(found.at("energy") -
                         std::sqrt((1000 * 16. / 3 + 300 * 2. / 3) /
                                   (1000 * 4 + 300 * 2))),
                1e-12);
    check("nothing else is known", found.size() == 2);
  }



  // Proves that of the cylinders the inner one is the inner one, be it the
  // slave or not: pressure, displacement and stress are those of its material.
  void check_inner_body(const bool swapped)
  {
    const auto      parameters = rings(1, 2, swapped);
    const TwoBodies model(parameters);
    const auto      exact = exact_solution(cylinders, parameters, model);

    const ConcentricCylinders
               expected(20, 50, 100, {1000, 0.3}, {2000, 0.25}, 100, 20);
    const auto inner = model.mesh.body("inner", "test");
    const auto outer = model.mesh.body("outer", "test");
    double     error = 0, difference = 1;
    for (const double angle : {0., 0.6, 1.5})
      {
        const Point<2> X(50 * std::cos(angle), 50 * std::sin(angle));
        error =
          std::max(error, std::abs(exact.pressure(X) - expected.pressure(X)));
        for (const auto body : {inner, outer})
          error = std::max(error,
                           (exact.displacement(X, body) -
                            expected.displacement(X, body == outer))
                               .norm() +
                             (exact.stress(X, body) -
                              expected.stress(X, body == outer))
                               .norm());
        difference =
          std::min(difference,
                   (exact.stress(X, inner) - exact.stress(X, outer)).norm());
      }
    check_small(std::string("slave is ") + (swapped ? "inner" : "outer"),
                error,
                1e-12);
    check("the bodies differ", difference > 0.1);
  }
} // namespace



int main()
{
  headline("orders");
  for (const unsigned int degree : {1, 2})
    check_orders(degree);

  headline("fields of the space");
  for (const unsigned int degree : {1, 2})
    check_fields_of_the_space(degree);

  headline("integrals");
  check_integrals();

  headline("inner body");
  for (const bool swapped : {false, true})
    check_inner_body(swapped);
  return 0;
}
