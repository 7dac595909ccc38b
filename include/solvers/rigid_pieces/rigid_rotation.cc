/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/rigid_pieces/rigid_rotation.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"

namespace Contact
{
  namespace
  {
    /// Visit the nodes of all cells of this rank with their unknowns and
    /// places.
    template<int dim, typename Visit>
    void for_nodes(const Discretization<dim> &discretization,
                   const Visit               &visit)
    {
      std::vector<types::global_dof_index> dofs;
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const auto &fe   = cell->get_fe();
            const auto &node = fe.base_element(0);
            dofs.resize(fe.n_dofs_per_cell());
            cell->get_dof_indices(dofs);
            for (unsigned int a = 0; a < node.n_dofs_per_cell(); ++a)
              {
                NodeDoFs<dim> of_node;
                for (unsigned int c = 0; c < dim; ++c)
                  of_node[c] = dofs[fe.component_to_system_index(c, a)];
                visit(cell,
                      of_node,
                      discretization.mapping[cell->active_fe_index()]
                        .transform_unit_to_real_cell(cell,
                                                     node.unit_support_point(
                                                       a)));
              }
          }
    }



    /// The largest strain of a piece.
    template<int dim>
    double largest_strain(const Discretization<dim> &discretization,
                          const Elasticity<dim>     &elasticity,
                          const unsigned int         piece,
                          const GhostedVector       &u)
    {
      const auto stresses = elasticity.stresses(u);
      double     largest  = 0;
      for (const auto &cell :
           discretization.mesh.triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            discretization.mesh.pieces.of_cell(cell) == piece)
          for (const auto &stress : stresses[cell->active_cell_index()])
            largest = std::max(
              largest,
              std::sqrt(elasticity.energy_density(cell->material_id(), stress) /
                        elasticity.youngs_modulus(cell->material_id())));
      return Utilities::MPI::max(largest, discretization.communicator);
    }



    /// Of each piece the corners of all its surfaces; nothing of one that
    /// sticks or is glued somewhere.
    template<int dim>
    std::map<unsigned int, std::vector<Point<dim>>>
    frictionless_corners(const ContactInterface<dim> &interface)
    {
      std::map<unsigned int, std::vector<Point<dim>>> corners;
      std::set<unsigned int>                          rough;
      const auto collect = [&](const Surface<dim> &surface, const bool smooth) {
        for (const SurfaceFacet<dim> &edge : surface.facets)
          {
            for (unsigned int a = 0; a < 2; ++a)
              corners[edge.piece].push_back(surface.nodes[edge.nodes[a]].X);
            if (!smooth)
              rough.insert(edge.piece);
          }
      };
      for (const auto &contact_pair : interface.pairs)
        {
          const bool smooth =
            contact_pair->law.is_frictionless() && !contact_pair->tied;
          collect(contact_pair->slave, smooth);
          if (contact_pair->master)
            collect(*contact_pair->master, smooth);
        }
      for (const unsigned int piece : rough)
        corners.erase(piece);
      return corners;
    }



    /// The centre of the circle that all points are on, if there is one.
    std::optional<Point<2>> common_centre(const std::vector<Point<2>> &points)
    {
      const unsigned int n = points.size();
      const Tensor<1, 2> a = points[n / 3] - points[0];
      const Tensor<1, 2> b = points[2 * n / 3] - points[0];
      const double       d = 2 * (a[0] * b[1] - a[1] * b[0]);
      if (std::abs(d) <= 1e-6 * (a.norm_square() + b.norm_square()))
        return {};
      const Tensor<1, 2> to_centre(
        {(b[1] * a.norm_square() - a[1] * b.norm_square()) / d,
         (a[0] * b.norm_square() - b[0] * a.norm_square()) / d});
      const Point<2> centre   = points[0] + to_centre;
      const double   accuracy = 1e-6 * to_centre.norm();
      for (const Point<2> &point : points)
        if (std::abs(point.distance(centre) - to_centre.norm()) > accuracy)
          return {};
      return centre;
    }



    /// e_z x (X - C) at the nodes of a piece.
    GhostedVector rotation_about(const Discretization<2> &discretization,
                                 const unsigned int       piece,
                                 const Point<2>          &centre)
    {
      GhostedVector rotation(discretization.distribution);
      const auto   &owned = discretization.dof_handler.locally_owned_dofs();
      for_nodes(discretization,
                [&](const auto &cell, const auto &dofs, const Point<2> &X) {
                  if (discretization.mesh.pieces.of_cell(cell) != piece)
                    return;
                  const Tensor<1, 2> way = rigid_motion(2, X - centre);
                  for (unsigned int c = 0; c < 2; ++c)
                    if (owned.is_element(dofs[c]))
                      rotation[dofs[c]] = way[c];
                });
      rotation.update_ghosts();
      return rotation;
    }



    /// Whether the loads do no work but round-off in a motion.
    bool does_no_work(const GhostedVector &load, const GhostedVector &motion)
    {
      GhostedVector works = load;
      std::transform(works.begin(),
                     works.end(),
                     motion.begin(),
                     works.begin(),
                     std::multiplies<>());
      return std::abs(works.sum()) <= 1e-10 * works.l1_norm();
    }



    template<int dim>
    bool has_joint(const Discretization<dim> &discretization,
                   const unsigned int         piece)
    {
      const auto &joints = discretization.mesh.pieces.joints();
      return !discretization.tied().empty() ||
             !discretization.rigid_boundaries().empty() ||
             std::any_of(joints.begin(), joints.end(), [&](const auto &joint) {
               return joint.piece == piece || joint.other == piece;
             });
    }
  } // namespace



  template<int dim>
  std::vector<std::vector<double>>
  rigid_modes(const Discretization<dim> &discretization)
  {
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    constexpr unsigned int           n_modes = dim * (dim + 1) / 2;
    std::vector<std::vector<double>> modes(n_modes,
                                           std::vector<double>(
                                             owned.n_elements()));

    const MeshPieces<dim> &pieces = discretization.mesh.pieces;
    std::map<types::material_id, BoundingBox<dim>> boxes;
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      boxes.emplace(pieces[piece].body, pieces[piece].box)
        .first->second.merge_with(pieces[piece].box);

    for_nodes(discretization,
              [&](const auto &cell, const auto &dofs, const Point<dim> &X) {
                if (!owned.is_element(dofs[0]))
                  return;
                const Tensor<1, dim> arm =
                  X - boxes.at(cell->material_id()).center();
                for (unsigned int m = 0; m < n_modes; ++m)
                  {
                    const Tensor<1, dim> motion = rigid_motion(m, arm);
                    for (unsigned int c = 0; c < dim; ++c)
                      modes[m][owned.index_within_set(dofs[c])] = motion[c];
                  }
              });
    return modes;
  }



  // The omega of the motion a + omega x (X - c): the moment of the
  // displacements by the moments of inertia about the centre of mass. The sums
  // are over the corners, with the volume of their cell as weight, about the
  // centre of the box: w, w r, w u, w r x u, and the products of the
  // displacements by rotations.
  template<int dim>
  std::vector<double> rigid_rotations(const Discretization<dim> &discretization,
                                      const GhostedVector       &u)
  {
    constexpr unsigned int n    = Dimension<dim>::n_rotations;
    constexpr unsigned int at_u = 1 + dim, at_moment = at_u + dim,
                           at_inertia = at_moment + n,
                           n_sums     = at_inertia + n * n;
    const MeshPieces<dim> &pieces     = discretization.mesh.pieces;
    std::vector<double>    sums(n_sums * pieces.size());
    for (const auto &cell :
         discretization.mesh.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int piece = pieces.of_cell(cell);
          double            *s     = &sums[n_sums * piece];
          const double       w     = cell->measure();
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto &dofs =
                discretization.vertex_dofs[cell->vertex_index(v)];
              const Tensor<1, dim> r =
                cell->vertex(v) - pieces[piece].box.center();
              Tensor<1, dim> motion;
              s[0] += w;
              for (unsigned int i = 0; i < dim; ++i)
                {
                  motion[i] = u[dofs[i]];
                  s[1 + i] += w * r[i];
                  s[at_u + i] += w * motion[i];
                }
              for (unsigned int m = 0; m < n; ++m)
                {
                  const Tensor<1, dim> turn = rigid_motion(dim + m, r);
                  s[at_moment + m] += w * (turn * motion);
                  for (unsigned int k = 0; k < n; ++k)
                    s[at_inertia + n * m + k] +=
                      w * (turn * rigid_motion(dim + k, r));
                }
            }
        }
    Utilities::MPI::sum(sums, discretization.communicator, sums);

    std::vector<double> angles;
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      {
        const double  *s = &sums[n_sums * piece];
        Tensor<1, dim> centre, motion;
        for (unsigned int i = 0; i < dim; ++i)
          {
            centre[i] = s[1 + i] / s[0];
            motion[i] = s[at_u + i];
          }
        Tensor<1, n> moment;
        Tensor<2, n> inertia;
        for (unsigned int m = 0; m < n; ++m)
          {
            const Tensor<1, dim> turn = rigid_motion(dim + m, centre);
            moment[m]                 = s[at_moment + m] - turn * motion;
            for (unsigned int k = 0; k < n; ++k)
              inertia[m][k] = s[at_inertia + n * m + k] -
                              s[0] * (turn * rigid_motion(dim + k, centre));
          }
        const Tensor<1, n> omega = invert(inertia) * moment;
        angles.push_back(n == 1 ? omega[0] : omega.norm());
      }
    return angles;
  }



  template<int dim>
  std::vector<SpinningPiece>
  turning_pieces(const Discretization<dim>   &discretization,
                 const Elasticity<dim>       &elasticity,
                 const ContactInterface<dim> &interface)
  {
    std::vector<SpinningPiece> turning;
    if constexpr (dim == 2)
      {
        const auto corners = frictionless_corners(interface);
        for (const RigidBodyMode &motion :
             rigid_body_modes<dim>(discretization, nullptr))
          {
            const auto of_piece = corners.find(motion.piece);
            if (motion.n < 3 || of_piece == corners.end() ||
                has_joint(discretization, motion.piece))
              continue;
            const auto centre = common_centre(of_piece->second);
            if (!centre)
              continue;
            SpinningPiece piece{motion.piece,
                                rotation_about(discretization,
                                               motion.piece,
                                               *centre),
                                of_piece->second.front().distance(*centre)};
            if (does_no_work(elasticity.dead_loads.at(1), piece.rotation))
              turning.push_back(piece);
          }
      }
    return turning;
  }



  template<int dim>
  void remove_rotations(const Discretization<dim>        &discretization,
                        const std::vector<SpinningPiece> &pieces,
                        GhostedVector                    &u)
  {
    if (pieces.empty())
      return;
    const auto angles = rigid_rotations(discretization, u);
    for (const SpinningPiece &piece : pieces)
      for (unsigned int k = 0; k < piece.rotation.n_held(); ++k)
        u.begin()[k] -= angles[piece.piece] * piece.rotation.begin()[k];
  }



  template<int dim>
  void check_rotations(const Discretization<dim>   &discretization,
                       const Elasticity<dim>       &elasticity,
                       const ContactInterface<dim> *interface,
                       const GhostedVector         &u)
  {
    const auto &pieces    = discretization.mesh.pieces;
    bool        all_large = true;
    for (unsigned int p = 0; p < pieces.size(); ++p)
      all_large = all_large && !elasticity.is_small_strain(pieces[p].body);
    if (all_large)
      return;
    const double yield  = 1e-3;
    const auto   angles = rigid_rotations(discretization, u);
    for (const RigidBodyMode &motion :
         rigid_body_modes<dim>(discretization, interface, Tangents::glued))
      {
        const double angle     = std::abs(angles[motion.piece]);
        const double elongates = std::sqrt(1 + angle * angle) - 1;
        if (elasticity.is_small_strain(pieces[motion.piece].body) &&
            elongates > yield &&
            10 * elongates >
              largest_strain(discretization, elasticity, motion.piece, u))
          throw NotConverged(
            discretization.mesh.piece_name(motion.piece) + " turns by " +
            brief(angle) + " rad, which lengthens it by " +
            brief(100 * elongates) +
            " % in small strain, more than a tenth of its strain: set "
            "Solids/Kinematics = large displacement, or hold it against "
            "rotation");
      }
  }

#define INSTANTIATE(dim)                                                    \
  template std::vector<std::vector<double>> rigid_modes(                    \
    const Discretization<dim> &);                                           \
  template std::vector<double> rigid_rotations(const Discretization<dim> &, \
                                               const GhostedVector &);      \
  template std::vector<SpinningPiece> turning_pieces(                       \
    const Discretization<dim> &,                                            \
    const Elasticity<dim> &,                                                \
    const ContactInterface<dim> &);                                         \
  template void remove_rotations(const Discretization<dim> &,               \
                                 const std::vector<SpinningPiece> &,        \
                                 GhostedVector &);                          \
  template void check_rotations(const Discretization<dim> &,                \
                                const Elasticity<dim> &,                    \
                                const ContactInterface<dim> *,              \
                                const GhostedVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
