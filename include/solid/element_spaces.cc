/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/element_spaces.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold.h>

#include <memory>

#include "base/errors.h"
#include "mesh/coarse_cells.h"

namespace Contact
{
  namespace
  {
    /**
     * The isoparametric mapping of triangles and tetrahedra, with the middle of
     * each line where the manifold of the line has it. deal.II's own asks the
     * manifold of the cell for all of them.
     */
    template<int dim>
    class SimplexMapping : public MappingFE<dim>
    {
    public:
      explicit SimplexMapping(const unsigned int degree)
        : MappingFE<dim>(FE_SimplexP<dim>(degree))
        , degree(degree)
      {
      }

      std::unique_ptr<Mapping<dim>> clone() const override
      {
        return std::make_unique<SimplexMapping<dim>>(degree);
      }

    private:
      // In the order of the nodes of FE_SimplexP.
      std::vector<Point<dim>> compute_mapping_support_points(
        const typename Triangulation<dim>::cell_iterator &cell) const override
      {
        std::vector<Point<dim>> points;
        for (const unsigned int v : cell->vertex_indices())
          points.push_back(cell->vertex(v));
        for (const unsigned int l : cell->line_indices())
          if (degree == 2)
            points.push_back(cell->line(l)->center(/*respect_manifold=*/true));
        return points;
      }

      const unsigned int degree;
    };



    /// One point, or dim + 1 points that are exact for polynomials of degree 2.
    /// The choice of the first corner of a triangle does not matter to its
    /// three, as it does to the four of QGaussSimplex<2>(2).
    template<int dim>
    Quadrature<dim> simplex_rule(const unsigned int degree)
    {
      if constexpr (dim == 2)
        if (degree == 2)
          return {{{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}},
                  {1. / 6, 1. / 6, 1. / 6}};
      return QGaussSimplex<dim>(degree);
    }
  } // namespace



  template<int dim>
  hp::MappingCollection<dim> make_mapping(const unsigned int degree)
  {
    return hp::MappingCollection<dim>(MappingQ<dim>(degree),
                                      SimplexMapping<dim>(degree));
  }

  template<int dim>
  hp::FECollection<dim> make_fe(const unsigned int degree)
  {
    return hp::FECollection<dim>(FESystem<dim>(FE_Q<dim>(degree), dim),
                                 FESystem<dim>(FE_SimplexP<dim>(degree), dim));
  }

  template<int dim>
  hp::QCollection<dim> make_quadrature(const unsigned int degree)
  {
    return hp::QCollection<dim>(QGauss<dim>(degree + 1),
                                simplex_rule<dim>(degree));
  }

  template<int dim>
  hp::QCollection<dim - 1> make_face_quadrature(const unsigned int degree)
  {
    hp::QCollection<dim - 1> quadrature{QGauss<dim - 1>(degree + 1)};
    if constexpr (dim == 2)
      quadrature.push_back(QGauss<1>(degree + 1));
    else
      quadrature.push_back(QGaussSimplex<2>(degree + 1));
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



  template<int dim>
  void check_curved_simplices(const DoFHandler<dim>            &dof_handler,
                              const hp::MappingCollection<dim> &mapping)
  {
    const FE_SimplexP<dim> fe(2);
    FEValues<dim>          fe_values(mapping[1],
                            fe,
                            Quadrature<dim>(fe.get_unit_support_points()),
                            update_jacobians);
    const auto             is_curved = [](const auto &cell) {
      for (const unsigned int l : cell->line_indices())
        if (cell->line(l)->manifold_id() != numbers::flat_manifold_id)
          return true;
      return false;
    };
    for (const auto &cell :
         dof_handler.get_triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && !cell->reference_cell().is_hyper_cube() &&
          is_curved(cell))
        {
          fe_values.reinit(cell);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            if (!(determinant(Tensor<2, dim>(fe_values.jacobian(q))) > 0))
              throw InputError("its curved sides turn the cell at " +
                                 to_string(cell->center()) + " mm inside out",
                               "section 'Mesh'",
                               "make the mesh finer there, or leave its sides "
                               "straight");
        }
  }



  template hp::MappingCollection<2> make_mapping(const unsigned int);
  template hp::FECollection<2>      make_fe(const unsigned int);
  template hp::QCollection<2>       make_quadrature(const unsigned int);
  template hp::MappingCollection<3> make_mapping(const unsigned int);
  template hp::FECollection<3>      make_fe(const unsigned int);
  template hp::QCollection<3>       make_quadrature(const unsigned int);
  template hp::QCollection<1>       make_face_quadrature<2>(const unsigned int);
  template hp::QCollection<2>       make_face_quadrature<3>(const unsigned int);
  template void check_curved_simplices(const DoFHandler<2> &,
                                       const hp::MappingCollection<2> &);
  template void check_curved_simplices(const DoFHandler<3> &,
                                       const hp::MappingCollection<3> &);
  template void distribute_dofs(const Mesh<2> &,
                                const hp::FECollection<2> &,
                                DoFHandler<2> &);
  template void distribute_dofs(const Mesh<3> &,
                                const hp::FECollection<3> &,
                                DoFHandler<3> &);
} // namespace Contact
