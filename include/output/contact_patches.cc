/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/contact_patches.h"

namespace Contact
{
  using DataComponentInterpretation::component_is_part_of_vector;

  template<>
  const std::vector<std::string> &contact_fields<2>()
  {
    static const std::vector<std::string> names{"displacement",
                                                "displacement",
                                                "pressure",
                                                "shear",
                                                "gap",
                                                "slip",
                                                "status"};
    return names;
  }

  template<>
  const std::vector<std::string> &contact_fields<3>()
  {
    static const std::vector<std::string> names{"displacement",
                                                "displacement",
                                                "displacement",
                                                "shear",
                                                "shear",
                                                "shear",
                                                "slip",
                                                "slip",
                                                "slip",
                                                "pressure",
                                                "gap",
                                                "status"};
    return names;
  }



  template<>
  VectorFields contact_vectors<2>()
  {
    return {{0, 1, "displacement", component_is_part_of_vector}};
  }

  template<>
  VectorFields contact_vectors<3>()
  {
    return {{0, 2, "displacement", component_is_part_of_vector},
            {3, 5, "shear", component_is_part_of_vector},
            {6, 8, "slip", component_is_part_of_vector}};
  }



  unsigned int contact_cell_degree(const Surface<2> &)
  {
    return 1;
  }

  unsigned int contact_cell_degree(const Surface<3> &slave)
  {
    return slave.degree;
  }



  namespace
  {
    /// Their values in a row, and the position.
    std::vector<double> contact_values(const ProfileRow<2> &row)
    {
      return {row.u[0],
              row.u[1],
              row.pressure,
              row.shear,
              row.gap,
              row.slip,
              double(row.status),
              row.X[0],
              row.X[1]};
    }

    std::vector<double> contact_values(const ProfileRow<3> &row)
    {
      std::vector<double> values;
      for (const Tensor<1, 3> &vector :
           {Tensor<1, 3>(row.u), row.shear_vector, row.slip_vector})
        for (unsigned int c = 0; c < 3; ++c)
          values.push_back(vector[c]);
      values.insert(values.end(),
                    {row.pressure,
                     row.gap,
                     double(row.status),
                     row.X[0],
                     row.X[1],
                     row.X[2]});
      return values;
    }



    /// A patch wants its points along its coordinates, the first one fastest.
    std::vector<unsigned int> points_of_patch(const Surface<2> &,
                                              const unsigned int degree)
    {
      return degree == 1 ? std::vector<unsigned int>{0, 1}
                         : std::vector<unsigned int>{0, 2, 1};
    }

    std::vector<unsigned int> points_of_patch(const Surface<3> &,
                                              const unsigned int degree)
    {
      return degree == 1 ? std::vector<unsigned int>{0, 1, 2, 3}
                         : std::vector<unsigned int>{0, 6, 1, 4, 8, 5, 2, 7, 3};
    }



    /// A facet of the slave surface with the fields above, then its position.
    template<int dim>
    DataOutBase::Patch<dim - 1, dim>
    make_patch(const Surface<dim>                 &slave,
               const std::vector<ProfileRow<dim>> &rows,
               const unsigned int                  e)
    {
      const auto &nodes = slave.facets[e].nodes;
      const auto  order = points_of_patch(slave, slave.degree);

      DataOutBase::Patch<dim - 1, dim> patch;
      for (unsigned int v = 0; v < GeometryInfo<dim - 1>::vertices_per_cell;
           ++v)
        patch.vertices[v] = rows[nodes[v]].X;
      patch.reference_cell       = ReferenceCells::get_hypercube<dim - 1>();
      patch.n_subdivisions       = slave.degree;
      patch.points_are_available = true;
      patch.data.reinit(contact_fields<dim>().size() + dim, order.size());
      for (unsigned int i = 0; i < order.size(); ++i)
        {
          unsigned int c = 0;
          for (const double value : contact_values(rows[nodes[order[i]]]))
            patch.data(c++, i) = value;
        }
      return patch;
    }
  } // namespace



  template<int dim>
  std::vector<DataOutBase::Patch<dim - 1, dim>>
  contact_patches(const std::vector<PairProfile<dim>> &pairs)
  {
    std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
    for (const PairProfile<dim> &contact_pair : pairs)
      for (unsigned int e = 0; e < contact_pair.slave->facets.size(); ++e)
        {
          patches.push_back(
            make_patch(*contact_pair.slave, contact_pair.slave_rows, e));
          patches.back().patch_index = patches.size() - 1;
        }
    return patches;
  }

  template std::vector<DataOutBase::Patch<1, 2>>
  contact_patches(const std::vector<PairProfile<2>> &pairs);
  template std::vector<DataOutBase::Patch<2, 3>>
  contact_patches(const std::vector<PairProfile<3>> &pairs);
} // namespace Contact
