/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Forces, largest tractions and the ends of the contact pairs of contact and
// stick, from contact points that are told what to do.

#include "contact/results/contact_results.h"

#include "tests.h"

using namespace Tests;

namespace
{
  using Profile = std::function<double(const double x)>;

  const Profile zero = [](double) { return 0.; };

  constexpr double length = 3;

  // Two blocks from x = 0 to 3, the upper one with ten edges in contact. What
  // their points feel is set directly: the multipliers are 1, and the pressure
  // is in how a point weights them; the bodies have moved by 1 along x in this
  // increment, and the slip is in the length of the tangent.
  struct Model : public TwoBodies
  {
    Model(const unsigned int degree, const std::string &rule)
      : TwoBodies(parameters(degree, rule))
    {
      interface.pair(solution);
      for (unsigned int k = 0; k < interface.n_multipliers(); ++k)
        solution[interface.normal_index(k)] = 1;
      for (const auto &node : interface.pairs[0]->slave.nodes)
        start[node.dofs[0]] = -1;
    }

    static Parameters::All parameters(const unsigned int degree,
                                      const std::string &rule)
    {
      MeshText mesh;
      mesh.block("lower", 7, 1, rectangle({0, -1}, {length, 0}));
      mesh.block("upper", 10, 1, rectangle({0, 0}, {length, 1}));
      auto parameters =
        make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
      parameters.contact.slave                = "upper bottom";
      parameters.contact.master               = "lower top";
      parameters.contact.discretization       = rule;
      parameters.contact.friction_coefficient = 0.5;
      return parameters;
    }

    // The place of a point.
    double x(const ContactPoint<2> &point) const
    {
      const auto     &slave = interface.pairs[0]->slave;
      const EdgeShape shape(slave.degree, point.slave_xi);
      double          x = 0;
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        x += shape.value[a] *
             slave.nodes[slave.facets[point.slave_facet].nodes[a]].X[0];
      return x;
    }

    // Contact where @p pressure is positive, stick there where @p slip is zero,
    // otherwise slip in its direction under the bound @p bound.
    void set(const Profile &pressure, const Profile &slip, const double bound)
    {
      change_points(interface, [&](ContactPoint<2> &point) {
        if (point.is_master_corner)
          return;
        const double p = pressure(x(point)), s = slip(x(point));
        point.status = {p <= 0   ? Status::open
                        : s == 0 ? Status::stick
                                 : Status::slip,
                        p <= 0 || s == 0 ? 0 : (s > 0 ? 1 : -1)};
        point.psi.fill(0);
        point.psi[0]         = std::max(0., p);
        point.friction_bound = bound;
        point.tangents[0] *= s / point.tangents[0].norm();
      });
    }

    // Under the bounds that set() has made.
    ContactResults results()
    {
      const BoundsWhile<2> frozen(interface.bounds, /*follow=*/false);
      return contact_results(interface, *interface.pairs[0], solution, start);
    }
  };



  double cut_root(const double f, const double power)
  {
    return f > 0 ? std::pow(f, power) : 0.;
  }



  // Proves the forces, which are integrals over the slave (all rules integrate
  // linear functions), and the largest values.
  void check_forces(const std::string &name, Model &model)
  {
    model.set([](const double x) { return 2 + x; },
              [](const double x) { return x - 10; },
              0.25);
    auto found = model.results();
    check_small(name + ", normal force",
                std::abs(found.normal_force - 10.5),
                1e-12);
    check_small(name + ", tangential force",
                std::abs(found.tangential_force + 0.25 * length),
                1e-12);
    double largest = 0;
    for (const auto &point : model.interface.points())
      largest = std::max(largest, 2 + model.x(point));
    check_small(name + ", largest values",
                std::abs(found.max_pressure - largest) +
                  std::abs(found.max_shear - 0.25),
                1e-12);

    // Sticking, with the multipliers of the shear in place of the bound.
    model.set([](double) { return 2.; }, zero, 0.25);
    for (unsigned int k = 0; k < model.interface.n_normal_multipliers(); ++k)
      model.solution[model.interface.tangential_index(k)] = 0.125;
    found = model.results();
    check_small(name + ", stick",
                std::abs(found.normal_force - 2 * length) +
                  std::abs(found.tangential_force - 0.25 * length) +
                  std::abs(found.max_pressure - 2) +
                  std::abs(found.max_shear - 0.25),
                1e-12);
  }



  // Proves that there is nothing where nothing touches, and that contact all
  // along the slave is as wide as that, and so is sticking.
  void check_none_and_all(const std::string &name, Model &model)
  {
    model.set(zero, zero, 1);
    const auto none = model.results();
    check(name + ", none",
          none.normal_force == 0 && none.tangential_force == 0 &&
            none.max_pressure == 0 && none.max_shear == 0 && none.extent == 0 &&
            none.stick_extent == 0);
    model.set([](double) { return 1.; }, zero, 1);
    const auto all = model.results();
    check_small(name + ", all",
                std::abs(all.extent - length) +
                  std::abs(all.stick_extent - length),
                1e-12);
    model.set([](double) { return 1.; }, [](double) { return 1.; }, 1);
    check(name + ", all slips", model.results().stick_extent == 0);
  }



  // Proves that contact ends where p^2 vanishes: exactly, if p^2 is linear,
  // wherever between two points that is.
  void check_ends_of_contact(const std::string &name, Model &model)
  {
    double error = 0;
    for (const double middle : {1.4, 1.43, 1.5, 1.57})
      for (const double half : {0.83, 0.9, 1.02, 1.19})
        {
          model.set(
            [=](const double x) {
              return 5 * cut_root(1 - std::abs(x - middle) / half, 0.5);
            },
            [](double) { return 1.; },
            1);
          error = std::max(error, std::abs(model.results().extent - 2 * half));
        }
    check_small(name + ", ends of contact", error, 1e-12);
  }



  // Proves that sticking ends where |slip|^(2/3) vanishes, whatever its sign.
  void check_ends_of_stick(const std::string &name, Model &model)
  {
    double error = 0;
    for (const double middle : {1.4, 1.43, 1.5, 1.57})
      for (const double half : {0.21, 0.4, 0.52, 0.69})
        for (const double sign : {-1, 1})
          {
            model.set([](double) { return 1.; },
                      [=](const double x) {
                        return 1e-3 * std::copysign(1., sign * (x - middle)) *
                               cut_root(std::abs(x - middle) - half, 1.5);
                      },
                      1);
            error = std::max(error,
                             std::abs(model.results().stick_extent - 2 * half));
          }
    check_small(name + ", ends of stick", error, 1e-12);
  }



  // Proves that a zone of stick that reaches the end of contact ends there.
  void check_all_sticks(const std::string &name, Model &model)
  {
    model.set(
      [=](const double x) {
        return 5 * cut_root(1 - std::abs(x - 1.43) / 1.02, 0.5);
      },
      zero,
      1);
    check_small(name + ", stick up to the end of contact",
                std::abs(model.results().stick_extent - 2.04),
                1e-12);
  }



  // Proves, for points in the nodes, what is done where nothing can be
  // extrapolated: contact pairs end half way if there is one point only or the
  // pressure grows towards the end; a point in contact that is held and does
  // not slip ends sticking; and a gap inside of a contact pair does not count.
  void check_special_cases(Model &model)
  {
    const double  h    = 0.3;
    const Profile one  = [](double) { return 1.; };
    const auto    near = [](const double x, const double place) {
      return std::abs(x - place) < 0.1;
    };

    model.set([&](const double x) { return near(x, 4 * h) ? 1. : 0.; }, one, 1);
    check_small("one point", std::abs(model.results().extent - h), 1e-12);
    model.set(
      [&](const double x) {
        return x > 3.5 * h && x < 6.5 * h ? 1 + std::abs(x - 5 * h) : 0.;
      },
      one,
      1);
    check_small("growing pressure",
                std::abs(model.results().extent - 3 * h),
                1e-12);
    model.set(
      [&](const double x) { return near(x, 0) || near(x, length) ? 1. : 0.; },
      one,
      1);
    check_small("a gap inside", std::abs(model.results().extent - h), 1e-12);

    // The first point is held, up to round-off, then two stick.
    for (const double slip : {0., 1e-20, -1e-20})
      {
        model.set(
          one,
          [=](const double x) {
            return near(x, 0) ? slip : (x < 2.5 * h ? 0. : 1.);
          },
          1);
        auto points                   = model.interface.points();
        points[0].status              = {Status::slip, 0};
        points[0].has_no_free_tangent = true;
        model.interface.set_points(points);
        check_small("held point",
                    std::abs(model.results().stick_extent - 2.5 * h),
                    1e-12);
      }
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss", "mortar"})
      {
        const std::string name = rule + ", degree " + std::to_string(degree);
        headline(name);
        for (const auto &test : {check_forces,
                                 check_none_and_all,
                                 check_ends_of_contact,
                                 check_ends_of_stick,
                                 check_all_sticks})
          {
            Model model(degree, rule);
            test(name, model);
          }
      }
  headline("special cases");
  Model model(1, "nodal");
  check_special_cases(model);
  return 0;
}
