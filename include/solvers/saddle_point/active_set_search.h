/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_active_set_search_h
#define contact_active_set_search_h

#include "solid/discretization.h"
#include "solvers/saddle_point/linearized_contact.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The active set of the linearised problem, found without a second
   * factorization: the primal-dual active set method on LinearizedContact,
   * where a point that changes its status costs one back substitution.
   *
   * With a bound of the shear that moves with the pressure the iteration may
   * cycle. Lemke's method does not: see search_by_pivoting().
   *
   * The step is one of sequential quadratic programming: the number of steps
   * does not grow with the number of points that were guessed wrong.
   */
  class ActiveSetSearch
  {
  public:
    ActiveSetSearch(const Discretization<2>    &discretization,
                    ContactInterface<2>        &interface,
                    const DirectSolver         &solver,
                    const ContactLinearization &linearization);

    /**
     * Given the Newton @p update under the present statuses at @p solution,
     * constraints distributed, make it the update of the linearised problem.
     * A point that opens loses its frozen bound, see
     * FrictionBounds::reset(); the statuses in the points stay:
     * ActiveSet::update() makes the new ones after the step.
     * Returns whether no point wants to change its status; otherwise, as can be
     * where bounds of friction are frozen,
     * @p update is left as it is. Throws NotConverged if statuses let a body
     * go.
     */
    bool correct(const GhostedVector &solution,
                 const GhostedVector &u_start,
                 Vector<double>      &update);

    /// Whether the statuses found are those in the points.
    bool keeps_statuses() const;

  private:
    /// Find the active set under which @p corrected is the update, from the
    /// @p update of the old one. Returns whether it was found.
    bool search(const Vector<double> &update, Vector<double> &corrected);

    /**
     * The linearised problem by Lemke's method, see ContactComplementarity,
     * from the responses of all points. Returns whether a solution was found;
     * not so where contact is all that holds a body.
     */
    bool search_by_pivoting(const Vector<double> &update,
                            Vector<double>       &corrected);

    /// The status of a point after an update, by its own trial values alone.
    PointStatus<2> status_after(const unsigned int    q,
                                const Vector<double> &update) const;

    /// Update the statuses under the @p update, all or only the first that
    /// changes. Returns whether there was one.
    bool update_statuses(const Vector<double> &update, const bool one_by_one);

    ContactInterface<2> &interface;
    LinearizedContact    problem;
  };
} // namespace Contact

#endif
