/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/active_set.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "solvers/contact_complementarity.h"

namespace Contact
{
  namespace
  {
    double dot(const std::vector<types::global_dof_index> &unknowns,
               const Vector<double>                       &row,
               const Vector<double>                       &vector)
    {
      double sum = 0;
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        sum += row[i] * vector[unknowns[i]];
      return sum;
    }
  } // namespace



  ActiveSetSearch::ActiveSetSearch(
    const Discretization                  &discretization,
    ContactInterface                      &interface,
    const DirectSolver                    &solver,
    const ContactInterface::Linearization &linearization)
    : discretization(discretization)
    , interface(interface)
    , solver(solver)
    , linearization(linearization)
  {
  }



  bool ActiveSetSearch::correct(const Vector<double> &solution,
                                const Vector<double> &u_start,
                                Vector<double>       &update)
  {
    collect(solution, u_start);
    Vector<double> corrected = update;
    if (!search(update, corrected) &&
        !(linearization.moving_bound && search_by_turns(update, corrected)) &&
        !search_by_pivoting(update, corrected))
      return false;
    update = corrected;
    return true;
  }



  // All points decide at once, which is fast. Decisions that were there before
  // are a cycle: then one point at a time, the first that wants to, which ends
  // for every uniquely solvable frictionless contact problem (Murty's
  // least-index rule for linear complementarity problems).
  bool ActiveSetSearch::search(const Vector<double> &update,
                               Vector<double>       &corrected)
  {
    std::set<std::vector<signed char>> seen{signature()};
    bool                               one_by_one = false;
    unsigned int                       n_rounds   = 0;
    const unsigned int                 max_rounds = 20 + 20 * points.size();
    while (updated_status(corrected, one_by_one))
      {
        if (++n_rounds > max_rounds)
          return false;
        one_by_one = one_by_one || !seen.insert(signature()).second;
        add_responses();
        corrected = solve_changes(update);
      }
    return true;
  }



  bool ActiveSetSearch::search_by_turns(const Vector<double> &update,
                                        Vector<double>       &corrected)
  {
    // Only signs matter: bounds to a thousandth are enough.
    const unsigned int max_turns = 20;
    const double       tolerance = 1e-3;

    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].status = interface.points[q].status;
    bounds_are_frozen = true;
    corrected         = update;
    bool   is_found   = true;
    double change     = 1;
    for (unsigned int turn = 0;
         turn < max_turns && change > tolerance && is_found;
         ++turn)
      {
        change   = freeze_bounds(corrected);
        is_found = search(update, corrected);
      }
    bounds_are_frozen = false;
    if (!is_found || change > tolerance)
      return false;

    // A point that has opened and closed again on the way has lost its bound.
    corrected = solve_changes(update);
    return !updated_status(corrected, /*one_by_one=*/false);
  }



  bool ActiveSetSearch::search_by_pivoting(const Vector<double> &update,
                                           Vector<double>       &corrected)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const ContactPoint &point = interface.points[q];
        points[q].status          = point.status;
        points[q].has_changed =
          point.facing && !interface.contact_pair(point).tied;
      }
    add_responses();
    FullMatrix<double> matrix;
    Vector<double>     z;
    if (!find_trial_values(update, matrix, z))
      return false;

    // Tractions along a void row do nothing: such a point has no shear.
    std::vector<ContactComplementarity::Point> tractions;
    std::vector<unsigned int>                  number_of;
    for (unsigned int i = 0; i < responses.size(); ++i)
      {
        const unsigned int  q     = responses[i].point;
        const ContactPoint &point = interface.points[q];
        if (!responses[i].tangential)
          {
            const FrictionLaw frozen{point.friction_bound, 0};
            tractions.push_back(
              {i,
               numbers::invalid_unsigned_int,
               bound_moves() ? interface.contact_pair(point).law : frozen});
            number_of.push_back(q);
          }
        else if (interface.can_stick(point))
          tractions[std::find(number_of.begin(), number_of.end(), q) -
                    number_of.begin()]
            .q = i;
      }
    const Vector<double> constant = z;
    if (!ContactComplementarity(matrix, constant, tractions).solve(z))
      return false;

    for (unsigned int i = 0; i < number_of.size(); ++i)
      points[number_of[i]].status =
        interface.updated_status(interface.points[number_of[i]],
                                 PointStatus(),
                                 z[tractions[i].p],
                                 tractions[i].q == numbers::invalid_unsigned_int
                                   ? 0.
                                   : z[tractions[i].q],
                                 bound_moves());
    corrected = solve_changes(update);
    return true;
  }



  // The tractions t are those of the old statuses, a + D z, and the excess
  // eta, and z = z_0 - G eta: (1 - G D) z = z_0 + G a - G t.
  bool ActiveSetSearch::find_trial_values(const Vector<double> &update,
                                          FullMatrix<double>   &matrix,
                                          Vector<double>       &constant) const
  {
    const unsigned int n = responses.size();
    FullMatrix<double> G, D(n, n);
    Vector<double>     a(n);
    find_responses(update, constant, G);
    for (unsigned int i = 0; i < n; ++i)
      {
        const LinearPoint    &point = points[responses[i].point];
        const AffineTraction &old =
          responses[i].tangential ? point.old_q : point.old_p;
        a[i] = old.constant;
        for (unsigned int j = 0; j < n; ++j)
          if (responses[j].point == responses[i].point)
            D(i, j) = responses[j].tangential ? old.by_q : old.by_p;
      }
    FullMatrix<double> GD(n, n);
    G.mmult(GD, D);
    LAPACKFullMatrix<double> system(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        system(i, j) = (i == j ? 1 : 0) - GD(i, j);
    G.vmult_add(constant, a);

    // Singular, but for round-off, where nothing but contact holds a body.
    const double norm = system.l1_norm();
    try
      {
        system.invert();
      }
    catch (const LACExceptions::ExcSingular &)
      {
        return false;
      }
    if (!(norm * system.l1_norm() < 1e12))
      return false;
    const Vector<double> unloaded = constant;
    system.vmult(constant, unloaded);
    LAPACKFullMatrix<double> loads(n, n), response(n, n);
    loads = G;
    system.mmult(response, loads);
    matrix.reinit(n, n);
    matrix = response;
    return true;
  }



  double ActiveSetSearch::freeze_bounds(const Vector<double> &update)
  {
    double change = 0, largest = 0;
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        ContactPoint &point = interface.points[q];
        const double  p =
          points[q].p +
          dot(points[q].rows.unknowns, points[q].rows.p_trial, update);
        const double bound = interface.contact_pair(point).law.bound(p);
        change  = std::max(change, std::abs(bound - point.friction_bound));
        largest = std::max(largest, bound);
        point.friction_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  void ActiveSetSearch::collect(const Vector<double> &solution,
                                const Vector<double> &u_start)
  {
    responses.clear();
    points.resize(interface.points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const ContactPoint &point = interface.points[q];
        const ContactState  now   = interface.state(point, solution, u_start);
        interface.rows(point, solution, u_start, linearization, points[q].rows);
        points[q].p           = now.p_trial;
        points[q].q           = now.q_trial;
        points[q].status      = point.status;
        points[q].old_p       = traction(q, false);
        points[q].old_q       = traction(q, true);
        points[q].has_changed = false;
      }
  }



  bool ActiveSetSearch::updated_status(const Vector<double> &update,
                                       const bool            one_by_one)
  {
    bool changed = false;
    for (unsigned int q = 0; q < points.size() && !(changed && one_by_one); ++q)
      {
        LinearPoint      &point    = points[q];
        const auto       &unknowns = point.rows.unknowns;
        const PointStatus status   = interface.updated_status(
          interface.points[q],
          point.status,
          point.p + dot(unknowns, point.rows.p_trial, update),
          point.q + dot(unknowns, point.rows.q_trial, update),
          bound_moves());
        if (status == point.status)
          continue;
        changed           = true;
        point.has_changed = true;
        point.status      = status;
        if (!bound_moves() && status.kind == Status::open)
          interface.reset_bound(q);
      }
    return changed;
  }



  bool ActiveSetSearch::keeps_decisions() const
  {
    return signature() == interface.signature();
  }



  std::vector<signed char> ActiveSetSearch::signature() const
  {
    std::vector<signed char> signature;
    for (const LinearPoint &point : points)
      signature.push_back(point.status.code());
    return signature;
  }



  void ActiveSetSearch::add_responses()
  {
    const auto is_known = [this](const unsigned int q, const bool tangential) {
      return std::any_of(responses.begin(),
                         responses.end(),
                         [&](const Response &response) {
                           return response.point == q &&
                                  response.tangential == tangential;
                         });
    };

    // The part that a prescribed displacement adds to every distributed vector.
    const unsigned int n_unknowns =
      discretization.dof_handler.n_dofs() + interface.n_multipliers();
    Vector<double> inhomogeneity(n_unknowns);
    discretization.constraints.distribute(inhomogeneity);

    for (unsigned int q = 0; q < points.size(); ++q)
      for (const bool tangential : {false, true})
        {
          if (!points[q].has_changed || is_known(q, tangential) ||
              (tangential && interface.contact_pair(interface.points[q])
                               .law.is_frictionless()))
            continue;

          const auto    &rows = points[q].rows;
          Vector<double> W(n_unknowns);
          discretization.constraints.distribute_local_to_global(tangential
                                                                  ? rows.load_q
                                                                  : rows.load_p,
                                                                rows.unknowns,
                                                                W);
          solver.solve(W);
          discretization.constraints.distribute(W);
          W -= inhomogeneity;
          responses.push_back({q, tangential, std::move(W)});
        }
  }



  const Vector<double> &ActiveSetSearch::trial_row(const unsigned int q,
                                                   const bool tangential) const
  {
    return tangential ? points[q].rows.q_trial : points[q].rows.p_trial;
  }



  ActiveSetSearch::AffineTraction
  ActiveSetSearch::traction(const unsigned int q, const bool tangential) const
  {
    // A point that opens or closes is linearised from the side of contact.
    const double   p = std::max(points[q].p, 0.);
    const Traction t = interface.traction(interface.points[q],
                                          points[q].status,
                                          p,
                                          points[q].q,
                                          bound_moves());
    if (tangential)
      return {t.q - t.dq_dp * p - t.dq_dq * points[q].q, t.dq_dp, t.dq_dq};
    return {t.p - t.dp_dp * p, t.dp_dp, 0.};
  }



  ActiveSetSearch::AffineTraction
  ActiveSetSearch::excess(const unsigned int q, const bool tangential) const
  {
    const AffineTraction  now = traction(q, tangential);
    const AffineTraction &old = tangential ? points[q].old_q : points[q].old_p;
    return {now.constant - old.constant,
            now.by_p - old.by_p,
            now.by_q - old.by_q};
  }



  void ActiveSetSearch::find_responses(const Vector<double> &update,
                                       Vector<double>       &z,
                                       FullMatrix<double>   &G) const
  {
    const unsigned int n = responses.size();
    z.reinit(n);
    G.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto &[q, tangential, W] = responses[i];
        const auto &row                = trial_row(q, tangential);
        const auto &unknowns           = points[q].rows.unknowns;
        z[i] =
          (tangential ? points[q].q : points[q].p) + dot(unknowns, row, update);
        for (unsigned int j = 0; j < n; ++j)
          G(i, j) = dot(unknowns, row, responses[j].W);
      }
  }



  // With the trial values z of the points that respond, eta = eta_0 + D z:
  //   (I + G D) z = z_0 - G eta_0,  G_qr = d_q . W_r.
  Vector<double>
  ActiveSetSearch::solve_changes(const Vector<double> &update) const
  {
    const unsigned int n = responses.size();

    FullMatrix<double> G, D(n, n), system(n, n);
    Vector<double>     z, eta(n), G_eta(n);
    find_responses(update, z, G);
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int   q        = responses[i].point;
        const AffineTraction traction = excess(q, responses[i].tangential);
        eta[i]                        = traction.constant;
        for (unsigned int j = 0; j < n; ++j)
          if (responses[j].point == q)
            D(i, j) = responses[j].tangential ? traction.by_q : traction.by_p;
      }

    G.mmult(system, D);
    for (unsigned int i = 0; i < n; ++i)
      system(i, i) += 1;
    G.vmult(G_eta, eta);
    z -= G_eta;

    LAPACKFullMatrix<double> lu(n, n);
    lu = system;
    try
      {
        lu.compute_lu_factorization();
        lu.solve(z);
      }
    catch (const LACExceptions::ExcSingular &)
      {
        throw NotConverged("the search of the active set meets statuses "
                           "under which nothing holds a body");
      }
    D.vmult_add(eta, z);

    Vector<double> corrected = update;
    for (unsigned int i = 0; i < n; ++i)
      corrected.add(-eta[i], responses[i].W);
    return corrected;
  }
} // namespace Contact
