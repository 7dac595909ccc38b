/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_summary_h
#define contact_summary_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/timer.h>

#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adaptivity/effect_estimate.h"
#include "adaptivity/probe_errors.h"
#include "base/findings.h"
#include "solid/strain_range.h"

namespace Contact
{
  /// A probed value and what it is compared with.
  struct ProbeResult
  {
    std::string name;
    std::string unit;
    bool        is_displacement = false;
    double      value           = 0;

    // Both or none; the tolerance is relative to the reference, which is
    // not zero.
    std::optional<double> reference = {};
    std::optional<double> tolerance = {};

    /// The estimated discretization error, in the unit of the value, and what
    /// estimates it.
    std::optional<double> error     = {};
    std::string           estimator = {};

    /// Whether the mesh before confirms an estimate by dual weighted residuals,
    /// see agrees_with_last(); without an estimate the reason, or nothing if
    /// none was asked for.
    bool        error_is_confirmed = true;
    std::string not_estimated      = {};

    /// Whether something tells that the error may be larger: levels that do not
    /// agree, a corner, a zone of contact that the mesh does not resolve.
    bool error_may_be_larger = false;

    /// Where effects are estimated, in the unit of the value: the error that
    /// is accepted, 1 % unless an accuracy is asked for, and what the loops
    /// and the linear solver leave.
    std::optional<double> accepted_error = {}, loop_error = {};

    /// value/reference - 1, if there is a reference.
    std::optional<double> relative_deviation() const;

    /// Whether the deviation is within the tolerance; true without reference.
    bool within() const;
  };



  /// The cost of one load increment, or of the attempt at one, and its end.
  struct IncrementRecord
  {
    unsigned int level               = 0; // of refinement
    double       load_factor         = 0;
    unsigned int newton_iterations   = 0; // in all loops together
    unsigned int linear_iterations   = 0; // of the condensed system
    unsigned int friction_iterations = 0;
    unsigned int geometry_iterations = 0;
    unsigned int active              = 0; // contact points, stick and slip
    unsigned int stick               = 0;
    unsigned int slip                = 0;
    unsigned int halved_steps        = 0; // Newton steps that were too long
    unsigned int cycles              = 0; // of the active set, left one by one
    double       hold_work           = 0; // of stabilization [N mm per mm]
    bool         converged           = false;
    std::string  message; // why it was given up

    /// The force that is round-off beside those that act [N per mm of
    /// thickness].
    double round_off_force = 0;

    /// By name: how far invariants are not met, and works since the start
    /// [N mm per mm of thickness], see Invariants.
    std::map<std::string, double> invariants, works;

    /// The rotations of rigid boundaries that probes ask for, with full turns
    /// [rad].
    std::map<std::string, Tensor<1, 3>> rotations;

    /// The probes by name, those of stresses and plastic strains where an
    /// increment of the last mesh ends; and what contact exerts by contact
    /// pair, see ContactResults.
    std::map<std::string, double>                        probes;
    std::map<std::string, std::map<std::string, double>> contact;

    /// The reactions of each group of supports, by direction, see Invariants.
    std::map<std::string, std::map<std::string, double>> reactions;

    /// By name, see BodyResult; where steps of a cut increment end, none.
    std::map<std::string, std::map<std::string, double>> bodies;

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &level &load_factor &newton_iterations &linear_iterations
        &friction_iterations &geometry_iterations &active &stick &slip
          &halved_steps &cycles &hold_work &converged &message &invariants
            &works &probes &contact &reactions &bodies &rotations;
    }
  };



  /// The time of a phase of the program [s], and how often it was entered.
  struct PhaseTime
  {
    double       cpu   = 0;
    double       wall  = 0;
    unsigned int calls = 0;
  };

  /// Of all phases of a timer.
  std::map<std::string, PhaseTime>
  phase_times(const dealii::TimerOutput &timer);



  /// The cost of a mesh of nested iteration; without, there is one.
  struct LevelRecord
  {
    std::size_t  n_cells         = 0;
    std::size_t  n_displacements = 0; // unknowns
    std::size_t  n_multipliers   = 0;
    std::string  system; // and how it was solved
    unsigned int newton_iterations = 0;
    unsigned int linear_iterations = 0; // 1 for each direct solve

    std::map<std::string, double>    probes; // value by name
    ProbeErrors                      errors; // of them, see GoalErrors
    std::map<std::string, PhaseTime> time;   // by phase
    double                           peak_memory_mb = 0; // of all so far
  };



  /// The record of the run of one case.
  struct RunSummary
  {
    std::string case_name;
    std::string mesh_file;

    /// Whether all increments converged, and if not what went wrong.
    bool        converged   = false;
    bool        interrupted = false;
    std::string message;

    /// All that the user was told on the standard error.
    Findings findings;

    /// Why an accuracy that was asked for is not reached, or nothing.
    std::string accuracy_missed;

    /// The names of the probes as they are in the parameter file.
    std::vector<std::string> probe_names;

    std::vector<ProbeResult>     probes;
    std::vector<IncrementRecord> increments;
    std::vector<LevelRecord>     levels;

    bool        in_space        = false; // the mesh has volumes
    std::size_t n_displacements = 0;     // unknowns
    std::size_t n_multipliers   = 0;
    std::size_t n_held          = 0; // displacements, most by a process

    /// The contact zone at full load by contact pair and name, see
    /// ContactResults; empty where there is none.
    std::map<std::string, std::map<std::string, double>> contact;

    std::map<std::string, PhaseTime> time; // by phase
    double                           peak_memory_mb = 0;

    /// The effects that the case switches on, for instance "friction" ->
    /// "Coulomb 0.1".
    std::map<std::string, std::string> effects;

    /// By name, see BodyResult; empty where bodies have nothing to tell.
    std::map<std::string, std::map<std::string, double>> bodies;

    /// Where effects are estimated.
    std::optional<StrainRange> strain_range;

    /// What effects do to the probes, see EffectEstimates.
    std::vector<EffectEstimate> effect_estimates;

    /// The numbers of costly operations, see Counters.
    std::map<std::string, unsigned long> counters;

    /// Converged, no invariant is violated, and all probes are within their
    /// tolerances.
    bool passed() const;
  };



  /// The estimates of the last level by dual weighted residuals.
  void take_errors_of_level(RunSummary &summary);

  /**
   * Estimate the discretization errors of the probes by their differences from
   * the values on a coarser level, the finest with at most half of the
   * unknowns. That is no less than the error if from one to the other the error
   * at least halves. Without such a level there is no estimate.
   */
  void estimate_errors(RunSummary &summary);

  /**
   * Estimate them from the values @p finer on the mesh refined once, as twice
   * the difference: again no less than the error if refining at least halves
   * it.
   */
  void estimate_errors(RunSummary                     &summary,
                       const std::vector<ProbeResult> &finer);

  /// The largest resident memory of this process so far [MB = 2^20 bytes].
  double peak_memory_mb();

  /// Whether the last run that has left its summary in a directory has
  /// converged.
  bool has_converged(const std::filesystem::path &directory);

  /// Write a summary as JSON.
  void write_summary(const RunSummary &summary, std::ostream &out);
} // namespace Contact

#endif
