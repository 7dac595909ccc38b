/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/discretization.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <boost/serialization/set.hpp>

#include "base/all_ranks.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "parameters/formula.h"
#include "solid/followers.h"
#include "solid/place_search.h"

namespace Contact
{
  namespace
  {
    /// The faces of all contact pairs, and those that are rigid.
    template<int dim>
    std::set<types::boundary_id>
    faces_with_free_centres(const Mesh<dim>       &mesh,
                            const Parameters::All &parameters)
    {
      std::set<types::boundary_id> faces;
      for (const auto &[name, point] : parameters.boundary.rigid)
        {
          const auto &ids = mesh.boundary(name, "Boundary conditions/Rigid");
          faces.insert(ids.begin(), ids.end());
        }
      for (const Parameters::Contact &pair : parameters.pairs())
        for (const std::string &group : {pair.slave, pair.master})
          if (const auto found = mesh.boundaries.find(group);
              found != mesh.boundaries.end())
            faces.insert(found->second.begin(), found->second.end());
      return faces;
    }



    template<int dim>
    std::set<types::material_id>
    bodies_of_small_strain(const Mesh<dim>          &mesh,
                           const Parameters::Solids &parameters)
    {
      std::set<types::material_id> bodies;
      for (const auto &[name, body] : mesh.bodies)
        if (parameters.kinematics.of(name) == Parameters::Strains::small)
          bodies.insert(body);
      return bodies;
    }
  } // namespace



  template<int dim>
  Discretization<dim>::Discretization(const Mesh<dim>       &mesh,
                                      const Parameters::All &parameters,
                                      const MPI_Comm         communicator)
    : DiscretizedBodies<dim>(own_dof_handler,
                             own_constraints,
                             make_mapping(mesh, parameters.element.degree),
                             parameters.element.degree,
                             parameters.solids.symmetry ==
                               Parameters::Symmetry::axisymmetric,
                             communicator)
    , mesh(mesh)
    , serendipity(degree == 2 && parameters.element.centre_node ==
                                   Parameters::CentreNode::serendipity)
    , free_centres(faces_with_free_centres(mesh, parameters))
    , fe(make_fe(mesh, degree))
    , quadrature(make_quadrature(mesh, degree))
    , boundary(parameters.boundary)
    , normal_supports(mesh, parameters.boundary.displacement_normal)
    , own_dof_handler(mesh.triangulation)
    , small_strain(bodies_of_small_strain(mesh, parameters.solids))
  {
    if (const std::string entry = boundary.entry_in_space();
        dim == 2 && !entry.empty())
      throw InputError(entry.back() == 'z'
                         ? "the mesh is plane and has no direction z"
                         : "the mesh is plane and turns about z alone",
                       "Boundary conditions/" + entry,
                       "remove the entry, or take a mesh of volumes");
    if (dim == 3 && axisymmetric)
      throw InputError("a mesh of volumes is no section of rings",
                       "Solids/Symmetry",
                       "remove the entry, or mesh the section");

    // Their values at once, not in the middle of a long run.
    const auto &increments = parameters.solution.increments;
    for (const auto &[entry, formula] : boundary.histories)
      {
        histories[entry] =
          parse_history(formula, "Boundary conditions/Histories");
        for (unsigned int i = 1; i <= increments.size(); ++i)
          factor(entry, increments.at(i));
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
    distribute_dofs(fe, own_dof_handler);
    if (degree == 2 && !mesh.has_only_hypercubes())
      on_all_ranks(communicator,
                   [&]() { check_curved_simplices(dof_handler, mapping); });

    prescribed.clear();
    ties.clear();
    known_followers.reset();
    leaders.clear();
    updates_vanish = true;
    this->collect_vertex_dofs();
    gather_named_points();
    find_places();
    normal_supports.find_nodes(dof_handler);
    collect_supports();
    collect_ties();
    collect_rigid();
    make_constraints({});
    distribute_vectors();
  }



  // The surfaces of contact are in full on every rank.
  template<int dim>
  void Discretization<dim>::distribute_vectors()
  {
    using DoFs = std::set<types::global_dof_index>;
    DoFs                                 shared;
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->is_locally_owned() && cell->at_boundary(f) &&
            free_centres.count(cell->face(f)->boundary_id()) > 0)
          {
            dofs.resize(cell->get_fe().n_dofs_per_face(f));
            cell->face(f)->get_dof_indices(dofs, cell->active_fe_index());
            shared.insert(dofs.begin(), dofs.end());
          }
    for (const auto &[name, vertices] : mesh.points)
      for (const unsigned int vertex : vertices)
        shared.insert(vertex_dofs[vertex].begin(), vertex_dofs[vertex].end());
    for (const auto &[name, place] : places)
      for (const auto &unknowns : place.unknowns)
        for (const auto &[dof, weight] : unknowns)
          shared.insert(dof);

    IndexSet ghosts = DoFTools::extract_locally_relevant_dofs(dof_handler);
    for (const DoFs &of_rank : Utilities::MPI::all_gather(communicator, shared))
      ghosts.add_indices(of_rank.begin(), of_rank.end());
    distribution =
      std::make_shared<HeldUnknowns>(dof_handler.locally_owned_dofs(),
                                     ghosts,
                                     communicator);
  }



  template<int dim>
  DistributedVector
  Discretization<dim>::distributed(const GhostedVector &solution) const
  {
    DistributedVector u(dof_handler.locally_owned_dofs(),
                        DoFTools::extract_locally_relevant_dofs(dof_handler),
                        communicator);
    std::copy_n(solution.begin(), u.locally_owned_size(), u.begin());
    u.update_ghost_values();
    return u;
  }



  // A named point is a vertex of the coarse mesh, which all ranks number alike.
  template<int dim>
  void Discretization<dim>::gather_named_points()
  {
    std::vector<types::global_dof_index *> shared;
    std::vector<types::global_dof_index>   dofs;
    for (const auto &[name, vertices] : mesh.points)
      for (const unsigned int vertex : vertices)
        for (auto &dof : vertex_dofs[vertex])
          {
            shared.push_back(&dof);
            dofs.push_back(dof);
          }
    Utilities::MPI::min(dofs, communicator, dofs);
    for (unsigned int i = 0; i < shared.size(); ++i)
      *shared[i] = dofs[i];
  }



  // The first rank with a cell at a node owns it: it knows all cells around it.
  template<int dim>
  void Discretization<dim>::find_places()
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    std::map<unsigned int, unsigned int> owner;
    for (const auto &[name, vertices] : mesh.points)
      for (const unsigned int vertex : vertices)
        owner[vertex] = numbers::invalid_unsigned_int;
    if (!owner.empty())
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (const auto at = owner.find(cell->vertex_index(v));
                at != owner.end())
              at->second = rank;
    places.clear();
    for (const auto &[name, vertices] : mesh.points)
      if (vertices.size() == 1)
        {
          const unsigned int vertex = vertices[0];
          Place<dim>        &place  = places[name];
          for (unsigned int c = 0; c < dim; ++c)
            place.unknowns[c] = {{vertex_dofs[vertex][c], 1.}};
          if (Utilities::MPI::min(owner.at(vertex), communicator) == rank)
            place.vertices = {{vertex, 1.}};
        }
    const PlaceSearch<dim> search(mesh, mapping, dof_handler, communicator);
    const auto             is_of_rigid = [&](const std::string &name) {
      return std::any_of(boundary.rigid.begin(),
                         boundary.rigid.end(),
                         [&](const auto &of) { return of.second == name; });
    };
    for (const auto &[name, named] : mesh.places)
      try
        {
          places[name] = search.find(name);
        }
      catch (const InputError &)
        {
          places.erase(name);
          if (!is_of_rigid(name))
            throw;
        }
  }



  template<int dim>
  const Place<dim> &Discretization<dim>::place(const std::string &name,
                                               const std::string &entry) const
  {
    if (const auto found = places.find(name); found != places.end())
      return found->second;
    if (mesh.places.count(name) > 0) // both say why not
      PlaceSearch<dim>(mesh, mapping, dof_handler, communicator).find(name);
    mesh.point(name, entry);
    AssertThrow(false, ExcInternalError());
    return places.begin()->second;
  }



  template<int dim>
  double Discretization<dim>::factor(const std::string &entry,
                                     const double       load_factor) const
  {
    const auto history = histories.find(entry);
    return history == histories.end() ? load_factor
                                      : history->second(Point<1>(load_factor));
  }



  // A hanging node goes where the nodes do that it hangs on.
  template<int dim>
  void Discretization<dim>::make_constraints(
    const std::map<types::global_dof_index, double> &updates)
  {
    own_constraints.clear();
    if (mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, own_constraints);
    const auto move = [&](const types::global_dof_index dof) {
      const auto update = updates.find(dof);
      if (update != updates.end())
        own_constraints.set_inhomogeneity(dof, update->second);
    };
    for (const auto &[dof, displacement] : prescribed)
      if (!own_constraints.is_constrained(dof))
        {
          own_constraints.add_line(dof);
          move(dof);
        }
    for (const auto &line : normal_supports.lines())
      if (!own_constraints.is_constrained(line.pivot))
        {
          own_constraints.add_line(line.pivot);
          own_constraints.add_entries(line.pivot, line.entries);
          move(line.pivot);
        }
    for (const auto &[dof, partner] : ties)
      {
        own_constraints.add_line(dof);
        own_constraints.add_entry(dof, partner, 1.);
      }
    for (const auto &line : followers_of_rigid)
      {
        own_constraints.add_line(line.dof);
        own_constraints.add_entries(line.dof, line.entries);
        own_constraints.set_inhomogeneity(line.dof, line.inhomogeneity);
      }
    bind_centres(*this, dof_handler, own_constraints);
    own_constraints.close();
  }



  template<int dim>
  const AffineConstraints<double> &Discretization<dim>::followers() const
  {
    if (!known_followers)
      known_followers =
        std::make_unique<AffineConstraints<double>>(make_followers(*this));
    return *known_followers;
  }



  template class Discretization<2>;
  template class Discretization<3>;
} // namespace Contact
