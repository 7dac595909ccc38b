/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/resultant.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>

#include "solid/followers.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    IndexSet unknowns_at(const Discretization<dim>          &discretization,
                         const std::set<types::boundary_id> &boundary,
                         const unsigned int                  direction,
                         const bool                          of_supports)
    {
      ComponentMask mask(dim, false);
      mask.set(direction, true);
      IndexSet unknowns(discretization.dof_handler.n_dofs());
      for (const auto dof :
           DoFTools::extract_boundary_dofs(discretization.dof_handler,
                                           mask,
                                           boundary))
        if (discretization.is_fixed(dof) == of_supports)
          unknowns.add_index(dof);
      return unknowns;
    }
  } // namespace



  template<int dim>
  Resultant<dim>::Resultant(const Elasticity<dim>              &elasticity,
                            const Discretization<dim>          &discretization,
                            const std::set<types::boundary_id> &boundary,
                            const unsigned int                  direction,
                            const bool                          of_supports)
    : unknowns(unknowns_at(discretization, boundary, direction, of_supports))
    , elasticity(elasticity)
    , discretization(discretization)
  {
  }



  template<int dim>
  double Resultant<dim>::value(const Vector<double> &solution,
                               const double          load_factor) const
  {
    Vector<double> forces = elasticity.forces(solution, load_factor);
    hand_over_from_followers(discretization, forces);
    double sum = 0;
    for (const auto dof : discretization.dof_handler.locally_owned_dofs())
      if (unknowns.is_element(dof))
        sum += forces[dof];
    return Utilities::MPI::sum(sum, discretization.communicator);
  }



  template<int dim>
  Vector<double> Resultant<dim>::test_function() const
  {
    Vector<double> v(discretization.dof_handler.n_dofs());
    for (const auto dof : unknowns)
      v[dof] = 1;
    followers(discretization).distribute(v);
    return v;
  }



  template<int dim>
  void Resultant<dim>::add_derivative(const Vector<double> &solution,
                                      const double          factor,
                                      Vector<double>       &derivative) const
  {
    const Vector<double>      v = test_function();
    std::vector<unsigned int> chosen;
    for (unsigned int c = 0; c < elasticity.n_cells(); ++c)
      {
        const auto &dofs = elasticity.dofs_of_cell(c);
        if (std::any_of(dofs.begin(), dofs.end(), [&](const auto dof) {
              return v[dof] != 0;
            }))
          chosen.push_back(c);
      }
    elasticity.visit_cells(solution,
                           /*with_tangent=*/true,
                           chosen,
                           [&](const std::vector<types::global_dof_index> &dofs,
                               const FullMatrix<double> &tangent,
                               const Vector<double> &) {
                             for (unsigned int i = 0; i < dofs.size(); ++i)
                               for (unsigned int j = 0; j < dofs.size(); ++j)
                                 derivative[dofs[j]] +=
                                   factor * v[dofs[i]] * tangent(i, j);
                           });
  }



  template class Resultant<2>;
  template class Resultant<3>;
} // namespace Contact
