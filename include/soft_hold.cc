/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "soft_hold.h"

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Contact
{
  SoftHold::SoftHold(const Discretization         &discretization,
                     const std::vector<CellTable> &cells)
    : discretization(discretization)
    , cells(cells)
  {
    for (const auto &[name, body] : discretization.mesh.bodies)
      areas[body] = volumes[body] = 0;
    for (const CellTable &cell : cells)
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          volumes[cell.body] += cell.JxW[q];
          areas[cell.body] +=
            cell.JxW[q] / discretization.circumference(cell.points[q]);
        }
    for (auto *sums : {&areas, &volumes})
      for (auto &[body, sum] : *sums)
        sum = Utilities::MPI::sum(sum, discretization.communicator);
  }



  void SoftHold::hold(const std::map<types::material_id, double> &stiffness,
                      const Vector<double>                       &rest)
  {
    Assert(rest.size() >= discretization.dof_handler.n_dofs(),
           ExcDimensionMismatch(rest.size(),
                                discretization.dof_handler.n_dofs()));
    std::map<types::material_id, double> positive;
    for (const auto &[body, k] : stiffness)
      {
        Assert(volumes.count(body) > 0, ExcMessage("no such body"));
        Assert(k >= 0, ExcMessage("a negative stiffness"));
        if (k > 0)
          positive[body] = k;
      }
    if (positive != this->stiffness)
      ++n_changes;
    this->stiffness = positive;
    this->rest      = rest;
  }



  void SoftHold::release()
  {
    if (!stiffness.empty())
      ++n_changes;
    stiffness.clear();
    rest.reinit(0);
  }



  double SoftHold::spring(const CellTable &cell) const
  {
    const auto held = stiffness.find(cell.body);
    if (held == stiffness.end())
      return 0;
    double volume = 0;
    for (const double JxW : cell.JxW)
      volume += JxW;
    return held->second * volume / volumes.at(cell.body) / cell.n_corners();
  }



  void SoftHold::add_springs(const CellTable      &cell,
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



  std::map<types::material_id, double>
  SoftHold::energy(const Vector<double> &u) const
  {
    std::map<types::material_id, double> energies;
    for (const auto &[body, k] : stiffness)
      energies[body] = 0;
    for (const CellTable &cell : cells)
      if (const double k = spring(cell); k > 0)
        for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
          energies[cell.body] +=
            0.5 * k * std::pow(u[cell.dofs[i]] - rest[cell.dofs[i]], 2);
    for (auto &[body, energy] : energies)
      energy = Utilities::MPI::sum(energy, discretization.communicator);
    return energies;
  }



  double SoftHold::mean_circumference(const types::material_id body) const
  {
    return volumes.at(body) / areas.at(body);
  }
} // namespace Contact
