/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/vtu/body_grids.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include "solid/stress_recovery.h"

namespace Contact
{
  namespace
  {
    /// Values by vertex as the owners of the vertices have them: a vertex of
    /// another process may have cells that this one does not know.
    template<int dim>
    void take_from_owners(const Discretization<dim> &discretization,
                          std::vector<double>       &values)
    {
      const auto       &dof_handler = discretization.dof_handler;
      DistributedVector at_vertices(dof_handler.locally_owned_dofs(),
                                    DoFTools::extract_locally_relevant_dofs(
                                      dof_handler),
                                    discretization.communicator);
      const auto        for_vertices = [&](const auto &visit) {
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (!cell->is_artificial())
            for (const unsigned int v : cell->vertex_indices())
              {
                const unsigned int vertex = cell->vertex_index(v);
                visit(discretization.vertex_dofs[vertex][0], values[vertex]);
              }
      };
      for_vertices([&](const types::global_dof_index dof, const double value) {
        if (at_vertices.locally_owned_elements().is_element(dof))
          at_vertices[dof] = value;
      });
      at_vertices.update_ghost_values();
      for_vertices([&](const types::global_dof_index dof, double &value) {
        value = at_vertices[dof];
      });
    }



    template<int dim>
    std::vector<double> of_owners(const Discretization<dim> &discretization,
                                  std::vector<double>        values)
    {
      if (!values.empty())
        take_from_owners(discretization, values);
      return values;
    }



    template<int dim>
    std::vector<SymmetricTensor<2, 3>>
    of_owners(const Discretization<dim>         &discretization,
              std::vector<SymmetricTensor<2, 3>> tensors)
    {
      std::vector<double> values(tensors.size());
      for (unsigned int c = 0;
           c < SymmetricTensor<2, 3>::n_independent_components;
           ++c)
        {
          for (unsigned int v = 0; v < values.size(); ++v)
            values[v] = tensors[v].access_raw_entry(c);
          take_from_owners(discretization, values);
          for (unsigned int v = 0; v < values.size(); ++v)
            tensors[v].access_raw_entry(c) = values[v];
        }
      return tensors;
    }
  } // namespace



  template<int dim>
  BodyGrids<dim>::BodyGrids(
    const Discretization<dim>                &discretization,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const std::vector<double>                &plastic_strains,
    const GhostedVector                      &solution,
    const GhostedVector                      &contact_forces)
    : discretization(discretization)
    , stresses(of_owners(discretization, vertex_stresses))
    , plastic_strains(of_owners(discretization, plastic_strains))
    , displacement(discretization.distributed(solution))
    , forces(contact_forces.size() > 0
               ? discretization.distributed(contact_forces)
               : DistributedVector())
  {
  }



  template<int dim>
  VtuGrid BodyGrids<dim>::empty_grid() const
  {
    VtuGrid grid;
    grid.at_points = {{"displacement", "mm", 3, {}},
                      {"stress", "MPa", 9, {}},
                      {"von_mises", "MPa", 1, {}}};
    if (forces.size() > 0)
      grid.at_points.push_back(
        {"contact_force", "N" + discretization.per_thickness(), 3, {}});
    if (!plastic_strains.empty())
      grid.at_points.push_back({"plastic_strain", "", 1, {}});
    grid.of_cells = {{"body", "", 1, {}},
                     {"level", "", 1, {}},
                     {"process", "", 1, {}}};
    return grid;
  }



  template<int dim>
  VtuGrid BodyGrids<dim>::grid(const types::material_id body) const
  {
    VtuGrid     grid = empty_grid();
    Points      points;
    const float process =
      Utilities::MPI::this_mpi_process(discretization.communicator);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == body)
        {
          add_cell(cell, points, grid);
          grid.of_cells[0].values.push_back(body);
          grid.of_cells[1].values.push_back(cell->level());
          grid.of_cells[2].values.push_back(process);
        }
    return grid;
  }



  template<int dim>
  void BodyGrids<dim>::add_cell(const Cell &cell,
                                Points     &points,
                                VtuGrid    &grid) const
  {
    const auto &fe      = cell->get_fe();
    const auto &mapping = discretization.mapping[cell->active_fe_index()];
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    std::vector<std::int32_t> numbers;
    const auto &units = fe.base_element(0).get_unit_support_points();
    for (unsigned int node = 0; node < units.size(); ++node)
      {
        const auto dof = dofs[fe.component_to_system_index(0, node)];
        const auto [point, is_new] = points.emplace(dof, grid.n_points());
        if (is_new)
          {
            grid.add_point(
              mapping.transform_unit_to_real_cell(cell, units[node]));
            add_values(cell, node, units[node], grid);
          }
        numbers.push_back(point->second);
      }
    grid.add_cell(numbers, units);
  }



  // In the order of empty_grid().
  template<int dim>
  void BodyGrids<dim>::add_values(const Cell        &cell,
                                  const unsigned int node,
                                  const Point<dim>  &unit,
                                  VtuGrid           &grid) const
  {
    const auto                          &fe = cell->get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    SymmetricTensor<2, 3> stress;
    double                strain = 0;
    for (const unsigned int v : cell->vertex_indices())
      {
        const double shape =
          cell->reference_cell().d_linear_shape_function(unit, v);
        stress += shape * stresses[cell->vertex_index(v)];
        if (!plastic_strains.empty())
          strain += shape * plastic_strains[cell->vertex_index(v)];
      }
    auto       field      = grid.at_points.begin();
    const auto add_vector = [&](const DistributedVector &vector) {
      for (unsigned int c = 0; c < 3; ++c)
        field->values.push_back(
          c < dim ? vector[dofs[fe.component_to_system_index(c, node)]] : 0.);
      ++field;
    };
    add_vector(displacement);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        field->values.push_back(stress[i][j]);
    (++field)->values.push_back(von_mises(stress));
    ++field;
    if (forces.size() > 0)
      add_vector(forces);
    if (!plastic_strains.empty())
      field->values.push_back(strain);
  }

  template class BodyGrids<2>;
  template class BodyGrids<3>;
} // namespace Contact
