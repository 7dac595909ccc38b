/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that result files hold the cells and nodes that VTK expects, whole
// after every increment; that probes have the values of known fields; that
// summary and table hold the verdicts; and that a directory which cannot be
// written to is refused. The profiles themselves: postprocessing_profiles.cc.

#include "postprocessing.h"

#include <deal.II/base/utilities.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "base/errors.h"
#include "base/files.h"
#include "output/result_files.h"
#include "output/result_tables.h"
#include "probes/probes.h"

using namespace Tests;

namespace
{
  std::string contents(const std::filesystem::path &file)
  {
    std::ifstream     in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }



  // The numbers of an array of a VTU file: base64 of the sizes, directly
  // followed by base64 of the compressed data.
  template<typename Number>
  std::vector<Number> vtu_array(const std::string &vtu, const std::string &tag)
  {
    const auto begin = vtu.find('\n', vtu.find(tag + '>')) + 1;
    const auto text  = vtu.substr(begin, vtu.find('\n', begin) - begin);
    if (text.size() < 24)
      return {};

    const auto sizes = Utilities::decode_base64(text.substr(0, 24));
    const auto data  = Utilities::decode_base64(text.substr(24));
    uint32_t   n_bytes;
    std::memcpy(&n_bytes, &sizes[4], 4);
    std::vector<Number> numbers(n_bytes / sizeof(Number));
    uLongf              size = n_bytes;
    uncompress(reinterpret_cast<Bytef *>(numbers.data()),
               &size,
               data.data(),
               data.size());
    return numbers;
  }



  // The distance of the mid-sides and centres of quadratic cells from where VTK
  // wants them: behind the corners, in the order of these pairs of corners.
  double misplaced(const std::vector<Point<2>> &cell)
  {
    const bool is_triangle = cell.size() == 6;
    const std::vector<std::array<unsigned int, 2>> pairs =
      is_triangle
        ? decltype(pairs){{{0, 1}}, {{1, 2}}, {{2, 0}}}
        : decltype(pairs){{{0, 1}}, {{1, 2}}, {{3, 2}}, {{0, 3}}, {{0, 2}}};
    double worst = 0;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      worst = std::max(worst,
                       cell[i + (is_triangle ? 3 : 4)].distance(
                         0.5 * (cell[pairs[i][0]] + cell[pairs[i][1]])));
    return worst;
  }



  // Print the numbers of cells of each type, and check their nodes: the ends of
  // lines follow each other.
  void check_cells(const std::filesystem::path &file)
  {
    const std::string vtu = contents(file);
    const auto        x   = vtu_array<float>(vtu, "\"3\" format=\"binary\"");
    const auto nodes = vtu_array<int>(vtu, "connectivity\" format=\"binary\"");
    const auto offsets = vtu_array<int>(vtu, "offsets\" format=\"binary\"");
    const auto types =
      vtu_array<unsigned char>(vtu, "types\" format=\"binary\"");

    std::map<unsigned int, unsigned int> count;
    double                               worst = 0;
    Point<2>                             last;
    for (unsigned int c = 0, i = 0; c < types.size(); ++c)
      {
        std::vector<Point<2>> cell;
        for (; i < static_cast<unsigned int>(offsets[c]); ++i)
          cell.emplace_back(x[3 * nodes[i]], x[3 * nodes[i] + 1]);
        ++count[types[c]];
        if (types[c] == 3)
          worst = std::max(worst, cell[0].distance(last));
        else if (types[c] == 22 || types[c] == 28)
          worst = std::max(worst, misplaced(cell));
        last = cell[1];
      }
    std::cout << "  " << file.filename().string() << ':';
    for (const auto &[type, n] : count)
      std::cout << ' ' << n << " of type " << type;
    std::cout << std::endl;
    check_small("misplaced nodes", worst, 1e-6);
  }



  // Proves that the files hold what they should: cells by the types of VTK (5
  // and 9 linear, 22 and 28 quadratic triangles and quadrangles, 3 lines), with
  // the nodes in VTK's order; that a series is whole after every increment; and
  // that the profile is a table.
  void check_files(const unsigned int degree)
  {
    headline("files, degree " + std::to_string(degree));
    const PlacedModel model(two_blocks(degree, "nodal"), stay);
    const Stresses    stresses(model.mesh.triangulation.n_vertices());
    const auto [slave, master] = profiles(model, stresses);

    const std::vector<PairProfile<2>> pairs{
      {"", &model.interface.pairs[0]->slave, slave, master}};

    const std::filesystem::path directory = "files/nested";
    ResultFiles<2>              files(directory, model.discretization);
    for (unsigned int k = 1; k <= 2; ++k)
      {
        files.write_bodies(k, 0.5 * k, stresses, model.solution);
        files.write_contact(k, 0.5 * k, pairs);
        for (const std::string name : {"bodies", "contact"})
          {
            const std::string pvd = contents(directory / (name + ".pvd"));
            std::cout << "  " << name << ".pvd names "
                      << (pvd.find("_0001_0.vtu") != pvd.npos) +
                           (pvd.find("_0002_0.vtu") != pvd.npos)
                      << std::endl;
            check("is closed", pvd.find("</VTKFile>") != pvd.npos);
          }
      }
    check_cells(directory / "bodies_0002_0.vtu");
    check_cells(directory / "bodies_0002_1.vtu");
    check_cells(directory / "contact_0002_0.vtu");

    files.write_profile(pairs);
    std::ifstream            csv(directory / "profile.csv");
    std::string              line;
    std::map<long, unsigned> n_lines;
    while (std::getline(csv, line))
      ++n_lines[std::count(line.begin(), line.end(), ',') + 1];
    for (const auto &[n_columns, n] : n_lines)
      std::cout << "  profile.csv: " << n << " lines of " << n_columns
                << " columns" << std::endl;
    bool unfinished = false;
    for (const auto &entry : std::filesystem::directory_iterator(directory))
      unfinished = unfinished || entry.path().extension() == ".part";
    check("no unfinished file", !unfinished);
  }



  // Proves what each quantity of a probe means.
  void check_probes()
  {
    headline("probes");
    const PlacedModel     model(two_blocks(1, "nodal"), [](const Point<2> &X) {
      return Point<2>(X[0] + 0.25, X[1] - 0.5);
    });
    SymmetricTensor<2, 3> stress;
    stress[0][0] = 1;
    stress[1][1] = 4;
    stress[2][2] = -2;
    stress[0][1] = 3;
    const Stresses stresses(model.mesh.triangulation.n_vertices(), stress);
    Place<2>       place;
    place.vertices = {{3, 1.}};
    for (unsigned int c = 0; c < 2; ++c)
      place.unknowns[c] = {{model.discretization.vertex_dofs[3][c], 1.}};
    for (const auto &[name, quantity] : named_values(Parameters::Quantity()))
      if ((is_displacement(quantity) || is_stress(quantity)) &&
          !is_in_space(quantity))
        std::cout << "  " << name << ' '
                  << probe_value(quantity,
                                 place,
                                 model.discretization,
                                 stresses,
                                 model.solution)
                  << std::endl;
  }



  // Proves the verdicts, the table, and the keys of the JSON file.
  void check_summary()
  {
    headline("summary");
    RunSummary good;
    good.case_name = "good";
    good.mesh_file = "meshes/block.msh";
    good.converged = true;
    good.probes    = {{"DY", "mm", true, -1.30001, -1.3, 1e-4},
                      {"S", "MPa", false, 2}};
    good.increments.resize(1);
    good.time["solve"] = {0.5, 0.25};
    RunSummary outside = good, failed = good;
    outside.case_name           = "outside";
    outside.probes[0].tolerance = 1e-6;
    failed.case_name            = "failed";
    failed.converged            = false;
    failed.message              = "increment 1: no convergence";
    print_table(std::cout, {good, outside, failed});
    check("verdicts", good.passed() && !outside.passed() && !failed.passed());

    std::filesystem::create_directory("files");
    std::ofstream out("files/summary.json");
    write_summary(good, out);
    out.close();
    auto json = nlohmann::ordered_json::parse(contents("files/summary.json"));
    for (const char *const differs : {"program", "date", "time_of_day"})
      {
        check(differs, json.contains(differs));
        json.erase(differs);
      }
    std::cout << json.dump(1) << std::endl;
    check("peak memory", peak_memory_mb() > 10 && peak_memory_mb() < 1e5);
  }



  // Proves that a directory that cannot be is refused with what, where and
  // remedy, and that what stands in its way stays.
  void check_unwritable()
  {
    headline("unwritable");
    std::ofstream("in_the_way") << "kept";
    try
      {
        create_output_directory("in_the_way/output");
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
    check("file in the way stays", contents("in_the_way") == "kept");
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    check_files(degree);
  check_probes();
  check_summary();
  check_unwritable();
  return 0;
}
