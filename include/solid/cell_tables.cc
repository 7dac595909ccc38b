/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/cell_tables.h"

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>

namespace Contact
{
  namespace
  {
    /**
     * The first @p n_modes of the polynomials 1, xi, eta, made orthonormal with
     * respect to the weights @p JxW of the points of a cell (modified Gram and
     * Schmidt); none if there are as many as points, where projecting changes
     * nothing.
     */
    std::vector<std::array<double, 3>>
    orthonormal_modes(const Quadrature<2>       &quadrature,
                      const std::vector<double> &JxW,
                      const unsigned int         n_modes)
    {
      if (n_modes >= quadrature.size())
        return {};

      // Modes that are left out stay zero.
      std::vector<std::array<double, 3>> modes(quadrature.size(), {{0, 0, 0}});
      const auto product = [&](const unsigned int m, const unsigned int n) {
        double sum = 0;
        for (unsigned int q = 0; q < JxW.size(); ++q)
          sum += JxW[q] * modes[q][m] * modes[q][n];
        return sum;
      };
      for (unsigned int m = 0; m < n_modes; ++m)
        {
          for (unsigned int q = 0; q < JxW.size(); ++q)
            modes[q][m] = m == 0 ? 1 : quadrature.point(q)[m - 1] - 0.5;
          for (unsigned int n = 0; n < m; ++n)
            {
              const double part = product(m, n);
              for (auto &mode : modes)
                mode[m] -= part * mode[n];
            }
          const double norm = std::sqrt(product(m, m));
          for (auto &mode : modes)
            mode[m] /= norm;
        }
      return modes;
    }



    /// The unknowns of the free nodes and the gradients of their shape
    /// functions. Bound, the centre moves with the corners (-1/4) and the
    /// mid-sides (1/2) and hands its shape function on to them.
    void tabulate_nodes(const DoFHandler<2>::active_cell_iterator &dof_cell,
                        const FEValues<2>                         &fe_values,
                        const Discretization &discretization,
                        CellTable            &cell)
    {
      const auto &fe    = fe_values.get_fe();
      const bool  bound = discretization.serendipity &&
                         dof_cell->reference_cell().is_hyper_cube();
      const unsigned int n_nodes = fe.base_element(0).n_dofs_per_cell();
      const unsigned int n_free  = bound ? n_nodes - 1 : n_nodes;

      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      dof_cell->get_dof_indices(dofs);
      for (unsigned int a = 0; a < n_free; ++a)
        for (unsigned int c = 0; c < 2; ++c)
          cell.dofs.push_back(dofs[fe.component_to_system_index(c, a)]);

      const auto handed_over = [&](const unsigned int a, const auto &of) {
        return bound ? of(a) + (a < 4 ? -0.25 : 0.5) * of(8) : of(a);
      };
      for (const unsigned int q : fe_values.quadrature_point_indices())
        for (unsigned int a = 0; a < n_free; ++a)
          {
            cell.gradients.push_back(
              handed_over(a, [&](const unsigned int node) {
                return fe_values.shape_grad(fe.component_to_system_index(0,
                                                                         node),
                                            q);
              }));
            if (discretization.axisymmetric)
              cell.hoop_gradients.push_back(
                handed_over(a,
                            [&](const unsigned int node) {
                              return fe_values.shape_value(
                                fe.component_to_system_index(0, node),
                                q);
                            }) /
                cell.points[q][0]);
          }
    }
  } // namespace



  CellTables
  tabulate_cells(const Discretization                         &discretization,
                 const std::map<types::material_id, Material> &materials,
                 const std::set<types::material_id>           &projected)
  {
    hp::FEValues<2> hp_fe_values(
      discretization.mapping,
      discretization.fe,
      discretization.quadrature,
      update_gradients | update_JxW_values | update_quadrature_points |
        (discretization.axisymmetric ? update_values : update_default));

    CellTables tables;
    tables.own.reserve(discretization.mesh.triangulation.n_active_cells());
    for (const auto &dof_cell :
         discretization.dof_handler.active_cell_iterators())
      {
        if (dof_cell->is_artificial())
          continue;
        hp_fe_values.reinit(dof_cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();

        CellTable cell;
        cell.active_index = dof_cell->active_cell_index();
        cell.body         = dof_cell->material_id();
        cell.piece        = discretization.mesh.pieces.of_cell(dof_cell);
        cell.material     = &materials.at(cell.body);
        cell.JxW          = fe_values.get_JxW_values();
        cell.points       = fe_values.get_quadrature_points();
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          cell.JxW[q] *= discretization.circumference(cell.points[q]);
        if (projected.count(cell.body) > 0)
          cell.modes =
            orthonormal_modes(fe_values.get_quadrature(),
                              cell.JxW,
                              discretization.degree == 2 &&
                                  dof_cell->reference_cell().is_hyper_cube()
                                ? 3
                                : 1);

        tabulate_nodes(dof_cell, fe_values, discretization, cell);
        (dof_cell->is_locally_owned() ? tables.own : tables.neighbors)
          .push_back(std::move(cell));
      }
    return tables;
  }
} // namespace Contact
