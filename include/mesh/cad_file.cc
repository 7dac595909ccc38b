/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/cad_file.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <fstream>
#include <iomanip>
#include <regex>
#include <sstream>

#include "base/all_ranks.h"
#include "base/errors.h"
#include "base/files.h"
#include "base/string_utilities.h"
#include "mesh/cad_model.h"
#include "parameters/geometry.h"

namespace Contact
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;
    using Parameters::Geometry;

    /// The surfaces on which pressures are looked for, not those of glue.
    std::set<std::string> contact_surfaces(const Parameters::All &parameters)
    {
      std::set<std::string> names;
      for (const Parameters::Contact &pair : parameters.pairs())
        if (!pair.tied)
          names.insert({pair.slave, pair.master});
      return names;
    }



    /// Checksums of a file and, of a .geo, of all files that it names.
    void add_checksums(const fs::path &file, std::map<fs::path, unsigned> &sums)
    {
      if (!fs::is_regular_file(file) ||
          !sums.emplace(file.lexically_normal(), checksum(file)).second ||
          Geometry::source_of(file.string()) != Geometry::Source::geo)
        return;
      std::ifstream     in(file);
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      const std::regex  quoted("\"([^\"\n]+)\"");
      for (std::sregex_iterator name(text.begin(), text.end(), quoted), end;
           name != end;
           ++name)
        add_checksums(file.parent_path() / name->str(1), sums);
    }



    /// All that a mesh depends on, in a line.
    std::string fingerprint(const fs::path              &source,
                            const Geometry              &mesh,
                            const std::set<std::string> &in_contact)
    {
      std::ostringstream text;
      text << std::setprecision(17) << "gmsh " << CadModel::version()
           << ", size " << mesh.size << ", order " << mesh.order;
      for (const auto &[name, size] : mesh.sizes)
        text << ", " << name << ' ' << size;
      for (const auto &[name, numbers] : mesh.boundaries)
        {
          text << ", " << name;
          for (const double number : numbers)
            text << ' ' << number;
        }
      text << "; contact:";
      for (const std::string &name : in_contact)
        text << ' ' << name << ',';
      std::map<fs::path, unsigned> sums;
      add_checksums(source, sums);
      for (const auto &[file, sum] : sums)
        text << ' ' << file.filename().string() << ' ' << sum;
      return text.str();
    }



    const std::string comments = "$Comments", end_of_comments = "$EndComments";

    /// The last lines of a mesh: its fingerprint and its description.
    std::pair<std::string, std::string> read_comments(const fs::path &msh_file)
    {
      std::ifstream in(msh_file);
      std::string   line, print, description;
      while (std::getline(in, line))
        if (line == comments && std::getline(in, print) &&
            std::getline(in, description) && std::getline(in, line) &&
            line == end_of_comments)
          return {print, description};
      return {};
    }
  } // namespace



  void mesh_cad_file(Parameters::All  &parameters,
                     ParameterHandler &prm,
                     const MPI_Comm    communicator)
  {
    Parameters::Mesh &mesh = parameters.mesh;
    const auto        kind = Geometry::source_of(mesh.file);
    if (kind == Geometry::Source::mesh)
      return;
    const Geometry geometry(prm);
    const fs::path source(mesh.file);
    const fs::path msh_file =
      parameters.directory() / (source.stem().string() + ".msh");
    on_all_ranks(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) > 0)
        return;
      if (!fs::is_regular_file(source))
        throw InputError("the file of the geometry does not exist",
                         mesh.file,
                         "check the name in entry 'Mesh/File'");
      const auto        in_contact = contact_surfaces(parameters);
      const std::string print      = fingerprint(source, geometry, in_contact);
      const auto [known, kept]     = read_comments(msh_file);
      const std::string name       = msh_file.filename().string();
      const std::string from       = " from " + source.filename().string();
      if (known == print)
        {
          tell({name + " as it was made" + from +
                  ", nothing has changed since; " + kept,
                /*is_violated=*/false,
                parameters.name},
               parameters.findings);
          return;
        }
      create_output_directory(parameters.directory());
      const Timer timer;
      CadModel    model(mesh.file, geometry, in_contact);
      fs::path    part = msh_file; // gmsh goes by the end of the name
      part.replace_extension(".part.msh");
      model.write_mesh(part.string());
      const std::string text = model.describe();
      std::ofstream(part, std::ios::app) << comments << '\n'
                                         << print << '\n'
                                         << text << '\n'
                                         << end_of_comments << '\n';
      fs::rename(part, msh_file);
      tell({name + ", made by gmsh" + from + " in " + brief(timer.wall_time()) +
              " s; " + text,
            /*is_violated=*/false,
            parameters.name},
           parameters.findings);
    });
    if (geometry.order == 2 ||
        (geometry.order == 0 && kind == Geometry::Source::cad))
      mesh.mid_side_nodes = true;
    mesh.file = msh_file.string();
  }
} // namespace Contact
