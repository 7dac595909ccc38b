/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Bodies of revolution. Proves that tangent, forces and energy of rings are
// derivatives of each other; that a uniform stress is in equilibrium under its
// tractions, in hollow and in solid cylinders, for small and for large strain;
// that loads and contact weights add up to those of whole rings; that nothing
// but the motion along the axis is rigid; that a uniform pressure passes from
// one solid cylinder to another; and that the pressure between two tubes is
// Lame's.

#include "condensed_model.h"
#include "derivatives.h"
#include "solvers/free_motions.h"

using namespace Tests;

namespace
{
  const double young = 1000, poisson = 0.3;

  const MeshText::Choice mixed =
    [](const unsigned int i, const unsigned int j) { return i == 1 && j == 1; };



  // A cylinder of the height 2 from the radius @p bore to 3, whose inner nodes
  // are not on a grid.
  Parameters::All cylinder(const double       bore,
                           const unsigned int degree,
                           const std::string &kinematics,
                           const double       nu = poisson)
  {
    MeshText mesh;
    mesh.block(
      "body",
      3,
      3,
      [=](const double s, const double t) {
        const double bump = s * (1 - s) * t * (1 - t);
        return Point<2>(bore + (3 - bore) * s + bump, 2 * t - 0.7 * bump);
      },
      mixed);
    auto parameters =
      make_parameters(mesh, {"body"}, degree, kinematics, young, nu);
    parameters.solids.symmetry = "axisymmetric";
    return parameters;
  }



  /// All digits.
  std::string formula(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
  }



  void check_derivatives(const unsigned int degree,
                         const std::string &centre_node,
                         const std::string &kinematics,
                         const std::string &dilatation)
  {
    const std::string name = "degree " + std::to_string(degree) +
                             (degree == 2 ? ", centre " + centre_node : "") +
                             ", " + kinematics + ", " + dilatation;
    auto parameters                = cylinder(0.5, degree, kinematics, 0.46);
    parameters.element.centre_node = centre_node;
    parameters.solids.dilatation   = dilatation;
    const Bodies bodies(parameters);

    Random         random;
    Vector<double> u(bodies.n_dofs());
    for (double &value : u)
      value = random(-0.05, 0.05);

    const auto found =
      compare_with_differences(bodies, u, [&](const Vector<double> &u) {
        return bodies.elasticity->strain_energy(u);
      });
    check_small(name + ", forces", found.forces, 1e-7);
    check_small(name + ", tangent", found.tangent, 1e-8);
    check_small(name + ", asymmetry", found.asymmetry, 1e-13);
  }



  // The homogeneous motion (1 + a) r, (1 + b) y strains uniformly by E =
  // (e(a), e(a), e(b)), e(h) = h or h + h^2/2. Its dead tractions by undeformed
  // area are P = F S, its true stress P/(a stretch of the area).
  void check_uniform(const double       bore,
                     const unsigned int degree,
                     const std::string &kinematics,
                     const std::string &dilatation)
  {
    const bool   small = kinematics == "small strain";
    const double a     = small ? -0.01 : -0.1;
    const double b     = small ? 0.02 : 0.2;

    const auto   e = [&](const double h) { return small ? h : h + h * h / 2; };
    const auto   f = [&](const double h) { return small ? 1. : 1 + h; };
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const double mu     = young / (2 * (1 + poisson));
    const double tr     = 2 * e(a) + e(b);
    const double Px     = f(a) * (lambda * tr + 2 * mu * e(a));
    const double Py     = f(b) * (lambda * tr + 2 * mu * e(b));

    auto parameters                = cylinder(bore, degree, kinematics);
    parameters.solids.dilatation   = dilatation;
    parameters.boundary.traction_x = {{"body right", formula(Px)}};
    parameters.boundary.traction_y = {{"body top", formula(Py)},
                                      {"body bottom", formula(-Py)}};
    if (bore > 0)
      parameters.boundary.pressure["body left"] = formula(-Px);
    const Bodies bodies(parameters);
    const auto   u = bodies.displacement([&](const Point<2> &X) {
      return Point<2>((1 + a) * X[0], (1 + b) * X[1]);
    });

    const std::string name = (bore > 0 ? "hollow, degree " : "solid, degree ") +
                             std::to_string(degree) + ", " + kinematics + ", " +
                             dilatation;
    check_small(name + ", forces",
                bodies.elasticity->forces(u, 1).linfty_norm() /
                  bodies.elasticity->dead_loads.whole(),
                1e-12);

    SymmetricTensor<2, 3> exact;
    exact[0][0] = exact[2][2] = Px / (f(a) * f(b));
    exact[1][1]               = Py / (f(a) * f(a));
    double deviation          = 0;
    for (const auto &cell : bodies.elasticity->stresses(u))
      for (const auto &stress : cell)
        deviation = std::max(deviation, (stress - exact).norm() / exact.norm());
    check_small(name + ", stress", deviation, 1e-12);
  }



  double sum_of(const Vector<double>            &load,
                const std::vector<unsigned int> &components,
                const unsigned int               c)
  {
    double sum = 0;
    for (unsigned int i = 0; i < load.size(); ++i)
      if (components[i] == c)
        sum += load[i];
    return sum;
  }



  // Of the forces only those along the axis add up to something: on the top
  // with 9 pi mm^2, on the outside with 12 pi mm^2, in 18 pi mm^3.
  void check_loads(const unsigned int degree)
  {
    const double pi   = numbers::PI;
    const auto   load = [&](const auto &set) {
      auto parameters = cylinder(0, degree, "small strain");
      set(parameters.boundary);
      const Bodies bodies(parameters);
      return sum_of(bodies.elasticity->dead_loads.at(1),
                    bodies.components(),
                    1);
    };
    const std::string name = "degree " + std::to_string(degree) + ", ";
    check_small(name + "spread force",
                std::abs(load([](auto &b) {
                           b.spread_force_y = {{"body top", 7}};
                         }) -
                         7),
                1e-12);
    check_small(name + "pressure",
                std::abs(load([](auto &b) {
                           b.pressure = {{"body top", "2"}};
                         }) +
                         18 * pi),
                1e-12);
    check_small(name + "traction",
                std::abs(load([](auto &b) {
                           b.traction_y = {{"body right", "2*y"}};
                         }) -
                         24 * pi),
                1e-12);
    check_small(name + "body force",
                std::abs(load([](auto &b) {
                           b.body_force_y = {{"body", "3"}};
                         }) -
                         54 * pi),
                1e-12);
  }



  // Two cylinders of the radius 3, one on the other.
  Parameters::All two_cylinders(const unsigned int degree,
                                const std::string &rule)
  {
    MeshText mesh;
    mesh.block("lower", 4, 2, rectangle({0, -1}, {3, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {3, 1}));
    auto parameters                    = make_parameters(mesh,
                                      {"lower", "upper"},
                                      degree,
                                      "small strain",
                                      young,
                                      poisson);
    parameters.solids.symmetry         = "axisymmetric";
    parameters.contact.slave           = "upper bottom";
    parameters.contact.master          = "lower top";
    parameters.contact.rule            = rule;
    parameters.boundary.displacement_y = {{"lower bottom", 0}};
    parameters.boundary.pressure       = {{"upper top", "10"}};
    return parameters;
  }



  // They add up to the area of the slave, and each is positive. A node on the
  // axis has a weight at degree 1; at degree 2 it has no area, but a gap, and a
  // point of its own.
  void check_weights(const unsigned int degree, const std::string &rule)
  {
    ContactModel model(two_cylinders(degree, rule));
    model.interface.pair(model.solution);
    double       sum = 0, smallest = 1e9;
    unsigned int n_on_axis = 0;
    for (const ContactPoint &point : model.interface.points)
      {
        const bool on_axis =
          model.discretization.is_on_axis(point.X[0]) && degree == 2;
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
      for (const FreeMotion &motion :
           free_motions(bodies.discretization, nullptr))
        std::cout << ' '
                  << bodies.mesh.body_name(
                       bodies.mesh.pieces[motion.piece].body)
                  << ", " << motion.name;
      std::cout << std::endl;
    };
    auto parameters = two_cylinders(1, "mortar");
    print("free", parameters);
    parameters.boundary.displacement_y = {{"lower bottom left", 0},
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
    model.interface->initialize_status(model.solution);
    const std::string name =
      "degree " + std::to_string(degree) + ", slave " + slave;
    check(name + ", converged", model.newton(1) > 0);

    double             deviation = 0;
    const ContactZone &zone      = *model.interface->zones[0];
    for (unsigned int n = 0; n < zone.slave.nodes.size(); ++n)
      deviation =
        std::max(deviation,
                 std::abs(model.interface->pressure(zone.pressure_at(n),
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
    auto parameters                    = make_parameters(mesh,
                                      {"inner", "outer"},
                                      degree,
                                      "small strain",
                                      1000,
                                      0.3);
    parameters.solids.symmetry         = "axisymmetric";
    parameters.solids.young["outer"]   = 2000;
    parameters.solids.poisson["outer"] = 0.25;
    parameters.contact.slave           = "outer left";
    parameters.contact.master          = "inner right";
    parameters.contact.rule            = "mortar";
    parameters.boundary.pressure       = {{"inner left", "100"}};
    parameters.boundary.displacement_y = {{"inner bottom", 0},
                                          {"inner top", 0},
                                          {"outer bottom", 0},
                                          {"outer top", 0}};

    CondensedModel model(parameters);
    model.start = model.solution;
    model.pair();
    model.interface->initialize_status(model.solution);
    const auto overlap = [](const double q) {
      return lame(1000, 0.3, 20, 50, 100, q, 50) -
             lame(2000, 0.25, 50, 100, q, 0, 50);
    };
    const double q         = overlap(0) / (overlap(0) - overlap(1));
    double       deviation = model.newton(1) > 0 ? 0 : 1;
    for (unsigned int k = 0; k < model.interface->n_multipliers(); ++k)
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



  // What is left of the axis, or moved off it, is no ring.
  void check_errors()
  {
    const auto refused = [](const Parameters::All &parameters) {
      try
        {
          Bodies bodies(parameters);
        }
      catch (const InputError &)
        {
          return true;
        }
      return false;
    };
    check("a negative radius is refused",
          refused(cylinder(-0.1, 1, "small strain")));
    auto moved                    = cylinder(0, 2, "small strain");
    moved.boundary.displacement_x = {{"body left", 0.1}};
    check("a moved axis is refused", refused(moved));
    moved.boundary.displacement_x = {{"body left", 0}};
    check("a held one is not", !refused(moved));
  }
} // namespace



int main()
{
  headline("derivatives");
  for (const std::string kinematics : {"small strain", "large displacement"})
    for (const std::string dilatation : {"full", "projected"})
      {
        check_derivatives(1, "bound", kinematics, dilatation);
        check_derivatives(2, "bound", kinematics, dilatation);
        check_derivatives(2, "free", kinematics, dilatation);
      }

  headline("uniform stress");
  for (const double bore : {0., 1.})
    for (const unsigned int degree : {1, 2})
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        for (const std::string dilatation : {"full", "projected"})
          check_uniform(bore, degree, kinematics, dilatation);

  headline("loads");
  for (const unsigned int degree : {1, 2})
    check_loads(degree);

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

  headline("errors");
  check_errors();
}
