/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Measures that keep a run going: the steps of the load factor, cut and grown
// again; the guard of Newton's method; the relaxation of fixed points.

#include "solvers/newton/load_steps.h"

#include <cmath>

#include "solvers/newton/newton_globalization.h"
#include "solvers/newton/relaxation.h"
#include "tests.h"

using namespace Tests;

namespace
{
  // Proves that without failures the factors are those of equal increments, to
  // the last bit.
  void check_plan()
  {
    headline("plan");
    bool exact = true;
    for (const unsigned int n : {1, 3, 7, 10})
      {
        LoadSteps steps(Parameters::Increments(n), 6);
        for (unsigned int k = 1; k <= n; ++k)
          {
            const auto step = steps.next();
            exact           = exact && step.to == static_cast<double>(k) / n &&
                    step.increment == k && step.is_whole &&
                    step.starts_increment && step.ends_increment;
            steps.accept(3);
          }
        exact = exact && steps.finished();
      }
    check("equal increments, exactly", exact);
  }



  // Proves that a step is cut to half, that steps double again as soon as they
  // fit, but into the length that has failed behind four alone, that no
  // increment of the plan is left out, and that the cuts end.
  void check_cuts()
  {
    headline("cuts");
    LoadSteps steps(Parameters::Increments(2), 3);
    check("cut", steps.cut() && steps.next().to == 0.25);
    check("and again", steps.cut() && steps.next().to == 0.125);
    check("and once more", steps.cut() && steps.next().to == 0.0625);
    check("but no further", !steps.cut() && steps.next().to == 0.0625);
    std::cout << "  from then on:";
    while (!steps.finished())
      {
        steps.accept(3);
        if (!steps.finished())
          std::cout << ' ' << steps.next().to
                    << (steps.next().ends_increment ? "!" : "");
      }
    std::cout << std::endl;

    // A step that was hard is followed by one of the same length.
    LoadSteps hard(Parameters::Increments(1), 3);
    hard.cut();
    hard.cut();
    hard.accept(3);
    check("after an easy one the same, until it fits", hard.next().to == 0.5);
    hard.accept(20);
    check("after a hard one the same", hard.next().to == 0.75);
    hard.accept(3);
    check("to the end", hard.next().to == 1);

    // Steps that fail beyond half of every increment.
    LoadSteps    fragile(Parameters::Increments(3), 10);
    unsigned int n = 0, ends = 0;
    while (!fragile.finished() && ++n < 1000)
      {
        const auto step = fragile.next();
        if (step.to - step.from > 0.1 + 1e-12)
          check_small("depth", fragile.cut() ? 0 : 1, 1);
        else
          {
            ends += step.ends_increment;
            fragile.accept(3);
          }
      }
    check("every increment is reached", ends == 3 && n < 100);
  }



  // Proves when the method stands still, and when only one point may change.
  void check_guard()
  {
    headline("guard of Newton's method");
    NewtonGlobalization guard;
    unsigned int        still = 0;
    while (guard.circle() == 0)
      {
        guard.advance(0.5 - 1e-3 * still, 0);
        ++still;
      }
    check("stands still after five steps that change nothing", still == 6);
    guard.advance(0.4, 0);
    check("progress", guard.circle() == 0);
    for (unsigned int i = 0; i < 10; ++i)
      guard.advance(0.4, 1);
    check("nor while points change", guard.circle() == 0);

    unsigned int wasted = 0;
    while (!guard.one_at_a_time(4))
      ++wasted;
    std::cout << "  steps with the same number of changes: " << wasted
              << std::endl;
    check("until there is progress", guard.one_at_a_time(4));
    check("progress", !guard.one_at_a_time(3));
  }



  // Proves that Newton's method is lost where forces rise above what a step can
  // cancel, not where it begins with them. A residual that grows by 31 per
  // step, as it did while points changed one at a time, is stopped: 1e-5 N are
  // the round-off of 4.5e10 N = 1e-2 N 31^8.5.
  void check_runaway()
  {
    headline("runaway of Newton's method");
    const double        tolerance = 1e-5;
    NewtonGlobalization guard;
    check("large forces at the beginning", !guard.is_lost(1e15, tolerance));
    guard.advance(1e15, 1);
    check("smaller ones behind them", !guard.is_lost(1e14, tolerance));
    guard.advance(1e-3, 1);
    check("a rise that one step takes back", !guard.is_lost(4e10, tolerance));
    check("a rise that none does", guard.is_lost(5e10, tolerance));
    check("a wider tolerance", !guard.is_lost(5e10, 2 * tolerance));
    guard.forget();
    check("another problem", !guard.is_lost(5e10, tolerance));

    double       residual = 1e-2;
    unsigned int n        = 0;
    for (; n < 100 && !guard.is_lost(residual, tolerance); ++n)
      {
        guard.advance(residual, 1);
        residual *= 31;
      }
    check("growth by 31 for nine steps", n == 9);
  }



  // Proves that x -> s x + 1 is solved for slopes of -2.5 and -20 as well, and
  // in as many steps as without where it contracts from one side.
  void check_relaxation()
  {
    headline("fixed points");
    for (const double slope : {0.5, -0.5, -2.5, -20.})
      {
        Relaxation    relaxation;
        GhostedVector x(1);
        unsigned int  n = 0;
        double        defect;
        do
          {
            GhostedVector image(1);
            image[0]          = slope * x[0] + 1;
            defect            = std::abs(image[0] - x[0]);
            const double part = relaxation.length(image);
            x.sadd(1 - part, part, image);
          }
        while (defect > 1e-6 && ++n < 1000);
        std::cout << "  slope " << slope << ": " << n << " turns" << std::endl;
      }
  }
} // namespace



int main()
{
  check_plan();
  check_cuts();
  check_guard();
  check_runaway();
  check_relaxation();
  return 0;
}
