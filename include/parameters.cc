/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "parameter_file.h"

namespace Contact
{
  namespace
  {
    using Names = std::vector<std::string>;

    /// What a probe can look at; the one list for checking and documenting.
    const Names probe_quantities = {"displacement x",
                                    "displacement y",
                                    "stress xx",
                                    "stress yy",
                                    "stress zz",
                                    "stress xy",
                                    "von Mises"};



    std::string joined(const Names &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text;
    }



    std::string in_quotes(const std::string &name)
    {
      return "'" + name + "'";
    }



    // Patterns know closed intervals only, and a tolerance of zero is never
    // reached.
    void check_positive(const double value, const std::string &entry)
    {
      if (!(value > 0))
        throw EntryError(entry + " is " + Utilities::to_string(value) +
                           ", but has to be positive.",
                         {entry},
                         "set a value greater than 0");
    }



    // The keys of one map have to be keys of another one as well.
    template<typename A, typename B>
    void check_keys(const std::map<std::string, A> &map,
                    const std::string              &entry,
                    const std::map<std::string, B> &other,
                    const std::string              &other_entry)
    {
      for (const auto &[key, value] : map)
        if (other.count(key) == 0)
          throw EntryError(in_quotes(key) + " is in " + entry +
                             ", but not in " + other_entry + ".",
                           {entry, other_entry},
                           "add " + in_quotes(key) + " to " + other_entry +
                             " or remove it from " + entry);
    }



    // Two entries that act on the same group although only one of them can.
    template<typename A, typename B>
    void check_disjoint(const std::map<std::string, A> &map,
                        const std::string              &entry,
                        const std::map<std::string, B> &other,
                        const std::string              &other_entry)
    {
      for (const auto &[key, value] : map)
        if (other.count(key) > 0)
          throw EntryError(in_quotes(key) + " is in " + entry + " and in " +
                             other_entry + ", which contradict each other.",
                           {entry, other_entry},
                           "remove " + in_quotes(key) + " from one of the two");
    }



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



  EntryError::EntryError(const std::string              &problem,
                         const std::vector<std::string> &entries,
                         const std::string              &remedy)
    : InputError(problem, joined(entries), remedy)
    , problem(problem)
    , entries(entries)
    , remedy(remedy)
  {
  }



  namespace Parameters
  {
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
                        "centre x, centre y, radius' [mm], separated by ';'.");
      prm.leave_subsection();
    }



    void Mesh::check() const
    {
      const std::string entry = "Mesh/Arcs";
      if (file.empty())
        throw EntryError("There is no mesh.",
                         {"Mesh/File"},
                         "set 'File' in section 'Mesh' to a gmsh file");
      for (const auto &[group, arc] : arcs)
        if (arc.size() != 3 || !(arc[2] > 0))
          throw EntryError("The arc " + in_quotes(group) + " is not a circle.",
                           {entry},
                           "write '" + group +
                             ": centre x, centre y, radius' with a positive "
                             "radius");
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



    void Element::check() const
    {
      if (degree == 1 && centre_node == "free")
        throw EntryError("An element of degree 1 has no centre node to free.",
                         {"Element/Centre node", "Element/Degree"},
                         "set 'Degree = 2' for the 9-node element, or "
                         "'Centre node = bound'");
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
      prm.add_parameter("Kinematics",
                        kinematics,
                        "How the bodies move [-]; large displacement: Green "
                        "strain and rotations of any size, small strain: "
                        "linear.",
                        Patterns::Selection("small strain|"
                                            "large displacement"));
      prm.leave_subsection();
    }



    void Solids::check() const
    {
      const std::string E  = "Solids/Young's modulus";
      const std::string nu = "Solids/Poisson's ratio";
      check_keys(young, E, poisson, nu);
      check_keys(poisson, nu, young, E);
      if (young.empty())
        throw EntryError("No body has a material.",
                         {E, nu},
                         "set both, as in 'set Young's modulus = Block: "
                         "70000'");
      for (const auto &[body, value] : young)
        if (!(value > 0))
          throw EntryError("Young's modulus of " + in_quotes(body) +
                             " is not positive.",
                           {E},
                           "set a positive value in MPa");
      for (const auto &[body, value] : poisson)
        if (!(value > -1 && value < 0.5))
          throw EntryError("Poisson's ratio of " + in_quotes(body) +
                             " is not between -1 and 0.5.",
                           {nu},
                           "set a value greater than -1 and less than 0.5");
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
                        "'point: value' [N per mm of thickness], separated "
                        "by ','; a point group and its dead force at full "
                        "load.");
      prm.add_parameter("Force y",
                        force_y,
                        "As Force x, in direction y [N per mm of thickness].");
      prm.add_parameter("Spread force x",
                        spread_force_x,
                        "'boundary: value' [N per mm of thickness], separated "
                        "by ','; a boundary group and its dead force at full "
                        "load, spread evenly over its undeformed length. Of a "
                        "nodal force the finer mesh sees the singularity.");
      prm.add_parameter("Spread force y",
                        spread_force_y,
                        "As Spread force x, in direction y [N per mm of "
                        "thickness].");
      prm.leave_subsection();
    }



    void Boundary::check() const
    {
      const std::string section = "Boundary conditions/";
      check_disjoint(force_x,
                     section + "Force x",
                     displacement_x,
                     section + "Displacement x");
      check_disjoint(force_y,
                     section + "Force y",
                     displacement_y,
                     section + "Displacement y");
      check_disjoint(tied_y,
                     section + "Tied y",
                     displacement_y,
                     section + "Displacement y");
      for (const auto &[follower, leader] : tied_y)
        if (tied_y.count(leader) > 0)
          throw EntryError(in_quotes(follower) + " is tied to " +
                             in_quotes(leader) + ", which is tied itself.",
                           {section + "Tied y"},
                           "tie points to one that is not tied");
    }



    void Contact::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Contact");
      prm.add_parameter("Slave",
                        slave,
                        "Boundary group that carries the contact points [-]; "
                        "empty, together with Master: no contact.");
      prm.add_parameter("Master",
                        master,
                        "Boundary group they are projected on [-].");
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
      prm.leave_subsection();
    }



    void Contact::check() const
    {
      const Names surfaces = {"Contact/Slave", "Contact/Master"};
      if (slave.empty() != master.empty())
        throw EntryError("Contact takes two surfaces, but there is only one.",
                         surfaces,
                         "set both, or none for a case without contact");
      if (!slave.empty() && slave == master)
        throw EntryError("The slave and the master are both " +
                           in_quotes(slave) + ".",
                         surfaces,
                         "set two different boundary groups");
      check_friction();
      check_excluded_points();
    }



    void Contact::check_friction() const
    {
      const std::string coulomb = "Contact/Friction coefficient";
      const std::string tresca  = "Contact/Tresca limit";
      if (slave.empty() && frictional())
        throw EntryError("There is friction, but no contact.",
                         {friction_coefficient > 0 ? coulomb : tresca,
                          "Contact/Slave",
                          "Contact/Master"},
                         "set slave and master, or no friction");
      if (friction_coefficient > 0 && tresca_limit > 0)
        throw EntryError("There are two laws of friction.",
                         {coulomb, tresca},
                         "set one of the two to 0");
    }



    void Contact::check_excluded_points() const
    {
      const std::string entry = "Contact/Excluded points";
      if (excluded_points.empty())
        return;
      if (slave.empty())
        throw EntryError("Points are excluded from contact, but there is "
                         "none.",
                         {entry, "Contact/Slave"},
                         "set slave and master, or leave the points empty");
      if (rule == "Gauss")
        throw EntryError("Gauss points are inside the faces: there is none to "
                         "exclude at a point group.",
                         {entry, "Contact/Rule"},
                         "set 'Rule = nodal', or leave the points empty");
      if (std::set<std::string>(excluded_points.begin(), excluded_points.end())
              .size() < excluded_points.size() ||
          std::count(excluded_points.begin(), excluded_points.end(), "") > 0)
        throw EntryError("A point group is excluded twice or has no name.",
                         {entry},
                         "write each group once, separated by ','");
    }



    void Solution::add_parameters(ParameterHandler &prm)
    {
      const Patterns::Integer   at_least_one(1);
      const Patterns::Selection loop("fixed point|each step|Newton");


      prm.enter_subsection("Solution");
      prm.add_parameter("Increments",
                        n_increments,
                        "Equal steps to the full load [-].",
                        at_least_one);
      prm.add_parameter("Geometry",
                        geometry,
                        "How projections and normals follow the displacements "
                        "[-]; fixed point: in a loop of their own; each step: "
                        "renewed before each Newton step; Newton: with the "
                        "displacements, in the tangent as well (rules nodal "
                        "and Gauss, saddle point system).",
                        loop);
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



    void Refinement::check() const
    {
      check_positive(fraction, "Refinement/Fraction");
      check_positive(tolerance, "Refinement/Tolerance");
    }



    void Solution::check() const
    {
      check_positive(geometry_tolerance, "Solution/Geometry tolerance");
      check_positive(friction_tolerance, "Solution/Friction tolerance");
      check_positive(newton_tolerance, "Solution/Newton tolerance");
    }



    void Probes::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Probes");
      prm.add_parameter("Probes",
                        probes,
                        "Values to report: 'name: quantity, point', separated "
                        "by ';'; a point group and one of: " +
                          joined(probe_quantities) +
                          " [displacements: mm, stresses: MPa].");
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
                        "Line contact of Hertz to compare the pressure with: "
                        "'radius, force' [mm, N per mm of thickness, of the "
                        "full cylinder]; empty: none.");
      prm.leave_subsection();
    }



    void Probes::check() const
    {
      check_quantities();
      check_references();
      if (hertz.empty())
        return;
      if (hertz.size() != 2 || !(hertz[0] > 0) || !(hertz[1] > 0))
        throw EntryError("A Hertz contact takes two positive values.",
                         {"Probes/Hertz"},
                         "write 'radius, force per mm', or leave it empty");
    }



    void Probes::check_quantities() const
    {
      for (const auto &[name, probe] : probes)
        {
          if (probe.size() != 2 || probe[1].empty())
            throw EntryError("The probe " + in_quotes(name) +
                               " is not a quantity and a point.",
                             {"Probes/Probes"},
                             "write '" + name + ": quantity, point'");
          if (std::count(probe_quantities.begin(),
                         probe_quantities.end(),
                         probe[0]) == 0)
            throw EntryError("The probe " + in_quotes(name) +
                               " looks at an unknown quantity, " +
                               in_quotes(probe[0]) + ".",
                             {"Probes/Probes"},
                             "choose one of: " + joined(probe_quantities));
        }
    }



    void Probes::check_references() const
    {
      const std::string reference = "Probes/References";
      const std::string tolerance = "Probes/Tolerances";
      check_keys(references, reference, probes, "Probes/Probes");
      check_keys(references, reference, tolerances, tolerance);
      check_keys(tolerances, tolerance, references, reference);
      for (const auto &[name, value] : references)
        if (value == 0)
          throw EntryError("The reference of " + in_quotes(name) +
                             " is 0: nothing can be compared relatively to it.",
                           {reference},
                           "probe a value that is not 0");
      for (const auto &[name, value] : tolerances)
        if (!(value > 0))
          throw EntryError("The tolerance of " + in_quotes(name) +
                             " is not positive.",
                           {tolerance},
                           "set a value greater than 0");
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
                        "Whether displacements and stresses are written for "
                        "ParaView [-].");
      prm.add_parameter("Profile",
                        profile,
                        "Whether the pressure along the slave surface is "
                        "written [-].");
      prm.leave_subsection();
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



    void All::check() const
    {
      mesh.check();
      element.check();
      solids.check();
      boundary.check();
      contact.check();
      solution.check();
      refinement.check();
      probes.check();

      if (!probes.hertz.empty() && contact.slave.empty())
        throw EntryError("There is no contact pressure to compare with Hertz.",
                         {"Probes/Hertz", "Contact/Slave"},
                         "set slave and master, or leave Hertz empty");
      check_system();
    }



    bool All::is_condensed() const
    {
      if (solution.system != "automatic")
        return solution.system == "condensed";
      if (solution.linear_solver != "automatic")
        return solution.linear_solver != "UMFPACK";
      return contact.slave.empty() || contact.rule == "mortar" ||
             contact.tied || refinement.n_levels > 0 || n_ranks > 1;
    }



    // What goes with which linear system.
    void All::check_system() const
    {
      const std::string system = "Solution/System";
      const std::string solver = "Solution/Linear solver";
      const std::string rule   = "Contact/Rule";
      const auto        clash  = [](const std::string &problem,
                            const Names       &entries,
                            const std::string &remedy) {
        throw EntryError(problem, entries, remedy);
      };

      if (n_ranks > 1 && !contact.slave.empty() && contact.rule == "Gauss")
        clash("The rule Gauss is solved by one process, here are " +
                std::to_string(n_ranks) + ".",
              {rule},
              "run it without mpirun, or set 'Rule = mortar' or 'Rule = "
              "nodal'");
      if (n_ranks > 1 && solution.linear_solver == "CHOLMOD")
        clash("CHOLMOD works in one process, here are " +
                std::to_string(n_ranks) + ".",
              {solver},
              "set 'Linear solver = AMG' or 'Linear solver = MUMPS'");

      if (!is_condensed())
        {
          if (n_ranks > 1)
            clash("A saddle point system is solved by one process.",
                  {system},
                  "run it without mpirun, or set 'System = condensed'");
          if (contact.frictional() && solution.friction == "each step")
            clash("With multipliers the bound follows in a loop or in the "
                  "tangent.",
                  {"Solution/Friction", system},
                  "set 'Friction = Newton', or 'System = condensed'");
          if (solution.linear_solver != "automatic" &&
              solution.linear_solver != "UMFPACK")
            clash("A saddle point system is not positive definite: " +
                    solution.linear_solver + " can not solve it.",
                  {solver, system},
                  "set 'Linear solver = UMFPACK', or 'System = condensed'");
          if (contact.tied)
            clash("Tied surfaces have no saddle point system.",
                  {"Contact/Tied", system},
                  "set 'System = condensed'");
          if (refinement.n_levels > 0)
            clash("Nested iteration needs the condensed system.",
                  {"Refinement/Levels", system},
                  "set 'System = condensed', with the rule nodal or mortar, or "
                  "refine the first mesh with Mesh/Refinements");
          if (contact.rule == "mortar" && solution.geometry == "Newton")
            clash("The tangent does not know how mortar segments move.",
                  {"Solution/Geometry", rule},
                  "set 'Geometry = each step'");
          return;
        }

      if (solution.linear_solver == "UMFPACK")
        clash("UMFPACK is for saddle point systems.",
              {solver, system},
              "set 'Linear solver = CHOLMOD'");
      if (!contact.slave.empty() && contact.rule == "Gauss")
        clash("The multipliers of the rule Gauss can not be eliminated: " +
                (solution.linear_solver == "automatic"
                   ? "a condensed system"
                   : solution.linear_solver) +
                " is not for it.",
              {rule,
               solution.system != "automatic"          ? system
               : solution.linear_solver != "automatic" ? solver
                                                       : "Refinement/Levels"},
              "set 'Rule = mortar' or 'Rule = nodal'; the rule Gauss takes "
              "'System = saddle point' and UMFPACK");
      if (!contact.slave.empty() && solution.geometry == "Newton")
        clash("The condensed system does not know how projections move.",
              {"Solution/Geometry", system},
              "set 'Geometry = each step'");
      if (contact.frictional() && solution.friction == "Newton")
        clash("With the bound in the tangent the condensed system would not be "
              "symmetric.",
              {"Solution/Friction", system},
              "set 'Friction = each step'");
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

    ParameterReader reader(prm);
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
