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



    /// One point, or 3 in triangles and 8 in tetrahedra. The choice of the
    /// first corner does not matter to them, as it does to those of
    /// QGaussSimplex(2). MatrixFree knows those of 8 points, and none of 4.
    template<int dim>
    Quadrature<dim> simplex_rule(const unsigned int degree)
    {
      if constexpr (dim == 2)
        if (degree == 2)
          return {{{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}},
                  {1. / 6, 1. / 6, 1. / 6}};
      return QWitherdenVincentSimplex<dim>(degree);
    }
  } // namespace



  template<int dim>
  hp::MappingCollection<dim> make_mapping(const Mesh<dim>   &mesh,
                                          const unsigned int degree)
  {
    hp::MappingCollection<dim> mapping;
    if (mesh.has_hypercubes())
      mapping.push_back(MappingQ<dim>(degree));
    if (mesh.has_simplices())
      mapping.push_back(SimplexMapping<dim>(degree));
    return mapping;
  }

  template<int dim>
  hp::FECollection<dim> make_fe(const Mesh<dim>   &mesh,
                                const unsigned int degree)
  {
    hp::FECollection<dim> fe;
    if (mesh.has_hypercubes())
      fe.push_back(FESystem<dim>(FE_Q<dim>(degree), dim));
    if (mesh.has_simplices())
      fe.push_back(FESystem<dim>(FE_SimplexP<dim>(degree), dim));
    return fe;
  }

  template<int dim>
  hp::QCollection<dim> make_quadrature(const Mesh<dim>   &mesh,
                                       const unsigned int degree)
  {
    hp::QCollection<dim> quadrature;
    if (mesh.has_hypercubes())
      quadrature.push_back(QGauss<dim>(degree + 1));
    if (mesh.has_simplices())
      quadrature.push_back(simplex_rule<dim>(degree));
    return quadrature;
  }

  template<int dim>
  hp::QCollection<dim - 1> make_face_quadrature(const Mesh<dim>   &mesh,
                                                const unsigned int degree)
  {
    hp::QCollection<dim - 1> quadrature;
    if (mesh.has_hypercubes())
      quadrature.push_back(QGauss<dim - 1>(degree + 1));
    if (mesh.has_simplices()) // on lines those of Gauss
      quadrature.push_back(QWitherdenVincentSimplex<dim - 1>(degree + 1));
    return quadrature;
  }



  template<int dim>
  void distribute_dofs(const hp::FECollection<dim> &fe,
                       DoFHandler<dim>             &dof_handler)
  {
    if (fe.size() == 1)
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
    FEValues<dim>          fe_values(mapping[mapping.size() - 1],
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



#define INSTANTIATE(dim)                                                        \
  template hp::MappingCollection<dim> make_mapping(const Mesh<dim> &,           \
                                                   const unsigned int);         \
  template hp::FECollection<dim>      make_fe(const Mesh<dim> &,                \
                                              const unsigned int);              \
  template hp::QCollection<dim>       make_quadrature(const Mesh<dim> &,        \
                                                      const unsigned int);      \
  template hp::QCollection<dim - 1>   make_face_quadrature(const Mesh<dim> &,   \
                                                           const unsigned int); \
  template void check_curved_simplices(const DoFHandler<dim> &,                 \
                                       const hp::MappingCollection<dim> &);     \
  template void distribute_dofs(const hp::FECollection<dim> &,                  \
                                DoFHandler<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
