/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/node_table.h"

#include <deal.II/base/mpi.h>

#include <limits>
#include <ostream>
#include <set>
#include <string>

namespace Contact
{
  template<int dim>
  std::vector<NodeRow<dim>>
  collect_nodes(const Discretization<dim> &discretization,
                const GhostedVector       &u,
                const GhostedVector       &contact_forces)
  {
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    std::set<types::global_dof_index>    seen;
    std::vector<types::global_dof_index> dofs;
    std::vector<NodeRow<dim>>            rows;
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
            const Point<dim> X =
              mapping.transform_unit_to_real_cell(cell,
                                                  fe.unit_support_point(x));
            NodeRow<dim> row;
            row.piece = discretization.mesh.pieces.of_cell(cell);
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto in_c     = dofs[fe.component_to_system_index(c, a)];
                row.values[c]       = X[c];
                row.values[dim + c] = u[in_c];
                if (contact_forces.size() > 0)
                  row.values[2 * dim + c] = contact_forces[in_c];
              }
            rows.push_back(row);
          }
      }

    std::vector<NodeRow<dim>> all;
    for (const auto &of_rank :
         Utilities::MPI::gather(discretization.communicator, rows))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
  }



  template<int dim>
  void write_nodes(std::ostream                    &out,
                   const Mesh<dim>                 &mesh,
                   const std::vector<NodeRow<dim>> &rows,
                   const std::string               &force_unit)
  {
    std::string places, displacements, forces;
    for (unsigned int d = 0; d < dim; ++d)
      {
        places += std::string(",") + "XYZ"[d] + "_mm";
        displacements += std::string(",displacement_") + "xyz"[d] + "_mm";
        forces += std::string(",contact_force_") + "xyz"[d] + '_' + force_unit;
      }
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "body,piece" << places << displacements << forces << '\n';
    for (const NodeRow<dim> &row : rows)
      {
        out << mesh.body_name(mesh.pieces[row.piece].body) << ',' << row.piece;
        for (const double value : row.values)
          out << ',' << value + 0.; // no "-0"
        out << '\n';
      }
  }

  template std::vector<NodeRow<2>>
  collect_nodes(const Discretization<2> &discretization,
                const GhostedVector     &u,
                const GhostedVector     &contact_forces);
  template std::vector<NodeRow<3>>
                collect_nodes(const Discretization<3> &discretization,
                              const GhostedVector     &u,
                              const GhostedVector     &contact_forces);
  template void write_nodes(std::ostream                  &out,
                            const Mesh<2>                 &mesh,
                            const std::vector<NodeRow<2>> &rows,
                            const std::string             &force_unit);
  template void write_nodes(std::ostream                  &out,
                            const Mesh<3>                 &mesh,
                            const std::vector<NodeRow<3>> &rows,
                            const std::string             &force_unit);
} // namespace Contact
