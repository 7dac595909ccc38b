/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/normal_supports.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/all_ranks.h"
#include "base/errors.h"
#include "mesh/face_middle.h"

namespace Contact
{
  namespace
  {
    const std::string entry = "Boundary conditions/Displacement normal";

    /// Mesh files have six digits and more.
    const double flat = 1e-5;

    /// Below this sine two normals are one; below this part of a normal an
    /// unknown is not in its equation.
    const double round_off = 1e-10;



    Tensor<1, 2> area_vector(const TriaIterator<TriaAccessor<1, 2, 2>> &face)
    {
      return cross_product_2d(face->vertex(1) - face->vertex(0));
    }

    Tensor<1, 3> area_vector(const TriaIterator<TriaAccessor<2, 3, 3>> &face)
    {
      return cross_product_3d(face->vertex(face->n_vertices() - 1) -
                                face->vertex(0),
                              face->vertex(2) - face->vertex(1)) /
             2;
    }



    /// Visit the faces of the coarse mesh, which every rank has, with these
    /// ids.
    template<int dim, typename Visit>
    void for_coarse_faces(const Mesh<dim>                    &mesh,
                          const std::set<types::boundary_id> &ids,
                          const Visit                        &visit)
    {
      for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
            {
              Tensor<1, dim> area = area_vector(face);
              if (area * (face->center() - cell->center()) < 0)
                area *= -1;
              visit(face, area);
            }
    }
  } // namespace



  template<int dim>
  double
  NormalSupports<dim>::Line::motion(const GhostedVector      &u,
                                    const SupportMotion<dim> &motion) const
  {
    const double value = prescribed.at(motion);
    double       sum = value - u[pivot], size = std::abs(value);
    size += std::abs(u[pivot]);
    for (const auto &[dof, coefficient] : entries)
      {
        sum += coefficient * u[dof];
        size += std::abs(coefficient * u[dof]);
      }
    const double few = 16 * std::numeric_limits<double>::epsilon();
    return std::abs(sum) > few * size ? sum : 0.;
  }



  template<int dim>
  NormalSupports<dim>::NormalSupports(
    const Mesh<dim>                     &mesh,
    const std::map<std::string, double> &values)
  {
    for (const auto &[name, value] : values)
      {
        if (mesh.points.count(name) + mesh.places.count(name) > 0)
          throw InputError("the point '" + name + "' has no normal",
                           entry,
                           "name a boundary, or set 'Displacement x' and the "
                           "others");
        Plane plane{name, mesh.boundary(name, entry), {}, value};
        plane.normal = normal_of(mesh, plane);
        planes.push_back(plane);
      }
  }



  template<int dim>
  Tensor<1, dim> NormalSupports<dim>::normal_of(const Mesh<dim> &mesh,
                                                const Plane     &plane) const
  {
    Tensor<1, dim> sum;
    double         whole = 0;
    for_coarse_faces(mesh,
                     plane.boundary_ids,
                     [&](const auto &, const Tensor<1, dim> &area) {
                       sum += area;
                       whole += area.norm();
                     });
    bool is_flat = sum.norm() > flat * whole;
    if (is_flat)
      sum /= sum.norm();
    for_coarse_faces(mesh,
                     plane.boundary_ids,
                     [&](const auto &face, const Tensor<1, dim> &area) {
                       const Tensor<1, dim> bulge =
                         middle_of_face(face) - face->center();
                       is_flat =
                         is_flat && (area / area.norm() - sum).norm() <= flat &&
                         std::abs(bulge * sum) <= flat * face->diameter();
                     });
    if (!is_flat)
      throw InputError("'" + plane.name +
                         "' is not flat: it has no normal that all of it is "
                         "held along",
                       entry,
                       "name a flat boundary, or one for each of its flat "
                       "parts");
    return sum;
  }



  // Those of the cells of this rank, which knows all cells around them, then
  // those of all ranks. A hanging node of degree 2 that is but another name of
  // a node of the larger face leaves the equation to that.
  template<int dim>
  void NormalSupports<dim>::find_nodes(const DoFHandler<dim> &dof_handler)
  {
    nodes.clear();
    if (planes.empty())
      return;
    AffineConstraints<double> hanging;
    if (dof_handler.get_triangulation().has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    hanging.close();

    std::vector<std::vector<Dof>> found; // unknowns, and the number of a plane
    const auto add = [&](std::vector<Dof> node, const unsigned int plane) {
      for (Dof &dof : node)
        if (const auto *parents = hanging.get_constraint_entries(dof))
          {
            if (parents->size() > 1 || parents->empty())
              return;
            dof = parents->front().first;
          }
      node.push_back(plane);
      found.push_back(std::move(node));
    };
    std::vector<Dof> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          for (unsigned int p = 0; face->at_boundary() && p < planes.size();
               ++p)
            if (planes[p].boundary_ids.count(face->boundary_id()) > 0)
              {
                const auto &fe = cell->get_fe();
                dofs.resize(fe.n_dofs_per_face());
                face->get_dof_indices(dofs, cell->active_fe_index());
                std::map<unsigned int, std::vector<Dof>> of_node;
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  {
                    const auto [c, a] = fe.face_system_to_component_index(i);
                    of_node[a].resize(dim);
                    of_node[a][c] = dofs[i];
                  }
                for (const auto &[a, node] : of_node)
                  add(node, p);
              }

    for (const auto &of_rank :
         Utilities::MPI::all_gather(dof_handler.get_communicator(), found))
      for (const auto &numbers : of_rank)
        {
          Node &node = nodes[numbers[0]];
          std::copy_n(numbers.begin(), dim, node.dofs.begin());
          node.planes.insert(numbers[dim]);
        }
  }



  // Without the unknowns that supports along the coordinates prescribe.
  template<int dim>
  std::vector<typename NormalSupports<dim>::Equation>
  NormalSupports<dim>::free_equations(
    const Node                           &node,
    const std::map<Dof, Prescribed<dim>> &prescribed) const
  {
    std::vector<Equation> equations;
    for (const unsigned int p : node.planes)
      {
        Equation equation{planes[p].normal, {}};
        equation.prescribed.parts[dim] = planes[p].value;
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto held = prescribed.find(node.dofs[c]);
              held != prescribed.end())
            {
              if (held->second.has_formula() && equation.normal[c] != 0)
                throw InputError("'" + planes[p].name +
                                   "' shares a node with a group that is "
                                   "moved by a formula",
                                 entry,
                                 "let the groups end before they meet");
              for (unsigned int k = 0; k <= dim; ++k)
                equation.prescribed.parts[k] -=
                  equation.normal[c] * held->second.parts[k];
              equation.normal[c] = 0;
            }
        equations.push_back(equation);
      }
    return equations;
  }



  template<int dim>
  std::vector<Tensor<1, dim>>
  NormalSupports<dim>::orthonormal(const std::vector<Equation> &equations)
  {
    std::vector<Tensor<1, dim>> basis;
    for (const Equation &equation : equations)
      {
        Tensor<1, dim> rest = equation.normal;
        for (unsigned int pass = 0; pass < 2; ++pass) // because of round-off
          for (const Tensor<1, dim> &other : basis)
            rest -= (rest * other) * other;
        if (rest.norm() > round_off)
          basis.push_back(rest / rest.norm());
      }
    return basis;
  }



  // Gauss and Jordan: the largest coefficient of all that are left is the next
  // pivot, and its unknown goes out of all other equations.
  template<int dim>
  std::vector<unsigned int>
  NormalSupports<dim>::eliminate(std::vector<Equation> &equations)
  {
    const auto subtract =
      [](Equation &from, const double factor, const Equation &what) {
        from.normal -= factor * what.normal;
        for (unsigned int k = 0; k <= dim; ++k)
          from.prescribed.parts[k] -= factor * what.prescribed.parts[k];
      };
    std::vector<unsigned int> pivots;
    for (unsigned int row = 0; row < equations.size(); ++row)
      {
        unsigned int best = row, pivot = 0;
        for (unsigned int other = row; other < equations.size(); ++other)
          for (unsigned int c = 0; c < dim; ++c)
            if (std::abs(equations[other].normal[c]) >
                std::abs(equations[best].normal[pivot]))
              {
                best  = other;
                pivot = c;
              }
        const double scale = equations[best].normal[pivot];
        if (std::abs(scale) <= round_off)
          break;
        std::swap(equations[row], equations[best]);
        equations[row].normal /= scale;
        for (double &part : equations[row].prescribed.parts)
          part /= scale;
        for (unsigned int other = 0; other < equations.size(); ++other)
          if (other != row)
            {
              subtract(equations[other],
                       equations[other].normal[pivot],
                       equations[row]);
              equations[other].normal[pivot] = 0;
            }
        pivots.push_back(pivot);
      }
    return pivots;
  }



  template<int dim>
  void NormalSupports<dim>::check(
    const Node                           &node,
    const unsigned int                    n_solved,
    const std::vector<Equation>          &equations,
    const std::map<Dof, Prescribed<dim>> &prescribed) const
  {
    double size = 0;
    for (const unsigned int p : node.planes)
      size = std::max(size, std::abs(planes[p].value));
    for (const Dof dof : node.dofs)
      if (const auto held = prescribed.find(dof); held != prescribed.end())
        for (const double part : held->second.parts)
          size = std::max(size, std::abs(part));
    const double tolerance = 1e-8 * size;
    for (unsigned int row = n_solved; row < equations.size(); ++row)
      for (const double part : equations[row].prescribed.parts)
        if (std::abs(part) > tolerance)
          throw InputError("'" + planes[*node.planes.begin()].name +
                             "' shares a node with another group that is "
                             "moved differently",
                           entry,
                           "give both displacements that agree, or let the "
                           "groups end before they meet");
  }



  template<int dim>
  void NormalSupports<dim>::solve(std::map<Dof, Prescribed<dim>> &prescribed)
  {
    all_lines.clear();
    line_of.clear();
    for (auto &[first, node] : nodes)
      {
        std::vector<Equation> equations = free_equations(node, prescribed);
        node.held                       = orthonormal(equations);
        const auto pivots               = eliminate(equations);
        check(node, pivots.size(), equations, prescribed);
        for (unsigned int row = 0; row < pivots.size(); ++row)
          {
            const auto &[normal, displacement] = equations[row];
            Line line{node.dofs[pivots[row]], {}, displacement};
            for (unsigned int c = 0; c < dim; ++c)
              if (c != pivots[row] && std::abs(normal[c]) > round_off)
                line.entries.emplace_back(node.dofs[c], -normal[c]);
            if (line.entries.empty())
              prescribed.emplace(line.pivot, line.prescribed);
            else
              {
                line_of[line.pivot] = all_lines.size();
                all_lines.push_back(line);
              }
          }
      }
  }



  template<int dim>
  const typename NormalSupports<dim>::Line *
  NormalSupports<dim>::line(const Dof dof) const
  {
    const auto found = line_of.find(dof);
    return found == line_of.end() ? nullptr : &all_lines[found->second];
  }



  template<int dim>
  void NormalSupports<dim>::make_free(const NodeDoFs<dim> &node,
                                      Tensor<1, dim>      &direction) const
  {
    if (const auto found = nodes.find(node[0]); found != nodes.end())
      for (const Tensor<1, dim> &held : found->second.held)
        direction -= (direction * held) * held;
  }



  template<int dim>
  std::vector<Tensor<1, dim>>
  NormalSupports<dim>::normals(const NodeDoFs<dim> &node) const
  {
    std::vector<Tensor<1, dim>> normals;
    if (const auto found = nodes.find(node[0]); found != nodes.end())
      for (const unsigned int p : found->second.planes)
        normals.push_back(planes[p].normal);
    return normals;
  }



  template<int dim>
  bool NormalSupports<dim>::hold_alike(const NodeDoFs<dim>  &a,
                                       const NodeDoFs<dim>  &b,
                                       const Tensor<1, dim> &direction) const
  {
    const auto of_a = nodes.find(a[0]), of_b = nodes.find(b[0]);
    if (of_a == nodes.end() || of_b == nodes.end())
      return false;
    const auto along = [&](const unsigned int p) {
      const double cosine = planes[p].normal * direction / direction.norm();
      return std::abs(cosine) < 1 - flat * flat ? 0. : cosine > 0 ? 1. : -1.;
    };
    for (const unsigned int p : of_a->second.planes)
      for (const unsigned int q : of_b->second.planes)
        if (along(p) != 0 && along(q) != 0 &&
            !(along(p) * planes[p].value != along(q) * planes[q].value))
          return true;
    return false;
  }



  template<int dim>
  std::map<std::string, std::set<types::global_dof_index>>
  NormalSupports<dim>::unknowns(const unsigned int component) const
  {
    std::map<std::string, std::set<Dof>> unknowns;
    for (const Plane &plane : planes)
      if (std::abs(plane.normal[component]) > round_off)
        unknowns[plane.name];
    for (const auto &[dof, node] : nodes)
      for (const unsigned int p : node.planes)
        if (const auto of_plane = unknowns.find(planes[p].name);
            of_plane != unknowns.end())
          of_plane->second.insert(node.dofs[component]);
    return unknowns;
  }



  template<int dim>
  double NormalSupports<dim>::largest(const SupportMotion<dim> &motion) const
  {
    double largest = 0;
    for (const Plane &plane : planes)
      largest = std::max(largest, std::abs(plane.value * motion.factors[dim]));
    return largest;
  }

  template class NormalSupports<2>;
  template class NormalSupports<3>;
} // namespace Contact
