/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of bodies that are stabilized by springs: springs add up to the
// stiffness asked for on any mesh, forces are the derivative of the energy and
// the tangent that of the forces, nothing else changes, and what was released
// is as before.

#include "derivatives.h"

using namespace Tests;

namespace
{
  Parameters::All make_case(const unsigned int degree,
                            const std::string &kinematics)
  {
    Random   random;
    MeshText mesh;
    mesh.block(
      "lower",
      3,
      2,
      [&](const double s, const double t) {
        return Point<2>(3 * s * s + random(-0.05, 0.05),
                        2 * t - 3 + random(-0.05, 0.05));
      },
      [](const unsigned int i, const unsigned int j) { return i + j == 2; });
    mesh.block("upper", 2, 2, rectangle({0, 0}, {1, 1}));
    return make_parameters(mesh, {"lower", "upper"}, degree, kinematics);
  }



  // The first piece of a body.
  unsigned int piece_of(const Mesh<2> &mesh, const std::string &body)
  {
    unsigned int piece = 0;
    while (mesh.pieces[piece].body != mesh.bodies.at(body))
      ++piece;
    return piece;
  }



  // The energy the forces belong to.
  double energy(const Elasticity<2> &elasticity, const GhostedVector &u)
  {
    double sum = elasticity.strain_energy(u);
    for (const auto &[body, of_hold] : elasticity.springs.energy(u))
      sum += of_hold;
    return sum;
  }



  // The sum of the forces on each body.
  std::map<types::material_id, Tensor<1, 2>> resultants(const Bodies &bodies,
                                                        const GhostedVector &u)
  {
    std::map<types::material_id, Tensor<1, 2>> sums;
    const auto forces     = bodies.elasticity->forces(u, 0);
    const auto components = bodies.components();
    const auto X          = bodies.support_points();
    for (unsigned int i = 0; i < forces.size(); ++i)
      sums[bodies.mesh.bodies.at(X[i][1] < -0.5 ? "lower" : "upper")]
          [components[i]] += forces[i];
    return sums;
  }



  void hold(const unsigned int degree, const std::string &kinematics)
  {
    headline("degree " + std::to_string(degree) + ", " + kinematics);
    const Bodies   bodies(make_case(degree, kinematics));
    Elasticity<2> &elasticity = *bodies.elasticity;
    const auto     lower      = piece_of(bodies.mesh, "lower");
    const auto     upper      = piece_of(bodies.mesh, "upper");

    Random        random;
    GhostedVector u(bodies.n_dofs()), rest(bodies.n_dofs());
    for (unsigned int i = 0; i < u.size(); ++i)
      {
        u[i]    = random(-0.05, 0.05);
        rest[i] = random(-0.05, 0.05);
      }
    const GhostedVector free_forces = elasticity.forces(u, 0);

    // A translation of everything away from the place of rest.
    const double        k = 123;
    const Tensor<1, 2>  d({0.3, -0.2});
    const GhostedVector translated =
      bodies.displacement([&](const Point<2> &X) { return X + d; });
    GhostedVector none(u.size());
    const auto    version = elasticity.tangent_version();
    elasticity.springs.hold({{lower, k}, {upper, 0}}, none);
    check("one body is held",
          elasticity.springs.held() ==
            std::map<unsigned int, SpringStiffness>{{lower, k}});
    check("the tangent is new", elasticity.tangent_version() == version + 1);
    auto sums = resultants(bodies, translated);
    check_small("its force", (sums[lower] - k * d).norm(), 1e-10);
    check_small("force of the other one", sums[upper].norm(), 1e-10);
    check_small("its energy",
                std::abs(elasticity.springs.energy(translated).at(lower) -
                         0.5 * k * d.norm_square()),
                1e-12);

    // From anywhere to anywhere, with another place of rest first.
    elasticity.springs.hold({{lower, k}}, rest);
    check("it is not for another rest",
          elasticity.tangent_version() == version + 1);
    elasticity.springs.hold({{lower, k}, {upper, 2 * k}}, rest);
    check("but for another stiffness",
          elasticity.tangent_version() == version + 2);

    const auto found =
      compare_with_differences(bodies, u, [&](const GhostedVector &u) {
        return energy(elasticity, u);
      });
    check_small("forces against central differences of the energy",
                found.forces,
                1e-8);
    check_small("tangent against those of the forces", found.tangent, 1e-8);

    // Against rotation alone.
    const double kappa = 45, omega = 0.02;
    elasticity.springs.hold({{lower, {0, kappa}}}, none);
    check_small("a translation costs nothing against rotation",
                elasticity.springs.energy(translated).at(lower),
                1e-12);
    const GhostedVector turned = bodies.displacement([&](const Point<2> &X) {
      return Point<2>(X[0] - omega * X[1], X[1] + omega * X[0]);
    });
    check_small("energy of a rotation",
                std::abs(elasticity.springs.energy(turned).at(lower) -
                         0.5 * kappa * omega * omega),
                1e-12);
    elasticity.springs.hold({{lower, {k, kappa}}, {upper, {0, 2 * kappa}}},
                            rest);
    const auto against_rotation =
      compare_with_differences(bodies, u, [&](const GhostedVector &u) {
        return energy(elasticity, u);
      });
    check_small("forces of both against central differences of the energy",
                against_rotation.forces,
                1e-8);
    check_small("tangent of both against those of the forces",
                against_rotation.tangent,
                1e-8);
    const auto last_version = elasticity.tangent_version();

    elasticity.springs.release();
    GhostedVector left = elasticity.forces(u, 0);
    left -= free_forces;
    check("released",
          elasticity.springs.held().empty() &&
            elasticity.springs.energy(u).empty() && left.all_zero());
    check("the tangent is new again",
          elasticity.tangent_version() == last_version + 1);
    elasticity.springs.release();
    check("but once only", elasticity.tangent_version() == last_version + 1);
  }



  // A body of two pieces, of which one is held.
  void hold_a_piece()
  {
    headline("a body of two pieces");
    MeshText mesh;
    mesh.block("body", 2, 2, rectangle({0, 0}, {1, 1}));
    mesh.block("body", 2, 1, rectangle({3, 0}, {5, 1}));
    const Bodies bodies(make_parameters(mesh, {"body"}, 1, "small strain"));
    const MeshPieces<2> &pieces = bodies.mesh.pieces;
    check("two pieces", pieces.size() == 2);
    check("neither is the whole body",
          !pieces.is_whole_body(0) && !pieces.is_whole_body(1));
    check("named by their place",
          bodies.mesh.piece_name(1) ==
            "the piece of the body 'body' from (3, 0) to (5, 1) mm");
    check("no joints", pieces.joints().empty());

    const double        k = 7;
    const Tensor<1, 2>  d({0.3, -0.2});
    const GhostedVector translated =
      bodies.displacement([&](const Point<2> &X) { return X + d; });
    Elasticity<2> &elasticity = *bodies.elasticity;
    elasticity.springs.hold({{1, k}}, GhostedVector(translated.size()));

    const auto   forces     = elasticity.forces(translated, 0);
    const auto   components = bodies.components();
    const auto   X          = bodies.support_points();
    Tensor<1, 2> of_first, of_second;
    for (unsigned int i = 0; i < forces.size(); ++i)
      (X[i][0] < 2 ? of_first : of_second)[components[i]] += forces[i];
    check_small("force on the first", of_first.norm(), 1e-10);
    check_small("on the second", (of_second - k * d).norm(), 1e-10);
  }



  // A body that nothing else holds: the springs carry the force on it, whose
  // energy is at least that of a translation by force over stiffness.
  void push()
  {
    headline("a free body under a force");
    Parameters::All parameters = make_case(1, "small strain");
    parameters.boundary.resultant_force[0]["lower top"] = 7;
    parameters.boundary.displacement[0]["upper top"]    = 0;
    parameters.boundary.displacement[1]["upper top"]    = 0;
    const Bodies   bodies(parameters);
    Elasticity<2> &elasticity = *bodies.elasticity;
    const double   k          = 50;

    DynamicSparsityPattern couplings(bodies.n_dofs(), bodies.n_dofs());
    elasticity.add_couplings(couplings);
    SparsityPattern pattern;
    pattern.copy_from(couplings);
    SparseMatrix<double> matrix(pattern);
    Counters             counters;
    DirectSolver         solver(counters);
    solver.initialize(pattern);

    GhostedVector u(bodies.n_dofs());
    for (unsigned int step = 1; step <= 2; ++step)
      {
        elasticity.springs.hold({{piece_of(bodies.mesh, "lower"), k}}, u);
        GhostedVector rhs(u.size());
        matrix = 0;
        elasticity.assemble(u, 1, rhs, &matrix);
        for (unsigned int i = 0; i < u.size(); ++i)
          if (bodies.discretization.constraints.is_constrained(i))
            matrix.diag_element(i) = 1;
        solver.factorize(matrix);
        solver.solve(rhs);
        u += rhs;

        // Elastic forces add up to nothing: this is the force of the springs.
        check_small("force of step " + std::to_string(step),
                    (resultants(bodies, u).at(bodies.mesh.bodies.at("lower")) -
                     Tensor<1, 2>({7, 0}))
                      .norm(),
                    1e-9);
        const double energy =
          elasticity.springs.energy(u).at(piece_of(bodies.mesh, "lower"));
        check("energy of step " + std::to_string(step) +
                " at least that of a translation",
              energy > 0.5 * 7 * 7 / k * (1 - 1e-10));
      }
  }
} // namespace



int main()
{
  for (const std::string kinematics : {"small strain", "large displacement"})
    for (const unsigned int degree : {1, 2})
      hold(degree, kinematics);
  hold_a_piece();
  push();
  return 0;
}
