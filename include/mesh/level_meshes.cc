/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/level_meshes.h"

#include <deal.II/distributed/tria.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

namespace Contact
{
  template<int dim>
  typename LevelMeshes<dim>::List
  LevelMeshes<dim>::of(const Triangulation<dim> &finest) const
  {
    if (!are_known)
      {
        coarser =
          MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(
            finest);
        coarser.pop_back(); // the finest one
        are_known = true;
      }
    List all = coarser;
    all.emplace_back(&finest, [](const auto *) {});
    return all;
  }



  template<int dim>
  void LevelMeshes<dim>::keep(const Triangulation<dim> &mesh)
  {
    if (!are_known)
      return;
    const auto                          smoothing = mesh.get_mesh_smoothing();
    std::shared_ptr<Triangulation<dim>> copy;
    if (const auto *distributed =
          dynamic_cast<const parallel::distributed::Triangulation<dim> *>(
            &mesh))
      copy = std::make_shared<parallel::distributed::Triangulation<dim>>(
        distributed->get_communicator(),
        smoothing);
    else
      copy = std::make_shared<Triangulation<dim>>(smoothing);
    copy->copy_triangulation(mesh);
    coarser.push_back(copy);
  }

  template class LevelMeshes<2>;
  template class LevelMeshes<3>;
} // namespace Contact
