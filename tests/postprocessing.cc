/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The profiles, the result files and the summary, on two blocks that are small
// enough to know the answer.

#include <deal.II/base/utilities.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "base/errors.h"
#include "base/files.h"
#include "output/probes.h"
#include "output/result_files.h"
#include "output/result_tables.h"
#include "solid/stress_recovery.h"
#include "tests.h"

using namespace Tests;

namespace
{
  using Stresses = std::vector<SymmetricTensor<2, 3>>;
  using Rows     = std::vector<ProfileRow>;

  // Each block has one cell cut into triangles; the wide lower one has other
  // nodes than the upper one. The upper one may bulge towards x = 2/3.
  Parameters::All two_blocks(const unsigned int degree,
                             const std::string &rule,
                             const bool         wide  = false,
                             const double       bulge = 0)
  {
    const auto cut = [](const unsigned int i, const unsigned int j) {
      return i == 1 && j == 0;
    };
    const auto upper = [=](const double s, const double t) {
      return Point<2>(2 * s, t + bulge * std::pow(2 * s - 2. / 3, 2));
    };
    MeshText mesh;
    if (wide)
      mesh.block("lower", 7, 2, rectangle({-1, -1}, {4, 0}), cut);
    else
      mesh.block("lower", 3, 2, rectangle({0, -1}, {2, 0}), cut);
    mesh.block("upper", 3, 2, upper, cut);

    auto parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave          = "upper bottom";
    parameters.contact.master         = "lower top";
    parameters.contact.discretization = rule;
    return parameters;
  }



  Point<2> stay(const Point<2> &X)
  {
    return X;
  }



  // A model in a given configuration, paired.
  struct PlacedModel : public ContactModel
  {
    PlacedModel(const Parameters::All                           &parameters,
                const std::function<Point<2>(const Point<2> &)> &position)
      : ContactModel(parameters)
    {
      const Vector<double> u = displacement(position);
      std::copy(u.begin(), u.end(), solution.begin());
      interface.pair(solution);
    }
  };



  // The profiles of slave and master.
  std::array<Rows, 2> profiles(const ContactModel                 &model,
                               const Stresses                     &stresses,
                               const std::optional<ExactSolution> &exact = {})
  {
    const auto &disc  = model.discretization;
    const Rows  slave = slave_profile(model.interface,
                                     *model.interface.pairs[0],
                                     disc,
                                     stresses,
                                     model.solution,
                                     model.start,
                                     exact);
    return {{slave,
             master_profile(model.interface,
                            *model.interface.pairs[0],
                            disc,
                            stresses,
                            model.solution,
                            slave,
                            exact)}};
  }



  double deviation(const Rows &rows,
                   double ProfileRow::*const column,
                   const double              value)
  {
    double largest = 0;
    for (const ProfileRow &row : rows)
      largest = std::max(largest, std::abs(row.*column - value));
    return largest;
  }



  // Proves that under a uniform pressure all curves agree: multiplier, pressure
  // from the volume stresses of both bodies, and the nodal forces, which add up
  // to pressure times width; and that both profiles run alike, over the width
  // of the blocks before and after.
  void check_uniform_pressure(const unsigned int degree,
                              const std::string &rule)
  {
    headline("uniform pressure, degree " + std::to_string(degree) + ", " +
             rule);
    Parameters::All parameters         = two_blocks(degree, rule);
    parameters.boundary.displacement_x = {{"lower left", 0}, {"upper left", 0}};
    parameters.boundary.displacement_y = {{"lower bottom", 0},
                                          {"upper top", -0.02}};
    ContactModel model(parameters);
    check("converged", model.solve(1, false) > 0);
    const StressRecovery recovery(model.discretization);

    // Both blocks together are 2 high.
    const double   p     = 1000 / (1 - 0.3 * 0.3) * 0.01;
    const double   width = 2 * (1 + 0.3 / (1 - 0.3) * 0.01);
    const Stresses stresses =
      recovery.vertex_stresses(*model.elasticity, model.solution);
    for (const Rows &rows : profiles(model, stresses))
      {
        using Row = ProfileRow;
        check_small("pressure", deviation(rows, &Row::pressure, p), 1e-9);
        check_small("extrapolated pressure",
                    deviation(rows, &Row::extrapolated_pressure, p),
                    1e-9);
        check_small("gap", deviation(rows, &Row::gap, 0), 1e-12);

        double force = -2 * p;
        for (const ProfileRow &row : rows)
          force += row.nodal_force;
        check_small("nodal forces", std::abs(force), 1e-9);
        check("slips without friction", rows[1].status == 1);
        check("from x = 0 to 2", rows[0].X[0] == 0 && rows.back().X[0] == 2);
        check_small("widths",
                    std::abs(rows.back().arc_length - 2) +
                      std::abs(rows.back().deformed_arc_length - width),
                    1e-12);
      }
  }



  // Proves the interpolation: of multipliers that are linear along the slave
  // the master nodes have the same values, and nothing where no slave is. A
  // node excluded from contact has the status -1.
  void check_master_nodes(const unsigned int degree)
  {
    headline("master nodes, degree " + std::to_string(degree));
    Parameters::All parameters         = two_blocks(degree, "nodal", true);
    parameters.contact.excluded_points = {"upper bottom right"};
    PlacedModel model(parameters, stay);

    const auto &interface = model.interface;
    for (unsigned int n = 0; n < interface.pairs[0]->slave.nodes.size(); ++n)
      {
        const unsigned int k = interface.pairs[0]->multipliers.of_node[n];
        if (k != numbers::invalid_unsigned_int)
          model.solution[interface.normal_index(k)] =
            2 - interface.pairs[0]->slave.nodes[n].X[0];
      }

    const auto [slave, master] =
      profiles(model, Stresses(model.mesh.triangulation.n_vertices()));
    double error             = 0;
    bool   beyond_is_nothing = true;
    for (const ProfileRow &row : master)
      if (row.X[0] >= 0 && row.X[0] <= 2)
        error = std::max(error, std::abs(row.pressure + row.X[0] - 2));
      else
        beyond_is_nothing =
          beyond_is_nothing && row.status == -1 && row.pressure == 0;
    check_small("interpolated pressure", error, 1e-12);
    check("nothing beyond the slave", beyond_is_nothing);
    check("excluded node", slave[0].status == 0 && slave.back().status == -1);
  }



  // Proves that the axis of the Hertz contact is where the slave is nearest to
  // the master, for both of them.
  void check_hertz_axis(const unsigned int degree)
  {
    headline("Hertz axis, degree " + std::to_string(degree));
    Parameters::All parameters = two_blocks(degree, "nodal", true, 0.1);
    parameters.probes.hertz    = {5, 100};
    const PlacedModel model(parameters, stay);
    const Stresses    stresses(model.mesh.triangulation.n_vertices());
    const auto        exact =
      make_exact_solution(parameters,
                          model.discretization,
                          *model.interface.pairs[0],
                          contact_results(model.interface,
                                          *model.interface.pairs[0],
                                          model.solution,
                                          model.start));
    for (const Rows &rows : profiles(model, stresses, exact))
      for (const ProfileRow &row : rows)
        if (row.exact_pressure > 0)
          std::cout << "  x " << row.X[0] << ", p/p0 "
                    << row.exact_pressure / exact->values.at("max_pressure")
                    << std::endl;
  }



  // Proves that normals and arc lengths are those of the deformed surface: the
  // stress turned along with the bodies presses the same at every node.
  void check_rotation(const unsigned int degree)
  {
    headline("rotation, degree " + std::to_string(degree));
    const Tensor<2, 2> R = rotation(0.5);
    const PlacedModel  model(two_blocks(degree, "Gauss"), [&](const auto &X) {
      return Point<2>(1.5 * (R * X));
    });

    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = i; j < 2; ++j)
        stress[i][j] = 3 * R[i][0] * R[j][0] - 7 * R[i][1] * R[j][1];
    for (const Rows &rows :
         profiles(model,
                  Stresses(model.mesh.triangulation.n_vertices(), stress)))
      {
        check_small("extrapolated pressure",
                    deviation(rows, &ProfileRow::extrapolated_pressure, 7),
                    1e-12);
        check_small("deformed arc length",
                    std::abs(rows.back().deformed_arc_length - 3),
                    1e-12);
      }
  }



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
        else if (types[c] > 60)
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
  // and 9 linear, 69 and 70 quadratic triangles and quadrangles, 3 lines), with
  // the nodes in VTK's order; that a series is whole after every increment; and
  // that the profile is a table.
  void check_files(const unsigned int degree)
  {
    headline("files, degree " + std::to_string(degree));
    const PlacedModel model(two_blocks(degree, "nodal"), stay);
    const Stresses    stresses(model.mesh.triangulation.n_vertices());
    const auto [slave, master] = profiles(model, stresses);

    const std::vector<PairProfile> pairs{
      {"", &model.interface.pairs[0]->slave, slave, master}};

    const std::filesystem::path directory = "files/nested";
    ResultFiles                 files(directory, model.discretization);
    for (unsigned int k = 1; k <= 2; ++k)
      {
        files.write_bodies(k, 0.5 * k, stresses, model.solution);
        files.write_contact(k, 0.5 * k, pairs);
        for (const std::string name : {"bodies", "contact"})
          {
            const std::string pvd = contents(directory / (name + ".pvd"));
            std::cout << "  " << name << ".pvd names "
                      << (pvd.find("_0001.vtu") != pvd.npos) +
                           (pvd.find("_0002.vtu") != pvd.npos)
                      << std::endl;
            check("is closed", pvd.find("</VTKFile>") != pvd.npos);
          }
      }
    check_cells(directory / "bodies_0002.vtu");
    check_cells(directory / "contact_0002.vtu");

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
    for (const auto &[name, quantity] : named_values(Parameters::Quantity()))
      if (!is_contact_traction(quantity))
        std::cout << "  " << name << ' '
                  << probe_value(quantity,
                                 3,
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
    good.probes    = {{"DY", true, -1.30001, -1.3, 1e-4, {}},
                      {"S", false, 2, {}, {}, {}}};
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
    std::cout
      << nlohmann::ordered_json::parse(contents("files/summary.json")).dump(1)
      << std::endl;
    check("peak memory", peak_memory_mb() > 10 && peak_memory_mb() < 1e5);
  }



  // Proves that a directory that can not be is refused with what, where and
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
    {
      for (const std::string rule : {"nodal", "Gauss"})
        check_uniform_pressure(degree, rule);
      check_master_nodes(degree);
      check_hertz_axis(degree);
      check_rotation(degree);
      check_files(degree);
    }
  check_probes();
  check_summary();
  check_unwritable();
}
