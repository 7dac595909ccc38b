/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The problem, its discretization and the methods are in
// include/tutorial/intro.dox, results and possible extensions in results.dox
// beside it; `./run doxygen` makes pages of them and of this file.
//
// In short: a slave and a master surface with gap g, slip s, pressure p and
// shear q. Contact and Coulomb's friction are equations with a kink,
//
//   p = max(0, lambda_n - c g),
//   q = projection of lambda_t - c s onto [-mu p, mu p],
//
// for a semismooth Newton method: every point of contact has a status (open,
// stick or slip), as in the primal-dual active set method of step-41 and
// step-42. Around it are up to five loops, from the outside to the inside:
// levels of the mesh, load increments, stabilization of bodies that nothing
// holds before they touch, pairing of the surfaces, and the bound of friction.
//
// The classes behind this file, from the bottom up: Parameters, Mesh,
// Discretization, Elasticity (the bodies), Surface and ContactPoint (where they
// meet; MortarDiscretization), ContactInterface (the equations of contact),
// LinearSystem (SaddlePointSystem with ActiveSetSearch, or CondensedSystem with
// ContactElimination), NewtonState and Pairing (Newton's method),
// RigidBodyStabilization; then ErrorEstimator, InvariantCheck, and for the
// results Postprocessor and Report.

// @sect3{Include files}
//
// Of deal.II next to nothing: what it is needed for, from meshes to multigrid,
// is behind the classes of this program, whose order is in include/README.md
// under "A map of the code".

#include <algorithm>
#include <limits>
#include <memory>
#include <sstream>

#include "adaptivity/coarser_level.h"
#include "adaptivity/effect_estimates.h"
#include "adaptivity/error_estimator.h"
#include "adaptivity/goal_errors.h"
#include "adaptivity/refinement.h"
#include "base/all_ranks.h"
#include "base/errors.h"
#include "base/interruption.h"
#include "contact/interface/pair_checks.h"
#include "contact/results/contact_crossing.h"
#include "output/accuracy.h"
#include "output/application.h"
#include "output/checkpoint.h"
#include "output/notes.h"
#include "output/postprocessor.h"
#include "output/report.h"
#include "solvers/newton/fixed_point.h"
#include "solvers/newton/linear_system.h"
#include "solvers/newton/load_steps.h"
#include "solvers/newton/newton_state.h"
#include "solvers/newton/pairing.h"
#include "solvers/rigid_pieces/rigid_body_stabilization.h"
#include "verification/invariants.h"

namespace Contact
{
  using namespace dealii;

  // @sect3{The ContactProblem class}
  //
  // One case, from its parameters to its summary. The functions are declared,
  // and defined below, in the order in which one wants to read them: the scene;
  // the loops, from the outside to the inside; Newton's method, in which a
  // contact problem is like any other but for the status of its points; and the
  // next mesh.
  template<int dim>
  class ContactProblem
  {
  public:
    ContactProblem(const Parameters::All  &parameters,
                   const ParameterHandler &prm);

    RunSummary run();

  private:
    // Setting up.
    void setup_system();
    void setup_level();

    // The loops.
    void        solve_level();
    ProbeErrors estimate_errors();
    void        solve_increment(const LoadSteps::Step &step);
    void        start_from_coarser_level(const unsigned int increment);
    bool        try_again(LoadSteps             &steps,
                          const LoadSteps::Step &step,
                          const std::string     &reason);
    void        make_first_contact(LoadSteps &steps);
    void        solve_with_stabilization();
    void        solve_with_geometry_loop();
    void        solve_with_friction_loop();

    // Newton's method.
    void solve_newton();

    // The effects, estimated in the last state.
    void estimate_effects();

    // The next mesh.
    void flag_cells();
    void refine();

    // The invariants.
    void check_invariants(const GhostedVector &springs);

    const Parameters::All parameters;
    Report<dim>           report;

    // The scene on the present mesh, its linear system, and its state.
    ContactModel<dim>                    model;
    IncrementState<dim>                  state;
    Pairing<dim>                         pairing;
    std::unique_ptr<LinearSystem<dim>>   system;
    RigidBodyStabilization<dim>          stabilization;
    std::unique_ptr<InvariantCheck<dim>> invariants;
    NewtonState<dim>                     newton;
    Postprocessor<dim>                   postprocessor;
    Checkpoint<dim>                      checkpoint;

    // Nested iteration: the level, and the one before.
    Levels            levels;
    CoarserLevel<dim> coarser;

    // Of the increments on the present mesh, for the effects.
    StressPeaks<dim> stress_peaks;

    bool is_smallest_step = false; // of the load
  };



  template<int dim>
  ContactProblem<dim>::ContactProblem(const Parameters::All  &parameters,
                                      const ParameterHandler &prm)
    : parameters(parameters)
    , report(this->parameters, prm, MPI_COMM_WORLD)
    , pairing(model, this->parameters, report.timer)
    , stabilization(model, report.log)
    , newton(model, system, state, pairing, report.timer)
    , postprocessor(this->parameters, model, state, report)
    , checkpoint(this->parameters,
                 model,
                 invariants,
                 state,
                 pairing,
                 newton.convergence,
                 report)
    , levels(this->parameters)
  {
  }



  // @sect3{Setting up}

  // @sect4{ContactProblem::run}
  //
  // An error in the input leaves here as an exception; a case that does not
  // converge has a result as well: the summary says so, and nothing that was
  // written looks as if it had converged. Any other error one process may have
  // alone: it ends the others.
  template<int dim>
  RunSummary ContactProblem<dim>::run()
  {
    RunSummary &summary = report.summary;
    try
      {
        setup_system();
        report.print_scene(model, system->name());
        solve_level();
        while (!levels.end_with(summary.levels, summary.accuracy_missed))
          {
            refine();
            solve_level();
          }
        estimate_effects();
        summary.converged = true;
        summary.message.clear();
        report.tell({{summary.accuracy_missed}});
      }
    catch (const NotConverged &failure)
      {
        summary.message = failure.what();
        if (!summary.levels.empty())
          summary.message +=
            "; the mesh before, of " +
            std::to_string(summary.levels.back().n_displacements) +
            " unknowns, has converged: its probes are the last ones of 'levels' "
            "in summary.json";
      }
    catch (const Interrupted &interruption)
      {
        summary.interrupted = true;
        summary.message     = interruption.what();
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::exception &error)
      {
        end_all_ranks(report.communicator, error);
        throw;
      }
    // Also of a scene that cannot be set up.
    if (!report.has_files())
      report.open_files(*model.discretization);
    report.finish();
    return summary;
  }



  // @sect4{ContactProblem::setup_system}
  //
  // All errors of the input are found here, before anything is computed or
  // written: a body that nothing holds would otherwise show as a singular
  // matrix much later.
  template<int dim>
  void ContactProblem<dim>::setup_system()
  {
    {
      TimerOutput::Scope scope(report.timer, "setup");
      model.mesh =
        std::make_unique<Mesh<dim>>(parameters.mesh, report.communicator);
      if (parameters.refines_adaptively(model.mesh->has_only_hypercubes()))
        check_adaptive(*model.mesh);
      if (dim == 2)
        parameters.check_effects_in_plane();
      model.discretization =
        std::make_unique<Discretization<dim>>(*model.mesh,
                                              parameters,
                                              report.communicator);
    }
    setup_level();
    if (model.interface)
      {
        check_pairs(model.interface->pairs, parameters.pairs());
        model.interface->active_set.initialize(state.solution);
      }
    check_supports(*model.discretization, model.interface.get());
    postprocessor.check_probes();
    if (const std::string locking = model.elasticity->locking();
        parameters.asks_for_accuracy() && !locking.empty())
      throw InputError("no accuracy is reached: " + locking,
                       "Probes/Accuracy",
                       "set 'Element/Degree = 2', or mesh with quadrangles");
    report.open_files(*model.discretization);
  }



  // @sect4{ContactProblem::setup_level}
  //
  // The objects that belong to one mesh.
  template<int dim>
  void ContactProblem<dim>::setup_level()
  {
    {
      TimerOutput::Scope scope(report.timer, "setup");
      model.elasticity =
        std::make_unique<Elasticity<dim>>(*model.discretization,
                                          parameters.solids);
      const auto pairs = parameters.pairs();
      if (!pairs.empty())
        {
          model.interface =
            std::make_unique<ContactInterface<dim>>(*model.discretization,
                                                    *model.elasticity,
                                                    pairs);
          model.interface->bounds.follow =
            parameters.solution.friction == Parameters::FrictionLoop::newton;
        }
      state.reinit(model);
      stress_peaks = StressPeaks<dim>();
      invariants = std::make_unique<InvariantCheck<dim>>(*model.discretization,
                                                         *model.elasticity,
                                                         model.interface.get(),
                                                         parameters.solution);
      report.record_size(model);
      system = LinearSystem<dim>::create(model,
                                         parameters,
                                         pairing.linearization(),
                                         report.log,
                                         report.timer);
      pairing.begin_level(*system);
    }
    // In 3-D pairings cost, and without friction nothing asks for one before
    // the start from the coarser level has its own.
    if (dim == 2 || levels.present() == 0 || model.has_friction())
      pairing.pair(state.solution);

    // The levels below the last one need no more than the accuracy of their
    // mesh.
    const double tolerance = parameters.solution.newton_tolerance;
    newton.begin_level(
      levels.may_be_last() || parameters.solution.estimate_effects
        ? tolerance
        : std::max(tolerance, parameters.refinement.tolerance));
  }



  // @sect4{ContactProblem::solve_level}
  //
  // All load increments on one mesh. Coarser meshes only yield the start of the
  // next level: the results of the last mesh are written. What yields does so
  // for good once an increment is accepted, on this mesh.
  template<int dim>
  void ContactProblem<dim>::solve_level()
  {
    CoarserLevel<dim> here;
    LoadSteps         steps(parameters.solution.increments,
                    parameters.solution.max_cuts);
    stabilization.begin_level();
    if (levels.present() > 0 && model.has_friction())
      {
        pairing.pair(state.solution);
        model.interface->active_set.initialize(state.solution);
      }
    if (parameters.restart && levels.may_be_last())
      checkpoint.read(steps);
    while (!steps.finished())
      {
        make_first_contact(steps);
        const LoadSteps::Step step = steps.next();
        try
          {
            solve_increment(step);
          }
        catch (const NotConverged &failure)
          {
            const std::string remark =
              step.from == 0 ? beyond_small_strain(model, state.solution) : "";
            if (try_again(steps, step, failure.what()))
              continue;
            std::ostringstream message;
            message << "no solution at t = " << step.to
                    << ", the last one is at t = " << step.from << ": "
                    << failure.what() << (remark.empty() ? "" : "; ") << remark;
            throw NotConverged(message.str());
          }
        check_rotations(*model.discretization,
                        *model.elasticity,
                        model.interface.get(),
                        state.solution);
        check_invariants(stabilization.release(state));
        model.elasticity->accept(state.solution);
        if (parameters.solution.estimate_effects)
          stress_peaks.take(model, parameters.solids, state.solution);
        steps.accept(report.increment().newton_iterations);
        stabilization.end_increment();

        if (levels.may_be_last() && step.ends_increment)
          {
            postprocessor.write_increment(step.increment, /*is_complete=*/true);
            if (!parameters.asks_for_accuracy())
              checkpoint.write(steps);
          }
        report.print_increment();
        if (levels.may_be_followed() && step.ends_increment)
          here.add(model, state.solution);
      }
    coarser = std::move(here);
    postprocessor.record_level(levels.present(),
                               levels.may_be_last(),
                               system->name(),
                               estimate_errors());
  }



  // @sect4{ContactProblem::estimate_errors}
  //
  // The dual problems, one for each probe, are linear: they are solved under
  // the statuses that the last increment has ended with. A result does not
  // depend on them: without a request that they end none.
  template<int dim>
  ProbeErrors ContactProblem<dim>::estimate_errors()
  {
    ProbeErrors errors;
    errors.not_estimated      = parameters.missing_errors();
    const std::string locking = model.elasticity->locking();

    // So large a system has no factorization that serves, and one more would
    // take longer than the run.
    const bool is_too_large =
      parameters.is_condensed(model.n_displacements()) &&
      !parameters.is_condensed() &&
      parameters.probes.errors == Parameters::Errors::automatic &&
      !parameters.follows_goals();
    if (!locking.empty())
      errors.not_estimated = "No mesh tells: " + locking + '.';
    else if (is_too_large && parameters.solves_dual_problems())
      errors.not_estimated = "The mesh is too large for that to cost little: "
                             "take 'Levels', or 'Errors = dual weighted "
                             "residuals'.";
    else if constexpr (dim == 2)
      if (parameters.solves_dual_problems())
        try
          {
            GoalErrors goal_errors(parameters,
                                   model,
                                   state,
                                   *system,
                                   report.timer);
            errors             = goal_errors.estimate();
            coarser.indicators = goal_errors.indicators();
          }
        catch (const NotConverged &failure)
          {
            if (parameters.follows_goals())
              throw;
            errors               = ProbeErrors();
            errors.not_estimated = failure.what();
          }
    return errors;
  }



  // @sect4{ContactProblem::solve_increment}
  template<int dim>
  void ContactProblem<dim>::solve_increment(const LoadSteps::Step &step)
  {
    is_smallest_step = step.is_smallest;
    model.elasticity->set_thermal_strain(step.from, step.to);
    model.elasticity->begin_first_step();
    if (model.has_friction())
      model.interface->begin_increment(step.from, state.solution);
    if (model.interface &&
        model.interface->motions.move(step.from, step.to, state.solution))
      pairing.pair(state.solution);
    if (model.interface && step.increment == 1)
      model.interface->ramp_initial_penetration(step.from_part,
                                                step.to_part,
                                                state.solution);
    state.begin(model, step.from, step.to);
    pairing.begin_increment(step.to_part - step.from_part);
    postprocessor.clear_stresses();
    report.begin_increment(levels.present(), step.increment, step.to);
    // Behind a cut an increment starts at the end of the last one on this mesh.
    const bool has_coarser_start = levels.present() > 0 && step.is_whole;
    if (has_coarser_start)
      start_from_coarser_level(step.increment);

    // Linear bodies take what is prescribed at once: nothing of it has to go
    // through the matrix, and one factorization serves all increments.
    if (model.elasticity->is_linear())
      model.discretization->prescribe(state.solution, state.load_factor);
    else
      model.discretization->constrain_update(state.solution, state.load_factor);
    if (model.interface) // supports alone do not change
      {
        model.interface->motions.check_rotations();
        stabilization.stabilize_free_pieces(model.interface.get());
        model.interface->active_set.activate_free_obstacles(state.solution);
      }
    stabilization.begin_increment();
    newton.begin_increment(/*starts_elsewhere=*/has_coarser_start);

    solve_with_stabilization();
    if (system->has_multipliers()) // the condensed one looks in each step
      {
        if (system->tangent_is_indefinite(state, levels.may_be_last()))
          throw NotConverged(lost_stability);
        report.tell({{system->open_stability()}});
      }
    if (model.interface)
      {
        model.interface->motions.place(state.solution, /*keeps_place=*/true);
        model.interface->motions.check_rotations();
        check_obstacles(model.interface->pairs, state.start, state.solution);
      }

    // No equation determines the place of a body that has lost its contact: it
    // could have gone anywhere on the way.
    if (model.interface &&
        stabilization.stabilize_free_pieces(model.interface.get()))
      throw NotConverged("a body has lost the contact that held it");
    report.tell({{newton.note_of_leap()}});
    postprocessor.record_increment();
    newton.convergence.accept();
    report.end_increment();
  }



  // @sect4{ContactProblem::start_from_coarser_level}
  //
  // The bodies have given way to thermal strains already.
  template<int dim>
  void
  ContactProblem<dim>::start_from_coarser_level(const unsigned int increment)
  {
    model.elasticity->end_first_step();
    coarser.set_start(model, increment, state.solution);
    pairing.pair_near_contact(state.solution, /*from_coarser_mesh=*/true);
    coarser.set_surfaces(model, increment, state.solution);
  }



  // @sect4{ContactProblem::try_again}
  //
  // An increment that does not converge leaves no trace but its record. The
  // state is that of the increment's start; the pattern of the matrix is made
  // anew. The tangent may have to know how the pairing changes, or a body that
  // contact alone held may have come loose on the way: then it is held, too.
  // Springs may be too soft. Else the load is applied in smaller steps.
  template<int dim>
  bool ContactProblem<dim>::try_again(LoadSteps             &steps,
                                      const LoadSteps::Step &step,
                                      const std::string     &reason)
  {
    report.give_up_increment(reason);
    state.roll_back(model);
    postprocessor.clear_stresses();
    system->clear_pattern();
    model.elasticity->set_thermal_strain(step.from, step.from);
    if (model.interface)
      model.interface->motions.move(step.from, step.from, state.solution);
    pairing.pair(state.solution);

    if (pairing.use_consistent_tangent())
      {
        report.log << "  once more with the pairing in the tangent"
                   << std::endl;
        return true;
      }
    stabilization.stabilize_free_pieces(nullptr);
    if (stabilization.has_grown())
      return true;
    if (stabilization.stiffen())
      {
        report.log << "  once more with stiffer springs" << std::endl;
        return true;
      }
    if (steps.cut())
      {
        report.log << "  cut in half" << std::endl;
        return true;
      }
    state.load_factor = step.from;
    if (levels.may_be_last() && !step.starts_increment)
      postprocessor.write_increment(step.increment, /*is_complete=*/false);
    return false;
  }



  // @sect4{ContactProblem::make_first_contact}
  //
  // Slip counts from the start of an increment. Where bodies come to touch, the
  // way that they move before they do would count as well, and friction would
  // remember it: they first touch in a step as small as may be.
  template<int dim>
  void ContactProblem<dim>::make_first_contact(LoadSteps &steps)
  {
    if (!steps.next().starts_increment || !model.has_friction() ||
        model.interface->active_set.count().active > 0 ||
        rigid_body_modes<dim>(*model.discretization, nullptr).empty())
      return;
    if (steps.begin_small())
      report.log
        << "The bodies do not touch yet: they do first in a step of its own"
        << std::endl;
  }



  // @sect4{ContactProblem::solve_with_stabilization}
  //
  // A body that nothing holds is held by soft springs until contact holds it;
  // see RigidBodyStabilization.
  template<int dim>
  void ContactProblem<dim>::solve_with_stabilization()
  {
    if (!stabilization.is_needed())
      {
        stabilization.release(state);
        solve_with_geometry_loop();
        return;
      }

    stabilization.choose_stiffness();
    const unsigned int max_iterations = 20;
    for (unsigned int iteration = 1;; ++iteration)
      {
        stabilization.attach(state.solution);
        if (model.interface)
          {
            pairing.pair(state.solution);
            model.interface->active_set.activate_nearest(state.solution);
          }
        solve_with_geometry_loop();

        const auto   hold   = stabilization.work(state.solution);
        const double energy = model.elasticity->strain_energy(state.solution);
        report.increment().hold_work = hold.work;
        report.log << "  stabilization, iteration " << iteration
                   << ": its work " << hold.work << " N mm"
                   << model.discretization->per_thickness()
                   << ", strain energy " << energy << " N mm"
                   << model.discretization->per_thickness() << std::endl;
        if (hold.is_little(energy,
                           newton.convergence.force_scale(),
                           newton.convergence.tolerance()))
          return;
        if (iteration == max_iterations)
          stabilization.give_up(hold, iteration);
      }
  }



  // @sect4{ContactProblem::solve_with_geometry_loop}
  //
  // Pair, freeze projections and normals, solve, pair again. The first
  // iteration is never accepted, for it knows the geometry of the increment's
  // start only; unless that is already the solution of a coarser mesh: then the
  // change of the surfaces is asked for, not that under a nodal force, which
  // never ends. The criterion is the one of the reference solution: the largest
  // change of a displacement against the largest displacement of the increment
  // before.
  template<int dim>
  void ContactProblem<dim>::solve_with_geometry_loop()
  {
    if (!pairing.follows() || pairing.follows_each_step())
      {
        solve_with_friction_loop();
        return;
      }

    const auto iterate = [&](const unsigned int n) {
      double last_increment = state.largest_change(model, state.start);
      // Rigid motions to the first touch are no measure.
      if (n > 1 && stabilization.is_needed())
        last_increment =
          std::min(last_increment,
                   2 * model.elasticity->strain_energy(state.solution) /
                     newton.convergence.force_scale());

      report.log << "  geometry, iteration " << n << std::endl;
      ++report.increment().geometry_iterations;
      if (n == 1)
        pairing.pair(state.solution);
      else if (!system->has_multipliers())
        model.interface->active_set.release_parted(state.solution);
      solve_with_friction_loop();

      // The way of the bodies since they were paired.
      const double moved =
        levels.present() > 0
          ? model.interface->largest_change(state.solution,
                                            pairing.configuration())
          : state.largest_change(model, pairing.configuration());
      const double change      = moved == 0 ? 0. : moved / last_increment;
      const bool   is_compared = n > 1 || levels.present() > 0;
      if (is_compared)
        report.log << "    change of the displacement " << change << std::endl;
      return std::make_pair(change,
                            is_compared &&
                              change < parameters.solution.geometry_tolerance);
    };
    fixed_point("geometry loop ends with a change",
                /*max_iterations=*/30,
                iterate,
                [&](Relaxation &relaxation) {
                  pairing.renew(state.solution, relaxation);
                });
  }



  // @sect4{ContactProblem::solve_with_friction_loop}
  //
  // Coulomb's friction as a fixed point over Tresca's: solve with frozen bounds
  // of the shear traction, update the bounds from the pressures, until they
  // stay. A body that friction alone holds would have nothing to hold it where
  // no pressure is known: there it sticks in the first iteration.
  template<int dim>
  void ContactProblem<dim>::solve_with_friction_loop()
  {
    const bool has_friction = model.has_friction();
    if (!has_friction ||
        parameters.solution.friction != Parameters::FrictionLoop::fixed_point ||
        !model.interface->has_coulomb_friction())
      {
        if (has_friction && levels.present() == 0)
          model.interface->bounds.update(state.solution, state.start);
        solve_newton();
        return;
      }

    ContactInterface<dim> &interface = *model.interface;
    if (!rigid_body_modes<dim>(*model.discretization,
                               &interface,
                               Tangents::free)
           .empty())
      interface.bounds.raise_unknown();

    Vector<double> last_bounds;
    const auto     iterate = [&](const unsigned int n) {
      ++report.increment().friction_iterations;
      solve_newton();
      last_bounds = interface.bounds.values();
      const double change =
        interface.bounds.update(state.solution, state.start);
      report.log << "    friction, iteration " << n << ": change of the bound "
                 << change << std::endl;
      return std::make_pair(change,
                            change <= parameters.solution.friction_tolerance);
    };
    const auto renew = [&](Relaxation &relaxation) {
      const double part =
        relaxation.length(GhostedVector(interface.bounds.values()));
      if (part < 1)
        {
          last_bounds.sadd(1 - part, part, interface.bounds.values());
          interface.bounds.set(last_bounds);
        }
    };
    fixed_point("friction loop ends with a change of the bound",
                /*max_iterations=*/300,
                iterate,
                renew);
  }



  // @sect3{Newton's method}

  // @sect4{ContactProblem::solve_newton}
  //
  // Newton's method on displacements, multipliers and the status of the points
  // together. It has converged when the residual, forces and constraints, is
  // small against the forces, under the status that each point has in the
  // present state, and under a pairing of the present state.
  template<int dim>
  void ContactProblem<dim>::solve_newton()
  {
    IncrementRecord   &record = report.increment();
    const unsigned int limit  = parameters.solution.newton_limit(
      /*converges_linearly=*/model.interface && !system->has_multipliers());
    unsigned int max_steps  = limit;
    bool         is_checked = false; // whether the solution is stable
    newton.begin();
    for (unsigned int step = 0;; ++step)
      {
        stop_if_interrupted(report.communicator);
        newton.evaluate();
        report.print_step(model,
                          step,
                          newton.convergence.residual(),
                          newton.n_changes());
        report.record_halvings(newton.shorten_step());
        newton.accept();

        // No stable state has an indefinite tangent: it has to be known at the
        // solution itself, too, not only on the way. Coarser levels are starts:
        // there it is not looked for.
        const bool has_converged = newton.has_converged();
        const bool is_accepted   = has_converged && pairing.accepts(state);
        const bool is_judged =
          is_accepted && levels.may_be_last() && !system->has_multipliers();
        if (is_judged && !newton.has_tangent_of_state())
          {
            system->renew_tangent(state);
            is_checked = true;
          }
        if (is_accepted && !system->tangent_is_indefinite(state, is_judged))
          {
            report.tell({{system->open_stability()}});
            return;
          }
        if (is_accepted && is_checked)
          throw NotConverged(lost_stability);
        is_checked = is_accepted;
        if (step >= max_steps)
          throw NotConverged("Newton's method ends with the residual " +
                             brief(newton.convergence.residual()) + " after " +
                             std::to_string(step) + " steps" +
                             newton.unsettled() + newton.changes() +
                             system->contradiction() + stabilization.remark());
        if (has_converged && !is_accepted)
          {
            report.log << "      paired anew: the surfaces have moved by "
                       << pairing.misplacement(state) << " mm of "
                       << pairing.way(state) << " mm since they were paired"
                       << std::endl;
            newton.pair_anew();
            max_steps = step + limit;
            continue;
          }

        // In bodies that yield, points that change one by one would see another
        // body each time: a shorter increment is the better way, if there is.
        if (newton.start_single_changes())
          {
            if (!model.elasticity->is_elastic() && !is_smallest_step)
              throw NotConverged("the active set cycles:" + newton.changes());
            ++record.cycles;
            report.log << "      the active set cycles, now one point at a "
                          "time changes:"
                       << newton.changes() << std::endl;
            if (!system->has_multipliers())
              max_steps = limit + model.interface->points().size();
          }
        record.linear_iterations += newton.make_step();
        ++record.newton_iterations;
        // Steps under statuses that do not settle throw a body about.
        if (!system->statuses_settle() && stabilization.may_help())
          throw NotConverged("contact alone holds a body, and the statuses of "
                             "its points do not settle");
      }
  }



  // @sect3{The effects}

  // @sect4{ContactProblem::estimate_effects}
  //
  // How much the probes change by an effect that the scene has, or leaves out,
  // follows from the residual of the other scene in this one's state. In 3-D
  // runs on coarser meshes tell it, see estimate_effects_by_runs().
  template<int dim>
  void ContactProblem<dim>::estimate_effects()
  {
    if constexpr (dim == 2)
      {
        if (!parameters.solution.estimate_effects)
          return;
        report.record(strain_range(*model.discretization, state.solution));
        EffectEstimates effects(parameters,
                                model,
                                state,
                                stress_peaks,
                                report.timer);
        try
          {
            const auto estimates = effects.estimate();
            report.record(estimates, effects.remainders());
          }
        catch (const NotConverged &failure)
          {
            report.tell({{std::string("effects cannot be estimated: ") +
                          failure.what()}});
          }
      }
  }



  // @sect3{The next mesh}

  // @sect4{ContactProblem::flag_cells}
  //
  // All of them, or those with the largest indicators: of the errors of probes
  // or of the error in the norm of the energy; and surfaces that might touch.
  template<int dim>
  void ContactProblem<dim>::flag_cells()
  {
    if (!parameters.refines_adaptively(model.mesh->has_only_hypercubes()))
      {
        flag_all_cells(*model.mesh);
        return;
      }
    if (parameters.follows_goals())
      flag_by_indicators(model, parameters, coarser.indicators);
    else
      {
        TimerOutput::Scope scope(report.timer, "estimate");
        flag_by_estimate(model,
                         parameters,
                         postprocessor.recovered_stresses(),
                         state.solution);
      }
    flag_close_surfaces(model, parameters, state.solution);
  }



  // @sect4{ContactProblem::refine}
  //
  // The old matrices go first: two meshes at a time would take their memory.
  template<int dim>
  void ContactProblem<dim>::refine()
  {
    flag_cells();
    {
      TimerOutput::Scope scope(report.timer, "setup");
      system.reset();
      invariants.reset();
      model.interface.reset();
      model.elasticity.reset();
      refine_and_transfer(*model.mesh,
                          *model.discretization,
                          coarser.solutions);
    }
    levels.advance();
    if (parameters.asks_for_accuracy())
      report.replace_results(*model.discretization);
    setup_level();
    report.print_level(model, levels.present(), system->name());
  }



  // @sect3{The invariants}

  // @sect4{ContactProblem::check_invariants}
  //
  // Conditions on every solution, by a computation of their own. A result that
  // violates one is wrong, whatever Newton's method says.
  template<int dim>
  void ContactProblem<dim>::check_invariants(const GhostedVector &springs)
  {
    TimerOutput::Scope scope(report.timer, "invariants");
    Invariants         found =
      invariants->check(state.solution,
                        state.load_factor,
                        newton.convergence.tolerance(),
                        newton.convergence.force_scale(),
                        springs.size() > 0 ? &springs : nullptr,
                        pairing.shift_of_projections(state),
                        newton.convergence.given_force(state.load_factor));
    invariants->advance();
    report.increment().round_off_force =
      1e3 * std::numeric_limits<double>::epsilon() *
      newton.convergence.force_scale();
    found.findings.push_back({pairing.note(found.moment_imbalance)});
    report.record(found);
  }
} // namespace Contact



// @sect3{The main function}
//
// Whether a scene is one in 2-D or in 3-D, its mesh tells.
int main(int argc, char **argv)
{
  using namespace Contact;
  return run_application(
    argc,
    argv,
    [](const Parameters::All &parameters, const ParameterHandler &prm) {
      try
        {
          return ContactProblem<2>(parameters, prm).run();
        }
      catch (const MeshOfVolumes &mesh)
        {
          return ContactProblem<3>(parameters.for_space(mesh.has_tetrahedra),
                                   prm)
            .run();
        }
    });
}
