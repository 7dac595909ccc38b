/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/counters.h"

namespace Contact
{
  std::map<std::string, unsigned long> Counters::by_name() const
  {
    return {{"tangents", tangents},
            {"cell_tangents", cell_tangents},
            {"cell_forces", cell_forces},
            {"large_displacement_cells", large_displacement_cells},
            {"material_cells", material_cells},
            {"enhanced_cells", enhanced_cells},
            {"return_mappings", return_mappings},
            {"history_updates", history_updates},
            {"thermal_cells", thermal_cells},
            {"rigid_updates", rigid_updates},
            {"symbolic_factorizations", symbolic_factorizations},
            {"numeric_factorizations", numeric_factorizations},
            {"linear_solves", linear_solves},
            {"pairings", pairings},
            {"candidate_pairs", candidate_pairs},
            {"projections", projections},
            {"geometry_updates", geometry_updates},
            {"active_set_changes", active_set_changes},
            {"tangential_rows", tangential_rows},
            {"slip_stiffnesses", slip_stiffnesses},
            {"obstacle_moves", obstacle_moves},
            {"free_motions", free_motions},
            {"interferences", interferences},
            {"stress_recoveries", stress_recoveries},
            {"error_estimates", error_estimates},
            {"files", files}};
  }
} // namespace Contact
