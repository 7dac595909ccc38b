/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Small parameter files, written and read, for the tests of the reader.

#ifndef contact_tests_parameters_reader_h
#define contact_tests_parameters_reader_h

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "parameters/parameter_file.h"
#include "parameters/parameters.h"

namespace Tests
{
  using namespace dealii;

  using Names = std::vector<std::string>;

  // The entries that every case needs. Tests set more after it.
  inline const std::string base = "subsection Mesh\n"
                                  "  set File = a.msh\n"
                                  "end\n"
                                  "subsection Solids\n"
                                  "  set Young's modulus = Block: 70000\n"
                                  "  set Poisson's ratio = Block: 0.3\n"
                                  "end\n";



  inline void write(const std::string &file, const std::string &text)
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



  inline void section(const std::string &text)
  {
    std::cout << "\n=== " << text << "\n";
  }



  inline void report(const std::string &file, const Names &overrides = {})
  {
    const Case result(file, overrides);
    std::cout << (result.error.empty() ? "accepted" : result.error) << "\n\n";
  }



  // The base and one more line in one section, and what becomes of it.
  inline void report_lines(const std::string &section, const std::string &lines)
  {
    write("base.prm", base);
    write("case.prm",
          "include base.prm\nsubsection " + section + "\n" + lines + "\nend\n");
    report("case.prm");
  }



  // The mesh file is stored as an absolute path, which the test cannot
  // compare: it is printed relative to the working directory.
  inline std::string mesh_file(const Case &result)
  {
    const std::filesystem::path file = result.parameters.mesh.file;
    return (file.is_absolute() ? "absolute, " : "RELATIVE, ") +
           file.lexically_relative(std::filesystem::current_path()).string();
  }



  inline void print_values(const Case &result)
  {
    const auto &p = result.parameters;
    std::cout << "name: " << p.name << "\nmesh: " << mesh_file(result) << ' '
              << p.mesh.refinements << ' ' << p.mesh.shift.at(1) << '\n';
    for (const auto &[group, arc] : p.mesh.arcs)
      std::cout << "arc: " << group << ' ' << arc[0] << ' ' << arc[1] << ' '
                << arc[2] << '\n';
    std::cout << "element: " << p.element.degree << ' '
              << p.element.centre_node.name()
              << "\nsolids: " << p.solids.youngs_modulus.at("Block") << ' '
              << p.solids.poisson.at("Block") << ' '
              << p.solids.kinematics.name()
              << "\nboundary: " << p.boundary.displacement[0].at("Encast")
              << ' ' << p.boundary.tied[1].at("C") << ' '
              << p.boundary.force[1].size() << "\ncontact: " << p.contact.slave
              << ' ' << p.contact.master << ' '
              << p.contact.discretization.name() << ' '
              << p.contact.n_gauss_points << ' '
              << p.contact.excluded_points.at(1) << ' '
              << p.contact.friction_coefficient << ' ' << p.contact.tresca_limit
              << "\nsolution: " << p.solution.increments.size() << ' '
              << p.solution.geometry.name() << ' '
              << p.solution.geometry_tolerance << ' '
              << p.solution.friction.name() << ' '
              << p.solution.friction_tolerance
              << "\nprobes: " << p.probes.probes.at("S(B)").at(0) << ' '
              << p.probes.probes.at("S(B)").at(1) << ' '
              << p.probes.references.at("DY(B)") << ' '
              << p.probes.tolerances.at("DY(B)")
              << "\noutput: " << p.output.directory << ' '
              << p.output.screen.name() << ' ' << p.output.vtu << ' '
              << p.output.profile << '\n';
  }
} // namespace Tests

#endif
