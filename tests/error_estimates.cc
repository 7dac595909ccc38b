/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The estimated discretization errors of the probes, from coarser levels and
// from a finer mesh, and how the table shows them.

#include "output/result_tables.h"
#include "tests.h"

using namespace Tests;

namespace
{
  // A run on levels with so many unknowns, where the probes A and B have the
  // values n and -10 n on the n-th level.
  RunSummary make_summary(const std::vector<std::size_t> &n_unknowns)
  {
    RunSummary summary;
    summary.case_name = "case";
    summary.mesh_file = "mesh.msh";
    summary.converged = true;
    double value      = 0;
    for (const std::size_t n : n_unknowns)
      {
        value += 1;
        LevelRecord level;
        level.n_displacements = n;
        level.probes          = {{"A", value}, {"B", -10 * value}};
        summary.levels.push_back(level);
      }
    summary.probes = {{"A", "mm", true, value},
                      {"B", "MPa", false, -10 * value}};
    return summary;
  }



  void print_errors(const std::string &name, const RunSummary &summary)
  {
    std::cout << "  " << name << ':';
    for (const ProbeResult &probe : summary.probes)
      if (probe.error)
        std::cout << ' ' << probe.name << ' ' << *probe.error;
      else
        std::cout << ' ' << probe.name << " none";
    std::cout << std::endl;
  }



  // Proves that the value is compared with that of the finest level that has
  // at most half of the unknowns, and with nothing if there is none; that steps
  // of three levels which do not become smaller lead nine steps further.
  void check_levels()
  {
    headline("levels");
    const auto estimate = [](const std::vector<std::size_t> &n_unknowns) {
      RunSummary summary = make_summary(n_unknowns);
      estimate_errors(summary);
      std::string name;
      for (const std::size_t n : n_unknowns)
        name += (name.empty() ? "" : ", ") + std::to_string(n);
      print_errors(name, summary);
    };
    estimate({100});
    estimate({100, 199});
    estimate({100, 200});
    estimate({10, 100, 400});
    estimate({10, 100, 130, 170});
    estimate({10, 40, 60, 80, 100});
    estimate({10, 20, 50, 90, 100});
  }



  // Proves that the difference from a finer mesh is doubled, without a sign,
  // and that the values and their verdicts stay.
  void check_finer_mesh()
  {
    headline("finer mesh");
    RunSummary       summary = make_summary({100});
    const RunSummary finer   = make_summary({400});
    auto             probes  = finer.probes;
    probes[0].value          = 1.125;
    probes[1].value          = -9;
    estimate_errors(summary, probes);
    print_errors("1 and -10 against 1.125 and -9", summary);
    check("values stay",
          summary.probes[0].value == 1 && summary.probes[1].value == -10);
    check("no verdict on an estimate", summary.passed());
  }



  // Proves that the table has a column of estimates if there is one, in any
  // case, and none otherwise.
  void check_table()
  {
    headline("table");
    RunSummary without = make_summary({100}), with = make_summary({100, 200});
    estimate_errors(without);
    estimate_errors(with);
    with.case_name    = "two levels";
    RunSummary failed = without;
    failed.case_name  = "failed";
    failed.converged  = false;
    failed.message    = "no convergence";
    print_table(std::cout, {without, failed});
    print_table(std::cout, {without, with, failed});

    // One probe alone.
    with.probes[0].error.reset();
    print_table(std::cout, {with});
  }
} // namespace



int main()
{
  check_levels();
  check_finer_mesh();
  check_table();
  return 0;
}
