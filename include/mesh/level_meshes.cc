/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/level_meshes.h"

#include "mesh/distributed_mesh.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    std::shared_ptr<Triangulation<dim>> copy_of(const Triangulation<dim> &mesh)
    {
      const auto  smoothing = mesh.get_mesh_smoothing();
      const auto *distributed =
        dynamic_cast<const DistributedMesh<dim> *>(&mesh);
      std::shared_ptr<Triangulation<dim>> copy;
      if (distributed != nullptr)
        copy = std::make_shared<DistributedMesh<dim>>(
          distributed->get_communicator(),
          smoothing);
      else
        copy = std::make_shared<Triangulation<dim>>(smoothing);
      copy->copy_triangulation(mesh);
      return copy;
    }
  } // namespace



  template<int dim>
  typename LevelMeshes<dim>::List
  LevelMeshes<dim>::of(const Triangulation<dim> &finest) const
  {
    if (!are_known)
      {
        for (unsigned int l = finest.n_global_levels(); l > 1; --l)
          {
            const auto copy =
              copy_of(coarser.empty() ? finest : *coarser.front());
            copy->coarsen_global();
            coarser.insert(coarser.begin(), copy);
          }
        are_known = true;
      }
    List all = coarser;
    all.emplace_back(&finest, [](const auto *) {});
    return all;
  }



  template<int dim>
  void LevelMeshes<dim>::keep(const Triangulation<dim> &mesh)
  {
    if (mesh.n_global_levels() == 1 && mesh.all_reference_cells_are_simplex())
      are_known = true;
    if (are_known)
      coarser.push_back(copy_of(mesh));
  }

  template class LevelMeshes<2>;
  template class LevelMeshes<3>;
} // namespace Contact
