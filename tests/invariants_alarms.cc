/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that each kind of wrong state raises the alarm that belongs to it, for
// all rules; that a check leaves no trace until its increment is accepted, and
// goes on alike from an archive; and that forces which hold the bodies count as
// those of supports. That right states raise none: invariants.cc.

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include "checked_model.h"
#include "solid/cell_values.h"

using namespace Tests;

namespace
{
  // A change that makes a state wrong.
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
     [](Checked &m) { m.solution[m.find(Status::stick)->dofs(0)[1]] -= 1e-4; }},
    {"an open slave node moved into the master",
     [](Checked &m) {
       const ContactPoint<2> &point = *m.find(Status::open);
       const double gap = m.interface.state(point, m.solution, m.start).gap;
       m.solution[point.dofs(0)[1]] -= 2 * gap / point.C[0];
     }},
    {"a slave node that sticks moved along the master",
     [](Checked &m) { m.solution[m.find(Status::stick)->dofs(0)[0]] += 1e-4; }},
    {"a shear above the bound",
     [](Checked &m) {
       const ContactPoint<2> &point = *m.find(Status::stick);
       m.lambda_t(point)            = 2 * 0.2 * m.lambda_n(point);
     }},
    {"the sign of a shear",
     [](Checked &m) {
       m.lambda_t(*m.find(Status::slip)) *= -1;
       m.change(Status::slip, [](ContactPoint<2> &point) {
         point.status.slip_direction *= -1;
       });
     }},
    {"a point in contact left out",
     [](Checked &m) {
       const ContactPoint<2> &point = *m.find(Status::stick);
       m.lambda_n(point) = m.lambda_t(point) = 0;
       m.change(Status::stick, [](ContactPoint<2> &point) {
         point.status = {Status::open, 0};
       });
     }},
    {"a force on the slave alone",
     [](Checked &m) {
       m.change(Status::stick, [](ContactPoint<2> &point) {
         point.C[point.n_nodes - 1] *= 1.001;
       });
     }},
    {"the projection point shifted along the master",
     [](Checked &m) {
       m.change(Status::stick, [](ContactPoint<2> &point) {
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



  // Proves that wrong states raise the right alarms.
  void check_alarms(const std::string &rule)
  {
    const CheckedCase c{rule, 1, "large displacement", 0.2};
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
      auto             state = model.invariants.state();
      const CellValues values =
        values_on_cells(model.discretization,
                        state.vectors(model.discretization.distribution));
      boost::archive::binary_oarchive out(file);
      out << std::as_const(state) << values;
    }
    InvariantCheck<2> restarted(model.discretization,
                                *model.elasticity,
                                &model.interface,
                                model.parameters.solution);
    {
      auto                            state = restarted.state();
      CellValues                      values;
      boost::archive::binary_iarchive in(file);
      in >> state >> values;
      take_from_cells(model.discretization,
                      values,
                      state.vectors(model.discretization.distribution));
      restarted.restore(state);
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
    GhostedVector    holds =
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
      return found.findings.size() == 1 &&
             found.findings[0].text.find("stabilization") != std::string::npos;
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
              .findings.size() > 1);
  }
} // namespace



int main()
{
  for (const std::string rule : {"nodal", "Gauss", "mortar"})
    check_alarms(rule);
  check_repetition();
  check_holds();
  return 0;
}
