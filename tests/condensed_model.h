/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_model_h
#define contact_condensed_model_h

#include "solvers/condensed_system.h"
#include "tests.h"

namespace Tests
{
  /// Two bodies in contact, without multipliers in the linear system. With
  /// @p moving_bound Newton's method does friction.
  struct CondensedModel : public Bodies
  {
    explicit CondensedModel(const Parameters::All &parameters,
                            const std::string     &solver_name  = "CHOLMOD",
                            const bool             moving_bound = false)
      : Bodies(parameters)
      , moving_bound(moving_bound)
      , interface(std::make_unique<ContactInterface<2>>(discretization,
                                                        *elasticity,
                                                        parameters.pairs()))
      , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
      , solution(n_dofs() + interface->n_multipliers())
      , start(solution)
      , rhs(solution)
      , update(n_dofs())
    {
      make_system(solver_name);
    }

    void make_system(const std::string &solver_name)
    {
      condensed.reset();
      elimination = std::make_unique<ContactElimination<2>>(discretization,
                                                            interface.get(),
                                                            moving_bound);
      condensed   = std::make_unique<CondensedSystem<2>>(
        discretization,
        *elasticity,
        interface.get(),
        *elimination,
        Parameters::Choice<Parameters::SolverKind>(solver_name),
        timer);
    }

    /// After the mesh was refined; the displacement comes from before.
    void make_anew(const Parameters::All &parameters,
                   const Vector<double>  &displacement)
    {
      condensed.reset();
      interface.reset();
      elasticity = Elasticity<2>::create(discretization, parameters.solids);
      interface  = std::make_unique<ContactInterface<2>>(discretization,
                                                        *elasticity,
                                                        parameters.pairs());
      solution.reinit(n_dofs() + interface->n_multipliers());
      start.reinit(solution.size());
      rhs.reinit(solution.size());
      update.reinit(n_dofs());
      std::copy(displacement.begin(), displacement.end(), solution.begin());
      make_system("CHOLMOD");
    }

    void pair()
    {
      interface->pair(solution);
      condensed->update_pattern();
    }

    /// Minus the residual under the statuses of now, after a step under those
    /// that the multipliers ask for. Returns how many points change their
    /// status.
    unsigned int assemble(const double load_factor, const bool after_a_step)
    {
      rhs = 0;
      elasticity->assemble(solution, load_factor, rhs, nullptr);
      if (after_a_step)
        {
          elimination->recover_pressures(rhs, solution);
          elimination->recover_shears(rhs, solution);
        }
      const unsigned int n_changes =
        interface->update_statuses(solution, start, moving_bound, after_a_step);
      ContactKernel<2>(*interface)
        .assemble(solution, start, {false, moving_bound}, rhs, nullptr);
      return n_changes;
    }

    /// Newton's method under the pairing and the bounds of now. Returns the
    /// number of iterations, or 0 if there is no convergence.
    unsigned int newton(const double load_factor)
    {
      for (unsigned int iteration = 0; iteration < 60; ++iteration)
        {
          const unsigned int n_changes = assemble(load_factor, iteration > 0);
          const double       scale =
            elasticity->forces(solution, load_factor).linfty_norm();
          if (iteration > 0 && n_changes == 0 &&
              rhs.linfty_norm() < 1e-12 * scale)
            return iteration;
          condensed->solve(solution, start, rhs, 1e-13 * scale, update);
          for (unsigned int i = 0; i < n_dofs(); ++i)
            solution[i] += update[i];
          discretization.constrain_update(solution, load_factor);
        }
      return 0;
    }

    /// One increment with the pairing of its start, and the bound of Coulomb's
    /// friction in a loop. Returns whether it converges.
    bool solve(const double load_factor)
    {
      start = solution;
      discretization.constrain_update(solution, load_factor);
      pair();
      interface->initialize_status(solution);
      interface->update_bounds(solution, start);
      for (unsigned int turn = 0; turn < 60; ++turn)
        {
          if (newton(load_factor) == 0)
            return false;
          if (moving_bound)
            return true;
          if (interface->update_bounds(solution, start) < 1e-12)
            return true;
        }
      return false;
    }

    const bool                             moving_bound;
    std::unique_ptr<ContactInterface<2>>   interface;
    std::unique_ptr<ContactElimination<2>> elimination;
    std::unique_ptr<CondensedSystem<2>>    condensed;
    TimerOutput                            timer;
    Vector<double>                         solution, start, rhs, update;
  };



  /// The largest difference of a part of two vectors, by the largest value of
  /// that part of @p b.
  inline double difference(const Vector<double> &a,
                           const Vector<double> &b,
                           const unsigned int    from,
                           const unsigned int    to)
  {
    double difference = 0, largest = 0;
    for (unsigned int i = from; i < to; ++i)
      {
        difference = std::max(difference, std::abs(a[i] - b[i]));
        largest    = std::max(largest, std::abs(b[i]));
      }
    return difference / largest;
  }
} // namespace Tests

#endif
