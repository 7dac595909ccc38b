/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The entries of how a scene is solved, and of what is reported.

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include "base/string_utilities.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void Solution::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Solution");
      add_increments(prm);
      add_loops(prm);
      add_linear_system(prm);
      prm.leave_subsection();
    }



    void Solution::add_increments(ParameterHandler &prm)
    {
      prm.add_parameter("Increments",
                        increments,
                        "The number of equal steps to the full load [-], or "
                        "the load factors t where they end, separated by ',' "
                        "and the last one 1: '0.01, 0.1, 1'.");
      prm.add_parameter("Max cut-backs",
                        max_cuts,
                        "How often an increment that does not converge is cut "
                        "in half before giving up [-]; 0: never. Behind it "
                        "the steps grow again.",
                        Patterns::Integer(0, 20));
    }



    void Solution::add_loops(ParameterHandler &prm)
    {
      prm.add_parameter("Geometry",
                        geometry,
                        "How projections and normals follow the displacements "
                        "[-]; undeformed: not at all, as theories of small "
                        "displacements have it (kinematics small strain); "
                        "fixed point: in a loop of their own; each step: "
                        "renewed before each Newton step, until these move "
                        "the surfaces by less than the geometry tolerance; "
                        "Newton: with the displacements, in the tangent as "
                        "well (saddle point system); automatic: Newton, in "
                        "the condensed system each step.");
      prm.add_parameter(
        "Geometry tolerance",
        geometry_tolerance,
        "Largest change of a displacement behind the last pairing, relative to "
        "the largest displacement of the increment [-]; > 0. The first iteration of "
        "a geometry loop is never accepted.");
      prm.add_parameter("Friction",
                        friction,
                        "How the bound of friction follows the pressure [-]; "
                        "fixed point: in a loop over Tresca's problems; "
                        "Newton: in the tangent.");
      prm.add_parameter(
        "Friction tolerance",
        friction_tolerance,
        "Largest change of a bound of the shear traction in one iteration of the "
        "friction loop, relative to the largest bound [-]; > 0.");
      prm.add_parameter("Newton tolerance",
                        newton_tolerance,
                        "Residual of equilibrium and of the contact "
                        "constraints, relative to the load [-]; > 0.");
      prm.add_parameter(
        "Max Newton iterations",
        max_newton_iterations,
        "Newton iterations before giving up [-]; 0: 25, and 100 "
        "with contact in the condensed system, whose tangent "
        "does not know how the pairing moves.",
        Patterns::Integer(0));
    }



    void Solution::add_linear_system(ParameterHandler &prm)
    {
      prm.add_parameter("Estimate effects",
                        estimate_effects,
                        "Estimate at the end how much each effect, that the "
                        "scene has or leaves out, changes the probes [-]: by "
                        "two Newton steps of the scene with and without it.");
      prm.add_parameter("Linear tolerance",
                        linear_tolerance,
                        "How far conjugate gradients are driven in a Newton "
                        "step, relative to the residual of that [-]; > 0, < "
                        "1. Where bodies yield, and the step will leave more "
                        "than that, and in contact of linear bodies in 3-D, "
                        "to 0.01.");
      prm.add_parameter(
        "System",
        system,
        "The linear system [-]; saddle point: with the "
        "multipliers; condensed: without, symmetric positive "
        "definite without friction, for the nodal and mortar discretizations; "
        "automatic: condensed in 3-D, without contact, for glued surfaces, with "
        "several levels, with several processes, with another solver than "
        "UMFPACK, and with more than 100000 displacements for the discretizations nodal "
        "and mortar, otherwise saddle point.");
      prm.add_parameter("Linear solver",
                        linear_solver,
                        "UMFPACK for saddle point systems; for condensed ones "
                        "CHOLMOD, AMG (conjugate gradients with smoothed "
                        "aggregation), GMG (with geometric multigrid, and "
                        "without a matrix) or MUMPS [-]; automatic: for "
                        "condensed systems GMG from 20000 unknowns (in 3-D "
                        "5000; in large displacement 100000 and 10000) on if "
                        "the mesh is a refined one and the scene one for it, "
                        "else CHOLMOD below 100000 (in 3-D "
                        "25000, with friction 50000) on one rank and AMG "
                        "beyond; for saddle point "
                        "systems UMFPACK below 30000 unknowns, and beyond "
                        "CHOLMOD for the bodies and LAPACK for the contact, if "
                        "its unknowns are few.");
    }



    void Refinement::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Refinement");
      prm.add_parameter("Levels",
                        n_levels,
                        "How often the mesh is refined after a solution, which "
                        "is transferred [-].",
                        Patterns::Integer(0));
      prm.add_parameter(
        "Strategy",
        strategy,
        "uniform: all cells; adaptive: the cells with the "
        "largest estimated errors, for meshes of quadrangles or "
        "hexahedra; "
        "automatic: uniform, but adaptive towards an accuracy "
        "where the mesh allows it [-].");
      prm.add_parameter("Limits",
                        limits,
                        "'unknowns: number, seconds: number, megabytes: "
                        "number', each of them or none: no further level of a "
                        "run that an accuracy is asked of [-, s, MB].");
      prm.add_parameter(
        "Fraction",
        fraction,
        "The share of the estimated error (squared, without an "
        "accuracy) that is in the cells to refine [-]; >= 0, <= "
        "1; only for adaptive; 0: automatic: 0.5, and towards "
        "an accuracy that which takes the fewest unknowns.",
        Patterns::Double(0, 1));
      prm.add_parameter("Tolerance",
                        tolerance,
                        "The Newton tolerance on all levels but the last [-]; "
                        "> 0.");
      prm.leave_subsection();
    }



    void Probes::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Probes");
      prm.add_parameter(
        "Probes",
        probes,
        "Values to report: 'name: quantity, point', separated "
        "by ';'; with a second point group, as in 'name: "
        "quantity, point, point', the value at the first minus "
        "the value at the second. One of: " +
          Choice<Quantity>::names(", ") +
          " [displacements: mm, stresses: MPa, forces: N per "
          "mm of thickness, in rings N]; pressure and shear "
          "are those of contact, at points of a slave, by undeformed area, the true "
          "pressure by deformed area; reactions "
          "and contact forces are all forces on the body at a boundary "
          "group, reactions also at a point group, named as the point: on the "
          "nodes that supports hold in that direction, and on the "
          "others; support forces are reactions without what contact exerts "
          "on these nodes; obstacle forces and moments, about its centre, "
          "those of an obstacle on the body, its section 'Contact "
          "NAME' as the point, and its motions since the beginning; alike "
          "preload and shortening are those of a cut; the strain energy is that of a body, "
          "named as the point [N mm per mm of thickness, in rings N "
          "mm].");
      prm.add_action("Probes", [this](const std::string &value) {
        order.clear();
        for (const std::string &probe :
             Utilities::split_string_list(value, ';'))
          order.push_back(split_at(probe, probe.find(':')).first);
      });
      prm.add_parameter("References",
                        references,
                        "'name: value', separated by ','; what a probe is "
                        "compared with, in its unit [mm or MPa].");
      prm.add_parameter("Tolerances",
                        tolerances,
                        "'name: value', separated by ','; the deviation from "
                        "the reference that is accepted, relative to it [-]; "
                        "> 0.");
      add_errors(prm);
      prm.leave_subsection();
    }



    void Probes::add_errors(ParameterHandler &prm)
    {
      prm.add_parameter(
        "Errors",
        errors,
        "What estimates the discretization error of the probes [-]; "
        "automatic: levels by their values, a single mesh in 2-D by a "
        "dual problem for each probe where that costs little; dual "
        "weighted residuals: that on each level, whatever it costs; "
        "next mesh: of a single mesh, the same scene on the mesh "
        "refined once; none.");
      prm.add_parameter(
        "Accuracy",
        accuracy,
        "'name: error unit', separated by ','; the unit is % "
        "of the value, mm or MPa. The mesh is refined until the "
        "estimated errors of these probes are no larger, or a "
        "limit is reached; without 'Levels', as often as it "
        "takes [%, mm, MPa].");
    }



    void Output::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Output");
      prm.add_parameter("Directory",
                        directory,
                        "Where files go, relative to the working directory "
                        "[-].");
      prm.add_parameter("Screen",
                        screen,
                        "What is printed [-]; increments: a line for each and "
                        "the table of results, full: all iterations as well, "
                        "table: the table, none: nothing.");
      prm.add_parameter("VTU",
                        vtu,
                        "Whether displacements and stresses of each increment "
                        "are written for ParaView [-].");
      prm.add_parameter("Profile",
                        profile,
                        "Whether pressure, shear, gap and slip along both "
                        "surfaces are written at the end [-].");
      prm.add_parameter("Nodes",
                        nodes,
                        "Whether displacements and forces of contact of all "
                        "nodes are written in full precision at the end [-].");
      prm.leave_subsection();
    }
  } // namespace Parameters
} // namespace Contact
