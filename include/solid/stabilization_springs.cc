/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/stabilization_springs.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <numeric>

namespace Contact
{
  StabilizationSprings::StabilizationSprings(
    const Discretization         &discretization,
    const std::vector<CellTable> &cells)
    : discretization(discretization)
    , cells(cells)
    , areas(discretization.mesh.pieces.size())
    , volumes(areas.size())
  {
    for (const CellTable &cell : cells)
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          volumes[cell.piece] += cell.JxW[q];
          areas[cell.piece] +=
            cell.JxW[q] / discretization.circumference(cell.points[q]);
        }
    for (auto *sums : {&areas, &volumes})
      Utilities::MPI::sum(*sums, discretization.communicator, *sums);
  }



  void StabilizationSprings::hold(
    const std::map<unsigned int, SpringStiffness> &stiffness,
    const Vector<double>                          &rest)
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



  void StabilizationSprings::release()
  {
    if (!stiffness.empty())
      ++n_changes;
    stiffness.clear();
    rest.reinit(0);
  }



  StabilizationSprings::CellSprings
  StabilizationSprings::springs_of(const CellTable &cell) const
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

    springs.row.reinit(cell.dofs.size());
    for (unsigned int q = 0; q < cell.JxW.size(); ++q)
      for (unsigned int a = 0; a < cell.n_nodes(); ++a)
        {
          const Tensor<1, 2> mean =
            cell.JxW[q] / (2 * volume) * cell.gradients[q * cell.n_nodes() + a];
          springs.row[2 * a] -= mean[1];
          springs.row[2 * a + 1] += mean[0];
        }
    return springs;
  }



  double StabilizationSprings::rotation(const CellTable      &cell,
                                        const CellSprings    &springs,
                                        const Vector<double> &u) const
  {
    double angle = 0;
    for (unsigned int i = 0; i < springs.row.size(); ++i)
      angle += springs.row[i] * (u[cell.dofs[i]] - rest[cell.dofs[i]]);
    return angle;
  }



  void StabilizationSprings::add_springs(const CellTable      &cell,
                                         const Vector<double> &u,
                                         FullMatrix<double>   *tangent,
                                         Vector<double>       &forces) const
  {
    if (stiffness.empty())
      return;
    const CellSprings springs = springs_of(cell);
    for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
      {
        forces[i] += springs.corner * (u[cell.dofs[i]] - rest[cell.dofs[i]]);
        if (tangent != nullptr)
          (*tangent)(i, i) += springs.corner;
      }
    if (springs.rotation == 0)
      return;
    forces.add(springs.rotation * rotation(cell, springs, u), springs.row);
    if (tangent != nullptr)
      for (unsigned int i = 0; i < springs.row.size(); ++i)
        for (unsigned int j = 0; j < springs.row.size(); ++j)
          (*tangent)(i, j) +=
            springs.rotation * springs.row[i] * springs.row[j];
  }



  std::map<unsigned int, double>
  StabilizationSprings::energy(const Vector<double> &u) const
  {
    std::map<unsigned int, double> energies;
    for (const auto &of_piece : stiffness)
      energies[of_piece.first] = 0;
    for (const CellTable &cell : cells)
      if (stiffness.count(cell.piece) > 0)
        {
          const CellSprings springs = springs_of(cell);
          double           &energy  = energies[cell.piece];
          for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
            energy += 0.5 * springs.corner *
                      std::pow(u[cell.dofs[i]] - rest[cell.dofs[i]], 2);
          energy +=
            0.5 * springs.rotation * std::pow(rotation(cell, springs, u), 2);
        }
    for (auto &[piece, energy] : energies)
      energy = Utilities::MPI::sum(energy, discretization.communicator);
    return energies;
  }



  double
  StabilizationSprings::mean_circumference(const unsigned int piece) const
  {
    return volumes[piece] / areas[piece];
  }
} // namespace Contact
