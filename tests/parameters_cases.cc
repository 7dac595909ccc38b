/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The parameter files of SSNP154 are valid, and their fragments add up to the
// modelings they are named after.

#include <filesystem>
#include <iostream>

#include "parameters.h"

using namespace dealii;



// What distinguishes the modelings; the rest is common to all of them.
void print_case(const std::string &name)
{
  Contact::Parameters::All p;
  ParameterHandler         prm;
  const auto               directory =
    std::filesystem::path(SOURCE_DIR) / ".." / "parameters";
  Contact::read_parameters(directory / (name + ".prm"), {}, prm, p);

  std::cout << p.name << ": degree " << p.element.degree << ", "
            << p.contact.rule << ", friction " << p.contact.friction_coefficient
            << ", " << p.contact.excluded_points.size() << " excluded, "
            << p.boundary.tied_y.size() << " tied, mesh "
            << std::filesystem::path(p.mesh.file).filename().string() << '\n';
  for (const auto &[probe, reference] : p.probes.references)
    std::cout << "  " << probe << " = " << p.probes.probes.at(probe).at(0)
              << " in " << p.probes.probes.at(probe).at(1) << ": " << reference
              << " within " << p.probes.tolerances.at(probe) << '\n';
}



int main()
{
  std::cout.precision(14);

  // Proves that every file can be read and that the later fragments win.
  for (const char modeling : std::string("abcdefgh"))
    print_case(std::string("ssnp154_") + modeling);

  // Proves that the tie and the exclusion can be taken back by empty values.
  for (const char modeling : std::string("efg"))
    print_case(std::string("ssnp154_") + modeling + "_untied");
}
