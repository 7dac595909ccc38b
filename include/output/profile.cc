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
    /// Values between the corners of a facet are the mean of those there.
    template<typename T>
    void fill_middles(const SurfaceFacet<2> &edge, std::vector<T> &values)
    {
      values[edge.nodes[2]] =
        0.5 * (values[edge.nodes[0]] + values[edge.nodes[1]]);
    }

    template<typename T>
    void fill_middles(const SurfaceFacet<3> &facet, std::vector<T> &values)
    {
      const auto &n = facet.nodes;
      for (unsigned int s = 0; s < 4; ++s)
        {
          const auto [a, b] = SurfaceFacet<3>::corners_of_side[s];
          values[n[4 + s]]  = 0.5 * (values[n[a]] + values[n[b]]);
        }
      values[n[8]] =
        0.25 * (values[n[0]] + values[n[1]] + values[n[2]] + values[n[3]]);
    }



    std::vector<double> arc_lengths(const Surface<2>            &surface,
                                    const std::vector<Point<2>> &x)
    {
      return surface.arc_length(x);
    }

    /// Surfaces in space have none.
    std::vector<double> arc_lengths(const Surface<3> &,
                                    const std::vector<Point<3>> &x)
    {
      return std::vector<double>(x.size());
    }



    /// A shear or a slip in one number: along the tangent, or the magnitude.
    double in_one_number(const Tensor<1, 1> &tangential)
    {
      return tangential[0];
    }

    double in_one_number(const Tensor<1, 2> &tangential)
    {
      return tangential.norm();
    }



    /// The recovered stress at the nodes of a surface, with several ranks from
    /// those that know the vertices.
    template<int dim>
    std::vector<SymmetricTensor<2, 3>>
    node_stresses(const Surface<dim>                       &surface,
                  const Discretization<dim>                &discretization,
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
        for (const SurfaceFacet<dim> &facet : surface.facets)
          fill_middles(facet, stresses);
      return stresses;
    }



    /// The rows of a surface with all that does not ask for the other one.
    template<int dim>
    std::vector<ProfileRow<dim>>
    make_rows(const Surface<dim>                       &surface,
              const Discretization<dim>                &discretization,
              const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
              const Vector<double>                     &u)
    {
      const auto stresses =
        node_stresses(surface, discretization, vertex_stresses);
      const auto              normals = surface.normals(u);
      std::vector<Point<dim>> reference, deformed;
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          reference.push_back(surface.nodes[i].X);
          deformed.push_back(surface.position(i, u));
        }
      const auto arc_length          = arc_lengths(surface, reference);
      const auto deformed_arc_length = arc_lengths(surface, deformed);

      std::vector<ProfileRow<dim>> rows(surface.nodes.size());
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          rows[n].arc_length          = arc_length[n];
          rows[n].deformed_arc_length = deformed_arc_length[n];
          rows[n].X                   = reference[n];
          rows[n].u                   = deformed[n] - reference[n];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              rows[n].extrapolated_pressure -=
                normals[n][i] * stresses[n][i][j] * normals[n][j];
        }
      return rows;
    }



    void add_exact_values(const std::optional<ExactSolution> &exact,
                          std::vector<ProfileRow<2>>         &rows)
    {
      if (!exact)
        return;
      for (ProfileRow<2> &row : rows)
        {
          row.exact_pressure = exact->pressure(row.X);
          if (exact->shear)
            row.exact_shear = exact->shear(row.X);
        }
    }

    void add_exact_values(const std::optional<ExactSolution> &,
                          std::vector<ProfileRow<3>> &)
    {
    }



    /// The force w p of a point [N per mm of thickness].
    template<int dim>
    double normal_force(const ContactInterface<dim> &interface,
                        const ContactPoint<dim>     &point,
                        const Vector<double>        &solution)
    {
      const ContactState<dim> now = interface.state(point, solution, solution);
      return point.weight * interface
                              .traction(point,
                                        point.status,
                                        now.p_trial,
                                        now.q_trial,
                                        /*moving_bound=*/false)
                              .p;
    }



    /// The status of a point as the profile counts it.
    template<int dim>
    int rank(const ContactPoint<dim> &point)
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
    template<int dim>
    void add_gap_and_slip(const ContactInterface<dim>  &interface,
                          const ContactPair<dim>       &contact_pair,
                          const Vector<double>         &solution,
                          const Vector<double>         &u_start,
                          std::vector<ProfileRow<dim>> &rows)
    {
      // These points only look: they carry no multiplier.
      MultiplierSpace numbering;
      auto points = make_nodal_points(contact_pair.slave, {}, numbering);
      for (ContactPoint<dim> &point : points)
        {
          point.contact_pair =
            interface.points()[contact_pair.first_point].contact_pair;
          point.n_multipliers          = 0;
          point.augmentation_parameter = 0;
        }
      contact_pair.project(make_array_view(points), solution);
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          const ContactState<dim> state =
            interface.state(points[numbering.of_node[n]], solution, u_start);
          rows[n].gap  = state.gap;
          rows[n].slip = in_one_number(state.slip);
          rows[n].slip_vector =
            points[numbering.of_node[n]].along_tangents(state.slip);
        }
    }



    /// Pressure, shear, nodal force and status, which come with multipliers.
    template<int dim>
    void add_contact_values(const ContactInterface<dim>  &interface,
                            const ContactPair<dim>       &contact_pair,
                            const Vector<double>         &solution,
                            const Vector<double>         &u_start,
                            std::vector<ProfileRow<dim>> &rows)
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
              Tensor<1, dim - 1> shear;
              if (!contact_pair.law.is_frictionless())
                for (unsigned int t = 0; t < dim - 1; ++t)
                  shear[t] = solution[interface.tangential_index(k, t)];
              rows[n].shear = in_one_number(shear);
            }
          if (!of_corners.empty())
            {
              rows[n].nodal_force += of_corners[n].force[0];
              rows[n].pressure += of_corners[n].traction()[0];
              rows[n].shear += of_corners[n].traction()[1];
            }
        }

      for (const ContactPoint<dim> &point : interface.points_of(contact_pair))
        {
          if (point.is_master_corner)
            continue;
          const double force = normal_force(interface, point, solution);
          for (unsigned int k = 0; k < point.n_multipliers; ++k)
            {
              ProfileRow<dim> &row = rows[node_of[point.multipliers[k]]];
              row.nodal_force += point.psi[k] * force;
              row.status = std::max(row.status, rank(point));
            }

          // A point at a node has been paired already, and with the geometry
          // as a fixed point it is this pairing that the result satisfies.
          if (point.n_multipliers == 1)
            {
              const ContactState<dim> state =
                interface.state(point, solution, u_start);
              ProfileRow<dim> &row = rows[node_of[point.multipliers[0]]];
              row.gap              = state.gap;
              row.slip             = in_one_number(state.slip);
              row.slip_vector      = point.along_tangents(state.slip);
              row.shear_vector     = point.along_tangents(state.lambda_t);
            }
        }
    }



    /// Give a row the contact values of a place on the slave.
    void interpolate(const Surface<2>                 &slave,
                     const std::vector<ProfileRow<2>> &slave_rows,
                     const Projection<2>              &place,
                     ProfileRow<2>                    &row)
    {
      // Values are not extrapolated to the overhang beyond the end.
      const EdgeShape shape(slave.degree,
                            std::max(-1., std::min(1., place.xi)));
      unsigned int    nearest = 0;
      for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
        {
          const auto &from = slave_rows[slave.facets[place.facet].nodes[a]];
          row.pressure += shape.value[a] * from.pressure;
          row.shear += shape.value[a] * from.shear;
          row.gap += shape.value[a] * from.gap;
          row.slip += shape.value[a] * from.slip;
          if (shape.value[a] > shape.value[nearest])
            nearest = a;
        }
      row.status = slave_rows[slave.facets[place.facet].nodes[nearest]].status;
    }



    /// Let the rows begin at their other end.
    void reverse(std::vector<ProfileRow<2>> &rows)
    {
      std::reverse(rows.begin(), rows.end());
      const double length          = rows.front().arc_length;
      const double deformed_length = rows.front().deformed_arc_length;
      for (ProfileRow<2> &row : rows)
        {
          row.arc_length          = length - row.arc_length;
          row.deformed_arc_length = deformed_length - row.deformed_arc_length;
        }
    }
  } // namespace



  template<int dim>
  std::vector<ProfileRow<dim>>
  slave_profile(const ContactInterface<dim>              &interface,
                const ContactPair<dim>                   &contact_pair,
                const Discretization<dim>                &discretization,
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



  template<>
  std::vector<ProfileRow<2>>
  master_profile(const ContactInterface<2>                &interface,
                 const ContactPair<2>                     &contact_pair,
                 const Discretization<2>                  &discretization,
                 const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                 const Vector<double>                     &solution,
                 const std::vector<ProfileRow<2>>         &slave,
                 const std::optional<ExactSolution>       &exact)
  {
    if (!contact_pair.master)
      return {};
    const Surface<2> &master = *contact_pair.master;
    auto rows = make_rows(master, discretization, vertex_stresses, solution);

    const SurfaceSearch<2> search(contact_pair.slave, solution);
    for (unsigned int n = 0; n < rows.size(); ++n)
      {
        const Projection<2> place =
          search.closest_point(master.position(n, solution));
        if (!place.off_the_end)
          interpolate(contact_pair.slave, slave, place, rows[n]);
      }

    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int n = 0; n < master.nodes.size(); ++n)
      node_of_dof[master.nodes[n].dofs[0]] = n;
    for (const ContactPoint<2> &point : interface.points_of(contact_pair))
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



  template<>
  std::vector<ProfileRow<3>>
  master_profile(const ContactInterface<3> &,
                 const ContactPair<3> &,
                 const Discretization<3> &,
                 const std::vector<SymmetricTensor<2, 3>> &,
                 const Vector<double> &,
                 const std::vector<ProfileRow<3>> &,
                 const std::optional<ExactSolution> &)
  {
    return {};
  }



  template<int dim>
  std::vector<PairProfile<dim>>
  pair_profiles(const ContactInterface<dim>              &interface,
                const Discretization<dim>                &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact,
                const bool                                with_masters)
  {
    std::vector<PairProfile<dim>> profiles;
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

  template std::vector<ProfileRow<2>>
  slave_profile(const ContactInterface<2>                &interface,
                const ContactPair<2>                     &contact_pair,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact);
  template std::vector<ProfileRow<3>>
  slave_profile(const ContactInterface<3>                &interface,
                const ContactPair<3>                     &contact_pair,
                const Discretization<3>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact);
  template std::vector<PairProfile<2>>
  pair_profiles(const ContactInterface<2>                &interface,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact,
                const bool                                with_masters);
  template std::vector<PairProfile<3>>
  pair_profiles(const ContactInterface<3>                &interface,
                const Discretization<3>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const Vector<double>                     &solution,
                const Vector<double>                     &u_start,
                const std::optional<ExactSolution>       &exact,
                const bool                                with_masters);
} // namespace Contact
