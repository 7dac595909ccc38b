/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves what the mortar discretization claims of its points: of the slave side
// only the node itself is in a point; a rigid shift is no gap, and the weights
// sum up to the length that both surfaces share; where the surfaces coincide,
// node pairs are found if the nodes match, and a uniform pressure gives every
// node of the master its integral in any case; the tangential offset is zero
// also across a gap; turning everything changes no coefficient; the rows are
// the derivatives of gap and slip.

#include "mortar_pairing.h"

using namespace Tests;

namespace
{
  /// From a to b in n equal parts.
  Line even(const double a, const double b, const unsigned int n)
  {
    Line line;
    for (unsigned int i = 0; i <= n; ++i)
      line.push_back(a + (b - a) * i / n);
    return line;
  }



  /// By how much the slave side is more than the node itself.
  double beside_the_node(const ContactPoint<2> &point)
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
                pairing.largest([&](const ContactPoint<2> &point) {
                  return std::abs(point.tangents[0] * pairing.offset(point));
                }),
                1e-11);
    check_small("weights and length",
                std::abs(pairing.shared_length() - length),
                1e-12);
  }



  const Line uneven_slave{0, 0.7, 1, 2.2, 2.5};
  const Line uneven_master{-0.8, 0.3, 0.9, 1.6, 1.7, 3.5};



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
          pairing.largest([&](const ContactPoint<2> &point) {
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
    check("pairs of two nodes",
          pairing.largest(
            [](const ContactPoint<2> &point) { return point.n_nodes; }) == 2);
    check_small("distance of the partners",
                pairing.largest([](const ContactPoint<2> &point) {
                  return point.X(0).distance(point.X(1));
                }),
                1e-13);
    check_small("coefficients but one and minus one",
                pairing.largest([](const ContactPoint<2> &point) {
                  return std::abs(point.C[0] - 1) + std::abs(point.C[1] + 1);
                }),
                1e-12);
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
                pairing.largest([&](const ContactPoint<2> &point) {
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
        const ContactPoint<2> &a = before.points[i], &b = after.points[i];
        same_nodes = same_nodes && a.n_nodes == b.n_nodes;
        for (unsigned int c = 0; same_nodes && c < a.n_nodes; ++c)
          same_nodes = a.dofs(c) == b.dofs(c);
        difference = std::max({difference,
                               std::abs(a.weight - b.weight),
                               (R * a.normal - b.normal).norm(),
                               (R * a.tangents[0] - b.tangents[0]).norm()});
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
    TwoBodies           model(parameters);
    const GhostedVector bent = model.displacement(bend);
    Random              random;
    for (unsigned int i = 0; i < model.n_dofs(); ++i)
      {
        model.solution[i] = bent[i];
        model.start[i]    = bent[i] + random(-0.01, 0.01);
      }
    for (unsigned int i = model.n_dofs(); i < model.solution.size(); ++i)
      model.solution[i] = random(-1, 1);
    model.interface.pair(model.solution);

    GhostedVector other = model.solution;
    for (double &value : other)
      value += random(-0.1, 0.1);

    double                 error = 0, largest = 0;
    ContactKernel<2>::Rows rows;
    for (const ContactPoint<2> &point : model.interface.points())
      {
        const auto &interface = model.interface;
        ContactKernel<2>(interface).rows(point,
                                         model.solution,
                                         model.start,
                                         {false},
                                         rows);
        const auto from = interface.state(point, model.solution, model.start);
        const auto to   = interface.state(point, other, model.start);
        double     p    = from.p_trial - to.p_trial,
               q        = from.q_trial[0] - to.q_trial[0];
        largest         = std::max({largest, std::abs(p), std::abs(q)});
        for (unsigned int j = 0; j < rows.unknowns.size(); ++j)
          {
            const auto   i    = rows.unknowns[j];
            const double step = other[i] - model.solution[i];
            p += rows.p_trial[j] * step;
            q += rows.q_trial[0][j] * step;
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
      turned(degree);
      tangent(degree);
    }
  return 0;
}
