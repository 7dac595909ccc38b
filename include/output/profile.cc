/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/profile.h"

#include <algorithm>
#include <map>

#include "contact/results/contact_results.h"
#include "output/profile_rows.h"

namespace Contact
{
  namespace
  {
    /// A shear or a slip in one number: along the tangent, or the magnitude.
    double in_one_number(const Tensor<1, 1> &tangential)
    {
      return tangential[0];
    }

    double in_one_number(const Tensor<1, 2> &tangential)
    {
      return tangential.norm();
    }



    /// The force w p of a point [N per mm of thickness].
    template<int dim>
    double normal_force(const ContactInterface<dim> &interface,
                        const ContactPoint<dim>     &point,
                        const GhostedVector         &solution)
    {
      const ContactState<dim> now = interface.state(point, solution, solution);
      return point.weight * interface.active_set.traction(point, now).p;
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
                          const GhostedVector          &solution,
                          const GhostedVector          &u_start,
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
        if (contact_pair.slave.parents[n].empty())
          {
            const ContactState<dim> state =
              interface.state(points[numbering.of_node[n]], solution, u_start);
            rows[n].gap  = state.gap;
            rows[n].slip = in_one_number(state.slip);
            rows[n].slip_vector =
              points[numbering.of_node[n]].along_tangents(state.slip);
          }
    }



    /// A hanging node has no point: it has the means of its receivers.
    template<int dim>
    void fill_in_hanging(const Surface<dim>           &slave,
                         std::vector<ProfileRow<dim>> &rows)
    {
      for (unsigned int n = 0; n < rows.size(); ++n)
        if (!slave.parents[n].empty())
          for (const auto &[receiver, part] : slave.receivers(n))
            {
              rows[n].gap += part * rows[receiver].gap;
              rows[n].slip += part * rows[receiver].slip;
              rows[n].slip_vector += part * rows[receiver].slip_vector;
              rows[n].shear += part * rows[receiver].shear;
              rows[n].shear_vector += part * rows[receiver].shear_vector;
              rows[n].status = std::max(rows[n].status, rows[receiver].status);
            }
    }



    /// The forces of contact points on the nodes of one of their surfaces,
    /// positive if they push. A point that is joined with one of another pair
    /// pushes nodes of the other master, too: its own part is for the own one.
    template<int dim, typename Points>
    void add_nodal_forces(const ContactInterface<dim>  &interface,
                          const Points                 &points,
                          const ContactPair<dim>       &contact_pair,
                          const bool                    of_slave,
                          const GhostedVector          &solution,
                          std::vector<ProfileRow<dim>> &rows)
    {
      const Surface<dim> &surface =
        of_slave ? contact_pair.slave : *contact_pair.master;
      std::map<types::global_dof_index, unsigned int> node_of_dof;
      for (unsigned int n = 0; n < surface.nodes.size(); ++n)
        node_of_dof[surface.nodes[n].dofs[0]] = n;
      for (const ContactPoint<dim> &point : points)
        {
          std::map<unsigned int, double> part_of; // by node
          double                         all = 0, here = 0;
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            if (point.is_on_slave(a) == of_slave)
              {
                const double c =
                  (a < point.n_slave_nodes ? 1 : -1) * point.C[a];
                all += c;
                const auto node = node_of_dof.find(point.dofs(a)[0]);
                if (node == node_of_dof.end())
                  continue;
                here += c;
                part_of[node->second] += c;
              }
          for (const auto &[node, part] : part_of)
            rows[node].nodal_force +=
              part * all / here * normal_force(interface, point, solution);
        }
    }



    /// Pressure, shear, nodal force and status, which come with multipliers.
    template<int dim>
    void add_contact_values(const ContactInterface<dim>  &interface,
                            const ContactPair<dim>       &contact_pair,
                            const GhostedVector          &solution,
                            const GhostedVector          &u_start,
                            std::vector<ProfileRow<dim>> &rows)
    {
      const auto of_corners =
        corner_tractions(interface, contact_pair, solution);
      const auto stretches = contact_pair.slave.stretches(solution);
      std::map<unsigned int, unsigned int> node_of; // by multiplier
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          rows[n].pressure = pressure_at(interface, contact_pair, n, solution);
          const unsigned int k = multiplier_at(interface, contact_pair, n);
          if (k != numbers::invalid_unsigned_int)
            {
              node_of[contact_pair.multipliers.of_node[n]] = n;
              Tensor<1, dim - 1> shear;
              if (!contact_pair.law.is_frictionless())
                for (unsigned int t = 0; t < dim - 1; ++t)
                  shear[t] = solution[interface.tangential_index(k, t)];
              rows[n].shear = in_one_number(shear);
            }
          if (!of_corners.empty())
            {
              rows[n].pressure += of_corners[n][0];
              rows[n].shear += of_corners[n][1];
            }
          rows[n].true_pressure = rows[n].pressure / stretches[n];
        }

      const auto points = contact_pair.points_of_slave(interface.points());
      const auto acting = interface.acting_points(contact_pair);
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const ContactPoint<dim> &point = acting[q];
          const double force = normal_force(interface, point, solution);
          for (unsigned int k = 0; k < point.n_multipliers; ++k)
            {
              ProfileRow<dim> &row = rows[node_of.at(points[q].multipliers[k])];
              row.nodal_force += point.psi[k] * force;
              row.status = std::max(row.status, rank(point));
            }

          // A point at a node has been paired already, and with the geometry
          // as a fixed point it is this pairing that the result satisfies.
          if (point.n_multipliers == 1)
            {
              const ContactState<dim> state =
                interface.state(point, solution, u_start);
              ProfileRow<dim> &row = rows[node_of.at(points[q].multipliers[0])];
              row.gap              = state.gap;
              row.slip             = in_one_number(state.slip);
              row.slip_vector      = point.along_tangents(state.slip);
              row.shear_vector     = point.along_tangents(state.lambda_t);
            }
        }
      fill_in_hanging(contact_pair.slave, rows);
      add_nodal_forces(interface,
                       contact_pair.corners_of_master(interface.points()),
                       contact_pair,
                       true,
                       solution,
                       rows);
    }



    /// Give a row the contact values of a place on the slave. Values are not
    /// extrapolated to the overhang beyond the end.
    template<int dim>
    void interpolate(const Surface<dim>                 &slave,
                     const std::vector<ProfileRow<dim>> &slave_rows,
                     const Projection<dim>              &place,
                     ProfileRow<dim>                    &row)
    {
      const SurfaceFacet<dim> &facet = slave.facets[place.facet];
      const auto               values =
        FacetShape<dim>::values(*facet.kind, facet.kind->inside(place.xi));
      unsigned int nearest = 0;
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        {
          const auto &from = slave_rows[facet.nodes[a]];
          row.pressure += values[a] * from.pressure;
          row.true_pressure += values[a] * from.true_pressure;
          row.shear += values[a] * from.shear;
          row.gap += values[a] * from.gap;
          row.slip += values[a] * from.slip;
          row.shear_vector += values[a] * from.shear_vector;
          row.slip_vector += values[a] * from.slip_vector;
          if (values[a] > values[nearest])
            nearest = a;
        }
      row.status = slave_rows[facet.nodes[nearest]].status;
    }



    /// Let the rows of a chain begin at their other end.
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

    void reverse(std::vector<ProfileRow<3>> &)
    {
    }
  } // namespace



  template<int dim>
  std::vector<ProfileRow<dim>>
  slave_profile(const ContactInterface<dim>              &interface,
                const ContactPair<dim>                   &contact_pair,
                const Discretization<dim>                &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start)
  {
    auto rows =
      make_rows(contact_pair.slave, discretization, vertex_stresses, solution);
    add_gap_and_slip(interface, contact_pair, solution, u_start, rows);
    add_contact_values(interface, contact_pair, solution, u_start, rows);
    return rows;
  }



  template<int dim>
  std::vector<ProfileRow<dim>>
  master_profile(const ContactInterface<dim>              &interface,
                 const ContactPair<dim>                   &contact_pair,
                 const Discretization<dim>                &discretization,
                 const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                 const GhostedVector                      &solution,
                 const std::vector<ProfileRow<dim>>       &slave)
  {
    if (!contact_pair.master)
      return {};
    const Surface<dim> &master = *contact_pair.master;
    auto rows = make_rows(master, discretization, vertex_stresses, solution);

    const DeformedSurface<dim>        slave_now(contact_pair.slave, solution);
    const std::vector<Tensor<1, dim>> normals =
      DeformedSurface<dim>(master, solution).normals();
    for (unsigned int n = 0; n < rows.size(); ++n)
      {
        const Projection<dim> place =
          contact_pair.facing_slave(slave_now,
                                    master.position(n, solution),
                                    {{normals[n]}},
                                    master.facets_of_node[n]);
        if (!place.beyond_end)
          interpolate(contact_pair.slave, slave, place, rows[n]);
      }

    add_nodal_forces(interface,
                     interface.acting_points(contact_pair),
                     contact_pair,
                     false,
                     solution,
                     rows);
    add_nodal_forces(interface,
                     contact_pair.corners_of_master(interface.points()),
                     contact_pair,
                     false,
                     solution,
                     rows);
    reverse(rows);
    return rows;
  }



  template<int dim>
  std::vector<PairProfile<dim>>
  pair_profiles(const ContactInterface<dim>              &interface,
                const Discretization<dim>                &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start,
                const bool                                with_masters)
  {
    std::vector<PairProfile<dim>> profiles;
    for (const auto &contact_pair : interface.pairs)
      {
        profiles.push_back({contact_pair->name, &contact_pair->slave, {}, {}});
        profiles.back().slave_rows = slave_profile(interface,
                                                   *contact_pair,
                                                   discretization,
                                                   vertex_stresses,
                                                   solution,
                                                   u_start);
        if (with_masters)
          profiles.back().master_rows =
            master_profile(interface,
                           *contact_pair,
                           discretization,
                           vertex_stresses,
                           solution,
                           profiles.back().slave_rows);
      }
    return profiles;
  }

  template std::vector<ProfileRow<2>>
  slave_profile(const ContactInterface<2>                &interface,
                const ContactPair<2>                     &contact_pair,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start);
  template std::vector<PairProfile<2>>
  pair_profiles(const ContactInterface<2>                &interface,
                const Discretization<2>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start,
                const bool                                with_masters);
  template std::vector<PairProfile<3>>
  pair_profiles(const ContactInterface<3>                &interface,
                const Discretization<3>                  &discretization,
                const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                const GhostedVector                      &solution,
                const GhostedVector                      &u_start,
                const bool                                with_masters);
} // namespace Contact
