/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_history_h
#define contact_history_h

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "output/summary.h"

namespace Contact
{
  /// The units of forces and of works, which of plane strain are by thickness,
  /// and of the probes, name and unit in the order of their columns.
  struct HistoryUnits
  {
    std::string                                      force, work;
    std::vector<std::pair<std::string, std::string>> probes;
  };

  /**
   * Write the increments of the last mesh that converged as a table,
   * history.csv: the load factor t, Newton steps, the probes, and for each
   * contact pair, group of supports and kind of work what `summary.json` has. A
   * line with names and units, then a row an increment; a field is empty where
   * an increment has no such value, as stresses where a step of a cut one ends.
   */
  void write_history(const RunSummary   &summary,
                     const HistoryUnits &units,
                     std::ostream       &out);
} // namespace Contact

#endif
