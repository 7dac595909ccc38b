/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The history of the points of class Elasticity, its energies and the works of
// an increment, and bodies that are too stiff.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>

#include "base/dimension.h"
#include "solid/elasticity.h"

namespace Contact
{
  template<int dim>
  std::vector<std::vector<double>> Elasticity<dim>::plastic_strains() const
  {
    std::vector<std::vector<double>> strains(
      discretization.mesh.triangulation.n_active_cells());
    for (const auto *part : {&tables.own, &tables.neighbors})
      for (const CellTable<dim> &cell : *part)
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          strains[cell.active_index].push_back(cell.plastic_strain(q));
    return strains;
  }



  template<int dim>
  void Elasticity<dim>::accept(const GhostedVector &u)
  {
    end_first_step();
    for (auto *part : {&tables.own, &tables.neighbors})
      for (CellTable<dim> &cell : *part)
        if (!cell.history.empty())
          {
            discretization.counters.history_updates += cell.JxW.size();
            cell.history = cell.kernel->history_at(cell, u.extract(cell.dofs));
          }
  }



  template<int dim>
  bool Elasticity<dim>::changes_by_yielding() const
  {
    return has_history() &&
           std::all_of(laws.begin(), laws.end(), [&](const auto &law) {
             return kernels.at(law.first)->is_small_strain() &&
                    (law.second->is_linear() || law.second->n_history() > 0);
           });
  }



  template<int dim>
  std::vector<unsigned int>
  Elasticity<dim>::yielding(const std::vector<unsigned int> &chosen,
                            const GhostedVector             &u) const
  {
    std::vector<unsigned int> yielding;
    Vector<double>            of_cell;
    for (const unsigned int number : chosen)
      {
        const CellTable<dim> &cell = tables.own[number];
        if (cell.history.empty())
          continue;
        u.extract(cell.dofs, of_cell);
        if (cell.kernel->yields(cell, of_cell))
          yielding.push_back(number);
      }
    return yielding;
  }



  // By cell how many numbers follow, and these.
  template<int dim>
  CellValues Elasticity<dim>::history(const bool of_yielded_alone) const
  {
    const auto ids = cell_ids();
    CellValues values;
    for (const CellTable<dim> &cell : tables.own)
      {
        if (cell.history.empty() ||
            (of_yielded_alone &&
             std::all_of(cell.history.begin(),
                         cell.history.end(),
                         [](const double number) { return number == 0; })))
          continue;
        values.cells.push_back(ids[cell.active_index]);
        values.numbers.push_back(cell.history.size());
        values.numbers.insert(values.numbers.end(),
                              cell.history.begin(),
                              cell.history.end());
      }
    return values;
  }



  template<int dim>
  void Elasticity<dim>::restore(const CellValues &history)
  {
    std::map<CellId, const double *> of_cell;
    const double                    *here = history.numbers.data();
    for (const CellId &cell : history.cells)
      {
        of_cell[cell] = here + 1;
        here += 1 + static_cast<std::size_t>(*here);
      }
    const auto ids = cell_ids();
    for (auto *part : {&tables.own, &tables.neighbors})
      for (CellTable<dim> &cell : *part)
        if (const auto found = of_cell.find(ids[cell.active_index]);
            found != of_cell.end())
          std::copy_n(found->second, cell.history.size(), cell.history.begin());
  }



  template<int dim>
  std::vector<CellId> Elasticity<dim>::cell_ids() const
  {
    std::vector<CellId> ids;
    for (const auto &cell :
         discretization.mesh.triangulation.active_cell_iterators())
      ids.push_back(cell->id());
    return ids;
  }



  template<int dim>
  double Elasticity<dim>::strain_energy(
    const GhostedVector                    &u,
    const std::optional<types::material_id> body) const
  {
    double energy = 0;
    for (const CellTable<dim> &cell : tables.own)
      if (!body || cell.body == *body)
        energy += cell.kernel->energy(cell, u.extract(cell.dofs));
    return Utilities::MPI::sum(energy, discretization.communicator);
  }



  template<int dim>
  std::string Elasticity<dim>::locking() const
  {
    unsigned int number = 0; // of the body, from one on
    for (const CellTable<dim> &cell : tables.own)
      if (!is_plane_stress && cell.dofs.size() == dim * (dim + 1) &&
          cell.material->is_nearly_incompressible())
        number = cell.body + 1;
    number = Utilities::MPI::max(number, discretization.communicator);
    return number == 0 ? ""
                       : std::string("the ") + Dimension<dim>::simplices +
                           " of degree 1 of '" +
                           discretization.mesh.body_name(number - 1) +
                           "', which hardly changes its volume, lock";
  }



  // Of the modes, orthonormal in the energy, a cell would take alpha.
  template<int dim>
  typename Elasticity<dim>::BendingEnergy
  Elasticity<dim>::bending_energy(const GhostedVector     &u,
                                  const types::material_id body) const
  {
    BendingEnergy energy;
    const auto   &law = *laws.at(body);
    if (discretization.degree == 1 && enhanced.count(body) == 0 &&
        (law.is_linear() || law.n_history() > 0))
      for (const CellTable<dim> &cell : tables.own)
        if (cell.body == body && !cell.material->is_nearly_incompressible() &&
            cell.JxW.size() == GeometryInfo<dim>::vertices_per_cell)
          {
            const auto modes = stress_modes<dim>(QGauss<dim>(2), cell);
            const auto strains =
              cell.kernel->strains(cell, u.extract(cell.dofs));
            std::array<double, dim * dim> alpha{};
            for (unsigned int q = 0; q < strains.size(); ++q)
              {
                for (unsigned int m = 0; m < alpha.size(); ++m)
                  alpha[m] += cell.JxW[q] * (modes[q][m] * strains[q]);
                energy.whole +=
                  0.5 * cell.JxW[q] *
                  (cell.material->template stress<3>(strains[q]) * strains[q]);
              }
            for (const double of_mode : alpha)
              energy.missing += 0.5 * of_mode * of_mode;
          }
    energy.missing =
      Utilities::MPI::sum(energy.missing, discretization.communicator);
    energy.whole =
      Utilities::MPI::sum(energy.whole, discretization.communicator);
    return energy;
  }



  template<int dim>
  typename Elasticity<dim>::Works
  Elasticity<dim>::works(const GhostedVector &u_0,
                         const GhostedVector &u_1) const
  {
    Works sum;
    for (const CellTable<dim> &cell : tables.own)
      {
        const Works of_cell = cell.kernel->works(cell,
                                                 u_0.extract(cell.dofs),
                                                 u_1.extract(cell.dofs));
        sum.dissipation += of_cell.dissipation;
        sum.path += of_cell.path;
        sum.error += of_cell.error;
        sum.thermal += of_cell.thermal;
      }
    for (double *work : {&sum.dissipation, &sum.path, &sum.error, &sum.thermal})
      *work = Utilities::MPI::sum(*work, discretization.communicator);
    return sum;
  }

  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Contact
