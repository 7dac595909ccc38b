/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_active_set_h
#define contact_active_set_h

#include "contact/contact_interface.h"
#include "solvers/linear_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The active set of the linearised problem, found without a second
   * factorization.
   *
   * A semismooth Newton step solves A(S) delta_0 = -R(S) with the statuses S
   * the points made before. The plain primal-dual active set method would now
   * let the points decide anew, factorize A(S'), and so on: one factorization
   * for every small change of the set. But a point acts on everything else
   * through its tractions only. With the rows d_r of the trial values, the
   * loads v_r, and eta_r the traction that point r exerts beyond what S says,
   *   delta     = delta_0 - sum_r W_r eta_r,           W_r = A(S)^-1 v_r,
   *   d_q.delta = d_q.delta_0 - sum_r (d_q.W_r) eta_r,
   * where eta_r is an affine function of the trial values of point r. So the
   * active set iteration runs on the points alone, and a point that changes
   * costs one back substitution, once. (Woodbury's formula for the change of
   * the tangent, in the space of the contact points.)
   *
   * With a bound of the shear that moves with the pressure the linearised
   * problem is not symmetric, and the iteration may cycle. Then it is run with
   * frozen bounds, which is a convex problem, and the bounds follow the
   * pressures from turn to turn: the fixed point over Tresca's problems, on
   * the contact points alone. That may fail as well, where friction is large
   * beside what holds a body, as soft springs do. Lemke's method does not: see
   * search_by_pivoting().
   *
   * The step that results is one of sequential quadratic programming: the
   * number of Newton steps does not grow with the number of points by which
   * the guess of the contact area was wrong.
   */
  class ActiveSetSearch
  {
  public:
    ActiveSetSearch(const Discretization                  &discretization,
                    ContactInterface                      &interface,
                    const DirectSolver                    &solver,
                    const ContactInterface::Linearization &linearization);

    /**
     * Given the Newton @p update under the present statuses at @p solution,
     * constraints distributed, make it the update of the linearised problem.
     * A point that opens loses its frozen bound, see
     * ContactInterface::reset_bound(); the statuses in the points stay:
     * ContactInterface::update_statuses() makes the new ones after the step.
     * Returns whether no point wants to change its status; otherwise, as can be
     * where bounds of friction are frozen,
     * @p update is left as it is. Throws NotConverged if statuses let a body
     * go.
     */
    bool correct(const Vector<double> &solution,
                 const Vector<double> &u_start,
                 Vector<double>       &update);

    /// Whether the statuses found are those in the points.
    bool keeps_decisions() const;

  private:
    /// A traction as a function of trial values: constant and derivatives.
    struct AffineTraction
    {
      double constant, by_p, by_q;
    };

    /// A point in the linearised problem.
    struct LinearPoint
    {
      ContactInterface::Rows rows;
      double                 p, q; // trial values before the update
      PointStatus            status;
      AffineTraction         old_p, old_q; // under the old status
      bool                   has_changed = false;
    };

    /// The response of all unknowns to a unit of pressure or shear of a point.
    struct Response
    {
      unsigned int   point;
      bool           tangential;
      Vector<double> W;
    };

    void collect(const Vector<double> &solution, const Vector<double> &u_start);

    /// Find the active set under which @p corrected is the update, from the
    /// @p update of the old one. Returns whether it was found.
    bool search(const Vector<double> &update, Vector<double> &corrected);

    /// The same with bounds that are frozen in turns. Where this ends, the
    /// statuses are those of the last turn.
    bool search_by_turns(const Vector<double> &update,
                         Vector<double>       &corrected);

    /**
     * The linearised problem by Lemke's method, see ContactComplementarity,
     * from the responses of all points. Returns whether a solution was found;
     * not so where contact is all that holds a body.
     */
    bool search_by_pivoting(const Vector<double> &update,
                            Vector<double>       &corrected);

    /// Trial values of all points by what they exert: z = constant - matrix t.
    /// Returns whether that exists.
    bool find_trial_values(const Vector<double> &update,
                           FullMatrix<double>   &matrix,
                           Vector<double>       &constant) const;

    /// Freeze the bounds under the pressures of @p update. Returns the largest
    /// change by the largest bound.
    double freeze_bounds(const Vector<double> &update);

    bool bound_moves() const
    {
      return linearization.moving_bound && !bounds_are_frozen;
    }

    /// Let the points decide under the @p update, all or only the first that
    /// changes its status. Returns whether there was one.
    bool updated_status(const Vector<double> &update, const bool one_by_one);
    std::vector<signed char> signature() const;
    void                     add_responses();

    const Vector<double> &trial_row(const unsigned int q,
                                    const bool         tangential) const;

    /// The traction of a point under its status.
    AffineTraction traction(const unsigned int q, const bool tangential) const;
    /// The same minus that under the old status.
    AffineTraction excess(const unsigned int q, const bool tangential) const;

    /// The trial values z of the points that respond under the @p update, and
    /// what of them a unit of a traction takes away, G.
    void           find_responses(const Vector<double> &update,
                                  Vector<double>       &z,
                                  FullMatrix<double>   &G) const;
    Vector<double> solve_changes(const Vector<double> &update) const;

    const Discretization                 &discretization;
    ContactInterface                     &interface;
    const DirectSolver                   &solver;
    const ContactInterface::Linearization linearization;

    bool                     bounds_are_frozen = false;
    std::vector<LinearPoint> points;
    std::vector<Response>    responses;
  };
} // namespace Contact

#endif
