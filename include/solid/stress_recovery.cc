/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/stress_recovery.h"

#include <deal.II/grid/reference_cell.h>

#include <algorithm>

namespace Contact
{
  template<int dim>
  StressRecovery<dim>::StressRecovery(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (unsigned int e = 0; e < discretization.fe.size(); ++e)
      {
        const auto             cell = discretization.fe[e].reference_cell();
        const Quadrature<dim> &quadrature = discretization.quadrature[e];
        FullMatrix<double>     values(quadrature.size(), cell.n_vertices());
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          for (unsigned int v = 0; v < cell.n_vertices(); ++v)
            values(q, v) = cell.d_linear_shape_function(quadrature.point(q), v);

        fits.emplace_back(cell.n_vertices(), quadrature.size());
        if (quadrature.size() >= cell.n_vertices())
          fits.back().left_invert(values);
        else
          fits.back().right_invert(values);
      }
  }



  template<int dim>
  std::vector<SymmetricTensor<2, 3>>
  StressRecovery<dim>::vertex_stresses(const Elasticity<dim> &elasticity,
                                       const GhostedVector   &u) const
  {
    return vertex_values<SymmetricTensor<2, 3>>(
      [&](const unsigned int cell) { return elasticity.stresses(cell, u); });
  }



  // Fits oscillate beside the end of the plastic zone.
  template<int dim>
  std::vector<double>
  StressRecovery<dim>::vertex_strains(const Elasticity<dim> &elasticity) const
  {
    const auto of_cells = elasticity.plastic_strains();
    auto       strains  = vertex_values<double>(
      [&](const unsigned int cell) { return of_cells[cell]; });
    for (double &strain : strains)
      strain = std::max(0., strain);
    return strains;
  }



  template<int dim>
  template<typename Value>
  std::vector<Value> StressRecovery<dim>::vertex_values(
    const std::function<std::vector<Value>(unsigned int)> &values_of_cell) const
  {
    const unsigned int n_vertices =
      discretization.mesh.triangulation.n_vertices();
    std::vector<Value>        at_vertices(n_vertices);
    std::vector<unsigned int> n_cells(n_vertices, 0);

    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        const auto at_points = values_of_cell(cell->active_cell_index());
        for (const unsigned int v : cell->vertex_indices())
          {
            at_vertices[cell->vertex_index(v)] += at_vertex(cell, v, at_points);
            ++n_cells[cell->vertex_index(v)];
          }
      }
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (n_cells[v] > 0)
        at_vertices[v] /= n_cells[v];
    return at_vertices;
  }



  template<int dim>
  template<typename Value>
  Value StressRecovery<dim>::at_vertex(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const unsigned int                                    v,
    const std::vector<Value>                             &at_points) const
  {
    const auto &fit   = fits[cell->active_fe_index()];
    Value       value = Value();
    for (unsigned int q = 0; q < at_points.size(); ++q)
      value += fit(v, q) * at_points[q];
    return value;
  }



  template<int dim>
  typename StressRecovery<dim>::CellsOfVertices
  StressRecovery<dim>::cells_at(const Place<dim> &place) const
  {
    CellsOfVertices cells;
    for (const auto &[vertex, weight] : place.vertices)
      cells[vertex];
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (const auto at = cells.find(cell->vertex_index(v));
            at != cells.end())
          at->second.push_back(cell);
    return cells;
  }



  template<int dim>
  SymmetricTensor<2, 3>
  StressRecovery<dim>::stress_at(const Place<dim>      &place,
                                 const CellsOfVertices &cells,
                                 const Elasticity<dim> &elasticity,
                                 const GhostedVector   &u) const
  {
    SymmetricTensor<2, 3> stress;
    for (const auto &[vertex, weight] : place.vertices)
      {
        SymmetricTensor<2, 3> sum;
        for (const auto &cell : cells.at(vertex))
          for (const unsigned int v : cell->vertex_indices())
            if (cell->vertex_index(v) == vertex)
              sum +=
                at_vertex(cell,
                          v,
                          elasticity.stresses(cell->active_cell_index(), u));
        stress += weight * (sum / cells.at(vertex).size());
      }
    return stress;
  }



  double von_mises(const SymmetricTensor<2, 3> &stress)
  {
    return std::sqrt(1.5) * deviator(stress).norm();
  }



  template class StressRecovery<2>;
  template class StressRecovery<3>;
} // namespace Contact
