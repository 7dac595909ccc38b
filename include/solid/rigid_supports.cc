/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The part of Discretization on boundaries that move as rigid bodies.

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include "base/all_ranks.h"
#include "base/errors.h"
#include "solid/discretization.h"

namespace Contact
{
  namespace
  {
    const std::string entry = "Boundary conditions/Rigid";

    template<int dim>
    Tensor<1, 3> in_space(const Tensor<1, dim> &vector)
    {
      Tensor<1, 3> v;
      for (unsigned int c = 0; c < dim; ++c)
        v[c] = vector[c];
      return v;
    }

  } // namespace



  template<int dim>
  Point<dim> Discretization<dim>::rigid_point(const std::string &name) const
  {
    const std::string &point = boundary.rigid.at(name);
    const auto         named = mesh.places.find(point);
    if (named == mesh.places.end())
      return mesh.triangulation.get_vertices()[mesh.point(point, entry)];
    const auto &in_body = named->second.in_body;
    const auto  first   = in_body.begin();
    for (const auto &[body, X] : in_body)
      if (X != first->second)
        throw InputError("the point '" + point + "' is in '" +
                           mesh.body_name(first->first) + "' or in '" +
                           mesh.body_name(body) + "', which are moved apart",
                         "entry 'Mesh/Points'",
                         "write '" + point + " in BODY'");
    return first->second;
  }



  // The owner of a cell knows which of its nodes hang; those follow others of
  // the boundary.
  template<int dim>
  void Discretization<dim>::collect_rigid()
  {
    rigid.clear();
    rigid_dofs.clear();
    rigid_held.clear();
    followers_of_rigid.clear();
    if (boundary.rigid.empty())
      return;
    AffineConstraints<double> hanging;
    if (mesh.triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    using Dofs = std::array<types::global_dof_index, dim>;
    for (const auto &[name, point] : boundary.rigid)
      {
        const auto                          &ids = mesh.boundary(name, entry);
        const Point<dim>                     P   = rigid_point(name);
        bool                                 is_large = false;
        std::map<Dofs, Point<dim>>           places;
        std::vector<types::global_dof_index> dofs, on_face;
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && cell->at_boundary())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
                {
                  is_large =
                    is_large || small_strain.count(cell->material_id()) == 0;
                  const auto &fe = cell->get_fe();
                  dofs.resize(fe.n_dofs_per_cell());
                  cell->get_dof_indices(dofs);
                  on_face.resize(fe.n_dofs_per_face());
                  face->get_dof_indices(on_face, cell->active_fe_index());
                  const std::set<types::global_dof_index> face_dofs(
                    on_face.begin(),
                    on_face.end());
                  for (unsigned int a = 0; a < dofs.size() / dim; ++a)
                    {
                      Dofs node;
                      for (unsigned int c = 0; c < dim; ++c)
                        node[c] = dofs[fe.component_to_system_index(c, a)];
                      if (face_dofs.count(node[0]) > 0 &&
                          !hanging.is_constrained(node[0]))
                        places.emplace(node,
                                       mapping[cell->active_fe_index()]
                                         .transform_unit_to_real_cell(
                                           cell,
                                           fe.unit_support_point(
                                             fe.component_to_system_index(0,
                                                                          a))));
                    }
                }
        is_large = Utilities::MPI::max(static_cast<unsigned int>(is_large),
                                       communicator) > 0;
        for (const auto &of_rank :
             Utilities::MPI::all_gather(communicator, places))
          places.insert(of_rank.begin(), of_rank.end());

        std::vector<typename RigidBoundary<dim>::Node> nodes;
        for (const auto &[node, X] : places)
          {
            nodes.push_back({node, in_space<dim>(X - P)});
            for (const auto dof : node)
              {
                if (ties.count(dof) + leaders.count(dof) > 0 ||
                    normal_supports.line(dof) != nullptr)
                  throw InputError("the rigid boundary '" + name +
                                     "' shares a node with a group that is "
                                     "tied or held along its normal",
                                   entry + ", Tied x, Displacement normal",
                                   "let the groups end before they meet, or "
                                   "hold it along x, y or z");
                if (!rigid_dofs.insert(dof).second)
                  throw InputError("the rigid boundary '" + name +
                                     "' shares a node with another one",
                                   entry,
                                   "make them one boundary");
                if (prescribed.count(dof) > 0)
                  rigid_held.insert(dof);
              }
          }
        rigid.emplace_back(name, nodes, is_large, axisymmetric);
        choose_rigid_leaders(rigid.back());
      }
    followers_of_rigid = rigid_lines(GhostedVector(dof_handler.n_dofs()), 0);
    for (auto &line : followers_of_rigid)
      line.inhomogeneity = 0;
  }



  // Supports of single nodes take the place of leaders. Where there are more
  // than motions, they have to say the same as the motion that is prescribed:
  // in a plane of symmetry, nothing of a turn about its normal.
  template<int dim>
  void Discretization<dim>::choose_rigid_leaders(RigidBoundary<dim> &boundary)
  {
    Tensor<2, 3> none;
    for (unsigned int k = 0; k < 3; ++k)
      none[k][k] = 1;
    const auto others =
      boundary.choose_leaders({{}, none},
                              this->targets(boundary, /*load_factor=*/1),
                              rigid_held);
    if (others.empty())
      return;
    const auto resting = [&](const double load_factor) {
      const auto    supports = motion_of_supports(load_factor);
      GhostedVector u(dof_handler.n_dofs());
      for (const auto held : rigid_held)
        u[held] = prescribed.at(held).at(supports);
      const auto motion =
        boundary.motion(u, this->targets(boundary, load_factor));
      const double round_off = 1e-8 * (boundary.extent() + motion.U.norm());
      std::set<types::global_dof_index> dofs;
      for (const auto &node : boundary.nodes)
        for (unsigned int c = 0; c < dim; ++c)
          if (std::abs(boundary.displacement(motion, node)[c]) <= round_off)
            dofs.insert(node.dofs[c]);
      return dofs;
    };
    const auto at_half = resting(0.5), at_end = resting(1);
    for (const auto dof : others)
      if (prescribed.at(dof).is_moved() || at_half.count(dof) == 0 ||
          at_end.count(dof) == 0)
        throw InputError("the rigid boundary '" + boundary.name +
                           "' is moved in more ways than it has motions",
                         entry + ", Displacement x",
                         "remove the supports of its nodes, or the "
                         "displacements and rotations of the boundary");
  }



  template<int dim>
  const RigidBoundary<dim> &
  Discretization<dim>::rigid_boundary(const std::string &name,
                                      const std::string &by) const
  {
    const auto found =
      std::find_if(rigid.begin(), rigid.end(), [&](const auto &boundary) {
        return boundary.name == name;
      });
    if (found == rigid.end())
      throw InputError("'" + name + "' is no rigid boundary",
                       by,
                       "name one of 'Boundary conditions/Rigid'");
    return *found;
  }



  template<int dim>
  typename RigidBoundary<dim>::Targets
  Discretization<dim>::targets(const RigidBoundary<dim> &of,
                               const double              load_factor) const
  {
    typename RigidBoundary<dim>::Targets targets;
    const auto prescribe = [&](const unsigned int k, const double value) {
      targets.is_prescribed[k] = true;
      targets.value[k]         = value;
    };
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::string in = std::string(" ") + "xyz"[c];
        if (const auto found = boundary.displacement[c].find(of.name);
            found != boundary.displacement[c].end())
          prescribe(c,
                    found->second * factor("Displacement" + in, load_factor));
        if (const auto found = boundary.rotation[c].find(of.name);
            found != boundary.rotation[c].end())
          prescribe(3 + c,
                    found->second * factor("Rotation" + in, load_factor));
      }
    for (unsigned int c = 0; c < dim; ++c)
      if (const auto found = formula_of_rigid[c].find(of.name);
          found != formula_of_rigid[c].end())
        prescribe(c,
                  formulas[found->second](rigid_point(of.name), load_factor));
    return targets;
  }



  // A boundary that turns may need other leaders. Ranks know their state but
  // for round-off: one chooses.
  template<int dim>
  void Discretization<dim>::update_rigid_leaders(const GhostedVector &u,
                                                 const double load_factor)
  {
    for (RigidBoundary<dim> &boundary : rigid)
      {
        if (!boundary.is_large)
          continue;
        const auto         targets = this->targets(boundary, load_factor);
        auto               motion  = boundary.motion(u, targets);
        const double       enough  = 0.6;
        RigidBoundary<dim> other(boundary);
        other.choose_leaders(motion, targets, rigid_held);
        const bool is_better = std::isfinite(motion.R.norm()) &&
                               boundary.quality(motion, targets) <
                                 enough * other.quality(motion, targets);
        if (Utilities::MPI::max(static_cast<unsigned int>(is_better),
                                communicator) == 0)
          continue;
        motion.R = Utilities::MPI::broadcast(communicator, motion.R);
        boundary.choose_leaders(motion, targets, rigid_held);
        ++n_patterns;
      }
  }



  template<int dim>
  std::vector<typename RigidBoundary<dim>::Line>
  Discretization<dim>::rigid_lines(const GhostedVector &u,
                                   const double         load_factor) const
  {
    std::vector<typename RigidBoundary<dim>::Line> all;
    for (const RigidBoundary<dim> &boundary : rigid)
      {
        const auto lines =
          boundary.lines(u, targets(boundary, load_factor), rigid_held);
        all.insert(all.end(), lines.begin(), lines.end());
      }
    return all;
  }



  template<int dim>
  void
  Discretization<dim>::project_on_rigid_motions(GhostedVector &u,
                                                const double load_factor) const
  {
    const auto of_supports = motion_of_supports(load_factor);
    for (const auto &line : normal_supports.lines())
      if (u.holds(line.pivot))
        u[line.pivot] += line.motion(u, of_supports);
    for (const RigidBoundary<dim> &boundary : rigid)
      if (boundary.is_large)
        {
          const auto motion =
            boundary.motion(u, targets(boundary, load_factor));
          for (const auto &node : boundary.nodes)
            for (unsigned int c = 0; c < dim; ++c)
              if (rigid_held.count(node.dofs[c]) == 0)
                u[node.dofs[c]] = boundary.displacement(motion, node)[c];
        }
  }



  template<int dim>
  typename RigidBoundary<dim>::PerMotion
  Discretization<dim>::applied(const RigidBoundary<dim> &of,
                               const double              load_factor) const
  {
    typename RigidBoundary<dim>::PerMotion resultant{};
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::string in = std::string(" ") + "xyz"[c];
        if (const auto force = boundary.force[c].find(of.name);
            force != boundary.force[c].end())
          resultant[c] = force->second * factor("Force" + in, load_factor);
        if (const auto moment = boundary.moment[c].find(of.name);
            moment != boundary.moment[c].end())
          resultant[3 + c] =
            moment->second * factor("Moment" + in, load_factor);
      }
    return resultant;
  }



  template<int dim>
  void Discretization<dim>::add_rigid_loads(const GhostedVector &u,
                                            const double         load_factor,
                                            GhostedVector       &load) const
  {
    for (const RigidBoundary<dim> &of : rigid)
      {
        const auto resultant = applied(of, load_factor);
        if (resultant == typename RigidBoundary<dim>::PerMotion())
          continue;
        const auto motion = of.motion(u, targets(of, load_factor));
        for (const auto &[dof, force] : of.nodal_forces(motion, resultant))
          load[dof] += force;
      }
  }



  template<int dim>
  double Discretization<dim>::rigid_load(const double load_factor) const
  {
    if (rigid.empty())
      return 0;
    GhostedVector u(distribution), load(distribution);
    add_rigid_loads(u, load_factor, load);
    return load.l1_norm();
  }

  template class Discretization<2>;
  template class Discretization<3>;
} // namespace Contact
