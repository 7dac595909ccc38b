/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_vertex_fields_h
#define contact_vertex_fields_h

#include <deal.II/numerics/data_out.h>

#include <string>
#include <utility>
#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The recovered stress as finite element fields that are given by their
   * values at the vertices: linear, whatever the degree of the displacement.
   */
  template<int dim>
  class VertexFields
  {
  public:
    /// Of the stress [MPa] by vertex of the triangulation, and of the
    /// equivalent plastic strain [-], which may be empty.
    VertexFields(const Discretization<dim>                &discretization,
                 const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                 const std::vector<double>                &plastic_strains);

    /// Attach stress_xx, _yy, _zz, _xy, in 3-D _xz and _yz, and von_mises
    /// [MPa] of these at all nodes of the bodies, and plastic_strain if there
    /// is one, to @p data_out, which must not outlive this object.
    void attach(DataOut<dim> &data_out) const;

  private:
    void find_von_mises(const MPI_Comm communicator);

    const hp::FECollection<dim> fe;
    DoFHandler<dim>             dof_handler;

    /// Name and values by unknown of the fields.
    std::vector<std::pair<std::string, DistributedVector>> fields;

    /// Von Mises' stress, which is not linear between vertices.
    const hp::FECollection<dim> fe_of_nodes;
    DoFHandler<dim>             nodes;
    DistributedVector           von_mises_at_nodes;
  };
} // namespace Contact

#endif
