/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_result_tables_h
#define contact_result_tables_h

#include <iosfwd>
#include <vector>

#include "output/summary.h"

namespace Contact
{
  /**
   * Print the wall time [s] by phase and level, with unknowns, iterations and
   * memory, and how the total grows: its slope over the unknowns on logarithmic
   * scales, from each level to the next where that is clearly larger.
   */
  void print_levels(std::ostream &out, const RunSummary &summary);

  /**
   * Print the final table, one line per probe: case, mesh, computed value,
   * reference, deviation, tolerance, and whether it is within. A case that did
   * not converge says so, and its message follows the table.
   */
  void print_table(std::ostream &out, const std::vector<RunSummary> &summaries);
} // namespace Contact

#endif
