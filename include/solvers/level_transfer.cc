/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/level_transfer.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The names of cells and of those that they are children of.
    template<int dim>
    std::set<CellId> with_parents(const SurfaceCells<dim> &cells)
    {
      std::set<CellId> ids;
      for (const auto &cell : cells.all())
        {
          ids.insert(cell.first);
          if (cell.first.get_child_indices().size() > 0)
            ids.insert(SurfaceCells<dim>::parent(cell.first));
        }
      return ids;
    }
  } // namespace



  // An unknown of a fine cell is that of the coarse cell if this is not
  // refined, or the interpolated one in the child.
  template<int dim>
  LevelTransfer<dim>::LevelTransfer(Level                   &coarse,
                                    Level                   &fine,
                                    const SurfaceCells<dim> &fine_cells)
    : coarse(coarse)
    , fine(fine)
    , cells(coarse.dof_handler,
            [ids = with_parents(fine_cells)](const auto &cell) {
              return ids.count(cell->id()) > 0;
            })
  {
    const FiniteElement<dim> &fe        = coarse.dof_handler.get_fe();
    const unsigned int        n         = fe.n_dofs_per_cell();
    const double              round_off = 1e-12;
    for (const auto &[id, of_fine] : fine_cells.all())
      if (const auto same = cells.all().find(id); same != cells.all().end())
        for (unsigned int i = 0; i < n; ++i)
          rows[of_fine[i]] = {{same->second[i], 1.}};
      else
        {
          const Dofs &of_coarse = cells.all().at(SurfaceCells<dim>::parent(id));
          const auto &matrix =
            fe.get_prolongation_matrix(SurfaceCells<dim>::last_child(id));
          for (unsigned int i = 0; i < n; ++i)
            {
              const auto [place, is_new] = rows.try_emplace(of_fine[i]);
              if (!is_new)
                continue;
              Row &row = place->second;
              for (unsigned int j = 0; j < n; ++j)
                if (std::abs(matrix(i, j) - 1) < round_off)
                  row.emplace_back(of_coarse[j], 1.);
                else if (std::abs(matrix(i, j)) > round_off)
                  row.emplace_back(of_coarse[j], matrix(i, j));
            }
        }
  }



  template<int dim>
  std::set<types::global_dof_index>
  LevelTransfer<dim>::at_same_nodes(const std::set<Dof> &fixed) const
  {
    std::set<Dof> result;
    for (const Dof dof : fixed)
      if (const Row &row = rows.at(dof); row.size() == 1)
        result.insert(row[0].first);
    return result;
  }



  // All ranks get the constraints at the surfaces: each knows those of its own
  // unknowns.
  template<int dim>
  void LevelTransfer<dim>::initialize()
  {
    transfer.reinit_geometric_transfer(fine.dof_handler,
                                       coarse.dof_handler,
                                       fine.supports(),
                                       coarse.supports());
    const IndexSet    &owned = coarse.dof_handler.locally_owned_dofs();
    std::map<Dof, Row> own;
    for (const auto &cell : cells.all())
      for (const Dof dof : cell.second)
        if (owned.is_element(dof) && coarse.supports().is_constrained(dof))
          {
            const auto &entries =
              *coarse.supports().get_constraint_entries(dof);
            own[dof].assign(entries.begin(), entries.end());
          }
    for (auto &of_rank :
         Utilities::MPI::all_gather(coarse.dof_handler.get_communicator(), own))
      constrained.merge(of_rank);
  }



  // By unknowns of the coarse level that are not constrained.
  template<int dim>
  void LevelTransfer<dim>::add_coarse(const Dof              fine_dof,
                                      const double           factor,
                                      std::map<Dof, double> &sum) const
  {
    for (const auto &[dof, weight] : rows.at(fine_dof))
      {
        const auto by = constrained.find(dof);
        if (by == constrained.end())
          sum[dof] += factor * weight;
        else
          for (const auto &[leader, share] : by->second)
            sum[leader] += factor * weight * share;
      }
  }



  // Where a node of the fine level is eliminated and none of the coarse ones
  // that it is interpolated from, the line is that of the fine node, solved for
  // the coarse one that it depends on most: two or three points that hold a
  // body may all be between coarse nodes.
  template<int dim>
  void LevelTransfer<dim>::add_line_between(const Dof dof, Lines &sums) const
  {
    std::map<Dof, double> place, sum;
    add_coarse(dof, 1, place);
    if (rows.at(dof).size() == 1 || place.empty() ||
        std::any_of(place.begin(), place.end(), [&](const auto &entry) {
          return sums.count(entry.first) > 0;
        }))
      return;
    const auto pivot =
      *std::max_element(place.begin(), place.end(), [](auto &a, auto &b) {
        return std::abs(a.second) < std::abs(b.second);
      });
    if (const auto *entries = fine.line_constraints.get_constraint_entries(dof))
      for (const auto &[other, factor] : *entries)
        add_coarse(other, factor / pivot.second, sum);
    for (const auto &[other, weight] : place)
      sum[other] -= weight / pivot.second;
    sum.erase(pivot.first);
    sums.emplace(pivot.first, std::move(sum));
  }



  // At the ends of surfaces a line may have unknowns that other lines
  // eliminate. One of these is left to the finer level where it has further
  // ones in turn, which might lead round in a circle.
  template<int dim>
  void LevelTransfer<dim>::hand_down() const
  {
    Lines sums;
    for (const Dof dof : fine.eliminated)
      {
        const Row &row = rows.at(dof);
        if (row.size() != 1 || constrained.count(row[0].first) > 0)
          continue;
        std::map<Dof, double> &sum = sums[row[0].first];
        if (const auto *entries =
              fine.line_constraints.get_constraint_entries(dof))
          for (const auto &[other, factor] : *entries)
            add_coarse(other, factor, sum);
        sum.erase(row[0].first);
      }

    for (const Dof dof : fine.eliminated)
      add_line_between(dof, sums);

    const auto has_any = [](const std::map<Dof, double> &sum,
                            const auto                  &those) {
      return std::any_of(sum.begin(), sum.end(), [&](const auto &entry) {
        return those.count(entry.first) > 0;
      });
    };
    std::set<Dof> by_lines;
    for (const auto &[dof, sum] : sums)
      if (has_any(sum, sums))
        by_lines.insert(dof);

    Dofs                      eliminated;
    AffineConstraints<double> lines;
    for (const auto &[dof, sum] : sums)
      if (by_lines.count(dof) == 0 || !has_any(sum, by_lines))
        {
          lines.add_line(dof);
          for (const auto &[other, factor] : sum)
            if (factor != 0)
              lines.add_entry(dof, other, factor);
          eliminated.push_back(dof);
        }
    lines.close();
    coarse.set_lines(eliminated, lines);
  }



  template<int dim>
  void LevelTransfer<dim>::restrict_residual() const
  {
    coarse.rhs = 0;
    transfer.restrict_and_add(coarse.rhs, fine.residual);
    coarse.contact_projection().project_transposed(coarse.rhs);
  }



  // What the coarse level does not know of the lines is repaired on the softer
  // side.
  template<int dim>
  void LevelTransfer<dim>::correct() const
  {
    transfer.prolongate_and_add(fine.solution, coarse.solution);
    fine.contact_projection().project(fine.solution);
  }

  template class LevelTransfer<2>;
  template class LevelTransfer<3>;
} // namespace Contact
