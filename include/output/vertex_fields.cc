/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/vertex_fields.h"

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include "solid/stress_recovery.h"

namespace Contact
{
  VertexFields::VertexFields(
    const Discretization<2>                  &discretization,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses)
    : fe(FE_Q<2>(1), FE_SimplexP<2>(1))
    , dof_handler(discretization.mesh.triangulation)
  {
    distribute_dofs(discretization.mesh, fe, dof_handler);
    for (const char *name :
         {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "von_mises"})
      fields.emplace_back(name, Vector<double>(dof_handler.n_dofs()));

    // A vertex of another rank may have cells that this one does not know.
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto dof =
              cell->vertex_dof_index(v, 0, cell->active_fe_index());
            if (!owned.is_element(dof))
              continue;
            const auto  &stress = vertex_stresses[cell->vertex_index(v)];
            unsigned int c      = 0;
            for (const double value : {stress[0][0],
                                       stress[1][1],
                                       stress[2][2],
                                       stress[0][1],
                                       von_mises(stress)})
              fields[c++].second[dof] = value;
          }
  }



  void VertexFields::attach(DataOut<2> &data_out) const
  {
    for (const auto &[name, values] : fields)
      data_out.add_data_vector(dof_handler, values, name);
  }
} // namespace Contact
