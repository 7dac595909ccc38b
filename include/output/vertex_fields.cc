/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/vertex_fields.h"

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include "solid/stress_recovery.h"

namespace Contact
{
  namespace
  {
    struct StressField
    {
      std::string  name;
      unsigned int i, j;
    };

    /// The components that are not zero for sure.
    template<int dim>
    std::vector<StressField> stress_fields()
    {
      std::vector<StressField> fields{{"stress_xx", 0, 0},
                                      {"stress_yy", 1, 1},
                                      {"stress_zz", 2, 2},
                                      {"stress_xy", 0, 1}};
      if (dim == 3)
        {
          fields.push_back({"stress_xz", 0, 2});
          fields.push_back({"stress_yz", 1, 2});
        }
      return fields;
    }
  } // namespace



  template<int dim>
  VertexFields<dim>::VertexFields(
    const Discretization<dim>                &discretization,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const std::vector<double>                &plastic_strains)
    : fe(FE_Q<dim>(1), FE_SimplexP<dim>(1))
    , dof_handler(discretization.mesh.triangulation)
  {
    distribute_dofs(discretization.mesh, fe, dof_handler);
    const auto              components = stress_fields<dim>();
    const DistributedVector zero(dof_handler.locally_owned_dofs(),
                                 DoFTools::extract_locally_relevant_dofs(
                                   dof_handler),
                                 discretization.communicator);
    for (const auto &component : components)
      fields.emplace_back(component.name, zero);
    fields.emplace_back("von_mises", zero);
    if (!plastic_strains.empty())
      fields.emplace_back("plastic_strain", zero);

    // A vertex of another rank may have cells that this one does not know.
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof =
              cell->vertex_dof_index(v, 0, cell->active_fe_index());
            if (!owned.is_element(dof))
              continue;
            const auto &stress = vertex_stresses[cell->vertex_index(v)];
            for (unsigned int c = 0; c < components.size(); ++c)
              fields[c].second[dof] = stress[components[c].i][components[c].j];
            fields[components.size()].second[dof] = von_mises(stress);
            if (!plastic_strains.empty())
              fields.back().second[dof] =
                plastic_strains[cell->vertex_index(v)];
          }
    for (auto &field : fields)
      field.second.update_ghost_values();
  }



  template<int dim>
  void VertexFields<dim>::attach(DataOut<dim> &data_out) const
  {
    for (const auto &[name, values] : fields)
      data_out.add_data_vector(dof_handler, values, name);
  }

  template class VertexFields<2>;
  template class VertexFields<3>;
} // namespace Contact
