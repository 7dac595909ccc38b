/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that with friction the tangential row is void at a slave node on a
// symmetry line, and nowhere else; that the system is then regular without any
// node excluded by hand, and the tangential multiplier there is zero; and that
// without friction there are no tangential multipliers.

#include "tests.h"

using namespace Tests;

namespace
{
  Parameters::All make_case(const unsigned int degree, const std::string &rule)
  {
    MeshText mesh;
    mesh.block("lower", 5, 2, rectangle({0, -1}, {2.5, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {1.8, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "large displacement");

    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.friction_coefficient = 0.2;
    parameters.boundary.displacement[0]     = {{"lower left", 0},
                                               {"upper left", 0}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
                                               {"upper top", -0.05}};
    return parameters;
  }



  void print_void_points(const std::string &name, const Parameters::All &p)
  {
    TwoBodies model(p);
    model.pair();
    std::cout << "  " << name << ':';
    unsigned int n_void = 0;
    for (const ContactPoint<2> &point : points_of_slave(model.interface))
      if (point.has_no_free_tangent)
        {
          const auto &edge =
            model.interface.pairs[0]->slave.facets[point.slave_facet];
          const EdgeShape shape(model.interface.pairs[0]->slave.degree,
                                point.slave_xi);
          Point<2>        X;
          for (unsigned int a = 0; a <= model.interface.pairs[0]->slave.degree;
               ++a)
            X += shape.value[a] *
                 model.interface.pairs[0]->slave.nodes[edge.nodes[a]].X;
          std::cout << " (" << X << ')';
          ++n_void;
        }
    std::cout << ' ' << n_void << " of "
              << points_of_slave(model.interface).size() << std::endl;
  }



  void check_case(const unsigned int degree)
  {
    headline("degree " + std::to_string(degree));
    const Parameters::All nodal = make_case(degree, "nodal");
    print_void_points("void", nodal);
    print_void_points("void, Gauss rule", make_case(degree, "Gauss"));

    Parameters::All free = nodal;
    free.boundary.displacement[0].clear();
    print_void_points("void without the symmetry line", free);

    Parameters::All half = nodal;
    half.boundary.displacement[0].erase("lower left");
    print_void_points("void with one body held", half);

    Parameters::All clamped                          = nodal;
    clamped.boundary.displacement[0]["lower bottom"] = 0;
    print_void_points("void with a clamped base", clamped);

    Parameters::All excluded         = nodal;
    excluded.contact.excluded_points = {"upper bottom left"};
    print_void_points("void without the node", excluded);

    // The tangential row of the node is there, yet without consequence.
    TwoBodies model(nodal);
    check("converges", model.solve(1, true) > 0);
    bool   slips_without_direction = true;
    double multiplier = 0, largest = 0;
    for (const ContactPoint<2> &point : points_of_slave(model.interface))
      {
        const double lambda_t =
          model.interface.state(point, model.solution, model.start).lambda_t[0];
        largest = std::max(largest, std::abs(lambda_t));
        if (point.has_no_free_tangent)
          {
            multiplier              = std::abs(lambda_t);
            slips_without_direction = point.status.kind == Status::slip &&
                                      point.status.slip_direction == 0;
          }
      }
    check("its point slips in no direction", slips_without_direction);
    check("other points carry shear", largest > 0.1);
    check_small("its tangential multiplier", multiplier / largest, 1e-12);

    Parameters::All frictionless              = nodal;
    frictionless.contact.friction_coefficient = 0;
    std::cout << "  multipliers with and without friction: "
              << model.interface.n_multipliers() << ", "
              << TwoBodies(frictionless).interface.n_multipliers() << std::endl;
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    check_case(degree);
  return 0;
}
