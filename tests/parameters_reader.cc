/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Parameter files are read as documented, and every rule about them is
// enforced with a message that says what, where and how to remedy it.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "parameters/parameter_file.h"
#include "parameters/parameters.h"

using namespace dealii;

namespace
{
  using Names = std::vector<std::string>;

  // The entries that every case needs. Tests set more after it.
  const std::string base = "subsection Mesh\n"
                           "  set File = a.msh\n"
                           "end\n"
                           "subsection Solids\n"
                           "  set Young's modulus = Block: 70000\n"
                           "  set Poisson's ratio = Block: 0.3\n"
                           "end\n";



  void write(const std::string &file, const std::string &text)
  {
    std::filesystem::create_directories("files/sub");
    std::ofstream("files/" + file) << text;
  }



  struct Case
  {
    ParameterHandler         prm;
    Contact::Parameters::All parameters;
    std::string              error;

    explicit Case(const std::string &file, const Names &overrides = {})
    {
      try
        {
          Contact::read_parameters("files/" + file, overrides, prm, parameters);
        }
      catch (const Contact::InputError &exception)
        {
          error = exception.what();
        }
    }
  };



  void headline(const std::string &text)
  {
    std::cout << "\n=== " << text << "\n";
  }



  void report(const std::string &file, const Names &overrides = {})
  {
    const Case result(file, overrides);
    std::cout << (result.error.empty() ? "accepted" : result.error) << "\n\n";
  }



  // The base and one more line in one section, and what becomes of it.
  void report_lines(const std::string &section, const std::string &lines)
  {
    write("base.prm", base);
    write("case.prm",
          "include base.prm\nsubsection " + section + "\n" + lines + "\nend\n");
    report("case.prm");
  }



  // The mesh file is stored as an absolute path, which the test can not
  // compare: it is printed relative to the working directory.
  std::string mesh_file(const Case &result)
  {
    const std::filesystem::path file = result.parameters.mesh.file;
    return (file.is_absolute() ? "absolute, " : "RELATIVE, ") +
           file.lexically_relative(std::filesystem::current_path()).string();
  }



  void print_values(const Case &result)
  {
    const auto &p = result.parameters;
    std::cout << "name: " << p.name << "\nmesh: " << mesh_file(result) << ' '
              << p.mesh.refinements << '\n';
    for (const auto &[group, arc] : p.mesh.arcs)
      std::cout << "arc: " << group << ' ' << arc[0] << ' ' << arc[1] << ' '
                << arc[2] << '\n';
    std::cout << "element: " << p.element.degree << ' '
              << p.element.centre_node.name()
              << "\nsolids: " << p.solids.youngs_modulus.at("Block") << ' '
              << p.solids.poisson.at("Block") << ' '
              << p.solids.kinematics.name()
              << "\nboundary: " << p.boundary.displacement_x.at("Encast") << ' '
              << p.boundary.tied_y.at("C") << ' ' << p.boundary.force_y.size()
              << "\ncontact: " << p.contact.slave << ' ' << p.contact.master
              << ' ' << p.contact.discretization.name() << ' '
              << p.contact.n_gauss_points << ' '
              << p.contact.excluded_points.at(1) << ' '
              << p.contact.friction_coefficient << ' ' << p.contact.tresca_limit
              << "\nsolution: " << p.solution.n_increments << ' '
              << p.solution.geometry.name() << ' '
              << p.solution.geometry_tolerance << ' '
              << p.solution.friction.name() << ' '
              << p.solution.friction_tolerance
              << "\nprobes: " << p.probes.probes.at("S(B)").at(0) << ' '
              << p.probes.probes.at("S(B)").at(1) << ' '
              << p.probes.references.at("DY(B)") << ' '
              << p.probes.tolerances.at("DY(B)") << ' ' << p.probes.hertz.at(1)
              << "\noutput: " << p.output.directory << ' '
              << p.output.screen.name() << ' ' << p.output.vtu << ' '
              << p.output.profile << '\n';
  }



  // Proves that values of every kind arrive in the structures.
  void test_values()
  {
    headline("values");
    write("values.prm",
          base + "subsection Mesh\n"
                 "  set Refinements = 2\n"
                 "  set Arcs = Bottom_C: 0, 50, 50; Other: 1, 2, 3\n"
                 "end\n"
                 "subsection Element\n"
                 "  set Degree = 2\n"
                 "  set Centre node = free\n"
                 "end\n"
                 "subsection Boundary conditions\n"
                 "  set Displacement x = Axe: 0, Encast: -0.5\n"
                 "  set Tied y = C: B\n"
                 "end\n"
                 "subsection Contact\n"
                 "  set Slave = S\n"
                 "  set Master = M\n"
                 "  set Discretization = nodal\n"
                 "  set Excluded points = C, D\n"
                 "  set Friction coefficient = 0.1\n"
                 "end\n"
                 "subsection Solution\n"
                 "  set Geometry = Newton\n"
                 "  set Geometry tolerance = 1e-3\n"
                 "end\n"
                 "subsection Probes\n"
                 "  set Probes = DY(B): displacement y, B; S(B): stress yy, B\n"
                 "  set References = DY(B): -1.5\n"
                 "  set Tolerances = DY(B): 0.001\n"
                 "  set Hertz = 50, 35000\n"
                 "end\n"
                 "subsection Output\n"
                 "  set Screen = none\n"
                 "  set VTU = true\n"
                 "end\n");
    const Case result("values.prm");
    std::cout << result.error;
    print_values(result);
  }



  // Proves that comments, joined lines, blanks and tabs, and upper-case
  // keywords are read as ParameterHandler reads them.
  void test_syntax()
  {
    headline("syntax");
    write("syntax.prm",
          base + "# a comment \n"
                 "\n"
                 "SUBSECTION Contact # another one\n"
                 "\t set\tGauss   points\t=  5 # and another one\n"
                 "END\n"
                 "subsection Boundary conditions\n"
                 "  set Force y = A: 1, \\\n"
                 "                B: 2  \\\n"
                 "                # nothing more\n"
                 "  set Force x = A: 3 # this joins the next line as well \\\n"
                 "  this is part of the comment\n"
                 "end");
    const Case result("syntax.prm");
    std::cout << result.error << result.parameters.contact.n_gauss_points << ' '
              << result.parameters.boundary.force_y.size() << ' '
              << result.parameters.boundary.force_x.size() << '\n';

    // The line of a joined statement is its first one.
    report_lines("Boundary conditions", "  set Force y = A: 1, \\\n B 2");
  }



  // Proves that paths are relative to the file they are in, and that what is
  // read later wins, be it an include, the file itself or the command line.
  void test_include()
  {
    headline("include");
    write("sub/mesh.prm", "subsection Mesh\n set File = ../b.msh\nend\n");
    write("sub/both.prm", "include mesh.prm\ninclude two.prm\n");
    write("sub/two.prm", "subsection Solution\n set Increments = 2\nend\n");
    write("three.prm", "subsection Solution\n set Increments = 3\nend\n");
    const std::string four = "subsection Solution\n set Increments = 4\nend\n";

    write("later_include.prm", base + four + "include sub/both.prm\n");
    write("own.prm", base + "include sub/both.prm\n" + four);
    write("two_includes.prm", base + "include sub/two.prm\ninclude three.prm");
    for (const std::string file :
         {"later_include.prm", "own.prm", "two_includes.prm"})
      {
        const Case result(file);
        std::cout << file << ": " << result.error
                  << result.parameters.solution.n_increments << ", "
                  << mesh_file(result) << '\n';
      }

    const Case result("own.prm",
                      {"Solution/Increments=5", " Mesh / File = c.msh"});
    std::cout << "command line: " << result.error
              << result.parameters.solution.n_increments << ", "
              << mesh_file(result) << '\n';

    // An include inside a section continues it.
    write("entries.prm", "set Increments = 6\n");
    write("inside.prm",
          base + "subsection Solution\n include entries.prm\nend\n");
    std::cout << "inside a section: " << Case("inside.prm").error
              << Case("inside.prm").parameters.solution.n_increments << '\n';
  }



  // Proves that files that can not be read are named, with who asks for them.
  void test_files()
  {
    headline("files");
    report("missing.prm");
    report("sub");
    write("asks.prm", base + "include sub/missing.prm\n");
    report("asks.prm");
    write("self.prm", "include self.prm\n");
    report("self.prm");
    write("sub/cycle.prm", "\ninclude ../cycle.prm\n");
    write("cycle.prm", "include sub/cycle.prm\n");
    report("cycle.prm");

    // The same file twice is no cycle.
    write("base.prm", base);
    write("twice.prm", "include base.prm\ninclude base.prm\n");
    report("twice.prm");
  }



  // Proves that an entry is set once per file, and once on the command line.
  void test_twice()
  {
    headline("twice");
    report_lines("Solution", "set Increments = 1\nset Increments = 1");
    report_lines("Contact",
                 "set Gauss points = 3\nend\nsubsection Contact\n"
                 "set Gauss  points = 4");
    report("base.prm", {"Element/Degree=1", "Element/Degree=2"});
    report_lines("Boundary conditions", "set Force y = A: 1, A: 2");
    report_lines("Mesh", "set Arcs = A: 0, 1, 1; A: 0, 2, 2");
  }



  // Proves that unknown names are answered with the nearest one: of the same
  // section first, then of the others, if there is one at all.
  void test_unknown()
  {
    headline("unknown");
    report_lines("Elemnt", "");
    report_lines("Something else", "");
    report_lines("Element", "set Degre = 1");
    report_lines("Element", "set centre NODE = bound");
    report_lines("Element", "set Increments = 1");
    report_lines("Element", "set Something else = 1");
    write("case.prm", "set Degree = 1\n");
    report("case.prm");
  }



  // Proves that sections have to be opened and closed properly.
  void test_structure()
  {
    headline("structure");
    report_lines("Element", "subsection Mesh\nend");
    write("open.prm", base + "subsection Element\n set Degree = 1\n");
    report("open.prm");
    write("stray.prm", base + "end\n");
    report("stray.prm");
    write("closes.prm", "end\n");
    report_lines("Element", "include closes.prm");
    write("opens.prm", "\nsubsection Element\n");
    write("case.prm", base + "include opens.prm\nend\n");
    report("case.prm");
    report_lines("Element", "Degree = 1");
    report_lines("Element", "set Degree 1");
    report_lines("Element", "end of the section");
  }



  // Proves that every kind of pattern tells what it allows.
  void test_patterns()
  {
    headline("patterns");
    report_lines("Element", "set Degree = 3");
    report_lines("Element", "set Degree = ");
    report_lines("Element", "set Centre node = fixed");
    report_lines("Contact", "set Gauss points = 11");
    report_lines("Contact", "set Friction coefficient = -0.1");
    report_lines("Contact", "set Tresca limit = -1");
    report_lines("Solution", "set Increments = 0");
    report_lines("Solution", "set Increments = 1.5");
    report_lines("Solution", "set Newton tolerance = small");
    report_lines("Solids", "set Young's modulus = Block 70000");
    report_lines("Solids", "set Young's modulus = Block: nan");
    report_lines("Mesh", "set Arcs = A: 0, x, 1");
    report_lines("Probes", "set Probes = DY(B), displacement y, B");
    report_lines("Probes", "set Hertz = 50, strong");
    report_lines("Boundary conditions", "set Tied y = C");
    report_lines("Output", "set VTU = perhaps");
  }



  // Proves that meshes and materials are checked beyond their patterns.
  void test_mesh_and_solids()
  {
    headline("mesh and solids");
    report_lines("Mesh", "set File =");
    report_lines("Mesh", "set Arcs = A: 0, 50");
    report_lines("Mesh", "set Arcs = A: 0, 50, 0");
    report_lines("Element", "set Degree = 1\nset Centre node = free");
    report_lines("Element", "set Centre node = free");
    report_lines("Element", "set Degree = 2\nset Centre node = free");
    report_lines("Element", "set Degree = 1");
    report_lines("Solids", "set Young's modulus = Block: 0");
    report_lines("Solids", "set Poisson's ratio = Block: 0.5");
    report_lines("Solids", "set Poisson's ratio = Block: -1");
    report_lines("Solids", "set Young's modulus = Block: 1, Cylinder: 1");
    report_lines("Solids", "set Poisson's ratio = Block: 0, Cylinder: 0");
    report_lines("Solids", "set Young's modulus =\nset Poisson's ratio =");
  }



  // Proves that conditions that contradict each other are refused.
  void test_boundary()
  {
    headline("boundary conditions");
    const std::string section = "Boundary conditions";
    report_lines(section, "set Displacement x = A: 0\nset Force x = A: 1");
    report_lines(section, "set Displacement y = A: 0\nset Force y = A: 1");
    report_lines(section, "set Displacement x = A: 0\nset Force y = A: 1");
    report_lines(section,
                 "set Displacement y = A: 0\nset Resultant force y = A: 1");
    report_lines(section, "set Displacement x = A: 0\nset Traction x = A: 1");
    report_lines(section, "set Displacement y = C: 0\nset Tied y = C: B");
    report_lines(section, "set Displacement y = B: 0\nset Tied y = C: B");
    report_lines(section, "set Tied y = C: C");
    report_lines(section, "set Tied y = C: B, D: C");
  }



  // Proves that contact has two surfaces or none, and that what acts on
  // contact needs one.
  void test_contact()
  {
    headline("contact");
    const std::string pair = "set Slave = S\nset Master = M\n";
    report_lines("Contact", pair);
    report_lines("Contact", "set Slave =\nset Master =");
    report_lines("Contact", "set Slave = S");
    report_lines("Contact", "set Master = M");
    report_lines("Contact", "set Slave = S\nset Master = S");
    report_lines("Contact", "set Friction coefficient = 0.1");
    report_lines("Contact", "set Tresca limit = 1");
    report_lines("Contact",
                 pair + "set Friction coefficient = 0.1\nset Tresca limit = 1");
    report_lines("Contact",
                 "set Discretization = nodal\nset Excluded points = C");
    report_lines("Contact",
                 pair + "set Discretization = Gauss\nset Excluded points = C");
    report_lines("Contact",
                 pair +
                   "set Discretization = nodal\nset Excluded points = C, C");
    report_lines("Contact",
                 pair +
                   "set Discretization = nodal\nset Excluded points = C, , D");
    report_lines("Probes", "set Hertz = 50, 35000");
  }



  // Proves that tolerances are positive.
  void test_solution()
  {
    headline("solution");
    report_lines("Solution", "set Geometry tolerance = 0");
    report_lines("Solution", "set Friction tolerance = -1e-3");
    report_lines("Solution", "set Newton tolerance = 0");
  }



  // Proves that a probe is a known quantity in a point, and that probes,
  // references and tolerances belong together.
  void test_probes()
  {
    headline("probes");
    const std::string probe = "set Probes = P: stress yy, B\n";
    report_lines("Probes", probe);
    report_lines("Probes", "set Probes = P: stress, B");
    report_lines("Probes", "set Probes = P: stress yy");
    report_lines("Probes", "set Probes = P: stress yy, B, C, D");
    report_lines("Probes", "set References = P: 1\nset Tolerances = P: 1");
    report_lines("Probes", probe + "set References = P: 1");
    report_lines("Probes", probe + "set Tolerances = P: 1");
    report_lines("Probes",
                 probe + "set References = P: 1\nset Tolerances = P: 0");
    report_lines("Probes",
                 probe + "set References = P: 0\nset Tolerances = P: 1");
    report_lines("Probes", "set Hertz = 50, 1, 1");
    report_lines("Probes", "set Hertz = 50, 0");
  }



  // Proves that the command line is checked as a file is.
  void test_overrides()
  {
    headline("overrides");
    report("base.prm", {"Element/Degree=2", "Element/Centre node=free"});
    report("base.prm", {"Element/Centre node=free"});
    report("base.prm", {"Element/Degree=3"});
    report("base.prm", {"Element/Degree"});
    report("base.prm", {"Degree=2"});
    report("base.prm", {"Elemnt/Degree=2"});
    report("base.prm", {"Element/Degre=2"});
    report("base.prm", {"Mesh/Degree=a/b=c"});
    report("base.prm", {""});
  }



  // The text as a file, and what becomes of it.
  void report_json(const std::string &text)
  {
    write("case.json", text);
    report("case.json");
  }



  // As report_lines(), with the elements of one section.
  void report_json_lines(const std::string &section, const std::string &lines)
  {
    write("base.prm", base);
    report_json("{\"include\": \"base.prm\",\n\"" + section + "\": {\n" +
                lines + "\n}}");
  }



  // Proves that values of every kind are read from JSON, under names as they
  // are or as ParameterHandler writes them.
  void test_json_values()
  {
    headline("values in JSON");
    write("values.json", R"json({
      "Mesh": {
        "File": "a.msh",
        "Refinements": 2,
        "Arcs": {"Bottom_C": [0, 50, 50], "Other": "1, 2, 3"}
      },
      "Element": {
        "Degree": {"value": "2", "documentation": "of ParameterHandler"},
        "Centre_20node": "free"
      },
      "Solids": {
        "Young_27s_20modulus": {"Block": 7e4},
        "Poisson's   ratio": {"value": {"Block": 0.3}}
      },
      "Boundary_20conditions": {
        "Displacement x": {"Axe": 0, "Encast": -0.5},
        "Tied y": {"C": "B"}
      },
      "Contact": {
        "Slave": "S",
        "Master": " M ",
        "Discretization": "nodal",
        "Excluded points": ["C", "D"],
        "Friction coefficient": 1e-1
      },
      "Contact_20left_5f2": {
        "Slave": "S2", "Master": "M2", "Discretization": "nodal"
      },
      "Contact right_2": {"Slave": "S3", "Master": "M3", "Discretization": "nodal"},
      "Solution": {"Geometry": "Newton"},
      "Probes": {
        "Probes": {
          "DY(B)": "displacement y, B",
          "S(B)": ["stress yy", "B"]
        },
        "References": {"DY(B)": -1.5},
        "Tolerances": {"DY(B)": 0.001},
        "Hertz": [50, 35000]
      },
      "Output": {"Screen": "none", "VTU": true}
    })json");
    const Case result("values.json");
    std::cout << result.error;
    print_values(result);
    for (const auto &contact_pair : result.parameters.pairs())
      std::cout << contact_pair.section() << ": " << contact_pair.slave << '\n';

    // A body may have the name of something else.
    write("value.json",
          R"json({"Mesh": {"File": "a.msh"},
              "Solids": {"Young's modulus": {"value": 1, "Block": 2},
                         "Poisson's ratio": {"value": 0, "Block": 0}}})json");
    const Case value("value.json");
    std::cout << value.error
              << value.parameters.solids.youngs_modulus.at("value") << '\n';
  }



  // Proves that files of both kinds include each other, that paths are relative
  // to the file they are in, and that a file goes before what it includes.
  void test_json_include()
  {
    headline("include in JSON");
    write("base.prm", base);
    write("sub/mesh.json", "{\"Mesh\": {\"File\": \"../b.msh\"}}");
    write("sub/both.prm",
          "include mesh.json\nsubsection Solution\nset Increments = 3\nend\n");
    write("mixed.json",
          "{\"Solution\": {\"Increments\": 4},\n"
          "\"include\": [\"base.prm\", \"sub/both.prm\"]}");
    const Case result("mixed.json", {"Element/Degree=2"});
    std::cout << result.error << result.parameters.solution.n_increments << ", "
              << result.parameters.element.degree << ", " << mesh_file(result)
              << '\n';

    report_json("{\n\"include\": \"missing.json\"}");
    report_json("{\"include\": [\"base.prm\",\n\"case.json\"]}");
    report_json("{\"include\": {\"file\": \"base.prm\"}}");
    report_lines("Mesh", "include sub/mesh.json");
  }



  // Proves that what is no JSON is refused at its line and column, and two
  // equal names as in the other files.
  void test_json_syntax()
  {
    headline("syntax of JSON");
    report_json("");
    report_json("{\"Element\": {\"Degree\": 1}\n");
    report_json("{\n  \"Element\": {\n    \"Degree\": 1,\n  }\n}\n");
    report_json("{\n  # degree\n}");
    report_json("{\"Element\": {\"Degree\" 1}}");
    report_json("{\"Element\": {\"Degree\": 01}}");
    report_json("{\"Mesh\": {\"Scale\": 1e999}}");
    report_json("{} {}");
    report_json("{\"Mesh\": {\"File\": \"\xff\"}}");
    report_json("{\"Mesh\": {\"File\": \"" + std::string(1000, 'x') + "\n");
    report_json(std::string(100000, '['));
    report_json(std::string(10, '{'));
    report_json("{\"Mesh\": {\"Scale\": [[[[1]]]]}}");
    report_json("{\"Mesh\": {},\n\"Element\": {},\n\"Mesh\": {}}");
    report_json_lines("Contact", "\"Slave\": \"A\",\n\"Slave\": \"B\"");
    report_json_lines("Contact", "\"Gauss points\": 3,\n\"Gauss_20points\": 4");
    report_json_lines("Boundary conditions",
                      "\"Force y\": {\"A\": 1, \"A\": 2}");
    report_json_lines("Boundary conditions", "\"Force y\": \"A: 1, A: 2\"");
  }



  // Proves that unknown names and wrong values are answered as those of other
  // files, and wrong types with what they are.
  void test_json_entries()
  {
    headline("entries in JSON");
    report_json_lines("Contcat", "\"Slave\": \"A\"");
    report_json_lines("Contact", "\"Slaev\": \"A\"");
    report_json_lines("Element", "\"Slave\": \"A\"");
    report_json_lines("Element", "\"Contact\": {\"Slave\": \"A\"}");
    report_json("{\n\"Degree\": 1}");
    report_json("{\n\"Mesh\": \"a.msh\"}");
    report_json("{\n\"Contact left\": [\"Slave\", \"Master\"]}");
    report_json("[1, 2]");
    report_json("null");

    report_json_lines("Element", "\"Degree\": 3");
    report_json_lines("Element", "\"Degree\": 1.0");
    report_json_lines("Element", "\"Degree\": true");
    report_json_lines("Element", "\"Degree\": null");
    report_json_lines("Element", "\"Degree\": {}");
    report_json_lines("Element", "\"Degree\": {\"value\": 3}");
    report_json_lines("Element", "\"Degree\": [1]");
    report_json_lines("Output", "\"VTU\": 1");
    report_json_lines("Mesh", "\"Shift\": [1, \"x\"]");
    report_json_lines("Mesh", "\"Shift\": [1, [2]]");
    report_json_lines("Mesh", "\"File\": \"a\\nb\"");
    report_json_lines("Contact", "\"Excluded points\": [\"C, D\"]");
    report_json_lines("Solids", "\"Young's modulus\": 1");
    report_json_lines("Solids", "\"Young's modulus\": {\"Block\": \"E\"}");
    report_json_lines("Solids", "\"Young's modulus\": {\"Block\": [1]}");
    report_json_lines("Solids", "\"Young's modulus\": {\"A: 1, B\": 1}");
    report_json_lines("Solids", "\"Young's modulus\": [\"Block\", 1]");
    report_json_lines("Probes", "\"Probes\": {\"P\": {\"at\": \"B\"}}");
    report_json_lines("Solids", "\"Young's modulus\": {\"Block\": 0}");
  }



  // Proves that every entry is documented with a unit, and that what is
  // printed can be read and holds the defaults.
  void test_print()
  {
    headline("printed parameters");
    std::ostringstream printed;
    Contact::print_parameters(printed);
    write("printed.prm", printed.str());

    const Names needed = {"Mesh/File=a.msh",
                          "Solids/Young's modulus=Block: 70000",
                          "Solids/Poisson's ratio=Block: 0.3"};
    const Case  result("printed.prm", needed);
    write("empty.prm", "");
    const Case         defaults("empty.prm", needed);
    std::ostringstream from_printed, from_nothing;
    result.prm.print_parameters(from_printed, ParameterHandler::ShortPRM);
    defaults.prm.print_parameters(from_nothing, ParameterHandler::ShortPRM);
    std::cout << result.error << defaults.error
              << "same values: " << (from_printed.str() == from_nothing.str())
              << '\n';

    for (const auto &entry : Contact::declared_entries(result.prm))
      if (entry.documentation.find('[') == std::string::npos &&
          entry.path() != "Mesh/File" && entry.alias_of.empty())
        std::cout << "no unit: " << entry.path() << '\n';
    std::cout << printed.str().substr(0, printed.str().find("end\n"));
  }
} // namespace



int main()
{
  test_values();
  test_syntax();
  test_include();
  test_files();
  test_twice();
  test_unknown();
  test_structure();
  test_patterns();
  test_mesh_and_solids();
  test_boundary();
  test_contact();
  test_solution();
  test_probes();
  test_overrides();
  test_json_values();
  test_json_include();
  test_json_syntax();
  test_json_entries();
  test_print();
}
