/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/geometry.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <filesystem>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace Parameters
  {
    namespace
    {
      using Sizes      = std::map<std::string, double>;
      using Boundaries = std::map<std::string, std::vector<double>>;
      template<typename T>
      using Convert = Patterns::Tools::Convert<T>;
    } // namespace



    void Geometry::add_parameters(ParameterHandler &prm)
    {
      prm.declare_entry("Size",
                        "0",
                        Patterns::Double(0),
                        "Of the cells that gmsh makes [mm, in the coordinates "
                        "of the file]; 0: automatic, of a .geo its own, of CAD "
                        "files by body volume / surface (2-D: area / "
                        "perimeter). Round boundaries have at least 12 cells a "
                        "turn; surfaces of contact have half of all that.");
      prm.declare_entry("Sizes",
                        "",
                        *Convert<Sizes>::to_pattern(),
                        "Instead of these 'name: size' [mm], separated by ','; "
                        "of bodies and boundaries; > 0.");
      prm.declare_entry("Order",
                        "0",
                        Patterns::Integer(0, 2),
                        "Order of the elements that gmsh makes [-]; 2: sides "
                        "of cells are curved by their mid-side nodes, which "
                        "are on the boundary; 0: automatic, of a .geo its own, "
                        "else 2.");
      prm.declare_entry("Boundaries",
                        "",
                        *Convert<Boundaries>::to_pattern(),
                        "Names of boundaries of a CAD file: 'name: x, y, z' of "
                        "a point on it, or of several one after the other, "
                        "2-D: 'x, y' [mm, in the coordinates of the file], "
                        "separated by ';'; 'name in body: x, y, z' where "
                        "bodies touch.");
    }



    Geometry::Geometry(ParameterHandler &prm)
    {
      prm.enter_subsection("Mesh");
      size       = prm.get_double("Size");
      order      = prm.get_integer("Order");
      sizes      = Convert<Sizes>::to_value(prm.get("Sizes"));
      boundaries = Convert<Boundaries>::to_value(prm.get("Boundaries"));
      prm.leave_subsection();
      for (const auto &[name, own] : sizes)
        if (!(own > 0))
          throw InputError("the size of " + in_quotes(name) + " is " +
                             Utilities::to_string(own) +
                             ", but has to be positive",
                           "entry 'Mesh/Sizes'",
                           "write '" + name + ": size', in mm");
    }



    std::map<std::string, std::string>
    Geometry::idle_entries(const std::string &file) const
    {
      std::map<std::string, std::string> idle;
      const auto note = [&](const bool is_set, const std::string &entry) {
        if (is_set && source_of(file) == Source::mesh)
          idle["Mesh/" + entry] = "the file is a mesh, no .geo or CAD file";
      };
      note(size != 0, "Size");
      note(order != 0, "Order");
      note(!sizes.empty(), "Sizes");
      note(!boundaries.empty(), "Boundaries");
      return idle;
    }



    Geometry::Source Geometry::source_of(const std::string &file)
    {
      static const std::map<std::string, Source> sources = {
        {".geo", Source::geo},
        {".step", Source::cad},
        {".stp", Source::cad},
        {".brep", Source::cad}};
      const auto found = sources.find(
        lower_case(std::filesystem::path(file).extension().string()));
      return found == sources.end() ? Source::mesh : found->second;
    }
  } // namespace Parameters
} // namespace Contact
