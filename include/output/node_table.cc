/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/node_table.h"

#include <deal.II/base/mpi.h>

#include <limits>
#include <ostream>
#include <set>

namespace Contact
{
  std::vector<NodeRow> collect_nodes(const Discretization<2> &discretization,
                                     const Vector<double>    &u,
                                     const Vector<double>    &contact_forces)
  {
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    std::set<types::global_dof_index>    seen;
    std::vector<types::global_dof_index> dofs;
    std::vector<NodeRow>                 rows;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        const auto &fe      = cell->get_fe();
        const auto &mapping = discretization.mapping[cell->active_fe_index()];
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const unsigned int x   = fe.component_to_system_index(0, a);
            const auto         dof = dofs[x];
            if (!owned.is_element(dof) || !seen.insert(dof).second)
              continue;
            const auto     y = dofs[fe.component_to_system_index(1, a)];
            const Point<2> X =
              mapping.transform_unit_to_real_cell(cell,
                                                  fe.unit_support_point(x));
            NodeRow row{discretization.mesh.pieces.of_cell(cell),
                        {{X[0], X[1], u[dof], u[y], 0, 0}}};
            if (contact_forces.size() > 0)
              for (unsigned int c = 0; c < 2; ++c)
                row.values[4 + c] = contact_forces[c == 0 ? dof : y];
            rows.push_back(row);
          }
      }

    std::vector<NodeRow> all;
    for (const auto &of_rank :
         Utilities::MPI::gather(discretization.communicator, rows))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
  }



  void write_nodes(std::ostream               &out,
                   const Mesh<2>              &mesh,
                   const std::vector<NodeRow> &rows)
  {
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "body,piece,X_mm,Y_mm,displacement_x_mm,displacement_y_mm,"
           "contact_force_x_N_per_mm,contact_force_y_N_per_mm\n";
    for (const NodeRow &row : rows)
      {
        out << mesh.body_name(mesh.pieces[row.piece].body) << ',' << row.piece;
        for (const double value : row.values)
          out << ',' << value + 0.; // no "-0"
        out << '\n';
      }
  }
} // namespace Contact
