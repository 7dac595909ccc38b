/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_increment_table_h
#define contact_increment_table_h

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/history.h"
#include "output/summary.h"

namespace Contact
{
  /**
   * The increments on the screen, one a line: t, Newton steps, the contact
   * force of each pair, the largest pressure of all, the probes and the time.
   * Lines end at 110 characters: probes go first, then forces, and what has no
   * place is in history.csv alone.
   */
  class IncrementTable
  {
  public:
    /// The columns, by the names of the contact pairs and the units.
    void set_columns(const std::vector<std::string> &pairs,
                     const HistoryUnits             &units);

    /// The head: names, and units below them.
    std::string head() const;

    /// The row of an increment that took @p seconds. What it has no value of,
    /// as of stresses on coarser meshes, has a dash.
    std::string row(const IncrementRecord &increment,
                    const double           seconds) const;

    /// That of an attempt which has no solution.
    std::string row_without_solution(const IncrementRecord &increment,
                                     const double           seconds) const;

  private:
    struct Column
    {
      std::string name, unit;
      std::size_t narrowest;

      std::function<std::optional<double>(const IncrementRecord &)> value;

      /// With a blank before it.
      std::size_t width() const;
    };

    std::string line(const std::function<std::string(const Column &)> &field,
                     const std::string &last) const;

    std::vector<Column> columns;
    bool                is_complete = true;
  };
} // namespace Contact

#endif
