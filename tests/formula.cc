/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Formulas of the user: their values, what is said about broken ones, and the
// entries of the parameters that hold them.

#include "parameters/formula.h"

#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tests.h"

using namespace Tests;

namespace
{
  template<int n>
  void check_value(const std::string &formula,
                   const std::string &variables,
                   const Point<n>    &p,
                   const double       value)
  {
    const auto         function = parse_formula<n>(formula, variables, "entry");
    std::ostringstream text;
    text << formula << " at " << p;
    check_small(text.str(), std::abs(function(p) - value), 1e-14);
  }



  // Proves that the variables have their order, that there are pi, min, max
  // and if, and that functions made before others stay what they are.
  void check_values()
  {
    headline("values");
    const double pi = numbers::PI;
    check_value("2*t + 1", "t", Point<1>(0.25), 1.5);
    check_value("min(1, 2*t)", "t", Point<1>(0.25), 0.5);
    check_value("min(1, 2*t)", "t", Point<1>(0.75), 1);
    check_value("max(0, 2*t - 1)", "t", Point<1>(0.25), 0);
    check_value("max(0, 2*t - 1)", "t", Point<1>(0.75), 0.5);
    check_value("if(t < 0.5, 3, 4)", "t", Point<1>(0.25), 3);
    check_value("if(t < 0.5, 3, 4)", "t", Point<1>(0.75), 4);
    check_value("7", "t", Point<1>(0.75), 7);
    check_value("x - 2*y", "x,y", Point<2>(3, 4), -5);
    check_value("sin(pi*x)/pi + y^3", "x,y", Point<2>(0.5, 2), 1 / pi + 8);
    check_value("(x^2 - y^2)/(x^2 + y^2)", "x,y", Point<2>(2, 1), 0.6);

    const auto first  = parse_formula<1>("t", "t", "entry");
    const auto second = parse_formula<1>("2*t", "t", "entry");
    const auto copy   = first;
    check("two functions at a time",
          first(Point<1>(3)) == 3 && second(Point<1>(3)) == 6 &&
            copy(Point<1>(4)) == 4);
  }



  // Proves that a formula that cannot be read is refused by an error that
  // quotes it, and names the variables there are.
  void check_broken()
  {
    headline("broken formulas");
    for (const std::string formula :
         {"", "2*", "x + z", "sin(x", "x y", "f(x)", "x,y"})
      try
        {
          parse_formula<2>(formula, "x,y", "entry");
          check("'" + formula + "' is refused", false);
        }
      catch (const std::runtime_error &error)
        {
          std::cout << "  " << error.what() << std::endl;
        }
  }



  // Proves that a table is linear between its pairs, constant beyond, that a
  // history may as well be a formula, and that a broken table is refused with
  // the reason.
  void check_tables()
  {
    headline("tables");
    const auto table = parse_history(" table (0 0, 0.5 1,1 -1e0 ) ", "entry");
    for (const auto &[t, value] : std::map<double, double>{{-1, 0},
                                                           {0, 0},
                                                           {0.125, 0.25},
                                                           {0.5, 1},
                                                           {0.75, 0},
                                                           {0.875, -0.5},
                                                           {1, -1},
                                                           {2, -1}})
      check("t = " + std::to_string(t), table(Point<1>(t)) == value);
    const auto constant = parse_history("table(0.5 3)", "entry");
    check("one pair", constant(Point<1>(0)) == 3 && constant(Point<1>(1)) == 3);
    check("a formula", parse_history("2*t", "entry")(Point<1>(3)) == 6);
    for (const std::string history : {"table",
                                      "table 0 0, 1 1",
                                      "table()",
                                      "table(0 0, 1)",
                                      "table(0 0; 1 1)",
                                      "table(0 0, 1 1 1)",
                                      "table(0 0, 0 1)",
                                      "table(0 0, 1 x)",
                                      "table(0 0, 1 1,)",
                                      "table(1 0, 0 1)",
                                      "2*"})
      try
        {
          parse_history(history, "entry");
          check("'" + history + "' is refused", false);
        }
      catch (const std::runtime_error &error)
        {
          std::cout << "  " << error.what() << std::endl;
        }
  }



  using Map = std::map<std::string, std::string>;

  void report_boundary(const Map &pressure, const Map &histories)
  {
    Parameters::Boundary boundary;
    boundary.pressure  = pressure;
    boundary.histories = histories;
    try
      {
        boundary.check();
        std::cout << "  accepted" << std::endl;
      }
    catch (const EntryError &error)
      {
        std::cout << "  " << error.problem << " ->";
        for (const std::string &entry : error.entries)
          std::cout << ' ' << entry;
        std::cout << " -> " << error.remedy << std::endl;
      }
  }



  // Proves that a wrong formula or history is an error that names the entry
  // and says what is wrong with it: pressures are formulas in x and y,
  // histories in t, and only of what grows with the load.
  void check_boundary()
  {
    headline("boundary conditions");
    report_boundary({{"Top", "1 + x*y"}, {"Side", "3"}}, {});
    report_boundary({{"Top", "1 + x*y"}, {"Side", "3*"}}, {});
    report_boundary({{"Top", "t"}}, {});
    report_boundary({}, {{"Force y", "min(1, 2*t)"}, {"Pressure", "x"}});
    report_boundary({}, {{"Force w", "t"}});
    report_boundary({}, {{"Tied y", "t"}});
    report_boundary({}, {{"Force y", "table(0 0, 0.5 1, 1 0)"}});
    report_boundary({}, {{"Force y", "table(0 0, 0.5 1, 0.4 0)"}});
    report_boundary({{"Top", "table(0 0, 1 1)"}}, {});
    report_boundary({}, {{"Histories", "t"}});
    Map all;
    for (const std::string entry : {"Displacement", "Force", "Resultant force"})
      for (const std::string component : {" x", " y"})
        all[entry + component] = "t^2";
    all["Pressure"] = "1 - t";
    report_boundary({}, all);
  }



  void report_probe(const std::vector<std::string> &probe)
  {
    Parameters::Probes probes;
    probes.probes["name"] = probe;
    try
      {
        probes.check(Parameters::Symmetry::plane_strain);
        std::cout << "  accepted" << std::endl;
      }
    catch (const EntryError &error)
      {
        std::cout << "  " << error.problem << " -> " << error.entries.at(0)
                  << " -> " << error.remedy << std::endl;
      }
  }



  // Proves that a probe is a known quantity at one point or at two.
  void check_probes()
  {
    headline("probes");
    report_probe({"displacement y", "P"});
    report_probe({"displacement y", "P", "Q"});
    report_probe({"displacement y"});
    report_probe({"displacement y", "P", "Q", "R"});
    report_probe({"displacement y", ""});
    report_probe({"displacement y", "", "Q"});
    report_probe({"displacement y", "P", ""});
    report_probe({"torsion z", "P", "Q"});
  }



  // Proves that in a file the commas of a formula do not separate its entries,
  // and that two points are read as two.
  void check_file()
  {
    headline("file");
    std::ofstream("formulas.prm")
      << "subsection Mesh\n"
         "  set File = a.msh\n"
         "end\n"
         "subsection Solids\n"
         "  set Young's modulus = Block: 1\n"
         "  set Poisson's ratio = Block: 0\n"
         "end\n"
         "subsection Boundary conditions\n"
         "  set Pressure  = Top: 100 + max(x, y); Side: if(x > 1, 2, 3)\n"
         "  set Histories = Pressure: min(1, 2*t); Force x: max(0, 2*t - 1)\n"
         "end\n"
         "subsection Probes\n"
         "  set Probes = a: displacement y, P, Q; b: von Mises, P\n"
         "end\n";
    ParameterHandler prm;
    Parameters::All  parameters;
    read_parameters("formulas.prm", {}, prm, parameters);
    for (const auto *map :
         {&parameters.boundary.pressure, &parameters.boundary.histories})
      for (const auto &[entry, formula] : *map)
        std::cout << "  " << entry << " = " << formula << std::endl;
    for (const auto &[name, probe] : parameters.probes.probes)
      {
        std::cout << "  " << name << " =";
        for (const std::string &item : probe)
          std::cout << " '" << item << "'";
        std::cout << std::endl;
      }
  }
} // namespace



int main()
{
  // There the parser gives its own reasons, which are no part of this.
  std::cerr.setstate(std::ios_base::failbit);

  check_values();
  check_broken();
  check_tables();
  check_boundary();
  check_probes();
  check_file();
  return 0;
}
