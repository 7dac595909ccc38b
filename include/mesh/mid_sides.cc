/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/mid_sides.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    using Sides = std::vector<std::vector<unsigned int>>;

    /// The corners of the edges and faces of a volume and of the volume itself,
    /// in the order of the nodes on their middles.
    const Sides tetrahedron_sides =
      {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
    const Sides pyramid_sides    = {{0, 1},
                                    {0, 3},
                                    {0, 4},
                                    {1, 2},
                                    {1, 4},
                                    {2, 3},
                                    {2, 4},
                                    {3, 4},
                                    {0, 1, 2, 3}};
    const Sides wedge_sides      = {{0, 1},
                                    {0, 2},
                                    {0, 3},
                                    {1, 2},
                                    {1, 4},
                                    {2, 5},
                                    {3, 4},
                                    {3, 5},
                                    {4, 5},
                                    {0, 1, 3, 4},
                                    {0, 2, 3, 5},
                                    {1, 2, 4, 5}};
    const Sides hexahedron_sides = {{0, 1},
                                    {0, 3},
                                    {0, 4},
                                    {1, 2},
                                    {1, 5},
                                    {2, 3},
                                    {2, 6},
                                    {3, 7},
                                    {4, 5},
                                    {4, 7},
                                    {5, 6},
                                    {6, 7},
                                    {0, 1, 2, 3},
                                    {0, 1, 4, 5},
                                    {0, 3, 4, 7},
                                    {1, 2, 5, 6},
                                    {2, 3, 6, 7},
                                    {4, 5, 6, 7},
                                    {0, 1, 2, 3, 4, 5, 6, 7}};

    const Sides &sides_of_volume(const unsigned int n_corners)
    {
      switch (n_corners)
        {
          case 4:
            return tetrahedron_sides;
          case 5:
            return pyramid_sides;
          case 6:
            return wedge_sides;
          default:
            return hexahedron_sides;
        }
    }
  } // namespace



  // Behind the corners stand those of the edges, then those of faces.
  void add_mid_sides(const unsigned int                 dimension,
                     const unsigned int                 n_corners,
                     const std::vector<long>           &nodes,
                     std::map<std::vector<long>, long> &mid_sides)
  {
    const Sides       &of_volume = sides_of_volume(n_corners);
    const unsigned int n_sides =
      dimension == 3 ? of_volume.size() : dimension * n_corners / 2;
    for (unsigned int s = 0; s < n_sides && n_corners + s < nodes.size(); ++s)
      {
        std::vector<long> corners;
        if (dimension == 3)
          for (const unsigned int corner : of_volume[s])
            corners.push_back(nodes[corner]);
        else
          corners = {nodes[s], nodes[(s + 1) % n_corners]};
        std::sort(corners.begin(), corners.end());
        mid_sides[corners] = nodes[n_corners + s];
      }
  }
} // namespace Contact
