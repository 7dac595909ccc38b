/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the stress at the vertices is exact where the stress is linear
// and the element can represent its displacement, that a triangle with one
// point gives its constant, that cells are averaged at a vertex, and that the
// von Mises stress and the stress across the plane are right.

#include "solid/stress_recovery.h"

#include "tests.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000, poisson = 0.3;
  const double lambda =
    youngs_modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
  const double mu = youngs_modulus / (2 * (1 + poisson));



  // The displacement (x^2 + xy, 2 xy - y^2)/100 and its stress: linear.
  Tensor<1, 2> quadratic_displacement(const Point<2> &X)
  {
    const double x = X[0], y = X[1];
    return Tensor<1, 2>({(x * x + x * y) / 100, (2 * x * y - y * y) / 100});
  }



  SymmetricTensor<2, 3> linear_stress(const Point<2> &X)
  {
    const double x = X[0], y = X[1];
    const double xx = (2 * x + y) / 100, yy = (2 * x - 2 * y) / 100;
    const double xy = (x + 2 * y) / 200;

    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 3; ++i)
      stress[i][i] = lambda * (xx + yy);
    stress[0][0] += 2 * mu * xx;
    stress[1][1] += 2 * mu * yy;
    stress[0][1] = 2 * mu * xy;
    return stress;
  }



  void check_linear(const std::string      &name,
                    const std::string      &centre_node,
                    const Chart            &chart,
                    const MeshText::Choice &split)
  {
    MeshText mesh;
    mesh.block("block", 3, 3, chart, split);
    Parameters::All parameters     = make_parameters(mesh,
                                                 {"block"},
                                                 2,
                                                 "small strain",
                                                 youngs_modulus,
                                                 poisson);
    parameters.element.centre_node = centre_node;
    const Bodies            bodies(parameters);
    const StressRecovery<2> recovery(bodies.discretization);
    const GhostedVector     u = bodies.displacement(
      [](const Point<2> &X) { return X + quadratic_displacement(X); });

    const auto  stresses = recovery.vertex_stresses(*bodies.elasticity, u);
    const auto &vertices = bodies.mesh.triangulation.get_vertices();
    double      error = 0, largest = 0;
    for (unsigned int v = 0; v < vertices.size(); ++v)
      {
        const auto exact = linear_stress(vertices[v]);
        error            = std::max(error, (stresses[v] - exact).norm());
        largest          = std::max(largest, exact.norm());
      }
    check_small("linear stress in " + name, error / largest, 1e-12);
  }



  // Two triangles with strains of their own.
  void check_triangles()
  {
    MeshText mesh;
    mesh.block("block",
               1,
               1,
               rectangle({0, 0}, {1, 1}),
               [](unsigned int, unsigned int) { return true; });
    const Bodies            bodies(make_parameters(mesh,
                                        {"block"},
                                        1,
                                        "small strain",
                                        youngs_modulus,
                                        poisson));
    const StressRecovery<2> recovery(bodies.discretization);

    // Only the corner (1, 0) moves, by 0.01 to the right: of the triangles
    // (0,0), (1,0), (1,1) and (0,0), (1,1), (0,1) the first is strained by
    // E11 = 0.01, 2 E12 = -0.01.
    const GhostedVector u = bodies.displacement([](const Point<2> &X) {
      return X + Point<2>(X[0] == 1 && X[1] == 0 ? 0.01 : 0, 0);
    });
    const auto  stresses  = recovery.vertex_stresses(*bodies.elasticity, u);
    const auto &vertices  = bodies.mesh.triangulation.get_vertices();
    double      error     = 0;
    for (unsigned int v = 0; v < vertices.size(); ++v)
      {
        const Point<2>       &X     = vertices[v];
        const double          share = X[0] == X[1] ? 0.5 : (X[0] == 1 ? 1 : 0);
        SymmetricTensor<2, 3> exact;
        exact[0][0] = share * (lambda + 2 * mu) * 0.01;
        exact[1][1] = exact[2][2] = share * lambda * 0.01;
        exact[0][1]               = -share * mu * 0.01;
        error = std::max(error, (stresses[v] - exact).norm());
      }
    check_small("constants of two triangles and their mean",
                error / youngs_modulus,
                1e-15);
  }



  // F = (1.1, 0.2; 0, 0.9) everywhere: E = (F^T F - I)/2, sigma = F S F^T/J.
  void check_cauchy()
  {
    MeshText mesh;
    mesh.block("block", 2, 1, rectangle({0, 0}, {2, 1}));
    const Bodies        bodies(make_parameters(mesh,
                                        {"block"},
                                        1,
                                        "large displacement",
                                        youngs_modulus,
                                        poisson));
    const GhostedVector u = bodies.displacement([](const Point<2> &X) {
      return Point<2>(1.1 * X[0] + 0.2 * X[1], 0.9 * X[1]);
    });

    const double E11 = 0.105, E22 = -0.075, E12 = 0.11;
    const double tr  = lambda * (E11 + E22);
    const double S11 = tr + 2 * mu * E11, S22 = tr + 2 * mu * E22;
    const double S12 = 2 * mu * E12, J = 0.99;

    SymmetricTensor<2, 3> exact;
    exact[0][0] = (1.1 * 1.1 * S11 + 2 * 1.1 * 0.2 * S12 + 0.2 * 0.2 * S22) / J;
    exact[1][1] = 0.9 * 0.9 * S22 / J;
    exact[0][1] = 0.9 * (1.1 * S12 + 0.2 * S22) / J;
    exact[2][2] = tr / J;

    double error = 0;
    for (const auto &stress : StressRecovery<2>(bodies.discretization)
                                .vertex_stresses(*bodies.elasticity, u))
      error = std::max(error, (stress - exact).norm());
    check_small("Cauchy stress at finite strain",
                error / youngs_modulus,
                1e-14);
  }



  void check_von_mises()
  {
    const auto stress =
      [](const double xx, const double yy, const double zz, const double xy) {
        SymmetricTensor<2, 3> s;
        s[0][0] = xx;
        s[1][1] = yy;
        s[2][2] = zz;
        s[0][1] = xy;
        return s;
      };
    headline("von Mises");
    std::cout << "  tension 3: " << von_mises(stress(0, 3, 0, 0)) << std::endl
              << "  shear 2, squared: "
              << std::pow(von_mises(stress(0, 0, 0, 2)), 2) << std::endl
              << "  (5, 1, 3), shear 1, squared: "
              << std::pow(von_mises(stress(5, 1, 3, 1)), 2) << std::endl;
    check_small("pressure", von_mises(stress(-7, -7, -7, 0)), 1e-13);
  }
} // namespace



int main()
{
  headline("recovered stress");
  const auto none = [](unsigned int, unsigned int) { return false; };
  const auto some = [](unsigned int i, unsigned int j) { return i == j; };

  // The 8-node element represents x^2, xy and y^2 only where it is a
  // parallelogram, the 9-node one wherever its sides are straight.
  const Chart parallelogram = [](const double s, const double t) {
    return Point<2>(2 * s + 0.5 * t, -0.3 * s + t);
  };
  const Chart quadrangle = [](const double s, const double t) {
    return Point<2>(2 * s + 0.5 * t + 0.4 * s * t, -0.3 * s + t - 0.2 * s * t);
  };
  check_linear("parallelograms of 8 nodes", "serendipity", parallelogram, none);
  check_linear("8 nodes and triangles", "serendipity", parallelogram, some);
  check_linear("quadrangles of 9 nodes", "free", quadrangle, none);
  check_linear("9 nodes and triangles", "free", quadrangle, some);
  check_triangles();
  check_cauchy();
  check_von_mises();
  return 0;
}
