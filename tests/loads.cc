/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that pressures, tractions, spread forces and body forces add up to the
// forces and moments that are integrated here, in closed form or with many
// points, and that they point where they should: on straight and round
// boundaries of quadrangles and triangles. How they follow the load factor:
// loads_histories.cc.

#include "loads.h"

#include <deal.II/base/quadrature_lib.h>

using namespace Tests;

namespace
{
  // Force and moment about the origin.
  struct Resultant
  {
    Tensor<1, 2> force;
    double       moment = 0;

    void add(const Point<2> &X, const Tensor<1, 2> &F)
    {
      force += F;
      moment += X[0] * F[1] - X[1] * F[0];
    }

    double distance(const Resultant &other) const
    {
      return (force - other.force).norm() + std::abs(moment - other.moment);
    }
  };



  Resultant resultant(const Bodies &bodies, const GhostedVector &load)
  {
    const auto X = bodies.support_points();
    const auto c = bodies.components();
    Resultant  sum;
    for (unsigned int i = 0; i < load.size(); ++i)
      {
        Tensor<1, 2> F;
        F[c[i]] = load[i];
        sum.add(X[i], F);
      }
    return sum;
  }



  using Field = std::function<double(const Point<2> &)>;

  // Of a pressure on the discrete boundary, integrated with many points. The
  // body is to the left of the edges.
  Resultant integrate(const Surface<2> &surface, const Field &pressure)
  {
    const QGauss<1> quadrature(10);
    Resultant       sum;
    for (const auto &edge : surface.facets)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const EdgeShape shape(surface.degree, 2 * quadrature.point(q)[0] - 1);
          Point<2>        X;
          Tensor<1, 2>    along;
          for (unsigned int a = 0; a < surface.n_nodes_per_edge(); ++a)
            {
              const Tensor<1, 2> node = surface.nodes[edge.nodes[a]].X;
              X += shape.value[a] * node;
              along += shape.first[a] * node;
            }
          const Tensor<1, 2> outwards = cross_product_2d(along);
          sum.add(X, -2 * quadrature.weight(q) * pressure(X) * outwards);
        }
    return sum;
  }



  // Of the pressure 1 in closed form: a closed line has none, hence the ends
  // of the boundary are all that counts.
  Resultant between_ends(const Point<2> &A, const Point<2> &B)
  {
    Resultant sum;
    sum.force[0] = -(B[1] - A[1]);
    sum.force[1] = B[0] - A[0];
    sum.moment   = (B.square() - A.square()) / 2;
    return sum;
  }



  // Proves that the nodal loads of a constant and of a linear pressure have the
  // force and the moment of the pressure on the discrete boundary, which for a
  // constant one follow from its ends; on a concave and a convex side; and that
  // the sides together, under the same pressure, are in equilibrium.
  void check_pressure(const std::string &name,
                      const unsigned int degree,
                      const bool         round,
                      const Split       &split)
  {
    const std::string text = (round ? "arc, " : "straight, ") + name +
                             ", degree " + std::to_string(degree);
    double constant = 0, ends = 0, linear = 0;
    for (const std::string side : {"body bottom", "body top"})
      {
        auto parameters              = body(degree, round, split);
        parameters.boundary.pressure = {{side, "3"}};
        const Bodies     under_constant(parameters);
        const Surface<2> surface = under_constant.surface(side);
        const auto       found =
          resultant(under_constant,
                    under_constant.elasticity->dead_loads.at(1));
        constant = std::max(constant,
                            found.distance(
                              integrate(surface, [](auto &) { return 3.; })));

        auto exact =
          between_ends(surface.nodes.front().X, surface.nodes.back().X);
        exact.force *= 3;
        exact.moment *= 3;
        ends = std::max(ends, found.distance(exact));

        parameters.boundary.pressure = {{side, "1 + 2*x - 0.5*y"}};
        const Bodies under_linear(parameters);
        linear = std::max(linear,
                          resultant(under_linear,
                                    under_linear.elasticity->dead_loads.at(1))
                            .distance(integrate(surface, [](const Point<2> &X) {
                              return 1 + 2 * X[0] - 0.5 * X[1];
                            })));
      }
    check_small(text + ": constant", constant, 1e-12);
    check_small(text + ": constant, by the ends", ends, 1e-12);
    check_small(text + ": linear", linear, 1e-11);

    auto parameters              = body(degree, round, split);
    parameters.boundary.pressure = {{"body bottom", "3"},
                                    {"body top", "3"},
                                    {"body left", "3"},
                                    {"body right", "3"}};
    const Bodies under_all(parameters);
    check_small(text + ": all around",
                resultant(under_all, under_all.elasticity->dead_loads.at(1))
                  .distance(Resultant()),
                1e-12);
  }



  // Proves that a positive pressure compresses: on the top of a block it
  // balances the stress -p, the displacement of which is linear.
  void check_sign(const unsigned int degree, const Split &split)
  {
    const double E = 1000, nu = 0.3, p = 20;
    MeshText     mesh;
    mesh.block("body", 3, 2, rectangle({0, 0}, {2, 1}), split);
    auto parameters =
      make_parameters(mesh, {"body"}, degree, "small strain", E, nu);
    parameters.boundary.pressure = {{"body top", "20"}};
    const Bodies bodies(parameters);
    const auto   u = bodies.displacement([&](const Point<2> &X) {
      return Point<2>(X[0] * (1 + nu * (1 + nu) * p / E),
                      X[1] * (1 - (1 - nu * nu) * p / E));
    });

    const auto forces  = bodies.elasticity->forces(u, 1);
    const auto X       = bodies.support_points();
    double     largest = 0;
    for (unsigned int i = 0; i < forces.size(); ++i)
      if (X[i][1] > 1e-6)
        largest = std::max(largest, std::abs(forces[i]));
    check_small("forces, degree " + std::to_string(degree), largest, 1e-11);
    check("the load points downwards",
          forces.linfty_norm() > 1 &&
            resultant(bodies, bodies.elasticity->dead_loads.at(1)).force[1] <
              0);
  }



  // Proves that spread forces add up to what they are, in their direction, and
  // on a straight boundary have their line of action in its middle.
  void check_spread_force(const std::string &name,
                          const unsigned int degree,
                          const bool         round,
                          const Split       &split)
  {
    const std::string text = (round ? "arc, " : "straight, ") + name +
                             ", degree " + std::to_string(degree);
    auto parameters                        = body(degree, round, split);
    parameters.boundary.resultant_force[0] = {{"body top", 7}};
    parameters.boundary.resultant_force[1] = {{"body top", -100},
                                              {"body bottom", 30}};
    const Bodies bodies(parameters);
    const auto   found = resultant(bodies, bodies.elasticity->dead_loads.at(1));
    check_small(text + ": force",
                (found.force - Tensor<1, 2>({7, -70})).norm(),
                1e-12);
    if (!round)
      {
        Resultant exact;
        exact.add(Point<2>(3, 4.5), Tensor<1, 2>({7, -100}));
        exact.add(Point<2>(2.5, 2.5), Tensor<1, 2>({0, 30}));
        check_small(text + ": moment",
                    std::abs(found.moment - exact.moment),
                    1e-11);
      }
    check_small(text + ": whole load",
                std::abs(bodies.elasticity->dead_loads.magnitude(1) - 137),
                1e-11);
  }



  // Proves that tractions and body forces add up to the integrals of their
  // formulas, with the moments of those: on the parallelogram with the corner
  // (1, 2) and the sides (3, 1) and (0.5, 2), whose top is (1.5, 4) + s (3, 1)
  // and whose area is 5.5.
  void check_fields(const std::string &name,
                    const unsigned int degree,
                    const Split       &split)
  {
    const std::string text      = name + ", degree " + std::to_string(degree);
    const auto        deviation = [&](const auto &set, const Resultant &exact) {
      auto parameters = body(degree, false, split);
      set(parameters.boundary);
      const Bodies bodies(parameters);
      return resultant(bodies, bodies.elasticity->dead_loads.at(1))
        .distance(exact);
    };
    const double length = std::sqrt(10.);

    // integral 2 x ds = 6 length about the middle (3, 4.5), and its moment is
    // that of x^2: integral (1.5 + 3 s)^2 ds = 9.75.
    Resultant exact;
    exact.force[1] = 6 * length;
    exact.moment   = 2 * 9.75 * length;
    check_small(text + ": traction y",
                deviation(
                  [](auto &b) {
                    b.traction[1] = {{"body top", "2*x"}};
                  },
                  exact),
                1e-11);
    exact = Resultant();
    exact.add(Point<2>(3, 4.5), Tensor<1, 2>({-7 * length, 0}));
    check_small(text + ": traction x",
                deviation(
                  [](auto &b) {
                    b.traction[0] = {{"body top", "-7"}};
                  },
                  exact),
                1e-11);
    exact = Resultant();
    exact.add(Point<2>(2.75, 3.5), Tensor<1, 2>({2 * 5.5, -3 * 5.5}));
    check_small(text + ": body forces",
                deviation(
                  [](auto &b) {
                    b.body_force[0] = {{"body", "2"}};
                    b.body_force[1] = {{"body", "-3"}};
                  },
                  exact),
                1e-11);
  }
} // namespace



int main()
{
  const std::vector<std::pair<std::string, Split>> meshes = {{"quadrangles",
                                                              none},
                                                             {"triangles", all},
                                                             {"both", some}};

  headline("pressure");
  for (const auto &[name, split] : meshes)
    for (const unsigned int degree : {1, 2})
      for (const bool round : {false, true})
        check_pressure(name, degree, round, split);

  headline("tractions and body forces");
  for (const auto &[name, split] : meshes)
    for (const unsigned int degree : {1, 2})
      check_fields(name, degree, split);

  headline("sign");
  for (const unsigned int degree : {1, 2})
    check_sign(degree, some);

  headline("spread force");
  for (const auto &[name, split] : meshes)
    for (const unsigned int degree : {1, 2})
      for (const bool round : {false, true})
        check_spread_force(name, degree, round, split);
  return 0;
}
