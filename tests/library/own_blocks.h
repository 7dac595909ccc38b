/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef own_blocks_h
#define own_blocks_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

// The parts of a program without contact: the mesh of two blocks, their
// unknowns and supports, and an elasticity (small strain).

using namespace dealii;

const types::boundary_id base = 1, ground = 2, sole = 3, head = 4;
const types::material_id lower = 0, upper = 1;

template<int dim>
void make_mesh(Triangulation<dim> &mesh)
{
  const auto block = [](Triangulation<dim> &triangulation,
                        const double        width,
                        const double        bottom,
                        const double        top,
                        const unsigned int  n_along,
                        const unsigned int  n_across) {
    Point<dim>                from, to;
    std::vector<unsigned int> n(dim, n_along);
    for (unsigned int d = 0; d < dim; ++d)
      from[d] = -width / 2, to[d] = width / 2;
    from[dim - 1] = bottom, to[dim - 1] = top, n[dim - 1] = n_across;
    GridGenerator::subdivided_hyper_rectangle(triangulation, n, from, to);
  };
  const double       gap = 0.001; // no node is of both
  Triangulation<dim> below, above;
  block(below, 4, -2, 0, 8, 4);
  block(above, 2, gap, 1 + gap, 5, 3);
  GridGenerator::merge_triangulations(below, above, mesh, gap / 1000);

  const std::map<types::boundary_id, double> heights = {{base, -2},
                                                        {ground, 0},
                                                        {sole, gap},
                                                        {head, 1 + gap}};
  for (const auto &cell : mesh.active_cell_iterators())
    {
      cell->set_material_id(cell->center()[dim - 1] < 0 ? lower : upper);
      for (const auto &face : cell->face_iterators())
        for (const auto &[id, height] : heights)
          if (face->at_boundary() &&
              std::abs(face->center()[dim - 1] - height) < gap / 1000)
            face->set_boundary_id(id);
    }
}

template<int dim>
struct OwnBlocks
{
  Triangulation<dim>                         mesh;
  const FESystem<dim>                        fe;
  DoFHandler<dim>                            dof_handler;
  std::map<types::global_dof_index, double>  prescribed;
  AffineConstraints<double>                  constraints; // of an update
  const std::map<types::material_id, double> moduli = {{lower, 70000},
                                                       {upper, 210000}};

  OwnBlocks()
    : fe(FE_Q<dim>(1), dim)
  {
    make_mesh(mesh);
    dof_handler.reinit(mesh);
    dof_handler.distribute_dofs(fe);
    std::vector<double> way(dim, 0.);
    way[0] = 0.02, way[dim - 1] = -0.05;
    VectorTools::interpolate_boundary_values(dof_handler,
                                             base,
                                             Functions::ZeroFunction<dim>(dim),
                                             prescribed);
    VectorTools::interpolate_boundary_values(dof_handler,
                                             head,
                                             Functions::ConstantFunction<dim>(
                                               way),
                                             prescribed);
    for (const auto &[dof, value] : prescribed)
      constraints.add_line(dof);
    constraints.close();
  }

  // Cell by cell: add(tangent, minus the residual, unknowns).
  template<class Vector, class Add>
  void assemble(const Vector &u, const Add &add) const
  {
    FEValues<dim>                        fe_values(fe,
                            QGauss<dim>(fe.degree + 1),
                            update_gradients | update_JxW_values);
    const unsigned int                   n = fe.n_dofs_per_cell();
    FullMatrix<double>                   K(n, n);
    dealii::Vector<double>               f(n), u_cell(n);
    std::vector<types::global_dof_index> dofs(n);
    const FEValuesExtractors::Vector     displacement(0);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const double E = moduli.at(cell->material_id()), nu = 0.3;
        const double mu     = E / (2 * (1 + nu));
        const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
        fe_values.reinit(cell);
        cell->get_dof_indices(dofs);
        const auto &v = fe_values[displacement];
        K             = 0;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              K(i, j) += (lambda * v.divergence(i, q) * v.divergence(j, q) +
                          2 * mu * v.symmetric_gradient(i, q) *
                            v.symmetric_gradient(j, q)) *
                         fe_values.JxW(q);
        for (unsigned int i = 0; i < n; ++i)
          u_cell[i] = -u[dofs[i]];
        K.vmult(f, u_cell);
        add(K, f, dofs);
      }
  }
};

#endif
