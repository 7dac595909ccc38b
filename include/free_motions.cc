/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "free_motions.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>

#include <set>

#include "errors.h"

namespace Contact
{
  namespace
  {
    /// What holds one body, in terms of its rigid motions: displacement in x,
    /// in y, and rotation about the centre times the size.
    struct RigidMotions
    {
      Point<2>              centre;
      double                size = 0;
      SymmetricTensor<2, 3> held;

      /// The motion along @p direction is resisted at @p x.
      void hold(const Point<2> &x, const Tensor<1, 2> &direction)
      {
        const Tensor<1, 2> arm = (x - centre) / size;
        const Tensor<1, 3> row({direction[0],
                                direction[1],
                                direction[1] * arm[0] - direction[0] * arm[1]});
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            held[i][j] += row[i] * row[j];
      }
    };



    std::map<types::material_id, RigidMotions>
    make_motions(const Discretization &discretization)
    {
      // The coarse mesh, which every rank has.
      std::map<types::material_id, BoundingBox<2>> boxes;
      for (const auto &cell :
           discretization.mesh.triangulation.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          {
            const BoundingBox<2> vertex({cell->vertex(v), cell->vertex(v)});
            const auto box = boxes.emplace(cell->material_id(), vertex);
            if (!box.second)
              box.first->second.merge_with(vertex);
          }

      std::map<types::material_id, RigidMotions> motions;
      for (const auto &[body, box] : boxes)
        {
          motions[body].centre = box.center();
          motions[body].size   = 0.5 * box.get_boundary_points().first.distance(
                                       box.get_boundary_points().second);
          // Rings resist growing and turning inside out.
          if (discretization.axisymmetric)
            motions[body].held[0][0] = motions[body].held[2][2] = 1;
        }
      return motions;
    }



    /// Supports and ties, vertex by vertex.
    void hold_by_supports(const Discretization &discretization,
                          std::map<types::material_id, RigidMotions> &motions)
    {
      for (const auto &cell :
           discretization.mesh.triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; cell->is_locally_owned() && c < 2; ++c)
            {
              const auto dof =
                discretization.vertex_dofs[cell->vertex_index(v)][c];
              if (discretization.is_fixed(dof) || discretization.is_tied(dof))
                {
                  Tensor<1, 2> direction;
                  direction[c] = 1;
                  motions.at(cell->material_id())
                    .hold(cell->vertex(v), direction);
                }
            }
    }



    void hold_by_contact(const ContactInterface                     &interface,
                         const bool                                  friction,
                         std::map<types::material_id, RigidMotions> &motions)
    {
      for (const ContactPoint &point : interface.points)
        {
          if (point.decision.status == Status::open)
            continue;
          Point<2> x;
          for (unsigned int a = 0; a < point.n_slave_nodes; ++a)
            x += point.C[a] * point.X[a];

          const auto hold = [&](const types::material_id body) {
            motions.at(body).hold(x, point.normal);
            if (friction && point.decision.status == Status::stick)
              motions.at(body).hold(x, point.tangent);
          };
          const ContactZone &zone = interface.zone(point);
          hold(zone.slave.edges[point.slave_edge].body);
          if (zone.master)
            hold(zone.master->edges[point.master_edge].body);
        }
    }



    std::string name_of_motion(const Tensor<1, 3> &mode)
    {
      const std::array<std::string, 3> names{
        {"displacement in x", "displacement in y", "rotation"}};
      std::string name;
      for (unsigned int i = 0; i < 3; ++i)
        if (std::abs(mode[i]) > 0.1)
          name += (name.empty() ? "" : " with ") + names[i];
      return name;
    }
  } // namespace



  std::vector<FreeMotion> free_motions(const Discretization   &discretization,
                                       const ContactInterface *interface,
                                       const bool              friction)
  {
    auto motions = make_motions(discretization);
    hold_by_supports(discretization, motions);
    for (auto &motion : motions)
      motion.second.held =
        Utilities::MPI::sum(motion.second.held, discretization.communicator);
    if (interface != nullptr)
      hold_by_contact(*interface, friction, motions);

    std::vector<FreeMotion> free;
    for (const auto &[body, rigid] : motions)
      {
        const auto   modes   = eigenvectors(rigid.held);
        const double largest = modes.front().first;
        // Round-off of the sums, against one point that holds.
        if (modes.back().first <= 1e-10 * largest || largest == 0)
          free.push_back({body, name_of_motion(modes.back().second)});
      }
    return free;
  }



  void check_supports(const Discretization   &discretization,
                      const ContactInterface *interface)
  {
    std::set<types::material_id> touching;
    const auto                   touch = [&](const Surface &surface) {
      for (const Surface::Edge &edge : surface.edges)
        touching.insert(edge.body);
    };
    if (interface != nullptr)
      for (const auto &zone : interface->zones)
        {
          touch(zone->slave);
          if (zone->master)
            touch(*zone->master);
        }

    for (const auto &[body, motion] : free_motions(discretization, interface))
      if (touching.count(body) == 0)
        throw InputError("nothing holds the body '" +
                           discretization.mesh.body_name(body) +
                           "' against: " + motion,
                         "Boundary conditions, Contact",
                         "support it in that motion, tie a point of it, or "
                         "give it a surface that can touch another body");
  }
} // namespace Contact
