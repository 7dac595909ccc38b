/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mixed_cells_h
#define contact_mixed_cells_h

#include <vector>

#include "mesh/msh_file.h"

namespace Contact
{
  using namespace dealii;

  /// The corners of the faces of a hexahedron, wedge, pyramid or tetrahedron,
  /// each round its normal out of the cell, by the number of its corners. They
  /// are in gmsh's order.
  const std::vector<std::vector<unsigned int>> &
  faces_of_volume(const unsigned int n_corners);

  /**
   * Split cells into tetrahedra, with the surfaces that they have: all that
   * hang together by nodes, unless they are hexahedra alone or tetrahedra
   * alone.
   *
   * A cell is split from its corner of the smallest number, which with each
   * triangle of the faces that it is not on makes a tetrahedron; a quadrangle
   * is split from its own such corner, so that neighbours agree (J. Dompierre
   * et al.: How to subdivide pyramids, prisms and hexahedra into tetrahedra.
   * 8th International Meshing Roundtable, 1999). New edges of cells of second
   * order have a middle: the node there or, without one, the place that the
   * edges of the face or of the hexahedron put it.
   *
   * Throws InputError where a cell is tangled, or where the triangles of a
   * neighbour have the other diagonal of a quadrangle.
   */
  void split_mixed_cells(MshFile &msh);
} // namespace Contact

#endif
