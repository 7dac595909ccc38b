/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/multigrid/matrix_free_system.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/constraint_entries.h"
#include "base/dimension.h"
#include "solvers/direct/negative_curvature.h"

namespace Contact
{
  template<int dim>
  MatrixFreeSystem<dim>::MatrixFreeSystem(
    const Discretization<dim>   &discretization,
    const Elasticity<dim>       &elasticity,
    const ContactInterface<dim> *interface,
    ContactElimination<dim>     &elimination,
    TimerOutput                 &timer)
    : CondensedSystem<dim>(discretization, elasticity, elimination, timer)
    , interface(interface)
  {
  }



  template<int dim>
  std::string
  MatrixFreeSystem<dim>::refusal(const Discretization<dim> &discretization,
                                 const Elasticity<dim>     &elasticity)
  {
    if (discretization.fe.size() > 1)
      return std::string(Dimension<dim>::simplices) + " beside " +
             Dimension<dim>::hypercubes;
    if (discretization.mesh.has_simplices())
      {
        if (Utilities::MPI::n_mpi_processes(discretization.communicator) > 1)
          return std::string(Dimension<dim>::simplices) +
                 " on several processes";
        // Others MatrixFree does not know.
        if (!(discretization.quadrature[0] ==
              QWitherdenVincentSimplex<dim>(discretization.degree)))
          return std::string(Dimension<dim>::simplices) + " of degree 2";
      }
    if (discretization.axisymmetric)
      return "rings";
    // Centres of faces have the values of the formula, here, not of the
    // element.
    const auto &formulas = discretization.boundary.displacement_formula;
    if (dim == 3 && discretization.serendipity &&
        std::any_of(formulas.begin(), formulas.end(), [](const auto &of) {
          return !of.empty();
        }))
      return "a displacement formula on elements without centre nodes";
    if (!elasticity.is_elastic())
      return "a material that is not linear elastic or St. Venant-Kirchhoff's";
    // A slave stiffer than by this: displacements have differed from those of
    // CHOLMOD (1e5: by 8e-5), and pairings have come to rest elsewhere (1e6).
    const double largest_ratio = 1e4;
    double       softest       = std::numeric_limits<double>::max();
    double       stiffest      = 0;
    for (const auto &[name, body] : discretization.mesh.bodies)
      {
        softest  = std::min(softest, elasticity.youngs_modulus(body));
        stiffest = std::max(stiffest, elasticity.youngs_modulus(body));
      }
    if (stiffest > largest_ratio * softest)
      return "bodies more than 10000 times as stiff as others";
    const auto is_on_any_rank = [&](const bool condition) {
      return Utilities::MPI::max(static_cast<unsigned int>(condition),
                                 discretization.communicator) > 0;
    };
    if (!elasticity.is_linear() && elasticity.has_thermal_strain())
      return "thermal strains in large displacement";
    if (is_on_any_rank(!discretization.rigid_boundaries().empty()))
      return "rigid boundaries";
    if (is_on_any_rank(!discretization.tied().empty()))
      return "unknowns that are tied together";
    if (is_on_any_rank(!discretization.normal_supports.lines().empty()))
      return "supports along normals";
    return "";
  }



  template<int dim>
  bool MatrixFreeSystem<dim>::is_too_deep(const Mesh<dim> &mesh)
  {
    const auto &cells = mesh.triangulation;
    return double(cells.n_cells(0)) *
             std::pow(2., double(dim * cells.n_global_levels())) >
           double(std::numeric_limits<types::global_dof_index>::max());
  }



  template<int dim>
  bool
  MatrixFreeSystem<dim>::is_worth_it(const Discretization<dim> &discretization,
                                     const Elasticity<dim>     &elasticity)
  {
    const auto       &mesh  = discretization.mesh.triangulation;
    const std::size_t n     = discretization.dof_handler.n_dofs();
    const std::size_t least = dim == 2
                                ? (elasticity.is_linear() ? 20000 : 100000)
                                : (elasticity.is_linear() ? 5000 : 10000);
    // Of all ranks: each has to choose the same.
    const double coarse_part =
      double(mesh.n_cells(0)) / mesh.n_global_active_cells();
    const bool is_solved_by_each_rank =
      mesh.n_global_levels() == 1 &&
      Utilities::MPI::n_mpi_processes(discretization.communicator) > 1;
    return (n >= least || is_solved_by_each_rank) &&
           !is_too_deep(discretization.mesh) && n * coarse_part < least;
  }



  template<int dim>
  bool
  MatrixFreeSystem<dim>::is_preferred(const Discretization<dim> &discretization,
                                      const Elasticity<dim>     &elasticity)
  {
    // Points do not smooth what has to keep its volume: of nu = 0.49 and 0.499
    // conjugate gradients take 22 and 77 iterations in 2-D, 8 and 31 in 3-D.
    const double largest_ratio = 100;
    const auto  &bodies        = discretization.mesh.bodies;
    return is_worth_it(discretization, elasticity) &&
           std::none_of(bodies.begin(),
                        bodies.end(),
                        [&](const auto &body) {
                          const Material &material =
                            elasticity.material(body.second);
                          return material.lambda > largest_ratio * material.mu;
                        }) &&
           refusal(discretization, elasticity).empty();
  }



  // Springs and thermal strains are beside the operator.
  template<int dim>
  bool MatrixFreeSystem<dim>::subtract_forces(const GhostedVector &u,
                                              GhostedVector       &rhs) const
  {
    if (!bodies || !elasticity.is_linear() || elasticity.has_thermal_strain() ||
        !elasticity.springs.held().empty())
      return false;
    std::copy_n(u.begin(), owned.n_elements(), work.begin());
    Vector forces(work);
    bodies->forces(forces, work);
    for (unsigned int k = 0; k < owned.n_elements(); ++k)
      rhs.begin()[k] -= forces.local_element(k);
    return true;
  }



  // The surfaces, with what hanging nodes hang on.
  template<int dim>
  typename MatrixFreeSystem<dim>::Dofs
  MatrixFreeSystem<dim>::all_of_interface(Dofs &&of_cells) const
  {
    if (interface == nullptr)
      return of_cells;
    const auto add = [&](const Surface<dim> &surface) {
      for (const SurfaceNode<dim> &node : surface.nodes)
        for (const auto dof : node.dofs)
          {
            of_cells.push_back(dof);
            visit_leaders(discretization.constraints,
                          dof,
                          [&](const Dof leader, const double) {
                            of_cells.push_back(leader);
                          });
          }
    };
    for (const auto &contact_pair : interface->pairs)
      {
        add(contact_pair->slave);
        if (contact_pair->master)
          add(*contact_pair->master);
      }
    return of_cells;
  }



  template<int dim>
  void MatrixFreeSystem<dim>::reset()
  {
    if (bodies)
      return;
    std::map<types::material_id, ElasticBody> elastic_bodies;
    for (const auto &body : discretization.mesh.bodies)
      elastic_bodies.emplace(body.second, elasticity.elastic_body(body.second));
    centres =
      std::make_unique<CentreBinding<dim, double>>(discretization,
                                                   discretization.dof_handler,
                                                   discretization.constraints);
    bodies =
      std::make_unique<BodyOperator<dim, double>>(discretization.mapping[0],
                                                  discretization.quadrature[0],
                                                  discretization.dof_handler,
                                                  *centres,
                                                  elastic_bodies);
    bodies->initialize(work);
    multigrid = std::make_unique<ContactMultigrid<dim>>(discretization,
                                                        elastic_bodies,
                                                        interface);
  }



  template<int dim>
  void
  MatrixFreeSystem<dim>::assemble_bulk(const GhostedVector  &solution,
                                       const StressStiffness stress_stiffness)
  {
    AssertThrow(stress_stiffness == StressStiffness::with, ExcInternalError());
    if (elasticity.is_linear())
      return;
    std::copy_n(solution.begin(), owned.n_elements(), work.begin());
    bodies->linearize(work);
    multigrid->linearize(work);
  }



  template<int dim>
  void MatrixFreeSystem<dim>::add_interface(const bool)
  {
    has_terms = this->on_any_rank(!elimination.slip_direction_terms().empty() ||
                                  !elimination.pairing_terms().empty());
    if (has_terms)
      {
        const Dofs dofs = dofs_of_terms();
        IndexSet   used(owned.size());
        used.add_indices(dofs.begin(), dofs.end());
        surface.initialize(used, owned, discretization.communicator);
        surface_forces.initialize(used, owned, discretization.communicator);
      }
    const auto lines_of = [&](const AffineConstraints<double> &constraints) {
      return SurfaceLines<double>(SurfaceRows(elimination.eliminated_dofs(),
                                              constraints,
                                              owned),
                                  owned,
                                  discretization.communicator);
    };
    lines      = lines_of(elimination.constraints());
    test_lines = elimination.is_symmetric()
                   ? lines
                   : lines_of(elimination.test_constraints());
  }



  template<int dim>
  void MatrixFreeSystem<dim>::prepare()
  {
    multigrid->set_lines(elimination.eliminated_dofs(),
                         elimination.constraints(),
                         elimination.test_constraints(),
                         springs());
    indefinite.reset();
  }



  // The turning of shears. Unknowns that hang on others or are supported have
  // no values of their own.
  template<int dim>
  std::vector<SurfaceSpring> MatrixFreeSystem<dim>::springs() const
  {
    std::vector<SurfaceSpring> all;
    std::map<Dof, double>      sum;
    for (const auto &term : elimination.slip_direction_terms())
      if (term.is_own())
        for (const auto &[stiffness, way] : term.springs)
          {
            sum.clear();
            for (unsigned int k = 0; k < way.size(); ++k)
              visit_leaders(discretization.constraints,
                            term.dofs[k],
                            [&, w = way[k]](const Dof    dof,
                                            const double factor) {
                              if (w != 0)
                                sum[dof] += factor * w;
                            });
            all.push_back({stiffness, {sum.begin(), sum.end()}});
          }
    return all;
  }



  // In the unknowns that are solved for.
  template<int dim>
  bool MatrixFreeSystem<dim>::is_indefinite(const bool may_cost)
  {
    if (!knows_definiteness() || (!indefinite && !may_cost))
      return false;
    if (!indefinite)
      {
        TimerOutput::Scope scope(timer, "stability");
        Vector             r(work);
        fill_at_random(r.begin(),
                       r.begin() + owned.n_elements(),
                       Utilities::MPI::this_mpi_process(
                         discretization.communicator));
        const auto &base  = discretization.constraints;
        const auto &lines = elimination.test_constraints();
        for (const auto i : owned)
          if (base.is_constrained(i) || lines.is_constrained(i))
            r(i) = 0;
        Vector diagonal = bodies->diagonal();
        for (auto &value : diagonal)
          value = std::abs(value);
        indefinite = has_negative_curvature(*this, *multigrid, diagonal, r);
      }
    return *indefinite;
  }



  template<int dim>
  void MatrixFreeSystem<dim>::vmult(Vector &dst, const Vector &src) const
  {
    work = src;
    lines.expand(work);
    bodies->vmult(dst, work);
    add_terms(dst);
    test_lines.condense(dst);
  }



  // Those of the terms of this rank, or what they hang on.
  template<int dim>
  typename MatrixFreeSystem<dim>::Dofs
  MatrixFreeSystem<dim>::dofs_of_terms() const
  {
    Dofs       dofs;
    const auto add = [&](const Dofs &of_term) {
      for (const auto dof : of_term)
        visit_leaders(discretization.constraints,
                      dof,
                      [&](const Dof leader, const double) {
                        dofs.push_back(leader);
                      });
    };
    for (const auto &term : elimination.slip_direction_terms())
      add(term.dofs);
    for (const auto &term : elimination.pairing_terms())
      {
        add(term.rows);
        add(term.columns);
      }
    sort_unique(dofs);
    return dofs;
  }



  // What the turning of shears and of the pairing adds. Unknowns that hang on
  // others or are supported have no values of their own.
  template<int dim>
  void MatrixFreeSystem<dim>::add_terms(Vector &dst) const
  {
    if (!has_terms)
      return;
    const auto            &base = discretization.constraints;
    dealii::Vector<double> u, force;
    const auto             multiply =
      [&](const auto &stiffness, const Dofs &rows, const Dofs &columns) {
        u.reinit(columns.size());
        force.reinit(rows.size());
        for (unsigned int j = 0; j < columns.size(); ++j)
          visit_leaders(base,
                        columns[j],
                        [&](const Dof dof, const double factor) {
                          u[j] += factor * surface(work, dof);
                        });
        stiffness.vmult(force, u);
        for (unsigned int i = 0; i < rows.size(); ++i)
          visit_leaders(base, rows[i], [&](const Dof dof, const double factor) {
            surface_forces.add(dst, dof, factor * force[i]);
          });
      };
    surface.read(work);
    surface_forces.clear();
    for (const auto &term : elimination.slip_direction_terms())
      if (term.is_own())
        multiply(term.stiffness, term.dofs, term.dofs);
    for (const auto &term : elimination.pairing_terms())
      multiply(term, term.rows, term.columns);
    surface_forces.add_to(dst);
  }



  template<int dim>
  unsigned int MatrixFreeSystem<dim>::solve_reduced(const GhostedVector &rhs,
                                                    const double   tolerance,
                                                    GhostedVector &x)
  {
    ++discretization.counters.linear_solves;
    Vector             b(work), of_rank(work);
    const unsigned int n = owned.n_elements();
    std::copy_n(rhs.begin(), n, b.begin());
    of_rank = 0;
    SolverControl control(max_iterations, tolerance);
    try
      {
        if (elimination.is_symmetric())
          SolverCG<Vector>(control).solve(*this, of_rank, b, *multigrid);
        else
          SolverGMRES<Vector>(control,
                              typename SolverGMRES<Vector>::AdditionalData(
                                /*max_n_tmp_vectors=*/52,
                                /*right_preconditioning=*/true))
            .solve(*this, of_rank, b, *multigrid);
      }
    catch (const SolverControl::NoConvergence &)
      {
        std::ostringstream residual;
        residual << control.last_value();
        throw SolverStalls("geometric multigrid stalls at the residual " +
                           residual.str() + " N/mm (rings: N) after " +
                           std::to_string(max_iterations) + " iterations");
      }
    // deal.II keeps the vectors of a solver for the next one.
    GrowingVectorMemory<Vector>::release_unused_memory();
    std::copy_n(of_rank.begin(), n, x.begin());
    return control.last_step();
  }

  template class MatrixFreeSystem<2>;
  template class MatrixFreeSystem<3>;
} // namespace Contact
