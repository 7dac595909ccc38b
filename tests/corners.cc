/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves what holds where surfaces have corners or several pieces: a group that
// goes round a corner gives the same points as its face alone, as master and as
// slave, by all rules; a corner on flat ground is pushed along the normal of
// the ground; a master of two pieces is seen on both sides of the hole alike,
// and carries a uniform pressure by its shape functions; what lies behind the
// closest piece is hidden by it; at a vertex of the master neither edge is
// preferred.

#include "contact/mortar/mortar.h"
#include "tests.h"

using namespace Tests;

namespace
{
  using Names = std::vector<std::string>;
  using Move  = std::function<Point<2>(const Point<2> &)>;

  Point<2> stay(const Point<2> &X)
  {
    return X;
  }



  /// Two surfaces, each of one or several groups, in a configuration.
  struct Pair : public Bodies
  {
    Pair(const Parameters::All &parameters,
         const Names           &slave,
         const Names           &master,
         const Move            &move = stay)
      : Bodies(parameters)
      , slave(surface_of(slave, SurfaceCut::into_sides))
      , master(surface_of(master, SurfaceCut::none))
      , u(displacement(move))
    {
    }

    Surface<2> surface_of(const Names &names, const SurfaceCut cut) const
    {
      std::set<types::boundary_id> ids;
      for (const std::string &name : names)
        for (const auto id : mesh.boundary(name, "test"))
          ids.insert(id);
      return Surface<2>(discretization, ids, names.front(), cut);
    }

    std::vector<ContactPoint<2>> mortar() const
    {
      MultiplierSpace                multipliers;
      const MortarDiscretization<2>  rule(slave, master, discretization, {});
      auto                           points = rule.make_points(multipliers);
      const BodyOverlap<2>::Surfaces surfaces{{{&slave}, {&master}}};
      rule.pair(points, u, {}, {surfaces, u});
      return points;
    }

    std::vector<ContactPoint<2>>
    project(std::vector<ContactPoint<2>> points) const
    {
      const DeformedSurface<2> slave_now(slave, u), master_now(master, u);
      for (ContactPoint<2> &point : points)
        pair_with_master(point,
                         directions_of(point, slave_now),
                         master_now,
                         discretization,
                         u);
      return points;
    }

    std::vector<ContactPoint<2>> nodal() const
    {
      MultiplierSpace multipliers;
      return project(make_nodal_points(slave, {}, multipliers));
    }

    std::vector<ContactPoint<2>> gauss() const
    {
      MultiplierSpace multipliers;
      return project(make_gauss_points(slave, 4, multipliers));
    }

    Point<2> position(const ContactPoint<2> &point, const unsigned int a) const
    {
      return point.X(a) + Point<2>(u[point.dofs(a)[0]], u[point.dofs(a)[1]]);
    }

    double gap(const ContactPoint<2> &point) const
    {
      double gap = 0;
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        gap += point.C[a] * (point.normal * position(point, a));
      return gap;
    }

    const Surface<2>    slave, master;
    const GhostedVector u;
  };



  /// The data of the points, by the place of their slave node: the coefficients
  /// by the places of the nodes.
  using Place = std::pair<long, long>;
  using Facts = std::map<Place, std::map<Place, double>>;

  Place place(const Point<2> &X)
  {
    return {std::lround(1e6 * X[0]), std::lround(1e6 * X[1])};
  }



  /// Of all points that face the master; with @p mirror, of the mirror image.
  Facts facts(const std::vector<ContactPoint<2>> &points,
              const bool                          mirror = false)
  {
    const auto at = [&](const Point<2> &X) {
      return place(Point<2>(mirror ? -X[0] : X[0], X[1]));
    };
    Facts facts;
    for (const ContactPoint<2> &point : points)
      if (point.facing)
        {
          auto &values = facts[at(point.X(0))];
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            if (std::abs(point.C[a]) > 1e-10)
              values[at(point.X(a))] += point.weight * point.C[a];
          values[{-999, 0}] = point.weight;
          values[{-999, 1}] = (mirror ? -1 : 1) * point.normal[0];
          values[{-999, 2}] = point.normal[1];
        }
    return facts;
  }



  double difference(const Facts &a, const Facts &b)
  {
    double largest = a.size() == b.size() ? 0 : 1e9;
    for (const auto &[key, values] : a)
      if (b.count(key) == 0 || b.at(key).size() != values.size())
        largest = 1e9;
      else
        for (const auto &[node, value] : values)
          largest = b.at(key).count(node) == 0
                      ? 1e9
                      : std::max(largest, std::abs(value - b.at(key).at(node)));
    return largest;
  }



  /// A wide sole above a pedestal whose sides bulge.
  Parameters::All make_pedestal(const unsigned int degree)
  {
    MeshText mesh;
    mesh.block("ped", 5, 4, [](const double s, const double t) {
      return Point<2>(10 * s - 5, 4 * t - 4);
    });
    mesh.block("up", 14, 2, rectangle({-15, 0}, {15, 3}));
    return make_parameters(mesh, {"ped", "up"}, degree, "small strain");
  }



  // The sole hangs over the pedestal, bent down on both sides.
  Point<2> press(const Point<2> &X)
  {
    const double y = X[1];
    if (y < 0)
      return {X[0] * (1 + 0.03 * y * (y + 4) / -4), y};
    return {X[0], y - 1e-3 * X[0] * X[0]};
  }



  void round_a_corner(const unsigned int degree)
  {
    headline("a group that goes round a corner, degree " +
             std::to_string(degree));
    const auto  parameters = make_pedestal(degree);
    const Names top{"ped top"};
    const Names all{"ped top", "ped left", "ped right"};
    const Names sole{"up bottom"};
    const Pair  one(parameters, sole, top, press),
      two(parameters, sole, all, press);
    check_small("master, mortar",
                difference(facts(one.mortar()), facts(two.mortar())),
                1e-10);
    check_small("master, nodal",
                difference(facts(one.nodal()), facts(two.nodal())),
                1e-10);
    check_small("master, Gauss",
                difference(facts(one.gauss()), facts(two.gauss())),
                1e-10);
    const Pair three(parameters, top, sole, press),
      four(parameters, all, sole, press);
    check_small("slave, mortar",
                difference(facts(three.mortar()), facts(four.mortar())),
                1e-10);
  }



  /// A square that stands on one of its corners, turned by an angle.
  void corner_on_ground(const unsigned int degree, const double angle)
  {
    headline("a corner, its face turned by " + two_digits(angle) +
             " degrees on flat ground, degree " + std::to_string(degree));
    MeshText mesh;
    mesh.block("ground", 7, 1, rectangle({-3, -1}, {3, 0}));
    mesh.block("square", 4, 4, rectangle({0, 10}, {2, 12}));
    const Pair pair(
      make_parameters(mesh, {"ground", "square"}, degree, "small strain"),
      {"square bottom", "square left"},
      {"ground top"},
      [&](const Point<2> &X) {
        if (X[1] < 5)
          return X;
        return Point<2>(Point<2>(0.1, -0.01) +
                        rotation(angle * numbers::PI / 180) *
                          (X - Point<2>(0, 10)));
      });

    double       sideways = 0, off = 0;
    unsigned int n = 0;
    for (const ContactPoint<2> &point : pair.mortar())
      if (point.facing && point.X(0).distance(Point<2>(0, 10)) < 1e-9)
        {
          ++n;
          sideways = std::max(sideways, std::abs(point.normal[0]));
          off      = std::max(off, std::abs(pair.gap(point) + 0.01));
        }
    const auto sees = [&](const double side) { return side < 75 ? 1u : 0u; };
    check("the corner faces the ground by its sides",
          n == sees(angle) + sees(90 - angle));
    check_small("the normal beside that of the ground", sideways, 1e-12);
    check_small("the gap is the height of the corner", off, 1e-12);
  }



  /// Two projections over one line; the hole is within one edge of it, and
  /// edges end in it, too.
  void projection_points(const unsigned int degree)
  {
    headline("a master of two pieces, degree " + std::to_string(degree));
    for (const unsigned int n : {1, 2, 3, 4, 6, 12})
      {
        MeshText mesh;
        mesh.block("left foot", 3, 1, rectangle({-4, 0}, {-1, 1}));
        mesh.block("right foot", 3, 1, rectangle({1, 0}, {4, 1}));
        mesh.block("low", n, 1, rectangle({-6, -1}, {6, 0}));
        const Pair                                pair(make_parameters(mesh,
                                        {"left foot", "right foot", "low"},
                                        degree,
                                        "small strain"),
                        {"low top"},
                        {"left foot bottom", "right foot bottom"});
        const auto                                points = pair.mortar();
        double                                    length = 0, smallest = 1;
        std::map<types::global_dof_index, double> loads;
        for (const ContactPoint<2> &point : points)
          if (point.facing)
            {
              length += point.weight;
              smallest = std::min(smallest, point.weight);
              for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
                loads[point.dofs(a)[0]] -= point.weight * point.C[a];
            }
        double          error = 0;
        MultiplierSpace unused;
        for (const ContactPoint<2> &point :
             make_nodal_points(pair.master, {}, unused))
          error =
            std::max(error, std::abs(loads[point.dofs(0)[0]] - point.weight));
        std::cout << " edges: " << n << std::endl;
        check_small("left and right",
                    difference(facts(points), facts(points, true)),
                    1e-10);
        check_small("weights and length", std::abs(length - 6), 1e-12);
        check("weights are positive", smallest > 0);
        check_small("loads under uniform pressure", error, 1e-10);
      }
  }



  // A plate with both of its faces in the master, and another one behind it.
  void behind(const unsigned int degree)
  {
    headline("pieces one behind the other, degree " + std::to_string(degree));
    MeshText mesh;
    mesh.block("upper", 3, 1, rectangle({0, 0.2}, {3, 1.2}));
    mesh.block("plate", 4, 1, rectangle({-1, -0.1}, {4, 0}));
    mesh.block("floor", 5, 1, rectangle({-1, -1}, {4, -0.15}));
    mesh.block("lid", 5, 1, rectangle({-1, 1.3}, {4, 1.4}));
    const auto  parameters = make_parameters(mesh,
                                            {"upper", "plate", "floor", "lid"},
                                            degree,
                                            "small strain");
    const Names all{"plate top",
                    "plate bottom",
                    "floor top",
                    "lid top",
                    "lid bottom"};
    // In the end deeper than half of the plate.
    for (const double depth : {-0.1, 0., 0.07})
      {
        const Move sink = [&](const Point<2> &X) {
          const bool is_upper = X[1] > 0.1 && X[1] < 1.25;
          return Point<2>(X[0], X[1] - (is_upper ? 0.2 + depth : 0));
        };
        const Pair one(parameters, {"upper bottom"}, {"plate top"}, sink);
        const Pair two(parameters, {"upper bottom"}, all, sink);
        check_small("the closest face only, depth " + two_digits(depth),
                    difference(facts(one.mortar()), facts(two.mortar())),
                    1e-10);
      }
  }



  // A node over the vertex of a roof, seen from outside, and its mirror image.
  void over_a_vertex(const unsigned int degree)
  {
    headline("a slave node over a vertex, degree " + std::to_string(degree));
    MeshText mesh;
    mesh.block("roof", 2, 1, [](const double s, const double t) {
      return Point<2>(2 * s - 1, t - 1 - 0.2 * std::abs(2 * s - 1));
    });
    mesh.block("block", 2, 1, rectangle({-1, 0.1}, {1, 1}));
    const Pair pair(
      make_parameters(mesh, {"roof", "block"}, degree, "small strain"),
      {"block bottom"},
      {"roof top"});
    const auto points = pair.nodal();
    check_small("left and right",
                difference(facts(points), facts(points, true)),
                1e-12);
    for (const ContactPoint<2> &point : points)
      if (std::abs(point.X(0)[0]) < 1e-9)
        {
          check_small("sideways", std::abs(point.normal[0]), 1e-12);
          check_small("gap", std::abs(pair.gap(point) - 0.1), 1e-12);
          double sum = 0, slope = 0;
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            {
              sum += point.C[a];
              slope += point.C1[a];
            }
          check_small("sum of the coefficients", std::abs(sum), 1e-14);
          check_small("and of their derivatives", std::abs(slope), 1e-14);
        }
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      round_a_corner(degree);
      corner_on_ground(degree, 20);
      corner_on_ground(degree, 45);
      projection_points(degree);
      behind(degree);
      over_a_vertex(degree);
    }
  return 0;
}
