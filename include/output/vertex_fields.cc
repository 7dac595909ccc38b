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
    , fe_of_nodes(FE_Q<dim>(discretization.degree),
                  FE_SimplexP<dim>(discretization.degree))
    , nodes(discretization.mesh.triangulation)
  {
    distribute_dofs(discretization.mesh, fe, dof_handler);
    distribute_dofs(discretization.mesh, fe_of_nodes, nodes);
    const auto              components = stress_fields<dim>();
    const DistributedVector zero(dof_handler.locally_owned_dofs(),
                                 DoFTools::extract_locally_relevant_dofs(
                                   dof_handler),
                                 discretization.communicator);
    for (const auto &component : components)
      fields.emplace_back(component.name, zero);
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
            if (!plastic_strains.empty())
              fields.back().second[dof] =
                plastic_strains[cell->vertex_index(v)];
          }
    for (auto &field : fields)
      field.second.update_ghost_values();
    find_von_mises(discretization.communicator);
  }



  template<int dim>
  void VertexFields<dim>::find_von_mises(const MPI_Comm communicator)
  {
    const IndexSet &owned = nodes.locally_owned_dofs();
    von_mises_at_nodes.reinit(owned,
                              DoFTools::extract_locally_relevant_dofs(nodes),
                              communicator);
    const auto                           components = stress_fields<dim>();
    std::vector<types::global_dof_index> of_cell, of_vertices;
    for (const auto &cell : nodes.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const typename DoFHandler<dim>::active_cell_iterator linear(
            &cell->get_triangulation(),
            cell->level(),
            cell->index(),
            &dof_handler);
          const auto &shapes = linear->get_fe();
          of_vertices.resize(shapes.n_dofs_per_cell());
          linear->get_dof_indices(of_vertices);
          of_cell.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(of_cell);
          for (unsigned int i = 0; i < of_cell.size(); ++i)
            {
              if (!owned.is_element(of_cell[i]))
                continue;
              SymmetricTensor<2, 3> stress;
              for (unsigned int v = 0; v < of_vertices.size(); ++v)
                {
                  const double shape =
                    shapes.shape_value(v, cell->get_fe().unit_support_point(i));
                  for (unsigned int c = 0; c < components.size(); ++c)
                    stress[components[c].i][components[c].j] +=
                      shape * fields[c].second[of_vertices[v]];
                }
              von_mises_at_nodes[of_cell[i]] = von_mises(stress);
            }
        }
    von_mises_at_nodes.update_ghost_values();
  }



  template<int dim>
  void VertexFields<dim>::attach(DataOut<dim> &data_out) const
  {
    for (const auto &[name, values] : fields)
      data_out.add_data_vector(dof_handler, values, name);
    data_out.add_data_vector(nodes, von_mises_at_nodes, "von_mises");
  }

  template class VertexFields<2>;
  template class VertexFields<3>;
} // namespace Contact
