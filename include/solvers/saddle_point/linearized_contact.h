/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_linearized_contact_h
#define contact_linearized_contact_h

#include "contact/interface/contact_kernel.h"
#include "solid/discretization.h"
#include "solvers/direct/linear_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The problem of one semismooth Newton step in the space of the contact
   * points.
   *
   * A step solves A(S) delta_0 = -R(S) with the present statuses S. The plain
   * primal-dual active set method would now update the statuses, factorize
   * A(S'), and so on: one factorization for every small change of the set. But
   * a point acts on everything else through its tractions only. With the rows
   * d_r of the trial values, the loads v_r, and eta_r the traction of point r
   * beyond that under S,
   *   delta     = delta_0 - sum_r W_r eta_r,           W_r = A(S)^-1 v_r,
   *   d_q.delta = d_q.delta_0 - sum_r (d_q.W_r) eta_r,
   * where eta_r is an affine function of the trial values of point r:
   * Woodbury's formula for the change of the tangent. A point whose status
   * changes costs one back substitution, once.
   */
  class LinearizedContact
  {
  public:
    /// A traction as a function of trial values: constant and derivatives.
    struct AffineTraction
    {
      double constant, by_p, by_q;
    };

    struct Point
    {
      /// The trial values after the @p update.
      double p_after(const Vector<double> &update) const;
      double q_after(const Vector<double> &update) const;

      ContactKernel<2>::Rows rows;
      double                 p, q; // trial values before the update
      PointStatus<2>         status;
      AffineTraction         old_p, old_q; // under the old status
      bool                   has_changed = false;
    };

    /// The response of the unknowns to a unit of pressure or shear of a point:
    /// of all, or of those of contact, see DirectSolver::solve_at_border().
    struct Response
    {
      unsigned int   point;
      bool           tangential;
      Vector<double> W;
    };

    LinearizedContact(const Discretization<2>    &discretization,
                      const ContactInterface<2>  &interface,
                      const DirectSolver         &solver,
                      const ContactLinearization &linearization);

    /// Linearise all points at @p solution under their statuses.
    void collect(const GhostedVector &solution, const GhostedVector &u_start);

    /// Compute the responses to the points that have changed, and what they are
    /// to the trial values of these points.
    void add_responses();

    /// The update of the unknowns of contact, at least, under the new statuses,
    /// from that under the old ones. Throws NotConverged if statuses let a body
    /// go.
    Vector<double> solve_changes(const Vector<double> &update);

    /// The update of all unknowns behind solve_changes(), which returned
    /// @p corrected.
    Vector<double> complete(const Vector<double> &update,
                            const Vector<double> &corrected) const;

    /// The trial values of the points with a response as a function of their
    /// tractions: z = @p constant - @p matrix t. Returns whether that exists;
    /// not so where contact is all that holds a body.
    bool find_trial_values(const Vector<double> &update,
                           FullMatrix<double>   &matrix,
                           Vector<double>       &constant) const;

    /// The statuses of all points, to be compared.
    std::vector<signed char> signature() const;

    const ContactLinearization linearization;
    std::vector<Point>         points;
    std::vector<Response>      responses;

  private:
    const Vector<double> &trial_row(const unsigned int q,
                                    const bool         tangential) const;

    /// What prescribed displacements add to every distributed vector.
    Vector<double> inhomogeneity() const;

    const Vector<double> &load(const unsigned int q,
                               const bool         tangential) const;

    /// The traction of a point under its status.
    AffineTraction traction(const unsigned int q, const bool tangential) const;

    /// The same minus that under the old status.
    AffineTraction excess(const unsigned int q, const bool tangential) const;

    /// The trial values of the points with a response under the @p update.
    Vector<double> trial_values(const Vector<double> &update) const;

    /// Their decrease by a unit of each traction: what add_responses() adds are
    /// further rows and columns.
    FullMatrix<double> decreases;

    const Discretization<2>   &discretization;
    const ContactInterface<2> &interface;
    const DirectSolver        &solver;

    /// The tractions beyond those of the old statuses, by response.
    Vector<double> excess_tractions;
  };
} // namespace Contact

#endif
