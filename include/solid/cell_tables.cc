/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/cell_tables.h"

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/dimension.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "solid/followers.h"

namespace Contact
{
  namespace
  {
    /// Make the mode m of all points orthonormal to those before (modified Gram
    /// and Schmidt), by the product of two modes.
    template<class Modes, class Product>
    void
    orthonormalize(const unsigned int m, const Product &product, Modes &modes)
    {
      for (unsigned int l = 0; l < m; ++l)
        {
          const double part = product(m, l);
          for (auto &mode : modes)
            mode[m] -= part * mode[l];
        }
      const double norm = std::sqrt(product(m, m));
      for (auto &mode : modes)
        mode[m] /= norm;
    }
  } // namespace



  // Of the polynomials 1, xi, eta, zeta.
  template<int dim>
  std::vector<std::array<double, dim + 1>>
  dilatation_modes(const FiniteElement<dim>  &fe,
                   const Quadrature<dim>     &quadrature,
                   const std::vector<double> &JxW)
  {
    const unsigned int n_modes = n_dilatation_modes(fe);
    if (n_modes >= quadrature.size())
      return {};

    // Modes that are left out stay zero.
    std::vector<std::array<double, dim + 1>> modes(quadrature.size());
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
        orthonormalize(m, product, modes);
      }
    return modes;
  }

  template std::vector<std::array<double, 3>>
  dilatation_modes(const FiniteElement<2> &,
                   const Quadrature<2> &,
                   const std::vector<double> &);
  template std::vector<std::array<double, 4>>
  dilatation_modes(const FiniteElement<3> &,
                   const Quadrature<3> &,
                   const std::vector<double> &);



  template<int dim>
  std::vector<std::array<SymmetricTensor<2, 3>, dim * dim>>
  stress_modes(const Quadrature<dim> &quadrature, const CellTable<dim> &cell)
  {
    const unsigned int n = quadrature.size();
    std::vector<std::array<SymmetricTensor<2, 3>, dim * dim>> modes(n);

    // Linear in each coordinate: the value in the centre is the mean.
    std::vector<Tensor<2, dim>> J;
    Tensor<2, dim>              J_0;
    for (const Tensor<2, dim> &map : cell.gradient_maps)
      {
        J.push_back(invert(transpose(map)));
        J_0 += J.back() / n;
      }
    const Tensor<2, dim> map_0 = invert(transpose(J_0));

    const auto product = [&](const unsigned int m, const unsigned int k) {
      double sum = 0;
      for (unsigned int q = 0; q < n; ++q)
        sum += cell.JxW[q] * (modes[q][m] * cell.material->stress(modes[q][k]));
      return sum;
    };
    unsigned int m = 0;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        for (const unsigned int k : std::set<unsigned int>{i, j})
          {
            SymmetricTensor<2, dim> unit;
            unit[i][j] = 1;
            const auto strain =
              symmetrize(map_0 * Tensor<2, dim>(unit) * transpose(map_0));
            SymmetricTensor<2, 3> mean;
            for (unsigned int q = 0; q < n; ++q)
              {
                for (unsigned int d = 0; d < dim; ++d)
                  for (unsigned int e = d; e < dim; ++e)
                    modes[q][m][d][e] = (quadrature.point(q)[k] - 0.5) /
                                        determinant(J[q]) * strain[d][e];
                mean += cell.JxW[q] * modes[q][m];
              }
            mean /= std::accumulate(cell.JxW.begin(), cell.JxW.end(), 0.);
            for (auto &mode : modes)
              mode[m] -= mean;
            orthonormalize(m, product, modes);
            ++m;
          }
    for (auto &mode : modes)
      for (auto &strain : mode)
        strain = cell.material->stress(strain);
    return modes;
  }

  template std::vector<std::array<SymmetricTensor<2, 3>, 4>>
  stress_modes(const Quadrature<2> &, const CellTable<2> &);
  template std::vector<std::array<SymmetricTensor<2, 3>, 9>>
  stress_modes(const Quadrature<3> &, const CellTable<3> &);



  namespace
  {


    /// The unknowns of the free nodes, and their shape functions. A bound node
    /// moves with others and hands its shape function on to them.
    template<int dim, typename Cell>
    void tabulate_nodes(const Cell                &dof_cell,
                        const FEValues<dim>       &fe_values,
                        const Discretization<dim> &discretization,
                        CellTables<dim>           &tables,
                        CellTable<dim>            &cell)
    {
      const auto                  &fe = fe_values.get_fe();
      const std::vector<BoundNode> bound =
        bound_nodes(discretization, dof_cell);
      std::vector<unsigned int> free(fe.base_element(0).n_dofs_per_cell());
      std::iota(free.begin(), free.end(), 0);

      // By node the bound ones that hand over to it, and the factors.
      std::vector<std::vector<std::pair<unsigned int, double>>> takes(
        free.size());
      for (const auto &[node, leaders] : bound)
        {
          free.erase(std::find(free.begin(), free.end(), node));
          for (const auto &[leader, factor] : leaders)
            takes[leader].emplace_back(node, factor);
        }

      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      dof_cell->get_dof_indices(dofs);
      cell.dofs.reserve(dim * free.size());
      for (const unsigned int a : free)
        for (unsigned int c = 0; c < dim; ++c)
          cell.dofs.push_back(dofs[fe.component_to_system_index(c, a)]);

      const auto handed_over = [&](const unsigned int a, const auto &of) {
        auto value = of(a);
        for (const auto &[node, factor] : takes[a])
          value += factor * of(node);
        return value;
      };
      auto &unit_gradients =
        tables.unit_gradients[{dof_cell->active_fe_index(), takes}];
      if (unit_gradients.empty())
        for (const Point<dim> &point : fe_values.get_quadrature().get_points())
          for (const unsigned int a : free)
            unit_gradients.push_back(
              handed_over(a, [&](const unsigned int node) {
                return fe.base_element(0).shape_grad(node, point);
              }));
      cell.unit_gradients = &unit_gradients;
      if (discretization.axisymmetric)
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (const unsigned int a : free)
            cell.hoop_gradients.push_back(
              handed_over(a,
                          [&](const unsigned int node) {
                            return fe_values.shape_value(
                              fe.component_to_system_index(0, node),
                              q);
                          }) /
              fe_values.quadrature_point(q)[0]);
    }
  } // namespace



  namespace
  {
    /// Triangles of degree 1, which lock as well, are a note, see
    /// Elasticity::locking(): a body may have few of them.
    void refuse_locking(const Discretization<2> &, const CellTable<2> &)
    {
    }

    void refuse_locking(const Discretization<3> &discretization,
                        const CellTable<3>      &cell)
    {
      if (cell.material->is_nearly_incompressible())
        throw InputError("the tetrahedra of degree 1 of '" +
                           discretization.mesh.body_name(cell.body) +
                           "', which hardly changes its volume, would lock",
                         "entry 'Element/Degree'",
                         "set 'Degree = 2', or mesh the body with hexahedra");
    }
  } // namespace



  template<int dim>
  CellTables<dim>
  tabulate_cells(const Discretization<dim>                    &discretization,
                 const std::map<types::material_id, Material> &materials,
                 const std::set<types::material_id>           &projected,
                 const std::set<types::material_id>           &enhanced)
  {
    hp::FEValues<dim> hp_fe_values(
      discretization.mapping,
      discretization.fe,
      discretization.quadrature,
      update_inverse_jacobians | update_JxW_values | update_quadrature_points |
        (discretization.axisymmetric ? update_values : update_default));

    CellTables<dim> tables;
    tables.own.reserve(discretization.mesh.triangulation.n_active_cells());
    for (const auto &dof_cell :
         discretization.dof_handler.active_cell_iterators())
      {
        if (dof_cell->is_artificial())
          continue;
        hp_fe_values.reinit(dof_cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();

        CellTable<dim> cell;
        cell.gradient_maps.reserve(fe_values.n_quadrature_points);
        cell.active_index = dof_cell->active_cell_index();
        cell.body         = dof_cell->material_id();
        cell.piece        = discretization.mesh.pieces.of_cell(dof_cell);
        cell.material     = &materials.at(cell.body);
        cell.centre       = dof_cell->center();
        cell.JxW          = fe_values.get_JxW_values();
        cell.area = std::accumulate(cell.JxW.begin(), cell.JxW.end(), 0.);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            cell.JxW[q] *=
              discretization.circumference(fe_values.quadrature_point(q));
            cell.gradient_maps.push_back(
              transpose(Tensor<2, dim>(fe_values.inverse_jacobian(q))));
          }
        if (projected.count(cell.body) > 0)
          cell.modes = dilatation_modes(dof_cell->get_fe(),
                                        fe_values.get_quadrature(),
                                        cell.JxW);

        if (discretization.degree == 1 &&
            !dof_cell->reference_cell().is_hyper_cube())
          refuse_locking(discretization, cell);

        if (enhanced.count(cell.body) > 0)
          {
            if (!dof_cell->reference_cell().is_hyper_cube())
              throw InputError(
                std::string("there are no incompatible modes of ") +
                  Dimension<dim>::simplices + ", one is at " +
                  brief(cell.centre),
                "Solids/Incompatible modes",
                "mesh '" + discretization.mesh.body_name(cell.body) +
                  "' with " + Dimension<dim>::hypercubes +
                  " alone, or set 'Degree = 2'");
            cell.stress_modes = stress_modes(fe_values.get_quadrature(), cell);
          }

        tabulate_nodes(dof_cell, fe_values, discretization, tables, cell);
        (dof_cell->is_locally_owned() ? tables.own : tables.neighbors)
          .push_back(std::move(cell));
      }
    return tables;
  }



  template CellTables<2>
  tabulate_cells(const Discretization<2> &,
                 const std::map<types::material_id, Material> &,
                 const std::set<types::material_id> &,
                 const std::set<types::material_id> &);
  template CellTables<3>
  tabulate_cells(const Discretization<3> &,
                 const std::map<types::material_id, Material> &,
                 const std::set<types::material_id> &,
                 const std::set<types::material_id> &);
} // namespace Contact
