/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/probes.h"

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "contact/contact_results.h"
#include "solid/stress_recovery.h"

namespace Contact
{
  bool is_displacement(const std::string &quantity)
  {
    return quantity.rfind("displacement", 0) == 0;
  }



  bool is_contact_traction(const std::string &quantity)
  {
    return quantity == "pressure" || quantity == "shear";
  }



  bool is_stress(const std::string &quantity)
  {
    return !is_displacement(quantity) && !is_contact_traction(quantity);
  }



  namespace
  {
    /// A node of the slave of a zone, with a pressure.
    struct SlaveNode
    {
      const ContactZone *zone;
      unsigned int       number;
    };



    /// The slave nodes with these unknowns, at most one of each zone.
    std::vector<SlaveNode> slave_nodes_at(const NodeDoFs         &dofs,
                                          const ContactInterface *interface)
    {
      std::vector<SlaveNode> found;
      if (interface != nullptr)
        for (const auto &zone : interface->zones)
          for (unsigned int n = 0; n < zone->slave.nodes.size(); ++n)
            if (zone->slave.nodes[n].dofs == dofs &&
                !zone->pressure_at(n).empty())
              found.push_back({zone.get(), n});
      return found;
    }



    bool has_node(const Surface &surface, const NodeDoFs &dofs)
    {
      return std::any_of(surface.nodes.begin(),
                         surface.nodes.end(),
                         [&](const auto &node) { return node.dofs == dofs; });
    }



    /// Why no multiplier is at a node.
    std::string why_no_multiplier(const NodeDoFs         &dofs,
                                  const ContactInterface *interface)
    {
      if (interface == nullptr)
        return "the scene has no contact";
      for (const auto &zone : interface->zones)
        {
          const std::string name =
            zone->name.empty() ? "" : " of the zone '" + zone->name + "'";
          if (has_node(zone->slave, dofs))
            return "it is on the slave" + name + ", but no point of contact is";
          if (zone->master && has_node(*zone->master, dofs))
            return "it is on the master" + name +
                   ", and the tractions are those of the slave";
        }
      return "it is on no slave";
    }
  } // namespace



  void check_contact_traction(const std::string      &probe,
                              const std::string      &quantity,
                              const std::string      &point,
                              const ContactInterface *interface,
                              const Discretization   &discretization)
  {
    const NodeDoFs &dofs =
      discretization
        .vertex_dofs[discretization.mesh.point(point, "Probes/Probes")];
    const auto found = slave_nodes_at(dofs, interface);
    if (found.empty())
      throw InputError("there is no " + quantity +
                         " of contact at the point '" + point +
                         "': " + why_no_multiplier(dofs, interface),
                       "Probes/Probes, '" + probe + "'",
                       "name a point group on a slave, or a stress");
    if (found.size() > 1)
      throw InputError("the point '" + point + "' has a " + quantity +
                         " of contact in two zones, '" + found[0].zone->name +
                         "' and '" + found[1].zone->name + "'",
                       "Probes/Probes, '" + probe + "'",
                       "name a point of one zone only, or a stress; "
                       "'Output/Profile' has both");
  }



  double contact_traction(const std::string      &quantity,
                          const unsigned int      vertex,
                          const ContactInterface *interface,
                          const Discretization   &discretization,
                          const Vector<double>   &solution)
  {
    const auto [zone, n] =
      slave_nodes_at(discretization.vertex_dofs[vertex], interface).at(0);
    const bool   normal     = quantity == "pressure";
    const auto   of_corners = corner_loads(*interface, *zone, solution);
    const double of_corner =
      of_corners.empty() ? 0. : of_corners[n].traction()[normal ? 0 : 1];
    if (normal)
      return interface->pressure(zone->pressure_at(n), solution) + of_corner;
    const unsigned int k = zone->multipliers.of_node[n];
    return zone->law.is_frictionless() || k == numbers::invalid_unsigned_int
             ? of_corner
             : solution[interface->tangential_index(k)] + of_corner;
  }



  double probe_value(const std::string                        &quantity,
                     const unsigned int                        vertex,
                     const Discretization                     &discretization,
                     const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                     const Vector<double>                     &u)
  {
    const NodeDoFs &dofs   = discretization.vertex_dofs[vertex];
    const auto      stress = vertex_stresses.empty() ? SymmetricTensor<2, 3>()
                                                     : vertex_stresses[vertex];
    const std::map<std::string, double> values{{"displacement x", u[dofs[0]]},
                                               {"displacement y", u[dofs[1]]},
                                               {"stress xx", stress[0][0]},
                                               {"stress yy", stress[1][1]},
                                               {"stress zz", stress[2][2]},
                                               {"stress xy", stress[0][1]},
                                               {"von Mises",
                                                von_mises(stress)}};

    const auto value = values.find(quantity);
    if (value == values.end())
      throw InputError("there is no quantity '" + quantity + "' to probe",
                       "entry 'Probes/Probes'",
                       "see --parameters for the quantities");
    return value->second;
  }
} // namespace Contact
