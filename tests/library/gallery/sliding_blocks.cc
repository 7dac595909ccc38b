/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// @sect3{Include files}

// All but the last two are deal.II's, and those of step-8.
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>

// The library of contact: the equations of the points of contact, and the
// bodies as contact sees them.
#include "bodies/given_bodies.h"
#include "contact/interface/contact_kernel.h"

namespace SlidingBlocks
{
  using namespace dealii;
  using Contact::GhostedVector; // on one process, a vector of all unknowns

  // @sect3{The problem}

  // Lengths are in mm, moduli in MPa. The blocks have a gap between them, so
  // that no node belongs to both: how they touch is the library's business, not
  // that of the mesh.
  struct Problem
  {
    const types::material_id                   lower = 0, upper = 1;
    const double                               gap           = 0.001;
    const double                               poisson       = 0.3;
    const double                               friction      = 0.3;
    const double                               way_down      = 0.05;
    const double                               way_along     = 0.02;
    const unsigned int                         n_increments  = 4;
    const std::map<types::material_id, double> youngs_moduli = {{0, 70000.},
                                                                {1, 210000.}};
  };

  // @sect3{The class}

  // As in step-8, and behind it three members of contact: the bodies, the
  // contact pairs with their points, and the number of unknowns with their
  // multipliers.
  template<int dim>
  class SlidingBlocks
  {
  public:
    SlidingBlocks();
    void run();

  private:
    void           make_mesh();
    void           find_supports();
    void           make_contact();
    void           make_pattern();
    void           move_head(const double time);
    void           assemble_bodies();
    void           solve_increment(const unsigned int increment);
    void           make_step();
    Tensor<1, dim> force_of_contact() const;
    void           write(const unsigned int increment) const;

    const Problem       problem;
    Triangulation<dim>  triangulation;
    const FESystem<dim> fe;
    const MappingQ<dim> mapping;
    DoFHandler<dim>     dof_handler;

    // From below to above: of the lower block, then of the upper one.
    const types::boundary_id base = 1, ground = 2, sole = 3, head = 4;

    // Newton's method moves supported unknowns by nothing: they are where they
    // have to be from the start of an increment on.
    AffineConstraints<double>         constraints;
    std::set<types::global_dof_index> unknowns_of_head;

    std::unique_ptr<Contact::GivenBodies<dim>>      bodies;
    std::unique_ptr<Contact::ContactInterface<dim>> contact;
    unsigned int                                    n_unknowns = 0;

    // Displacements, then the multipliers; @p start is that of the increment,
    // which the slip is counted from.
    GhostedVector        solution, start, rhs;
    SparsityPattern      sparsity_pattern;
    SparseMatrix<double> matrix;
  };



  template<int dim>
  SlidingBlocks<dim>::SlidingBlocks()
    : fe(FE_Q<dim>(1), dim)
    , mapping(1)
    , dof_handler(triangulation)
  {
  }

  // @sect3{Mesh and supports}

  // Two blocks with their own meshes, which do not match, in one triangulation.
  // Bodies are material ids.
  template<int dim>
  void SlidingBlocks<dim>::make_mesh()
  {
    const auto block = [](Triangulation<dim> &mesh,
                          const double        width,
                          const double        bottom,
                          const double        height,
                          const unsigned int  n_along,
                          const unsigned int  n_across) {
      Point<dim>                from, to;
      std::vector<unsigned int> n(dim, n_along);
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          from[d] = -width / 2;
          to[d]   = width / 2;
        }
      from[dim - 1] = bottom;
      to[dim - 1]   = bottom + height;
      n[dim - 1]    = n_across;
      GridGenerator::subdivided_hyper_rectangle(mesh, n, from, to);
    };

    Triangulation<dim> lower, upper;
    block(lower, 4, -2, 2, 8, 4);
    block(upper, 2, problem.gap, 1, 5, 3);
    const double one_vertex = 1e-3 * problem.gap; // vertices as close are one
    GridGenerator::merge_triangulations(lower,
                                        upper,
                                        triangulation,
                                        one_vertex);

    const std::map<types::boundary_id, double> heights =
      {{base, -2}, {ground, 0}, {sole, problem.gap}, {head, problem.gap + 1}};
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->set_material_id(cell->center()[dim - 1] < 0 ? problem.lower
                                                          : problem.upper);
        for (const auto &face : cell->face_iterators())
          for (const auto &[id, height] : heights)
            if (face->at_boundary() &&
                std::abs(face->center()[dim - 1] - height) < one_vertex)
              face->set_boundary_id(id);
      }
    dof_handler.distribute_dofs(fe);
  }



  // The base rests, the head of the upper block will be moved.
  template<int dim>
  void SlidingBlocks<dim>::find_supports()
  {
    for (const types::boundary_id id : {base, head})
      {
        std::map<types::global_dof_index, double> held;
        VectorTools::interpolate_boundary_values(mapping,
                                                 dof_handler,
                                                 id,
                                                 Functions::ZeroFunction<dim>(
                                                   dim),
                                                 held);
        for (const auto &[dof, value] : held)
          {
            constraints.add_line(dof);
            if (id == head)
              unknowns_of_head.insert(dof);
          }
      }
    constraints.close();
  }

  // @sect3{Contact}

  // The library needs what is at the boundary: unknowns, places, supports, and
  // a stiffness of each body to scale gaps with. A contact pair names two
  // boundaries. The slave, whose nodes carry multipliers, is the one with the
  // finer mesh or, if they are alike, the smaller one. The points of contact,
  // one for each slave node, are paired with the master as both are now.
  template<int dim>
  void SlidingBlocks<dim>::make_contact()
  {
    bodies = std::make_unique<Contact::GivenBodies<dim>>(
      mapping,
      dof_handler,
      constraints,
      typename Contact::GivenBodies<dim>::Boundaries{{"Sole", {sole}},
                                                     {"Ground", {ground}}},
      problem.youngs_moduli);
    Contact::Parameters::Contact pair;
    pair.slave                  = "Sole";
    pair.master                 = "Ground";
    pair.friction_coefficient   = problem.friction;
    pair.augmentation_parameter = 1; // of stiffness by size
    contact = std::make_unique<Contact::ContactInterface<dim>>(
      *bodies,
      *bodies,
      std::vector<Contact::Parameters::Contact>{pair});

    n_unknowns = dof_handler.n_dofs() + contact->n_multipliers();
    solution   = GhostedVector(n_unknowns);
    start = rhs = solution;
    contact->pair(solution);
    contact->active_set.initialize(solution);
  }



  // Couplings of the cells, and of the points with their nodes and multipliers.
  // The diagonal is there for open points, whose multiplier is set to zero by
  // an equation of its own.
  template<int dim>
  void SlidingBlocks<dim>::make_pattern()
  {
    DynamicSparsityPattern               couplings(n_unknowns, n_unknowns);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        constraints.add_entries_local_to_global(dofs, couplings);
      }
    contact->add_couplings(couplings);
    for (unsigned int i = 0; i < n_unknowns; ++i)
      couplings.add(i, i);
    sparsity_pattern.copy_from(couplings);
    matrix.reinit(sparsity_pattern);
  }

  // @sect3{Loads and elasticity}

  // In the first half of the time down, then along.
  template<int dim>
  void SlidingBlocks<dim>::move_head(const double time)
  {
    Tensor<1, dim> way;
    way[dim - 1] = -problem.way_down * std::min(1., 2 * time);
    way[0]       = problem.way_along * std::max(0., 2 * time - 1);

    for (unsigned int d = 0; d < dim; ++d)
      {
        ComponentMask component(dim, false);
        component.set(d, true);
        const IndexSet along = DoFTools::extract_dofs(dof_handler, component);
        for (const auto dof : unknowns_of_head)
          if (along.is_element(dof))
            solution[dof] = way[d];
      }
  }



  // Minus the residual and its derivative, as in step-8.
  template<int dim>
  void SlidingBlocks<dim>::assemble_bodies()
  {
    FEValues<dim>                        fe_values(mapping,
                            fe,
                            QGauss<dim>(fe.degree + 1),
                            update_gradients | update_JxW_values);
    const unsigned int                   n = fe.n_dofs_per_cell();
    FullMatrix<double>                   cell_matrix(n, n);
    Vector<double>                       cell_rhs(n), displacement(n);
    std::vector<types::global_dof_index> dofs(n);
    const FEValuesExtractors::Vector     u(0);

    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const double E      = problem.youngs_moduli.at(cell->material_id());
        const double nu     = problem.poisson;
        const double mu     = E / (2 * (1 + nu));
        const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));

        fe_values.reinit(cell);
        cell->get_dof_indices(dofs);
        cell_matrix = 0;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              cell_matrix(i, j) +=
                (lambda * fe_values[u].divergence(i, q) *
                   fe_values[u].divergence(j, q) +
                 2 * mu * fe_values[u].symmetric_gradient(i, q) *
                   fe_values[u].symmetric_gradient(j, q)) *
                fe_values.JxW(q);
        for (unsigned int i = 0; i < n; ++i)
          displacement[i] = -solution[dofs[i]];
        cell_matrix.vmult(cell_rhs, displacement);
        constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
        constraints.distribute_local_to_global(cell_rhs, dofs, rhs);
      }
  }

  // @sect3{Newton's method}

  // The equations of contact are piecewise smooth: which piece holds at a point
  // is its status (open, sticking, slipping). Each step first updates them by
  // the multipliers, gaps and slips it finds, then solves the equations that
  // are smooth under these statuses. If none changes and the residual vanishes,
  // the conditions of contact hold. The first step takes the statuses of the
  // increment before, since it knows no better.
  template<int dim>
  void SlidingBlocks<dim>::solve_increment(const unsigned int increment)
  {
    const unsigned int max_steps = 30;
    const double       tolerance = 1e-8; // [N per mm, in 3-D N]

    start = solution;
    contact->begin_increment((increment - 1.) / problem.n_increments, start);
    move_head(double(increment) / problem.n_increments);
    for (unsigned int step = 0; step <= max_steps; ++step)
      {
        const unsigned int n_changes =
          contact->active_set.update(solution, start, /*keep=*/step > 0);
        matrix = 0;
        rhs    = 0;
        assemble_bodies();
        Contact::ContactKernel<dim>(*contact)
          .assemble(solution, start, {/*moving_geometry=*/false}, rhs, &matrix);
        for (const auto &line : constraints.get_lines())
          {
            matrix.diag_element(line.index) = 1;
            rhs[line.index]                 = 0;
          }
        std::cout << "  step " << step << ": residual " << std::scientific
                  << std::setprecision(2) << rhs.linfty_norm() << ", "
                  << n_changes << " points change" << std::endl;
        if (step > 0 && n_changes == 0 && rhs.linfty_norm() < tolerance)
          return;
        make_step();
      }
    AssertThrow(false, ExcMessage("Newton's method did not converge."));
  }



  // The matrix is that of a saddle point, and with friction unsymmetric.
  template<int dim>
  void SlidingBlocks<dim>::make_step()
  {
    Vector<double> update(n_unknowns);
    std::copy(rhs.begin(), rhs.end(), update.begin());
    SparseDirectUMFPACK solver;
    solver.solve(matrix, update);
    for (unsigned int i = 0; i < n_unknowns; ++i)
      solution[i] += update[i];
  }

  // @sect3{Results}

  // The force of the lower block on the upper one: pressure along the normal,
  // shear along the tangents, each times the length (area) of its point.
  template<int dim>
  Tensor<1, dim> SlidingBlocks<dim>::force_of_contact() const
  {
    Tensor<1, dim> force;
    for (const auto &point : contact->points())
      {
        const auto t =
          contact->active_set.traction(point,
                                       contact->state(point, solution, start));
        force += point.weight * t.p * point.normal;
        for (unsigned int k = 0; k < dim - 1; ++k)
          force += point.weight * t.q[k] * point.tangents[k];
      }
    return force;
  }



  template<int dim>
  void SlidingBlocks<dim>::write(const unsigned int increment) const
  {
    Vector<double> displacement(dof_handler.n_dofs());
    std::copy_n(solution.begin(), displacement.size(), displacement.begin());
    const std::vector<DataComponentInterpretation::DataComponentInterpretation>
      vector(dim, DataComponentInterpretation::component_is_part_of_vector);
    DataOut<dim> data_out;
    data_out.attach_dof_handler(dof_handler);
    data_out.add_data_vector(displacement,
                             std::vector<std::string>(dim, "displacement"),
                             DataOut<dim>::type_dof_data,
                             vector);
    data_out.build_patches();
    std::ofstream file("solution-" + std::to_string(dim) + "d-" +
                       std::to_string(increment) + ".vtu");
    data_out.write_vtu(file);
  }



  template<int dim>
  void SlidingBlocks<dim>::run()
  {
    make_mesh();
    find_supports();
    make_contact();
    make_pattern();
    std::cout << dof_handler.n_dofs() << " displacements, "
              << contact->n_multipliers() << " multipliers" << std::endl;
    for (unsigned int i = 1; i <= problem.n_increments; ++i)
      {
        std::cout << "increment " << i << std::endl;
        solve_increment(i);
        const auto count = contact->active_set.count();
        std::cout << "  " << count.stick << " points stick, "
                  << count.active - count.stick << " slip; force "
                  << std::defaultfloat << std::setprecision(10)
                  << force_of_contact() << std::endl;
        write(i);
      }
  }
} // namespace SlidingBlocks

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc > 1 && std::string(argv[1]) == "3")
    SlidingBlocks::SlidingBlocks<3>().run();
  else
    SlidingBlocks::SlidingBlocks<2>().run();
}
