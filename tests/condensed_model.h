/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_model_h
#define contact_condensed_model_h

#include "solvers/condensed/assembled_system.h"
#include "solvers/condensed/slip_direction_stiffness.h"
#include "tests.h"

namespace Tests
{
  /// Two bodies in contact, without multipliers in the linear system. With
  /// @p bounds_follow Newton's method does friction.
  template<int dim>
  struct CondensedModelIn : public BodiesIn<dim>
  {
    using BodiesIn<dim>::discretization;
    using BodiesIn<dim>::elasticity;
    using BodiesIn<dim>::n_dofs;

    explicit CondensedModelIn(const Parameters::All &parameters,
                              const std::string     &solver_name   = "CHOLMOD",
                              const bool             bounds_follow = false)
      : BodiesIn<dim>(parameters)
      , interface(std::make_unique<ContactInterface<dim>>(discretization,
                                                          *elasticity,
                                                          parameters.pairs()))
      , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
      , solution(n_dofs() + interface->n_multipliers())
      , start(solution)
      , rhs(solution)
      , update(n_dofs())
    {
      interface->bounds.follow = bounds_follow;
      make_system(solver_name);
    }

    void make_system(const std::string &solver_name)
    {
      condensed.reset();
      elimination = std::make_unique<ContactElimination<dim>>(discretization,
                                                              interface.get());
      condensed   = std::make_unique<AssembledSystem<dim>>(
        discretization,
        *elasticity,
        interface.get(),
        *elimination,
        Parameters::Choice<Parameters::SolverKind>(solver_name),
        timer);
    }

    /// After the mesh was refined; the displacement comes from before.
    void make_anew(const Parameters::All &parameters,
                   const GhostedVector   &displacement)
    {
      condensed.reset();
      interface.reset();
      elasticity =
        std::make_unique<Elasticity<dim>>(discretization, parameters.solids);
      interface = std::make_unique<ContactInterface<dim>>(discretization,
                                                          *elasticity,
                                                          parameters.pairs());
      solution  = GhostedVector(n_dofs() + interface->n_multipliers());
      start = rhs = solution;
      update      = GhostedVector(n_dofs());
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
          elimination->recover_multipliers(rhs, start, solution);
        }
      const unsigned int n_changes =
        interface->active_set.update(solution, start, after_a_step);
      ContactKernel<dim>(*interface)
        .assemble(solution, start, {false}, rhs, nullptr);
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
      interface->active_set.initialize(solution);
      interface->bounds.update(solution, start);
      for (unsigned int turn = 0; turn < 60; ++turn)
        {
          if (newton(load_factor) == 0)
            return false;
          if (interface->bounds.follow)
            return true;
          if (interface->bounds.update(solution, start) < 1e-12)
            return true;
        }
      return false;
    }

    std::unique_ptr<ContactInterface<dim>>   interface;
    std::unique_ptr<ContactElimination<dim>> elimination;
    std::unique_ptr<AssembledSystem<dim>>    condensed;
    TimerOutput                              timer;
    GhostedVector                            solution, start, rhs, update;
  };

  using CondensedModel = CondensedModelIn<2>;



  /// The norms of the residuals, relative to the forces, after each step to the
  /// load factor 1 from the present solution, until round-off is left; statuses
  /// are those of now or follow the multipliers.
  template<int dim>
  std::vector<double> residuals(CondensedModelIn<dim> &model,
                                const bool             statuses_follow = false)
  {
    model.start = model.solution;
    model.discretization.constrain_update(model.solution, 1);
    std::vector<double> norms;
    for (unsigned int step = 0; step < 10; ++step)
      {
        model.rhs = 0;
        model.elasticity->assemble(model.solution, 1, model.rhs, nullptr);
        if (step > 0)
          {
            model.elimination->recover_multipliers(model.rhs,
                                                   model.start,
                                                   model.solution);
          }
        if (statuses_follow)
          model.interface->active_set.update(model.solution,
                                             model.start,
                                             /*keep=*/step > 0);
        ContactKernel<dim>(*model.interface)
          .assemble(model.solution, model.start, {false}, model.rhs, nullptr);
        const double scale =
          model.elasticity->forces(model.solution, 1).linfty_norm();
        if (step > 0)
          {
            norms.push_back(model.rhs.linfty_norm() / scale);
            if (norms.back() < 1e-12)
              break;
          }
        model.condensed->solve(model.solution,
                               model.start,
                               model.rhs,
                               1e-14 * scale,
                               model.update);
        for (unsigned int i = 0; i < model.n_dofs(); ++i)
          model.solution[i] += model.update[i];
        model.discretization.constrain_update(model.solution, 1);
      }
    return norms;
  }



  /// Whether residuals are squared from step to step, but for a factor, down to
  /// round-off.
  inline bool fall_quadratically(const std::vector<double> &norms)
  {
    const double factor = 10, round_off = 1e-12;
    bool         quadratic = !norms.empty() && norms.back() < round_off;
    for (unsigned int k = 0; k + 1 < norms.size(); ++k)
      quadratic =
        quadratic &&
        norms[k + 1] < std::max(factor * norms[k] * norms[k], round_off);
    return quadratic;
  }



  /**
   * The distance of the matrix of a solved model from difference quotients.
   * Under statuses that stay the eliminated forces are a function F of the free
   * unknowns y alone: F(y) is what condense() makes of the forces of the bodies
   * in u + T y, and of the turning of the slip. The matrix is -dF/dy.
   */
  template<int dim>
  double matrix_error(CondensedModelIn<dim> &model, const double load_factor)
  {
    model.assemble(load_factor, true);
    model.condensed->solve(model.solution,
                           model.start,
                           model.rhs,
                           1e-12,
                           model.update);

    const unsigned int n     = model.n_dofs();
    const auto        &base  = model.discretization.constraints;
    const auto        &lines = model.elimination->constraints();
    Random             random;
    GhostedVector      y(n);
    for (unsigned int i = 0; i < n; ++i)
      if (!base.is_constrained(i) && !lines.is_constrained(i))
        y[i] = random(-1, 1);
    const auto turning =
      SlipDirectionStiffness<dim>::terms(*model.interface,
                                         model.solution,
                                         model.start,
                                         /*any_rank_may_add=*/false);
    const auto forces = [&](const double step) {
      GhostedVector du(y), rest(n), u(model.solution), rhs(u.size());
      du *= step;
      model.elimination->distribute(du);
      model.elimination->distribute(rest);
      du -= rest;
      for (unsigned int i = 0; i < n; ++i)
        u[i] += du[i];
      model.elasticity->assemble(u, load_factor, rhs, nullptr);
      for (const auto &term : turning)
        for (unsigned int i = 0; i < term.dofs.size(); ++i)
          for (unsigned int j = 0; j < term.dofs.size(); ++j)
            rhs[term.dofs[i]] -= term.stiffness(i, j) * du[term.dofs[j]];
      GhostedVector of_bodies(n);
      std::copy_n(rhs.begin(), n, of_bodies.begin());
      model.elimination->condense(of_bodies);
      return of_bodies;
    };
    const double  step = 1e-5;
    GhostedVector by_differences(forces(-step));
    by_differences -= forces(step);
    by_differences *= 1 / (2 * step);

    const auto            &matrix = model.condensed->system_matrix();
    DefiniteSolver::Vector x(matrix.locally_owned_domain_indices(),
                             matrix.get_mpi_communicator());
    DefiniteSolver::Vector by_matrix(x);
    std::copy(y.begin(), y.end(), x.begin());
    matrix.vmult(by_matrix, x);
    double deviation = 0, largest = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (!base.is_constrained(i) && !lines.is_constrained(i))
        {
          deviation =
            std::max(deviation, std::abs(by_matrix(i) - by_differences[i]));
          largest = std::max(largest, std::abs(by_matrix(i)));
        }
    return deviation / largest;
  }



  /// The largest difference of a part of two vectors, by the largest value of
  /// that part of @p b.
  inline double difference(const GhostedVector &a,
                           const GhostedVector &b,
                           const unsigned int   from,
                           const unsigned int   to)
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
