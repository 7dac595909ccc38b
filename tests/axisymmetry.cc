/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Bodies of revolution. Proves that tangent, forces and energy of rings are
// derivatives of each other; that a uniform stress is in equilibrium under its
// tractions, in hollow and in solid cylinders, for small and for large strain;
// and that loads add up to those of whole rings. Their contact:
// axisymmetric_contact.cc.

#include "derivatives.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000, poisson = 0.3;

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
      make_parameters(mesh, {"body"}, degree, kinematics, youngs_modulus, nu);
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

    Random        random;
    GhostedVector u(bodies.n_dofs());
    for (double &value : u)
      value = random(-0.05, 0.05);

    const auto found =
      compare_with_differences(bodies, u, [&](const GhostedVector &u) {
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
    const double lambda =
      youngs_modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const double mu = youngs_modulus / (2 * (1 + poisson));
    const double tr = 2 * e(a) + e(b);
    const double Px = f(a) * (lambda * tr + 2 * mu * e(a));
    const double Py = f(b) * (lambda * tr + 2 * mu * e(b));

    auto parameters                 = cylinder(bore, degree, kinematics);
    parameters.solids.dilatation    = dilatation;
    parameters.boundary.traction[0] = {{"body right", formula(Px)}};
    parameters.boundary.traction[1] = {{"body top", formula(Py)},
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
                  bodies.elasticity->dead_loads.magnitude(1),
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



  double sum_of(const GhostedVector             &load,
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
                           b.resultant_force[1] = {{"body top", 7}};
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
                           b.traction[1] = {{"body right", "2*y"}};
                         }) -
                         24 * pi),
                1e-12);
    check_small(name + "body force",
                std::abs(load([](auto &b) {
                           b.body_force[1] = {{"body", "3"}};
                         }) -
                         54 * pi),
                1e-12);
  }



  // A mesh left of the axis, or moved off it, is no ring.
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
    auto moved                     = cylinder(0, 2, "small strain");
    moved.boundary.displacement[0] = {{"body left", 0.1}};
    check("a moved axis is refused", refused(moved));
    moved.boundary.displacement[0] = {{"body left", 0}};
    check("a held one is not", !refused(moved));
  }
} // namespace



int main()
{
  headline("derivatives");
  for (const std::string kinematics : {"small strain", "large displacement"})
    for (const std::string dilatation : {"full", "B-bar"})
      {
        check_derivatives(1, "serendipity", kinematics, dilatation);
        check_derivatives(2, "serendipity", kinematics, dilatation);
        check_derivatives(2, "free", kinematics, dilatation);
      }

  headline("uniform stress");
  for (const double bore : {0., 1.})
    for (const unsigned int degree : {1, 2})
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        for (const std::string dilatation : {"full", "B-bar"})
          check_uniform(bore, degree, kinematics, dilatation);

  headline("loads");
  for (const unsigned int degree : {1, 2})
    check_loads(degree);

  headline("errors");
  check_errors();
  return 0;
}
