/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_geometry_h
#define contact_geometry_h

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// How gmsh meshes a geometry that Mesh/File names: entries of the section
    /// Mesh that nothing but CadModel needs.
    struct Geometry
    {
      double       size  = 0; // of cells [mm]; 0: automatic
      unsigned int order = 0; // of elements; 0: automatic

      /// Body or boundary -> size of its cells [mm].
      std::map<std::string, double> sizes;

      /// Boundary group, 'name' or 'name in body' -> coordinates of points on
      /// it [mm], one after the other.
      std::map<std::string, std::vector<double>> boundaries;

      /// Declare the entries, in the section Mesh.
      static void add_parameters(ParameterHandler &prm);

      /// Their values. Throws InputError.
      explicit Geometry(ParameterHandler &prm);

      /// Those that are set and have no effect, as All::idle_entries().
      std::map<std::string, std::string>
      idle_entries(const std::string &file) const;

      /// The kind of Mesh/File, by the end of its name.
      enum class Source
      {
        mesh,
        geo, // a description in gmsh's own language, which makes the mesh
        cad  // so of this
      };
      static Source source_of(const std::string &file);
    };
  } // namespace Parameters
} // namespace Contact

#endif
