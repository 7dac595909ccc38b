/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that a corner of the master is seen inside of a slave edge: gap, slip
// and coefficients by hand on one element; that a tip pressed into an edge
// gives what the nodal discretization gives with the roles exchanged, where the
// tip is a slave node, in both linear systems, with friction too; that the
// forces of both bodies balance, and the results hold the force of the corner;
// that flat faces with a slave beyond the corner, whose condition follows from
// those of the nodes, are no singular system; that the ends of a master are
// such points; and that the Gauss rule has none.

#include "condensed_model.h"
#include "contact/results/contact_results.h"

using namespace Tests;

namespace
{
  /// A tip on one element, whose middle is beside it.
  MeshText make_tip()
  {
    MeshText mesh;
    mesh.block("low", 1, 1, rectangle({-0.6, -1}, {1, 0}));
    mesh.block("tip", 2, 2, [](const double s, const double t) {
      return Point<2>(2 * s - 1, (1 - t) * std::abs(2 * s - 1) + 1.5 * t);
    });
    return mesh;
  }



  Parameters::All make_case(const unsigned int degree,
                            const std::string &rule,
                            const double       friction,
                            const bool         exchanged = false)
  {
    Parameters::All parameters =
      make_parameters(make_tip(), {"low", "tip"}, degree, "small strain");
    parameters.contact.slave          = exchanged ? "tip bottom" : "low top";
    parameters.contact.master         = exchanged ? "low top" : "tip bottom";
    parameters.contact.discretization = rule;
    parameters.contact.friction_coefficient = friction;
    parameters.boundary.displacement[0]     = {{"low bottom", 0},
                                               {"tip top", 0.02}};
    parameters.boundary.displacement[1]     = {{"low bottom", 0},
                                               {"tip top", -0.02}};
    return parameters;
  }



  /// The corners of masters that face a slave.
  std::vector<const ContactPoint<2> *>
  facing_corners(const ContactInterface<2> &interface)
  {
    std::vector<const ContactPoint<2> *> corners;
    for (const ContactPoint<2> &point : interface.points())
      if (point.is_master_corner && point.facing)
        corners.push_back(&point);
    return corners;
  }



  void check_signs(const unsigned int degree, const std::string &rule)
  {
    headline("signs, degree " + std::to_string(degree) + ", rule " + rule);
    TwoBodies    model(make_case(degree, rule, 0.3));
    const double up = 0.1, sideways = 0.2;
    for (const auto &node : model.interface.pairs[0]->master->nodes)
      {
        model.solution[node.dofs[0]] = sideways;
        model.solution[node.dofs[1]] = up;
      }
    model.interface.pair(model.solution);

    const auto corners = facing_corners(model.interface);
    check("one corner faces the edge", corners.size() == 1);
    const ContactPoint<2> &corner = *corners[0];
    check_small("the normal is that of the slave, outward",
                (corner.normal - Tensor<1, 2>({0, 1})).norm(),
                1e-12);
    const ContactState<2> now =
      model.interface.state(corner, model.solution, model.start);
    check_small("the gap is the height", std::abs(now.gap - up), 1e-7);
    check_small("the slip is along n turned by +90 degrees",
                std::abs(now.slip[0] + sideways),
                1e-12);
    check_small("own coefficient", std::abs(corner.C[0] - 1), 1e-12);
    double place = 0, sum = 0;
    for (unsigned int a = 1; a < corner.n_nodes; ++a)
      {
        check("of the slave", corner.is_on_slave(a));
        sum += corner.C[a];
        place -= corner.C[a] * corner.X(a)[0];
      }
    check_small("the others add up to minus one", std::abs(sum + 1), 1e-12);
    check_small("and have their centre under the tip",
                std::abs(place - sideways),
                1e-12);
  }



  template<typename Vector>
  double difference(const Vector &a, const Vector &b, const unsigned int n)
  {
    double largest = 0, size = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        size    = std::max(size, std::abs(b[i]));
      }
    return largest / size;
  }



  void check_tip(const unsigned int degree,
                 const std::string &rule,
                 const double       friction)
  {
    headline("pressed and dragged, degree " + std::to_string(degree) +
             ", rule " + rule + ", friction " + two_digits(friction));
    TwoBodies exchanged(make_case(degree, "nodal", friction, true));
    check("exchanged converges", exchanged.solve(1, true) > 0);
    const auto parameters = make_case(degree, rule, friction);
    TwoBodies  model(parameters);
    check("converges", model.solve(1, true) > 0);

    const auto corners = facing_corners(model.interface);
    check("the corner is in contact, and nothing else",
          corners.size() == 1 && corners[0]->status.kind != Status::open &&
            model.interface.active_set.count().active == 1);
    check_small("displacements of both ways",
                difference(model.solution, exchanged.solution, model.n_dofs()),
                2e-6);

    Tensor<1, 2>        on_slave, on_master;
    const GhostedVector forces = model.contact_forces();
    const auto add = [&](const Surface<2> &surface, Tensor<1, 2> &sum) {
      for (const auto &node : surface.nodes)
        for (unsigned int i = 0; i < 2; ++i)
          sum[i] += forces[node.dofs[i]];
    };
    const ContactPair<2> &contact_pair = *model.interface.pairs[0];
    add(contact_pair.slave, on_slave);
    add(*contact_pair.master, on_master);
    check("the tip is pushed up", on_master[1] > 0.1);
    check_small("the bodies push each other",
                (on_slave + on_master).norm() / on_master.norm(),
                1e-12);
    const auto results = contact_results(model.interface,
                                         contact_pair,
                                         model.solution,
                                         model.start);
    check_small("it is the normal force of the results",
                std::abs(results.normal_force / on_master.norm() *
                           std::hypot(1, friction) -
                         1),
                1e-3);
    if (friction > 0)
      check("friction is against the drag", on_master[0] < 0);

    // Paired where the other one has ended.
    if (friction > 0)
      return;
    CondensedModel condensed(parameters, "CHOLMOD", true);
    std::copy_n(model.solution.begin(),
                model.n_dofs(),
                condensed.solution.begin());
    condensed.pair();
    check("condensed converges", condensed.newton(1) > 0);
    check_small("displacements of both systems",
                difference(condensed.solution, model.solution, model.n_dofs()),
                1e-6);
    const auto pressure =
      [](const ContactInterface<2> &interface, const GhostedVector &solution) {
        return interface.state(*facing_corners(interface)[0], solution, solution)
        .lambda_n;
      };
    check_small("and the pressure of the corner",
                std::abs(pressure(*condensed.interface, condensed.solution) /
                           pressure(model.interface, model.solution) -
                         1),
                1e-6);
  }



  /// A block on a wider one that is the slave, all of its sides in the group.
  void check_flat(const unsigned int degree,
                  const std::string &rule,
                  const unsigned int n_low)
  {
    headline("flat, degree " + std::to_string(degree) + ", rule " + rule +
             ", slave edges " + std::to_string(n_low));
    MeshText mesh;
    mesh.block("low", n_low, 2, rectangle({-2, -1}, {2, 0}));
    mesh.block("up", 6, 1, [](const double s, const double t) {
      // Its bottom goes down the left side, along the projection, up the right
      // side.
      const Point<2> skin(std::min(0.9, std::max(-0.9, 5.4 * (s - 0.5))),
                          std::max(0., 2.4 * std::abs(2 * s - 1) - 0.8));
      return skin + t * (Point<2>(1.2 * s - 0.6, 2) - skin);
    });
    Parameters::All parameters =
      make_parameters(mesh, {"low", "up"}, degree, "small strain");
    parameters.contact.slave            = "low top";
    parameters.contact.master           = "up bottom";
    parameters.contact.discretization   = rule;
    parameters.boundary.displacement[0] = {{"low bottom", 0}, {"up top", 0}};
    parameters.boundary.displacement[1] = {{"low bottom", 0},
                                           {"up top", -0.01}};
    TwoBodies model(parameters);
    check("converges", model.solve(1, true) > 0);
    check("two corners face the slave",
          facing_corners(model.interface).size() == 2);
    double depth = 0, tension = 0;
    for (const ContactPoint<2> &point : model.interface.points())
      if (point.facing)
        {
          const ContactState<2> now =
            model.interface.state(point, model.solution, model.start);
          depth   = std::max(depth, -now.gap);
          tension = std::max(tension, -now.lambda_n);
        }
    check_small("depth", depth, 1e-10);
    check_small("tension", tension, 1e-6);
  }



  /// A block whose one end is opposite a single node of the slave, which its
  /// load is beside: that pressure alone cannot balance a moment.
  void check_ends(const unsigned int degree, const std::string &rule)
  {
    headline("ends, degree " + std::to_string(degree) + ", rule " + rule);
    MeshText mesh;
    mesh.block("low", 2, 2, rectangle({-2, -1}, {2, 0}));
    mesh.block("up", 4, 1, rectangle({-0.5, 0}, {0.75, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"low", "up"}, degree, "small strain");
    parameters.contact.slave            = "low top";
    parameters.contact.master           = "up bottom";
    parameters.contact.discretization   = rule;
    parameters.boundary.displacement[0] = {{"low bottom", 0}, {"up top", 0}};
    parameters.boundary.displacement[1] = {{"low bottom", 0},
                                           {"up top", -0.01}};
    TwoBodies model(parameters);
    check("converges", model.solve(1, true) > 0);
    const auto ends  = facing_corners(model.interface);
    double     depth = 0, tension = 0;
    for (const ContactPoint<2> *const point : ends)
      {
        const ContactState<2> now =
          model.interface.state(*point, model.solution, model.start);
        depth   = std::max(depth, -now.gap);
        tension = std::max(tension, -now.lambda_n);
      }
    check("both face the slave", ends.size() == 2);
    check_small("depth", depth, 1e-7);
    check_small("tension", tension, 1e-6);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "mortar"})
      {
        check_signs(degree, rule);
        check_tip(degree, rule, 0);
        check_tip(degree, rule, 0.1);
        // The plain active set of this loop, all points at once, cycles with
        // the nodal discretization at degree 2.
        if (degree == 1 || rule == "mortar")
          for (const unsigned int n_low : {1, 3, 4, 7})
            check_flat(degree, rule, n_low);
      }

  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "mortar"})
      check_ends(degree, rule);

  headline("the Gauss rule");
  check("none with the Gauss rule",
        !TwoBodies(make_case(1, "Gauss", 0))
           .interface.pairs[0]
           ->has_corner_points());
  return 0;
}
