/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/active_set_search.h"

#include <algorithm>
#include <set>

#include "base/interruption.h"
#include "solvers/saddle_point/contact_complementarity.h"

namespace Contact
{
  ActiveSetSearch::ActiveSetSearch(const Discretization<2>    &discretization,
                                   ContactInterface<2>        &interface,
                                   const DirectSolver         &solver,
                                   const ContactLinearization &linearization)
    : interface(interface)
    , problem(discretization, interface, solver, linearization)
  {
  }



  bool ActiveSetSearch::correct(const GhostedVector &solution,
                                const GhostedVector &u_start,
                                Vector<double>      &update)
  {
    problem.collect(solution, u_start);
    Vector<double> corrected = update;
    if (!search(update, corrected) && !search_by_pivoting(update, corrected))
      return false;
    update = problem.complete(update, corrected);
    return true;
  }



  // The statuses of all points are updated at once, which is fast. If statuses
  // come back that were there before, the search cycles: then one point is
  // updated at a time, the first whose status changes. This ends for every
  // uniquely solvable frictionless contact problem (Murty's least-index rule
  // for linear complementarity problems), but a round factors a dense matrix of
  // all points that have changed, and pivoting comes to the same end by the
  // work of a few such: beyond 50 points the rounds get fewer.
  bool ActiveSetSearch::search(const Vector<double> &update,
                               Vector<double>       &corrected)
  {
    std::size_t                        n_rounds = 0;
    std::set<std::vector<signed char>> seen{problem.signature()};
    bool                               one_by_one = false;
    const std::size_t                  n          = problem.points.size();
    const std::size_t                  max_rounds =
      20 + 20 * std::min(n, 50 * 50 * 50 / (n * n + 1));
    while (update_statuses(corrected, one_by_one))
      {
        stop_if_interrupted(MPI_COMM_SELF); // of the system of one process
        if (++n_rounds > max_rounds)
          return false;
        one_by_one = one_by_one || !seen.insert(problem.signature()).second;
        problem.add_responses();
        corrected = problem.solve_changes(update);
      }
    return true;
  }



  bool ActiveSetSearch::search_by_pivoting(const Vector<double> &update,
                                           Vector<double>       &corrected)
  {
    for (unsigned int q = 0; q < problem.points.size(); ++q)
      {
        const ContactPoint<2> &point = interface.points()[q];
        problem.points[q].status     = point.status;
        problem.points[q].has_changed =
          point.facing && !interface.contact_pair(point).tied;
      }
    problem.add_responses();
    FullMatrix<double> matrix;
    Vector<double>     z;
    if (!problem.find_trial_values(update, matrix, z))
      return false;

    // Tractions along a void row do nothing: such a point has no shear.
    std::vector<ContactComplementarity::Point> tractions;
    std::vector<unsigned int>                  number_of;
    for (unsigned int i = 0; i < problem.responses.size(); ++i)
      {
        const unsigned int     q     = problem.responses[i].point;
        const ContactPoint<2> &point = interface.points()[q];
        if (!problem.responses[i].tangential)
          {
            tractions.push_back(
              {i, numbers::invalid_unsigned_int, interface.bounds.law(point)});
            number_of.push_back(q);
          }
        else if (interface.active_set.can_stick(point))
          tractions[std::find(number_of.begin(), number_of.end(), q) -
                    number_of.begin()]
            .q = i;
      }
    const Vector<double> constant = z;
    if (!ContactComplementarity(matrix, constant, tractions).solve(z))
      return false;

    for (unsigned int i = 0; i < number_of.size(); ++i)
      problem.points[number_of[i]].status = interface.active_set.updated_status(
        interface.points()[number_of[i]],
        PointStatus<2>(),
        z[tractions[i].p],
        Tensor<1, 1>({tractions[i].q == numbers::invalid_unsigned_int
                        ? 0.
                        : z[tractions[i].q]}));
    corrected = problem.solve_changes(update);
    return true;
  }



  PointStatus<2>
  ActiveSetSearch::status_after(const unsigned int    q,
                                const Vector<double> &update) const
  {
    const LinearizedContact::Point &point = problem.points[q];
    return interface.active_set.updated_status(interface.points()[q],
                                               point.status,
                                               point.p_after(update),
                                               Tensor<1, 1>(
                                                 {point.q_after(update)}));
  }



  bool ActiveSetSearch::update_statuses(const Vector<double> &update,
                                        const bool            one_by_one)
  {
    bool changed = false;
    for (unsigned int q = 0;
         q < problem.points.size() && !(changed && one_by_one);
         ++q)
      {
        LinearizedContact::Point &point  = problem.points[q];
        const PointStatus<2>      status = status_after(q, update);
        if (status == point.status)
          continue;
        changed           = true;
        point.has_changed = true;
        point.status      = status;
        if (!interface.bounds.follow && status.kind == Status::open)
          interface.bounds.reset(q);
      }
    return changed;
  }



  bool ActiveSetSearch::keeps_statuses() const
  {
    return problem.signature() == interface.active_set.signature();
  }
} // namespace Contact
