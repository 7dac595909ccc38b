/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/discretization.h"

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <boost/serialization/map.hpp>

#include "base/all_ranks.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "parameters/formula.h"
#include "solid/followers.h"

namespace Contact
{
  namespace
  {
    /// The faces of all contact pairs.
    template<int dim>
    std::set<types::boundary_id>
    faces_of_pairs(const Mesh<dim> &mesh, const Parameters::All &parameters)
    {
      std::set<types::boundary_id> faces;
      for (const Parameters::Contact &pair : parameters.pairs())
        for (const std::string &group : {pair.slave, pair.master})
          if (const auto found = mesh.boundaries.find(group);
              found != mesh.boundaries.end())
            faces.insert(found->second.begin(), found->second.end());
      return faces;
    }
  } // namespace



  template<int dim>
  Discretization<dim>::Discretization(const Mesh<dim>       &mesh,
                                      const Parameters::All &parameters,
                                      const MPI_Comm         communicator)
    : mesh(mesh)
    , communicator(communicator)
    , degree(parameters.element.degree)
    , serendipity(degree == 2 && parameters.element.centre_node ==
                                   Parameters::CentreNode::serendipity)
    , axisymmetric(parameters.solids.symmetry ==
                   Parameters::Symmetry::axisymmetric)
    , free_centres(faces_of_pairs(mesh, parameters))
    , mapping(make_mapping<dim>(degree))
    , fe(make_fe<dim>(degree))
    , quadrature(make_quadrature<dim>(degree))
    , dof_handler(mesh.triangulation)
    , boundary(parameters.boundary)
  {
    if (const std::string entry = boundary.entry_in_z();
        dim == 2 && !entry.empty())
      throw InputError("the mesh is plane and has no direction z",
                       "Boundary conditions/" + entry,
                       "remove the entry, or take a mesh of volumes");
    if (dim == 3 && axisymmetric)
      throw InputError("a mesh of volumes is no section of rings",
                       "Solids/Symmetry",
                       "remove the entry, or mesh the section");

    // Their values at once, not in the middle of a long run.
    const unsigned int n = parameters.solution.n_increments;
    for (const auto &[entry, formula] : boundary.histories)
      {
        histories[entry] =
          parse_history(formula, "Boundary conditions/Histories");
        for (unsigned int i = 1; i <= n; ++i)
          factor(entry, i / double(n));
      }
    if (axisymmetric)
      check_radii();
    redistribute();
  }



  // On the coarse mesh, which every rank has.
  template<int dim>
  void Discretization<dim>::check_radii()
  {
    double largest = 0;
    for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        largest = std::max(largest, cell->vertex(v)[0]);
    axis_tolerance = 1e-10 * largest;

    for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        if (const Point<dim> X = cell->vertex(v); X[0] < -axis_tolerance)
          throw InputError("with axisymmetry x is the radius, but the node at "
                           "(" +
                             brief(X[0]) + ", " + brief(X[1]) +
                             ") mm has a negative one",
                           "Solids/Symmetry",
                           "mesh the half x >= 0 of the section, move it there "
                           "with Mesh/Shift, or set 'Symmetry = plane strain'");
  }



  template<int dim>
  void Discretization<dim>::redistribute()
  {
    distribute_dofs(mesh, fe, dof_handler);

    prescribed.clear();
    ties.clear();
    updates_vanish = true;
    collect_vertex_dofs();
    gather_named_points();
    collect_supports();
    collect_ties();
    make_constraints({});
  }



  template<int dim>
  std::array<double, dim>
  Discretization<dim>::support_factors(const double load_factor) const
  {
    std::array<double, dim> factors;
    for (unsigned int c = 0; c < dim; ++c)
      factors[c] = factor(std::string("Displacement ") + "xyz"[c], load_factor);
    return factors;
  }



  template<int dim>
  void Discretization<dim>::constrain_update(const Vector<double> &u,
                                             const double          load_factor)
  {
    std::map<types::global_dof_index, double> updates;
    bool                                      vanish = true;
    const auto factors   = support_factors(load_factor);
    largest_displacement = 0;
    for (const auto &[dof, displacement] : prescribed)
      {
        const double value =
          factors[displacement.component] * displacement.value;
        largest_displacement = std::max(largest_displacement, std::abs(value));
        updates[dof]         = value - u[dof];
        vanish               = vanish && updates[dof] == 0;
      }

    if (!(vanish && updates_vanish))
      make_constraints(updates);
    updates_vanish = vanish;
  }



  template<int dim>
  void Discretization<dim>::prescribe(Vector<double> &u,
                                      const double    load_factor)
  {
    constrain_update(u, load_factor);
    if (updates_vanish)
      return;
    Vector<double> move(u.size());
    constraints.distribute(move);
    gather(move);
    u += move;

    // To the last digit.
    const auto factors = support_factors(load_factor);
    for (const auto &[dof, displacement] : prescribed)
      u[dof] = factors[displacement.component] * displacement.value;
    constrain_update(u, load_factor);
  }



  template<int dim>
  Vector<double>
  Discretization<dim>::support_motion(const Vector<double> &u,
                                      const double          load_factor) const
  {
    const auto     factors = support_factors(load_factor);
    Vector<double> motion(dof_handler.n_dofs());
    for (const auto &[dof, displacement] : prescribed)
      motion[dof] =
        factors[displacement.component] * displacement.value - u[dof];
    return motion;
  }



  template<int dim>
  double
  Discretization<dim>::distance_from_supports(const Vector<double> &u,
                                              const double load_factor) const
  {
    const auto factors = support_factors(load_factor);
    double     largest = 0;
    for (const auto &[dof, displacement] : prescribed)
      largest = std::max(largest,
                         std::abs(u[dof] - factors[displacement.component] *
                                             displacement.value));
    return largest;
  }



  template<int dim>
  void Discretization<dim>::gather(Vector<double> &u) const
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    Vector<double> own(dof_handler.n_dofs());
    for (const auto i : dof_handler.locally_owned_dofs())
      own[i] = u[i];
    Utilities::MPI::sum(own, communicator, own);
    std::copy(own.begin(), own.end(), u.begin());
  }



  template<int dim>
  bool Discretization<dim>::is_fixed(const types::global_dof_index dof) const
  {
    // All that is prescribed is constrained, which is faster to see.
    return constraints.is_constrained(dof) && prescribed.count(dof) > 0;
  }



  template<int dim>
  bool Discretization<dim>::is_moved(const types::global_dof_index dof) const
  {
    if (!constraints.is_constrained(dof))
      return false;
    const auto value = prescribed.find(dof);
    return value != prescribed.end() && value->second.value != 0;
  }



  template<int dim>
  bool Discretization<dim>::is_tied(const types::global_dof_index dof) const
  {
    for (const auto &[tied, partner] : ties)
      if (dof == tied || dof == partner)
        return true;
    return false;
  }



  template<int dim>
  void Discretization<dim>::collect_vertex_dofs()
  {
    NodeDoFs<dim> none;
    none.fill(numbers::invalid_dof_index);
    vertex_dofs.assign(mesh.triangulation.n_vertices(), none);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            vertex_dofs[cell->vertex_index(v)][c] =
              cell->vertex_dof_index(v, c, cell->active_fe_index());
  }



  // A named point is a vertex of the coarse mesh, which all ranks number alike.
  template<int dim>
  void Discretization<dim>::gather_named_points()
  {
    std::vector<types::global_dof_index *> shared;
    std::vector<types::global_dof_index>   dofs;
    for (const auto &[name, vertex] : mesh.points)
      if (vertex != numbers::invalid_unsigned_int)
        for (auto &dof : vertex_dofs[vertex])
          {
            shared.push_back(&dof);
            dofs.push_back(dof);
          }
    Utilities::MPI::min(dofs, communicator, dofs);
    for (unsigned int i = 0; i < shared.size(); ++i)
      *shared[i] = dofs[i];
  }



  template<int dim>
  void Discretization<dim>::collect_supports()
  {
    const auto collect = [this](const auto &groups, const unsigned int c) {
      const std::string entry =
        std::string("Boundary conditions/Displacement ") + "xyz"[c];
      ComponentMask component(dim, false);
      component.set(c, true);

      for (const auto &[name, value] : groups)
        {
          std::map<types::global_dof_index, double> values;
          if (mesh.points.count(name) > 0)
            values[vertex_dofs[mesh.point(name, entry)][c]] = value;
          else
            for (const types::boundary_id id : mesh.boundary(name, entry))
              VectorTools::interpolate_boundary_values(
                mapping,
                dof_handler,
                id,
                Functions::ConstantFunction<dim>(value, dim),
                values,
                component);

          auto &unknowns = supports[c][name];
          unknowns.clear();
          for (const auto &[dof, dof_value] : values)
            {
              unknowns.insert(dof);
              if (const Prescribed here{dof_value, c};
                  prescribed.emplace(dof, here).first->second != here)
                throw InputError("'" + name +
                                   "' shares a node with another "
                                   "group that is moved differently",
                                 entry,
                                 "give both the same displacement, or let the "
                                 "groups end before they meet");
            }
        }
    };

    on_all_ranks(communicator, [&]() {
      for (unsigned int c = 0; c < dim; ++c)
        collect(boundary.displacement[c], c);
      if (axisymmetric)
        hold_axis();
    });
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator, prescribed))
      prescribed.insert(of_rank.begin(), of_rank.end());
  }



  // u_r = 0 on the axis.
  template<int dim>
  void Discretization<dim>::hold_axis()
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const auto on_axis = [&](const unsigned int v) {
          return is_on_axis(cell->vertex(v));
        };
        const auto vertices = cell->vertex_indices();
        if (cell->is_artificial() ||
            std::none_of(vertices.begin(), vertices.end(), on_axis))
          continue;

        const auto &fe = cell->get_fe();
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first == 0 &&
              is_on_axis(
                mapping[cell->active_fe_index()]
                  .transform_unit_to_real_cell(cell, fe.unit_support_point(i))))
            if (const Prescribed none{0, 0};
                prescribed.emplace(dofs[i], none).first->second != none)
              throw InputError("a node on the axis of symmetry is moved off it",
                               "Boundary conditions/Displacement x",
                               "u_x = 0 there: let the group end before the "
                               "axis");
      }
  }



  template<int dim>
  void Discretization<dim>::collect_ties()
  {
    const std::string entry = "Boundary conditions/Tied y";
    for (const auto &[name, partner] : boundary.tied_y)
      {
        const auto dof = vertex_dofs[mesh.point(name, entry)][1];
        if (prescribed.count(dof) > 0)
          throw InputError("point '" + name + "' is tied and supported in y",
                           entry,
                           "remove the tie or the support");
        ties[dof] = vertex_dofs[mesh.point(partner, entry)][1];
      }
  }



  template<int dim>
  double Discretization<dim>::factor(const std::string &entry,
                                     const double       load_factor) const
  {
    const auto history = histories.find(entry);
    return history == histories.end() ? load_factor
                                      : history->second(Point<1>(load_factor));
  }



  template<int dim>
  void Discretization<dim>::make_constraints(
    const std::map<types::global_dof_index, double> &updates)
  {
    constraints.clear();
    if (mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    for (const auto &[dof, displacement] : prescribed)
      {
        constraints.add_line(dof);
        const auto update = updates.find(dof);
        if (update != updates.end())
          constraints.set_inhomogeneity(dof, update->second);
      }
    for (const auto &[dof, partner] : ties)
      {
        constraints.add_line(dof);
        constraints.add_entry(dof, partner, 1.);
      }
    if (serendipity)
      bind_centres(*this, constraints);
    constraints.close();
  }



  template class Discretization<2>;
  template class Discretization<3>;
} // namespace Contact
