/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_application_h
#define contact_application_h

#include <deal.II/base/parameter_handler.h>

#include <functional>

#include "output/summary.h"
#include "parameters/parameters.h"

namespace Contact
{
  using namespace dealii;

  /// Compute one case.
  using SolveCase = std::function<RunSummary(const Parameters::All  &parameters,
                                             const ParameterHandler &prm)>;

  /**
   * The program around the cases that are named on the command line: read all
   * of them, compute one after the other, print the table of their results.
   * Returns the exit status that print_help() explains; errors are printed.
   */
  int run_application(int argc, char **argv, const SolveCase &solve);
} // namespace Contact

#endif
