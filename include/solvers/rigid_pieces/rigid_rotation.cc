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
    frictionless_corners(const Discretization<dim>   &discretization,
                         const ContactInterface<dim> &interface)
    {
      const auto of_node = pieces_of_nodes(discretization, interface);
      std::map<unsigned int, std::vector<Point<dim>>> corners;
      std::set<unsigned int>                          rough;
      const auto collect = [&](const Surface<dim> &surface, const bool smooth) {
        for (const SurfaceFacet<dim> &edge : surface.facets)
          for (unsigned int a = 0; a < 2; ++a)
            {
              const SurfaceNode<dim> &node  = surface.nodes[edge.nodes[a]];
              const unsigned int      piece = of_node.at(node.dofs[0]);
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
    GhostedVector rotation_about(const Discretization<2> &discretization,
                                 const unsigned int       piece,
                                 const Point<2>          &centre)
    {
      GhostedVector rotation(discretization.distribution);
      const auto   &owned = discretization.dof_handler.locally_owned_dofs();
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

    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto      &fe     = cell->get_fe();
        const Point<dim> centre = boxes.at(cell->material_id()).center();
        const auto &mapping = discretization.mapping[cell->active_fe_index()];
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            if (!owned.is_element(dofs[fe.component_to_system_index(0, a)]))
              continue;
            const Tensor<1, dim> arm =
              mapping.transform_unit_to_real_cell(
                cell,
                fe.base_element(0).unit_support_point(a)) -
              centre;
            for (unsigned int m = 0; m < n_modes; ++m)
              {
                const Tensor<1, dim> motion = rigid_motion(m, arm);
                for (unsigned int c = 0; c < dim; ++c)
                  modes[m][owned.index_within_set(
                    dofs[fe.component_to_system_index(c, a)])] = motion[c];
              }
          }
      }
    return modes;
  }



  template<>
  std::vector<double> rigid_rotations(const Discretization<2> &discretization,
                                      const GhostedVector     &u)
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



  template<>
  std::vector<SpinningPiece>
  turning_pieces(const Discretization<2>   &discretization,
                 const Elasticity<2>       &elasticity,
                 const ContactInterface<2> &interface)
  {
    std::vector<SpinningPiece> turning;
    const auto corners = frictionless_corners(discretization, interface);
    for (const RigidBodyMode &motion :
         rigid_body_modes<2>(discretization, nullptr))
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
    return turning;
  }



  template<>
  void remove_rotations(const Discretization<2>          &discretization,
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



  // The omega of the motion a + omega x (X - c): the moment of the
  // displacements by the moments of inertia about the centre of mass.
  template<>
  std::vector<double> rigid_rotations(const Discretization<3> &discretization,
                                      const GhostedVector     &u)
  {
    const MeshPieces<3>   &pieces = discretization.mesh.pieces;
    constexpr unsigned int n_sums = 1 + 3 + 3 + 3 + 9;
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
              const Tensor<1, 3> r =
                cell->vertex(v) - pieces[piece].box.center();
              const Tensor<1, 3> motion({u[dofs[0]], u[dofs[1]], u[dofs[2]]});
              const Tensor<1, 3> moment = cross_product_3d(r, motion);
              s[0] += w;
              for (unsigned int i = 0; i < 3; ++i)
                {
                  s[1 + i] += w * r[i];
                  s[4 + i] += w * motion[i];
                  s[7 + i] += w * moment[i];
                  for (unsigned int j = 0; j < 3; ++j)
                    s[10 + 3 * i + j] += w * r[i] * r[j];
                }
            }
        }
    Utilities::MPI::sum(sums, discretization.communicator, sums);

    std::vector<double> angles;
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      {
        const double *s = &sums[n_sums * piece];
        Tensor<1, 3>  r, motion, moment;
        Tensor<2, 3>  spread;
        for (unsigned int i = 0; i < 3; ++i)
          {
            r[i]      = s[1 + i] / s[0];
            motion[i] = s[4 + i] / s[0];
            moment[i] = s[7 + i] / s[0];
            for (unsigned int j = 0; j < 3; ++j)
              spread[i][j] = s[10 + 3 * i + j] / s[0];
          }
        moment -= cross_product_3d(r, motion);
        spread -= outer_product(r, r);
        Tensor<2, 3> inertia = -spread;
        for (unsigned int i = 0; i < 3; ++i)
          inertia[i][i] += trace(spread);
        angles.push_back((invert(inertia) * moment).norm());
      }
    return angles;
  }



  template<>
  std::vector<SpinningPiece> turning_pieces(const Discretization<3> &,
                                            const Elasticity<3> &,
                                            const ContactInterface<3> &)
  {
    return {};
  }



  template<>
  void remove_rotations(const Discretization<3> &,
                        const std::vector<SpinningPiece> &,
                        GhostedVector &)
  {
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

  template std::vector<std::vector<double>>
  rigid_modes(const Discretization<2> &discretization);
  template std::vector<std::vector<double>>
                rigid_modes(const Discretization<3> &discretization);
  template void check_rotations(const Discretization<2>   &discretization,
                                const Elasticity<2>       &elasticity,
                                const ContactInterface<2> *interface,
                                const GhostedVector       &u);
  template void check_rotations(const Discretization<3>   &discretization,
                                const Elasticity<3>       &elasticity,
                                const ContactInterface<3> *interface,
                                const GhostedVector       &u);
} // namespace Contact
