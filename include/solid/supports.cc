/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Discretization on what supports and ties hold.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/serialization/map.hpp>
#include <cmath>

#include "base/all_ranks.h"
#include "base/dimension.h"
#include "base/errors.h"
#include "parameters/formula.h"
#include "solid/discretization.h"

namespace Contact
{
  // The nodes of points, of a curve in 3-D, or of a boundary. A mesh file
  // may give points and boundaries the same name.
  template<int dim>
  void Discretization<dim>::visit_group(const unsigned int component,
                                        const std::string &entry,
                                        const std::string &name,
                                        const NodeVisitor &visitor) const
  {
    mesh.refuse_place(name, entry);
    if (mesh.points.count(name) > 0)
      {
        if (mesh.boundaries.count(name) + mesh.curves.count(name) > 0)
          throw InputError("'" + name + "' is a point as well as a boundary",
                           entry,
                           "give one of them another name in the mesh file or "
                           "in 'Mesh/Points'");
        for (const unsigned int vertex : mesh.points.at(name))
          visitor(
            vertex_dofs[vertex][component],
            [&]() { return mesh.triangulation.get_vertices()[vertex]; },
            /*is_owned=*/true);
        return;
      }
    const auto curve = mesh.curves.find(name);
    const bool is_curve =
      curve != mesh.curves.end() && mesh.boundaries.count(name) == 0;
    const auto &ids = is_curve ? curve->second : mesh.boundary(name, entry);

    std::vector<types::global_dof_index> dofs, of_part;
    std::set<types::global_dof_index>    on_group;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial() || !cell->at_boundary())
          continue;
        const auto &fe = cell->get_fe();
        on_group.clear();
        const auto add = [&](const auto &part, const unsigned int n_dofs) {
          if (ids.count(part->boundary_id()) == 0)
            return;
          of_part.resize(n_dofs);
          part->get_dof_indices(of_part, cell->active_fe_index());
          on_group.insert(of_part.begin(), of_part.end());
        };
        if constexpr (dim == 3)
          for (unsigned int l = 0; is_curve && l < cell->n_lines(); ++l)
            add(cell->line(l),
                2 * fe.n_dofs_per_vertex() + fe.n_dofs_per_line());
        for (const unsigned int f : cell->face_indices())
          if (!is_curve && cell->at_boundary(f))
            add(cell->face(f), fe.n_dofs_per_face(f));
        if (on_group.empty())
          continue;

        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first == component &&
              on_group.count(dofs[i]) > 0)
            visitor(
              dofs[i],
              [&]() {
                return mapping[cell->active_fe_index()]
                  .transform_unit_to_real_cell(cell, fe.unit_support_point(i));
              },
              cell->is_locally_owned());
      }
  }



  // All components come in the same order.
  template<int dim>
  std::vector<NodeDoFs<dim>>
  Discretization<dim>::nodes_of(const std::string &name,
                                const std::string &entry) const
  {
    std::vector<NodeDoFs<dim>> nodes;
    for (unsigned int c = 0; c < dim; ++c)
      {
        unsigned int n = 0;
        visit_group(c,
                    entry,
                    name,
                    [&](const types::global_dof_index dof,
                        const PlaceOfNode &,
                        const bool) {
                      if (c == 0)
                        nodes.emplace_back();
                      nodes[n++][c] = dof;
                    });
      }
    return nodes;
  }



  // The nodes of a group get what is prescribed. The owner of a cell knows
  // which of its nodes hang. Cells differ in the last digits of a place.
  template<int dim>
  void Discretization<dim>::hold(
    const unsigned int                                         component,
    const std::string                                         &entry,
    const std::string                                         &name,
    const std::function<Prescribed<dim>(const PlaceOfNode &)> &at)
  {
    auto &unknowns = supports[component][name];
    visit_group(component,
                entry,
                name,
                [&](const types::global_dof_index dof,
                    const PlaceOfNode            &place,
                    const bool                    is_owned) {
                  unknowns.insert(dof);
                  if (!is_owned)
                    return;
                  const Prescribed<dim> here = at(place);
                  const Prescribed<dim> first =
                    prescribed.emplace(dof, here).first->second;
                  if (first != here && !move_alike(first, here))
                    throw InputError(
                      "'" + name +
                        "' shares a node with another group that is moved "
                        "differently",
                      entry,
                      "give both the same displacement there, or let the "
                      "groups end before they meet");
                });
  }



  // At times that no formula is made for. The coordinates of a place have the
  // digits of the file.
  template<int dim>
  bool Discretization<dim>::move_alike(const Prescribed<dim> &first,
                                       const Prescribed<dim> &second) const
  {
    const unsigned int n_times   = 20;
    const double       round_off = 1e-9;
    double             largest = 0, difference = 0;
    for (unsigned int k = 1; k <= n_times; ++k)
      {
        const auto   motion = motion_of_supports(std::fmod(k / numbers::PI, 1));
        const double a = first.at(motion), b = second.at(motion);
        largest    = std::max({largest, std::abs(a), std::abs(b)});
        difference = std::max(difference, std::abs(a - b));
      }
    return difference <= round_off * (largest + mesh.typed_digits);
  }



  template<int dim>
  void Discretization<dim>::collect_supports()
  {
    supports = {};
    on_all_ranks(communicator, [&]() {
      formulas.clear();
      for (unsigned int c = 0; c < dim; ++c)
        {
          const std::string entry =
            std::string("Boundary conditions/Displacement ") + "xyz"[c];
          for (const auto &[name, value] : boundary.displacement[c])
            {
              if (boundary.rigid.count(name) > 0)
                continue;
              Prescribed<dim> everywhere;
              everywhere.parts[c] = value;
              hold(c, entry, name, [&](const PlaceOfNode &) {
                return everywhere;
              });
            }
          collect_formulas(c);
        }
      if (axisymmetric)
        hold_axis();
    });
    hold_parents_of_hanging_nodes();
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator, prescribed))
      prescribed.insert(of_rank.begin(), of_rank.end());
    on_all_ranks(communicator, [&]() { normal_supports.solve(prescribed); });
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto &[name, unknowns] : normal_supports.unknowns(c))
        supports[c][name].insert(unknowns.begin(), unknowns.end());
  }



  // Parameters are checked before the mesh is known, with all variables.
  template<int dim>
  void Discretization<dim>::collect_formulas(const unsigned int c)
  {
    const std::string entry =
      std::string("Boundary conditions/Displacement formula ") + "xyz"[c];
    std::map<std::string, unsigned int> numbers; // of the formulas, by text
    for (const auto &[name, formula] : boundary.displacement_formula[c])
      {
        const auto [known, is_new] = numbers.emplace(formula, formulas.size());
        const unsigned int number  = known->second;
        try
          {
            if (is_new)
              formulas.push_back(parse_formula_in_time<dim>(
                formula,
                std::string(Dimension<dim>::coordinates) + ",t",
                entry));
          }
        catch (const std::runtime_error &error)
          {
            throw InputError(error.what(),
                             entry,
                             "the mesh is plane: write a formula without z");
          }
        if (boundary.rigid.count(name) > 0)
          {
            formula_of_rigid[c][name] = number;
            continue;
          }
        hold(c, entry, name, [number](const PlaceOfNode &place) {
          Prescribed<dim> here;
          here.formula = number;
          here.X       = place();
          return here;
        });
      }
  }



  // A node of degree 2 in the middle of an edge of a larger cell has the place
  // of that cell's own node, which it follows. One that follows several is
  // where these are, which need not be where a formula wants it.
  template<int dim>
  void Discretization<dim>::hold_parents_of_hanging_nodes()
  {
    if (!mesh.triangulation.has_hanging_nodes())
      return;
    AffineConstraints<double> hanging;
    DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    hanging.close();
    for (const auto &line : hanging.get_lines())
      if (const auto held = prescribed.find(line.index);
          held != prescribed.end())
        {
          if (line.entries.size() == 1)
            prescribed.emplace(line.entries.front().first, held->second);
          else if (held->second.has_formula())
            prescribed.erase(held);
        }
  }



  // u_r = 0 on the axis.
  template<int dim>
  void Discretization<dim>::hold_axis()
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const auto on_axis = [&](const unsigned int v) {
          return this->is_on_axis(cell->vertex(v));
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
              this->is_on_axis(
                mapping[cell->active_fe_index()]
                  .transform_unit_to_real_cell(cell, fe.unit_support_point(i))))
            if (const Prescribed<dim> none;
                prescribed.emplace(dofs[i], none).first->second != none)
              throw InputError("a node on the axis of symmetry is moved off it",
                               "Boundary conditions/Displacement x",
                               "u_x = 0 there: let the group end before the "
                               "axis");
      }
  }



  // Nodes that hang follow others of the same boundary.
  template<int dim>
  void Discretization<dim>::collect_ties()
  {
    AffineConstraints<double> hanging;
    if (mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    for (unsigned int c = 0; c < dim; ++c)
      {
        const std::string entry =
          std::string("Boundary conditions/Tied ") + "xyz"[c];
        for (const auto &[group, partner] : boundary.tied[c])
          {
            const std::string &name = group;
            const auto leader = vertex_dofs[mesh.point(partner, entry)][c];
            const auto tie    = [&](const types::global_dof_index dof,
                                 const PlaceOfNode &,
                                 const bool) {
              if (dof == leader || hanging.is_constrained(dof))
                return;
              if (prescribed.count(dof) > 0 ||
                  normal_supports.line(dof) != nullptr)
                throw InputError("'" + name + "' is tied and supported in " +
                                   "xyz"[c],
                                 entry,
                                 "remove the tie or the support");
              if (ties.emplace(dof, leader).first->second != leader)
                throw InputError("'" + name +
                                   "' shares a node with another group that "
                                      "is tied to another point",
                                 entry,
                                 "tie both to the same point");
              leaders.insert(leader);
            };
            visit_group(c, entry, name, tie);
          }
      }
  }

  template class Discretization<2>;
  template class Discretization<3>;
} // namespace Contact
