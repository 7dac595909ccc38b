/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_h
#define contact_pairing_h

#include <deal.II/base/timer.h>

#include <optional>

#include "contact/interface/contact_kernel.h"
#include "model/increment_state.h"
#include "parameters/parameters.h"
#include "solvers/newton/aitken.h"
#include "solvers/newton/linear_system.h"
#include "solvers/newton/pairing_cycle_control.h"
#include "solvers/newton/relaxation.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The pairing of the contact points with the master in the course of Newton's
   * method: under which displacements it is made, whether the tangent knows how
   * it moves with the bodies, and whether a state may be accepted that is not
   * the one it was made under.
   */
  template<int dim>
  class Pairing
  {
  public:
    Pairing(const ContactModel<dim> &model,
            const Parameters::All   &parameters,
            TimerOutput             &timer);

    /// A new mesh, whose linear system is @p system.
    void begin_level(LinearSystem<dim> &system);

    /// Add the forces of contact in a state to those that all ranks have.
    void add_contact(const IncrementState<dim> &state,
                     GhostedVector             &rhs) const;

    /// The terms that the kernel linearises at present.
    const ContactLinearization &linearization() const
    {
      return present;
    }

    /// Whether the points are paired with bodies that have moved, and whether
    /// before each Newton step.
    bool follows() const;
    bool follows_each_step() const;

    /// Pair all points under the displacements @p configuration; in the theory
    /// of small displacements under none.
    void pair(const GhostedVector &configuration);

    /// The same for a start from which Newton's method follows: open points
    /// that touch nothing may keep an earlier pairing until complete(), or on a
    /// mesh that starts @p from_coarser_mesh have none.
    void pair_near_contact(const GhostedVector &configuration,
                           const bool           from_coarser_mesh = false);

    /// The displacements of the last pairing.
    const GhostedVector &configuration() const
    {
      return paired_at;
    }

    /// The way of the surfaces since the last pairing, and since the start of
    /// the increment [mm].
    double misplacement(const IncrementState<dim> &state) const;
    double way(const IncrementState<dim> &state) const;

    /// The distance that the projection points of the forces may have from the
    /// closest points in a state that was accepted [mm].
    double shift_of_projections(const IncrementState<dim> &state) const;

    /// Pair again in a fixed-point iteration that has led to @p solution: where
    /// it jumps to and fro, on the way.
    void renew(const GhostedVector &solution, Relaxation &relaxation);

    /// An increment begins, or the @p part of one that was cut, and Newton's
    /// method.
    void begin_increment(const double part);
    void begin_newton();

    /// Before a Newton step: pair the bodies where they are. If the tangent
    /// does not know how the pairing moves with them, and steps in one and the
    /// same direction become but slowly shorter, where these lead to.
    void follow(const GhostedVector &solution, const bool after_a_step);

    /// A Newton step has led from @p last to the state; progress is the
    /// smallest residual so far. See PairingCycleControl.
    void advance(const IncrementState<dim> &state,
                 const GhostedVector       &last,
                 const bool                 progress);

    /// Freeze the pairing if the guard says so, or if Newton's method stands
    /// still under one that moves: returns whether it has been frozen now.
    bool has_been_frozen(const bool stands_still);

    /// Pair the points that have kept an earlier pairing in follow(), the
    /// surfaces being where they were then. Returns whether any may have.
    /// Collective.
    bool complete();

    /// Whether the solution under this pairing is one.
    bool accepts(const IncrementState<dim> &state);

    /// If it is not, pair anew. Throws NotConverged where closest points jump
    /// between places that are not the same to the forces.
    void renew(const IncrementState<dim> &state);

    /**
     * In 3-D, without friction, the condensed matrix is symmetric and knows
     * nothing of how the pairing changes with the displacements. Where that
     * does not converge, it is unsymmetric from here on, and knows it. Returns
     * whether it has become so.
     */
    bool use_consistent_tangent();

    /// The reason why a pairing is not accepted.
    std::string unsettled(const IncrementState<dim> &state) const;

    /// The remark on closest points that jump between two places for good, with
    /// what the moments lose, see Invariants; empty if they do not.
    std::string note(const double moment_imbalance) const;

  private:
    void freeze(const bool frozen);
    bool has_derivatives() const;
    void pair(const GhostedVector &configuration, const PairingMode &mode);

    ProjectionMismatch mismatch_of(const IncrementState<dim> &state) const;

    const ContactModel<dim> &model;
    const Parameters::All   &parameters;
    TimerOutput             &timer;
    LinearSystem<dim>       *system = nullptr;

    ContactLinearization present{};
    GhostedVector        paired_at;
    bool                 is_complete = true; // no point has an earlier pairing
    AitkenExtrapolation  extrapolation;

    // Of the present Newton's method.
    PairingCycleControl guard;
    Relaxation          relaxation;
    bool                is_frozen     = false;
    bool                is_in_tangent = false; // though there is no friction

    // Where a pairing is accepted whose closest points jump.
    std::optional<ProjectionMismatch> jump;

    // Of the present increment.
    double part = 1;
  };
} // namespace Contact

#endif
