/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_newton_state_h
#define contact_newton_state_h

#include "solvers/newton/convergence_test.h"
#include "solvers/newton/linear_system.h"
#include "solvers/newton/newton_globalization.h"
#include "solvers/newton/pairing.h"
#include "solvers/newton/status_search.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The state of Newton's method: the residual where it is, the status of the
   * points there, and where the last step came from. The search for the active
   * set is that of NewtonGlobalization.
   */
  template<int dim>
  class NewtonState
  {
  public:
    NewtonState(const ContactModel<dim>                  &model,
                const std::unique_ptr<LinearSystem<dim>> &system,
                IncrementState<dim>                      &state,
                Pairing<dim>                             &pairing,
                TimerOutput                              &timer);

    /// On a new mesh, with points that are paired in the undeformed state.
    void begin_level(const double tolerance);

    /// No step has been made yet.
    void begin();

    /// Pair the points and evaluate the residual and the status of the points.
    /// Collective.
    void evaluate();

    /**
     * A step that turns a cell inside out was too long: half of it, and half
     * of that. Returns the residuals of these attempts. Collective.
     */
    std::vector<double> shorten_step();

    /// The state is where the next step begins. Throws NotConverged if it is
    /// no state of the bodies.
    void accept();

    /// Whether the residual is small enough and no point changes its status, or
    /// would if it had none before: where pressure and gap vanish one may for
    /// ever.
    bool has_converged() const;

    /// The points are paired anew: another problem.
    void pair_anew();

    /// Choose whether one point at a time is to change its status. Returns
    /// whether it is from now on.
    bool start_single_changes();

    /// Whether the tangent of the last step, in bodies where stresses turn, is
    /// that of the state: it was no longer than a hundredth of the way of the
    /// increment, or none was made. Collective.
    bool has_tangent_of_state() const;

    /// Make the next step. Returns the number of linear iterations.
    unsigned int make_step();

    /// The remark on bodies that went several times as far in a load increment
    /// as its first step, with the tangent of its start, leads to expect; empty
    /// if they did not, or where that is not known: of small displacements,
    /// supports that move, a start that is not the end of the last increment,
    /// and of friction, which lets go only in the second step. Collective.
    void        begin_increment(const bool starts_elsewhere);
    std::string note_of_leap() const;

    /// The points that change their status in this state, or want to, and a
    /// line on each of those that did.
    unsigned int n_changes() const
    {
      return n_status_changes;
    }

    std::string changes() const;

    /// The quantities that still change although the forces are in balance, in
    /// words; empty if the forces are not in balance.
    std::string unsettled() const;

    ConvergenceTest<dim> convergence;

  private:
    void             evaluate_with(const bool single_changes);
    unsigned int     update_status(const bool single_changes);
    VolumeRatio<dim> evaluate_bodies();

    /// Whether the last step turned a cell inside out and went further than
    /// the bodies are large: half of it follows, and surfaces that may be
    /// anywhere take long to pair. Collective.
    bool is_astray() const
    {
      return n_steps > 0 && smallest_volume.is_inside_out() &&
             state.largest_change(model, last) > convergence.size_of_bodies();
    }

    /// Pair the open points that have kept an earlier pairing. Returns whether
    /// one of them is to close.
    bool close_in_full_pairing();

    bool   satisfies_contact_law() const;
    void   check() const;
    bool   friction_acts() const;
    void   remember_status();
    double part_until_touch() const;

    const ContactModel<dim>                  &model;
    const std::unique_ptr<LinearSystem<dim>> &system;
    IncrementState<dim>                      &state;
    Pairing<dim>                             &pairing;
    TimerOutput                              &timer;
    StatusSearch<dim>                         statuses;

    GhostedVector    rhs; // minus the residual
    VolumeRatio<dim> smallest_volume;
    unsigned int     n_status_changes = 0;

    NewtonGlobalization           guard;
    unsigned int                  n_steps       = 0;
    bool                          one_at_a_time = false;
    double                        part          = 0; // of the last step
    GhostedVector                 last;          // where the last step began
    std::vector<PointStatus<dim>> last_statuses; // under which it was made
    double                        last_residual = 0;
    std::optional<double>         expected_way; // of the increment [mm]
  };
} // namespace Contact

#endif
