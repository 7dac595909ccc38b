/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_status_search_h
#define contact_status_search_h

#include <memory>

#include "solvers/newton/convergence_test.h"
#include "solvers/newton/pairing.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The search for the statuses of the points in the linear problem of a Newton
   * step, in 3-D: as ActiveSetSearch does with multipliers, but by solving it
   * again.
   */
  template<int dim>
  class StatusSearch
  {
  public:
    StatusSearch(const ContactModel<dim>                  &model,
                 const std::unique_ptr<LinearSystem<dim>> &system,
                 const Pairing<dim>                       &pairing,
                 const ConvergenceTest<dim>               &convergence);

    /// Newton's method begins.
    void begin();

    /// No more searches until then.
    void stop()
    {
      searches = false;
    }

    /// Solve the linear problem of @p step again under the statuses that its
    /// solution has, until they settle; @p rhs is minus the residual of the
    /// bodies, @p start where the step begins. Returns the number of linear
    /// iterations. Collective.
    unsigned int search(typename LinearSystem<dim>::Step step,
                        const GhostedVector             &start,
                        GhostedVector                   &rhs,
                        IncrementState<dim>             &state);

  private:
    /// Give the points the statuses that they have in the solution of the
    /// linear problem, unless that is one to @p tolerance under these, too
    /// [-]. Returns whether one is another.
    bool change_statuses(const double         tolerance,
                         const GhostedVector &start,
                         GhostedVector       &rhs,
                         IncrementState<dim> &state) const;

    /// The statuses in a solution, but open points that slip by more than half
    /// of their edge stay open: the gap there is that of another place.
    std::vector<PointStatus<dim>> statuses_in(const IncrementState<dim> &state,
                                              const GhostedVector &start) const;

    const ContactModel<dim>                  &model;
    const std::unique_ptr<LinearSystem<dim>> &system;
    const Pairing<dim>                       &pairing;
    const ConvergenceTest<dim>               &convergence;
    bool                                      searches = false;
  };
} // namespace Contact

#endif
