/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/resultant.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "solid/followers.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    std::map<types::global_dof_index, double>
    weights_at(const Discretization<dim>        &discretization,
               const std::vector<NodeDoFs<dim>> &nodes,
               const unsigned int                direction,
               const bool                        of_supports)
    {
      const Tensor<1, dim> unit = Point<dim>::unit_vector(direction);
      std::map<types::global_dof_index, double> weights;
      for (const NodeDoFs<dim> &node : nodes)
        {
          const Tensor<1, dim> free = discretization.is_rigid(node[0])
                                        ? Tensor<1, dim>()
                                        : discretization.free_part(node, unit);
          const Tensor<1, dim> part = of_supports ? unit - free : free;
          for (unsigned int c = 0; c < dim; ++c)
            if (part[c] != 0)
              weights[node[c]] = part[c];
        }
      return weights;
    }
  } // namespace



  template<int dim>
  Resultant<dim>::Resultant(const Elasticity<dim>              &elasticity,
                            const Discretization<dim>          &discretization,
                            const std::set<types::boundary_id> &boundary,
                            const unsigned int                  direction,
                            const bool                          of_supports)
    : Resultant(elasticity,
                discretization,
                nodes_on(discretization.dof_handler, boundary),
                direction,
                of_supports)
  {
  }



  template<int dim>
  Resultant<dim>::Resultant(const Elasticity<dim>            &elasticity,
                            const Discretization<dim>        &discretization,
                            const std::vector<NodeDoFs<dim>> &nodes,
                            const unsigned int                direction,
                            const bool                        of_supports)
    : weights(weights_at<dim>(discretization, nodes, direction, of_supports))
    , elasticity(elasticity)
    , discretization(discretization)
  {
  }



  template<int dim>
  double Resultant<dim>::value(const GhostedVector &solution,
                               const double         load_factor,
                               const GhostedVector &left_out) const
  {
    const auto    cells  = elasticity.cells_at(test_function());
    GhostedVector forces = elasticity.forces(solution, load_factor, &cells);
    if (left_out.size() > 0)
      forces -= left_out;
    hand_over_from_followers(discretization, forces);
    double      sum   = 0;
    const auto &owned = discretization.dof_handler.locally_owned_dofs();
    for (const auto &[dof, weight] : weights)
      if (owned.is_element(dof))
        sum += weight * forces[dof];
    return Utilities::MPI::sum(sum, discretization.communicator);
  }



  template<int dim>
  GhostedVector Resultant<dim>::test_function() const
  {
    GhostedVector v(discretization.distribution);
    for (const auto &[dof, weight] : weights)
      v[dof] = weight;
    discretization.distribute(discretization.followers(), v);
    return v;
  }



  template<int dim>
  IndexSet Resultant<dim>::unknowns() const
  {
    IndexSet unknowns(discretization.dof_handler.n_dofs());
    for (const auto &weight : weights)
      unknowns.add_index(weight.first);
    return unknowns;
  }



  template<int dim>
  void Resultant<dim>::add_derivative(const GhostedVector &solution,
                                      const double         factor,
                                      GhostedVector       &derivative) const
  {
    const GhostedVector v     = test_function();
    const auto          cells = elasticity.cells_at(v);
    elasticity.visit_cells(
      solution,
      /*with_tangent=*/true,
      [&](const std::vector<types::global_dof_index> &dofs,
          const FullMatrix<double>                   &tangent,
          const Vector<double> &) {
        for (unsigned int i = 0; i < dofs.size(); ++i)
          for (unsigned int j = 0; j < dofs.size(); ++j)
            derivative[dofs[j]] += factor * v[dofs[i]] * tangent(i, j);
      },
      &cells);
  }

  template class Resultant<2>;
  template class Resultant<3>;
} // namespace Contact
