/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_level_meshes_h
#define contact_level_meshes_h

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * The meshes of a geometric multigrid: each cell is one of the next finer
   * mesh, or the parent of such cells. The first ones are made by coarsening a
   * copy of the finest mesh. After that a mesh which is refined in all cells is
   * kept as the next of them: a copy of a quarter (in 3-D an eighth) of the
   * new mesh instead of all of it, and nothing has to be coarsened, which on
   * several ranks takes as long as on one. Of triangles and tetrahedra, which
   * deal.II does not coarsen, all meshes are kept.
   */
  template<int dim>
  class LevelMeshes
  {
  public:
    using List = std::vector<std::shared_ptr<const Triangulation<dim>>>;

    /// The coarsest mesh first; the last one is @p finest itself, which has to
    /// live as long. Collective.
    List of(const Triangulation<dim> &finest) const;

    /// Keep the mesh, of which all cells are about to be refined, if there are
    /// meshes already, or this is the first one and has no others.
    /// Collective.
    void keep(const Triangulation<dim> &mesh);

    /// Another mesh is to come.
    void forget()
    {
      coarser.clear();
      are_known = false;
    }

  private:
    mutable List coarser;
    mutable bool are_known = false;
  };
} // namespace Contact

#endif
