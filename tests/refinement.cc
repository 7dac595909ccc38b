/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of nested iteration: displacements that both meshes can represent are
// transferred as they are, hanging nodes and supports included; arcs stay
// round where they are refined; the marked cells are the fewest that have their
// share of the error; the slave follows the master where that is asked for;
// meshes with triangles are refused; a uniform pressure
// passes through the mortar discretization between meshes with hanging nodes at
// both surfaces; and what the points know reaches the points of the finer mesh.

#include "adaptivity/refinement.h"

#include <numeric>

#include "condensed_model.h"

using namespace Tests;

namespace
{
  using Field  = std::function<Point<2>(const Point<2> &)>; // X -> x
  using Choose = std::function<bool(const Point<2> &center)>;



  Parameters::All with_centre(Parameters::All parameters, const bool free)
  {
    parameters.element.centre_node = free ? "free" : "serendipity";
    return parameters;
  }



  std::string element_name(const unsigned int degree, const bool free)
  {
    return degree == 1 ? "degree 1" : (free ? "9 nodes" : "8 nodes");
  }



  /// Visit degree 1, and degree 2 with 8 and 9 nodes.
  void
  for_elements(const std::function<void(const unsigned int, const bool)> &visit)
  {
    visit(1, false);
    visit(2, false);
    visit(2, true);
  }



  /// Refine the cells whose centres are chosen.
  void refine(Bodies                      &bodies,
              const Choose                &choose,
              std::vector<Vector<double>> &solutions)
  {
    for (const auto &cell : bodies.mesh.triangulation.active_cell_iterators())
      if (choose(cell->center()))
        cell->set_refine_flag();
    refine_and_transfer(bodies.mesh, bodies.discretization, solutions);
  }



  /// The largest difference of two vectors.
  double difference(const Vector<double> &a, const Vector<double> &b)
  {
    double difference = a.size() == b.size() ? 0. : 1e9;
    for (unsigned int i = 0; i < a.size() && i < b.size(); ++i)
      difference = std::max(difference, std::abs(a[i] - b[i]));
    return difference;
  }



  /// By how much a displacement misses the constraints between its unknowns.
  double unconstrained(const Bodies &bodies, const Vector<double> &u)
  {
    const auto &constraints = bodies.discretization.constraints;
    double      worst       = 0;
    for (const auto &line : constraints.get_lines())
      {
        if (bodies.discretization.is_fixed(line.index))
          continue;
        double value = 0;
        for (const auto &[dof, coefficient] : line.entries)
          value += coefficient * u[dof];
        // An unknown that a support moves is in no entry, hence only without
        // one.
        if (!line.entries.empty())
          worst = std::max(worst, std::abs(u[line.index] - value));
      }
    return worst;
  }



  // Two fields at once, the second of which is twice the first one; behind the
  // displacements are numbers that do not count.
  void transfer(const std::string &name,
                const Chart       &chart,
                const Field       &field,
                const bool         with_support,
                unsigned int       degree,
                bool               free)
  {
    MeshText mesh;
    mesh.block("block", 4, 3, chart);
    Parameters::All parameters =
      with_centre(make_parameters(mesh, {"block"}, degree, "small strain"),
                  free);
    if (with_support)
      parameters.boundary.displacement_y = {{"block top", 0.25}};
    Bodies bodies(parameters);

    const Field twice = [&](const Point<2> &X) {
      return X + 2 * (field(X) - X);
    };
    std::vector<Vector<double>> solutions;
    for (const Field &one : {field, twice})
      {
        solutions.push_back(bodies.displacement(one));
        solutions.back().grow_or_shrink(bodies.n_dofs() + 7);
      }

    unsigned int last  = bodies.n_dofs();
    bool         grows = true, hanging = true;
    double       error = 0, broken = 0;
    for (const double radius : {0.7, 0.4, 0.25})
      {
        refine(
          bodies,
          [=](const Point<2> &c) {
            return c.distance({1, 0.4}) < radius;
          },
          solutions);
        error =
          std::max({error,
                    difference(solutions[0], bodies.displacement(field)),
                    difference(solutions[1], bodies.displacement(twice))});
        grows   = grows && bodies.n_dofs() > last;
        hanging = hanging && bodies.mesh.triangulation.has_hanging_nodes();
        last    = bodies.n_dofs();
        if (!with_support)
          for (const Vector<double> &u : solutions)
            broken = std::max(broken, unconstrained(bodies, u));
      }
    check(name + ", grows, with hanging nodes", grows && hanging);
    check_small(name + ", displacement", error, 1e-14);
    if (!with_support)
      check_small(name + ", constraints", broken, 1e-14);
  }



  void transfer_all()
  {
    headline("displacements carried over");
    const Chart square    = rectangle({0, 0}, {2, 1});
    const Chart distorted = [](const double s, const double t) {
      return Point<2>(2 * s + 0.3 * s * t * (1 - s),
                      t + 0.2 * s * (1 - t) + 0.1 * std::sin(5 * s) * t);
    };
    const Field linear = [](const Point<2> &X) {
      return Point<2>(1.1 * X[0] + 0.2 * X[1] + 0.1, -0.3 * X[0] + 1.2 * X[1]);
    };
    const Field lifted = [](const Point<2> &X) {
      return Point<2>(1.1 * X[0] - 0.3 * X[1], 1.25 * X[1]);
    };
    const Field quadratic = [](const Point<2> &X) {
      return X + 0.1 * Point<2>(X[0] * X[0] - 2 * X[0] * X[1],
                                X[1] * X[1] + X[0] * X[1] - X[0] * X[0]);
    };
    for_elements([&](const unsigned int degree, const bool free) {
      const std::string name = element_name(degree, free);
      transfer(name + ", linear", distorted, linear, false, degree, free);
      transfer(name + ", support", square, lifted, true, degree, free);
      if (degree == 2)
        transfer(name + ", quadratic", square, quadratic, false, 2, free);
    });
  }



  // A block with a round bottom and a round top, refined towards both.
  void arcs(const unsigned int degree, const bool free)
  {
    const Point<2> center(0, 3);
    const double   below = 3, above = 1.5;
    MeshText       mesh;
    mesh.block("block", 5, 3, [=](const double s, const double t) {
      const double angle = 1.2 * (s - 0.5);
      return center + (below + t * (above - below)) *
                        Point<2>(std::sin(angle), -std::cos(angle));
    });
    Parameters::All parameters =
      with_centre(make_parameters(mesh, {"block"}, degree, "small strain"),
                  free);
    parameters.mesh.arcs = {{"block bottom", {0, 3, below}},
                            {"block top", {0, 3, above}}};
    Bodies                      bodies(parameters);
    std::vector<Vector<double>> none;
    for (const double reach : {0.3, 0.15, 0.07})
      refine(
        bodies,
        [=](const Point<2> &c) {
          const double r = c.distance(center);
          return c[0] < 0.2 && (r > below - reach || r < above + reach);
        },
        none);

    double       error = 0, longest = 0, shortest = 1e9;
    unsigned int n_nodes = 0;
    for (const auto &[name, radius] :
         {std::make_pair("block bottom", below), {"block top", above}})
      {
        const Surface surface = bodies.surface(name);
        n_nodes += surface.nodes.size();
        for (const auto &node : surface.nodes)
          error = std::max(error, std::abs(node.X.distance(center) - radius));
        for (const auto &edge : surface.edges)
          {
            const double h = surface.nodes[edge.nodes[0]].X.distance(
              surface.nodes[edge.nodes[1]].X);
            longest  = std::max(longest, h);
            shortest = std::min(shortest, h);
          }
      }
    check(element_name(degree, free) + ", edges of different levels",
          bodies.mesh.triangulation.has_hanging_nodes() &&
            longest > 3 * shortest);
    check_small("distance of its nodes from the circles", error, 1e-14);
  }



  void marking()
  {
    headline("marked cells");
    MeshText mesh;
    mesh.block("block", 20, 20, rectangle({0, 0}, {1, 1}));
    Bodies        bodies(make_parameters(mesh, {"block"}, 1, "small strain"));
    const auto   &triangulation = bodies.mesh.triangulation;
    Random        random;
    Vector<float> indicators(triangulation.n_active_cells());
    for (float &value : indicators)
      value = std::pow(random(0.1, 1), 4);
    const double total =
      std::accumulate(indicators.begin(), indicators.end(), 0.);

    for (const double fraction : {0.1, 0.5, 0.9})
      {
        flag_cells(bodies.mesh, indicators, fraction);
        double marked = 0, smallest = 1e9, largest_unmarked = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
          {
            const double value = indicators[cell->active_cell_index()];
            if (cell->refine_flag_set())
              {
                marked += value;
                smallest = std::min(smallest, value);
              }
            else
              largest_unmarked = std::max(largest_unmarked, value);
            cell->clear_refine_flag();
          }
        check("a share of " + two_digits(fraction) + ", and no cell too many",
              marked >= fraction * total &&
                marked - smallest < fraction * total &&
                smallest >= largest_unmarked);
      }

    flag_cells(bodies.mesh, indicators, 1);
    unsigned int n = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        n += static_cast<bool>(cell->refine_flag_set());
        cell->clear_refine_flag();
      }
    check("all of it: all cells", n == triangulation.n_active_cells());
    flag_all_cells(bodies.mesh);
    n = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      n += static_cast<bool>(cell->refine_flag_set());
    check("all cells flagged", n == triangulation.n_active_cells());
  }



  // Proves that next to a part of the master that is refined the slave is
  // refined until its edges are as short, and nowhere else.
  void slave_like_master()
  {
    headline("slave like master");
    MeshText mesh;
    mesh.block("lower", 16, 2, rectangle({0, -1}, {16, 0}));
    mesh.block("upper", 8, 2, rectangle({0, 0}, {16, 2}));
    Bodies bodies(make_parameters(mesh, {"lower", "upper"}, 1, "small strain"));
    const auto &triangulation = bodies.mesh.triangulation;
    const auto  slave         = bodies.mesh.boundary("upper bottom", "");
    const auto  master        = bodies.mesh.boundary("lower top", "");
    const auto  flagged       = [&]() {
      std::set<std::pair<double, double>> centers;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->refine_flag_set() && cell->center()[1] > 0)
          centers.insert({cell->center()[0], cell->center()[1]});
      return centers;
    };
    const auto choose = [&](const Choose &choose) {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (choose(cell->center()))
          cell->set_refine_flag();
      flag_slave_like_master(bodies.mesh, slave, master);
    };
    using Centers = std::set<std::pair<double, double>>;

    // Edges of 1 mm from 5 to 6 are halved; those of the slave have 2 mm.
    choose([](const Point<2> &c) {
      return c[1] > -0.5 && c[1] < 0 && c[0] > 5 && c[0] < 6;
    });
    check("slaves beside it", flagged() == Centers({{5, 0.5}, {7, 0.5}}));
    std::vector<Vector<double>> none;
    refine_and_transfer(bodies.mesh, bodies.discretization, none);

    // Now there is 1 mm on both sides from 4 to 8, but for the refined edge.
    choose([](const Point<2>) { return false; });
    check("nothing refined, nothing to follow", flagged().empty());
    choose([](const Point<2> &c) {
      return c[1] > -0.5 && c[1] < 0 && c[0] > 6 && c[0] < 7;
    });
    check("slaves as long as it follow, once",
          flagged() == Centers({{5.5, 0.25}, {6.5, 0.25}, {7.5, 0.25}}));
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->clear_refine_flag();
    choose(
      [](const Point<2> &c) { return c[1] < -0.5 && c[0] > 6 && c[0] < 7; });
    check("what is refined inside, nobody follows", flagged().empty());
  }



  void triangles()
  {
    headline("adaptive refinement");
    for (const bool split : {false, true})
      {
        MeshText mesh;
        mesh.block("block",
                   2,
                   2,
                   rectangle({0, 0}, {1, 1}),
                   [=](const unsigned int i, const unsigned int j) {
                     return split && i == 1 && j == 1;
                   });
        const Bodies bodies(
          make_parameters(mesh, {"block"}, 1, "small strain"));
        try
          {
            check_adaptive(bodies.mesh);
            std::cout << "  accepted" << std::endl;
          }
        catch (const InputError &error)
          {
            std::cout << "  refused: "
                      << std::string(error.what())
                           .substr(0, std::string(error.what()).find('\n'))
                      << std::endl;
          }
      }
  }



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
    parameters.contact.discretization  = "mortar";
    parameters.boundary.displacement_x = {{"lower left", 0}, {"upper left", 0}};
    parameters.boundary.displacement_y = {{"lower bottom", 0},
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
            std::vector<Vector<double>> solutions{model.solution};
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
        for (const ContactPoint &point : model.interface->points)
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
    for (const Surface *surface : {&model.interface->pairs[0]->slave,
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
      interface = std::make_unique<ContactInterface>(discretization,
                                                     *elasticity,
                                                     parameters.pairs());
      solution.reinit(n_dofs() + interface->n_multipliers());
      interface->pair(solution);
    }

    void refine_all()
    {
      interface.reset();
      std::vector<Vector<double>> none;
      flag_all_cells(mesh);
      refine_and_transfer(mesh, discretization, none);
      elasticity = Elasticity::create(discretization, parameters.solids);
      make_interface();
    }

    double &pressure(const ContactPoint &point)
    {
      return solution[interface->normal_index(point.multipliers[0])];
    }

    double &shear(const ContactPoint &point)
    {
      return solution[interface->tangential_index(point.multipliers[0])];
    }

    const Parameters::All             parameters;
    std::unique_ptr<ContactInterface> interface;
    Vector<double>                    solution;
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
    for (ContactPoint &point : strips.interface->points)
      {
        const double x         = point.X[0][0];
        strips.pressure(point) = p(x);
        strips.shear(point)    = -0.1 * p(x);
        point.friction_bound   = 0.2 * p(x);
        point.status           = x < -0.1 ? PointStatus{Status::slip, -1}
                                          : PointStatus{Status::stick, 0};
      }
    const auto state = strips.interface->save(strips.solution);
    strips.refine_all();
    strips.interface->restore(state, strips.solution);

    double error = 0;
    bool   right = strips.interface->points.size() == degree * 12 + 1;
    for (const ContactPoint &point : strips.interface->points)
      {
        const double x = point.X[0][0];
        error          = std::max({error,
                                   std::abs(strips.pressure(point) - p(x)),
                                   std::abs(strips.shear(point) + 0.1 * p(x)),
                                   std::abs(point.friction_bound - 0.2 * p(x))});
        // The nearer of two points decides, which ends within a third.
        if (x < -0.34)
          right = right && point.status == PointStatus{Status::slip, -1};
        if (x > 0.01)
          right = right && point.status == PointStatus{Status::stick, 0};
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
        const auto inside = [=](const ContactPoint &point) {
          return std::abs(point.X[0][0] - center) < a;
        };
        for (ContactPoint &point : strips.interface->points)
          {
            const double x = point.X[0][0] - center;
            strips.pressure(point) =
              inside(point) ? std::sqrt(a * a - x * x) : 0.;
            point.status =
              inside(point) ? PointStatus{Status::slip, 1} : PointStatus();
          }
        const auto state = strips.interface->save(strips.solution);
        strips.refine_all();
        strips.interface->restore(state, strips.solution);

        unsigned int wrong_left = 0, wrong_right = 0;
        for (const ContactPoint &point : strips.interface->points)
          {
            const bool wrong =
              inside(point) != (point.status.kind == Status::slip);
            (point.X[0][0] < center ? wrong_left : wrong_right) += wrong;
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
  transfer_all();
  headline("arcs");
  for_elements(arcs);
  marking();
  slave_like_master();
  triangles();
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
}
