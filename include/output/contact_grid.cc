/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/contact_grid.h"

namespace Contact
{
  namespace
  {
    void add_vector(const Tensor<1, 3> &vector, VtuField &field)
    {
      for (unsigned int c = 0; c < 3; ++c)
        field.values.push_back(vector[c]);
    }

    Tensor<1, 3> in_three(const Tensor<1, 2> &vector)
    {
      return Point<3>(vector[0], vector[1], 0);
    }

    Tensor<1, 3> in_three(const Tensor<1, 3> &vector)
    {
      return vector;
    }



    void
    add_tangential(const ProfileRow<2> &row, VtuField &shear, VtuField &slip)
    {
      shear.values.push_back(row.shear);
      slip.values.push_back(row.slip);
    }

    void
    add_tangential(const ProfileRow<3> &row, VtuField &shear, VtuField &slip)
    {
      add_vector(row.shear_vector, shear);
      add_vector(row.slip_vector, slip);
    }



    void add_facet(const SurfaceFacet<2> &edge, VtuGrid &grid)
    {
      const auto add_line = [&](const unsigned int a, const unsigned int b) {
        grid.add_cell<1>({static_cast<std::int32_t>(edge.nodes[a]),
                          static_cast<std::int32_t>(edge.nodes[b])},
                         {Point<1>(0), Point<1>(1)});
      };
      if (edge.kind->degree == 1)
        return add_line(0, 1);
      add_line(0, 2);
      add_line(2, 1);
    }

    void add_facet(const SurfaceFacet<3> &facet, VtuGrid &grid)
    {
      std::vector<Point<2>> units;
      for (const Point<2> &place : facet.kind->places)
        units.emplace_back((place[0] + 1) / 2, (place[1] + 1) / 2);
      grid.add_cell<2>({facet.nodes.begin(),
                        facet.nodes.begin() + facet.n_nodes()},
                       units);
    }
  } // namespace



  template<int dim>
  VtuGrid contact_grid(const PairProfile<dim> &contact_pair)
  {
    const unsigned int n_tangential = dim == 2 ? 1 : 3;
    VtuField           displacement{"displacement", "mm", 3, {}};
    VtuField           pressure{"pressure", "MPa", 1, {}};
    VtuField           shear{"shear", "MPa", n_tangential, {}};
    VtuField           gap{"gap", "mm", 1, {}};
    VtuField           slip{"slip", "mm", n_tangential, {}};
    VtuField           status{"status", "", 1, {}};
    VtuGrid            grid;
    for (const ProfileRow<dim> &row : contact_pair.slave_rows)
      {
        grid.add_point(row.X);
        add_vector(in_three(row.u), displacement);
        pressure.values.push_back(row.pressure);
        add_tangential(row, shear, slip);
        gap.values.push_back(row.gap);
        status.values.push_back(row.status);
      }
    grid.at_points = {displacement, pressure, shear, gap, slip, status};
    for (const SurfaceFacet<dim> &facet : contact_pair.slave->facets)
      add_facet(facet, grid);
    return grid;
  }

  template VtuGrid contact_grid(const PairProfile<2> &);
  template VtuGrid contact_grid(const PairProfile<3> &);
} // namespace Contact
