/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_increment_state_h
#define contact_increment_state_h

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The unknowns, the displacements and then the multipliers, and where they
   * were at the start of the load increment: slip counts from there, and an
   * increment that does not converge ends there again.
   */
  template<int dim>
  struct IncrementState
  {
    GhostedVector solution;
    GhostedVector start;
    double        load_factor = 0, start_factor = 0;

    /// Undeformed, without forces.
    void reinit(const ContactModel<dim> &model)
    {
      solution = start = model.zero();
      start_factor     = load_factor;
    }

    /// An increment starts here, from one load factor to another.
    void
    begin(const ContactModel<dim> &model, const double from, const double to)
    {
      start_factor = from;
      load_factor  = to;
      start        = solution;
      if (model.has_friction())
        model.interface->active_set.set_support_motion(
          model.discretization->support_motion(start, to));
      if (model.interface)
        {
          // Large, and made anew with the pairing in the first Newton step.
          model.interface->clear_changes();
          points_at_start = model.interface->points();
        }
    }

    /// Back to its start, also of what the points know and which edges they
    /// face.
    void roll_back(ContactModel<dim> &model)
    {
      solution     = start;
      start_factor = load_factor;
      if (model.interface)
        model.interface->set_points(points_at_start);
    }

    /// The largest change of a displacement [mm]. Collective.
    double largest_change(const ContactModel<dim> &model,
                          const GhostedVector     &from) const
    {
      double     change = 0;
      const auto n = model.discretization->distribution->locally_owned_size();
      for (unsigned int k = 0; k < n; ++k)
        change =
          std::max(change, std::abs(solution.begin()[k] - from.begin()[k]));
      return Utilities::MPI::max(change, model.discretization->communicator);
    }

  private:
    std::vector<ContactPoint<dim>> points_at_start;
  };
} // namespace Contact

#endif
