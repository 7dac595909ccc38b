/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of nested iteration: displacements that both meshes can represent are
// transferred as they are, hanging nodes and supports included; arcs stay round
// where they are refined; the marked cells are the fewest that have their share
// of the error; the slave follows the master where that is asked for; and
// meshes with triangles are refused.

#include "adaptivity/refinement.h"

#include <numeric>

#include "base/errors.h"
#include "refine_bodies.h"

using namespace Tests;

namespace
{
  using Field = std::function<Point<2>(const Point<2> &)>; // X -> x



  /// The largest difference of two vectors.
  double difference(const GhostedVector &a, const GhostedVector &b)
  {
    double difference = a.size() == b.size() ? 0. : 1e9;
    for (unsigned int i = 0; i < a.size() && i < b.size(); ++i)
      difference = std::max(difference, std::abs(a[i] - b[i]));
    return difference;
  }



  /// By how much a displacement misses the constraints between its unknowns.
  double unconstrained(const Bodies &bodies, const GhostedVector &u)
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
      parameters.boundary.displacement[1] = {{"block top", 0.25}};
    Bodies bodies(parameters);

    const Field twice = [&](const Point<2> &X) {
      return X + 2 * (field(X) - X);
    };
    std::vector<GhostedVector> solutions;
    for (const Field &one : {field, twice})
      {
        const auto    u = bodies.displacement(one);
        GhostedVector longer(bodies.n_dofs() + 7);
        std::copy(u.begin(), u.end(), longer.begin());
        solutions.push_back(longer);
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
          for (const GhostedVector &u : solutions)
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
    Bodies                     bodies(parameters);
    std::vector<GhostedVector> none;
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
        const Surface<2> surface = bodies.surface(name);
        n_nodes += surface.nodes.size();
        for (const auto &node : surface.nodes)
          error = std::max(error, std::abs(node.X.distance(center) - radius));
        for (const auto &edge : surface.facets)
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

    // Four cells of each of four indicators, but for round-off.
    indicators = 0;
    for (unsigned int i = 0; i < 16; ++i)
      indicators[5 * i] = (4 - i / 4) * (1 + 1e-5 * (i % 3));
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->clear_refine_flag();
    for (const auto &[fraction, n_marked] :
         {std::pair<double, unsigned int>(0.65, 8), {0.75, 12}})
      {
        flag_cells(bodies.mesh, indicators, fraction);
        n = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
          {
            n += static_cast<bool>(cell->refine_flag_set());
            cell->clear_refine_flag();
          }
        check("of equal cells all or none: " + std::to_string(n_marked),
              n == n_marked);
      }

    // Alike, all cells are refined; one that has all of the error by itself.
    indicators = 1;
    check("toward an accuracy: all of equal cells",
          cheapest_fraction(indicators, 1) > 1 - 1e-12);
    indicators    = 1e-6;
    indicators[7] = 10;
    check("of one cell that has all of the error: that",
          cheapest_fraction(indicators, 2) < 1 &&
            cheapest_fraction(indicators, 2) > 0.99);
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
    std::vector<GhostedVector> none;
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
} // namespace



int main()
{
  transfer_all();
  headline("arcs");
  for_elements(arcs);
  marking();
  slave_like_master();
  triangles();
  return 0;
}
