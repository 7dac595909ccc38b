/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_distributed_mesh_h
#define contact_distributed_mesh_h

#include <deal.II/distributed/tria.h>

namespace Contact
{
  using namespace dealii;

  /**
   * A mesh of which each rank has a part, by p4est. Cells have their names by
   * the numbers of the coarse cells, not by those that p4est gives to them:
   * cells that are visited one by one then have ascending names. deal.II's
   * transfer between meshes makes sets of these, and if they are not filled in
   * ascending order it takes the square of the time.
   */
  template<int dim>
  class DistributedMesh : public parallel::distributed::Triangulation<dim>
  {
  public:
    using parallel::distributed::Triangulation<dim>::Triangulation;

  private:
    unsigned int coarse_cell_id_to_coarse_cell_index(
      const types::coarse_cell_id id) const override
    {
      return id;
    }

    types::coarse_cell_id
    coarse_cell_index_to_coarse_cell_id(const unsigned int index) const override
    {
      return index;
    }
  };
} // namespace Contact

#endif
