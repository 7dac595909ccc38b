/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "verification/rigid_fit.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// Call @p visit with the body of each corner of a cell, with its place and
    /// its displacement: as often as it is in cells.
    template<int dim, typename Visit>
    void for_corners(const Discretization<dim> &discretization,
                     const GhostedVector       &u,
                     const Visit               &visit)
    {
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto &dofs =
                discretization.vertex_dofs[cell->vertex_index(v)];
              Tensor<1, dim> way;
              for (unsigned int i = 0; i < dim; ++i)
                way[i] = u[dofs[i]];
              visit(cell->material_id(), cell->vertex(v), way);
            }
    }

    template<int rank, int dim>
    void sum_over_ranks(Tensor<rank, dim> &tensor, const MPI_Comm communicator)
    {
      tensor = Utilities::MPI::sum(tensor, communicator);
    }
  } // namespace



  template<int dim>
  RigidFits<dim> fit_rigid_motions(const Discretization<dim> &discretization,
                                   const GhostedVector       &u)
  {
    std::map<types::material_id, RigidFit<dim>>  fits;
    std::map<types::material_id, Tensor<2, dim>> correlations;
    std::map<types::material_id, double>         n;
    const auto communicator = discretization.communicator;
    for (const auto &body : discretization.mesh.bodies)
      {
        fits[body.second];
        correlations[body.second];
        n[body.second] = 0;
      }
    for_corners(discretization, u, [&](const auto body, auto &X, auto &way) {
      n[body] += 1;
      fits[body].centre_X += X;
      fits[body].centre += X + way;
    });
    for (auto &[body, fit] : fits)
      {
        const double all = Utilities::MPI::sum(n[body], communicator);
        sum_over_ranks(fit.centre_X, communicator);
        sum_over_ranks(fit.centre, communicator);
        fit.centre_X /= all;
        fit.centre /= all;
        if (discretization.axisymmetric)
          fit.centre[0] = fit.centre_X[0];
      }
    if (!discretization.axisymmetric)
      {
        for_corners(discretization,
                    u,
                    [&](const auto body, auto &X, auto &way) {
                      correlations[body] +=
                        outer_product(X + way - fits[body].centre,
                                      X - fits[body].centre_X);
                    });
        for (auto &[body, fit] : fits)
          {
            sum_over_ranks(correlations[body], communicator);
            fit.R = project_onto_orthogonal_tensors(correlations[body]);
          }
      }
    return fits;
  }



  template<int dim>
  std::map<types::material_id, double>
  deformations_along(const Discretization<dim> &discretization,
                     const RigidFits<dim>      &fits,
                     const GhostedVector       &u,
                     const Tensor<1, dim>      &direction)
  {
    std::map<types::material_id, double> largest;
    for (const auto &[body, fit] : fits)
      largest[body] = 0;
    for_corners(discretization, u, [&](const auto body, auto &X, auto &way) {
      largest[body] =
        std::max(largest[body],
                 std::abs(fits.at(body).deformation(X, way) * direction));
    });
    for (auto &[body, of_body] : largest)
      of_body = Utilities::MPI::max(of_body, discretization.communicator);
    return largest;
  }



  template<int dim>
  double largest_deformation(const Surface<dim>   &surface,
                             const RigidFits<dim> &fits,
                             const GhostedVector  &u)
  {
    double largest = 0;
    for (const SurfaceFacet<dim> &facet : surface.facets)
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        {
          const unsigned int node = facet.nodes[a];
          const Point<dim>  &X    = surface.nodes[node].X;
          largest                 = std::max(largest,
                             fits.at(facet.body)
                               .deformation(X, surface.position(node, u) - X)
                               .norm());
        }
    return largest;
  }

#define INSTANTIATE(dim)                                                 \
  template RigidFits<dim> fit_rigid_motions(const Discretization<dim> &, \
                                            const GhostedVector &);      \
  template std::map<types::material_id, double> deformations_along(      \
    const Discretization<dim> &,                                         \
    const RigidFits<dim> &,                                              \
    const GhostedVector &,                                               \
    const Tensor<1, dim> &);                                             \
  template double largest_deformation(const Surface<dim> &,              \
                                      const RigidFits<dim> &,            \
                                      const GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
