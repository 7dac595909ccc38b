/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The errors of a result against a closed form, from the files that the program
// has written: in the bodies by nodes.csv (not refined adaptively), on the
// slave by profile.csv. Prints them, and the values of the closed form, as
// JSON.
//   closed_form_errors FORM FILE [--set ENTRY=VALUE]... DIRECTORY
// FORM is 'name: number, number, ...', see ClosedForm; FILE and its entries are
// those of the run, DIRECTORY its results.

#include <nlohmann/json.hpp>

#include "closed_forms/exact_solution.h"
#include "output/node_table.h"

using namespace Tests;

namespace
{
  using Fields = std::vector<std::string>;

  std::vector<Fields> read_csv(const std::string &name)
  {
    std::ifstream       file(name);
    std::vector<Fields> rows;
    for (std::string line; std::getline(file, line);)
      rows.push_back(Utilities::split_string_list(line, ','));
    AssertThrow(!rows.empty(), ExcMessage("There is no " + name + "."));
    return rows;
  }



  ClosedForm closed_form(const std::string &text)
  {
    const Fields parts = Utilities::split_string_list(text, ':');
    return {parts.at(0),
            Utilities::string_to_double(
              Utilities::split_string_list(parts.at(1), ','))};
  }



  SlaveTractions slave_tractions(const std::string &file,
                                 const unsigned int degree)
  {
    const auto rows   = read_csv(file);
    const auto column = [&](const std::string &name) {
      return std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    };
    const auto     x = column("X_mm"), y = column("Y_mm");
    const auto     p = column("pressure_MPa"), q = column("shear_MPa");
    SlaveTractions slave{degree, {}, {}, {}};
    for (const Fields &row : rows)
      if (row[0] == "slave")
        {
          slave.X.emplace_back(std::stod(row.at(x)), std::stod(row.at(y)));
          slave.pressure.push_back(std::stod(row.at(p)));
          slave.shear.push_back(std::stod(row.at(q)));
        }
    return slave;
  }



  /// Displacements from the table of the nodes of the same mesh.
  void read_nodes(const std::string &file, TwoBodies &model)
  {
    GhostedVector numbers(model.n_dofs());
    std::iota(numbers.begin(), numbers.end(), 0);
    const auto nodes = collect_nodes(model.discretization, numbers, {});
    const auto rows  = read_csv(file);
    AssertThrow(rows.size() == nodes.size() + 1,
                ExcMessage("The mesh has other nodes."));
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int c = 0; c < 2; ++c)
        {
          AssertThrow(std::abs(nodes[n].values[c] -
                               std::stod(rows[n + 1].at(2 + c))) < 1e-9,
                      ExcMessage("The mesh has other nodes."));
          model.solution[static_cast<unsigned int>(nodes[n].values[2 + c])] =
            std::stod(rows[n + 1].at(4 + c));
        }
  }
} // namespace



int main(int argc, char **argv)
{
  AssertThrow(argc >= 4, ExcMessage("FORM FILE [--set ENTRY=VALUE] DIRECTORY"));
  const std::string directory = argv[argc - 1];
  Parameters::All   parameters;
  ParameterHandler  prm;
  Fields            settings;
  for (int i = 4; i < argc - 1; i += 2)
    settings.emplace_back(argv[i]);
  read_parameters(argv[2], settings, prm, parameters);

  const auto summary =
    nlohmann::json::parse(std::ifstream(directory + "/summary.json"));
  ContactResults results;
  results.normal_force     = summary.at("contact").at("normal_force");
  results.tangential_force = summary.at("contact").at("tangential_force");

  TwoBodies  model(parameters);
  const auto exact =
    exact_solution(closed_form(argv[1]), parameters, model, results);
  if (exact.displacement)
    read_nodes(directory + "/nodes.csv", model);
  const nlohmann::json found{
    {"exact", exact.values},
    {"errors",
     solution_errors(exact,
                     model,
                     slave_tractions(directory + "/profile.csv",
                                     parameters.element.degree))}};
  std::cout << found << std::endl;
  return 0;
}
