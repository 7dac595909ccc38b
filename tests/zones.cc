/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Three blocks on top of each other and on a rigid plane, between them three
// contact pairs of contact, each with a rule and a law of its own. Proves that
// the contact pairs do not disturb each other: in any order of the rules a
// uniform pressure goes through all of them exactly, every multiplier is found
// under its number, and glued surfaces need no contact to carry what pulls.

#include "tests.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000, shortening = 0.03;

  /// The conditions between two blocks, from below.
  struct Zone
  {
    std::string rule;
    double      friction;
    bool        tied;
  };



  Parameters::All make_case(const unsigned int         degree,
                            const std::array<Zone, 3> &pairs,
                            const double               poisson,
                            const double               stretch)
  {
    MeshText mesh;
    mesh.block("one", 3, 2, rectangle({0, 0}, {2, 1}));
    mesh.block("two", 3, 2, rectangle({0, 1}, {2, 2}));
    mesh.block("three", 3, 2, rectangle({0, 2}, {2, 3}));
    Parameters::All parameters          = make_parameters(mesh,
                                                 {"one", "two", "three"},
                                                 degree,
                                                 "small strain",
                                                 youngs_modulus,
                                                 poisson);
    parameters.boundary.displacement[0] = {{"one left", 0},
                                           {"two left", 0},
                                           {"three left", 0}};
    parameters.boundary.displacement[1] = {{"three top", stretch}};

    const std::array<std::string, 3> slaves{
      {"one bottom", "two bottom", "three bottom"}},
      masters{{"", "one top", "two top"}}, names{{"", "first", "second"}};
    for (unsigned int z = 0; z < 3; ++z)
      {
        Parameters::Contact &contact_pair =
          z == 0 ? parameters.contact : parameters.further_contacts[names[z]];
        contact_pair.name                 = names[z];
        contact_pair.slave                = slaves[z];
        contact_pair.master               = masters[z];
        contact_pair.discretization       = pairs[z].rule;
        contact_pair.friction_coefficient = pairs[z].friction;
        contact_pair.tied                 = pairs[z].tied;
      }
    parameters.contact.obstacle = {
      {Parameters::ObstacleShape::half_plane, {5, 0, 0, 1}}};
    return parameters;
  }



  void check_stack(const std::string         &name,
                   const unsigned int         degree,
                   const std::array<Zone, 3> &pairs,
                   const double               poisson,
                   const double               stretch)
  {
    headline(name + ", degree " + std::to_string(degree));
    TwoBodies model(make_case(degree, pairs, poisson, stretch));
    check("converges", model.solve(1, false) > 0);

    // Free to the right, no strain across: sigma = E/(1 - nu^2) strain.
    const double p = -youngs_modulus / (1 - poisson * poisson) * stretch / 3;
    SymmetricTensor<2, 3> exact;
    exact[1][1]      = -p;
    exact[2][2]      = -poisson * p;
    double deviation = 0;
    for (const auto &cell : model.elasticity->stresses(model.solution))
      for (const auto &stress : cell)
        deviation = std::max(deviation, (stress - exact).norm() / std::abs(p));
    check_small("stress", deviation, 1e-10);

    const ContactInterface<2> &interface = model.interface;
    double                     normal = 0, tangential = 0;
    unsigned int               n_points = 0, n_tangential = 0;
    for (const auto &contact_pair : interface.pairs)
      {
        n_points += contact_pair->points_among(interface.points()).size();
        if (!contact_pair->law.is_frictionless())
          n_tangential +=
            contact_pair->corners_of_master(interface.points()).size();
        for (const unsigned int k : contact_pair->multipliers.of_node)
          {
            normal =
              std::max(normal,
                       std::abs(model.solution[interface.normal_index(k)] / p -
                                1));
            if (contact_pair->law.is_frictionless())
              continue;
            ++n_tangential;
            tangential =
              std::max(tangential,
                       std::abs(model.solution[interface.tangential_index(k)] /
                                p));
          }
      }
    check_small("pressures", normal, 1e-10);
    check_small("shears", tangential, 1e-10);
    check("multipliers are counted",
          interface.n_multipliers() ==
              interface.n_normal_multipliers() + n_tangential &&
            n_points == interface.points().size());
    check("all points are in contact",
          interface.active_set.count().active ==
            points_that_act(interface).size());
  }
} // namespace



int main()
{
  const Zone nodal{"nodal", 0, false}, rough{"nodal", 0.2, false},
    gauss{"Gauss", 0, false}, mortar{"mortar", 0, false},
    rough_mortar{"mortar", 0.3, false}, glue{"nodal", 0, true};
  for (const unsigned int degree : {1, 2})
    {
      check_stack("smooth, rough, glued",
                  degree,
                  {{nodal, rough, glue}},
                  0.3,
                  -shortening);
      check_stack("smooth, glued, smooth",
                  degree,
                  {{gauss, glue, gauss}},
                  0.3,
                  -shortening);
      check_stack("smooth, rough, rough",
                  degree,
                  {{mortar, rough, rough_mortar}},
                  0.3,
                  -shortening);
      check_stack("all glued, pulled",
                  degree,
                  {{glue, glue, glue}},
                  0,
                  shortening);
    }
  return 0;
}
