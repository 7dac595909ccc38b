/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <ostream>

#include "parameter_file.h"

namespace Contact
{
  namespace
  {
    // ParameterHandler prints what is allowed only in a form that is not a
    // parameter file.
    void print_entry(const DeclaredEntry &entry, std::ostream &out)
    {
      for (const std::string &text :
           {entry.documentation, "Allowed: " + entry.allowed_values()})
        for (const std::string &line :
             Utilities::break_text_into_lines(text, 74))
          out << "  # " << line << '\n';
      out << "  set " << entry.name << " ="
          << (entry.default_value.empty() ? "" : " ") << entry.default_value
          << '\n';
    }
  } // namespace



  namespace Parameters
  {
    const std::vector<std::string> Probes::quantities = {"displacement x",
                                                         "displacement y",
                                                         "stress xx",
                                                         "stress yy",
                                                         "stress zz",
                                                         "stress xy",
                                                         "von Mises",
                                                         "pressure",
                                                         "shear"};



    void Mesh::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Mesh");
      prm.add_parameter("File",
                        file,
                        "The mesh: a gmsh file in MSH format 2.2 or 4.1, "
                        "coordinates in mm, relative to the file that sets "
                        "this entry.");
      prm.add_parameter("Refinements",
                        refinements,
                        "How often the mesh is refined globally [-].",
                        Patterns::Integer(0));
      prm.add_parameter("Arcs",
                        arcs,
                        "Boundary groups that are arcs of circles: 'group: "
                        "centre x, centre y, radius' [mm], separated by ';'; "
                        "in the coordinates of the file.");
      prm.add_parameter("Move",
                        move,
                        "'body: dx, dy' [mm], separated by ';'; shifts a body "
                        "against the others, in the coordinates of the file. "
                        "Its arcs move with it.");
      prm.add_parameter("Scale",
                        scale,
                        "Factor of all lengths of the file and of Move [-]; > "
                        "0.");
      prm.add_parameter("Rotation",
                        rotation,
                        "Turns the whole mesh about the origin, anticlockwise, "
                        "after Scale [degrees].");
      prm.add_parameter("Shift",
                        shift,
                        "'x, y' [mm]; shifts the whole mesh, after Rotation.");
      prm.leave_subsection();
    }



    void Element::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Element");
      prm.add_parameter("Degree",
                        degree,
                        "Polynomial degree of the displacements [-].",
                        Patterns::Integer(1, 2));
      prm.add_parameter("Centre node",
                        centre_node,
                        "The node in the middle of a quadrilateral of degree "
                        "2 [-]; bound: half the sum of the mid-sides minus a "
                        "quarter of the sum of the corners (8-node element), "
                        "free: an unknown (9-node element).",
                        Patterns::Selection("bound|free"));
      prm.leave_subsection();
    }



    void Solids::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Solids");
      prm.add_parameter("Young's modulus",
                        young,
                        "'body: E' [MPa], separated by ','; E > 0.");
      prm.add_parameter("Poisson's ratio",
                        poisson,
                        "'body: nu' [-], separated by ','; the same bodies "
                        "as in Young's modulus, -1 < nu < 0.5.");
      prm.add_parameter("Symmetry",
                        symmetry,
                        "What the mesh is a section of [-]; plane strain: a "
                        "slice of 1 mm; axisymmetric: rings about the axis x "
                        "= 0, x >= 0 being the radius, without torsion. Forces "
                        "are then those of whole rings [N], stress zz is that "
                        "of the hoops, and u_x = 0 on the axis.",
                        Patterns::Selection("plane strain|axisymmetric"));
      prm.add_parameter("Kinematics",
                        kinematics,
                        "How the bodies move [-]; large displacement: Green "
                        "strain and rotations of any size, small strain: "
                        "linear.",
                        Patterns::Selection("small strain|"
                                            "large displacement"));
      prm.add_parameter(
        "Dilatation",
        dilatation,
        "The trace of the strain in a cell [-]; full: as it is, "
        "projected: its mean, in quadrangles of degree 2 its linear "
        "part, against locking, automatic: projected for bodies "
        "with nu > 5/11. Triangles of degree 1 lock either way.",
        Patterns::Selection("automatic|full|projected"));
      prm.leave_subsection();
    }



    void Boundary::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Boundary conditions");
      prm.add_parameter("Displacement x",
                        displacement_x,
                        "'group: value' [mm], separated by ','; a boundary "
                        "or point group and its displacement at full load.");
      prm.add_parameter("Displacement y",
                        displacement_y,
                        "As Displacement x, in direction y [mm].");
      prm.add_parameter("Tied y",
                        tied_y,
                        "'point: point' [-], separated by ','; the first "
                        "point group moves in y as the second one does.");
      prm.add_parameter("Force x",
                        force_x,
                        "'point: value' [N per mm of thickness; axisymmetric: "
                        "N on the ring], separated by ','; a point group and "
                        "its dead force at full load.");
      prm.add_parameter(
        "Force y",
        force_y,
        "As Force x, in direction y [N per mm of thickness; axisymmetric: N].");
      prm.add_parameter("Spread force x",
                        spread_force_x,
                        "'boundary: value' [N per mm of thickness; "
                        "axisymmetric: N on all rings], separated by ','; a "
                        "boundary group and its dead force at full load, "
                        "spread evenly over its undeformed area. Of a nodal "
                        "force the finer mesh sees the singularity.");
      prm.add_parameter(
        "Spread force y",
        spread_force_y,
        "As Spread force x, in direction y [N per mm of thickness; "
        "axisymmetric: N].");
      const Patterns::Map formulas(Patterns::Anything(),
                                   Patterns::Anything(),
                                   0,
                                   Patterns::Map::max_int_value,
                                   ";");
      prm.add_parameter("Pressure",
                        pressure,
                        "'boundary: formula' [MPa], separated by ';'; a "
                        "boundary group and the pressure on it at full load, a "
                        "formula in x and y [mm], positive in compression. It "
                        "acts along the normal of the undeformed boundary.",
                        formulas);
      prm.add_parameter("Traction x",
                        traction_x,
                        "'boundary: formula' [MPa], separated by ';'; a "
                        "boundary group and the force on it by undeformed "
                        "area at full load, a formula in x and y [mm].",
                        formulas);
      prm.add_parameter("Traction y",
                        traction_y,
                        "As Traction x, in direction y [MPa].",
                        formulas);
      prm.add_parameter("Body force x",
                        body_force_x,
                        "'body: formula' [N/mm^3], separated by ';'; a body "
                        "and the force on it by undeformed volume at full "
                        "load, a formula in x and y [mm].",
                        formulas);
      prm.add_parameter("Body force y",
                        body_force_y,
                        "As Body force x, in direction y [N/mm^3]; weight is "
                        "-density times gravity, of steel -7.7e-5.",
                        formulas);
      prm.add_parameter("Histories",
                        histories,
                        "'entry: formula' [-], separated by ';'; an entry of "
                        "this section, and the factor of all its values as a "
                        "formula in the load factor t from 0 to 1, as in "
                        "'Force y: min(1, 2*t)', or as a table of t and the "
                        "factor, linear in between and constant beyond, as in "
                        "'Force y: table(0 0, 0.5 1, 1 -1)'. Without: t.",
                        formulas);
      prm.leave_subsection();
    }



    void Contact::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection(section());
      prm.add_parameter("Slave",
                        slave,
                        "Boundary group that carries the contact points [-]; "
                        "empty, together with Master: no contact. More zones "
                        "have sections of their own, 'Contact NAME', with the "
                        "same entries.");
      prm.add_parameter("Master",
                        master,
                        "Boundary group they are projected on [-].");
      prm.add_parameter("Obstacle",
                        obstacle,
                        "A rigid master without a mesh, instead of Master "
                        "[mm]: 'half plane: x, y, normal x, normal y', a point "
                        "and the outward normal, or 'circle: x, y, radius', "
                        "negative for a hole.");
      prm.add_parameter("Rule",
                        rule,
                        "Where the contact points are [-]; nodal: in the nodes "
                        "of the slave; Gauss: in the Gauss points of its "
                        "faces; mortar: in the nodes, with gaps that are "
                        "weighted along the surface by dual functions.",
                        Patterns::Selection("nodal|Gauss|mortar"));
      prm.add_parameter("Gauss points",
                        n_gauss_points,
                        "Gauss points per slave face [-]; only for the rule "
                        "Gauss.",
                        Patterns::Integer(1, 10));
      prm.add_parameter("Excluded points",
                        excluded_points,
                        "Point groups of the slave surface that carry no "
                        "contact point [-], separated by ','; for the rules "
                        "nodal and mortar.");
      prm.add_parameter("Tied",
                        tied,
                        "Glue the slave to the master wherever it faces it, "
                        "instead of contact [-]: what the same bodies cost "
                        "without contact; rule nodal or mortar.");
      prm.add_parameter("Friction coefficient",
                        friction_coefficient,
                        "Coulomb's coefficient of friction [-]; 0: none.",
                        Patterns::Double(0));
      prm.add_parameter("Tresca limit",
                        tresca_limit,
                        "Bound of the tangential traction that does not "
                        "depend on the pressure [MPa]; 0: none.",
                        Patterns::Double(0));
      prm.add_parameter("Complementarity",
                        complementarity,
                        "Parameter c of the augmented Lagrangian p = max(0, "
                        "lambda - c gap), by the stiffness E/h of the slave's "
                        "edge [-]; > 0. Results of the rules nodal and mortar "
                        "do not depend on it, those of the rule Gauss do.");
      prm.leave_subsection();
    }



    void Solution::add_parameters(ParameterHandler &prm)
    {
      const Patterns::Integer   at_least_one(1);
      const Patterns::Selection loop("fixed point|each step|Newton");
      const Patterns::Selection geometry_loop(
        "undeformed|fixed point|each step|Newton");

      prm.enter_subsection("Solution");
      prm.add_parameter("Increments",
                        n_increments,
                        "Equal steps to the full load [-].",
                        at_least_one);
      prm.add_parameter("Max cut-backs",
                        max_cuts,
                        "How often an increment that does not converge is cut "
                        "in half before giving up [-]; 0: never. Behind it "
                        "the steps grow again.",
                        Patterns::Integer(0, 20));
      prm.add_parameter("Geometry",
                        geometry,
                        "How projections and normals follow the displacements "
                        "[-]; undeformed: not at all, as theories of small "
                        "displacements have it (kinematics small strain); "
                        "fixed point: in a loop of their own; each step: "
                        "renewed before each Newton step; Newton: with the "
                        "displacements, in the tangent as well (rules nodal "
                        "and Gauss, saddle point system).",
                        geometry_loop);
      prm.add_parameter(
        "Geometry tolerance",
        geometry_tolerance,
        "Largest change of a displacement in one turn of the geometry loop, "
        "relative to the largest displacement of the increment before that "
        "turn [-]; > 0. The first turn is never accepted.");
      prm.add_parameter("Max geometry iterations",
                        max_geometry_iterations,
                        "Turns of the geometry loop before giving up [-].",
                        at_least_one);
      prm.add_parameter("Friction",
                        friction,
                        "How the bound of friction follows the pressure [-]; "
                        "fixed point: in a loop of its own; each step: "
                        "renewed before each Newton step; Newton: with the "
                        "displacements, in the tangent as well (saddle point "
                        "system).",
                        loop);
      prm.add_parameter(
        "Friction tolerance",
        friction_tolerance,
        "Largest change of a bound of the shear traction in one turn of the "
        "friction loop, relative to the largest bound [-]; > 0.");
      prm.add_parameter("Max friction iterations",
                        max_friction_iterations,
                        "Turns of the friction loop before giving up [-].",
                        at_least_one);
      prm.add_parameter("Newton tolerance",
                        newton_tolerance,
                        "Residual of equilibrium and of the contact "
                        "constraints, relative to the load [-]; > 0.");
      prm.add_parameter("Max Newton iterations",
                        max_newton_iterations,
                        "Newton iterations before giving up [-].",
                        at_least_one);
      prm.add_parameter("Linear tolerance",
                        linear_tolerance,
                        "How far conjugate gradients are driven in a Newton "
                        "step, relative to the residual of that [-]; > 0, < "
                        "1.");
      prm.add_parameter("System",
                        system,
                        "The linear system [-]; saddle point: with the "
                        "multipliers; condensed: without, symmetric positive "
                        "definite, for the rules nodal and mortar; automatic: "
                        "condensed for the rule mortar, with several levels, "
                        "with several processes, with another solver than "
                        "UMFPACK and without contact, otherwise saddle "
                        "point.",
                        Patterns::Selection("automatic|saddle point|"
                                            "condensed"));
      prm.add_parameter("Linear solver",
                        linear_solver,
                        "UMFPACK for saddle point systems; for condensed ones "
                        "CHOLMOD, AMG (conjugate gradients with smoothed "
                        "aggregation) or MUMPS [-]; automatic: UMFPACK, or "
                        "CHOLMOD below 100000 unknowns on one rank and AMG "
                        "beyond.",
                        Patterns::Selection("automatic|UMFPACK|CHOLMOD|AMG|"
                                            "MUMPS"));
      prm.leave_subsection();
    }



    void Refinement::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Refinement");
      prm.add_parameter("Levels",
                        n_levels,
                        "How often the mesh is refined after a solution, which "
                        "is carried over [-].",
                        Patterns::Integer(0));
      prm.add_parameter("Strategy",
                        strategy,
                        "uniform: all cells; adaptive: the cells with the "
                        "largest estimated errors, for meshes of quadrangles "
                        "[-].",
                        Patterns::Selection("uniform|adaptive"));
      prm.add_parameter("Fraction",
                        fraction,
                        "The share of the estimated error (squared) that is in "
                        "the cells to refine [-]; > 0, <= 1; only for "
                        "adaptive.",
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
      prm.add_parameter("Probes",
                        probes,
                        "Values to report: 'name: quantity, point', separated "
                        "by ';'; with a second point group, as in 'name: "
                        "quantity, point, point', the value at the first minus "
                        "the value at the second. One of: " +
                          Patterns::Tools::to_string(quantities) +
                          " [displacements: mm, stresses: MPa]; pressure "
                          "and shear are those of contact, at points of a "
                          "slave.");
      prm.add_parameter("References",
                        references,
                        "'name: value', separated by ','; what a probe is "
                        "compared with, in its unit [mm or MPa].");
      prm.add_parameter("Tolerances",
                        tolerances,
                        "'name: value', separated by ','; the deviation from "
                        "the reference that is accepted, relative to it [-]; "
                        "> 0.");
      prm.add_parameter("Hertz",
                        hertz,
                        "Line contact of Hertz to compare with: 'radius, "
                        "force' [mm, N per mm of thickness, of the full "
                        "cylinder], or 'radius': under the force that is "
                        "found, of models without a line of symmetry. Empty: "
                        "none.");
      prm.add_parameter("Frictional theory",
                        frictional_theory,
                        "Compare a contact of Hertz with Coulomb's friction "
                        "with a theory that knows it [-]: Cattaneo and "
                        "Mindlin's where the bodies are alike, otherwise two "
                        "half planes under the same increments; right only if "
                        "the contact is small beside the radius.");
      prm.add_parameter("Concentric cylinders",
                        concentric_cylinders,
                        "A cylinder in a ring about the origin to compare "
                        "with: 'bore, radius of contact, outer radius, "
                        "pressure, amplitude' [mm, MPa], under the pressure "
                        "'pressure + amplitude cos(2 theta)' outside, small "
                        "strain, no friction. Empty: none.");
      prm.add_parameter("Estimate errors",
                        estimate_errors,
                        "Estimate the discretization error of the probes [-]. "
                        "With several levels that costs nothing and is always "
                        "done; without, the case is solved once more on the "
                        "mesh refined once.");
      prm.leave_subsection();
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
                        "What is printed [-]; full: all iterations and the "
                        "table of results, table: the table, none: nothing.",
                        Patterns::Selection("full|table|none"));
      prm.add_parameter("VTU",
                        vtu,
                        "Whether displacements and stresses of each increment "
                        "are written for ParaView [-].");
      prm.add_parameter("Profile",
                        profile,
                        "Whether pressure, shear, gap and slip along both "
                        "surfaces are written at the end [-].");
      prm.leave_subsection();
    }



    void All::add_zone(const std::string &name, ParameterHandler &prm)
    {
      Contact &zone = further_contacts[name];
      zone.name     = name;
      zone.add_parameters(prm);
    }



    std::vector<Contact> All::zones() const
    {
      std::vector<Contact> zones;
      if (contact.is_zone())
        zones.push_back(contact);
      for (const auto &further : further_contacts)
        if (further.second.is_zone())
          zones.push_back(further.second);
      return zones;
    }



    void All::add_parameters(ParameterHandler &prm)
    {
      mesh.add_parameters(prm);
      element.add_parameters(prm);
      solids.add_parameters(prm);
      boundary.add_parameters(prm);
      contact.add_parameters(prm);
      solution.add_parameters(prm);
      refinement.add_parameters(prm);
      probes.add_parameters(prm);
      output.add_parameters(prm);
    }
  } // namespace Parameters



  void read_parameters(const std::filesystem::path    &file,
                       const std::vector<std::string> &overrides,
                       ParameterHandler               &prm,
                       Parameters::All                &parameters)
  {
    prm.clear();
    parameters      = Parameters::All();
    parameters.name = file.stem().string();
    parameters.add_parameters(prm);

    ParameterReader reader(prm, "Contact", [&](const std::string &name) {
      parameters.add_zone(name, prm);
    });
    reader.read_file(file);
    for (const std::string &assignment : overrides)
      reader.read_override(assignment);
    reader.resolve_path("Mesh", "File");

    // The checks know the entries, the reader knows where they were set.
    try
      {
        parameters.check();
      }
    catch (const EntryError &error)
      {
        throw InputError(error.problem,
                         reader.where(error.entries),
                         error.remedy);
      }
  }



  void print_parameters(std::ostream &out)
  {
    Parameters::All  parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);

    std::string section;
    for (const DeclaredEntry &entry : declared_entries(prm))
      {
        if (section.empty())
          out << "subsection " << entry.section << '\n';
        else if (section != entry.section)
          out << "end\n\n\n\nsubsection " << entry.section << '\n';
        else
          out << '\n';
        print_entry(entry, out);
        section = entry.section;
      }
    out << "end\n";
  }
} // namespace Contact
