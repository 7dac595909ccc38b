/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_msh_file_h
#define contact_msh_file_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * What a gmsh file says, in gmsh's own numbers and before anything is
   * concluded from it: nodes, elements and the names of physical groups.
   */
  struct MshFile
  {
    /// A point, a line, a triangle or a quadrangle.
    struct Element
    {
      /// gmsh's number, for messages.
      long number;

      /// The corners by node number, in gmsh's cyclic order; the mid-side and
      /// centre nodes of elements of second order are left out.
      std::vector<long> nodes;

      /// Tags of the physical groups the element belongs to; may be empty.
      std::vector<int> groups;
    };

    /// The file's own name, for messages.
    std::string name;

    /// Node number -> coordinates.
    std::map<long, Point<3>> nodes;

    /// By dimension: points, lines, cells. In the format 2.2 an element that
    /// belongs to two groups stands here twice.
    std::array<std::vector<Element>, 3> elements;

    /// By dimension: tag of a physical group -> its name.
    std::array<std::map<int, std::string>, 4> names;
  };



  /**
   * Read a gmsh file in MSH format 2.2 or 4.1, ASCII. Sections which are not
   * needed are skipped. Throws InputError with file and line if the file can
   * not be read, is of another format, is incomplete, or has elements other
   * than points, lines, triangles and quadrangles of first or second order.
   */
  MshFile read_msh(const std::string &file);
} // namespace Contact

#endif
