/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/surface_cells.h"

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <map>

#include "base/exchange.h"

namespace Contact
{
  namespace
  {
    /// The ranks that own the active cells of a mesh: p4est gives each rank
    /// cells that follow each other in its order, tree by tree and child by
    /// child.
    template<int dim>
    class CellOwners
    {
    public:
      using Binary = CellId::binary_type;

      /// Collective.
      CellOwners(const Triangulation<dim> &mesh)
      {
        const auto *distributed =
          dynamic_cast<const parallel::distributed::Triangulation<dim> *>(
            &mesh);
        if (distributed != nullptr)
          trees = distributed->get_coarse_cell_to_p4est_tree_permutation();
        bool   has_cells = false;
        CellId first;
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              const CellId place = in_order(cell->id());
              if (!has_cells || place < first)
                first = place;
              has_cells = true;
            }
        // The rank and the name of its first cell.
        std::vector<unsigned int> own;
        if (has_cells)
          {
            const Binary name = first.template to_binary<dim>();
            own.push_back(
              Utilities::MPI::this_mpi_process(mesh.get_communicator()));
            own.insert(own.end(), name.begin(), name.end());
          }
        const auto all = gathered(own, mesh.get_communicator());
        for (auto at = all.begin(); at != all.end();)
          {
            Binary name;
            ranks.push_back(*at++);
            std::copy_n(at, name.size(), name.begin());
            firsts.emplace_back(name);
            at += name.size();
          }
      }

      /// Of a cell or, if this is not in the mesh, the one that it is in.
      unsigned int owner(const CellId &cell) const
      {
        const auto behind =
          std::upper_bound(firsts.begin(), firsts.end(), in_order(cell));
        return ranks[behind == firsts.begin() ? 0
                                              : behind - firsts.begin() - 1];
      }

    private:
      CellId in_order(const CellId &cell) const
      {
        const auto                children = cell.get_child_indices();
        std::vector<std::uint8_t> path(children.begin(), children.end());
        const auto                number = cell.get_coarse_cell_id();
        return {trees.empty() ? number : trees[number], path};
      }

      std::vector<types::global_dof_index> trees; // of the coarse cells
      std::vector<unsigned int>            ranks; // that have cells
      std::vector<CellId>                  firsts;
    };



    CellId parent(const CellId &child)
    {
      const auto                children = child.get_child_indices();
      std::vector<std::uint8_t> path(children.begin(), children.end());
      path.pop_back();
      return {child.get_coarse_cell_id(), path};
    }
  } // namespace



  template<int dim>
  SurfaceCells<dim>::SurfaceCells(const DoFHandler<dim> &dof_handler,
                                  const Choice          &choice)
  {
    std::map<CellId, Dofs> all;
    Dofs                   of_cell(dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && choice(cell))
        {
          cell->get_dof_indices(of_cell);
          all.emplace(cell->id(), of_cell);
        }
    for (auto &[name, of_this] : all)
      {
        names.push_back(name);
        dofs.push_back(std::move(of_this));
      }
  }



  template<int dim>
  SurfaceCells<dim>
  SurfaceCells<dim>::coarser(const DoFHandler<dim> &coarse,
                             std::vector<Coarse>   &of_cells) const
  {
    using Binaries             = std::vector<CellId::binary_type>;
    const auto           &mesh = coarse.get_triangulation();
    const CellOwners<dim> owners(mesh);

    std::map<unsigned int, Binaries>                  questions;
    std::map<unsigned int, std::vector<unsigned int>> asked;
    for (unsigned int c = 0; c < names.size(); ++c)
      {
        const unsigned int owner = owners.owner(names[c]);
        questions[owner].push_back(names[c].template to_binary<dim>());
        asked[owner].push_back(c);
      }

    // Of each cell whether its coarse one is refined, and the unknowns of this.
    std::map<CellId, Dofs> own;
    Dofs                   of_cell(coarse.get_fe().n_dofs_per_cell());
    const auto             answers = ask<Dofs>(
      questions,
      [&](const Binaries &cells) {
        Dofs answer;
        for (const auto &binary : cells)
          {
            const CellId cell(binary);
            const bool   has_parent = cell.get_child_indices().size() > 0;
            auto         at =
              mesh.create_cell_iterator(has_parent ? parent(cell) : cell);
            const bool is_refined = has_parent && at->is_active();
            if (has_parent && !is_refined)
              at = at->child(last_child(cell));
            AssertThrow(at->is_active() && at->is_locally_owned(),
                        ExcInternalError());
            const typename DoFHandler<dim>::active_cell_iterator
              with_dofs(&mesh, at->level(), at->index(), &coarse);
            with_dofs->get_dof_indices(of_cell);
            answer.push_back(is_refined);
            answer.insert(answer.end(), of_cell.begin(), of_cell.end());
            own.emplace(with_dofs->id(), of_cell);
          }
        return answer;
      },
      mesh.get_communicator());

    of_cells.resize(names.size());
    for (const auto &[rank, answer] : answers)
      {
        auto at = answer.begin();
        for (const unsigned int c : asked.at(rank))
          {
            of_cells[c].is_refined = *at++;
            of_cells[c].dofs.assign(at, at + of_cell.size());
            at += of_cell.size();
          }
      }

    SurfaceCells result;
    for (auto &[name, of_this] : own)
      {
        result.names.push_back(name);
        result.dofs.push_back(std::move(of_this));
      }
    return result;
  }

  template class SurfaceCells<2>;
  template class SurfaceCells<3>;
} // namespace Contact
