/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that parameter files are read as documented, and that every rule about
// them is enforced with a message that says what, where and how to remedy it.

#include "parameters_reader.h"

#include <sstream>

using namespace Tests;

namespace
{
  // Proves that values of every kind arrive in the structures.
  void test_values()
  {
    section("values");
    write("values.prm",
          base + "subsection Mesh\n"
                 "  set Refinements = 2\n"
                 "  set Shift = 50, 35000\n"
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
    section("syntax");
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
              << result.parameters.boundary.force[1].size() << ' '
              << result.parameters.boundary.force[0].size() << '\n';

    // The line of a joined statement is its first one.
    report_lines("Boundary conditions", "  set Force y = A: 1, \\\n B 2");
  }



  // Proves that paths are relative to the file they are in, and that what is
  // read later wins, be it an include, the file itself or the command line.
  void test_include()
  {
    section("include");
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
                  << result.parameters.solution.increments.size() << ", "
                  << mesh_file(result) << '\n';
      }

    const Case result("own.prm",
                      {"Solution/Increments=5", " Mesh / File = c.msh"});
    std::cout << "command line: " << result.error
              << result.parameters.solution.increments.size() << ", "
              << mesh_file(result) << '\n';

    // An include inside a section continues it.
    write("entries.prm", "set Increments = 6\n");
    write("inside.prm",
          base + "subsection Solution\n include entries.prm\nend\n");
    std::cout << "inside a section: " << Case("inside.prm").error
              << Case("inside.prm").parameters.solution.increments.size()
              << '\n';
  }



  // Proves that files that cannot be read are named, with who asks for them.
  void test_files()
  {
    section("files");
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
    section("twice");
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
    section("unknown");
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
    section("structure");
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
    section("patterns");
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
    report_lines("Mesh", "set Shift = 50, strong");
    report_lines("Boundary conditions", "set Tied y = C");
    report_lines("Output", "set VTU = perhaps");
  }



  // Proves that meshes and materials are checked beyond their patterns.
  void test_mesh_and_solids()
  {
    section("mesh and solids");
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
    section("boundary conditions");
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
    section("contact");
    const std::string pair = "set Slave = S\nset Master = M\n";
    report_lines("Contact", pair);
    report_lines("Contact", "set Slave =\nset Master =");
    report_lines("Contact", "set Slave = S");
    report_lines("Contact", "set Master = M");
    report_lines("Contact", "set Slave = S\nset Master = S\nset Tied = true");
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
  }



  // Proves that tolerances are positive.
  void test_solution()
  {
    section("solution");
    report_lines("Solution", "set Geometry tolerance = 0");
    report_lines("Solution", "set Friction tolerance = -1e-3");
    report_lines("Solution", "set Newton tolerance = 0");
  }



  // Proves that a probe is a known quantity in a point, and that probes,
  // references and tolerances belong together.
  void test_probes()
  {
    section("probes");
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
    // A former one that is compared elsewhere.
    report_lines("Probes", "set Hertz = 50, 35000");
    report_lines("Probes", "set Frictional theory = yes");
  }



  // Proves that the command line is checked as a file is.
  void test_overrides()
  {
    section("overrides");
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



  // Proves that every entry is documented with a unit, and that what is
  // printed can be read and holds the defaults.
  void test_print()
  {
    section("printed parameters");
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
  test_print();
  return 0;
}
