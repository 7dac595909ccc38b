/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The parameter files of SSNP154 are valid, and their fragments add up to the
// modelings they are named after. So they do in JSON.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "parameters/parameters.h"

using namespace dealii;

const std::filesystem::path parameters =
  std::filesystem::path(SOURCE_DIR) / ".." / "parameters";



// The differences of the modelings; the rest is common to all of them.
void print_case(const std::string &name)
{
  Contact::Parameters::All p;
  ParameterHandler         prm;
  Contact::read_parameters(parameters / (name + ".prm"), {}, prm, p);

  std::cout << p.name << ": degree " << p.element.degree << ", "
            << p.contact.discretization.name() << ", friction "
            << p.contact.friction_coefficient << ", "
            << p.contact.excluded_points.size() << " excluded, "
            << p.boundary.tied[1].size() << " tied, mesh "
            << std::filesystem::path(p.mesh.file).filename().string() << '\n';
  for (const auto &[probe, reference] : p.probes.references)
    std::cout << "  " << probe << " = " << p.probes.probes.at(probe).at(0)
              << " in " << p.probes.probes.at(probe).at(1) << ": " << reference
              << " within " << p.probes.tolerances.at(probe) << '\n';
}



// Everything that is set by a file, as a text.
std::string printed(const std::filesystem::path        &file,
                    const ParameterHandler::OutputStyle style)
{
  Contact::Parameters::All p;
  ParameterHandler         prm;
  Contact::read_parameters(file, {}, prm, p);
  std::ostringstream text;
  prm.print_parameters(text, style);
  return text.str();
}



// Proves that a text in JSON means what another file does.
void compare(const std::string           &what,
             const std::string           &text,
             const std::filesystem::path &file)
{
  std::ofstream("case.json") << text;
  std::cout << what << ": "
            << (printed("case.json", ParameterHandler::ShortPRM) ==
                    printed(file, ParameterHandler::ShortPRM)
                  ? "equal"
                  : "DIFFERENT")
            << '\n';
}



// Modeling A with all that its fragments set. The mesh is named as the test
// needs it.
const std::string modeling_a = R"json({
  "Mesh": {
    "File": "MESH",
    "Arcs": {"Bottom_C": [0, 50, 50]}
  },
  "Element": {"Degree": 1},
  "Solids": {
    "Young's modulus": {"Block": 70000, "Cylinder": 210000},
    "Poisson's ratio": {"Block": 0.3, "Cylinder": 0.3},
    "Kinematics": "large displacement"
  },
  "Boundary conditions": {
    "Displacement x": {"Axe": 0, "Encast": 0},
    "Displacement y": {"Encast": 0},
    "Force y": {"Force": -17500}
  },
  "Contact": {
    "Slave": "Bottom_C",
    "Master": "Top_B",
    "Discretization": "Gauss",
    "Gauss points": 3
  },
  "Solution": {
    "Increments": 2,
    "Geometry": "fixed point",
    "Geometry tolerance": 0.01,
    "Friction": "fixed point"
  },
  "Probes": {
    "Probes": {"DY(B)": ["displacement y", "B"], "SIYY(B)": "stress yy, B"},
    "References": {"DY(B)": -1.3069040401077, "SIYY(B)": -3800.4949548283},
    "Tolerances": {"DY(B)": 0.001, "SIYY(B)": 0.001},
    "Errors": "none"
  },
  "Output": {"VTU": true, "Profile": true}
})json";



// Modeling G by the fragments, which are in DIRECTORY.
const std::string modeling_g = R"json({
  "include": ["DIRECTORY/ssnp154.prm", "DIRECTORY/discrete.prm",
              "DIRECTORY/friction.prm", "DIRECTORY/files.prm"],
  "Mesh": {"Arcs": {"Bottom_C": [0, 50, 50]}},
  "Probes": {
    "References": {"DY(B)": -1.3010795793844, "SIYY(B)": -3670.2559152851},
    "Tolerances": {"DY(B)": 0.001, "SIYY(B)": 0.005}
  }
})json";



int main()
{
  std::cout.precision(14);

  // Proves that every file can be read and that the later fragments win.
  for (const char modeling : std::string("abcdefgh"))
    print_case(std::string("ssnp154_") + modeling);

  // Proves that the tie and the exclusion can be taken back by empty values.
  for (const char modeling : std::string("efg"))
    print_case(std::string("ssnp154_") + modeling + "_untied");

  // Proves that JSON, by hand or by ParameterHandler, says the same.
  const auto a = parameters / "ssnp154_a.prm";
  compare("A in JSON",
          Utilities::replace_in_string(modeling_a,
                                       "MESH",
                                       parameters / "../meshes/ssnp154.msh"),
          a);
  compare("G with includes",
          Utilities::replace_in_string(modeling_g, "DIRECTORY", parameters),
          parameters / "ssnp154_g.prm");
  compare("A as JSON of ParameterHandler",
          printed(a, ParameterHandler::JSON),
          a);
  compare("A as short JSON of ParameterHandler",
          printed(a, ParameterHandler::ShortJSON),
          a);
  return 0;
}
