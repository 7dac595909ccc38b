/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_grids_h
#define contact_body_grids_h

#include <map>
#include <vector>

#include "output/vtu/vtu_file.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The bodies as grids with the results of a state: at the nodes displacement
   * [mm], Cauchy and von Mises stress [MPa], which are recovered at the
   * vertices and between them linear, or of linear stresses, and, unless they
   * are empty, forces of contact [N per mm of thickness; rings and volumes: N]
   * and equivalent plastic strains [-]; by cells the number of the body, the
   * level of refinement and the process.
   */
  template<int dim>
  class BodyGrids
  {
  public:
    /// Stresses and strains are by vertex of the triangulation. Collective.
    BodyGrids(const Discretization<dim>                &discretization,
              const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
              const std::vector<double>                &plastic_strains,
              const GhostedVector                      &solution,
              const GhostedVector                      &contact_forces);

    /// The cells of a body that this process owns.
    VtuGrid grid(const types::material_id body) const;

  private:
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /// The points of a grid by their first unknown.
    using Points = std::map<types::global_dof_index, std::int32_t>;

    VtuGrid empty_grid() const;
    void    add_cell(const Cell &cell, Points &points, VtuGrid &grid) const;
    void    add_values(const Cell        &cell,
                       const unsigned int node,
                       const Point<dim>  &unit,
                       VtuGrid           &grid) const;

    const Discretization<dim>               &discretization;
    const std::vector<SymmetricTensor<2, 3>> stresses;
    const std::vector<double>                plastic_strains;
    const DistributedVector                  displacement;
    const DistributedVector                  forces; // or nothing
  };
} // namespace Contact

#endif
