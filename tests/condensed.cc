/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the system without multipliers has the solution of the one with
// them, displacements, pressures and shears: for both rules, both degrees and
// both kinematics, without friction and with both laws of it while points are
// open, stick and slip, where a slave faces the master in part, and on a
// symmetry line.

#include "condensed.h"

#include "base/errors.h"
#include "condensed_model.h"

using namespace Tests;

namespace
{
  std::string counts(const ContactInterface<2> &interface)
  {
    const StatusCount count = interface.active_set.count();
    return std::to_string(interface.points().size() - count.active) +
           " open, " + std::to_string(count.stick) + " stick, " +
           std::to_string(count.active - count.stick) + " slip";
  }



  /// Two increments, the second with a history, by both systems.
  void compare(const std::string &name, const CondensedCase &c)
  {
    const Parameters::All parameters = make_case(c);
    TwoBodies             saddle(parameters);
    CondensedModel        condensed(parameters);
    bool                  converged = true;
    for (const double load_factor : {0.6, 1.})
      {
        converged = converged && saddle.solve(load_factor, false) > 0;
        converged = converged && condensed.solve(load_factor);
      }
    std::cout << "  " << name << ": " << counts(saddle.interface) << std::endl;
    check("both converge to the same decisions",
          converged && saddle.interface.active_set.signature() ==
                         condensed.interface->active_set.signature());

    const auto  &one = saddle.solution, &other = condensed.solution;
    const auto   n   = saddle.n_dofs();
    const auto   n_k = saddle.interface.n_normal_multipliers();
    const double u   = difference(one, other, 0, n);
    const double p   = difference(one, other, n, n + n_k);
    const double q =
      one.size() > n + n_k ? difference(one, other, n + n_k, one.size()) : 0.;
    check_small("displacements", u, 1e-9);
    check_small("multipliers", std::max(p, q), 1e-9);
  }



  void same_solutions(const std::string &rule)
  {
    headline("the same solution, " + rule + " rule");
    for (const unsigned int degree : {1, 2})
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        {
          const std::string name =
            "degree " + std::to_string(degree) + ", " + kinematics;
          compare(name + ", Coulomb", {rule, degree, kinematics, 0.08});
          if (kinematics == "large displacement")
            continue;
          compare(name + ", no friction", {rule, degree, kinematics});
          compare(name + ", Tresca", {rule, degree, kinematics, 0, 1.});
        }
  }



  // The master ends under the slave, at both sides, and stays pressed there.
  void facing_in_part(const std::string &rule)
  {
    headline("the slave faces the master in part, " + rule + " rule");
    for (const unsigned int degree : {1, 2})
      for (const double friction : {0., 0.08})
        {
          CondensedCase c{rule, degree};
          c.coulomb = friction;
          c.lower   = rectangle({0.37, -1}, {1.71, 0});
          c.rise    = 0.005;
          compare("degree " + std::to_string(degree) +
                    (friction > 0 ? ", Coulomb" : ", no friction"),
                  c);
        }
  }



  // Half of the bodies: the first node of the slave is on the line x = 0.
  void symmetry_line(const std::string &rule)
  {
    headline("symmetry line, " + rule + " rule");
    for (const unsigned int degree : {1, 2})
      for (const double friction : {0., 0.08})
        {
          CondensedCase c{rule, degree};
          c.coulomb  = friction;
          c.lower    = rectangle({0, -1}, {1.2, 0});
          c.symmetry = true;
          compare("degree " + std::to_string(degree) +
                    (friction > 0 ? ", Coulomb" : ", no friction"),
                  c);
        }
  }



  // The same line, but the master goes on beyond it, and is not held there. A
  // mortar point of a node that is held does without friction; with the nodal
  // rule it would have to hold the master, which takes multipliers.
  void beyond_the_line(const std::string &rule)
  {
    headline("master beyond the symmetry line, " + rule + " rule");
    for (const unsigned int degree : {1, 2})
      for (const double friction : {0., 0.08})
        {
          const std::string name =
            "degree " + std::to_string(degree) +
            (friction > 0 ? ", Coulomb" : ", no friction");
          CondensedCase c{rule, degree};
          c.coulomb       = friction;
          c.lower         = rectangle({-0.25, -1}, {1.2, 0});
          c.symmetry      = true;
          c.lower_is_free = true;
          try
            {
              compare(name, c);
            }
          catch (const InputError &error)
            {
              const std::string text = error.what();
              std::cout << "  " << name
                        << ", refused: " << text.substr(0, text.find('\n'))
                        << std::endl;
            }
        }
  }
} // namespace



int main()
{
  for (const std::string rule : {"nodal", "mortar"})
    {
      same_solutions(rule);
      facing_in_part(rule);
      symmetry_line(rule);
      beyond_the_line(rule);
    }
  return 0;
}
