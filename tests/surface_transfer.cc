/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of nested iteration with contact: a uniform pressure passes through
// the mortar discretization between meshes with hanging nodes at both surfaces;
// and the points of the finer mesh take over what the points of the coarser one
// know: pressure, shear and bound of friction exactly where they are linear,
// and each end of the contact to within one node.

#include "contact/interface/surface_transfer.h"

#include "condensed_model.h"
#include "refine_bodies.h"

using namespace Tests;

namespace
{
  // Two blocks, refined at both surfaces but not all along them: the nodes that
  // hang on the upright edges there hang on slave and master nodes.
  void
  patch(const unsigned int degree, const bool free, const bool lower_is_slave)
  {
    const double youngs_modulus = 1000, poisson = 0.3, shortening = 0.01;
    MeshText     mesh;
    mesh.block("lower", 4, 2, rectangle({0, -1}, {2, 0}));
    mesh.block("upper", 3, 2, rectangle({0, 0}, {2, 1}));
    Parameters::All parameters = with_centre(make_parameters(mesh,
                                                             {"lower", "upper"},
                                                             degree,
                                                             "small strain",
                                                             youngs_modulus,
                                                             poisson),
                                             free);
    parameters.contact.slave   = "upper bottom";
    parameters.contact.master  = "lower top";
    if (lower_is_slave)
      std::swap(parameters.contact.slave, parameters.contact.master);
    parameters.contact.discretization   = "mortar";
    parameters.boundary.displacement[0] = {{"lower left", 0},
                                           {"upper left", 0}};
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", -shortening}};

    CondensedModel model(parameters);
    const double   pressure =
      youngs_modulus / (1 - poisson * poisson) * shortening / 2;
    double deviation = 0;
    bool   converged = true, in_contact = true, hanging = true;
    for (unsigned int level = 0; level < 3; ++level)
      {
        if (level > 0)
          {
            std::vector<GhostedVector> solutions{model.solution};
            refine(
              model,
              [=](const Point<2> &c) {
                return std::abs(c[0] - (c[1] < 0 ? 1.2 : 0.8)) <
                         0.8 / std::pow(level, 2) &&
                       std::abs(c[1]) < 0.5 / std::pow(2, level - 1);
              },
              solutions);
            model.make_anew(parameters, solutions[0]);
          }
        converged = converged && model.solve(1);
        hanging   = hanging &&
                  (level == 0 || model.mesh.triangulation.has_hanging_nodes());
        for (const ContactPoint<2> &point : points_that_act(*model.interface))
          {
            in_contact = in_contact && point.status.kind == Status::slip;
            deviation  = std::max(
              deviation,
              std::abs(
                model.interface->state(point, model.solution, model.start)
                  .lambda_n -
                pressure) /
                pressure);
          }
        for (const auto &cell : model.elasticity->stresses(model.solution))
          for (const auto &stress : cell)
            deviation = std::max({deviation,
                                  std::abs(stress[1][1] + pressure) / pressure,
                                  std::abs(stress[0][0]) / pressure,
                                  std::abs(stress[0][1]) / pressure});
      }

    // Do nodes hang on slave nodes?
    unsigned int n_hanging = 0;
    for (const Surface<2> *surface : {&model.interface->pairs[0]->slave,
                                      &*model.interface->pairs[0]->master})
      {
        std::set<types::global_dof_index> dofs;
        for (const auto &node : surface->nodes)
          dofs.insert(node.dofs.begin(), node.dofs.end());
        bool found = false;
        for (const auto &line : model.discretization.constraints.get_lines())
          for (const auto &entry : line.entries)
            found =
              found || (line.entries.size() > 1 && dofs.count(entry.first) > 0);
        n_hanging += found;
      }
    const std::string name = element_name(degree, free) + ", slave " +
                             (lower_is_slave ? "below" : "above");
    check(name + ", converged, all in contact", converged && in_contact);
    check(name + ", nodes hang on slave and master nodes",
          hanging && n_hanging == 2);
    check_small(name + ", stress and pressure", deviation, 1e-10);
  }



  /// A strip above another one, and a contact interface between them.
  struct Strips : public Bodies
  {
    explicit Strips(const Parameters::All &parameters)
      : Bodies(parameters)
      , parameters(parameters)
    {
      make_interface();
    }

    void make_interface()
    {
      interface = std::make_unique<ContactInterface<2>>(discretization,
                                                        *elasticity,
                                                        parameters.pairs());
      solution  = GhostedVector(n_dofs() + interface->n_multipliers());
      interface->pair(solution);
    }

    void refine_all()
    {
      interface.reset();
      std::vector<GhostedVector> none;
      flag_all_cells(mesh);
      refine_and_transfer(mesh, discretization, none);
      elasticity =
        std::make_unique<Elasticity<2>>(discretization, parameters.solids);
      make_interface();
    }

    double &pressure(const ContactPoint<2> &point)
    {
      return solution[interface->normal_index(point.multipliers[0])];
    }

    double &shear(const ContactPoint<2> &point)
    {
      return solution[interface->tangential_index(point.multipliers[0])];
    }

    const Parameters::All                parameters;
    std::unique_ptr<ContactInterface<2>> interface;
    GhostedVector                        solution;
  };



  Parameters::All make_strips(const unsigned int degree,
                              const unsigned int n_edges,
                              const std::string &rule)
  {
    MeshText mesh;
    mesh.block("lower", 7, 1, rectangle({-1.5, -1}, {1.5, 0}));
    mesh.block("upper", n_edges, 1, rectangle({-1, 0}, {1, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.friction_coefficient = 0.2;
    return parameters;
  }



  // Pressure, shear and bound are linear, the left half slips.
  void linear_state(const unsigned int degree, const std::string &rule)
  {
    Strips     strips(make_strips(degree, 6, rule));
    const auto p = [](const double x) { return 3 + x; };
    change_points(*strips.interface, [&](ContactPoint<2> &point) {
      const double x         = point.X(0)[0];
      strips.pressure(point) = p(x);
      strips.shear(point)    = -0.1 * p(x);
      point.friction_bound   = 0.2 * p(x);
      point.status           = x < -0.1 ? PointStatus<2>{Status::slip, -1}
                                        : PointStatus<2>{Status::stick, 0};
    });
    const auto state = save_surfaces(*strips.interface, strips.solution);
    strips.refine_all();
    restore_surfaces(state, *strips.interface, strips.solution);

    double error = 0;
    bool   right = points_of_slave(*strips.interface).size() == degree * 12 + 1;
    for (const ContactPoint<2> &point : points_of_slave(*strips.interface))
      {
        const double x = point.X(0)[0];
        error          = std::max({error,
                                   std::abs(strips.pressure(point) - p(x)),
                                   std::abs(strips.shear(point) + 0.1 * p(x)),
                                   std::abs(point.friction_bound - 0.2 * p(x))});
        // The nearer of two points decides, which ends within a third.
        if (x < -0.34)
          right = right && point.status == PointStatus<2>{Status::slip, -1};
        if (x > 0.01)
          right = right && point.status == PointStatus<2>{Status::stick, 0};
      }
    const std::string name =
      rule + " rule, degree " + std::to_string(degree) + ", linear state";
    check(name + ", decisions", right);
    check_small(name + ", pressure, shear and bound", error, 1e-13);
  }



  // The pressure of Hertz from -a - 0.1 to a - 0.1, for many a: how many nodes
  // of the finer mesh, at most, are on the wrong side of an end.
  void end_of_contact(const unsigned int degree, const std::string &rule)
  {
    const double center = -0.1;
    unsigned int worst = 0, total = 0, n_cases = 0;
    for (double a = 0.4; a < 0.8; a += 0.017)
      {
        Strips     strips(make_strips(degree, 24 / degree, rule));
        const auto inside = [=](const ContactPoint<2> &point) {
          return std::abs(point.X(0)[0] - center) < a;
        };
        change_points(*strips.interface, [&](ContactPoint<2> &point) {
          const double x = point.X(0)[0] - center;
          strips.pressure(point) =
            inside(point) ? std::sqrt(a * a - x * x) : 0.;
          point.status =
            inside(point) ? PointStatus<2>{Status::slip, 1} : PointStatus<2>();
        });
        const auto state = save_surfaces(*strips.interface, strips.solution);
        strips.refine_all();
        restore_surfaces(state, *strips.interface, strips.solution);

        unsigned int wrong_left = 0, wrong_right = 0;
        for (const ContactPoint<2> &point : points_of_slave(*strips.interface))
          {
            const bool wrong =
              inside(point) != (point.status.kind == Status::slip);
            (point.X(0)[0] < center ? wrong_left : wrong_right) += wrong;
          }
        worst = std::max({worst, wrong_left, wrong_right});
        total += wrong_left + wrong_right;
        ++n_cases;
      }
    const std::string name =
      rule + " rule, degree " + std::to_string(degree) + ", end of contact";
    check(name + ", one node at most", worst <= 1);
    std::cout << "  " << total << " nodes of " << 2 * n_cases << " ends"
              << std::endl;
  }
} // namespace



int main()
{
  headline("uniform pressure, hanging nodes at the surfaces");
  for_elements([](const unsigned int degree, const bool free) {
    for (const bool lower_is_slave : {false, true})
      patch(degree, free, lower_is_slave);
  });
  headline("the state of the surface");
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "mortar"})
      {
        linear_state(degree, rule);
        end_of_contact(degree, rule);
      }
  return 0;
}
