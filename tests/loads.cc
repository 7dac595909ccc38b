/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Dead loads and prescribed displacements: what pressures, tractions, spread
// forces and body forces add up to, where they point, and how they follow the
// load factor.

#include <deal.II/base/quadrature_lib.h>

#include "tests.h"

using namespace Tests;

namespace
{
  using Split = MeshText::Choice;

  const Split none = {};
  const Split all  = [](unsigned int, unsigned int) { return true; };
  const Split some = [](const unsigned int i, const unsigned int j) {
    return (i + j) % 2 == 1;
  };

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



  Resultant resultant(const Bodies &bodies, const Vector<double> &load)
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
  Resultant integrate(const Surface &surface, const Field &pressure)
  {
    const QGauss<1> quadrature(10);
    Resultant       sum;
    for (const auto &edge : surface.edges)
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



  // A parallelogram that is turned, or a ring sector about (1, -2).
  Parameters::All
  body(const unsigned int degree, const bool round, const Split &split)
  {
    const Point<2> center(1, -2);
    const auto     straight = [](const double s, const double t) {
      return Point<2>(1 + 3 * s + 0.5 * t, 2 + s + 2 * t);
    };
    const auto ring = [=](const double s, const double t) {
      const double r = 2 + t, angle = 2.2 - 1.7 * s;
      return center + r * Point<2>(std::cos(angle), std::sin(angle));
    };
    MeshText mesh;
    mesh.block("body", 5, 2, round ? Chart(ring) : Chart(straight), split);
    auto parameters = make_parameters(mesh, {"body"}, degree, "small strain");
    if (round)
      parameters.mesh.arcs = {{"body bottom", {center[0], center[1], 2}},
                              {"body top", {center[0], center[1], 3}}};
    return parameters;
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
        const Bodies  under_constant(parameters);
        const Surface surface = under_constant.surface(side);
        const auto    found =
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
    auto parameters                       = body(degree, round, split);
    parameters.boundary.resultant_force_x = {{"body top", 7}};
    parameters.boundary.resultant_force_y = {{"body top", -100},
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
                std::abs(bodies.elasticity->dead_loads.whole() - 137),
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
                    b.traction_y = {{"body top", "2*x"}};
                  },
                  exact),
                1e-11);
    exact = Resultant();
    exact.add(Point<2>(3, 4.5), Tensor<1, 2>({-7 * length, 0}));
    check_small(text + ": traction x",
                deviation(
                  [](auto &b) {
                    b.traction_x = {{"body top", "-7"}};
                  },
                  exact),
                1e-11);
    exact = Resultant();
    exact.add(Point<2>(2.75, 3.5), Tensor<1, 2>({2 * 5.5, -3 * 5.5}));
    check_small(text + ": body forces",
                deviation(
                  [](auto &b) {
                    b.body_force_x = {{"body", "2"}};
                    b.body_force_y = {{"body", "-3"}};
                  },
                  exact),
                1e-11);
  }



  // A body with one of each load, or of that with the name @p only.
  Parameters::All loaded_body(const std::string &only = "")
  {
    auto       parameters = body(2, false, some);
    auto      &boundary   = parameters.boundary;
    const auto wanted     = [&](const std::string &entry) {
      return only.empty() || only == entry;
    };
    if (wanted("Force x"))
      boundary.force_x = {{"body top left", 3}};
    if (wanted("Force y"))
      boundary.force_y = {{"body top left", 5}, {"body top right", -1}};
    if (wanted("Resultant force x"))
      boundary.resultant_force_x = {{"body left", -4}};
    if (wanted("Resultant force y"))
      boundary.resultant_force_y = {{"body top", -9}};
    if (wanted("Pressure"))
      boundary.pressure = {{"body top", "2 + x"}, {"body right", "y"}};
    if (wanted("Traction x"))
      boundary.traction_x = {{"body left", "y"}};
    if (wanted("Traction y"))
      boundary.traction_y = {{"body right", "1 - x"}};
    if (wanted("Body force x"))
      boundary.body_force_x = {{"body", "0.5*y"}};
    if (wanted("Body force y"))
      boundary.body_force_y = {{"body", "-2"}};
    boundary.displacement_x = {{"body bottom", 0.5}};
    boundary.displacement_y = {{"body bottom", 0}, {"body top right", -0.25}};
    return parameters;
  }



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

    std::map<std::string, Vector<double>> loads;
    double                                whole = 0;
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
        Vector<double> with(bodies.n_dofs()), without(bodies.n_dofs());
        for (const auto &[entry, load] : loads)
          {
            with.add(history(entry, t), load);
            without.add(t, load);
          }
        with -= bodies.elasticity->dead_loads.at(t);
        without -= plain.elasticity->dead_loads.at(t);
        check_small("t = " + two_digits(t) + ", with histories",
                    with.linfty_norm(),
                    1e-13);
        check_small("t = " + two_digits(t) + ", without",
                    without.linfty_norm(),
                    1e-13);
      }
    check_small("whole load",
                std::abs(bodies.elasticity->dead_loads.whole() - whole) +
                  std::abs(plain.elasticity->dead_loads.whole() - whole),
                1e-12);
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
      auto          &discretization = some_bodies.discretization;
      Vector<double> u(some_bodies.n_dofs());
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

  check_histories_of_loads();
  check_histories_of_supports();
}
