/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/strain_range.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    double rotation_of(const Tensor<2, 2> &F)
    {
      return std::abs(std::atan2(F[1][0] - F[0][1], F[0][0] + F[1][1]));
    }



    double rotation_of(const Tensor<2, 3> &F)
    {
      const double cosine = (trace(project_onto_orthogonal_tensors(F)) - 1) / 2;
      return std::acos(std::min(1., std::max(-1., cosine)));
    }



    /// Take the deformation gradient of a point into the range.
    template<int dim>
    void extend(const Tensor<2, dim> &F, StrainRange &range)
    {
      const SymmetricTensor<2, dim> E =
        0.5 * (symmetrize(transpose(F) * F) - unit_symmetric_tensor<dim>());
      for (const double principal : eigenvalues(E))
        range.strain = std::max(range.strain, std::abs(principal));
      range.rotation = std::max(range.rotation, rotation_of(F));
    }
  } // namespace



  template<int dim>
  StrainRange strain_range(const Discretization<dim> &discretization,
                           const Vector<double>      &u)
  {
    const FEValuesExtractors::Vector displacement(0);
    hp::FEValues<dim>                fe_values(discretization.mapping,
                                discretization.fe,
                                discretization.quadrature,
                                update_values | update_gradients |
                                  update_quadrature_points);
    std::vector<Tensor<2, dim>>      gradients;
    std::vector<Tensor<1, dim>>      values;
    StrainRange                      range;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        const auto &here = fe_values.get_present_fe_values();
        gradients.resize(here.n_quadrature_points);
        values.resize(here.n_quadrature_points);
        here[displacement].get_function_gradients(u, gradients);
        here[displacement].get_function_values(u, values);
        for (unsigned int q = 0; q < here.n_quadrature_points; ++q)
          {
            extend<dim>(gradients[q] + unit_symmetric_tensor<dim>(), range);
            if (!discretization.axisymmetric)
              continue;
            const double stretch =
              1 + values[q][0] / here.quadrature_point(q)[0];
            range.strain =
              std::max(range.strain, std::abs(stretch * stretch - 1) / 2);
          }
      }
    return range;
  }



  template<int dim>
  double change_of_edges(const Discretization<dim> &discretization,
                         const Elasticity<dim>     &elasticity,
                         const GhostedVector       &u)
  {
    const auto &dofs    = discretization.vertex_dofs;
    double      largest = 0;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() &&
          elasticity.is_small_strain(cell->material_id()))
        for (const unsigned int edge : cell->line_indices())
          {
            const auto     line = cell->line(edge);
            Tensor<1, dim> X = line->vertex(1) - line->vertex(0), x = X;
            for (unsigned int c = 0; c < dim; ++c)
              x[c] += u[dofs[line->vertex_index(1)][c]] -
                      u[dofs[line->vertex_index(0)][c]];
            largest = std::max(largest, std::abs(x.norm() / X.norm() - 1));
          }
    return Utilities::MPI::max(largest, discretization.communicator);
  }



  std::string beyond_range(const StrainRange &range, const bool is_small_strain)
  {
    if (is_small_strain)
      {
        const double lengthens = range.rotation * range.rotation / 2;
        return 10 * lengthens > range.strain
                 ? "in small strain a rotation of " + brief(range.rotation) +
                     " rad lengthens by " + brief(100 * lengthens) +
                     " %, beside strains of " + brief(100 * range.strain) +
                     " %: set Solids/Kinematics = large displacement"
                 : "";
      }
    const double stretch = std::sqrt(1 + 2 * range.strain);
    const double linear  = range.strain * stretch;
    const double hencky  = std::log(stretch) / stretch;
    return linear > 1.1 * hencky
             ? "strains of " + brief(100 * range.strain) +
                 " % are beyond the range of Saint Venant and Kirchhoff's law: "
                 "the stress of Hencky's law differs by " +
                 brief(100 * (linear / hencky - 1)) + " % there"
             : "";
  }



  template StrainRange strain_range(const Discretization<2> &,
                                    const Vector<double> &);
  template StrainRange strain_range(const Discretization<3> &,
                                    const Vector<double> &);
  template double      change_of_edges(const Discretization<2> &,
                                       const Elasticity<2> &,
                                       const GhostedVector &);
  template double      change_of_edges(const Discretization<3> &,
                                       const Elasticity<3> &,
                                       const GhostedVector &);
} // namespace Contact
