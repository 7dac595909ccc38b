/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/level_transfer.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace Contact
{
  template<int dim>
  LevelTransfer<dim>::LevelTransfer(Level                   &coarse,
                                    Level                   &fine,
                                    const SurfaceCells<dim> &fine_cells)
    : coarse(coarse)
    , fine(fine)
    , communicator(coarse.dof_handler.get_communicator())
    , fine_owners(fine.dof_handler.locally_owned_dofs(), communicator)
    , coarse_owners(coarse.dof_handler.locally_owned_dofs(), communicator)
  {
    std::vector<typename SurfaceCells<dim>::Coarse> of_cells;
    cells = fine_cells.coarser(coarse.dof_handler, of_cells);
    make_rows(fine_cells, of_cells);
  }



  // An unknown of a fine cell is that of the coarse cell if this is not
  // refined, or the interpolated one in the child. Some are in cells of other
  // ranks alone.
  template<int dim>
  void LevelTransfer<dim>::make_rows(
    const SurfaceCells<dim>                               &of_fine,
    const std::vector<typename SurfaceCells<dim>::Coarse> &of_coarse)
  {
    struct Source
    {
      Dof          dof;
      bool         is_refined;
      unsigned int cell, number;

      bool operator<(const Source &other) const
      {
        return std::tie(dof, is_refined, cell, number) <
               std::tie(other.dof, other.is_refined, other.cell, other.number);
      }
    };
    const FiniteElement<dim> &fe = coarse.dof_handler.get_fe();
    const unsigned int        n  = fe.n_dofs_per_cell();
    std::vector<Source>       sources;
    for (unsigned int c = 0; c < of_coarse.size(); ++c)
      for (unsigned int i = 0; i < n; ++i)
        sources.push_back({of_fine.dofs[c][i], of_coarse[c].is_refined, c, i});
    std::sort(sources.begin(), sources.end());

    const double                        round_off = 1e-12;
    Dof                                 last      = numbers::invalid_dof_index;
    std::map<unsigned int, SurfaceRows> by_owner;
    for (const auto &[dof, is_refined, c, i] : sources)
      {
        if (dof == last)
          continue;
        last                  = dof;
        SurfaceRows &of_owner = by_owner[fine_owners.owner(dof)];
        const Dofs  &dofs     = of_coarse[c].dofs;
        if (!is_refined)
          of_owner.add_entry(dofs[i], 1);
        else
          {
            const auto &matrix = fe.get_prolongation_matrix(
              SurfaceCells<dim>::last_child(of_fine.names[c]));
            for (unsigned int j = 0; j < n; ++j)
              if (std::abs(matrix(i, j) - 1) < round_off)
                of_owner.add_entry(dofs[j], 1);
              else if (std::abs(matrix(i, j)) > round_off)
                of_owner.add_entry(dofs[j], matrix(i, j));
          }
        of_owner.end_row(dof);
      }
    for (const auto &[rank, of_rank] :
         Utilities::MPI::some_to_some(communicator, by_owner))
      rows.append(of_rank);
    rows.sort();
  }



  template<int dim>
  typename LevelTransfer<dim>::Dofs
  LevelTransfer<dim>::at_same_nodes(const Dofs &fixed) const
  {
    Dofs result;
    for (const Dof dof : fixed)
      {
        const unsigned int row = rows.find(dof);
        AssertThrow(row != numbers::invalid_unsigned_int, ExcInternalError());
        if (rows.end(row) == rows.begin(row) + 1)
          result.push_back(rows.others[rows.begin(row)]);
      }
    sort_unique(result);
    const auto by_owner =
      Utilities::MPI::some_to_some(communicator,
                                   coarse_owners.by_owner(result));
    result.clear();
    for (const auto &of_rank : by_owner)
      result.insert(result.end(), of_rank.second.begin(), of_rank.second.end());
    sort_unique(result);
    return result;
  }



  template<int dim>
  void LevelTransfer<dim>::initialize()
  {
    transfer.initialize(fine.dof_handler,
                        coarse.dof_handler,
                        fine.supports(),
                        coarse.supports());
    resolve_constraints();
  }



  // Each rank knows the constraints of its own unknowns.
  template<int dim>
  void LevelTransfer<dim>::resolve_constraints()
  {
    Dofs read = rows.others;
    sort_unique(read);
    SurfaceRows constrained;
    const auto  answers = ask<SurfaceRows>(
      coarse_owners.by_owner(read),
      [&](const Dofs &dofs) {
        SurfaceRows answer;
        for (const Dof dof : dofs)
          if (coarse.supports().is_constrained(dof))
            {
              for (const auto &[leader, share] :
                   *coarse.supports().get_constraint_entries(dof))
                answer.add_entry(leader, share);
              answer.end_row(dof);
            }
        return answer;
      },
      communicator);
    for (const auto &answer : answers)
      constrained.append(answer.second);

    SurfaceRows resolved;
    resolved.reserve(rows);
    places.clear();
    places.reserve(rows.size());
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        Place place = rows.end(row) == rows.begin(row) + 1 ? Place::at_node
                                                           : Place::between;
        for (unsigned int k = rows.begin(row); k < rows.end(row); ++k)
          {
            const unsigned int by = constrained.find(rows.others[k]);
            if (by == numbers::invalid_unsigned_int)
              {
                resolved.add_entry(rows.others[k], rows.factors[k]);
                continue;
              }
            if (place == Place::at_node)
              place = Place::at_constrained_node;
            for (unsigned int j = constrained.begin(by);
                 j < constrained.end(by);
                 ++j)
              resolved.add_entry(constrained.others[j],
                                 rows.factors[k] * constrained.factors[j]);
          }
        resolved.end_row(rows.dofs[row]);
        places.push_back(place);
      }
    rows = std::move(resolved);
  }



  // Rows that were needed before are there still.
  template<int dim>
  void LevelTransfer<dim>::get_rows(const Dofs &fine_dofs)
  {
    Dofs missing;
    for (const Dof dof : fine_dofs)
      if (!rows.has(dof) && !others.has(dof))
        missing.push_back(dof);
    sort_unique(missing);
    const auto answers = ask<SurfaceRows>(
      fine_owners.by_owner(missing),
      [&](const Dofs &dofs) {
        SurfaceRows answer;
        for (const Dof dof : dofs)
          {
            const unsigned int row = rows.find(dof);
            if (row != numbers::invalid_unsigned_int)
              answer.add_row(rows, row);
          }
        return answer;
      },
      communicator);
    for (const auto &answer : answers)
      others.append(answer.second);
    others.sort();
  }



  template<int dim>
  bool LevelTransfer<dim>::lacks_rows(const Dofs &own, const Dofs &needed) const
  {
    return !std::all_of(own.begin(), own.end(), [&](const Dof dof) {
      return rows.has(dof);
    }) || !std::all_of(needed.begin(), needed.end(), [&](const Dof dof) {
      return rows.has(dof) || others.has(dof);
    });
  }



  template<int dim>
  void LevelTransfer<dim>::add_coarse(const Dof    fine_dof,
                                      const double factor,
                                      Sum         &sum) const
  {
    unsigned int       row    = rows.find(fine_dof);
    const bool         is_own = row != numbers::invalid_unsigned_int;
    const SurfaceRows &from   = is_own ? rows : others;
    if (!is_own)
      row = from.find(fine_dof);
    for (unsigned int k = from.begin(row); k < from.end(row); ++k)
      sum[from.others[k]] += factor * from.factors[k];
  }



  template<int dim>
  SurfaceRows LevelTransfer<dim>::lines_at_nodes(const SurfaceRows &lines) const
  {
    SurfaceRows made;
    Sum         sum;
    for (unsigned int line = 0; line < lines.size(); ++line)
      {
        const unsigned int row = rows.find(lines.dofs[line]);
        AssertThrow(row != numbers::invalid_unsigned_int, ExcInternalError());
        if (places[row] != Place::at_node)
          continue;
        const Dof dof = rows.others[rows.begin(row)];
        sum.clear();
        for (unsigned int k = lines.begin(line); k < lines.end(line); ++k)
          add_coarse(lines.others[k], lines.factors[k], sum);
        sum.erase(dof);
        made.add_row(dof, sum);
      }
    return made;
  }



  // Where a node of the fine level is eliminated and none of the coarse ones
  // that it is interpolated from, the line is that of the fine node, solved for
  // the coarse one that it depends on most: two or three points that hold a
  // body may all be between coarse nodes. All ranks choose from all of these,
  // which are few, one after the other.
  template<int dim>
  void LevelTransfer<dim>::add_lines_between(const SurfaceRows &lines,
                                             SurfaceRows       &made) const
  {
    SurfaceRows between, their_places;
    Sum         place, sum;
    for (unsigned int line = 0; line < lines.size(); ++line)
      {
        const Dof dof = lines.dofs[line];
        if (places[rows.find(dof)] != Place::between)
          continue;
        place.clear();
        add_coarse(dof, 1, place);
        if (place.empty() ||
            std::any_of(place.begin(), place.end(), [&](const auto &entry) {
              return made.has(entry.first);
            }))
          continue;
        const auto pivot =
          *std::max_element(place.begin(), place.end(), [](auto &a, auto &b) {
            return std::abs(a.second) < std::abs(b.second);
          });
        sum.clear();
        for (unsigned int k = lines.begin(line); k < lines.end(line); ++k)
          add_coarse(lines.others[k], lines.factors[k] / pivot.second, sum);
        for (const auto &[other, weight] : place)
          sum[other] -= weight / pivot.second;
        sum.erase(pivot.first);
        between.add_row(pivot.first, sum);
        their_places.add_row(pivot.first, place);
      }

    between      = between.of_all_ranks(communicator);
    their_places = their_places.of_all_ranks(communicator);
    std::set<Dof> chosen;
    for (unsigned int row = 0; row < between.size(); ++row)
      if (std::none_of(their_places.others.data() + their_places.begin(row),
                       their_places.others.data() + their_places.end(row),
                       [&](const Dof dof) { return chosen.count(dof) > 0; }))
        {
          chosen.insert(between.dofs[row]);
          made.add_row(between, row);
        }
    made.sort();
  }



  namespace
  {
    /// At the ends of surfaces a line may have unknowns that other lines
    /// eliminate. One of these is left to the finer level where it has further
    /// ones in turn, which might lead round in a circle.
    SurfaceRows without_circles(const SurfaceRows &lines)
    {
      const auto has_any = [&](const unsigned int line, const auto &is_one) {
        return std::any_of(lines.others.data() + lines.begin(line),
                           lines.others.data() + lines.end(line),
                           is_one);
      };
      std::vector<bool> is_by_lines(lines.size());
      for (unsigned int line = 0; line < lines.size(); ++line)
        is_by_lines[line] =
          has_any(line, [&](const auto dof) { return lines.has(dof); });
      SurfaceRows      result;
      SurfaceRows::Sum sum;
      for (unsigned int line = 0; line < lines.size(); ++line)
        {
          if (is_by_lines[line] && has_any(line, [&](const auto dof) {
                const unsigned int other = lines.find(dof);
                return other != numbers::invalid_unsigned_int &&
                       is_by_lines[other];
              }))
            continue;
          sum.clear();
          for (unsigned int k = lines.begin(line); k < lines.end(line); ++k)
            {
              const unsigned int by = is_by_lines[line]
                                        ? lines.find(lines.others[k])
                                        : numbers::invalid_unsigned_int;
              if (lines.factors[k] == 0)
                continue;
              if (by == numbers::invalid_unsigned_int)
                sum[lines.others[k]] += lines.factors[k];
              else
                for (unsigned int j = lines.begin(by); j < lines.end(by); ++j)
                  if (lines.factors[j] != 0)
                    sum[lines.others[j]] += lines.factors[k] * lines.factors[j];
            }
          result.add_row(lines.dofs[line], sum);
        }
      return result;
    }
  } // namespace



  // With ways interpolated, springs have the energy in displacements of the
  // coarse level that they have on the fine one.
  template<int dim>
  std::vector<SurfaceSpring> LevelTransfer<dim>::coarse_springs() const
  {
    std::vector<SurfaceSpring> springs;
    Sum                        sum;
    for (const auto &[stiffness, way] : fine.own_springs())
      {
        sum.clear();
        for (const auto &[dof, factor] : way)
          add_coarse(dof, factor, sum);
        springs.push_back({stiffness, {sum.begin(), sum.end()}});
      }
    return springs;
  }



  // Lines that lead to each other are found by all ranks in the same way: the
  // coarse level has all lines on all ranks.
  template<int dim>
  bool LevelTransfer<dim>::hand_down()
  {
    const SurfaceRows lines  = fine.own_lines();
    Dofs              needed = lines.others;
    for (const auto &spring : fine.own_springs())
      for (const auto &entry : spring.way)
        needed.push_back(entry.first);
    get_rows(needed);
    if (Utilities::MPI::max(static_cast<unsigned int>(
                              lacks_rows(lines.dofs, needed)),
                            communicator) > 0)
      throw SolverStalls("geometric multigrid does not know nodes that hang "
                         "on cells inside of a body");
    coarse.set_springs(coarse_springs());
    SurfaceRows made = lines_at_nodes(lines).of_all_ranks(communicator);
    made.sort();
    add_lines_between(lines, made);
    return coarse.set_lines(without_circles(made));
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
