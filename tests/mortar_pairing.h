/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Two strips and their mortar points, in a configuration.

#ifndef contact_tests_mortar_pairing_h
#define contact_tests_mortar_pairing_h

#include <numeric>

#include "contact/mortar/mortar.h"
#include "tests.h"

namespace Tests
{
  using Line = std::vector<double>; // the vertices along a surface
  using Move = std::function<Point<2>(const Point<2> &)>;

  /// Two strips, the slave above the line y = 0 and the master below it.
  inline Parameters::All make_strips(const unsigned int degree,
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
      const MortarDiscretization<2> rule(slave,
                                         master,
                                         discretization,
                                         excluded);
      points = rule.make_points(multipliers);
      const BodyOverlap<2>::Surfaces surfaces{{{&slave}, {&master}}};
      rule.pair(points, u, {}, {surfaces, u});
    }

    Point<2> position(const ContactPoint<2> &point, const unsigned int a) const
    {
      return point.X(a) + Point<2>(u[point.dofs(a)[0]], u[point.dofs(a)[1]]);
    }

    /// sum C x: the weighted gap vector.
    Tensor<1, 2> offset(const ContactPoint<2> &point) const
    {
      Tensor<1, 2> sum;
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        sum += point.C[a] * position(point, a);
      return sum;
    }

    /// The largest value of a function over the points that face the master.
    double
    largest(const std::function<double(const ContactPoint<2> &)> &value) const
    {
      double result = 0;
      for (const ContactPoint<2> &point : points)
        if (point.facing)
          result = std::max(result, value(point));
      return result;
    }

    /// The weights of these points together.
    double shared_length() const
    {
      double sum = 0;
      for (const ContactPoint<2> &point : points)
        sum += point.facing ? point.weight : 0;
      return sum;
    }

    bool all_facing() const
    {
      return std::all_of(points.begin(),
                         points.end(),
                         [](const ContactPoint<2> &p) { return p.facing; });
    }

    const Surface<2>             slave, master;
    const GhostedVector          u;
    MultiplierSpace              multipliers;
    std::vector<ContactPoint<2>> points;
  };



  inline double sum_of_coefficients(const ContactPoint<2> &point)
  {
    return std::abs(std::accumulate(point.C.begin(), point.C.end(), 0.));
  }



  /// The points above y = 0.05 on a circle from above, the rest on another one.
  inline Point<2> bend(const Point<2> &X)
  {
    const bool     is_slave = X[1] > 0.05;
    const double   radius   = is_slave ? 2 : 6;
    const Point<2> center(1.3, is_slave ? 2.1 : 6);
    const double   angle = (X[0] - center[0]) / radius;
    const double   r     = radius - (X[1] - (is_slave ? 0.1 : 0));
    return center + r * Point<2>(std::sin(angle), -std::cos(angle));
  }



  /// The loads on the nodes of the master under a pressure of one.
  inline std::map<types::global_dof_index, double>
  loads_on_master(const Pairing &pairing)
  {
    std::map<types::global_dof_index, double> loads;
    for (const ContactPoint<2> &point : pairing.points)
      for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
        loads[point.dofs(a)[0]] -= point.weight * point.C[a];
    return loads;
  }



  /// By how much these differ from the integrals of the shape functions, the
  /// weights of the nodal discretization, relative to them.
  inline double error_of_loads(const Pairing &pairing)
  {
    auto            loads = loads_on_master(pairing);
    double          error = 0;
    MultiplierSpace unused;
    for (const ContactPoint<2> &point :
         make_nodal_points(pairing.master, {}, unused))
      error =
        std::max(error, std::abs(loads[point.dofs(0)[0]] / point.weight - 1));
    return error;
  }
} // namespace Tests

#endif
