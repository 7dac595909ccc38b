/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_linear_system_h
#define contact_linear_system_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>

#include "contact/interface/contact_kernel.h"
#include "model/increment_state.h"
#include "parameters/parameters.h"

namespace Contact
{
  using namespace dealii;

  inline const std::string lost_stability =
    "a body has lost its stability: the tangent of the solution is not "
    "positive definite";
  inline const std::string friction_leaves_stability_open =
    "the stability of the solution is not known: friction makes the tangent "
    "unsymmetric, and its symmetric part is not positive definite";



  /**
   * The linear system of Newton's method, in one of two forms: with the
   * multipliers as unknowns (SaddlePointSystem) or with the active points
   * eliminated (CondensedSystem).
   */
  template<int dim>
  class LinearSystem
  {
  public:
    /// That of the parameters. @p linearization may change from step to step.
    static std::unique_ptr<LinearSystem<dim>>
    create(const ContactModel<dim>    &model,
           const Parameters::All      &parameters,
           const ContactLinearization &linearization,
           ConditionalOStream         &screen,
           TimerOutput                &timer);

    virtual ~LinearSystem() = default;

    /// The form and the solver.
    virtual std::string name() const = 0;

    /// Whether the multipliers are unknowns. If not they follow from the
    /// forces of the bodies, by recover_multipliers().
    virtual bool has_multipliers() const = 0;

    /// The points have been paired, and some perhaps with other edges.
    virtual void update_pattern(const bool edges_have_changed) = 0;

    /// The points are no longer those that the pattern was made for.
    virtual void clear_pattern() = 0;

    /// Set the multipliers of the state, behind a part of the last step (0:
    /// none), from a right-hand side, minus the residual of the bodies alone,
    /// or in 3-D from what the tangent of that step makes of it. Does nothing
    /// if they are unknowns.
    virtual void recover_multipliers(const GhostedVector &,
                                     const double,
                                     IncrementState<dim> &)
    {
    }

    /// Subtract the internal forces under displacements from the right-hand
    /// side, constraints eliminated, those of owned unknowns, if there is a
    /// faster way than Elasticity's. Returns whether there is. Collective.
    virtual bool subtract_forces(const GhostedVector &, GhostedVector &) const
    {
      return false;
    }

    /// Newton's method begins.
    virtual void begin_newton() = 0;

    /// The Newton step to make.
    struct Step
    {
      unsigned int number;        // from zero
      double       residual;      // [-], see ConvergenceTest<dim>
      double       last_residual; // before the last step
      double       tolerance;     // of Newton's method [-]
      double       force;         // that they are relative to [N per mm]
      bool continues; // the last step, with its tangent, under other statuses
    };

    /// Make it, under the present status of the points and from minus the
    /// residual @p rhs, which is overwritten. Returns the number of linear
    /// iterations.
    virtual unsigned int make_step(const Step          &step,
                                   GhostedVector       &rhs,
                                   IncrementState<dim> &state) = 0;

    /// Whether the statuses of the points have settled in the linear problems
    /// of all steps, where they are searched with the multipliers.
    virtual bool statuses_settle() const
    {
      return true;
    }

    /// Make the tangent of a state, of which tangent_is_indefinite() is to
    /// tell, without a step. Throws NotConverged if it is not definite.
    virtual void renew_tangent(const IncrementState<dim> &)
    {
    }

    /// Whether the tangent of the last step, which has led to @p state, is
    /// known to be indefinite: no stable state has such a one. What costs some
    /// iterations or a factorization is done only if it @p may_cost.
    /// Collective.
    virtual bool tangent_is_indefinite(const IncrementState<dim> &state,
                                       const bool                 may_cost) = 0;

    /// Why nobody would know, where large problems are left to a solver that
    /// does not tell: a sentence, or nothing.
    virtual std::string open_stability() const = 0;

    /// Of what may be why Newton's method does not converge: a sentence, or
    /// nothing.
    virtual std::string contradiction() const
    {
      return "";
    }
  };
} // namespace Contact

#endif
