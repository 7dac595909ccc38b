/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/element_spaces.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

namespace Contact
{
  namespace
  {
    /// One point, or three points that are exact for polynomials of degree 2.
    /// The choice of the first corner of a triangle does not matter to them, as
    /// it does to the four points of QGaussSimplex<2>(2).
    Quadrature<2> triangle_rule(const unsigned int degree)
    {
      if (degree == 1)
        return QGaussSimplex<2>(1);
      return {{{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}},
              {1. / 6, 1. / 6, 1. / 6}};
    }
  } // namespace



  template<int dim>
  hp::MappingCollection<dim> make_mapping(const unsigned int degree)
  {
    hp::MappingCollection<dim> mapping{MappingQ<dim>(degree)};
    if constexpr (dim == 2)
      mapping.push_back(MappingFE<2>(FE_SimplexP<2>(degree)));
    return mapping;
  }

  template<int dim>
  hp::FECollection<dim> make_fe(const unsigned int degree)
  {
    hp::FECollection<dim> fe{FESystem<dim>(FE_Q<dim>(degree), dim)};
    if constexpr (dim == 2)
      fe.push_back(FESystem<2>(FE_SimplexP<2>(degree), 2));
    return fe;
  }

  template<int dim>
  hp::QCollection<dim> make_quadrature(const unsigned int degree)
  {
    hp::QCollection<dim> quadrature{QGauss<dim>(degree + 1)};
    if constexpr (dim == 2)
      quadrature.push_back(triangle_rule(degree));
    return quadrature;
  }



  template<int dim>
  void distribute_dofs(const Mesh<dim>             &mesh,
                       const hp::FECollection<dim> &fe,
                       DoFHandler<dim>             &dof_handler)
  {
    if (mesh.has_only_hypercubes())
      dof_handler.distribute_dofs(fe[0]);
    else
      {
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned())
            cell->set_active_fe_index(
              cell->reference_cell().is_hyper_cube() ? 0 : 1);
        dof_handler.distribute_dofs(fe);
      }
  }



  template hp::MappingCollection<2> make_mapping(const unsigned int);
  template hp::FECollection<2>      make_fe(const unsigned int);
  template hp::QCollection<2>       make_quadrature(const unsigned int);
  template hp::MappingCollection<3> make_mapping(const unsigned int);
  template hp::FECollection<3>      make_fe(const unsigned int);
  template hp::QCollection<3>       make_quadrature(const unsigned int);
  template void                     distribute_dofs(const Mesh<2> &,
                                                    const hp::FECollection<2> &,
                                                    DoFHandler<2> &);
  template void                     distribute_dofs(const Mesh<3> &,
                                                    const hp::FECollection<3> &,
                                                    DoFHandler<3> &);
} // namespace Contact
