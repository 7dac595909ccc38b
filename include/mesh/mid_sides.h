/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mid_sides_h
#define contact_mid_sides_h

#include <deal.II/base/point.h>

#include <map>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// The middle of an edge or, in 3-D, of a face, by its vertices in
  /// ascending order.
  template<int dim>
  using MidSides = std::map<std::vector<unsigned int>, Point<dim>>;

  /// Take over the nodes on the middles of the sides of an element of gmsh,
  /// whose corners come first, by these corners in ascending order.
  void add_mid_sides(const unsigned int                 dimension,
                     const unsigned int                 n_corners,
                     const std::vector<long>           &nodes,
                     std::map<std::vector<long>, long> &mid_sides);
} // namespace Contact

#endif
