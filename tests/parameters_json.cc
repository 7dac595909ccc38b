/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that parameter files in JSON are read as documented, and that files of
// both kinds include each other; that what is no JSON is refused at its line
// and column; and that every other error in them is answered as in the other
// files, wrong types with what they are.

#include "parameters_reader.h"

using namespace Tests;

namespace
{
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
    section("values in JSON");
    write("values.json", R"json({
      "Mesh": {
        "File": "a.msh",
        "Refinements": 2,
        "Shift": [50, 35000],
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
        "Tolerances": {"DY(B)": 0.001}
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
    section("include in JSON");
    write("base.prm", base);
    write("sub/mesh.json", "{\"Mesh\": {\"File\": \"../b.msh\"}}");
    write("sub/both.prm",
          "include mesh.json\nsubsection Solution\nset Increments = 3\nend\n");
    write("mixed.json",
          "{\"Solution\": {\"Increments\": 4},\n"
          "\"include\": [\"base.prm\", \"sub/both.prm\"]}");
    const Case result("mixed.json", {"Element/Degree=2"});
    std::cout << result.error << result.parameters.solution.increments.size()
              << ", " << result.parameters.element.degree << ", "
              << mesh_file(result) << '\n';

    report_json("{\n\"include\": \"missing.json\"}");
    report_json("{\"include\": [\"base.prm\",\n\"case.json\"]}");
    report_json("{\"include\": {\"file\": \"base.prm\"}}");
    report_lines("Mesh", "include sub/mesh.json");
  }



  // Proves that what is no JSON is refused at its line and column, and two
  // equal names as in the other files.
  void test_json_syntax()
  {
    section("syntax of JSON");
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
    section("entries in JSON");
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
} // namespace



int main()
{
  test_json_values();
  test_json_include();
  test_json_syntax();
  test_json_entries();
  return 0;
}
