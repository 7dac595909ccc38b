/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/rigid_rotation.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "solvers/rigid_body_modes.h"

namespace Contact
{
  namespace
  {
    /// Sums over a piece, of corners with the area of their cell as weight w
    /// and the place r from the centre of the box: w, w r, w u, w r x u, w r.r.
    using Sums                   = std::array<double, 7>;
    constexpr unsigned int n_sum = std::tuple_size<Sums>::value;



    Sums terms(const double w, const Tensor<1, 2> &r, const Tensor<1, 2> &u)
    {
      return {{w,
               w * r[0],
               w * r[1],
               w * u[0],
               w * u[1],
               w * (r[0] * u[1] - r[1] * u[0]),
               w * (r * r)}};
    }



    /// The largest strain of a piece.
    double largest_strain(const Discretization<2> &discretization,
                          const Elasticity<2>     &elasticity,
                          const unsigned int       piece,
                          const Vector<double>    &u)
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
    std::map<unsigned int, std::vector<Point<2>>>
    frictionless_corners(const Discretization<2> &discretization,
                         const ContactInterface  &interface)
    {
      const auto of_node = pieces_of_nodes(discretization, interface);
      std::map<unsigned int, std::vector<Point<2>>> corners;
      std::set<unsigned int>                        rough;
      const auto collect = [&](const Surface &surface, const bool smooth) {
        for (const Surface::Edge &edge : surface.edges)
          for (unsigned int a = 0; a < 2; ++a)
            {
              const Surface::Node &node  = surface.nodes[edge.nodes[a]];
              const unsigned int   piece = of_node.at(node.dofs[0]);
              corners[piece].push_back(node.X);
              if (!smooth)
                rough.insert(piece);
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
    Vector<double> rotation_about(const Discretization<2> &discretization,
                                  const unsigned int       piece,
                                  const Point<2>          &centre)
    {
      Vector<double> rotation(discretization.dof_handler.n_dofs());
      const auto    &owned = discretization.dof_handler.locally_owned_dofs();
      std::vector<types::global_dof_index> dofs;
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (!cell->is_artificial() &&
            discretization.mesh.pieces.of_cell(cell) == piece)
          {
            const auto &fe = cell->get_fe();
            dofs.resize(fe.n_dofs_per_cell());
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (owned.is_element(dofs[i]))
                {
                  const Tensor<1, 2> r =
                    discretization.mapping[cell->active_fe_index()]
                      .transform_unit_to_real_cell(cell,
                                                   fe.unit_support_point(i)) -
                    centre;
                  rotation[dofs[i]] =
                    fe.system_to_component_index(i).first == 0 ? -r[1] : r[0];
                }
          }
      Utilities::MPI::sum(rotation, discretization.communicator, rotation);
      return rotation;
    }



    /// Whether the loads do no work but round-off in a motion.
    bool does_no_work(const Vector<double> &load, const Vector<double> &motion)
    {
      double work = 0, magnitude = 0;
      for (unsigned int i = 0; i < motion.size(); ++i)
        {
          work += load[i] * motion[i];
          magnitude += std::abs(load[i] * motion[i]);
        }
      return std::abs(work) <= 1e-10 * magnitude;
    }



    bool has_joint(const Discretization<2> &discretization,
                   const unsigned int       piece)
    {
      const auto &joints = discretization.mesh.pieces.joints();
      return !discretization.boundary.tied_y.empty() ||
             std::any_of(joints.begin(), joints.end(), [&](const auto &joint) {
               return joint.piece == piece || joint.other == piece;
             });
    }
  } // namespace



  std::vector<std::vector<double>>
  rigid_modes(const Discretization<2> &discretization)
  {
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    std::vector<std::vector<double>> modes(3,
                                           std::vector<double>(
                                             owned.n_elements()));

    const MeshPieces<2> &pieces = discretization.mesh.pieces;
    std::map<types::material_id, BoundingBox<2>> boxes;
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      boxes.emplace(pieces[piece].body, pieces[piece].box)
        .first->second.merge_with(pieces[piece].box);

    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto    &fe     = cell->get_fe();
        const Point<2> centre = boxes.at(cell->material_id()).center();
        const auto &mapping   = discretization.mapping[cell->active_fe_index()];
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const auto in_x = dofs[fe.component_to_system_index(0, a)];
            const auto in_y = dofs[fe.component_to_system_index(1, a)];
            if (!owned.is_element(in_x))
              continue;
            const Tensor<1, 2> arm =
              mapping.transform_unit_to_real_cell(
                cell,
                fe.base_element(0).unit_support_point(a)) -
              centre;
            const auto row_x = owned.index_within_set(in_x);
            const auto row_y = owned.index_within_set(in_y);
            modes[0][row_x]  = 1;
            modes[1][row_y]  = 1;
            modes[2][row_x]  = -arm[1];
            modes[2][row_y]  = arm[0];
          }
      }
    return modes;
  }



  std::vector<double> rigid_rotations(const Discretization<2> &discretization,
                                      const Vector<double>    &u)
  {
    const MeshPieces<2> &pieces = discretization.mesh.pieces;
    std::vector<double>  sums(n_sum * pieces.size());
    for (const auto &cell :
         discretization.mesh.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int piece = pieces.of_cell(cell);
          for (const unsigned int v : cell->vertex_indices())
            {
              const NodeDoFs<2> &dofs =
                discretization.vertex_dofs[cell->vertex_index(v)];
              const Sums of_corner =
                terms(cell->measure(),
                      cell->vertex(v) - pieces[piece].box.center(),
                      Tensor<1, 2>({u[dofs[0]], u[dofs[1]]}));
              for (unsigned int i = 0; i < n_sum; ++i)
                sums[n_sum * piece + i] += of_corner[i];
            }
        }
    Utilities::MPI::sum(sums, discretization.communicator, sums);

    std::vector<double> angles;
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      {
        const double      *s = &sums[n_sum * piece];
        const Tensor<1, 2> r({s[1] / s[0], s[2] / s[0]});
        const double       moment  = s[5] - (r[0] * s[4] - r[1] * s[3]);
        const double       inertia = s[6] - s[0] * (r * r);
        angles.push_back(moment / inertia);
      }
    return angles;
  }



  std::vector<TurningPiece>
  turning_pieces(const Discretization<2> &discretization,
                 const Elasticity<2>     &elasticity,
                 const ContactInterface  &interface)
  {
    std::vector<TurningPiece> turning;
    const auto corners = frictionless_corners(discretization, interface);
    for (const RigidBodyMode &motion :
         rigid_body_modes(discretization, nullptr))
      {
        const auto of_piece = corners.find(motion.piece);
        if (motion.n < 3 || of_piece == corners.end() ||
            has_joint(discretization, motion.piece))
          continue;
        const auto centre = common_centre(of_piece->second);
        if (!centre)
          continue;
        TurningPiece piece{motion.piece,
                           rotation_about(discretization,
                                          motion.piece,
                                          *centre),
                           of_piece->second.front().distance(*centre)};
        if (does_no_work(elasticity.dead_loads.at(1), piece.rotation))
          turning.push_back(piece);
      }
    return turning;
  }



  void remove_rotations(const Discretization<2>         &discretization,
                        const std::vector<TurningPiece> &pieces,
                        Vector<double>                  &u)
  {
    if (pieces.empty())
      return;
    const auto angles = rigid_rotations(discretization, u);
    for (const TurningPiece &piece : pieces)
      for (unsigned int i = 0; i < piece.rotation.size(); ++i)
        u[i] -= angles[piece.piece] * piece.rotation[i];
  }



  void check_rotations(const Discretization<2> &discretization,
                       const Elasticity<2>     &elasticity,
                       const Vector<double>    &u)
  {
    if (!elasticity.is_linear())
      return;
    const double yield  = 1e-3;
    const auto   angles = rigid_rotations(discretization, u);
    for (const RigidBodyMode &motion :
         rigid_body_modes(discretization, nullptr))
      {
        const double angle     = std::abs(angles[motion.piece]);
        const double elongates = std::sqrt(1 + angle * angle) - 1;
        if (elongates > yield &&
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
} // namespace Contact
