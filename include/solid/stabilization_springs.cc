/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/stabilization_springs.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Contact
{
  template<int dim>
  StabilizationSprings<dim>::StabilizationSprings(
    const Discretization<dim>         &discretization,
    const std::vector<CellTable<dim>> &cells)
    : discretization(discretization)
    , cells(cells)
    , areas(discretization.mesh.pieces.size())
    , volumes(areas.size())
  {
    for (const CellTable<dim> &cell : cells)
      {
        volumes[cell.piece] +=
          std::accumulate(cell.JxW.begin(), cell.JxW.end(), 0.);
        areas[cell.piece] += cell.area;
      }
    for (auto *sums : {&areas, &volumes})
      Utilities::MPI::sum(*sums, discretization.communicator, *sums);
  }



  template<int dim>
  void StabilizationSprings<dim>::hold(
    const std::map<unsigned int, SpringStiffness> &stiffness,
    const GhostedVector                           &rest)
  {
    Assert(rest.size() >= discretization.dof_handler.n_dofs(),
           ExcDimensionMismatch(rest.size(),
                                discretization.dof_handler.n_dofs()));
    std::map<unsigned int, SpringStiffness> positive;
    for (const auto &[piece, k] : stiffness)
      {
        AssertIndexRange(piece, volumes.size());
        Assert(k.translation >= 0 && k.rotation >= 0,
               ExcMessage("a negative stiffness"));
        if (k.translation > 0 || k.rotation > 0)
          positive[piece] = k;
      }
    if (!(positive == this->stiffness))
      ++n_changes;
    this->stiffness = positive;
    this->rest      = rest;
  }



  template<int dim>
  void StabilizationSprings<dim>::release()
  {
    if (!stiffness.empty())
      ++n_changes;
    stiffness.clear();
    rest = GhostedVector();
  }



  template<int dim>
  typename StabilizationSprings<dim>::CellSprings
  StabilizationSprings<dim>::springs_of(const CellTable<dim> &cell) const
  {
    CellSprings springs;
    const auto  held = stiffness.find(cell.piece);
    if (held == stiffness.end())
      return springs;
    const double volume = std::accumulate(cell.JxW.begin(), cell.JxW.end(), 0.);
    const double share  = volume / volumes[cell.piece];
    springs.corner      = held->second.translation * share / cell.n_corners();
    springs.rotation    = held->second.rotation * share;
    if (springs.rotation == 0)
      return springs;

    for (unsigned int axis = 0; axis < n_axes; ++axis)
      springs.rows[axis] = rotation_row(cell, axis);
    return springs;
  }



  // From direction i to direction j.
  template<int dim>
  Vector<double>
  StabilizationSprings<dim>::rotation_row(const CellTable<dim> &cell,
                                          const unsigned int    axis) const
  {
    const unsigned int i = (Dimension<dim>::first_axis + axis + 1) % 3;
    const unsigned int j = (Dimension<dim>::first_axis + axis + 2) % 3;
    const double volume = std::accumulate(cell.JxW.begin(), cell.JxW.end(), 0.);
    Vector<double> row(cell.dofs.size());
    for (unsigned int q = 0; q < cell.JxW.size(); ++q)
      for (unsigned int a = 0; a < cell.n_nodes(); ++a)
        {
          const Tensor<1, dim> mean =
            cell.JxW[q] / (2 * volume) *
            (cell.gradient_maps[q] * cell.unit_gradients_at(q)[a]);
          row[dim * a + i] -= mean[j];
          row[dim * a + j] += mean[i];
        }
    return row;
  }



  template<int dim>
  double
  StabilizationSprings<dim>::largest_rotation(const GhostedVector &du) const
  {
    double largest = 0;
    for (const CellTable<dim> &cell : cells)
      if (stiffness.count(cell.piece) > 0)
        {
          double square = 0;
          for (unsigned int axis = 0; axis < n_axes; ++axis)
            {
              const Vector<double> row   = rotation_row(cell, axis);
              double               angle = 0;
              for (unsigned int i = 0; i < row.size(); ++i)
                angle += row[i] * du[cell.dofs[i]];
              square += angle * angle;
            }
          largest = std::max(largest, std::sqrt(square));
        }
    return Utilities::MPI::max(largest, discretization.communicator);
  }



  template<int dim>
  double StabilizationSprings<dim>::rotation(const CellTable<dim> &cell,
                                             const Vector<double> &row,
                                             const GhostedVector  &u) const
  {
    double angle = 0;
    for (unsigned int i = 0; i < row.size(); ++i)
      angle += row[i] * (u[cell.dofs[i]] - rest[cell.dofs[i]]);
    return angle;
  }



  template<int dim>
  void StabilizationSprings<dim>::add_springs(const CellTable<dim> &cell,
                                              const GhostedVector  &u,
                                              FullMatrix<double>   *tangent,
                                              Vector<double> &forces) const
  {
    if (stiffness.empty())
      return;
    const CellSprings springs = springs_of(cell);
    for (unsigned int i = 0; i < dim * cell.n_corners(); ++i)
      {
        forces[i] += springs.corner * (u[cell.dofs[i]] - rest[cell.dofs[i]]);
        if (tangent != nullptr)
          (*tangent)(i, i) += springs.corner;
      }
    if (springs.rotation == 0)
      return;
    for (const Vector<double> &row : springs.rows)
      {
        forces.add(springs.rotation * rotation(cell, row, u), row);
        if (tangent != nullptr)
          for (unsigned int i = 0; i < row.size(); ++i)
            for (unsigned int j = 0; j < row.size(); ++j)
              (*tangent)(i, j) += springs.rotation * row[i] * row[j];
      }
  }



  template<int dim>
  std::map<unsigned int, double>
  StabilizationSprings<dim>::energy(const GhostedVector &u) const
  {
    std::map<unsigned int, double> energies;
    for (const auto &of_piece : stiffness)
      energies[of_piece.first] = 0;
    for (const CellTable<dim> &cell : cells)
      if (stiffness.count(cell.piece) > 0)
        {
          const CellSprings springs = springs_of(cell);
          double           &energy  = energies[cell.piece];
          for (unsigned int i = 0; i < dim * cell.n_corners(); ++i)
            energy += 0.5 * springs.corner *
                      std::pow(u[cell.dofs[i]] - rest[cell.dofs[i]], 2);
          for (const Vector<double> &row : springs.rows)
            energy +=
              0.5 * springs.rotation * std::pow(rotation(cell, row, u), 2);
        }
    for (auto &[piece, energy] : energies)
      energy = Utilities::MPI::sum(energy, discretization.communicator);
    return energies;
  }



  template<int dim>
  double StabilizationSprings<dim>::mean_depth(const unsigned int piece) const
  {
    return dim == 2 ? volumes[piece] / areas[piece] : std::cbrt(volumes[piece]);
  }



  template class StabilizationSprings<2>;
  template class StabilizationSprings<3>;
} // namespace Contact
