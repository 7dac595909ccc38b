/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that converged increments violate no invariant, loading and unloading,
// for all rules, both degrees, both kinematics, with and without friction; that
// energy and works agree to round-off in large displacement, too; that the
// dissipation is that of forces and slips taken by hand; that the reactions of
// the supports are the forces of contact; and that each kind of
// wrong state raises the alarm that belongs to it.

#include "verification/invariants.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include "tests.h"

using namespace Tests;

namespace
{
  struct Case
  {
    std::string  rule;
    unsigned int degree;
    std::string  kinematics;
    double       friction;
  };



  std::string named(const Case &c)
  {
    return c.rule + ", degree " + std::to_string(c.degree) + ", " +
           c.kinematics + (c.friction > 0 ? ", friction" : "");
  }



  // A block with a convex lower side on a flat block: pressed down and dragged
  // along, then lifted again and dragged back.
  Parameters::All make_case(const Case &c)
  {
    MeshText mesh;
    mesh.block("lower", 7, 2, rectangle({-1.5, -1}, {1.5, 0}));
    mesh.block("upper", 9, 2, [](const double s, const double t) {
      const double x = 2 * s - 1;
      return Point<2>(x, 0.04 * x * x * (1 - t) + t);
    });
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, c.degree, c.kinematics);
    parameters.contact.slave                    = "upper bottom";
    parameters.contact.master                   = "lower top";
    parameters.contact.discretization           = c.rule;
    parameters.contact.friction_coefficient     = c.friction;
    parameters.boundary.displacement_x          = {{"lower bottom", 0},
                                                   {"upper top", 0.01}};
    parameters.boundary.displacement_y          = {{"lower bottom", 0},
                                                   {"upper top", -0.04}};
    parameters.boundary.pressure["upper right"] = "2";
    parameters.boundary.histories["Displacement y"] =
      "if(t < 0.5, 2*t, 1.5 - t)";
    parameters.boundary.histories["Displacement x"] = "sin(5*t)";
    parameters.solution.geometry                    = "Newton";
    parameters.solution.friction                    = "Newton";
    return parameters;
  }



  // A state, solved for, and its check. The residual is below 1e-12 of the
  // largest force.
  struct Checked : public ContactModel
  {
    explicit Checked(const Parameters::All &parameters)
      : ContactModel(parameters)
      , parameters(parameters)
      , invariants(discretization, *elasticity, &interface, parameters.solution)
    {
    }

    // One increment, paired in each step; the tangent of the mortar
    // discretization keeps the pairing. Until round-off is left.
    bool solve(const double load)
    {
      load_factor = load;
      return ContactModel::solve(load,
                                 parameters.contact.discretization !=
                                   Parameters::ContactDiscretization::mortar,
                                 /*pairs_anew=*/true,
                                 force) > 0;
    }

    Invariants check()
    {
      return invariants.check(solution, load_factor, tolerance, force);
    }

    // The invariants that are violated.
    std::string alarms()
    {
      std::string names;
      for (const std::string &violation : check().violations)
        names += (names.empty() ? "" : ", ") +
                 violation.substr(0, violation.find(':'));
      return names.empty() ? "none" : names;
    }

    const ContactPoint *find(const Status status) const
    {
      for (const ContactPoint &point : interface.points())
        if (point.status.kind == status && point.facing &&
            (status != Status::slip || point.status.slip_direction != 0))
          return &point;
      return nullptr;
    }

    /// Change the first point of a status.
    void change(const Status                               status,
                const std::function<void(ContactPoint &)> &change_point)
    {
      auto points = interface.points();
      change_point(points[find(status) - interface.points().data()]);
      interface.set_points(points);
    }

    double &lambda_n(const ContactPoint &point)
    {
      return solution[interface.normal_index(point.multipliers[0])];
    }

    double &lambda_t(const ContactPoint &point)
    {
      return solution[interface.tangential_index(point.multipliers[0])];
    }

    static constexpr double tolerance = 1e-8;
    static constexpr double force     = 10; // [N/mm], about that of the contact

    const Parameters::All parameters;
    InvariantCheck        invariants;
    double                load_factor = 0;
  };



  // Proves that eight increments of loading and unloading violate nothing, and
  // how well the balances hold.
  void check_converged(const Case &c)
  {
    headline(named(c));
    Checked      model(make_case(c));
    bool         converged = true, dissipates = true;
    std::string  alarms;
    Invariants   worst, last;
    unsigned int stick = 0, slip = 0;
    for (unsigned int k = 1; k <= 8; ++k)
      {
        converged              = converged && model.solve(k / 8.);
        const Invariants found = model.check();
        for (const std::string &violation : found.violations)
          alarms += "\n    " + std::to_string(k) + ": " + violation;
        const StatusCount count = model.interface.count();
        stick += count.stick;
        slip += count.active - count.stick;
        for (double Invariants::*number :
             std::initializer_list<double Invariants::*>{
               &Invariants::force_imbalance,
               &Invariants::moment_imbalance,
               &Invariants::augmentation_parameter,
               &Invariants::cone,
               &Invariants::slip,
               &Invariants::penetration,
               &Invariants::energy_imbalance})
          worst.*number = std::max(worst.*number, found.*number);
        dissipates =
          dissipates &&
          found.dissipation >=
            last.dissipation -
              1e-12 * found.strain_energy; // what sticks slips by round-off
        last = found;
        model.invariants.advance();
      }
    check("converges", converged);
    if (c.friction > 0)
      check("points stick and slip", stick > 0 && slip > 0);
    std::cout << "  alarms: " << (alarms.empty() ? "none" : alarms)
              << std::endl;
    check_small("forces of contact", worst.force_imbalance, 1e-10);
    if (c.rule != "Gauss")
      check_small("their moment", worst.moment_imbalance, 1e-10);
    check_small("complementarity", worst.augmentation_parameter, 1e-8);
    check_small("friction cone", worst.cone, 1e-12);
    check_small("slip law", worst.slip, 1e-8);
    if (c.rule != "Gauss")
      check_small("penetration", worst.penetration, 1e-10);
    else
      check("surfaces penetrate between the nodes", worst.penetration > 1e-8);
    check_small("energy", worst.energy_imbalance, 1e-10);
    const double sum = last.external_work + last.contact_work +
                       last.friction_work + last.stabilization_work +
                       last.path_work;
    check_small("strain energy is the sum of the works",
                std::abs(sum / last.strain_energy - 1),
                1e-10);
    check("path work in large displacement only",
          (last.path_work != 0) == (c.kinematics == "large displacement"));
    check("friction dissipates", dissipates);
    check("and no friction does not",
          (last.dissipation > 0) == (c.friction > 0));
  }



  // Proves that the supports take up the forces of contact, with the sign of a
  // force on the bodies: the upper one presses down and drags to the right.
  void check_reactions(const Checked &model, const Invariants &found)
  {
    const Vector<double> forces = model.contact_forces();
    Tensor<1, 2>         on_slave;
    for (const Surface::Node &node : model.interface.pairs[0]->slave.nodes)
      for (unsigned int c = 0; c < 2; ++c)
        on_slave[c] += forces[node.dofs[c]];
    const auto &upper = found.reactions.at("upper top");
    const auto &lower = found.reactions.at("lower bottom");
    check("the upper support presses and drags",
          upper.at("x") > 0 && upper.at("y") < 0);
    for (unsigned int c = 0; c < 2; ++c)
      {
        const std::string x(1, "xy"[c]);
        check_small("its force is that of contact in " + x,
                    std::abs(upper.at(x) / on_slave[c] + 1),
                    1e-10);
        check_small("the lower one balances it in " + x,
                    std::abs(lower.at(x) / upper.at(x) + 1),
                    1e-10);
      }
  }



  // Proves the signs and sizes of the works by hand, with one element on each
  // side: pressed down first, then dragged to the right until both nodes slip.
  // The friction on the upper body points to the left.
  void check_by_hand()
  {
    headline("one element on each side");
    MeshText mesh;
    mesh.block("lower", 1, 1, rectangle({0, -1}, {1, 0}));
    mesh.block("upper", 1, 1, rectangle({0, 0}, {1, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, 1, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = 0.1;
    parameters.boundary.displacement_x      = {{"lower bottom", 0},
                                               {"upper top", 0.05}};
    parameters.boundary.displacement_y      = {{"lower bottom", 0},
                                               {"upper top", -0.02}};
    parameters.boundary.histories = {{"Displacement x", "max(0, 2*t - 1)"},
                                     {"Displacement y", "min(1, 2*t)"}};
    parameters.solution.geometry  = "Newton";
    parameters.solution.friction  = "Newton";

    Checked model(parameters);
    check("converges when pressed", model.solve(0.5));
    const Invariants pressed = model.check();
    model.invariants.advance();
    check("nothing slips or works but the support",
          std::abs(pressed.dissipation) < 1e-12 &&
            std::abs(pressed.contact_work) < 1e-12 &&
            std::abs(pressed.friction_work) < 1e-12);
    check_small("work of the support is the strain energy",
                std::abs(pressed.external_work / pressed.strain_energy - 1),
                1e-12);

    const Vector<double> before = model.solution;
    check("converges when dragged", model.solve(1));
    const Invariants dragged = model.check();
    double           hand = 0, trapezoid = 0;
    bool             slips = true;
    for (const ContactPoint &point : model.interface.points())
      {
        slips = slips && point.status.kind == Status::slip;
        // Along x, from which the surface turns away by a little.
        double slip = 0;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          slip += point.C[a] *
                  (model.solution[point.dofs[a][0]] - before[point.dofs[a][0]]);
        const double p = model.lambda_n(point);
        hand += 0.5 * 0.1 * p * slip;
      }
    check("both nodes slip", slips);
    check_small("dissipation is friction times slip",
                std::abs(dragged.dissipation / hand - 1),
                1e-4);
    check("and positive", hand > 0.01 * dragged.strain_energy);
    check("the friction takes energy", dragged.friction_work < 0);
    check("the support gives it",
          dragged.external_work - pressed.external_work > 0);
    trapezoid =
      dragged.external_work + dragged.contact_work + dragged.friction_work;
    check_small("balance",
                std::abs(trapezoid / dragged.strain_energy - 1),
                1e-12);
    check_reactions(model, dragged);
    std::cout << "  alarms: " << model.alarms() << std::endl;
  }



  // Proves that wrong states raise the right alarms.
  struct Corruption
  {
    std::string                    what;
    std::function<void(Checked &)> apply;
  };

  const std::vector<Corruption> corruptions{
    {"nothing", [](Checked &) {}},
    {"the sign of a pressure",
     [](Checked &m) { m.lambda_n(*m.find(Status::slip)) *= -1; }},
    {"a slave node in contact moved into the master",
     [](Checked &m) { m.solution[m.find(Status::stick)->dofs[0][1]] -= 1e-4; }},
    {"an open slave node moved into the master",
     [](Checked &m) {
       const ContactPoint &point = *m.find(Status::open);
       const double gap = m.interface.state(point, m.solution, m.start).gap;
       m.solution[point.dofs[0][1]] -= 2 * gap / point.C[0];
     }},
    {"a slave node that sticks moved along the master",
     [](Checked &m) { m.solution[m.find(Status::stick)->dofs[0][0]] += 1e-4; }},
    {"a shear above the bound",
     [](Checked &m) {
       const ContactPoint &point = *m.find(Status::stick);
       m.lambda_t(point)         = 2 * 0.2 * m.lambda_n(point);
     }},
    {"the sign of a shear",
     [](Checked &m) {
       m.lambda_t(*m.find(Status::slip)) *= -1;
       m.change(Status::slip,
                [](ContactPoint &point) { point.status.slip_direction *= -1; });
     }},
    {"a point in contact left out",
     [](Checked &m) {
       const ContactPoint &point = *m.find(Status::stick);
       m.lambda_n(point) = m.lambda_t(point) = 0;
       m.change(Status::stick, [](ContactPoint &point) {
         point.status = {Status::open, 0};
       });
     }},
    {"a force on the slave alone",
     [](Checked &m) {
       m.change(Status::stick, [](ContactPoint &point) {
         point.C[point.n_nodes - 1] *= 1.001;
       });
     }},
    {"the foot shifted along the master",
     [](Checked &m) {
       m.change(Status::stick, [](ContactPoint &point) {
         point.C[point.n_nodes - 1] += 0.01;
         point.C[point.n_nodes - 2] -= 0.01;
       });
     }},
    {"the load", [](Checked &m) { m.load_factor *= 0.999; }},
    {"the energy of the start", [](Checked &m) {
       auto state = m.invariants.state();
       state.strain_energy *= 1.0001;
       m.invariants.restore(state);
     }}};

  void check_alarms(const std::string &rule)
  {
    const Case c{rule, 1, "large displacement", 0.2};
    headline("wrong states, " + named(c));
    Checked model(make_case(c));
    // Until there are points of all kinds.
    const auto has_all = [&]() {
      return model.find(Status::open) != nullptr &&
             model.find(Status::stick) != nullptr &&
             model.find(Status::slip) != nullptr;
    };
    for (unsigned int k = 1; k <= 8 && !has_all(); ++k)
      {
        if (k > 1)
          {
            model.check();
            model.invariants.advance();
          }
        check("converges", model.solve(k / 8.));
      }
    check("there are points of all kinds", has_all());
    if (!has_all())
      return;

    const auto solution = model.solution;
    const auto points   = model.interface.points();
    const auto state    = model.invariants.state();
    const auto load     = model.load_factor;
    for (const Corruption &corruption : corruptions)
      {
        corruption.apply(model);
        std::cout << "  " << corruption.what << ": " << model.alarms()
                  << std::endl;
        model.solution = solution;
        model.interface.set_points(points);
        model.load_factor = load;
        model.invariants.restore(state);
      }
  }



  // Proves that an increment that is not accepted leaves no trace, and that a
  // run goes on alike from an archive.
  void check_repetition()
  {
    headline("repetition and restart");
    Checked model(make_case({"mortar", 2, "large displacement", 0.3}));
    check("converges", model.solve(0.25));
    model.check();
    model.invariants.advance();
    check("converges", model.solve(0.5));
    const Invariants once = model.check(), again = model.check();
    const auto       same = [](const Invariants &a, const Invariants &b) {
      return a.strain_energy == b.strain_energy &&
             a.external_work == b.external_work &&
             a.contact_work == b.contact_work &&
             a.dissipation == b.dissipation &&
             a.energy_imbalance == b.energy_imbalance;
    };
    check("checked twice", same(once, again));

    std::stringstream file;
    {
      boost::archive::binary_oarchive out(file);
      out << model.invariants;
    }
    InvariantCheck restarted(model.discretization,
                             *model.elasticity,
                             &model.interface,
                             model.parameters.solution);
    {
      boost::archive::binary_iarchive in(file);
      in >> restarted;
    }
    check("from an archive",
          same(once,
               restarted.check(model.solution,
                               model.load_factor,
                               model.tolerance,
                               model.force)));
  }



  // Proves that other forces on the nodes count as what holds the bodies: here
  // the reactions, given by hand.
  void check_holds()
  {
    headline("what else holds the bodies");
    Checked model(make_case({"nodal", 2, "large displacement", 0.3}));
    check("converges", model.solve(0.25));
    const Invariants found = model.check();
    Vector<double>   holds =
      model.elasticity->forces(model.solution, model.load_factor);
    for (unsigned int i = 0; i < holds.size(); ++i)
      if (!model.discretization.is_fixed(i))
        holds[i] = 0;
    const Invariants held = model.invariants.check(model.solution,
                                                   model.load_factor,
                                                   model.tolerance,
                                                   model.force,
                                                   &holds);
    // Springs that carry so much are an alarm of their own, and no other is.
    const auto only_stabilization = [](const Invariants &found) {
      return found.violations.size() == 1 &&
             found.violations[0].find("stabilization") != std::string::npos;
    };
    check("no alarm but what they carry", only_stabilization(held));
    check("they work", std::abs(held.stabilization_work) > 1e-3);
    check_small("as the supports did",
                std::abs((held.external_work + held.stabilization_work) /
                           found.external_work -
                         1),
                1e-12);
    holds *= 1.01;
    check("more of them do not change what the supports balance",
          only_stabilization(model.invariants.check(model.solution,
                                                    model.load_factor,
                                                    model.tolerance,
                                                    model.force,
                                                    &holds)));
    holds[model.interface.pairs[0]->slave.nodes[3].dofs[1]] += 1e-3;
    check("but where no support acts they raise an alarm",
          model.invariants
              .check(model.solution,
                     model.load_factor,
                     model.tolerance,
                     model.force,
                     &holds)
              .violations.size() > 1);
  }
} // namespace



int main()
{
  for (const std::string rule : {"nodal", "Gauss", "mortar"})
    for (const std::string kinematics : {"small strain", "large displacement"})
      for (const unsigned int degree : {1, 2})
        check_converged({rule, degree, kinematics, degree == 2 ? 0.3 : 0.});
  for (const std::string rule : {"nodal", "mortar"})
    check_converged({rule, 1, "large displacement", 0.3});
  check_by_hand();
  for (const std::string rule : {"nodal", "Gauss", "mortar"})
    check_alarms(rule);
  check_repetition();
  check_holds();
}
