/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_counters_h
#define contact_counters_h

#include <map>
#include <string>

namespace Contact
{
  /**
   * Numbers of costly operations of this process: an effect that a scene does
   * not ask for leaves its counters at zero. Counted where the work is done,
   * since the start of the case: in those of the Discretization. Every process
   * counts its own.
   */
  struct Counters
  {
    // Bodies. A tangent is that of all cells of this process.
    unsigned long tangents                 = 0;
    unsigned long cell_tangents            = 0; // cells with tangent
    unsigned long cell_forces              = 0; // cells with or without
    unsigned long large_displacement_cells = 0; // of cell_forces
    unsigned long material_cells           = 0; // of cell_forces, not elastic
    unsigned long enhanced_cells = 0; // of cell_forces, with incompatible modes

    // Points that may yield: of cell_forces, and at the ends of increments.
    unsigned long return_mappings = 0;
    unsigned long history_updates = 0;

    unsigned long thermal_cells = 0; // whose thermal strain an increment sets
    unsigned long rigid_updates = 0; // rigid boundaries made constraints

    // Linear systems. The set-up of a multigrid hierarchy is both: the
    // aggregates follow from the pattern, the rest from the values.
    unsigned long symbolic_factorizations = 0;
    unsigned long numeric_factorizations  = 0;
    unsigned long linear_solves           = 0; // right-hand sides

    // Contact.
    unsigned long pairings        = 0; // of all points with the master
    unsigned long candidate_pairs = 0; // point and edge
    unsigned long projections     = 0; // points with a projection on the master
    unsigned long geometry_updates   = 0; // pairings that follow the bodies
    unsigned long active_set_changes = 0; // Newton steps after which a point
                                          // changes its status
    unsigned long tangential_rows  = 0;   // slip conditions put up
    unsigned long slip_stiffnesses = 0;   // made by this process, in 3-D
    unsigned long obstacle_moves =
      0;                             // given or free, by obstacle and increment
    unsigned long free_motions  = 0; // solved for, in each linear system
    unsigned long interferences = 0; // by contact pair and increment

    // Results.
    unsigned long stress_recoveries = 0; // at all vertices
    unsigned long error_estimates   = 0;
    unsigned long files             = 0; // written, whatever they are

    std::map<std::string, unsigned long> by_name() const;
  };
} // namespace Contact

#endif
