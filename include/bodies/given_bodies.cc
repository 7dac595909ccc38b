/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "bodies/given_bodies.h"

#include <deal.II/fe/fe.h>

#include "base/errors.h"

namespace Contact
{
  template<int dim>
  GivenBodies<dim>::GivenBodies(const Mapping<dim>              &mapping,
                                const DoFHandler<dim>           &dof_handler,
                                const AffineConstraints<double> &constraints,
                                const Boundaries                &boundaries,
                                const Moduli                    &moduli)
    : DiscretizedBodies<dim>(dof_handler,
                             constraints,
                             hp::MappingCollection<dim>(mapping),
                             dof_handler.get_fe().degree,
                             /*axisymmetric=*/false,
                             MPI_COMM_SELF)
    , boundaries(boundaries)
    , moduli(moduli)
  {
    const auto        &fe        = dof_handler.get_fe();
    const unsigned int quadratic = 2;
    if (fe.n_components() != dim || !fe.has_support_points() ||
        fe.degree > quadratic)
      throw InputError("contact needs a displacement of degree 1 or 2 with one "
                       "component for each direction, but the element is " +
                         fe.get_name(),
                       "GivenBodies",
                       "take FESystem<dim>(FE_Q<dim>(1), dim)");
    pieces.find(dof_handler.get_triangulation());
    this->collect_vertex_dofs();
    IndexSet all = complete_index_set(dof_handler.n_dofs());
    this->distribution =
      std::make_shared<HeldUnknowns>(all, all, this->communicator);
  }



  template<int dim>
  const std::set<types::boundary_id> &
  GivenBodies<dim>::boundary_ids(const std::string &name,
                                 const std::string &entry) const
  {
    const auto found = boundaries.find(name);
    if (found == boundaries.end())
      throw InputError("there is no boundary '" + name + "'",
                       entry,
                       "name it in the boundaries of GivenBodies");
    return found->second;
  }



  // Only boundaries have names.
  template<int dim>
  std::vector<NodeDoFs<dim>>
  GivenBodies<dim>::nodes_of(const std::string &name,
                             const std::string &entry) const
  {
    return nodes_on(this->dof_handler, boundary_ids(name, entry));
  }



  template<int dim>
  std::string GivenBodies<dim>::body_name(const types::material_id id) const
  {
    return "material id " + std::to_string(id);
  }



  template<int dim>
  unsigned int GivenBodies<dim>::piece(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    return pieces.of_cell(cell);
  }



  template<int dim>
  bool GivenBodies<dim>::is_fixed(const types::global_dof_index dof) const
  {
    const auto *entries = this->constraints.get_constraint_entries(dof);
    return entries != nullptr && entries->empty();
  }



  template<int dim>
  bool GivenBodies<dim>::are_fixed_alike(const types::global_dof_index a,
                                         const types::global_dof_index b) const
  {
    return is_fixed(a) && is_fixed(b) &&
           !(this->constraints.get_inhomogeneity(a) !=
             this->constraints.get_inhomogeneity(b));
  }



  template<int dim>
  double GivenBodies<dim>::youngs_modulus(const types::material_id body) const
  {
    const auto found = moduli.find(body);
    if (found == moduli.end())
      throw InputError("there is no Young's modulus of the " + body_name(body),
                       "GivenBodies",
                       "name it in its moduli");
    return found->second;
  }

  template class GivenBodies<2>;
  template class GivenBodies<3>;
} // namespace Contact
