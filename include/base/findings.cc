/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/findings.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <regex>

namespace Contact
{
  using namespace dealii;

  std::string line_of(const Finding &finding)
  {
    return finding.where + (finding.is_violated ? ": violated: " : ": note: ") +
           finding.text;
  }



  void tell(const Finding &finding, Findings &told)
  {
    // In quotes are names, which may have numbers.
    const auto without_numbers = [](const std::string &text) {
      static const std::regex name_or_number(
        "('[^']*')|[-+]?[0-9.]+(e[-+][0-9]+)?");
      return std::regex_replace(text, name_or_number, "$1");
    };
    const auto is_same = [&](const Finding &other) {
      return !finding.is_violated && !other.is_violated &&
             without_numbers(other.text) == without_numbers(finding.text);
    };
    if (finding.text.empty() || std::any_of(told.begin(), told.end(), is_same))
      return;
    told.push_back(finding);
    if (!Utilities::MPI::job_supports_mpi() ||
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cerr << line_of(finding) << std::endl;
  }
} // namespace Contact
