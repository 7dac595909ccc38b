/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_convergence_test_h
#define contact_convergence_test_h

#include <optional>

#include "model/increment_state.h"
#include "solvers/newton/force_scale.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Whether Newton's method has converged: the norm of the residual, forces
   * and constraints together, is at most the tolerance times the force F that
   * ForceScale finds.
   */
  template<int dim>
  class ConvergenceTest
  {
  public:
    explicit ConvergenceTest(const ContactModel<dim> &model)
      : model(model)
    {
    }

    /// On a new mesh, with points that are paired in the undeformed state. The
    /// tolerance is that of this mesh. Collective.
    void begin_level(const double tolerance);

    /// Compare the residual @p rhs of a state. Returns its norm [N per mm of
    /// thickness], the same on all ranks: it decides for all of them what comes
    /// next.
    double evaluate(const GhostedVector &rhs, const IncrementState<dim> &state);

    /// The norm of a residual [N per mm of thickness]. Collective.
    double norm_of(const GhostedVector &rhs) const;

    /// The norm and the force F of the last evaluation, and the norm by F.
    double residual() const
    {
      return norm / force;
    }

    double residual_norm() const
    {
      return norm;
    }

    double force_scale() const
    {
      return force;
    }

    /// See ForceScale. Collective.
    double given_force(const double load_factor) const
    {
      return scale->given(load_factor);
    }

    double tolerance() const
    {
      return newton_tolerance;
    }

    bool has_converged() const
    {
      return residual() <= newton_tolerance;
    }

    /// The last evaluation was at the end of an increment.
    void accept()
    {
      scale->accept(force);
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &*scale;
    }

  private:
    const ContactModel<dim>       &model;
    std::optional<ForceScale<dim>> scale;
    double                         newton_tolerance = 0;
    double                         norm  = 0; // [N per mm of thickness]
    double                         force = 0; // likewise
  };
} // namespace Contact

#endif
