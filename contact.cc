/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// @sect3{Introduction}
//
// Two deformable bodies touch, with Coulomb friction between them. We look for
// the displacement u of both, the contact pressure p and the shear traction q
// on the surface where they meet, such that for all virtual displacements
//
//   integral S(u) : delta E(u) dX - sum over the points of contact
//     w (p n + q t) . (delta u_slave - delta u_master) = dead loads . delta u,
//
//   g >= 0,  p >= 0,  p g = 0              (the bodies do not penetrate),
//   |q| <= mu p,  and slip only where |q| = mu p, against q   (friction).
//
// The conditions in the last two lines are inequalities, yet not hard to solve
// once they are written as equations: with any c > 0,
//
//   p = max(0, lambda_n - c g),
//   q = projection of lambda_t - c s onto [-mu p, mu p],
//
// lambda_n = p and lambda_t = q being the Lagrange multipliers of the gap g and
// of the slip s. Their semismooth Newton method is the primal-dual active set
// method of step-41 and step-42: every point of contact makes a decision (open,
// stick or slip) from the signs of these expressions, a linear system is
// solved under all decisions, and when no point changes its mind we are done.
// Here the search for the decisions happens inside the linear problem of one
// Newton step, see ActiveSetSearch, so that few steps are needed.
//
// Around Newton's method there are up to five loops, and each is there only if
// the scene asks for it:
//
//   levels                 nested iteration: the solution on one mesh is the
//                          start on the next finer one;
//     load increments      because friction depends on the history; cut in
//                          half and tried again if they do not converge;
//       soft hold          of a body that nothing holds before it touches;
//       geometry loop      which master edge faces which slave point, and with
//                          what normal; absent if Newton's method does it;
//         friction loop    the bound mu p is frozen: a problem of Tresca's
//                          friction; absent without Coulomb friction, or if
//                          Newton's method does it;
//           Newton's method.
//
// The linear system of a Newton step comes in two forms. With the multipliers
// it is a saddle point, solved by a sparse direct solver on one process: every
// contact rule can have it. Where the points of contact belong to one slave
// node each (nodal and mortar rule), the active ones can be eliminated instead,
// in the manner of step-42: CondensedSystem, symmetric and positive definite
// (but for friction by Newton's method), for conjugate gradients with algebraic
// multigrid, many unknowns and several processes. There the active set of
// step-41 and step-42 is searched from step to step, which is cheap because a
// level starts where the one before ended.
//
// With several processes each has a part of the mesh and of the matrix. The
// vectors of the solution and the surfaces are small beside these, and every
// process has them in full: what the points of contact decide is computed by
// all alike.
//
// The classes behind this file, from the bottom up: Parameters, Mesh,
// Discretization, Elasticity (the bodies), Surface and ContactPoint (where they
// meet; MortarRule), ContactInterface (the equations of contact),
// SaddlePointSystem with ActiveSetSearch, or CondensedSystem with
// ContactElimination; then ErrorEstimator, InvariantCheck, and for the results
// StressRecovery, ResultFiles, RunSummary.
//
// References: P. Alart and A. Curnier, Comput. Methods Appl. Mech. Engrg. 92
// (1991) 353-375; M. Hintermueller, K. Ito and K. Kunisch, SIAM J. Optim. 13
// (2003) 865-888; S. Hueeber and B. Wohlmuth, Comput. Methods Appl. Mech.
// Engrg. 194 (2005) 3147-3166; A. Popp, M. W. Gee and W. A. Wall, Int. J.
// Numer. Meth. Engng. 79 (2009) 1354-1391; the benchmark: A. W. A. Konter,
// Advanced Finite Element Contact Benchmarks, NAFEMS 2006, and SSNP154 of
// Code_Aster's validation manual.

// @sect3{Include files}
//
// Of deal.II next to nothing: what it is needed for, from meshes to multigrid,
// is behind the classes of this program, whose order is in include/README.md
// under "A map of the code".

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "adaptivity/error_estimator.h"
#include "adaptivity/refinement.h"
#include "base/command_line.h"
#include "base/counters.h"
#include "base/errors.h"
#include "base/files.h"
#include "base/interruption.h"
#include "base/restart_file.h"
#include "contact/contact_interface.h"
#include "contact/contact_results.h"
#include "output/ledger.h"
#include "output/probes.h"
#include "output/result_files.h"
#include "output/result_tables.h"
#include "output/summary.h"
#include "parameters/parameters.h"
#include "solid/discretization.h"
#include "solid/elasticity.h"
#include "solid/stress_recovery.h"
#include "solvers/aitken.h"
#include "solvers/condensed_system.h"
#include "solvers/force_scale.h"
#include "solvers/free_motions.h"
#include "solvers/load_steps.h"
#include "solvers/newton_guard.h"
#include "solvers/pairing_guard.h"
#include "solvers/relaxation.h"
#include "solvers/rigid_rotation.h"
#include "solvers/saddle_point_system.h"
#include "verification/exact_solution.h"
#include "verification/invariants.h"

namespace Contact
{
  using namespace dealii;

  // @sect3{The ContactProblem class}
  //
  // One case, from its parameters to its summary. The functions are declared,
  // and defined below, in the order in which one wants to read them: what a
  // case is made of; the loops; Newton's method, in which a contact problem is
  // like any other but for its decisions; and what comes before and after.
  class ContactProblem
  {
  public:
    ContactProblem(const Parameters::All  &parameters,
                   const ParameterHandler &prm,
                   const bool              verbose);

    RunSummary run();

  private:
    // Setting up.
    void setup_system();
    void make_interface();
    void make_linear_system();
    void print_scene();
    void print_note_on_arcs(const Parameters::Contact &zone);

    // The loops, from the outside to the inside.
    void solve_level();
    void solve_increment(const LoadSteps::Step &step);
    void give_up_increment(const std::string &reason);
    void approach(LoadSteps &steps);
    bool hold_what_is_free(const ContactInterface *contact);
    void solve_with_soft_hold();
    void solve_with_geometry_loop();
    void solve_with_friction_loop();

    // Newton's method.
    void solve_newton();

    /// Where a Newton step has led to.
    struct Outcome
    {
      double       force     = 0; // norm of the residual [N per mm]
      double       residual  = 0; // the same by the force scale [-]
      unsigned int n_changes = 0; // points that changed their status
      VolumeRatio  volume;        // the smallest
    };

    Outcome evaluate(const bool after_a_step, const bool one_at_a_time);
    bool    points_follow_the_law() const;
    void    freeze_pairing(const bool frozen);
    Outcome shorten_step(const Outcome               &outcome,
                         const NewtonGuard           &guard,
                         const Vector<double>        &last,
                         const std::vector<Decision> &decisions);

    void        pair_bodies();
    void        pair_bodies(const Vector<double> &configuration);
    void        pair_bodies_ahead(const bool after_a_step);
    void        renew_pairing(Relaxation &relaxation);
    double      misfit_of_new_pairing();
    VolumeRatio assemble_forces_of_bodies();
    void        recover_multipliers();
    double      assemble_forces_of_contact();
    double      residual_norm() const;
    double      newton_tolerance() const;
    bool        update_solution(const double residual,
                                const double last_residual,
                                const bool   search);
    void        update_solution_condensed(const unsigned int step,
                                          const double       residual);
    void        print_step(const unsigned int step,
                           const double       residual,
                           const unsigned int n_changes);

    // From one mesh to the next.
    void refine();

    // What has to hold, and what comes out.
    void check_invariants();
    void record_level();
    void output_increment(const unsigned int k, const bool is_complete);
    const std::vector<SymmetricTensor<2, 3>> &recovered_stresses();
    void                                      compare_with_theory();
    ContactResults results(const ContactZone &zone) const;
    double         probe(const std::vector<std::string> &definition);
    void           report_probes();
    void           finish();

    // Going on where a run has ended.
    void        write_restart_file(LoadSteps &steps);
    void        read_restart_file(LoadSteps &steps);
    std::string restart_key() const;

    /// All that an increment leaves to the next one.
    template<class Archive>
    void serialize(Archive &archive, LoadSteps &steps);

    // What is asked in several places.
    bool        is_last_level() const;
    bool        has_friction() const;
    bool        pairs_each_step() const;
    bool        geometry_follows() const;
    double      largest_change(const Vector<double> &from) const;
    std::string changes_since(const std::vector<Decision> &decisions) const;
    std::string what_is_open(const Outcome &now, const bool pairing) const;

    const MPI_Comm          communicator = MPI_COMM_WORLD;
    const Parameters::All   parameters;
    const ParameterHandler &prm;
    ConditionalOStream      screen;
    TimerOutput             timer;
    RunSummary              summary;

    // The scene.
    std::unique_ptr<Mesh>             mesh;
    std::unique_ptr<Discretization>   discretization;
    std::unique_ptr<Elasticity>       elasticity;
    std::unique_ptr<ContactInterface> interface; // none without contact
    std::unique_ptr<InvariantCheck>   invariants;
    std::unique_ptr<StressRecovery>   stress_recovery; // as it is asked for
    std::unique_ptr<ResultFiles>      files;

    // The linear system, with the multipliers or without: one of the two. The
    // unknowns are the displacements, then the multipliers; every rank has all
    // of them.
    std::unique_ptr<SaddlePointSystem>  saddle_point;
    std::unique_ptr<ContactElimination> elimination;
    std::unique_ptr<CondensedSystem>    condensed;
    Vector<double>                      system_rhs;
    Vector<double>                      update; // of the displacements
    std::string                         system_name;

    // The state now, and at the start of the increment.
    Vector<double>            solution;
    Vector<double>            start;
    std::vector<ContactPoint> points_at_start;

    // The displacements under which the points were paired, and whether these
    // pairs stay, see PairingGuard.
    Vector<double> paired_at;
    bool           pairing_is_frozen = false;
    bool           pairing_jumps = false; // between two states, both accepted
    AitkenExtrapolation extrapolation;

    // What nothing holds by itself in this increment.
    std::vector<FreeMotion> softly_held;
    std::size_t             n_held_at_start = 0;

    // What turns in itself, on this mesh.
    std::vector<TurningPiece> turning;

    // Nested iteration: the level, and on the level before the solutions and
    // the states of the surface after each increment.
    unsigned int                                             level = 0;
    std::vector<Vector<double>>                              level_solutions;
    std::vector<std::vector<ContactInterface::SurfaceState>> level_states;

    double load_factor = 0;

    // What residuals are compared with, in the present state.
    std::unique_ptr<ForceScale> force_scale;
    double                      reference_force = 0;

    // At the vertices, if somebody has asked for them since the last increment.
    std::vector<SymmetricTensor<2, 3>> stresses;
    std::optional<ExactSolution>       exact;

    ContactInterface::Linearization linearization{};
  };



  // @sect3{Setting up}
  //
  // What a case is made of.

  ContactProblem::ContactProblem(const Parameters::All  &parameters,
                                 const ParameterHandler &prm,
                                 const bool              verbose)
    : parameters(parameters)
    , prm(prm)
    , screen(std::cout,
             verbose && parameters.output.screen == Parameters::Screen::full &&
               Utilities::MPI::this_mpi_process(communicator) == 0)
    , timer(std::cout, TimerOutput::never, TimerOutput::cpu_and_wall_times)
  {
    counters()        = Counters();
    summary.case_name = parameters.name;
    summary.mesh_file =
      std::filesystem::path(parameters.mesh.file).filename().string();
  }



  // @sect4{ContactProblem::run}
  //
  // What goes wrong with the input leaves here as an exception; what does not
  // converge is a result as well: the summary says so, and nothing that was
  // written looks as if it had converged.
  RunSummary ContactProblem::run()
  {
    setup_system();
    print_scene();

    try
      {
        solve_level();
        while (!is_last_level())
          {
            refine();
            solve_level();
          }
        summary.converged = true;
        summary.message.clear();
      }
    catch (const NotConverged &failure)
      {
        summary.message = failure.what();
      }
    catch (const Interrupted &interruption)
      {
        summary.interrupted = true;
        summary.message     = interruption.what();
      }
    if (!summary.converged)
      screen << summary.message << std::endl;
    finish();
    return summary;
  }



  // @sect4{ContactProblem::setup_system}
  //
  // Everything that can be wrong with the input shows here, before anything is
  // computed or written.
  void ContactProblem::setup_system()
  {
    timer.enter_subsection("setup");
    mesh = std::make_unique<Mesh>(parameters.mesh, communicator);
    if (parameters.refinement.strategy == Parameters::Strategy::adaptive)
      check_adaptive(*mesh);
    discretization =
      std::make_unique<Discretization>(*mesh, parameters, communicator);

    linearization.moving_bound =
      parameters.solution.friction == Parameters::FrictionLoop::newton;
    make_interface();
    timer.leave_subsection();

    // A body that nothing holds would show as a singular matrix much later.
    make_linear_system();
    pair_bodies();
    force_scale = std::make_unique<ForceScale>(*discretization,
                                               *elasticity,
                                               interface.get());
    if (interface)
      interface->initialize_status(solution);
    check_supports(*discretization, interface.get());
    for (const auto &[name, probe] : parameters.probes.probes)
      for (unsigned int i = 1; i < probe.size(); ++i)
        {
          mesh->point(probe[i], "Probes/Probes");
          if (is_contact_traction(probe[0]))
            check_contact_traction(name,
                                   probe[0],
                                   probe[i],
                                   interface.get(),
                                   *discretization);
        }

    // From here on the results of an earlier run are replaced; until this one
    // ends, its summary says that it has not converged.
    files =
      std::make_unique<ResultFiles>(parameters.directory(), *discretization);
    if (!parameters.restart)
      files->remove_increments();
    summary.message = "the run has not ended";
    files->write_first("summary.json", [this](std::ostream &out) {
      write_summary(summary, out);
    });
  }



  // @sect4{ContactProblem::make_interface}
  //
  // What is made anew on every mesh.
  void ContactProblem::make_interface()
  {
    elasticity = Elasticity::create(*discretization, parameters.solids);
    if (const auto zones = parameters.zones(); !zones.empty())
      interface =
        std::make_unique<ContactInterface>(*discretization, *elasticity, zones);

    summary.n_displacements = discretization->dof_handler.n_dofs();
    summary.n_multipliers   = interface ? interface->n_multipliers() : 0;
    const auto n_unknowns   = summary.n_displacements + summary.n_multipliers;
    solution.reinit(n_unknowns);
    start.reinit(n_unknowns);
    system_rhs.reinit(n_unknowns);
    update.reinit(summary.n_displacements);
    invariants = std::make_unique<InvariantCheck>(*discretization,
                                                  *elasticity,
                                                  interface.get(),
                                                  parameters.solution);
  }



  void ContactProblem::make_linear_system()
  {
    TimerOutput::Scope scope(timer, "setup");
    freeze_pairing(false);
    if (!parameters.is_condensed(summary.n_displacements))
      {
        saddle_point = std::make_unique<SaddlePointSystem>(*discretization,
                                                           *elasticity,
                                                           interface.get(),
                                                           linearization,
                                                           geometry_follows(),
                                                           timer);
        system_name  = "saddle point, UMFPACK";
        return;
      }
    Parameters::Choice<Parameters::SolverKind> solver =
      parameters.solution.linear_solver;
    if (solver == Parameters::SolverKind::automatic)
      solver =
        DefiniteSolver::choose(summary.n_displacements,
                               Utilities::MPI::n_mpi_processes(communicator));
    elimination =
      std::make_unique<ContactElimination>(*discretization,
                                           interface.get(),
                                           linearization.moving_bound);
    condensed   = std::make_unique<CondensedSystem>(*discretization,
                                                  *elasticity,
                                                  interface.get(),
                                                  *elimination,
                                                  solver,
                                                  timer);
    system_name = "condensed, " + solver.name();
  }



  void ContactProblem::print_scene()
  {
    const std::vector<Effect> effects =
      find_effects(parameters, *discretization, interface.get(), system_name);
    for (const Effect &effect : effects)
      summary.effects[effect.name] = effect.choice;

    screen << "Case " << parameters.name << ": "
           << mesh->triangulation.n_global_active_cells() << " cells of "
           << summary.mesh_file << ", " << summary.n_displacements
           << " displacements, " << summary.n_multipliers << " multipliers"
           << std::endl;
    if (screen.is_active())
      print_effects(screen.get_stream(), effects);
    if (interface)
      for (const auto &zone : parameters.zones())
        print_note_on_arcs(zone);
  }



  // @sect4{ContactProblem::print_note_on_arcs}
  //
  // Who draws a circle may not know that a mesh has but a polygon of it.
  void ContactProblem::print_note_on_arcs(const Parameters::Contact &zone)
  {
    if (parameters.element.degree == 1 && parameters.mesh.refinements == 0 &&
        parameters.refinement.n_levels == 0)
      return;
    for (const std::string &name : {zone.slave, zone.master})
      {
        if (name.empty() || parameters.mesh.arcs.count(name) > 0)
          continue;
        const double bend =
          Surface(*discretization, mesh->boundary(name, zone.section()), name)
            .largest_bend();
        if (bend > 0.1)
          screen
            << "Note: '" << name << "' bends by up to " << bend
            << " degrees at a node and is no arc: at degree 2 and on finer "
               "meshes it keeps its corners. For a circle: Mesh/Arcs = "
            << name << ": x, y, radius" << std::endl;
      }
  }



  // @sect3{The loops}
  //
  // From the outside to the inside: levels of refinement, load increments, the
  // soft hold, the geometry, friction.

  // @sect4{ContactProblem::solve_level}
  //
  // All load increments on one mesh. The results of all but the last mesh are
  // but the start of the next level. An increment that does not converge leaves
  // no trace but its record: the state is that of its start again.
  void ContactProblem::solve_level()
  {
    std::vector<Vector<double>>                              solutions;
    std::vector<std::vector<ContactInterface::SurfaceState>> states;
    LoadSteps steps(parameters.solution.n_increments,
                    parameters.solution.max_cuts);
    softly_held.clear();
    if (interface)
      turning = turning_pieces(*discretization, *elasticity, *interface);
    if (level > 0 && has_friction())
      {
        pair_bodies();
        interface->initialize_status(solution);
      }
    if (parameters.restart && is_last_level())
      read_restart_file(steps);
    while (!steps.finished())
      {
        approach(steps);
        const LoadSteps::Step step = steps.next();
        try
          {
            solve_increment(step);
          }
        catch (const NotConverged &failure)
          {
            give_up_increment(failure.what());
            // What only contact held may have come loose on the way.
            hold_what_is_free(nullptr);
            if (softly_held.size() > n_held_at_start)
              continue;
            if (steps.cut())
              {
                screen << "  cut in half" << std::endl;
                continue;
              }
            std::ostringstream message;
            message << "no solution at the load factor " << step.to
                    << ", the last one is at " << step.from << ": "
                    << failure.what();
            load_factor = step.from;
            if (is_last_level() && !step.starts_increment)
              output_increment(step.increment, /*is_complete=*/false);
            throw NotConverged(message.str());
          }
        check_rotations(*discretization, *elasticity, solution);
        check_invariants();
        steps.accept(summary.increments.back().newton_iterations);
        softly_held.clear();

        if (is_last_level() && step.ends_increment)
          {
            output_increment(step.increment, /*is_complete=*/true);
            write_restart_file(steps);
          }
        else if (step.ends_increment)
          {
            solutions.push_back(solution);
            if (interface)
              states.push_back(interface->save(solution));
          }
      }
    level_solutions = std::move(solutions);
    level_states    = std::move(states);
    record_level();
  }



  // @sect4{ContactProblem::solve_increment}
  void ContactProblem::solve_increment(const LoadSteps::Step &step)
  {
    load_factor = step.to;
    start       = solution;
    if (interface)
      points_at_start = interface->points;
    stresses.clear();
    summary.increments.emplace_back();
    IncrementRecord &record = summary.increments.back();
    record.level            = level;
    record.load_factor      = load_factor;
    screen << "Increment " << step.increment << " of "
           << parameters.solution.n_increments << ", load factor "
           << load_factor << std::endl;

    if (level > 0 && step.is_whole)
      {
        // From the same increment of the level before.
        std::copy(level_solutions[step.increment - 1].begin(),
                  level_solutions[step.increment - 1].end(),
                  solution.begin());
        pair_bodies();
        if (interface)
          interface->restore(level_states[step.increment - 1], solution);
      }
    // Linear bodies take what is prescribed at once: nothing of it has to go
    // through the matrix, and one factorization serves all increments.
    if (elasticity->is_linear())
      discretization->prescribe(solution, load_factor);
    else
      discretization->constrain_update(solution, load_factor);
    if (interface) // supports alone do not change
      hold_what_is_free(interface.get());
    n_held_at_start = softly_held.size();

    solve_with_soft_hold();

    // Where a body is that has lost its contact, no equation says: it could
    // have gone anywhere on the way.
    if (interface && hold_what_is_free(interface.get()))
      throw NotConverged("a body has lost the contact that held it");

    if (interface)
      {
        const StatusCount count = interface->count();
        record.active           = count.active;
        record.stick            = count.stick;
        record.slip             = count.active - count.stick;
        for (const auto &zone : interface->zones)
          record.contact[zone->name] = results(*zone).by_name();
      }
    for (const auto &[name, definition] : parameters.probes.probes)
      if (!is_stress(definition[0]))
        record.probes[name] = probe(definition);
    record.converged = true;
    force_scale->accept(reference_force);
    screen << "  converged: " << record.newton_iterations << " Newton steps, "
           << record.friction_iterations << " friction turns, "
           << record.geometry_iterations << " geometry turns" << std::endl;
  }



  // @sect4{ContactProblem::give_up_increment}
  //
  // The state is that of the increment's start, also what the points know and
  // which edges they face. The pattern of the matrix is not: it is made anew.
  void ContactProblem::give_up_increment(const std::string &reason)
  {
    summary.increments.back().message = reason;
    screen << "  " << reason << std::endl;
    solution = start;
    if (interface)
      interface->points = points_at_start;
    stresses.clear();
    if (saddle_point)
      saddle_point->forget_pattern();
    pair_bodies();
  }



  // @sect4{ContactProblem::approach}
  //
  // Slip counts from the start of an increment. Where bodies come to touch,
  // what they move before they do would count as well, and friction would
  // remember it: they first touch in a step as small as may be.
  void ContactProblem::approach(LoadSteps &steps)
  {
    if (!steps.next().starts_increment || !has_friction() ||
        interface->count().active > 0 ||
        free_motions(*discretization, nullptr).empty())
      return;
    bool is_cut = false;
    while (steps.cut())
      is_cut = true;
    if (is_cut)
      screen
        << "The bodies do not touch yet: they do first in a step of its own"
        << std::endl;
  }



  // @sect4{ContactProblem::hold_what_is_free}
  //
  // A piece of a body that neither supports nor its points in @p contact hold
  // could move without resistance: it is held softly. Returns whether that is
  // news.
  bool ContactProblem::hold_what_is_free(const ContactInterface *contact)
  {
    auto free = free_motions(*discretization, contact);
    for (const TurningPiece &piece : turning)
      free.push_back({piece.piece, "rotation", 1});
    bool news = false;
    for (const FreeMotion &motion : free)
      if (std::none_of(softly_held.begin(),
                       softly_held.end(),
                       [&](const FreeMotion &held) {
                         return held.piece == motion.piece;
                       }))
        {
          softly_held.push_back(motion);
          news = true;
          screen << "  nothing holds " << mesh->piece_name(motion.piece)
                 << " against: " << motion.name << "; it is held softly"
                 << std::endl;
        }
    return news;
  }



  // @sect4{ContactProblem::solve_with_soft_hold}
  //
  // A body that nothing holds is held by springs so soft that the load carries
  // it to where contact holds it. From there the springs are hung up anew where
  // the body is now, and so on: the proximal point method (Rockafellar, SIAM J.
  // Control Optim. 14, 1976), at whose end the springs do nothing. Where the
  // body goes on moving, nothing holds it.
  void ContactProblem::solve_with_soft_hold()
  {
    if (softly_held.empty())
      {
        elasticity->soft_hold.release();
        solve_with_geometry_loop();
        return;
      }

    // Far softer than any body, yet far above the round-off of the stiffest.
    double softest = std::numeric_limits<double>::max();
    for (const auto &body : mesh->bodies)
      softest = std::min(softest, elasticity->young(body.second));
    std::map<unsigned int, double> stiffness; // by piece
    for (const FreeMotion &motion : softly_held)
      stiffness[motion.piece] =
        1e-6 * softest * elasticity->soft_hold.mean_circumference(motion.piece);

    // What turns in itself may not be carried away by what pushes it: stiff
    // against the forces, for they have nothing to carry.
    for (const TurningPiece &piece : turning)
      {
        const auto corners =
          mesh->pieces[piece.piece].box.get_boundary_points();
        stiffness[piece.piece] =
          std::max(stiffness[piece.piece],
                   10 * reference_force /
                     corners.first.distance(corners.second));
      }

    const unsigned int max_turns = 20;
    for (unsigned int turn = 1;; ++turn)
      {
        Vector<double> rest = solution;
        remove_rotations(*discretization, turning, rest);
        elasticity->soft_hold.hold(stiffness, rest);
        if (interface)
          {
            pair_bodies();
            interface->close_nearest(solution);
          }
        solve_with_geometry_loop();

        // Against rotation, what turns in itself is held for good.
        rest = solution;
        remove_rotations(*discretization, turning, rest);
        const auto   works  = elasticity->soft_hold.energy(rest);
        const auto   most   = std::max_element(works.begin(),
                                           works.end(),
                                           [](const auto &a, const auto &b) {
                                             return a.second < b.second;
                                           });
        const double work   = most->second;
        const double force  = std::sqrt(2 * stiffness.at(most->first) * work);
        const double energy = elasticity->strain_energy(solution);
        summary.increments.back().hold_work = work;
        screen << "  soft hold, turn " << turn << ": its work " << work
               << " N mm" << discretization->per_thickness()
               << ", strain energy " << energy << " N mm"
               << discretization->per_thickness() << std::endl;
        if (work <= 1e-8 * energy ||
            force <= newton_tolerance() * reference_force)
          return;
        if (turn == max_turns)
          {
            const auto         motion = std::find_if(softly_held.begin(),
                                             softly_held.end(),
                                             [&](const FreeMotion &held) {
                                               return held.piece == most->first;
                                             });
            std::ostringstream message;
            message << "nothing stops " << mesh->piece_name(motion->piece)
                    << " in its " << motion->name
                    << ": a soft hold still carries " << force << " N"
                    << discretization->per_thickness() << " after " << turn
                    << " turns";
            throw NotConverged(message.str());
          }
      }
  }



  // @sect4{ContactProblem::solve_with_geometry_loop}
  //
  // Pair, freeze projections and normals, solve, pair again. The first turn is
  // never accepted, for it knows the geometry of the increment's start only;
  // unless that is already the solution of a coarser mesh: then the change of
  // the surfaces is asked for, not that under a nodal force, which never ends.
  // The criterion is the one of the reference solution: the largest change of a
  // displacement against the largest displacement of the increment before.
  void ContactProblem::solve_with_geometry_loop()
  {
    if (!geometry_follows() || pairs_each_step())
      {
        solve_with_friction_loop();
        return;
      }

    double     change = 0;
    Relaxation relaxation;
    for (unsigned int turn = 1;
         turn <= parameters.solution.max_geometry_iterations;
         ++turn)
      {
        double last_increment = largest_change(start);
        // Rigid motions to the first touch are no measure.
        if (turn > 1 && !softly_held.empty())
          last_increment =
            std::min(last_increment,
                     2 * elasticity->strain_energy(solution) / reference_force);

        screen << "  geometry, turn " << turn << std::endl;
        ++summary.increments.back().geometry_iterations;
        if (turn == 1)
          pair_bodies();
        else if (condensed)
          interface->open_parted(solution);
        solve_with_friction_loop();

        // How far the bodies are from where they were paired.
        const double moved = level > 0
                               ? interface->largest_change(solution, paired_at)
                               : largest_change(paired_at);
        change             = moved == 0 ? 0. : moved / last_increment;
        if (turn > 1 || level > 0)
          {
            screen << "    change of the displacement " << change << std::endl;
            if (change < parameters.solution.geometry_tolerance)
              return;
          }

        renew_pairing(relaxation);
      }
    throw NotConverged(
      "the geometry loop ends with a change of " + brief(change) + " after " +
      std::to_string(parameters.solution.max_geometry_iterations) + " turns");
  }



  // @sect4{ContactProblem::solve_with_friction_loop}
  //
  // Coulomb's friction as a fixed point over Tresca's: solve with frozen bounds
  // of the shear traction, update the bounds from the pressures, until they
  // stay. A body that friction alone holds would have nothing to hold it where
  // no pressure is known: there it sticks in the first turn.
  void ContactProblem::solve_with_friction_loop()
  {
    if (!has_friction() ||
        parameters.solution.friction != Parameters::FrictionLoop::fixed_point ||
        !interface->has_coulomb_friction())
      {
        if (has_friction() && level == 0)
          interface->update_bounds(solution, start);
        solve_newton();
        return;
      }

    if (!free_motions(*discretization, interface.get(), Tangents::free).empty())
      interface->raise_unknown_bounds();

    double     change = 0;
    Relaxation relaxation;
    for (unsigned int turn = 1;
         turn <= parameters.solution.max_friction_iterations;
         ++turn)
      {
        ++summary.increments.back().friction_iterations;
        solve_newton();
        Vector<double> bounds = interface->bounds();
        change                = interface->update_bounds(solution, start);
        screen << "    friction, turn " << turn << ": change of the bound "
               << change << std::endl;
        if (change <= parameters.solution.friction_tolerance)
          return;

        const double part = relaxation.length(interface->bounds());
        if (part < 1)
          {
            bounds.sadd(1 - part, part, interface->bounds());
            interface->set_bounds(bounds);
          }
      }
    throw NotConverged(
      "the friction loop ends with a change of the bound of " + brief(change) +
      " after " + std::to_string(parameters.solution.max_friction_iterations) +
      " turns");
  }



  // @sect3{Newton's method}

  // @sect4{ContactProblem::solve_newton}
  //
  // Newton's method on displacements, multipliers and decisions together. It
  // has converged when the residual, forces and constraints, is small against
  // the forces, under the status that each point has in the present state.
  //
  // In the loops around it, from turn to turn little changes, and a
  // factorization may serve for several steps. It is kept while it reduces the
  // residual well, and as long as the decisions are those it was made under.
  void ContactProblem::solve_newton()
  {
    const unsigned int max_steps = parameters.solution.max_newton_iterations;

    NewtonGuard           guard;
    Vector<double>        last; // where the last step began
    std::vector<Decision> last_decisions;
    double                last_residual = std::numeric_limits<double>::max();
    unsigned int          n_single      = 0;
    bool                  one_at_a_time = false;
    bool                  search        = true;
    PairingGuard          pairing(parameters.solution.geometry_tolerance);
    Relaxation            relaxation;
    const auto            way = [&]() {
      return interface->largest_change(solution, start);
    };
    const bool follows = geometry_follows() && pairs_each_step();
    freeze_pairing(false);
    pairing_jumps = false;
    for (unsigned int step = 0;; ++step)
      {
        stop_if_interrupted(communicator);
        if (interface)
          last_decisions = interface->decisions();
        Outcome now = evaluate(step > 0, one_at_a_time);
        print_step(step, now.residual, now.n_changes);
        if (step > 0)
          now = shorten_step(now, guard, last, last_decisions);
        const bool progress = guard.advance(now.force);
        if (step > 0 && follows)
          pairing.advance(interface->largest_change(solution, last),
                          way(),
                          progress);
        // After a step the residual is that under the new status of all points:
        // a point may change it for ever where pressure and gap both vanish.
        const bool is_decided =
          now.n_changes == 0 ||
          (step > 0 && !one_at_a_time && points_follow_the_law());
        freeze_pairing(follows && pairing.is_frozen());
        bool is_to_be_paired = false;
        if (is_decided && !discretization->update_is_prescribed() &&
            now.residual <= newton_tolerance())
          {
            if (!follows ||
                pairing.accepts(interface->largest_change(solution, paired_at),
                                way()))
              return;
            pairing_jumps = pairing.goes_in_circles() &&
                            pairing.accepts(misfit_of_new_pairing(), way());
            if (pairing_jumps)
              return;
            is_to_be_paired = true;
            screen << "      paired anew: the surfaces have moved by "
                   << interface->largest_change(solution, paired_at)
                   << " mm of " << way() << " mm since they were paired"
                   << std::endl;
          }
        if (step >= max_steps + n_single)
          throw NotConverged(
            "Newton's method ends with the residual " + brief(now.residual) +
            " after " + std::to_string(step) + " steps" +
            what_is_open(now, is_to_be_paired) + changes_since(last_decisions) +
            (elimination ? elimination->contradiction() : ""));
        if (is_to_be_paired)
          {
            renew_pairing(relaxation);
            pairing.count_renewal();
            guard.forget();
            continue;
          }

        const bool was_one_at_a_time = one_at_a_time;
        one_at_a_time                = guard.one_at_a_time(now.n_changes);
        if (one_at_a_time && !was_one_at_a_time)
          {
            ++summary.increments.back().cycles;
            screen << "      the active set cycles, now one point at a time "
                      "changes:"
                   << changes_since(last_decisions) << std::endl;
            if (condensed)
              n_single = interface->points.size();
          }

        last = solution;
        if (discretization->update_is_prescribed())
          guard.forget();
        if (condensed)
          update_solution_condensed(step, now.residual);
        else
          {
            if (!update_solution(now.residual, last_residual, search))
              {
                search = false;
                screen << "      the search of the active set does not "
                          "settle: the points decide from step to step"
                       << std::endl;
              }
          }

        last_residual = now.residual;
        ++summary.increments.back().newton_iterations;
      }
  }



  // @sect4{ContactProblem::points_follow_the_law}
  //
  // One whose slip turns round sticks first, though its shear be too large.
  bool ContactProblem::points_follow_the_law() const
  {
    return std::all_of(interface->points.begin(),
                       interface->points.end(),
                       [this](const ContactPoint &point) {
                         const ContactState now =
                           interface->state(point, solution, start);
                         return interface->decide(point,
                                                  Decision(),
                                                  now.p_trial,
                                                  now.q_trial,
                                                  linearization.moving_bound) ==
                                point.decision;
                       });
  }



  // @sect4{ContactProblem::what_is_open}
  //
  // Where Newton's method ends with forces in balance, something else has not
  // come to rest. In words, for the message.
  std::string ContactProblem::what_is_open(const Outcome &now,
                                           const bool     pairing) const
  {
    if (now.residual > newton_tolerance() ||
        discretization->update_is_prescribed())
      return "";
    const std::string balanced = ", which is small enough; not settled is ";
    if (!pairing)
      return balanced + "the status of the points of contact";
    return balanced + "the pairing: the surfaces are " +
           brief(interface->largest_change(solution, paired_at)) +
           " mm from where they were paired, of " +
           brief(interface->largest_change(solution, start)) +
           " mm of the increment. Where a node of the slave slides over a "
           "corner of the master it may face the edges on either side in turn: "
           "a finer master, Mesh/Arcs, or the rule mortar";
  }



  // @sect4{ContactProblem::freeze_pairing}
  //
  // The tangent knows how projections and normals move as long as they do.
  void ContactProblem::freeze_pairing(const bool frozen)
  {
    pairing_is_frozen = frozen;
    linearization.moving_geometry =
      parameters.geometry(summary.n_displacements) ==
        Parameters::GeometryLoop::newton &&
      !frozen;
  }



  // @sect4{ContactProblem::evaluate}
  //
  // After a step the points decide anew. Before the first one they only would:
  // what has changed outside, load, pairing or bounds, is not in their
  // tractions yet, and the search of the active set comes first.
  ContactProblem::Outcome ContactProblem::evaluate(const bool after_a_step,
                                                   const bool one_at_a_time)
  {
    if (geometry_follows() && pairs_each_step() && !pairing_is_frozen)
      pair_bodies_ahead(after_a_step);

    Outcome outcome;
    outcome.volume = assemble_forces_of_bodies();
    if (interface)
      {
        if (condensed && after_a_step)
          recover_multipliers();
        outcome.n_changes =
          interface->decide_all(solution,
                                start,
                                linearization.moving_bound,
                                /*keep=*/after_a_step && !one_at_a_time);
        if (after_a_step && outcome.n_changes > 0)
          ++counters().active_set_changes;
        // As the search does. Without it the points go on from step to step,
        // and that would begin each turn of the friction loop anew.
        if (!condensed && after_a_step && !linearization.moving_bound)
          interface->drop_bounds_of_open_points();
        if (after_a_step && one_at_a_time)
          interface->decide_one(solution, start, linearization.moving_bound);
      }
    outcome.force    = assemble_forces_of_contact();
    reference_force  = force_scale->in(solution,
                                      start,
                                      load_factor,
                                      newton_tolerance(),
                                      linearization.moving_bound);
    outcome.residual = outcome.force / reference_force;
    return outcome;
  }



  // @sect4{ContactProblem::shorten_step}
  //
  // A step that turns a cell inside out, or leads to a residual larger than all
  // the last ones though no point has changed its mind, was too long: half of
  // it, and half of that. See NewtonGuard.
  ContactProblem::Outcome
  ContactProblem::shorten_step(const Outcome               &outcome,
                               const NewtonGuard           &guard,
                               const Vector<double>        &last,
                               const std::vector<Decision> &decisions)
  {
    const auto is_a_state = [](const Outcome &now) {
      return std::isfinite(now.residual) && now.volume.value > 0;
    };

    const unsigned int max_halvings = 6;
    Outcome            now          = outcome;
    for (unsigned int n = 0;
         n < max_halvings && (!is_a_state(now) || (now.n_changes == 0 &&
                                                   !guard.accepts(now.force)));
         ++n)
      {
        solution.sadd(0.5, 0.5, last);
        // Supports that were moved are half-way, too: the rest is left to do.
        discretization->constrain_update(solution, load_factor);
        if (interface)
          interface->set_decisions(decisions);
        ++summary.increments.back().halved_steps;
        now = evaluate(/*after_a_step=*/true, /*one_at_a_time=*/false);
        screen << "      half of this step: residual " << now.residual
               << std::endl;
      }
    if (!std::isfinite(now.residual))
      throw NotConverged("the residual is not a number");
    if (now.volume.value <= 0)
      {
        std::ostringstream message;
        message << "the body '" << mesh->body_name(now.volume.body)
                << "' turns inside out at X = (" << now.volume.X
                << ") mm: det F = " << now.volume.value;
        throw NotConverged(message.str());
      }
    return now;
  }



  // @sect4{ContactProblem::pair_bodies}
  //
  // The theory of small displacements knows the undeformed bodies only.
  void ContactProblem::pair_bodies()
  {
    pair_bodies(solution);
  }



  void ContactProblem::pair_bodies(const Vector<double> &configuration)
  {
    timer.enter_subsection("search");
    paired_at = configuration;
    if (interface)
      ++counters().pairings;
    if (geometry_follows() && !configuration.all_zero())
      ++counters().geometry_updates;
    const bool changed =
      interface && interface->pair(parameters.solution.geometry ==
                                       Parameters::GeometryLoop::undeformed
                                     ? Vector<double>(solution.size())
                                     : configuration,
                                   linearization.moving_geometry);
    timer.leave_subsection();
    if (condensed)
      condensed->update_pattern();
    else
      saddle_point->update_pattern(changed);
  }



  // @sect4{ContactProblem::pair_bodies_ahead}
  //
  // Before each Newton step the bodies are paired where they are; if the
  // tangent does not know how the pairing moves with them, and steps in one and
  // the same direction become but slowly shorter, where these lead to.
  void ContactProblem::pair_bodies_ahead(const bool after_a_step)
  {
    if (!after_a_step || linearization.moving_geometry)
      {
        extrapolation.forget();
        pair_bodies();
        return;
      }
    Vector<double> step(summary.n_displacements);
    for (unsigned int i = 0; i < step.size(); ++i)
      step[i] = solution[i] - paired_at[i];
    const double   length        = extrapolation.length(step);
    Vector<double> configuration = paired_at;
    configuration.sadd(1 - length, length, solution);
    pair_bodies(length == 1 ? solution : configuration);
  }



  // @sect4{ContactProblem::renew_pairing}
  //
  // A turn of the fixed point of the geometry. Where the bodies jump to and
  // fro, they are paired on the way.
  void ContactProblem::renew_pairing(Relaxation &relaxation)
  {
    const double part = relaxation.length(
      Vector<double>(solution.begin(),
                     solution.begin() + summary.n_displacements));
    Vector<double> configuration = paired_at;
    configuration.sadd(1 - part, part, solution);
    pair_bodies(configuration);
  }



  // @sect4{ContactProblem::misfit_of_new_pairing}
  //
  // How far the surfaces, paired where they are now, would be from touching
  // each other where they are in contact, and from being apart elsewhere.
  double ContactProblem::misfit_of_new_pairing()
  {
    const Vector<double> configuration = paired_at;
    pair_bodies();
    const double misfit = interface->largest_misfit(solution);
    pair_bodies(configuration);
    return misfit;
  }



  // @sect4{ContactProblem::assemble_forces_of_bodies}
  //
  // Every rank adds what its cells exert.
  VolumeRatio ContactProblem::assemble_forces_of_bodies()
  {
    TimerOutput::Scope scope(timer, "residual");
    system_rhs = 0;
    const VolumeRatio smallest =
      elasticity->assemble(solution, load_factor, system_rhs, nullptr);
    Utilities::MPI::sum(system_rhs, communicator, system_rhs);
    return smallest_of_all_ranks(smallest, communicator);
  }



  // @sect4{ContactProblem::recover_multipliers}
  //
  // Without multipliers in the linear system, they are what the bodies exert on
  // the nodes in contact. A bound that follows the pressure does so in between.
  void ContactProblem::recover_multipliers()
  {
    elimination->recover_pressures(system_rhs, solution);
    if (has_friction() &&
        parameters.solution.friction == Parameters::FrictionLoop::each_step)
      interface->update_bounds(solution, start);
    elimination->recover_shears(system_rhs, solution);
  }



  // @sect4{ContactProblem::assemble_forces_of_contact}
  //
  // Returns the norm of the whole residual, the same on all ranks: it decides
  // for all of them what comes next.
  double ContactProblem::assemble_forces_of_contact()
  {
    TimerOutput::Scope scope(timer, "residual");
    if (interface)
      interface->assemble(solution, start, linearization, system_rhs, nullptr);
    return Utilities::MPI::max(residual_norm(), communicator);
  }



  double ContactProblem::residual_norm() const
  {
    double square =
      interface ? std::pow(interface->constraint_norm(system_rhs), 2) : 0.;
    for (unsigned int i = 0; i < discretization->dof_handler.n_dofs(); ++i)
      square += system_rhs[i] * system_rhs[i];
    return std::sqrt(square);
  }



  // @sect4{ContactProblem::newton_tolerance}
  //
  // The levels below the last one need no more than the accuracy of their mesh.
  double ContactProblem::newton_tolerance() const
  {
    return is_last_level() ? parameters.solution.newton_tolerance
                           : std::max(parameters.solution.newton_tolerance,
                                      parameters.refinement.tolerance);
  }



  // @sect4{ContactProblem::update_solution}
  //
  // The step under the present decisions, then the search for those that the
  // linearised problem has. Returns whether that has come to an end.
  bool ContactProblem::update_solution(const double residual,
                                       const double last_residual,
                                       const bool   search)
  {
    const bool settled = saddle_point->solve(solution,
                                             start,
                                             load_factor,
                                             residual,
                                             last_residual,
                                             search,
                                             system_rhs);
    solution += system_rhs;
    discretization->constrain_update(solution, load_factor);
    return settled;
  }



  // @sect4{ContactProblem::update_solution_condensed}
  //
  // Inexact Newton: a step that others follow is not solved further than it is
  // good for, a thousandth of the residual, and well enough for the points to
  // decide on. Linear bodies under decisions that stay are solved in one.
  void ContactProblem::update_solution_condensed(const unsigned int step,
                                                 const double       residual)
  {
    const bool decided = step > 0 || !interface || interface->is_tied();
    const bool one_solve_is_all =
      elasticity->is_linear() && decided && !pairs_each_step() &&
      parameters.solution.friction == Parameters::FrictionLoop::fixed_point;
    const double forcing =
      std::min(1e-5, parameters.solution.linear_tolerance * residual);
    const double relative =
      std::max(0.1 * newton_tolerance(), one_solve_is_all ? 0. : forcing);
    const unsigned int n = condensed->solve(solution,
                                            start,
                                            system_rhs,
                                            relative * reference_force,
                                            update);
    summary.increments.back().linear_iterations += n;
    screen << "      solved to " << std::scientific << std::setprecision(1)
           << relative << std::defaultfloat << std::setprecision(6) << " in "
           << n << " iterations" << std::endl;
    for (unsigned int i = 0; i < update.size(); ++i)
      solution[i] += update[i];
    discretization->constrain_update(solution, load_factor);
  }



  void ContactProblem::print_step(const unsigned int step,
                                  const double       residual,
                                  const unsigned int n_changes)
  {
    screen << "    Newton " << std::setw(2) << step << "  residual "
           << std::scientific << std::setprecision(3) << residual
           << std::defaultfloat << std::setprecision(6);
    if (interface)
      {
        const StatusCount count = interface->count();
        screen << "  active " << count.active << "  stick " << count.stick
               << "  changes " << n_changes;
      }
    screen << std::endl;
  }



  // @sect3{From one mesh to the next}

  // @sect4{ContactProblem::refine}
  void ContactProblem::refine()
  {
    if (parameters.refinement.strategy == Parameters::Strategy::adaptive)
      {
        TimerOutput::Scope scope(timer, "estimate");
        const auto        &at_vertices = recovered_stresses();
        ++counters().error_estimates;
        flag_cells(*mesh,
                   ErrorEstimator(*discretization,
                                  *elasticity,
                                  *stress_recovery)
                     .indicators(at_vertices, interface.get(), solution),
                   parameters.refinement.fraction);
        for (const auto &zone : parameters.zones())
          if (zone.rule == Parameters::Rule::nodal && !zone.master.empty())
            flag_slave_like_master(
              *mesh,
              mesh->boundary(zone.slave, zone.section() + "/Slave"),
              mesh->boundary(zone.master, zone.section() + "/Master"));
      }
    else
      flag_all_cells(*mesh);

    // The old ones go first: two meshes at a time would take their memory.
    timer.enter_subsection("setup");
    condensed.reset();
    elimination.reset();
    invariants.reset();
    force_scale.reset();
    interface.reset();
    elasticity.reset();
    refine_and_carry_over(*mesh, *discretization, level_solutions);
    make_interface();
    timer.leave_subsection();

    ++level;
    make_linear_system();
    pair_bodies();
    force_scale = std::make_unique<ForceScale>(*discretization,
                                               *elasticity,
                                               interface.get());
    screen << "Level " << level << ": "
           << mesh->triangulation.n_global_active_cells() << " cells, "
           << summary.n_displacements << " displacements, "
           << summary.n_multipliers << " multipliers, " << system_name
           << std::endl;
  }



  // @sect3{What has to hold, and what comes out}

  // @sect4{ContactProblem::check_invariants}
  //
  // What has to hold for every solution, by a computation of its own. A result
  // that violates it is wrong, whatever Newton's method says.
  void ContactProblem::check_invariants()
  {
    TimerOutput::Scope scope(timer, "invariants");
    Vector<double>     hold;
    if (!elasticity->soft_hold.held().empty())
      {
        hold = elasticity->forces(solution, load_factor);
        elasticity->soft_hold.release();
        hold.sadd(-1, 1, elasticity->forces(solution, load_factor));
      }
    Invariants found =
      invariants->check(solution,
                        load_factor,
                        newton_tolerance(),
                        reference_force,
                        hold.size() > 0 ? &hold : nullptr,
                        geometry_follows()
                          ? interface->largest_change(solution, paired_at)
                          : 0.);
    invariants->advance();

    if (pairing_jumps)
      found.notes.push_back(
        "pairing: closest points jump between two places for good; the gaps of "
        "the one under the other are within the geometry tolerance, " +
        brief(parameters.solution.geometry_tolerance) +
        " of the way of the surfaces. A finer master, the rule mortar, or "
        "'Geometry = fixed point' may come to rest.");

    IncrementRecord &record = summary.increments.back();
    record.invariants       = found.measures();
    record.works            = found.works();
    record.violations       = found.violations;
    record.reactions        = found.reactions;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &note : found.notes)
        std::cerr << parameters.name << ", load factor " << load_factor
                  << ": note: " << note << std::endl;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const std::string &violation : found.violations)
        std::cerr << parameters.name << ", load factor " << load_factor
                  << ": violated: " << violation << std::endl;
  }



  // @sect4{ContactProblem::record_level}
  //
  // What this level took: the time since the level before.
  void ContactProblem::record_level()
  {
    LevelRecord record;
    {
      TimerOutput::Scope scope(timer, "output");
      for (const auto &[name, definition] : parameters.probes.probes)
        record.probes[name] = probe(definition);
    }
    record.n_cells         = mesh->triangulation.n_global_active_cells();
    record.n_displacements = summary.n_displacements;
    record.n_multipliers   = summary.n_multipliers;
    for (const IncrementRecord &increment : summary.increments)
      if (increment.level == level)
        {
          record.newton_iterations += increment.newton_iterations;
          record.linear_iterations += increment.linear_iterations;
        }
    record.time = phase_times(timer);
    for (const LevelRecord &before : summary.levels)
      for (const auto &[phase, time] : before.time)
        {
          record.time[phase].cpu -= time.cpu;
          record.time[phase].wall -= time.wall;
          record.time[phase].calls -= time.calls;
        }
    record.peak_memory_mb = Utilities::MPI::sum(peak_memory_mb(), communicator);
    summary.levels.push_back(record);
    if (is_last_level())
      report_probes();
  }



  // @sect4{ContactProblem::output_increment}
  //
  // The end of an increment, or, where that is not reached, the last state.
  void ContactProblem::output_increment(const unsigned int k,
                                        const bool         is_complete)
  {
    const bool is_last = is_complete && k == parameters.solution.n_increments;
    if (is_last && interface)
      compare_with_theory();
    const bool with_profile = is_last && parameters.output.profile;
    const bool with_nodes   = is_last && parameters.output.nodes;
    if (!parameters.output.vtu && !with_profile && !with_nodes)
      return;
    TimerOutput::Scope scope(timer, "output");

    Vector<double> forces;
    if (interface)
      forces =
        contact_forces(*interface, solution, start, linearization.moving_bound);
    if (with_nodes)
      files->write_nodes(solution, forces);
    if (!parameters.output.vtu && !with_profile)
      return;

    std::vector<ZoneProfile> profiles;
    if (interface)
      profiles = zone_profiles(*interface,
                               *discretization,
                               recovered_stresses(),
                               solution,
                               start,
                               exact,
                               /*with_masters=*/with_profile);

    if (parameters.output.vtu)
      {
        files->write_bodies(k,
                            load_factor,
                            recovered_stresses(),
                            solution,
                            forces);
        if (interface)
          files->write_contact(k, load_factor, profiles);
      }
    if (interface && with_profile)
      files->write_profile(profiles);
  }



  const std::vector<SymmetricTensor<2, 3>> &ContactProblem::recovered_stresses()
  {
    if (!stress_recovery)
      stress_recovery = std::make_unique<StressRecovery>(*discretization);
    if (stresses.empty())
      {
        ++counters().stress_recoveries;
        stresses = stress_recovery->vertex_stresses(*elasticity, solution);
      }
    return stresses;
  }



  ContactResults ContactProblem::results(const ContactZone &zone) const
  {
    return contact_results(*interface,
                           zone,
                           solution,
                           start,
                           linearization.moving_bound);
  }



  // @sect4{ContactProblem::compare_with_theory}
  //
  // What the contact is like in a few numbers, and what it should be like where
  // theory has an answer.
  void ContactProblem::compare_with_theory()
  {
    summary.contact = summary.increments.back().contact;

    TimerOutput::Scope scope(timer, "verification");
    try
      {
        exact = make_exact_solution(parameters,
                                    *discretization,
                                    *interface->zones[0],
                                    results(*interface->zones[0]));
      }
    catch (const ExceptionBase &failure)
      {
        // That is about the theory: the solution is what it is.
        std::ostringstream reason;
        failure.print_info(reason);
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          std::cerr << parameters.name << ": not compared with theory: "
                    << Utilities::trim(reason.str()) << std::endl;
      }
    if (!exact)
      return;
    summary.exact  = exact->values;
    summary.errors = solution_errors(*exact,
                                     *discretization,
                                     *elasticity,
                                     *interface,
                                     *interface->zones[0],
                                     solution);
  }



  // @sect4{ContactProblem::probe}
  double ContactProblem::probe(const std::vector<std::string> &definition)
  {
    const std::string &quantity = definition[0];
    const auto         value    = [&](const std::string &point) {
      const unsigned int vertex = mesh->point(point, "Probes/Probes");
      if (is_contact_traction(quantity))
        return contact_traction(quantity,
                                vertex,
                                interface.get(),
                                *discretization,
                                solution);
      return probe_value(quantity,
                         vertex,
                         *discretization,
                         is_stress(quantity) ? recovered_stresses() : stresses,
                         solution);
    };
    return definition.size() == 2 ? value(definition[1])
                                  : value(definition[1]) - value(definition[2]);
  }



  // @sect4{ContactProblem::report_probes}
  void ContactProblem::report_probes()
  {
    for (const auto &[name, definition] : parameters.probes.probes)
      {
        ProbeResult result;
        result.name  = name;
        result.unit  = is_displacement(definition[0]) ? "mm" : "MPa";
        result.value = summary.levels.back().probes.at(name);
        if (parameters.probes.references.count(name) > 0)
          {
            result.reference = parameters.probes.references.at(name);
            result.tolerance = parameters.probes.tolerances.at(name);
          }
        summary.probes.push_back(result);
      }
    estimate_errors(summary);
  }



  // @sect4{ContactProblem::finish}
  void ContactProblem::finish()
  {
    files->write_first("parameters.prm", [this](std::ostream &out) {
      prm.print_parameters(out, ParameterHandler::ShortPRM);
    });
    summary.time     = phase_times(timer);
    summary.counters = counters().by_name();
    summary.peak_memory_mb =
      Utilities::MPI::sum(peak_memory_mb(), communicator);
    // This file counts, too.
    ++summary.counters["files"];
    files->write_first("summary.json", [this](std::ostream &out) {
      write_summary(summary, out);
    });
    if (summary.converged &&
        Utilities::MPI::this_mpi_process(communicator) == 0)
      std::filesystem::remove(files->directory / "restart.bin");

    if (screen.is_active())
      {
        print_levels(screen.get_stream(), summary);
        print_counters(screen.get_stream(), summary);
        screen << "Results: " << files->directory.string() << std::endl;
      }
  }



  // @sect3{Going on where a run has ended}

  // @sect4{ContactProblem::write_restart_file}
  //
  // Also what can be told by now, should the run not come to its end.
  void ContactProblem::write_restart_file(LoadSteps &steps)
  {
    if (steps.finished())
      return;
    TimerOutput::Scope scope(timer, "output");
    files->write_first("summary.json", [this](std::ostream &out) {
      write_summary(summary, out);
    });
    files->write_first("restart.bin", [&](std::ostream &out) {
      write_restart(out, restart_key(), [&](auto &archive) {
        serialize(archive, steps);
      });
    });
  }



  void ContactProblem::read_restart_file(LoadSteps &steps)
  {
    const auto file = files->directory / "restart.bin";
    if (!std::filesystem::exists(file))
      {
        screen << "Nothing to go on from: no " << file << std::endl;
        return;
      }
    read_restart(file, restart_key(), [&](auto &archive) {
      serialize(archive, steps);
    });
    files->write_series();
    screen << "Restart behind the load factor "
           << summary.increments.back().load_factor << std::endl;
  }



  // @sect4{ContactProblem::restart_key}
  //
  // What has to be the same for a run to be the continuation of another one.
  std::string ContactProblem::restart_key() const
  {
    std::ostringstream key;
    key << "contact restart 1, ranks "
        << Utilities::MPI::n_mpi_processes(communicator) << ", unknowns "
        << solution.size() << ", mesh " << checksum(parameters.mesh.file)
        << '\n';
    prm.print_parameters(key, ParameterHandler::ShortPRM);
    return key.str();
  }



  // @sect4{ContactProblem::serialize}
  //
  // Levels below the last one are computed again, which costs less than to keep
  // their meshes.
  template<class Archive>
  void ContactProblem::serialize(Archive &archive, LoadSteps &steps)
  {
    std::vector<double>      values(solution.begin(), solution.end()), bounds;
    std::vector<signed char> decisions;
    if (interface)
      {
        decisions              = interface->signature();
        const Vector<double> b = interface->bounds();
        bounds.assign(b.begin(), b.end());
      }
    archive &steps &values &decisions &bounds &*force_scale &*invariants
      &summary.increments &*files;
    if (!Archive::is_loading::value)
      return;

    solution = Vector<double>(values.begin(), values.end());
    pair_bodies();
    if (interface)
      {
        std::vector<Decision> all;
        all.reserve(decisions.size());
        for (const auto code : decisions)
          all.push_back(Decision::from_code(code));
        interface->set_decisions(all);
        interface->set_bounds(Vector<double>(bounds.begin(), bounds.end()));
      }
  }



  // @sect3{What is asked in several places}

  bool ContactProblem::is_last_level() const
  {
    return level == parameters.refinement.n_levels;
  }



  bool ContactProblem::has_friction() const
  {
    return interface && interface->has_friction();
  }



  bool ContactProblem::pairs_each_step() const
  {
    return parameters.solution.geometry !=
             Parameters::GeometryLoop::undeformed &&
           parameters.solution.geometry !=
             Parameters::GeometryLoop::fixed_point;
  }



  /// Whether the points are paired with bodies that have moved.
  bool ContactProblem::geometry_follows() const
  {
    return interface && !interface->is_tied() &&
           parameters.solution.geometry != Parameters::GeometryLoop::undeformed;
  }



  /// The largest change of a displacement [mm].
  double ContactProblem::largest_change(const Vector<double> &from) const
  {
    double change = 0;
    for (unsigned int i = 0; i < discretization->dof_handler.n_dofs(); ++i)
      change = std::max(change, std::abs(solution[i] - from[i]));
    return Utilities::MPI::max(change, communicator);
  }



  std::string
  ContactProblem::changes_since(const std::vector<Decision> &decisions) const
  {
    return interface ? describe_changes(*interface, decisions, solution, start)
                     : "";
  }
} // namespace Contact



// @sect3{The main function}
//
// What the exit status says is in print_help().
namespace
{
  // The same case on the mesh refined once, by which errors are estimated.
  Contact::Parameters::All refined_case(const Contact::Parameters::All &coarse)
  {
    Contact::Parameters::All finer = coarse;
    finer.name += "_refined";
    finer.mesh.refinements += 1;
    finer.output.vtu = finer.output.profile = false;
    return finer;
  }



  // The discretization error of a run on one mesh is asked for by another one
  // on the mesh refined once, which leaves no files but its summary: the
  // parameters are those of the first.
  Contact::RunSummary run_case(const Contact::Parameters::All &parameters,
                               const dealii::ParameterHandler &prm,
                               const bool                      verbose)
  {
    using namespace Contact;

    RunSummary summary = ContactProblem(parameters, prm, verbose).run();
    if (!parameters.probes.estimate_errors || !summary.converged ||
        parameters.refinement.n_levels > 0)
      return summary;

    const Parameters::All finer   = refined_case(parameters);
    const RunSummary      refined = ContactProblem(finer, prm, verbose).run();
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::error_code error;
        std::filesystem::remove(finer.directory() / "parameters.prm", error);
      }
    summary.interrupted = refined.interrupted;
    if (refined.converged)
      {
        estimate_errors(summary, refined.probes);
        write_on_first_rank(MPI_COMM_WORLD,
                            parameters.directory() / "summary.json",
                            [&](std::ostream &out) {
                              write_summary(summary, out);
                            });
      }
    else if (!refined.interrupted)
      std::cerr << parameters.name
                << ": no error estimate, because the case does not converge on "
                   "the mesh refined once: "
                << refined.message << std::endl;
    return summary;
  }



  // A process that no launcher has started as one of several talks to nobody:
  // without Open MPI's daemon and network it starts in half the time. What the
  // environment says comes first. It needs no directory for its session,
  // either: all such processes would share one, and remove it from under each
  // other.
  void spare_network_of_single_process()
  {
    for (const char *launched :
         {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
      if (std::getenv(launched) != nullptr)
        return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", /*overwrite=*/0);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_osc", "^ucx", 0);
  }



  // All files are read before the first one is computed: a wrong entry in the
  // last one should not cost the time of the others.
  int run(const Contact::CommandLine &line)
  {
    using namespace Contact;

    const bool is_first_rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    std::vector<Parameters::All>          cases(line.files.size());
    std::vector<dealii::ParameterHandler> handlers(line.files.size());
    for (unsigned int i = 0; i < cases.size(); ++i)
      {
        read_parameters(line.files[i], line.overrides, handlers[i], cases[i]);
        cases[i].n_ranks =
          dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
        cases[i].restart = line.restart;
        cases[i].check();
      }
    note_signals();

    std::set<std::filesystem::path> directories;
    for (const Parameters::All &a_case : cases)
      if (!directories.insert(a_case.directory()).second ||
          (a_case.probes.estimate_errors &&
           !directories.insert(refined_case(a_case).directory()).second))
        throw InputError("two cases have the name '" + a_case.name +
                           "', and the same directory for their results",
                         "command line",
                         "rename one of the files, or run them one by one with "
                         "another Output/Directory");

    std::vector<RunSummary> summaries;
    for (unsigned int i = 0; i < cases.size(); ++i)
      {
        summaries.push_back(run_case(cases[i], handlers[i], !line.quiet));
        if (summaries.back().interrupted)
          break;
      }

    if (cases.front().output.screen != Parameters::Screen::none &&
        is_first_rank)
      print_table(std::cout, summaries);

    int status = 0;
    for (const RunSummary &summary : summaries)
      if (summary.interrupted)
        return 5;
      else if (!summary.converged)
        status = 3;
      else if (!summary.passed() && status == 0)
        status = 1;
    return status;
  }
} // namespace



int main(int argc, char **argv)
{
  // What computes nothing needs no MPI.
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--help")
    {
      Contact::print_help(std::cout);
      return 0;
    }
  if (first == "--version")
    {
      Contact::print_version(std::cout);
      return 0;
    }
  if (first == "--parameters")
    {
      Contact::print_parameters(std::cout);
      return 0;
    }

  spare_network_of_single_process();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return run(Contact::parse_command_line(argc, argv));
    }
  catch (const Contact::InputError &error)
    {
      // All processes read the same.
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cerr << error.what() << std::endl;
      return 2;
    }
  catch (const std::exception &error)
    {
      std::cerr << "The program failed; this is an error of its own:\n"
                << error.what() << std::endl;
      // The others would wait for this one.
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, 4);
      return 4;
    }
}
