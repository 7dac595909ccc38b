/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Contact of bodies of revolution. Proves that contact weights add up to those
// of whole rings; that nothing but the motion along the axis is rigid; that a
// uniform pressure passes from one solid cylinder to another; and that the
// pressure between two tubes is Lame's.

#include "condensed_model.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000, poisson = 0.3;



  // Two cylinders of the radius 3, one on the other.
  Parameters::All two_cylinders(const unsigned int degree,
                                const std::string &rule)
  {
    MeshText mesh;
    mesh.block("lower", 4, 2, rectangle({0, -1}, {3, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {3, 1}));
    auto parameters                     = make_parameters(mesh,
                                      {"lower", "upper"},
                                      degree,
                                      "small strain",
                                      youngs_modulus,
                                      poisson);
    parameters.solids.symmetry          = "axisymmetric";
    parameters.contact.slave            = "upper bottom";
    parameters.contact.master           = "lower top";
    parameters.contact.discretization   = rule;
    parameters.boundary.displacement[1] = {{"lower bottom", 0}};
    parameters.boundary.pressure        = {{"upper top", "10"}};
    return parameters;
  }



  // They add up to the area of the slave, and each is positive. A node on the
  // axis has a weight at degree 1; at degree 2 it has no area, but a gap, and a
  // point of its own.
  void check_weights(const unsigned int degree, const std::string &rule)
  {
    TwoBodies model(two_cylinders(degree, rule));
    model.interface.pair(model.solution);
    double       sum = 0, smallest = 1e9;
    unsigned int n_on_axis = 0;
    for (const ContactPoint<2> &point : model.interface.points())
      {
        if (point.is_master_corner)
          continue;
        const bool on_axis =
          model.discretization.is_on_axis(point.X(0)) && degree == 2;
        n_on_axis += on_axis;
        sum += on_axis && rule != "Gauss" ? 0. : point.weight;
        smallest = std::min(smallest, point.weight);
      }
    const std::string name = "degree " + std::to_string(degree) + ", " + rule;
    check_small(name + ", area", std::abs(sum - 9 * numbers::PI), 1e-12);
    check(name + ", all positive", smallest > 0);
    if (degree == 2 && rule != "Gauss")
      check(name + ", a point on the axis", n_on_axis == 1);
    if (rule == "nodal" && degree == 1)
      {
        // integral (1 - r) 2 pi r dr, where the first edge ends at r = 1.
        check_small(name + ", on the axis",
                    std::abs(smallest - numbers::PI / 3),
                    1e-12);
      }
  }



  void check_motions()
  {
    const auto print = [](const std::string &name, const auto &parameters) {
      const Bodies bodies(parameters);
      std::cout << "  " << name << ':';
      for (const RigidBodyMode &motion :
           rigid_body_modes<2>(bodies.discretization, nullptr))
        std::cout << ' '
                  << bodies.mesh.body_name(
                       bodies.mesh.pieces[motion.piece].body)
                  << ", " << motion.name;
      std::cout << std::endl;
    };
    auto parameters = two_cylinders(1, "mortar");
    print("free", parameters);
    parameters.boundary.displacement[1] = {{"lower bottom left", 0},
                                           {"upper top", 0}};
    print("free, held at a point", parameters);
  }



  // sigma_yy = -10 everywhere, all else vanishes.
  void check_contact(const unsigned int degree, const std::string &slave)
  {
    auto parameters          = two_cylinders(degree, "mortar");
    parameters.contact.slave = slave;
    if (slave == "lower top")
      parameters.contact.master = "upper bottom";
    // Contact has to hold the upper one.
    CondensedModel model(parameters);
    model.start = model.solution;
    model.discretization.constrain_update(model.solution, 1);
    model.pair();
    model.interface->active_set.initialize(model.solution);
    const std::string name =
      "degree " + std::to_string(degree) + ", slave " + slave;
    check(name + ", converged", model.newton(1) > 0);

    double                deviation    = 0;
    const ContactPair<2> &contact_pair = *model.interface->pairs[0];
    for (unsigned int n = 0; n < contact_pair.slave.nodes.size(); ++n)
      deviation =
        std::max(deviation,
                 std::abs(model.interface->pressure(contact_pair.pressure_at(n),
                                                    model.solution) -
                          10));
    check_small(name + ", pressure", deviation, 1e-8);

    SymmetricTensor<2, 3> exact;
    exact[1][1] = -10;
    deviation   = 0;
    for (const auto &cell : model.elasticity->stresses(model.solution))
      for (const auto &stress : cell)
        deviation = std::max(deviation, (stress - exact).norm());
    check_small(name + ", stress", deviation, 1e-8);
  }



  // The displacement at the radius r of a tube from a to b under the pressures
  // p_i inside and p_o outside, in plane strain along the axis (Lame), see
  // parameters/verification/nested_cylinders.prm.
  double lame(const double E,
              const double nu,
              const double a,
              const double b,
              const double p_i,
              const double p_o,
              const double r)
  {
    return (1 + nu) / (E * (b * b - a * a)) *
           ((1 - 2 * nu) * (p_i * a * a - p_o * b * b) * r +
            (p_i - p_o) * a * a * b * b / r);
  }



  // A tube in a tube under the pressure 100 in the bore: how far the pressures
  // between them are from the one with which both move alike.
  double tubes_deviation(const unsigned int degree, const unsigned int n)
  {
    MeshText mesh;
    mesh.block("inner", n, 2, rectangle({20, 0}, {50, 5}));
    mesh.block("outer", n, 3, rectangle({50, 0}, {100, 5}));
    auto parameters                           = make_parameters(mesh,
                                      {"inner", "outer"},
                                      degree,
                                      "small strain",
                                      1000,
                                      0.3);
    parameters.solids.symmetry                = "axisymmetric";
    parameters.solids.youngs_modulus["outer"] = 2000;
    parameters.solids.poisson["outer"]        = 0.25;
    parameters.contact.slave                  = "outer left";
    parameters.contact.master                 = "inner right";
    parameters.contact.discretization         = "mortar";
    parameters.boundary.pressure              = {{"inner left", "100"}};
    parameters.boundary.displacement[1]       = {{"inner bottom", 0},
                                                 {"inner top", 0},
                                                 {"outer bottom", 0},
                                                 {"outer top", 0}};

    CondensedModel model(parameters);
    model.start = model.solution;
    model.pair();
    model.interface->active_set.initialize(model.solution);
    const auto overlap = [](const double q) {
      return lame(1000, 0.3, 20, 50, 100, q, 50) -
             lame(2000, 0.25, 50, 100, q, 0, 50);
    };
    const double q         = overlap(0) / (overlap(0) - overlap(1));
    double       deviation = model.newton(1) > 0 ? 0 : 1;
    for (const unsigned int k : model.interface->pairs[0]->multipliers.of_node)
      deviation =
        std::max(deviation,
                 std::abs(model.solution[model.interface->normal_index(k)] / q -
                          1));
    return deviation;
  }



  // With half the edges the error falls by the power 2 k of the edges.
  void check_tubes()
  {
    for (const unsigned int degree : {1, 2})
      {
        const double      coarse = tubes_deviation(degree, 8);
        const double      fine   = tubes_deviation(degree, 16);
        const std::string name   = "degree " + std::to_string(degree);
        check_small(name + ", pressure", fine, degree == 1 ? 1e-3 : 1e-6);
        check(name + ", order", std::log2(coarse / fine) > 2 * degree - 0.3);
      }
  }
} // namespace



int main()
{
  headline("contact weights");
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss", "mortar"})
      check_weights(degree, rule);

  headline("rigid motions");
  check_motions();

  headline("contact");
  for (const unsigned int degree : {1, 2})
    for (const std::string slave : {"upper bottom", "lower top"})
      check_contact(degree, slave);

  headline("tubes");
  check_tubes();
  return 0;
}
