/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/profile.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

#include "contact/contact_results.h"

namespace Contact
{
  namespace
  {
    /// The recovered stress at the nodes of a surface, with several ranks from
    /// those that know the vertices.
    std::vector<SymmetricTensor<2, 3>>
    node_stresses(const Surface                            &surface,
                  const Discretization<2>                  &discretization,
                  const std::vector<SymmetricTensor<2, 3>> &vertex_stresses)
    {
      std::map<types::global_dof_index, unsigned int> vertex_of_dof;
      for (unsigned int v = 0; v < discretization.vertex_dofs.size(); ++v)
        vertex_of_dof.emplace(discretization.vertex_dofs[v][0], v);

      // The components by node, and how many ranks know them.
      const unsigned int  n = SymmetricTensor<2, 3>::n_independent_components;
      std::vector<double> sums((n + 1) * surface.nodes.size());
      const auto &owned = discretization.dof_handler.locally_owned_dofs();
      for (unsigned int node = 0; node < surface.nodes.size(); ++node)
        {
          const auto dof    = surface.nodes[node].dofs[0];
          const auto vertex = vertex_of_dof.find(dof);
          if (vertex == vertex_of_dof.end() || !owned.is_element(dof))
            continue;
          for (unsigned int i = 0; i < n; ++i)
            sums[(n + 1) * node + i] =
              vertex_stresses[vertex->second].access_raw_entry(i);
          sums[(n + 1) * node + n] = 1;
        }
      Utilities::MPI::sum(sums, discretization.communicator, sums);

      std::vector<SymmetricTensor<2, 3>> stresses(surface.nodes.size());
      for (unsigned int node = 0; node < stresses.size(); ++node)
        for (unsigned int i = 0; i < n; ++i)
          stresses[node].access_raw_entry(i) = sums[(n + 1) * node + i];

      // The recovered stress is linear along an edge.
      if (surface.degree == 2)
        for (const Surface::Edge &edge : surface.edges)
          stresses[edge.nodes[2]] =
            0.5 * (stresses[edge.nodes[0]] + stresses[edge.nodes[1]]);
      return stresses;
    }



    /// The rows of a surface with all that does not ask for the other one.
    std::vector<ProfileRow>
    make_rows(const Surface                            &surface,
              const Discretization<2>                  &discretization,
              const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
              const Vector<double>                     &u)
    {
      const auto stresses =
        node_stresses(surface, discretization, vertex_stresses);
      const auto            normals = surface.normals(u);
      std::vector<Point<2>> reference, deformed;
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          reference.push_back(surface.nodes[i].X);
          deformed.push_back(surface.position(i, u));
        }
      const auto arc_length          = surface.arc_length(reference);
      const auto deformed_arc_length = surface.arc_length(deformed);

      std::vector<ProfileRow> rows(surface.nodes.size());
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          rows[n].arc_length          = arc_length[n];
          rows[n].deformed_arc_length = deformed_arc_length[n];
          rows[n].X                   = reference[n];
          rows[n].u                   = deformed[n] - reference[n];
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              rows[n].extrapolated_pressure -=
                normals[n][i] * stresses[n][i][j] * normals[n][j];
        }
      return rows;
    }



    void add_exact_values(const std::optional<ExactSolution> &exact,
                          std::vector<ProfileRow>            &rows)
    {
      if (!exact)
        return;
      for (ProfileRow &row : rows)
        {
          row.exact_pressure = exact->pressure(row.X);
          if (exact->shear)
            row.exact_shear = exact->shear(row.X);
        }
    }



    /// The force w p of a point [N per mm of thickness].
    double normal_force(const ContactInterface &interface,
                        const ContactPoint     &point,
                        const Vector<double>   &solution)
    {
      const ContactState now = interface.state(point, solution, solution);
      return point.weight * interface
                              .traction(point,
                                        point.status,
                                        now.p_trial,
                                        now.q_trial,
                                        /*moving_bound=*/false)
                              .p;
    }



    /// The status of a point as the profile counts it.
    int rank(const ContactPoint &point)
    {
      if (!point.facing)
        return -1;
      switch (point.status.kind)
        {
          case Status::stick:
            return 2;
          case Status::slip:
            return 1;
          default:
            return 0;
        }
    }



    /// Gap and slip of the slave nodes, each paired on its own.
    void add_gap_and_slip(const ContactInterface  &interface,
                          const ContactPair       &contact_pair,
                          const Vector<double>    &solution,
                          const Vector<double>    &u_start,
                          std::vector<ProfileRow> &rows)
    {
      // These points only look: they carry no multiplier.
      MultiplierSpace numbering;
      auto points = make_nodal_points(contact_pair.slave, {}, numbering);
      for (ContactPoint &point : points)
        {
          point.contact_pair =
            interface.points()[contact_pair.first_point].contact_pair;
          point.n_multipliers          = 0;
          point.augmentation_parameter = 0;
        }
      contact_pair.project(make_array_view(points), solution);
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          const ContactState state =
            interface.state(points[numbering.of_node[n]], solution, u_start);
          rows[n].gap  = state.gap;
          rows[n].slip = state.slip;
        }
    }



    /// Pressure, shear, nodal force and status, which come with multipliers.
    void add_contact_values(const ContactInterface  &interface,
                            const ContactPair       &contact_pair,
                            const Vector<double>    &solution,
                            const Vector<double>    &u_start,
                            std::vector<ProfileRow> &rows)
    {
      const auto of_corners = corner_loads(interface, contact_pair, solution);
      std::vector<unsigned int> node_of(interface.n_normal_multipliers());
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          rows[n].pressure =
            interface.pressure(contact_pair.pressure_at(n), solution);
          const unsigned int k = contact_pair.multipliers.of_node[n];
          if (k != numbers::invalid_unsigned_int)
            {
              node_of[k] = n;
              if (!contact_pair.law.is_frictionless())
                rows[n].shear = solution[interface.tangential_index(k)];
            }
          if (!of_corners.empty())
            {
              rows[n].nodal_force += of_corners[n].force[0];
              rows[n].pressure += of_corners[n].traction()[0];
              rows[n].shear += of_corners[n].traction()[1];
            }
        }

      for (const ContactPoint &point : interface.points_of(contact_pair))
        {
          if (point.is_master_corner)
            continue;
          const double force = normal_force(interface, point, solution);
          for (unsigned int k = 0; k < point.n_multipliers; ++k)
            {
              ProfileRow &row = rows[node_of[point.multipliers[k]]];
              row.nodal_force += point.psi[k] * force;
              row.status = std::max(row.status, rank(point));
            }

          // A point at a node has been paired already, and with the geometry
          // as a fixed point it is this pairing that the result satisfies.
          if (point.n_multipliers == 1)
            {
              const ContactState state =
                interface.state(point, solution, u_start);
              rows[node_of[point.multipliers[0]]].gap  = state.gap;
              rows[node_of[point.multipliers[0]]].slip = state.slip;
            }
        }
    }



    /// Give a row the contact values of a place on the slave.
    void interpolate(const Surface                 &slave,
                     const std::vector<ProfileRow> &slave_rows,
                     const Projection              &place,
                     ProfileRow                    &row)
    {
      // Values are not extrapolated to the overhang beyond the end.
      const EdgeShape shape(slave.degree,
                            std::max(-1., std::min(1., place.xi)));
      unsigned int    nearest = 0;
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        {
          const auto &from = slave_rows[slave.edges[place.edge].nodes[a]];
          row.pressure += shape.value[a] * from.pressure;
          row.shear += shape.value[a] * from.shear;
          row.gap += shape.value[a] * from.gap;
          row.slip += shape.value[a] * from.slip;
          if (shape.value[a] > shape.value[nearest])
            nearest = a;
        }
      row.status = slave_rows[slave.edges[place.edge].nodes[nearest]].status;
    }



    /// Let the rows begin at their other end.
    void reverse(std::vector<ProfileRow> &rows)
    {
      std::reverse(rows.begin(), rows.end());
      const double length          = rows.front().arc_length;
      const double deformed_length = rows.front().deformed_arc_length;
      for (ProfileRow &row : rows)
        {
          row.arc_length          = length - row.arc_length;
          row.deformed_arc_length = deformed_length - row.deformed_arc_length;
        }
    }
  } // namespace



  std::vector<ProfileRow>
  slave_profile(const ContactInterface                   &interface,
                const ContactPair                        &contact_pair,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact)
  {
    auto rows =
      make_rows(contact_pair.slave, discretization, vertex_stresses, solution);
    add_gap_and_slip(interface, contact_pair, solution, u_start, rows);
    add_contact_values(interface, contact_pair, solution, u_start, rows);
    add_exact_values(exact, rows);
    return rows;
  }



  std::vector<ProfileRow>
  master_profile(const ContactInterface                   &interface,
                 const ContactPair                        &contact_pair,
                 const Discretization<2>                  &discretization,
                 const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                 const Vector<double>                     &solution,
                 const std::vector<ProfileRow>            &slave,
                 const std::optional<ExactSolution>       &exact)
  {
    if (!contact_pair.master)
      return {};
    const Surface &master = *contact_pair.master;
    auto rows = make_rows(master, discretization, vertex_stresses, solution);

    const SurfaceSearch search(contact_pair.slave, solution);
    for (unsigned int n = 0; n < rows.size(); ++n)
      {
        const Projection place =
          search.closest_point(master.position(n, solution));
        if (!place.off_the_end)
          interpolate(contact_pair.slave, slave, place, rows[n]);
      }

    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int n = 0; n < master.nodes.size(); ++n)
      node_of_dof[master.nodes[n].dofs[0]] = n;
    for (const ContactPoint &point : interface.points_of(contact_pair))
      {
        // Positive if it pushes.
        const double force = (point.is_master_corner ? -1 : 1) *
                             normal_force(interface, point, solution);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          if (!point.is_on_slave(a))
            rows[node_of_dof.at(point.dofs[a][0])].nodal_force -=
              point.C[a] * force;
      }

    add_exact_values(exact, rows);
    reverse(rows);
    return rows;
  }



  std::vector<PairProfile>
  pair_profiles(const ContactInterface                   &interface,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact,
                const bool                                with_masters)
  {
    std::vector<PairProfile> profiles;
    for (const auto &contact_pair : interface.pairs)
      {
        const auto theory =
          profiles.empty() ? exact : std::optional<ExactSolution>();
        profiles.push_back({contact_pair->name, &contact_pair->slave, {}, {}});
        profiles.back().slave_rows = slave_profile(interface,
                                                   *contact_pair,
                                                   discretization,
                                                   vertex_stresses,
                                                   solution,
                                                   u_start,
                                                   theory);
        if (with_masters)
          profiles.back().master_rows =
            master_profile(interface,
                           *contact_pair,
                           discretization,
                           vertex_stresses,
                           solution,
                           profiles.back().slave_rows,
                           theory);
      }
    return profiles;
  }
} // namespace Contact
