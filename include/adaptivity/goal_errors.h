/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_goal_errors_h
#define contact_goal_errors_h

#include <deal.II/base/timer.h>

#include "adaptivity/probe_errors.h"
#include "adaptivity/refined_state.h"
#include "solid/stress_recovery.h"
#include "solvers/newton/linear_system.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The discretization errors of probes by dual weighted residuals (R. Becker
   * and R. Rannacher, Acta Numerica 10, 2001, 1-102; with contact H. Blum and
   * F.-T. Suttmeier, Computing 65, 2000; A. Schroeder and A. Rademacher,
   * Comput. Methods Appl. Mech. Engrg. 200, 2011).
   *
   * In a converged state under its statuses the problem is smooth. The identity
   * that the estimate rests on, and by what its two factors e and z are
   * approximated, is in include/adaptivity/README.md, "Errors of probes".
   *
   * The error that the mesh refined once leaves is taken from the order q of
   * the functional: errors fall by 2^-q from mesh to mesh, and the change is
   * divided by 1 - 2^-q. Where solution and dual solution are smooth q is 2p, p
   * the degree of the elements; of pressures and of stresses on
   * boundaries p; of stresses between nodes 2.
   *
   * Not seen: a contact area that ends elsewhere on a finer mesh, beyond what
   * the transfer of the surfaces extrapolates; the history of friction before
   * this increment; singularities, whose errors fall more slowly.
   */
  class GoalErrors
  {
  public:
    /// The @p state has converged, by the @p system; if that has its tangent,
    /// the dual problems take it.
    GoalErrors(const Parameters::All   &parameters,
               ContactModel<2>         &model,
               const IncrementState<2> &state,
               const LinearSystem<2>   &system,
               TimerOutput             &timer);

    /**
     * Of the mesh: the value on an infinitely fine one, minus that of the
     * probe. Of a loop: the residual that the state has because the loop ended
     * before its limit, weighted with the dual solution.
     */
    ProbeErrors estimate();

    /**
     * By active cell what it contributes to the errors of the probes that an
     * accuracy is asked of, relative to that [-]: the residuals at its nodes
     * times the dual solution, as far as the mesh does not have it. After
     * estimate(). Probes that are accurate enough do not count, unless all are.
     */
    Vector<float> indicators() const;

  private:
    using Definition = Parameters::Probes::Definition;

    /// Minus the residual that is left, one loop after the other.
    using Residuals = std::vector<std::pair<std::string, GhostedVector>>;

    void                       find_doubts(ProbeErrors &errors) const;
    bool                       is_unresolved(const NodeDoFs<2> &node) const;
    void                       add_indicators(const GhostedVector &residual,
                                              const GhostedVector &weight,
                                              const double         scale,
                                              Vector<float>       &indicators) const;
    std::vector<GhostedVector> solve_dual_problems(ProbeErrors &errors) const;
    GhostedVector              negative_residual() const;
    Residuals                  pair_anew() const;
    void                       forget_excess() const;
    void                       impose_contact(const GhostedVector &functional,
                                              GhostedVector       &dual) const;
    double                     order(const Definition &probe) const;
    bool                       is_between_nodes(const Definition &probe) const;
    double                     change_of_probe(const Definition    &probe,
                                               const GhostedVector &functional,
                                               const GhostedVector &relaxed) const;

    const Parameters::All                &parameters;
    ContactModel<2>                      &model;
    const IncrementState<2>              &state;
    const LinearSystem<2>                &system;
    TimerOutput                          &timer;
    const Parameters::Probes::Definitions probes;
    const ContactLinearization            linearization;

    Vector<float> cell_indicators;

    /// The state on the mesh refined once, from estimate() on.
    std::unique_ptr<const RefinedState> refined;
  };
} // namespace Contact

#endif
