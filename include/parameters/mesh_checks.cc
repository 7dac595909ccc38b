/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Conditions on the entries of the section Mesh, beyond their patterns.

#include <deal.II/base/utilities.h>

#include <algorithm>

#include "base/string_utilities.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void Mesh::check() const
    {
      if (!(scale > 0))
        throw EntryError("Mesh/Scale is " + Utilities::to_string(scale) +
                           ", but has to be positive.",
                         {"Mesh/Scale"},
                         "set a value greater than 0");
      check_vectors();
      if (file.empty())
        throw EntryError("There is no mesh.",
                         {"Mesh/File"},
                         "set 'File' in section 'Mesh' to a gmsh file");
      for (const auto &[name, condition] : faces)
        {
          check_place_formula(condition, "Mesh/Faces");
          // An assignment, which is the value and no condition.
          for (std::size_t i = 0; i < condition.size(); ++i)
            if (condition[i] == '=' && condition[i + 1] != '=' &&
                (i == 0 || std::string("<>=!").find(condition[i - 1]) ==
                             std::string::npos))
              throw EntryError("The condition " + in_quotes(condition) +
                                 " has a single '='.",
                               {"Mesh/Faces"},
                               "leave room for round-off, as in 'y > 9.99' or "
                               "'abs(x) < 0.01'");
        }
      check_round_surfaces();
    }



    void Mesh::check_vectors() const
    {
      const auto is_vector = [](const std::vector<double> &vector) {
        return vector.size() == 2 || vector.size() == 3;
      };
      if (!is_vector(shift))
        throw EntryError("The shift of the mesh is not a vector.",
                         {"Mesh/Shift"},
                         "write 'x, y', in mm");
      for (const auto &[body, vector] : move)
        if (!is_vector(vector))
          throw EntryError("The move of " + in_quotes(body) +
                             " is not a vector.",
                           {"Mesh/Move"},
                           "write '" + body + ": dx, dy', in mm");
      if (rotation.size() != 1 && rotation.size() != 3)
        throw EntryError("The rotation of the mesh is neither an angle nor "
                         "three.",
                         {"Mesh/Rotation"},
                         "write an angle in degrees; for volumes one or three");
    }



    void Mesh::check_round_surfaces() const
    {
      for (const auto &[group, arc] : arcs)
        if (arc.size() != 3 || !(arc[2] > 0))
          throw EntryError("The arc " + in_quotes(group) + " is not a circle.",
                           {"Mesh/Arcs"},
                           "write '" + group +
                             ": centre x, centre y, radius' with a positive "
                             "radius");

      // The numbers of a surface: a place, an axis or none, positive sizes.
      const auto check = [](const auto        &surfaces,
                            const std::string &entry,
                            const bool         has_axis,
                            const unsigned int n_sizes,
                            const std::string &remedy) {
        const unsigned int first = has_axis ? 6 : 3;
        for (const auto &[group, numbers] : surfaces)
          {
            const bool is_complete = numbers.size() == first + n_sizes;
            if (is_complete &&
                std::all_of(numbers.begin() + first,
                            numbers.end(),
                            [](const double size) { return size > 0; }) &&
                (!has_axis || numbers[3] != 0 || numbers[4] != 0 ||
                 numbers[5] != 0))
              continue;
            throw EntryError("The surface of " + in_quotes(group) + " " +
                               (is_complete
                                  ? "has no axis or no positive size."
                                  : "does not have the numbers that it needs."),
                             {entry},
                             "write '" + group + ": " + remedy + "'");
          }
      };
      const std::string axis = "x, y, z, axis x, y, z, ";
      check(spheres, "Mesh/Spheres", false, 1, "x, y, z, radius");
      check(cylinders, "Mesh/Cylinders", true, 1, axis + "radius");
      check(cones, "Mesh/Cones", true, 1, axis + "angle");
      check(tori, "Mesh/Tori", true, 2, axis + "radius of ring, of tube");
      for (const auto &[group, cone] : cones)
        if (!(cone[6] < 90))
          throw EntryError("The cone " + in_quotes(group) +
                             " has an angle of 90 degrees or more.",
                           {"Mesh/Cones"},
                           "set the angle between its axis and its surface");
    }
  } // namespace Parameters
} // namespace Contact
