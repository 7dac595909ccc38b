/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "probes.h"

#include <map>

#include "errors.h"
#include "stress_recovery.h"

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



  double contact_traction(const std::string      &quantity,
                          const unsigned int      vertex,
                          const ContactInterface *interface,
                          const Discretization   &discretization,
                          const Vector<double>   &solution)
  {
    const NodeDoFs &dofs = discretization.vertex_dofs[vertex];
    if (interface != nullptr)
      for (const auto &zone : interface->zones)
        for (unsigned int n = 0; n < zone->slave.nodes.size(); ++n)
          if (zone->slave.nodes[n].dofs == dofs)
            {
              const auto pressure = zone->pressure_at(n);
              if (pressure.empty())
                continue;
              if (quantity == "pressure")
                return interface->pressure(pressure, solution);
              const unsigned int k = zone->multipliers.of_node[n];
              return zone->law.is_frictionless() ||
                         k == numbers::invalid_unsigned_int
                       ? 0.
                       : solution[interface->tangential_index(k)];
            }
    throw InputError("there is no " + quantity +
                       " of contact at a point that is asked for",
                     "Probes/Probes",
                     "name a point group on a slave, or a stress");
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
