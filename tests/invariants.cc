/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that converged increments violate no invariant, loading and unloading,
// for all rules, both degrees, both kinematics, with and without friction; that
// energy and works agree to round-off in large displacement, too; that the
// dissipation is that of forces and slips taken by hand; and that the reactions
// of the supports are the forces of contact. What raises an alarm:
// invariants_alarms.cc.

#include "checked_model.h"

using namespace Tests;

namespace
{
  // Proves that eight increments of loading and unloading violate nothing, and
  // how well the balances hold.
  void check_converged(const CheckedCase &c)
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
        for (const Finding &finding : found.findings)
          if (finding.is_violated)
            alarms += "\n    " + std::to_string(k) + ": " + finding.text;
        const StatusCount count = model.interface.active_set.count();
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
    const GhostedVector forces = model.contact_forces();
    Tensor<1, 2>        on_slave;
    for (const SurfaceNode<2> &node : model.interface.pairs[0]->slave.nodes)
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
    parameters.boundary.displacement[0]     = {{"lower bottom", 0},
                                               {"upper top", 0.05}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
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

    const GhostedVector before = model.solution;
    check("converges when dragged", model.solve(1));
    const Invariants dragged = model.check();
    double           hand = 0, trapezoid = 0;
    bool             slips = true;
    for (const ContactPoint<2> &point : points_that_act(model.interface))
      {
        slips = slips && point.status.kind == Status::slip;
        // Along x, from which the surface turns away by a little.
        double slip = 0;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          slip += point.C[a] *
                  (model.solution[point.dofs(a)[0]] - before[point.dofs(a)[0]]);
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
  return 0;
}
