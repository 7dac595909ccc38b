/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/stabilization_springs.h"

#include <deal.II/base/mpi.h>

#include <cmath>

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



  void
  StabilizationSprings::hold(const std::map<unsigned int, double> &stiffness,
                             const Vector<double>                 &rest)
  {
    Assert(rest.size() >= discretization.dof_handler.n_dofs(),
           ExcDimensionMismatch(rest.size(),
                                discretization.dof_handler.n_dofs()));
    std::map<unsigned int, double> positive;
    for (const auto &[piece, k] : stiffness)
      {
        AssertIndexRange(piece, volumes.size());
        Assert(k >= 0, ExcMessage("a negative stiffness"));
        if (k > 0)
          positive[piece] = k;
      }
    if (positive != this->stiffness)
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



  double StabilizationSprings::spring(const CellTable &cell) const
  {
    const auto held = stiffness.find(cell.piece);
    if (held == stiffness.end())
      return 0;
    double volume = 0;
    for (const double JxW : cell.JxW)
      volume += JxW;
    return held->second * volume / volumes[cell.piece] / cell.n_corners();
  }



  void StabilizationSprings::add_springs(const CellTable      &cell,
                                         const Vector<double> &u,
                                         FullMatrix<double>   *tangent,
                                         Vector<double>       &forces) const
  {
    if (stiffness.empty())
      return;
    const double k = spring(cell);
    for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
      {
        forces[i] += k * (u[cell.dofs[i]] - rest[cell.dofs[i]]);
        if (tangent != nullptr)
          (*tangent)(i, i) += k;
      }
  }



  std::map<unsigned int, double>
  StabilizationSprings::energy(const Vector<double> &u) const
  {
    std::map<unsigned int, double> energies;
    for (const auto &[piece, k] : stiffness)
      energies[piece] = 0;
    for (const CellTable &cell : cells)
      if (const double k = spring(cell); k > 0)
        for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
          energies[cell.piece] +=
            0.5 * k * std::pow(u[cell.dofs[i]] - rest[cell.dofs[i]], 2);
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
