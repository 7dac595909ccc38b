/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_dimension_h
#define contact_dimension_h

namespace Contact
{
  /**
   * Where the plane and space differ in a number or a word alone.
   */
  template<int dim>
  struct Dimension;

  template<>
  struct Dimension<2>
  {
    /// The axes of rotation, which are the last ones of x, y, z.
    static constexpr unsigned int n_rotations = 1;
    static constexpr unsigned int first_axis  = 2;

    static constexpr const char *coordinates = "x,y";
    static constexpr const char *moment_unit = "N"; // by thickness

    /// The words of gmsh for a body and for its boundary.
    static constexpr const char *body         = "surface";
    static constexpr const char *body_keyword = "Surface";
    static constexpr const char *boundary     = "line";

    /// Our own for a facet, and for how far contact reaches.
    static constexpr const char *facet  = "edge";
    static constexpr const char *extent = "width";

    static constexpr const char *simplices  = "triangles";
    static constexpr const char *hypercubes = "quadrangles";

    static constexpr const char *shapes_of_cells =
      "quadrangles have to be convex with four corners, triangles need an area";
  };

  template<>
  struct Dimension<3>
  {
    static constexpr unsigned int n_rotations = 3;
    static constexpr unsigned int first_axis  = 0;

    static constexpr const char *coordinates = "x,y,z";
    static constexpr const char *moment_unit = "N mm";

    static constexpr const char *body         = "volume";
    static constexpr const char *body_keyword = "Volume";
    static constexpr const char *boundary     = "surface";

    static constexpr const char *facet  = "face";
    static constexpr const char *extent = "area";

    static constexpr const char *simplices  = "tetrahedra";
    static constexpr const char *hypercubes = "hexahedra";

    static constexpr const char *shapes_of_cells =
      "at each corner of a hexahedron the three edges have to span a volume, of "
      "one orientation; tetrahedra need a volume";
  };
} // namespace Contact

#endif
