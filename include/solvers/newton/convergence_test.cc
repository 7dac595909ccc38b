/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/convergence_test.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Contact
{
  template<int dim>
  void ConvergenceTest<dim>::begin_level(const double tolerance)
  {
    newton_tolerance = tolerance;
    modulus = coordinate = overlap = so_far = 0;
    supported_cells.reset();
    measure_bodies();
  }



  template<int dim>
  void ConvergenceTest<dim>::measure_bodies()
  {
    const auto &discretization = *model.discretization;
    const auto &elasticity     = *model.elasticity;
    softest                    = std::numeric_limits<double>::max();
    for (const auto &[name, body] : discretization.mesh.bodies)
      {
        softest = std::min(softest, elasticity.youngs_modulus(body));
        const Material &material = elasticity.material(body);
        modulus = std::max(modulus, material.lambda + 2 * material.mu);
      }

    // Size and coordinates of the coarse mesh, which every rank has.
    Point<dim> low, high;
    double     smallest = std::numeric_limits<double>::max(), circumference = 0;
    bool       is_first = true;
    for (const auto &cell :
         discretization.mesh.triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int i = 0; i < dim; ++i)
          {
            const Point<dim> X = cell->vertex(v);
            low[i]             = is_first ? X[i] : std::min(low[i], X[i]);
            high[i]            = is_first ? X[i] : std::max(high[i], X[i]);
            coordinate         = std::max(coordinate, std::abs(X[i]));
            circumference =
              std::max(circumference, discretization.circumference(X));
            is_first = is_first && i == 0;
          }
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        smallest = std::min(smallest, cell->minimum_vertex_distance());
    smallest =
      Utilities::MPI::min(smallest, model.discretization->communicator);
    middle             = low + 0.5 * (high - low);
    size               = low.distance(high);
    slender            = std::max(1., size / smallest);
    const double depth = dim == 2 ? circumference : size;
    modulus *= depth;
    softest *= depth;

    if (model.interface)
      {
        const GhostedVector undeformed(discretization.distribution);
        for (const ContactPoint<dim> &point : model.interface->points())
          if (point.facing && !model.interface->contact_pair(point).tied)
            overlap = std::max(
              overlap,
              -model.interface->state(point, undeformed, undeformed).gap);
      }
  }



  // The multipliers, which all have, count once.
  template<int dim>
  double ConvergenceTest<dim>::norm_of(const GhostedVector &rhs) const
  {
    const MPI_Comm communicator = model.discretization->communicator;
    const auto     n = model.discretization->distribution->locally_owned_size();
    double         square =
      model.interface && Utilities::MPI::this_mpi_process(communicator) == 0
                ? std::pow(model.interface->constraint_norm(rhs), 2)
                : 0.;
    for (const double *r = rhs.begin(); r != rhs.begin() + n; ++r)
      square += *r * *r;
    return std::sqrt(Utilities::MPI::sum(square, communicator));
  }



  template<int dim>
  double ConvergenceTest<dim>::evaluate(const GhostedVector       &rhs,
                                        const IncrementState<dim> &state)
  {
    norm  = norm_of(rhs);
    force = scale(state);
    return norm;
  }



  template<int dim>
  double ConvergenceTest<dim>::scale(const IncrementState<dim> &state) const
  {
    const auto  &discretization = *model.discretization;
    const double way            = discretization.largest_prescribed();
    const double most = modulus * (way + way_of_contact() + overlap) * slender;
    double       acting =
      model.interface ? contact_forces(state.solution, state.start) : 0.;
    if (way > 0)
      acting = std::max(acting, reactions(state.solution, state.load_factor));

    const double dead = dead_forces(state.load_factor);
    const double round_off =
      std::numeric_limits<double>::epsilon() * modulus * (coordinate + way) *
      std::sqrt(static_cast<double>(discretization.dof_handler.n_dofs()));
    return Utilities::MPI::max(std::max({dead,
                                         std::min(acting, dead + most),
                                         so_far,
                                         round_off / newton_tolerance}),
                               model.discretization->communicator);
  }



  template<int dim>
  double ConvergenceTest<dim>::dead_forces(const double load_factor) const
  {
    double dead = model.elasticity->dead_loads.magnitude(load_factor) +
                  model.elasticity->thermal_forces();
    if (model.interface)
      for (const FreeMotion *motion : model.interface->motions.free)
        if (!motion->stays)
          dead += std::abs(motion->force) / motion->lever;
    return dead;
  }



  template<int dim>
  double ConvergenceTest<dim>::given_force(const double load_factor) const
  {
    const double way =
      model.discretization->largest_prescribed() + way_of_contact();
    return Utilities::MPI::max(way > 0
                                 ? dead_forces(load_factor) + softest * way
                                 : 0.,
                               model.discretization->communicator);
  }



  template<int dim>
  double ConvergenceTest<dim>::way_of_contact() const
  {
    double way = 0;
    if (model.interface)
      for (const auto &contact_pair : model.interface->pairs)
        {
          way = std::max(way, std::abs(contact_pair->interference->now));
          if (const auto *obstacle = contact_pair->obstacle.get())
            way = std::max(way,
                           obstacle->given_way(
                             obstacle->centre().distance(middle) + size / 2));
        }
    return way;
  }



  template<int dim>
  double
  ConvergenceTest<dim>::contact_forces(const GhostedVector &solution,
                                       const GhostedVector &u_start) const
  {
    double sum = 0;
    for (const ContactPoint<dim> &point : model.interface->points())
      if (point.status.kind != Status::open)
        {
          const ContactState<dim> now =
            model.interface->state(point, solution, u_start);
          const Traction<dim> t =
            model.interface->active_set.traction(point, now);
          sum += point.weight * std::hypot(t.p, t.q.norm());
        }
    return sum;
  }



  template<int dim>
  double ConvergenceTest<dim>::reactions(const GhostedVector &solution,
                                         const double         load_factor) const
  {
    const GhostedVector forces =
      model.elasticity->forces(solution, load_factor, &cells_at_supports());
    double sum = 0;
    for (const auto dof :
         model.discretization->dof_handler.locally_owned_dofs())
      if (is_supported(dof))
        sum += std::abs(forces[dof]);
    return Utilities::MPI::sum(sum, model.discretization->communicator);
  }



  template<int dim>
  bool
  ConvergenceTest<dim>::is_supported(const types::global_dof_index dof) const
  {
    return model.discretization->is_fixed(dof) ||
           model.discretization->is_rigid(dof) ||
           model.discretization->normal_supports.line(dof) != nullptr;
  }



  // A cell may be at a support of another rank, whose owner tells.
  template<int dim>
  const std::vector<unsigned int> &
  ConvergenceTest<dim>::cells_at_supports() const
  {
    if (!supported_cells)
      {
        GhostedVector supported(model.discretization->distribution);
        for (const auto dof :
             model.discretization->dof_handler.locally_owned_dofs())
          supported[dof] = is_supported(dof);
        supported.update_ghosts();
        supported_cells = model.elasticity->cells_at(supported);
      }
    return *supported_cells;
  }

  template class ConvergenceTest<2>;
  template class ConvergenceTest<3>;
} // namespace Contact
