/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves what the mortar discretization claims of its points: of the slave side
// only the node itself is in a point; a rigid shift is no gap, and the weights
// sum up to the length that both surfaces share; where the surfaces coincide,
// node pairs are found if the nodes match, and a uniform pressure gives every
// node of the master its integral in any case; all weights are positive,
// however little of an edge faces the master; the tangential offset is zero
// also across a gap; turning everything changes no coefficient; the rows are
// the derivatives of gap and slip.

#include "contact/mortar.h"

#include "tests.h"

using namespace Tests;

namespace
{
  using Line = std::vector<double>; // the vertices along a surface
  using Move = std::function<Point<2>(const Point<2> &)>;

  Point<2> stay(const Point<2> &X)
  {
    return X;
  }



  /// From a to b in n equal parts.
  Line even(const double a, const double b, const unsigned int n)
  {
    Line line;
    for (unsigned int i = 0; i <= n; ++i)
      line.push_back(a + (b - a) * i / n);
    return line;
  }



  /// Two strips, the slave above the line y = 0 and the master below it.
  Parameters::All make_strips(const unsigned int degree,
                              const Line        &slave,
                              const Line        &master,
                              const double       gap = 0)
  {
    const auto strip = [](const Line &line, const double low) {
      return [=](const double s, const double t) {
        return Point<2>(line[std::lround((line.size() - 1) * s)], low + t);
      };
    };
    MeshText mesh;
    mesh.block("lower", master.size() - 1, 1, strip(master, -1));
    mesh.block("upper", slave.size() - 1, 1, strip(slave, gap));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "large displacement");
    parameters.contact.slave          = "upper bottom";
    parameters.contact.master         = "lower top";
    parameters.contact.discretization = "mortar";
    return parameters;
  }



  /// The points of the mortar discretization in a configuration.
  struct Pairing : public Bodies
  {
    Pairing(const Parameters::All        &parameters,
            const Move                   &move,
            const std::set<unsigned int> &excluded = {})
      : Bodies(parameters)
      , slave(surface(parameters.contact.slave))
      , master(surface(parameters.contact.master))
      , u(displacement(move))
    {
      const MortarDiscretization rule(slave, master, discretization, excluded);
      points = rule.make_points(multipliers);
      rule.pair(points, u);
    }

    Point<2> position(const ContactPoint &point, const unsigned int a) const
    {
      return point.X[a] + Point<2>(u[point.dofs[a][0]], u[point.dofs[a][1]]);
    }

    /// sum C x: the weighted gap vector.
    Tensor<1, 2> offset(const ContactPoint &point) const
    {
      Tensor<1, 2> sum;
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        sum += point.C[a] * position(point, a);
      return sum;
    }

    /// The largest value of a function over the points that face the master.
    double
    largest(const std::function<double(const ContactPoint &)> &value) const
    {
      double result = 0;
      for (const ContactPoint &point : points)
        if (point.facing)
          result = std::max(result, value(point));
      return result;
    }

    /// The weights of these points together.
    double shared_length() const
    {
      double sum = 0;
      for (const ContactPoint &point : points)
        sum += point.facing ? point.weight : 0;
      return sum;
    }

    bool all_facing() const
    {
      return std::all_of(points.begin(),
                         points.end(),
                         [](const ContactPoint &p) { return p.facing; });
    }

    const Surface             slave, master;
    const Vector<double>      u;
    MultiplierSpace           multipliers;
    std::vector<ContactPoint> points;
  };



  double sum_of_coefficients(const ContactPoint &point)
  {
    return std::abs(std::accumulate(point.C.begin(), point.C.end(), 0.));
  }



  /// By how much the slave side is more than the node itself.
  double beside_the_node(const ContactPoint &point)
  {
    double sum = std::abs(point.C[0] - 1);
    for (unsigned int a = 1; a < point.n_slave_nodes; ++a)
      sum += std::abs(point.C[a]);
    return sum;
  }



  /// The properties of every pairing.
  void check_points(const Pairing &pairing, const double length)
  {
    check_small("sum of the coefficients",
                pairing.largest(sum_of_coefficients),
                1e-12);
    check_small("tangential offset",
                pairing.largest([&](const ContactPoint &point) {
                  return std::abs(point.tangent * pairing.offset(point));
                }),
                1e-11);
    check_small("weights and length",
                std::abs(pairing.shared_length() - length),
                1e-12);
  }



  const Line uneven_slave{0, 0.7, 1, 2.2, 2.5};
  const Line uneven_master{-0.8, 0.3, 0.9, 1.6, 1.7, 3.5};



  /// The points above y = 0.05 on a circle from above, the rest on another one.
  Point<2> bend(const Point<2> &X)
  {
    const bool     is_slave = X[1] > 0.05;
    const double   radius   = is_slave ? 2 : 6;
    const Point<2> center(1.3, is_slave ? 2.1 : 6);
    const double   angle = (X[0] - center[0]) / radius;
    const double   r     = radius - (X[1] - (is_slave ? 0.1 : 0));
    return center + r * Point<2>(std::sin(angle), -std::cos(angle));
  }



  void inside(const unsigned int degree, const bool bent)
  {
    headline(std::string(bent ? "bent" : "straight") +
             ", slave within the master, degree " + std::to_string(degree));
    const Pairing pairing(make_strips(degree, uneven_slave, uneven_master, 0.1),
                          bent ? bend : stay);
    check("all points face the master", pairing.all_facing());
    check_points(pairing, 2.5);
    check_small("slave nodes beside the own one",
                pairing.largest(beside_the_node),
                1e-12);
    check("the gap is open at all of them",
          pairing.largest([&](const ContactPoint &point) {
            return -point.normal * pairing.offset(point);
          }) == 0);
  }



  // Nodes that face each other: what the nodal discretization would find.
  void matching(const unsigned int degree)
  {
    headline("nodes that match, degree " + std::to_string(degree));
    const Pairing pairing(make_strips(degree, uneven_slave, uneven_slave),
                          stay);
    check("all points face the master", pairing.all_facing());
    check_points(pairing, 2.5);
    check("pairs of two nodes", pairing.largest([](const ContactPoint &point) {
      return point.n_nodes;
    }) == 2);
    check_small("distance of the partners",
                pairing.largest([](const ContactPoint &point) {
                  return point.X[0].distance(point.X[1]);
                }),
                1e-13);
    check_small("coefficients but one and minus one",
                pairing.largest([](const ContactPoint &point) {
                  return std::abs(point.C[0] - 1) + std::abs(point.C[1] + 1);
                }),
                1e-12);
  }



  /// The loads on the nodes of the master under a pressure of one.
  std::map<types::global_dof_index, double>
  loads_on_master(const Pairing &pairing)
  {
    std::map<types::global_dof_index, double> loads;
    for (const ContactPoint &point : pairing.points)
      for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
        loads[point.dofs[a][0]] -= point.weight * point.C[a];
    return loads;
  }



  /// By how much these differ from the integrals of the shape functions, the
  /// weights of the nodal discretization, relative to them.
  double error_of_loads(const Pairing &pairing)
  {
    auto            loads = loads_on_master(pairing);
    double          error = 0;
    MultiplierSpace unused;
    for (const ContactPoint &point :
         make_nodal_points(pairing.master, {}, unused))
      error =
        std::max(error, std::abs(loads[point.dofs[0][0]] / point.weight - 1));
    return error;
  }



  void
  coinciding(const unsigned int degree, const Line &slave, const Line &master)
  {
    const Pairing pairing(make_strips(degree, slave, master), stay);
    check("all points face the master", pairing.all_facing());
    check_points(pairing, slave.back() - slave.front());
    check_small("slave nodes beside the own one",
                pairing.largest(beside_the_node),
                1e-11);
    check_small("gap",
                pairing.largest([&](const ContactPoint &point) {
                  return pairing.offset(point).norm();
                }),
                1e-13);

    check_small("loads on the master under uniform pressure",
                error_of_loads(pairing),
                1e-10);
  }



  void coinciding(const unsigned int degree)
  {
    headline("other nodes on the same line, degree " + std::to_string(degree));
    coinciding(degree, uneven_slave, {0, 0.2, 0.9, 1.6, 1.7, 2.5});
    headline("one slave edge on 20 of the master");
    coinciding(degree, {0, 1}, even(0, 1, 20));
    headline("20 slave edges on one of the master");
    coinciding(degree, even(0, 1, 20), {0, 1});
  }



  // The worst of many pairings on one line. A point whose weight were negative
  // would count as not facing, and be missed in the length.
  struct Extremes
  {
    double length = 0, coefficients = 0, offset = 0;
    double smallest_weight = 1e9, largest_coefficient = 0;

    void add(const Pairing &pairing, const double shared)
    {
      length = std::max(length, std::abs(pairing.shared_length() - shared));
      coefficients =
        std::max(coefficients, pairing.largest(sum_of_coefficients));
      offset = std::max(offset, pairing.largest([&](const ContactPoint &point) {
        return pairing.offset(point).norm();
      }));
      for (const ContactPoint &point : pairing.points)
        if (point.facing)
          {
            // Relative to the shared length, of one edge at most.
            smallest_weight =
              std::min(smallest_weight, point.weight / std::min(shared, 1.));
            for (const double c : point.C)
              largest_coefficient = std::max(largest_coefficient, std::abs(c));
          }
    }

    void print() const
    {
      std::cout << "  weights down to " << two_digits(smallest_weight)
                << " of the shared length, coefficients up to "
                << two_digits(largest_coefficient) << std::endl;
      check("all weights are positive", smallest_weight > 0);
      check_small("sum of the coefficients", coefficients, 1e-11);
      check_small("gap", offset, 1e-11);
      check_small("weights and length", length, 1e-12);
    }
  };



  const Line places{0.001,
                    0.01,
                    0.1,
                    0.2,
                    0.3,
                    0.4,
                    0.499,
                    0.5,
                    0.501,
                    0.6,
                    0.7,
                    0.8,
                    0.9,
                    0.99,
                    0.999};



  void partial(const unsigned int degree)
  {
    const std::string name = ", degree " + std::to_string(degree);
    const Line        slave{0, 1, 2, 3};
    headline("the master ends within an edge" + name);
    Extremes ends;
    for (const double s : places)
      {
        ends.add(Pairing(make_strips(degree, slave, {-1, 0.8, 1 + s}), stay),
                 1 + s);
        ends.add(Pairing(make_strips(degree, slave, {1 + s, 2.1, 4}), stay),
                 2 - s);
      }
    ends.print();

    headline("the master begins with the slave and ends within its first edge" +
             name);
    Extremes first;
    for (const double s : places)
      {
        first.add(Pairing(make_strips(degree, slave, {-1, s}), stay), s);
        first.add(Pairing(make_strips(degree, {0, 1}, {-1, s}), stay), s);
        first.add(Pairing(make_strips(degree, {0, 1}, {s, 2}), stay), 1 - s);
      }
    first.print();

    headline("the master lies within one edge" + name);
    Extremes within;
    for (const double s : places)
      within.add(
        Pairing(make_strips(degree, slave, {1 + 0.9 * s, 1.09 + 0.9 * s}),
                stay),
        0.09);
    within.print();
  }


  // Bodies apart, where the overlap is seen along curving normals.
  void partial_bent(const unsigned int degree)
  {
    headline("bent, one faces a part of the other, degree " +
             std::to_string(degree));
    bool   beyond = true, in_part = true;
    double coefficients = 0, offset = 0;
    for (const double s : places)
      for (const Line &master : {Line{-1, 0.8, 1 + s}, Line{1 + s, 2.1, 4}})
        {
          const Pairing pairing(make_strips(degree, {0, 1, 2, 3}, master, 0.1),
                                bend);
          const double  shared = pairing.shared_length();
          in_part              = in_part && shared > 0.5 && shared < 2.5;
          for (const ContactPoint &point : pairing.points)
            if (!point.facing)
              beyond = beyond && (master[0] < 0 ? point.X[0][0] > 1 + s - 0.1
                                                : point.X[0][0] < 1 + s + 0.1);
          coefficients =
            std::max(coefficients, pairing.largest(sum_of_coefficients));
          offset =
            std::max(offset, pairing.largest([&](const ContactPoint &point) {
              return std::abs(point.tangent * pairing.offset(point));
            }));
        }
    check("the surfaces overlap in part", in_part);
    check("nodes without weight are beyond the end", beyond);
    check_small("sum of the coefficients", coefficients, 1e-11);
    check_small("tangential offset", offset, 1e-11);
  }



  // One node after the other carries no multiplier.
  void without_a_node(const unsigned int degree)
  {
    headline("a slave node without multiplier, degree " +
             std::to_string(degree));
    Extremes extremes;
    double   error = 0;
    for (const Line &slave : {Line{0, 3}, Line{0, 1, 1.7, 3}})
      {
        const auto strips = make_strips(degree, slave, {0, 0.5, 1.4, 2, 3});
        for (unsigned int i = 0; i < degree * (slave.size() - 1) + 1; ++i)
          {
            const Pairing pairing(strips, stay, {i});
            extremes.add(pairing, 3);
            error = std::max(error, error_of_loads(pairing));
          }
      }
    extremes.print();
    check_small("loads on the master under uniform pressure", error, 1e-10);
  }



  // Coefficients belong to the bodies, normals turn with them.
  void turned(const unsigned int degree)
  {
    headline("turned, degree " + std::to_string(degree));
    const auto strips = make_strips(degree, uneven_slave, uneven_master, 0.1);
    const Tensor<2, 2> R = rotation(2.5);
    const Pairing      before(strips, bend);
    const Pairing      after(strips, [&](const Point<2> &X) {
      return Point<2>(-7, 3) + R * bend(X);
    });

    bool   same_nodes = true;
    double difference = 0;
    for (unsigned int i = 0; i < before.points.size(); ++i)
      {
        const ContactPoint &a = before.points[i], &b = after.points[i];
        same_nodes = same_nodes && a.dofs == b.dofs;
        difference = std::max({difference,
                               std::abs(a.weight - b.weight),
                               (R * a.normal - b.normal).norm(),
                               (R * a.tangent - b.tangent).norm()});
        for (unsigned int c = 0; same_nodes && c < a.n_nodes; ++c)
          difference = std::max(difference, std::abs(a.C[c] - b.C[c]));
      }
    check("the same nodes", same_nodes);
    check_small("coefficients, weights and normals", difference, 1e-12);
  }



  // With the pairing kept, gap and slip are linear: a difference is exact.
  void tangent(const unsigned int degree)
  {
    headline("the rows, degree " + std::to_string(degree));
    Parameters::All parameters =
      make_strips(degree, uneven_slave, uneven_master, 0.1);
    parameters.contact.friction_coefficient = 0.3;
    ContactModel         model(parameters);
    const Vector<double> bent = model.displacement(bend);
    Random               random;
    for (unsigned int i = 0; i < model.n_dofs(); ++i)
      {
        model.solution[i] = bent[i];
        model.start[i]    = bent[i] + random(-0.01, 0.01);
      }
    for (unsigned int i = model.n_dofs(); i < model.solution.size(); ++i)
      model.solution[i] = random(-1, 1);
    model.interface.pair(model.solution);

    Vector<double> other = model.solution;
    for (double &value : other)
      value += random(-0.1, 0.1);

    double                 error = 0, largest = 0;
    ContactInterface::Rows rows;
    for (const ContactPoint &point : model.interface.points)
      {
        const auto &interface = model.interface;
        interface.rows(point, model.solution, model.start, {false, true}, rows);
        const auto from = interface.state(point, model.solution, model.start);
        const auto to   = interface.state(point, other, model.start);
        double     p = from.p_trial - to.p_trial, q = from.q_trial - to.q_trial;
        largest = std::max({largest, std::abs(p), std::abs(q)});
        for (unsigned int j = 0; j < rows.unknowns.size(); ++j)
          {
            const auto   i    = rows.unknowns[j];
            const double step = other[i] - model.solution[i];
            p += rows.p_trial[j] * step;
            q += rows.q_trial[j] * step;
          }
        error = std::max({error, std::abs(p), std::abs(q)});
      }
    check_small("rows and differences", error / largest, 1e-12);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      inside(degree, false);
      inside(degree, true);
      matching(degree);
      coinciding(degree);
      partial(degree);
      partial_bent(degree);
      without_a_node(degree);
      turned(degree);
      tangent(degree);
    }
}
