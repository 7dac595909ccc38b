/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/saddle_point/linearized_contact.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>

#include "base/errors.h"

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



  LinearizedContact::LinearizedContact(
    const Discretization<2>    &discretization,
    const ContactInterface<2>  &interface,
    const DirectSolver         &solver,
    const ContactLinearization &linearization)
    : linearization(linearization)
    , discretization(discretization)
    , interface(interface)
    , solver(solver)
  {
  }



  double LinearizedContact::Point::p_after(const Vector<double> &update) const
  {
    return p + dot(rows.unknowns, rows.p_trial, update);
  }



  double LinearizedContact::Point::q_after(const Vector<double> &update) const
  {
    return q + dot(rows.unknowns, rows.q_trial[0], update);
  }



  void LinearizedContact::collect(const GhostedVector &solution,
                                  const GhostedVector &u_start)
  {
    responses.clear();
    decreases.reinit(0, 0);
    excess_tractions.reinit(0);
    points.resize(interface.points().size());
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const ContactPoint<2> &point = interface.points()[q];
        const ContactState<2>  now = interface.state(point, solution, u_start);
        ContactKernel<2>(interface).rows(point,
                                         solution,
                                         u_start,
                                         linearization,
                                         points[q].rows);
        points[q].p           = now.p_trial;
        points[q].q           = now.q_trial[0];
        points[q].status      = point.status;
        points[q].old_p       = traction(q, false);
        points[q].old_q       = traction(q, true);
        points[q].has_changed = false;
      }
  }



  std::vector<signed char> LinearizedContact::signature() const
  {
    std::vector<signed char> signature;
    for (const Point &point : points)
      signature.push_back(point.status.code());
    return signature;
  }



  void LinearizedContact::add_responses()
  {
    const auto is_known = [this](const unsigned int q, const bool tangential) {
      return std::any_of(responses.begin(),
                         responses.end(),
                         [&](const Response &response) {
                           return response.point == q &&
                                  response.tangential == tangential;
                         });
    };

    const auto first = responses.size();
    for (unsigned int q = 0; q < points.size(); ++q)
      for (const bool tangential : {false, true})
        if (points[q].has_changed && !is_known(q, tangential) &&
            !(tangential && interface.contact_pair(interface.points()[q])
                              .law.is_frictionless()))
          responses.push_back({q, tangential, {}});

    // In blocks, which are solved faster than one by one.
    const unsigned int          block_size = 32;
    const Vector<double>        fixed      = inhomogeneity();
    std::vector<Vector<double>> block;
    for (auto begin = first; begin < responses.size(); begin += block.size())
      {
        block.assign(std::min<std::size_t>(block_size,
                                           responses.size() - begin),
                     Vector<double>(fixed.size()));
        for (unsigned int k = 0; k < block.size(); ++k)
          {
            const auto &[q, tangential, W] = responses[begin + k];
            discretization.constraints.distribute_local_to_global(
              load(q, tangential),
              points[q].rows.unknowns,
              block[k]);
          }
        solver.solve_at_border(block);
        for (unsigned int k = 0; k < block.size(); ++k)
          {
            discretization.constraints.distribute(block[k]);
            block[k] -= fixed;
            responses[begin + k].W.swap(block[k]);
          }
      }

    const unsigned int n = responses.size();
    if (n == first)
      return;
    FullMatrix<double> grown(n, n);
    grown.fill(decreases);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto &[q, tangential, W] = responses[i];
        const auto &row                = trial_row(q, tangential);
        for (unsigned int j = i < first ? first : 0; j < n; ++j)
          grown(i, j) = dot(points[q].rows.unknowns, row, responses[j].W);
      }
    decreases = grown;
  }



  Vector<double> LinearizedContact::inhomogeneity() const
  {
    Vector<double> vector(discretization.dof_handler.n_dofs() +
                          interface.n_multipliers());
    discretization.constraints.distribute(vector);
    return vector;
  }



  const Vector<double> &LinearizedContact::load(const unsigned int q,
                                                const bool tangential) const
  {
    return tangential ? points[q].rows.load_q[0] : points[q].rows.load_p;
  }



  const Vector<double> &
  LinearizedContact::trial_row(const unsigned int q,
                               const bool         tangential) const
  {
    return tangential ? points[q].rows.q_trial[0] : points[q].rows.p_trial;
  }



  LinearizedContact::AffineTraction
  LinearizedContact::traction(const unsigned int q, const bool tangential) const
  {
    // A point that opens or closes is linearised from the side of contact.
    const double      p = std::max(points[q].p, 0.);
    const Traction<2> t =
      interface.active_set.traction(interface.points()[q],
                                    points[q].status,
                                    p,
                                    Tensor<1, 1>({points[q].q}));
    if (tangential)
      return {t.q[0] - t.dq_dp[0] * p - t.dq_dq[0][0] * points[q].q,
              t.dq_dp[0],
              t.dq_dq[0][0]};
    return {t.p - t.dp_dp * p, t.dp_dp, 0.};
  }



  LinearizedContact::AffineTraction
  LinearizedContact::excess(const unsigned int q, const bool tangential) const
  {
    const AffineTraction  now = traction(q, tangential);
    const AffineTraction &old = tangential ? points[q].old_q : points[q].old_p;
    return {now.constant - old.constant,
            now.by_p - old.by_p,
            now.by_q - old.by_q};
  }



  Vector<double>
  LinearizedContact::trial_values(const Vector<double> &update) const
  {
    Vector<double> z(responses.size());
    for (unsigned int i = 0; i < z.size(); ++i)
      {
        const Point &point = points[responses[i].point];
        z[i]               = responses[i].tangential ? point.q_after(update)
                                                     : point.p_after(update);
      }
    return z;
  }



  // The tractions t are those of the old statuses, a + D z, and the excess
  // eta, and z = z_0 - G eta: (1 - G D) z = z_0 + G a - G t.
  bool LinearizedContact::find_trial_values(const Vector<double> &update,
                                            FullMatrix<double>   &matrix,
                                            Vector<double> &constant) const
  {
    const unsigned int        n = responses.size();
    const FullMatrix<double> &G = decreases;
    FullMatrix<double>        D(n, n);
    Vector<double>            a(n);
    constant = trial_values(update);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Point          &point = points[responses[i].point];
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



  // With the trial values z of the points that respond, eta = eta_0 + D z:
  //   (I + G D) z = z_0 - G eta_0,  G_qr = d_q . W_r.
  Vector<double> LinearizedContact::solve_changes(const Vector<double> &update)
  {
    const unsigned int n = responses.size();

    const FullMatrix<double> &G = decreases;
    LAPACKFullMatrix<double>  lu(n, n);
    Vector<double>            z = trial_values(update), eta(n), G_eta(n);
    // D couples the two tractions of a point.
    std::vector<std::array<unsigned int, 2>> couplings;
    std::vector<double>                      D;
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int   q        = responses[i].point;
        const AffineTraction traction = excess(q, responses[i].tangential);
        eta[i]                        = traction.constant;
        for (unsigned int j = 0; j < n; ++j)
          if (responses[j].point == q)
            {
              couplings.push_back({{i, j}});
              D.push_back(responses[j].tangential ? traction.by_q
                                                  : traction.by_p);
            }
      }

    for (unsigned int i = 0; i < n; ++i)
      lu(i, i) = 1;
    for (unsigned int k = 0; k < D.size(); ++k)
      if (D[k] != 0)
        for (unsigned int row = 0; row < n; ++row)
          lu(row, couplings[k][1]) += G(row, couplings[k][0]) * D[k];
    G.vmult(G_eta, eta);
    z -= G_eta;
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
    for (unsigned int k = 0; k < D.size(); ++k)
      eta[couplings[k][0]] += D[k] * z[couplings[k][1]];

    Vector<double> corrected = update;
    for (unsigned int i = 0; i < n; ++i)
      corrected.add(-eta[i], responses[i].W);
    excess_tractions = eta;
    return corrected;
  }



  Vector<double>
  LinearizedContact::complete(const Vector<double> &update,
                              const Vector<double> &corrected) const
  {
    if (!solver.leaves_inside() || excess_tractions.size() == 0)
      return corrected;
    const Vector<double> fixed = inhomogeneity();
    Vector<double>       change(fixed.size());
    for (unsigned int i = 0; i < excess_tractions.size(); ++i)
      {
        const auto &[q, tangential, W] = responses[i];
        Vector<double> loads           = load(q, tangential);
        loads *= -excess_tractions[i];
        discretization.constraints
          .distribute_local_to_global(loads, points[q].rows.unknowns, change);
      }
    solver.solve(change);
    discretization.constraints.distribute(change);
    change -= fixed;
    change += update;
    return change;
  }
} // namespace Contact
